// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCCommonModule.h"
#include "ruc/Base/Communicator.h"

#include "vtkMPICommunicator.h"
#include "vtkMultiProcessController.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkMPIController;

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
  using ruc::Communicator::Sum; // of doubles

  /** Collective: the ranks with the same `group` >= 0 as a communicator of their own, in the same
   * order. */
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
  vtkSmartPointer<vtkMultiProcessController> Own; // of a group
};

/**
 * One-way message from rank 0 to the ranks that work on their own, such as the reason to stop. It
 * is a number; 0 stands for none. Construction and Close are collective.
 */
class RUCCOMMON_EXPORT RankSignal
{
public:
  explicit RankSignal(const RankCommunicator& ranks);
  ~RankSignal();

  /** On rank 0: sends a message that is not 0, the first time. */
  void Give(int message);

  /** The message, or 0 as long as there is none; may be called at any time and rate. */
  int Heard();

  /**
   * Collective: ends when all ranks have come here. Until then rank 0 calls `ask` about ten times a
   * second, and sends the first number that is not 0.
   */
  void Close(const std::function<int()>& ask);

private:
  RankSignal(const RankSignal&) = delete;
  void operator=(const RankSignal&) = delete;

  const RankCommunicator& Ranks;
  vtkMPIController* Controller;        // null where there is one rank
  vtkMPICommunicator::Request Receipt; // of a higher rank
  int Message = 0;
  bool Done = false; // given, or received
};
