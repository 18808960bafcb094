// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/CellContents.h"

#include "Oracles.h"
#include "ThreadRanks.h"
#include "ruc/Statistics/Results/OnePointProbability.h"

#include <algorithm>
#include <limits>

namespace
{
const ruc::Window Block =
  ruc::Window::MakeBox({ 0, 0, 0 }, { 20, 25, 30 }, { false, false, false });

// Sizes differ within a mode
ruc::SpherePack Pack()
{
  ruc::SpherePack pack = oracle::RandomPack({ 400, 150, 33 }, { 0.4, 0.8, 1.3 }, Block, 17);
  oracle::Uniform random(18);
  for (double& radius : pack.Radius)
  {
    radius *= random(0.9, 1.1);
  }
  return pack;
}

// F1 by its definition, equation (11)
double Difference(
  const ruc::CellContents& contents, const std::vector<double>& fractions, double edge)
{
  double sum = 0.0;
  for (std::size_t m = 0; m < contents.Count.size(); ++m)
  {
    sum += std::pow(fractions[m] -
        4.0 * oracle::Pi * std::pow(contents.Radius[m], 3) * contents.Count[m] /
          (3.0 * std::pow(edge, 3)),
      2);
  }
  return std::sqrt(sum);
}
}

TEST(CellContents, CountsAreTheNearestWholeNumbers)
{
  const ruc::SpherePack pack = Pack();
  const int counts[] = { 400, 150, 33 };
  for (double edge : { 8.0, 10.0, 12.34, 17.0 })
  {
    const ruc::CellContents contents = ruc::FindCellContents(ruc::SharePack(pack, Block), edge);
    ASSERT_EQ(contents.Count.size(), 3u);
    int total = 0;
    for (int m = 0; m < 3; ++m)
    {
      EXPECT_LE(std::abs(contents.Count[m] - counts[m] * edge * edge * edge / 15000.0), 0.5);
      total += contents.Count[m];
      double cubes = 0.0;
      for (std::size_t i = 0; i < pack.Size(); ++i)
      {
        cubes += pack.Mode[i] == m + 1 ? std::pow(pack.Radius[i], 3) : 0.0;
      }
      EXPECT_NEAR(contents.Radius[m], std::cbrt(cubes / counts[m]), 1e-13); // rounding of a sum
    }
    EXPECT_EQ(contents.NumberOfSpheres(), total);
  }
}

TEST(CellContents, EdgeMinimisesTheDifferenceOfTheFractions)
{
  const ruc::SpherePack pack = Pack();
  const std::vector<double> fractions = ruc::OnePointProbability(ruc::SharePack(pack, Block));
  for (double edge : { 8.0, 10.0, 12.34 })
  {
    const ruc::CellContents contents = ruc::FindCellContents(ruc::SharePack(pack, Block), edge);
    const double least = Difference(contents, fractions, contents.Edge);
    for (int n = -2000; n <= 2000; ++n)
    {
      const double other = contents.Edge * (1.0 + 1e-4 * n);
      EXPECT_GE(Difference(contents, fractions, other), least * (1.0 - 1e-12)) << other;
    }
    // F1 rises on both sides: h_c is the minimum and not a plateau
    EXPECT_GT(Difference(contents, fractions, contents.Edge * 1.001), least * (1.0 + 1e-9));
    EXPECT_GT(Difference(contents, fractions, contents.Edge * 0.999), least * (1.0 + 1e-9));
    EXPECT_NEAR(ruc::OnePointDifference(contents, fractions, 1.1 * edge),
      Difference(contents, fractions, 1.1 * edge), 1e-14);
  }
}

TEST(CellContents, AnExactShareKeepsTheFractionsAndTheEdge)
{
  // One eighth of a pack whose counts divide by 8 has the fractions of the pack: F1 = 0 at half the
  // edge.
  const ruc::Window box = oracle::PeriodicCube(20.0);
  const ruc::SpherePack pack = oracle::RandomPack({ 80, 160 }, { 1.0, 0.5 }, box, 1);
  const ruc::CellContents contents = ruc::FindCellContents(ruc::SharePack(pack, box), 10.0);
  EXPECT_EQ(contents.Count, (std::vector<int>{ 10, 20 }));
  EXPECT_NEAR(contents.Edge, 10.0, 1e-13);
}

TEST(CellContents, ByNumberOfSpheres)
{
  const ruc::SpherePack pack = Pack();
  for (int spheres : { 30, 57, 100, 101, 102, 103, 583, 1000 })
  {
    const ruc::CellContents contents = ruc::FindCellContents(ruc::SharePack(pack, Block), spheres);
    EXPECT_EQ(contents.NumberOfSpheres(), spheres);
    // The contents are those of some one edge: the counts' shares of the pack's agree to their
    // rounding
    const double share = contents.Count[0] / 400.0;
    EXPECT_NEAR(contents.Count[1], 150 * share, 0.5 + 150 * 0.5 / 400);
    EXPECT_NEAR(contents.Count[2], 33 * share, 0.5 + 33 * 0.5 / 400);
  }
}

