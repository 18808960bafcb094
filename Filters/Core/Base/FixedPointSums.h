// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/FixedPoint.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ruc
{
/**
 * Sums of any number of fixed-point numbers, in two stages: the inner loops add to 64-bit sums,
 * which are carried into wider ones (AddWide) before they can overflow.
 *
 * Terms are scaled to at most 2^TermBits. Between two carries no sum takes more than MostTerms =
 * 2^(62 - TermBits) terms, so that it stays below 2^62.
 */
class FixedPointSums
{
public:
  static constexpr int TermBits = 36;
  static constexpr std::int64_t MostTerms = std::int64_t(1) << (62 - TermBits);

  explicit FixedPointSums(std::size_t count)
    : Partial(count, 0)
    , Wide(2 * count, 0)
  {
  }

  /**
   * Returns the 64-bit sums, to which the next terms may be added: to any one sum at most `terms`
   * of them, which is at most MostTerms.
   */
  std::int64_t* Take(std::int64_t terms)
  {
    this->Pending += terms;
    if (this->Pending > MostTerms)
    {
      this->Carry();
      this->Pending = terms;
    }
    return this->Partial.data();
  }

  /** Returns the wide sums, two limbs each. */
  const std::vector<std::int64_t>& Finish()
  {
    this->Carry();
    return this->Wide;
  }

private:
  void Carry()
  {
    for (std::size_t n = 0; n < this->Partial.size(); ++n)
    {
      AddWide(this->Partial[n], &this->Wide[2 * n]);
      this->Partial[n] = 0;
    }
    this->Pending = 0;
  }

  std::vector<std::int64_t> Partial, Wide;
  std::int64_t Pending = 0;
};
}
