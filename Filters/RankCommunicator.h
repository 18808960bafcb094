// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Communicator.h"

#include "vtkMultiProcessController.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <string>

/** The ranks of a vtkMultiProcessController; a null controller is a serial run. */
class RankCommunicator : public ruc::Communicator
{
public:
  explicit RankCommunicator(vtkMultiProcessController* controller)
    : Controller(controller)
  {
  }
  int Rank() const override;
  int Size() const override;
  void Sum(std::int64_t* values, std::size_t count) override;
  void Share(double* values, std::size_t count) override;
  void Minimum(std::int32_t* values, std::size_t count) override;
  void Minimum(double* values, std::size_t count) override;
  std::vector<std::vector<double>> Exchange(std::vector<std::vector<double>> outgoing) override;
  void ThrowIfAny(const std::string& error) override;

  /** Collective: the text of the lowest rank where it is not empty. */
  std::string FirstText(const std::string& text);

  /** Collective: the ranks with the same `group` >= 0 as a communicator of their own, in the same
   * order. */
  std::unique_ptr<RankCommunicator> Split(int group) const;

  vtkMultiProcessController* GetController() const { return this->Controller; }

private:
  vtkMultiProcessController* Controller;
  vtkSmartPointer<vtkMultiProcessController> Own; // of a group
};
