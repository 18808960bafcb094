// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// A study of sizes does what its parts do one by one, and says what it leaves out.

#include "ruc/Study/CellSizes.h"

#include "HardPack.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

namespace
{
const HardPack& ThePack()
{
  static const HardPack made(300, 300, 0.35);
  return made;
}

ruc::CellSizeSettings Settings(std::vector<int> sizes)
{
  ruc::CellSizeSettings settings;
  settings.Sizes = std::move(sizes);
  settings.Cells = 2;
  settings.MaximumLag = 3.0;
  settings.NumberOfLags = 20;
  settings.Blocks = 27;
  settings.Search.MaximumIterations = 20;
  settings.Search.Seed = 5;
  return settings;
}

ruc::CellSizeStudy StudySizes(
  const ruc::CellSizeSettings& settings, const HardPack& made = ThePack())
{
  ruc::Communicator alone;
  return ruc::StudyCellSizes(ruc::SharePack(made.Pack, made.Box), settings, alone, {});
}

// A card with one descriptor that is fitted and one that is not
ruc::CellsOfSize OfSize(int spheres, double fitted, double other)
{
  ruc::CellsOfSize of;
  of.Spheres = spheres;
  of.Card.Rows.push_back(
    { "c_1", ruc::DescriptorKind::Fraction, 1.0, 1.0, 1.0, 0.0, fitted, true });
  of.Card.Rows.push_back({ "Q6", ruc::DescriptorKind::Order, 1.0, 1.0, 1.0, 0.0, other, false });
  return of;
}
}

TEST(CellSizes, CellsAndReportsAreThoseOfTheirParts)
{
  const ruc::CellSizeSettings settings = Settings({ 60, 30, 60 });
  const ruc::CellSizeStudy study = StudySizes(settings);
  ASSERT_EQ(study.Sizes.size(), 2u);
  EXPECT_EQ(study.Sizes[0].Spheres, 30);
  EXPECT_EQ(study.Sizes[1].Spheres, 60);
  ruc::Communicator alone;
  const ruc::PackShare share = ruc::SharePack(ThePack().Pack, ThePack().Box);
  const ruc::DescriptorSettings descriptors = { { 0.15, 20 }, share.MeanDiameter(), 27 };
  const ruc::PackDescriptors pack = ruc::MeasureDescriptors(share, descriptors, false, alone);
  const ruc::CellContents contents = ruc::FindCellContents(ruc::ModeAmounts(share), 60);
  std::vector<ruc::PackDescriptors> cells;
  for (int n = 0; n < 2; ++n)
  {
    ruc::GradientSearchSettings search = settings.Search;
    search.Seed += n;
    const ruc::UnitCell cell = ruc::SearchByGradient(
      contents, pack.Sums, search, alone, [](const ruc::SearchState&) { return true; });
    EXPECT_EQ(study.Sizes[1].Objectives[n], cell.Objective);
    cells.push_back(
      ruc::MeasureDescriptors(ruc::SharePack(cell.Pack, cell.Box), descriptors, true, alone));
  }
  std::vector<bool> fitted(ruc::CountOf(ruc::DescriptorKind{}), false);
  fitted[static_cast<int>(ruc::DescriptorKind::Fraction)] = true;
  fitted[static_cast<int>(ruc::DescriptorKind::TwoPoint)] = true;
  const ruc::ReportCard expected = ruc::MakeReportCard({ pack }, cells, fitted);
  const ruc::ReportCard& card = study.Sizes[1].Card;
  ASSERT_EQ(card.Rows.size(), expected.Rows.size());
  for (std::size_t n = 0; n < card.Rows.size(); ++n)
  {
    EXPECT_EQ(card.Rows[n].Z, expected.Rows[n].Z) << card.Rows[n].Name;
    EXPECT_EQ(card.Rows[n].Fitted, expected.Rows[n].Fitted) << card.Rows[n].Name;
  }
  EXPECT_EQ(study.Floor, expected.Floor);
}

TEST(CellSizes, TheLeastSizeIsThatFromWhichOnAllAreWithin)
{
  ruc::CellSizeStudy study;
  study.Sizes = { OfSize(10, 1.0, 1.0), OfSize(20, -3.0, 0.0), OfSize(40, 1.9, 2.5),
    OfSize(80, -2.0, 1.0) };
  EXPECT_EQ(study.LeastSize(false), 80);
  EXPECT_EQ(study.LeastSize(true), 40);
  EXPECT_EQ(study.Verdict(),
    "Cells are within the pack's own error in all descriptors from 80 spheres on, and in those "
    "that the search fits from 40 spheres on. Of 80 spheres: Representative within the pack's own "
    "error in 2 of 2 descriptors.");
  study.Sizes.push_back(OfSize(160, 5.0, 0.0));
  EXPECT_EQ(study.LeastSize(false), 0);
  EXPECT_NE(study.Verdict().find("at no size studied"), std::string::npos);
}

// Of 30 large and 570 small spheres a cell of 5 has none of the large
TEST(CellSizes, WhatHasNoSphereOfAModeIsLeftOut)
{
  const HardPack made(30, 570, 0.3);
  const ruc::CellSizeStudy study = StudySizes(Settings({ 5, 40 }), made);
  ASSERT_EQ(study.Sizes.size(), 1u);
  ASSERT_EQ(study.LeftOut.size(), 1u);
  EXPECT_EQ(study.LeftOut.front().find("5 spheres: "), 0u) << study.LeftOut.front();
  EXPECT_THROW(StudySizes(Settings({ 5 }), made), std::invalid_argument);
}

TEST(CellSizes, AStopKeepsWhatIsFinished)
{
  ruc::Communicator alone;
  const ruc::CellSizeStudy study =
    ruc::StudyCellSizes(ruc::SharePack(ThePack().Pack, ThePack().Box), Settings({ 30, 60 }), alone,
      [](double, const std::string& what) { return what.find("60 spheres") == std::string::npos; });
  EXPECT_TRUE(study.Stopped);
  ASSERT_EQ(study.Sizes.size(), 1u);
  EXPECT_EQ(study.Sizes[0].Spheres, 30);
}

TEST(CellSizes, RefusesSettings)
{
  const auto refuses = [](const ruc::CellSizeSettings& settings, const std::string& property)
  {
    try
    {
      StudySizes(settings);
      ADD_FAILURE() << property;
    }
    catch (const std::invalid_argument& error)
    {
      EXPECT_EQ(std::string(error.what()).find(property + " requires"), 0u) << error.what();
    }
  };
  refuses(Settings({}), "Sizes");
  refuses(Settings({ 0 }), "Sizes");
  ruc::CellSizeSettings settings = Settings({ 40 });
  settings.Cells = 0;
  refuses(settings, "NumberOfCells");
  settings = Settings({ 40 });
  settings.Blocks = 7;
  refuses(settings, "Blocks");
  settings = Settings({ 40 });
  settings.MaximumLag = 100.0;
  refuses(settings, "MaximumLag");
}
