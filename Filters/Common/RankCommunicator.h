// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCCommonModule.h"
#include "ruc/Base/Communicator.h"

#include "vtkMultiProcessController.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <string>
#include <vector>

/** The ranks of a vtkMultiProcessController; a null controller is a serial run. */
class RUCCOMMON_EXPORT RankCommunicator : public ruc::Communicator
{
public:
  explicit RankCommunicator(vtkMultiProcessController* controller)
    : Controller(controller)
  {
  }
  int Rank() const override;
  int Size() const override;
  void Sum(std::int64_t* values, std::size_t count) override;
  void Minimum(std::int32_t* values, std::size_t count) override;
  void Minimum(double* values, std::size_t count) override;
  using ruc::Communicator::Sum; // the sum of doubles

  /**
   * Returns the ranks with the same `group` >= 0 as a communicator of their own, in the same order.
   * Collective.
   */
  std::unique_ptr<RankCommunicator> Split(int group) const;

  vtkMultiProcessController* GetController() const { return this->Controller; }

  /** Throws std::invalid_argument where there are several ranks that MPI does not connect. */
  void RequireMpi() const;

protected:
  void BroadcastBytes(std::string& bytes, int root) override;
  std::vector<std::string> AllGatherBytes(
    std::string own, const std::vector<std::size_t>& sizes) override;
  std::vector<std::string> AllToAllBytes(std::vector<std::string> outgoing) override;

private:
  vtkMultiProcessController* Controller;
  vtkSmartPointer<vtkMultiProcessController> Own; // the controller that a group owns
};
