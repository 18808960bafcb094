// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Base/Random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

TEST(Random, SequencesAreTheTriplesOfTheirSamples)
{
  ruc::RandomSequence random(5, ruc::RandomStream::MutationOperator, 7);
  for (int n = 0; n < 4; ++n)
  {
    for (double u :
      ruc::UniformTriple(5, ruc::RandomStream::MutationOperator, (std::uint64_t(7) << 24) + n))
    {
      EXPECT_EQ(random.Next(), u);
    }
  }
}

TEST(Random, EveryIndexIsDrawnAlike)
{
  ruc::RandomSequence random(5, ruc::RandomStream::MutationOperator, 7);
  std::vector<int> counts(5, 0);
  constexpr int draws = 10000;
  for (int n = 0; n < draws; ++n)
  {
    ++counts.at(random.NextIndex(5));
  }
  // Within 5 standard errors of a fifth
  for (int count : counts)
  {
    EXPECT_NEAR(count, 0.2 * draws, 5.0 * std::sqrt(draws * 0.2 * 0.8));
  }
}
