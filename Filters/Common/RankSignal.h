// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCCommonModule.h"

#include <functional>
#include <memory>

class RankCommunicator;

/**
 * A one-way message from rank 0 to the ranks, which work on their own meanwhile; such as the reason
 * to stop. It is a number, and 0 stands for no message. Construction and Close are collective.
 */
class RUCCOMMON_EXPORT RankSignal
{
public:
  /** There must be one rank, or MPI must connect the ranks (RankCommunicator::RequireMpi). */
  explicit RankSignal(const RankCommunicator& ranks);
  ~RankSignal();

  /** Sends a message that is not 0. Only the first one is sent. On rank 0 alone. */
  void Give(int message);

  /**
   * Returns the message, or 0 as long as there is none. May be called at any time and as often as
   * wanted.
   */
  int Heard();

  /**
   * Returns when all ranks have come here. Until then rank 0 calls `ask` about ten times a second,
   * and sends the first number that is not 0. Collective.
   */
  void Close(const std::function<int()>& ask);

  /** Whether this plugin was built with MPI. Without it there is one rank. */
  static const bool WithMpi;

private:
  RankSignal(const RankSignal&) = delete;
  void operator=(const RankSignal&) = delete;

  class Ranks;
  std::unique_ptr<Ranks> Others; // null if there is one rank
};
