// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Packing/Deposition.h"

#include "Oracles.h"
#include "ruc/Base/Random.h"

namespace
{
struct Cell
{
  std::vector<double> Radii; // of every sphere
  double Edge;
};

Cell MakeCell(const std::vector<int>& counts, const std::vector<double>& radii, double fraction)
{
  Cell cell;
  double volume = 0.0;
  for (std::size_t m = 0; m < counts.size(); ++m)
  {
    cell.Radii.insert(cell.Radii.end(), counts[m], radii[m]);
    volume += counts[m] * 4.0 / 3.0 * oracle::Pi * std::pow(radii[m], 3);
  }
  cell.Edge = std::cbrt(volume / fraction);
  return cell;
}

ruc::SpherePack PackOf(const Cell& cell, const std::vector<double>& centres)
{
  ruc::SpherePack pack;
  pack.Radius = cell.Radii;
  for (std::size_t k = 0; k < centres.size(); k += 3)
  {
    pack.X.push_back(centres[k]);
    pack.Y.push_back(centres[k + 1]);
    pack.Z.push_back(centres[k + 2]);
  }
  return pack;
}

// The largest (a + b - d) / (a + b), by brute force
double DegreeOf(const Cell& cell, const std::vector<double>& centres)
{
  const ruc::SpherePack pack = PackOf(cell, centres);
  double degree = 0.0;
  oracle::ForEachPair(pack, oracle::PeriodicCube(cell.Edge), 2.0 * pack.LargestRadius(),
    [&](std::size_t i, std::size_t j, const std::array<int, 3>&, double d)
    { degree = std::max(degree, 1.0 - d / (pack.Radius[i] + pack.Radius[j])); });
  return degree;
}

void ExpectInCell(const Cell& cell, const std::vector<double>& centres)
{
  ASSERT_EQ(centres.size(), 3 * cell.Radii.size());
  for (double c : centres)
  {
    EXPECT_GE(c, 0.0);
    EXPECT_LT(c, cell.Edge);
  }
}

// Expects that the counts in 8 bins of an axis are within 5 standard errors of equal
void ExpectUniform(const std::vector<double>& values, double edge)
{
  std::vector<int> counts(8, 0);
  for (double value : values)
  {
    ++counts[static_cast<int>(value / edge * 8.0)];
  }
  const double mean = values.size() / 8.0;
  for (int count : counts)
  {
    EXPECT_NEAR(count, mean, 5.0 * std::sqrt(mean * 7.0 / 8.0));
  }
}
}

TEST(Deposition, EveryIndividualIsAnotherAndReproducible)
{
  const Cell cell = MakeCell({ 20, 30 }, { 1.0, 0.6 }, 0.5);
  const auto deposit = [&](std::uint32_t seed, std::uint32_t number)
  { return ruc::DepositBallistically(cell.Radii, cell.Edge, seed, number, 0.25).Centres; };
  std::vector<std::vector<double>> seen;
  for (std::uint32_t number = 0; number < 4; ++number)
  {
    seen.push_back(deposit(1, number));
    EXPECT_EQ(std::count(seen.begin(), seen.end(), seen.back()), 1);
  }
  EXPECT_EQ(deposit(1, 2), deposit(1, 2));
  EXPECT_NE(deposit(1, 2), deposit(2, 2));
}

TEST(Deposition, KeepsItsDegreeOfOverlap)
{
  for (const Cell& cell :
    { MakeCell({ 300 }, { 1.0 }, 0.63), MakeCell({ 40, 200 }, { 1.0, 0.5 }, 0.63),
      MakeCell({ 3, 30, 200 }, { 3.0, 1.0, 0.4 }, 0.63) })
  {
    for (std::uint32_t number : { 0u, 1u, 2u })
    {
      const ruc::BallisticDeposition deposition =
        ruc::DepositBallistically(cell.Radii, cell.Edge, 5, number, ruc::DefaultDepositionDegree);
      ExpectInCell(cell, deposition.Centres);
      EXPECT_LE(deposition.Degree, ruc::DefaultDepositionDegree);
      // Rounding of a distance
      EXPECT_NEAR(DegreeOf(cell, deposition.Centres), deposition.Degree, 1e-12);
    }
  }
  // Few spheres find places that touch nothing
  const Cell dilute = MakeCell({ 10, 40 }, { 1.0, 0.5 }, 0.1);
  EXPECT_EQ(ruc::DepositBallistically(dilute.Radii, dilute.Edge, 5, 0, 0.0).Degree, 0.0);
}

TEST(Deposition, ACellLittleLargerThanItsLargestSphere)
{
  Cell cell = MakeCell({ 1, 30 }, { 1.0, 0.2 }, 0.5);
  cell.Edge = 2.1;
  const ruc::BallisticDeposition deposition =
    ruc::DepositBallistically(cell.Radii, cell.Edge, 1, 0, 0.25);
  EXPECT_LE(deposition.Degree, 0.25);
  EXPECT_NEAR(DegreeOf(cell, deposition.Centres), deposition.Degree, 1e-12);
}

TEST(Deposition, ADegreeThatCannotBeKeptIsToldAndTheLeastOfTheDraws)
{
  // The fraction is above 0.382, at which random sequential addition jams
  const Cell cell = MakeCell({ 60 }, { 1.0 }, 0.6);
  const ruc::BallisticDeposition deposition =
    ruc::DepositBallistically(cell.Radii, cell.Edge, 1, 0, 0.0);
  EXPECT_GT(deposition.Degree, 0.0);
  EXPECT_NEAR(DegreeOf(cell, deposition.Centres), deposition.Degree, 1e-12);
  // As many random centres overlap far more
  std::vector<double> random;
  for (std::size_t i = 0; i < cell.Radii.size(); ++i)
  {
    for (double u : ruc::UniformTriple(1, ruc::RandomStream::CellCentres, i))
    {
      random.push_back(cell.Edge * u);
    }
  }
  EXPECT_LT(deposition.Degree, 0.5 * DegreeOf(cell, random));
}

TEST(Deposition, ADegreeOfOneAllowsAnyOverlap)
{
  const Cell cell = MakeCell({ 2000 }, { 1.0 }, 0.6);
  const std::vector<double> centres =
    ruc::DepositBallistically(cell.Radii, cell.Edge, 1, 0, 1.0).Centres;
  ExpectUniform(centres, cell.Edge);
}

TEST(Deposition, IsGivenUpWhenItIsTold)
{
  // The fraction is above that at which random sequential addition jams: most spheres take all of
  // their 10 000 draws
  const Cell cell = MakeCell({ 60 }, { 1.0 }, 0.6);
  for (int stopAt : { 1, 20 })
  {
    int calls = 0;
    const auto carryOn = [&]() { return ++calls < stopAt; };
    EXPECT_TRUE(
      ruc::DepositBallistically(cell.Radii, cell.Edge, 1, 0, 0.0, carryOn).Centres.empty());
    EXPECT_EQ(calls, stopAt);
  }
}

TEST(Deposition, DegreesOutOfRangeAreRefused)
{
  const Cell cell = MakeCell({ 2 }, { 1.0 }, 0.1);
  for (double degree : { -0.1, 1.1, std::nan("") })
  {
    EXPECT_SAYS(ruc::DepositBallistically(cell.Radii, cell.Edge, 1, 0, degree),
      "DepositionDegree requires 0 <= DepositionDegree <= 1, got");
  }
}
