// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/PairSums/SumRounds.h"

#include <stdexcept>

namespace ruc
{
bool SumRounds::GoOn(int round)
{
  // Nobody looks at what is agreed on before it is, and nobody agrees on more before all have
  // looked
#pragma omp barrier
#pragma omp master
  {
    const double done = static_cast<double>(round) / this->Rounds;
    const bool yes = round == 0 || !this->Progress || this->Progress(done);
    this->Stopped = !this->Ranks.All(yes);
  }
#pragma omp barrier
  return !this->Stopped && round < this->Rounds;
}

void SumRounds::RequireEnd() const
{
  if (this->Stopped)
  {
    throw std::invalid_argument(
      "The sum was stopped before its end, and a part of it is worth nothing.");
  }
}
}
