// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"

#include <algorithm>
#include <cstdint>
#include <functional>

namespace ruc
{
/**
 * A function that is told the share of a sum that is done, on the calling thread, and returns
 * whether to go on. Where any rank says no, the sum throws std::invalid_argument on all of them: a
 * part of it is worth nothing.
 */
using SumProgress = std::function<bool(double done)>;

/**
 * The rounds of a sum, after each of which the ranks agree whether to go on. GoOn is called by all
 * threads of a parallel region, and is collective.
 */
class SumRounds
{
public:
  /** `spheres` is their number on all ranks: a small sum is over before anyone can stop it. */
  SumRounds(std::int64_t spheres, Communicator& ranks, const SumProgress& progress)
    : Rounds(static_cast<int>(std::clamp<std::int64_t>(spheres / SpheresOfRound, 1, MostRounds)))
    , Ranks(ranks)
    , Progress(progress)
  {
  }

  /** Where the part of `count` things begins that belongs to a round. */
  std::int64_t Begin(int round, std::int64_t count) const { return count * round / this->Rounds; }

  /** Returns whether there is a round, after the rounds before it. */
  bool GoOn(int round);

  /** Throws where the sum was stopped. */
  void RequireEnd() const;

private:
  static constexpr int MostRounds = 64, SpheresOfRound = 50;

  int Rounds;
  Communicator& Ranks;
  const SumProgress& Progress;
  bool Stopped = false;
};
}
