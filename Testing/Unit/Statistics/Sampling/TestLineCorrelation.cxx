// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Sampling/LineCorrelation.h"

#include "Oracles.h"

namespace
{
using ruc::LagGrid;
using ruc::PhaseChange;

struct PhaseInterval
{
  double Begin, End;
  int Phase;
};

// Intervals of phases that follow on one another, with gaps outside the region
std::vector<PhaseChange> ChangesOf(const std::vector<PhaseInterval>& intervals, int outside)
{
  std::vector<PhaseChange> changes;
  for (std::size_t n = 0; n < intervals.size(); ++n)
  {
    const bool follows = n > 0 && intervals[n].Begin == intervals[n - 1].End;
    if (n > 0 && !follows)
    {
      changes.push_back({ intervals[n - 1].End, intervals[n - 1].Phase, outside });
    }
    changes.push_back(
      { intervals[n].Begin, follows ? intervals[n - 1].Phase : outside, intervals[n].Phase });
  }
  changes.push_back({ intervals.back().End, intervals.back().Phase, outside });
  return changes;
}
}

TEST(LineCorrelation, IsTheOverlapOfDisplacedIntervals)
{
  // Two modes and the matrix; two stretches of the region; lengths both on lags and between them
  const std::vector<PhaseInterval> intervals = { { 0.3, 1.0, 2 }, { 1.0, 1.75, 0 },
    { 1.75, 2.1, 2 }, { 2.1, 2.85, 1 }, { 2.85, 3.3, 0 }, { 4.05, 4.8, 0 }, { 4.8, 6.3, 2 } };
  for (const LagGrid& lags : { LagGrid{ 0.25, 30 }, LagGrid{ 0.11, 13 }, LagGrid{ 10.0, 1 } })
  {
    ruc::LineCorrelation correlation(2, lags);
    correlation.AddLine(ChangesOf({ { 0.0, 9.0, 1 } }, 3));
    correlation.Finish();
    correlation.Clear();
    for (int lines : { 1, 2 })
    {
      correlation.AddLine(ChangesOf(intervals, 3));
      correlation.AddLine(ChangesOf(intervals, 3));
      const std::vector<const double*> rows = correlation.Finish();
      for (int r = 0; r < 3; ++r)
      {
        for (int s = 0; s < 3; ++s)
        {
          for (int k = 0; k <= lags.Count; ++k)
          {
            double expected = 0.0;
            for (const PhaseInterval& a : intervals)
            {
              for (const PhaseInterval& b : intervals)
              {
                const double shift = k * lags.Spacing;
                expected += (a.Phase == r && b.Phase == s) *
                  std::max(
                    std::min(a.End + shift, b.End) - std::max(a.Begin + shift, b.Begin), 0.0);
              }
            }
            const double* row = rows[3 * r + s];
            EXPECT_NEAR(row ? row[k] : 0.0, 2.0 * expected, 1e-12)
              << r << " " << s << " " << k << " " << lines;
          }
        }
      }
      correlation.Clear();
    }
  }
}