TEST(CellContents, AnImpossibleNumberGivesTheNext)
{
  // Two modes of equal counts always round together, so that every total is even.
  const ruc::SpherePack pack = oracle::RandomPack({ 50, 50 }, { 0.5, 0.6 }, Block, 1);
  EXPECT_EQ(ruc::FindCellContents(ruc::SharePack(pack, Block), 20).NumberOfSpheres(), 20);
  EXPECT_EQ(ruc::FindCellContents(ruc::SharePack(pack, Block), 21).NumberOfSpheres(), 22);
}

TEST(CellContents, EveryModeNeedsASphere)
{
  const ruc::SpherePack pack = oracle::RandomPack({ 400, 150, 3 }, { 0.4, 0.8, 1.3 }, Block, 17);
  EXPECT_SAYS(ruc::FindCellContents(ruc::SharePack(pack, Block), 8.0),
    "none of mode 3 (0.1024 in a cell of this size)");
  EXPECT_SAYS(ruc::FindCellContents(ruc::SharePack(pack, Block), 30), "none of mode 3");
  // At twice the volume that rounds up to one sphere there is one
  EXPECT_EQ(
    ruc::FindCellContents(ruc::SharePack(pack, Block), std::cbrt(15000.0 / 3.0)).Count[2], 1);
}

TEST(CellContents, TheSizeTheMessageAdvisesWorks)
{
  for (int rare : { 1, 2, 3, 5, 7, 11 })
  {
    const ruc::SpherePack pack = oracle::RandomPack({ 4000, rare }, { 0.4, 0.5 }, Block, 17);
    const std::string message =
      oracle::MessageOf([&]() { ruc::FindCellContents(ruc::SharePack(pack, Block), 2.0); });
    const std::size_t at = message.find("CellSize to ");
    ASSERT_NE(at, std::string::npos) << message;
    const double advised = std::stod(message.substr(at + 12));
    EXPECT_NO_THROW(ruc::FindCellContents(ruc::SharePack(pack, Block), advised)) << message;
  }
}

TEST(CellContents, TheLargestSphereNeedsRoom)
{
  // Four spheres of diameter 19 fill no more than a cell of about their own size
  const ruc::SpherePack pack = oracle::RandomPack({ 4, 400 }, { 9.5, 0.1 }, Block, 17);
  EXPECT_SAYS(ruc::FindCellContents(ruc::SharePack(pack, Block), 13.0),
    "CellSize requires an edge longer than the largest sphere's diameter, 19");
}

TEST(CellContents, FromFractionsAndDiametersAsFromThePackThatHasThem)
{
  const ruc::SpherePack pack = Pack();
  const ruc::PackShare share = ruc::SharePack(pack, Block);
  std::vector<double> fractions = ruc::OnePointProbability(share), diameters;
  fractions.pop_back(); // the matrix
  for (double radius : ruc::ModeAmounts(share).Radius)
  {
    diameters.push_back(2.0 * radius);
  }
  const ruc::ModeAmounts amounts(fractions, diameters);
  // The volume mean of all spheres
  EXPECT_NEAR(amounts.MeanDiameter(), share.MeanDiameter(), 1e-12);
  for (int mode = 0; mode < 3; ++mode)
  {
    EXPECT_NEAR(amounts.Fraction(mode), fractions[mode], 1e-15);
  }
  const ruc::CellContents given = ruc::FindCellContents(amounts, 12.34);
  const ruc::CellContents expected = ruc::FindCellContents(share, 12.34);
  EXPECT_EQ(given.Count, expected.Count);
  EXPECT_NEAR(given.Edge, expected.Edge, 1e-12);
  // The same from the counts
  EXPECT_EQ(ruc::FindCellContents(amounts, given.Count).Edge, given.Edge);
}

TEST(CellContents, OfGivenCountsTheEdgeStillMinimisesTheDifference)
{
  const std::vector<double> fractions = { 0.1, 0.25 };
  const ruc::ModeAmounts amounts(fractions, { 1.0, 2.0 });
  const ruc::CellContents contents = ruc::FindCellContents(amounts, std::vector<int>{ 7, 4 });
  EXPECT_EQ(contents.Count, (std::vector<int>{ 7, 4 }));
  const double least = Difference(contents, fractions, contents.Edge);
  for (double factor : { 0.9, 0.999, 1.001, 1.1 })
  {
    EXPECT_GT(Difference(contents, fractions, factor * contents.Edge), least) << factor;
  }
}

