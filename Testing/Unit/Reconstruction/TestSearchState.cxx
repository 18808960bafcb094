// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/SearchState.h"

#include <gtest/gtest.h>

using ruc::EndReason;
using ruc::SearchPhase;

// Scripts compare these texts
TEST(SearchState, HasTheNamesThatUsersSee)
{
  EXPECT_STREQ(ruc::NameOf(SearchPhase::RemovingOverlap), "removing overlap");
  EXPECT_STREQ(ruc::NameOf(SearchPhase::MinimisingObjective), "minimising F2");
  EXPECT_STREQ(ruc::NameOf(SearchPhase::AnnealingPopulation), "annealing population");
  EXPECT_STREQ(ruc::NameOf(SearchPhase::FittingNeighbours), "fitting neighbours");
  EXPECT_STREQ(ruc::NameOf(EndReason::None), "");
  EXPECT_STREQ(ruc::NameOf(EndReason::TargetObjective), "Target objective");
  EXPECT_STREQ(ruc::NameOf(EndReason::MaximumIterations), "Maximum iterations");
  EXPECT_STREQ(ruc::NameOf(EndReason::Converged), "Converged");
  EXPECT_STREQ(ruc::NameOf(EndReason::Stopped), "Stopped");
  EXPECT_STREQ(ruc::NameOf(EndReason::TimeLimit), "Time limit");
  EXPECT_STREQ(ruc::NameOf(EndReason::StopFile), "Stop file");
  EXPECT_STREQ(ruc::NameOf(EndReason::Abort), "Abort");
  EXPECT_STREQ(ruc::NameOf(EndReason::StopButton), "Stop button");
}

TEST(SearchState, KnowsWhatComesFromOutside)
{
  for (EndReason reason : { EndReason::None, EndReason::TargetObjective,
         EndReason::MaximumIterations, EndReason::Converged })
  {
    EXPECT_FALSE(ruc::IsFromOutside(reason)) << ruc::NameOf(reason);
  }
  for (EndReason reason : { EndReason::Stopped, EndReason::TimeLimit, EndReason::StopFile,
         EndReason::Abort, EndReason::StopButton })
  {
    EXPECT_TRUE(ruc::IsFromOutside(reason)) << ruc::NameOf(reason);
  }
}
