// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Tracing/PhaseChanges.h"

#include "Oracles.h"

using ruc::PhaseChange;

TEST(PhaseChanges, TheUnionCountsOnceAndTheLowestModeWins)
{
  const auto changesOf =
    [](std::vector<ruc::SphereHit> hits, const std::vector<ruc::LineInterval>& inside)
  {
    std::vector<PhaseChange> changes;
    ruc::FindPhaseChanges(hits, inside, 3, changes);
    std::vector<std::array<double, 3>> plain;
    for (const PhaseChange& c : changes)
    {
      plain.push_back({ c.Position, double(c.Before), double(c.After) });
    }
    return plain;
  };
  using Plain = std::vector<std::array<double, 3>>;
  EXPECT_EQ(changesOf({}, { { 0, 1 }, { 2, 3 } }),
    (Plain{ { 0, 4, 3 }, { 1, 3, 4 }, { 2, 4, 3 }, { 3, 3, 4 } }));
  // Two of one mode overlap, and one holds another
  EXPECT_EQ(changesOf({ { 3, 5, 1 }, { 1, 4, 1 }, { 2, 3, 1 } }, { { 0, 9 } }),
    (Plain{ { 0, 4, 3 }, { 1, 3, 1 }, { 5, 1, 3 }, { 9, 3, 4 } }));
  // A lower mode inside a higher one, a higher one cut by a lower one
  EXPECT_EQ(changesOf({ { 1, 6, 2 }, { 2, 3, 0 }, { 5, 7, 1 }, { 6.5, 8, 2 } }, { { 0, 9 } }),
    (Plain{ { 0, 4, 3 }, { 1, 3, 2 }, { 2, 2, 0 }, { 3, 0, 2 }, { 5, 2, 1 }, { 7, 1, 2 },
      { 8, 2, 3 }, { 9, 3, 4 } }));
  // Cut at both ends and by the gap; one lies in the gap; two touch
  EXPECT_EQ(changesOf({ { -1, 1, 0 }, { 3, 6, 1 }, { 4.2, 4.8, 0 }, { 6, 7, 2 }, { 8, 20, 0 } },
              { { 0, 4 }, { 5, 9 } }),
    (Plain{ { 0, 4, 0 }, { 1, 0, 3 }, { 3, 3, 1 }, { 4, 1, 4 }, { 5, 4, 1 }, { 6, 1, 2 },
      { 7, 2, 3 }, { 8, 3, 0 }, { 9, 0, 4 } }));
  // Two begin in one point
  EXPECT_EQ(changesOf({ { 1, 2, 1 }, { 1, 3, 2 }, { 1, 2, 1 } }, { { 1, 3 } }),
    (Plain{ { 1, 4, 1 }, { 2, 1, 2 }, { 3, 2, 4 } }));
}