TEST(CellContents, RefusesImpossibleFractionsDiametersAndCounts)
{
  using Numbers = std::vector<double>;
  const ruc::ModeAmounts good({ 0.2, 0.3 }, { 1.0, 2.0 });
  EXPECT_SAYS(ruc::ModeAmounts(Numbers{ 0.2, 0.3 }, Numbers{ 1.0 }), "each of the 2 modes, got 1");
  EXPECT_SAYS(ruc::ModeAmounts(Numbers{}, Numbers{}), "got 0");
  EXPECT_SAYS(ruc::ModeAmounts(Numbers{ 0.2, 0.3 }, Numbers{ 1.0, 0.0 }), "got 0 for mode 2");
  EXPECT_SAYS(ruc::ModeAmounts(Numbers{ 0.2, 0.0 }, Numbers{ 1.0, 1.0 }), "got 0 of mode 2");
  EXPECT_SAYS(ruc::ModeAmounts(Numbers{ 0.7, 0.4 }, Numbers{ 1.0, 1.0 }), "a sum of 1.1");
  EXPECT_SAYS(ruc::FindCellContents(good, std::vector<int>{ 5 }), "each of the 2 modes, got 1");
  EXPECT_SAYS(ruc::FindCellContents(good, std::vector<int>{ 5, 0 }), "got 0 for mode 2");
}

// Sizes of a mode of the pack's own: number, surface and volume
TEST(CellContents, DividedModesHaveThePacksSizes)
{
  const ruc::SpherePack pack = Pack();
  const ruc::PackShare share = ruc::SharePack(pack, Block);
  ruc::Communicator alone;
  const ruc::CellContents whole = ruc::FindCellContents(share, 12.34);
  const auto moment = [](const ruc::CellContents& contents, int mode, int power)
  {
    double sum = 0.0;
    for (std::size_t t = 0; t < contents.Count.size(); ++t)
    {
      sum += contents.ModeOf(static_cast<int>(t)) == mode
        ? contents.Count[t] * std::pow(contents.Radius[t], power)
        : 0.0;
    }
    return sum;
  };
  for (int diameters : { 2, 5, 0 })
  {
    const ruc::CellContents divided = ruc::DivideModes(whole, diameters, share, alone);
    EXPECT_EQ(divided.NumberOfSpheres(), whole.NumberOfSpheres());
    EXPECT_EQ(divided.NumberOfModes(), 3);
    EXPECT_EQ(divided.Edge, whole.Edge);
    for (int mode = 1; mode <= 3; ++mode)
    {
      const int spheres = whole.Count[mode - 1];
      const auto types = std::count(divided.Mode.begin(), divided.Mode.end(), mode);
      EXPECT_EQ(types, diameters == 0 ? spheres : std::min(diameters, spheres));
      EXPECT_EQ(moment(divided, mode, 0), spheres);
      EXPECT_NEAR(moment(divided, mode, 3) / moment(whole, mode, 3), 1.0, 1e-13);
      // Surface per volume of the pack's mode; one size has less
      double squares = 0.0, cubes = 0.0;
      for (std::size_t i = 0; i < pack.Size(); ++i)
      {
        squares += pack.Mode[i] == mode ? std::pow(pack.Radius[i], 2) : 0.0;
        cubes += pack.Mode[i] == mode ? std::pow(pack.Radius[i], 3) : 0.0;
      }
      const auto error = [&](const ruc::CellContents& contents) {
        return std::abs(
          moment(contents, mode, 2) / moment(contents, mode, 3) * cubes / squares - 1.0);
      };
      // Of equal parts of a uniform spread the error falls with the square of their number
      EXPECT_LT(error(divided), (types > 4 ? 0.1 : 0.4) * error(whole));
    }
    const ruc::SpherePack made =
      divided.MakePack(std::vector<double>(3 * divided.NumberOfSpheres(), 0.0).data());
    EXPECT_TRUE(std::is_sorted(made.Mode.begin(), made.Mode.end()));
    EXPECT_EQ(made.Radius, divided.Radii());
  }
}

TEST(CellContents, DividedModesAreTheSameOnAnyRanks)
{
  const ruc::SpherePack pack = Pack();
  ruc::Communicator alone;
  const ruc::PackShare all = ruc::SharePack(pack, Block);
  const ruc::CellContents whole = ruc::FindCellContents(all, 12.34);
  const ruc::CellContents expected = ruc::DivideModes(whole, 4, all, alone);
  for (int ranks : { 2, 3, 4 })
  {
    oracle::ThreadRanks::Run(ranks,
      [&](ruc::Communicator& communicator)
      {
        const ruc::PackShare share = ruc::SharePack(
          communicator.Rank() == 0 ? pack : ruc::SpherePack(), Block, true, communicator);
        const ruc::CellContents divided = ruc::DivideModes(whole, 4, share, communicator);
        EXPECT_EQ(divided.Radius, expected.Radius);
        EXPECT_EQ(divided.Count, expected.Count);
        EXPECT_EQ(divided.Mode, expected.Mode);
      });
  }
}

TEST(CellContents, OneDiameterAModeIsAsIfItWasNotDivided)
{
  const ruc::PackShare share = ruc::SharePack(Pack(), Block);
  ruc::Communicator alone;
  const ruc::CellContents whole = ruc::FindCellContents(share, 12.34);
  const ruc::CellContents divided = ruc::DivideModes(whole, 1, share, alone);
  EXPECT_EQ(divided.Count, whole.Count);
  EXPECT_EQ(divided.Mode, (std::vector<int>{ 1, 2, 3 }));
  for (int m = 0; m < 3; ++m)
  {
    EXPECT_NEAR(divided.Radius[m] / whole.Radius[m], 1.0, 1e-14);
  }
}
