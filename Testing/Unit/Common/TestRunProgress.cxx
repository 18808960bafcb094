// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RunProgress.h"

#include <gtest/gtest.h>

#include <cmath>

TEST(RunProgress, TextIsForReaders)
{
  EXPECT_EQ(
    (RunProgress{ "Unit Cell Reconstruction", "minimising F2, iteration 40", true, "F2", 0.05 }
        .ToText()),
    "Unit Cell Reconstruction: minimising F2, iteration 40 [F2 = 0.05, may be stopped]    ");
  EXPECT_EQ((RunProgress{ "Two-Point Probability", "summing pairs", false, {}, 0.0 }.ToText()),
    "Two-Point Probability: summing pairs [runs to its end]    ");
}

TEST(RunProgress, ComesBackFromItsText)
{
  for (const std::string activity : { "cell 2, iteration 40", "", "a: b, c = 3 [d]" })
  {
    for (const bool stoppable : { false, true })
    {
      for (const std::string quantity : { "", "F2", "Porosity (%)" })
      {
        for (const double value : { 0.0, -1.234e-5, 6.02e23 })
        {
          const RunProgress told{ "A Filter", activity, stoppable, quantity, value };
          const std::optional<RunProgress> heard = RunProgress::FromText(told.ToText());
          ASSERT_TRUE(heard) << told.ToText();
          EXPECT_EQ(heard->Filter, told.Filter);
          EXPECT_EQ(heard->Activity, told.Activity);
          EXPECT_EQ(heard->Stoppable, told.Stoppable);
          EXPECT_EQ(heard->Quantity, told.Quantity);
          EXPECT_EQ(heard->Value, quantity.empty() ? 0.0 : value);
        }
      }
    }
  }
}

// ParaView 6.1 loses four characters between server and client
TEST(RunProgress, FourCharactersMayGetLost)
{
  const std::string text = RunProgress{ "A Filter", "at work", true, "F2", 0.5 }.ToText();
  const std::optional<RunProgress> heard = RunProgress::FromText(text.substr(0, text.size() - 4));
  ASSERT_TRUE(heard);
  EXPECT_TRUE(heard->Stoppable);
  EXPECT_EQ(heard->Value, 0.5);
}

TEST(RunProgress, ValuesThatAreNoNumbersAreNotShown)
{
  const RunProgress told{ "A Filter", "at work", true, "F2", std::nan("") };
  const std::optional<RunProgress> heard = RunProgress::FromText(told.ToText());
  ASSERT_TRUE(heard);
  EXPECT_TRUE(heard->Quantity.empty());
  EXPECT_TRUE(heard->Stoppable);
}

TEST(RunProgress, OtherTextsAreNotTaken)
{
  for (const std::string text : { "", "vtkContourFilter", "Contour: 40 %", "may be stopped]",
         "A Filter: at work", "A Filter: [may be stopped]", "A Filter [may be stopped]",
         "no colon [F2 = 1, may be stopped]", "A Filter: at work [may be stopped] soon" })
  {
    EXPECT_FALSE(RunProgress::FromText(text)) << text;
  }
}
