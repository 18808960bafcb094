// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCCommonModule.h"
#include "ruc/Base/Communicator.h"

#include "vtkMPICommunicator.h"
#include "vtkMultiProcessController.h"
#include "vtkSmartPointer.h"

#include <array>
#include <functional>
#include <memory>
#include <string>

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

/**
 * A word that the lowest rank, once it is done, may give to the others that still go their own
 * ways, without a step that they take together. Made and closed by all ranks.
 */
class RUCCOMMON_EXPORT RankSignal
{
public:
  explicit RankSignal(const RankCommunicator& ranks);
  ~RankSignal();

  /** The word, or nothing as long as there is none; to be called as often as wanted. */
  std::string Heard();

  /**
   * Collective: ends when all ranks have come here. Until then the lowest one calls `ask` some ten
   * times a second and gives the first word that it returns, of at most 31 characters.
   */
  void Close(const std::function<std::string()>& ask);

private:
  RankSignal(const RankSignal&) = delete;
  void operator=(const RankSignal&) = delete;

  void Give(const std::string& word);

  using Letter = std::array<char, 32>;

  const RankCommunicator& Ranks;
  vtkMPIController* Controller;        // null where there is one rank
  vtkMPICommunicator::Request Receipt; // of a higher rank
  Letter Word = {};
  bool Done = false; // given, or received
};
