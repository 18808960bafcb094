// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCCommonModule.h"

#include <functional>
#include <memory>

class RankCommunicator;

/**
 * One-way message from rank 0 to the ranks that work on their own, such as the reason to stop. It
 * is a number; 0 stands for none. Construction and Close are collective.
 */
class RUCCOMMON_EXPORT RankSignal
{
public:
  /** The ranks must be connected by MPI (RankCommunicator::RequireMpi), or be one. */
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

  /** Whether this plugin was built with MPI; without, there is one rank. */
  static const bool WithMpi;

private:
  RankSignal(const RankSignal&) = delete;
  void operator=(const RankSignal&) = delete;

  class Ranks;
  std::unique_ptr<Ranks> Others; // null where there is one rank
};
