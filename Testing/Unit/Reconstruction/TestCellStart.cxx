// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/CellStart.h"

#include "Oracles.h"
#include "ruc/Base/Random.h"
#include "ruc/Packing/Deposition.h"

namespace
{
ruc::CellContents Contents(std::vector<int> counts, std::vector<double> radii, double fraction)
{
  double volume = 0.0;
  for (std::size_t m = 0; m < counts.size(); ++m)
  {
    volume += counts[m] * 4.0 / 3.0 * oracle::Pi * std::pow(radii[m], 3);
  }
  return { std::move(counts), std::move(radii), std::cbrt(volume / fraction) };
}

ruc::SpherePack PackOf(const ruc::CellContents& contents, const std::vector<double>& centres)
{
  ruc::SpherePack pack;
  for (std::size_t m = 0; m < contents.Count.size(); ++m)
  {
    pack.Radius.insert(pack.Radius.end(), contents.Count[m], contents.Radius[m]);
  }
  for (std::size_t k = 0; k < centres.size(); k += 3)
  {
    pack.X.push_back(centres[k]);
    pack.Y.push_back(centres[k + 1]);
    pack.Z.push_back(centres[k + 2]);
  }
  return pack;
}

// The largest (a + b - d) / (a + b), by brute force
double DegreeOf(const ruc::CellContents& contents, const std::vector<double>& centres)
{
  const ruc::SpherePack pack = PackOf(contents, centres);
  double degree = 0.0;
  oracle::ForEachPair(pack, oracle::PeriodicCube(contents.Edge), 2.0 * pack.LargestRadius(),
    [&](std::size_t i, std::size_t j, const std::array<int, 3>&, double d)
    { degree = std::max(degree, 1.0 - d / (pack.Radius[i] + pack.Radius[j])); });
  return degree;
}

void ExpectInCell(const ruc::CellContents& contents, const std::vector<double>& centres)
{
  ASSERT_EQ(centres.size(), 3 * std::size_t(contents.NumberOfSpheres()));
  for (double c : centres)
  {
    EXPECT_GE(c, 0.0);
    EXPECT_LT(c, contents.Edge);
  }
}

// Counts in 8 bins of an axis are within 5 standard errors of equal
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

TEST(CellStart, RandomCentresAreThoseOfTheGradientSearch)
{
  const ruc::CellContents contents = Contents({ 5, 8 }, { 1.0, 0.5 }, 0.5);
  const std::vector<double> centres = ruc::RandomCentres(contents, 7, 0);
  ASSERT_EQ(centres.size(), 39u);
  for (int i = 0; i < 13; ++i)
  {
    const std::array<double, 3> u = ruc::UniformTriple(7, ruc::RandomStream::CellCentres, i);
    for (int q = 0; q < 3; ++q)
    {
      EXPECT_EQ(centres[3 * i + q], contents.Edge * u[q]);
    }
  }
}

TEST(CellStart, RandomCentresAreUniform)
{
  const ruc::CellContents contents = Contents({ 20000 }, { 1.0 }, 0.5);
  const std::vector<double> centres = ruc::RandomCentres(contents, 3, 5);
  ExpectInCell(contents, centres);
  for (int q = 0; q < 3; ++q)
  {
    std::vector<double> values;
    for (std::size_t k = q; k < centres.size(); k += 3)
    {
      values.push_back(centres[k]);
    }
    ExpectUniform(values, contents.Edge);
  }
}

TEST(CellStart, EveryIndividualIsAnotherAndReproducible)
{
  const ruc::CellContents contents = Contents({ 20, 30 }, { 1.0, 0.6 }, 0.5);
  std::vector<std::vector<double>> seen;
  for (std::uint32_t number = 0; number < 4; ++number)
  {
    for (const std::vector<double>& centres : { ruc::RandomCentres(contents, 1, number),
           ruc::DepositBallistically(contents.Radii(), contents.Edge, 1, number, 0.25).Centres })
    {
      EXPECT_EQ(std::count(seen.begin(), seen.end(), centres), 0);
      seen.push_back(centres);
    }
  }
  EXPECT_EQ(ruc::RandomCentres(contents, 1, 2), ruc::RandomCentres(contents, 1, 2));
  EXPECT_NE(ruc::RandomCentres(contents, 1, 2), ruc::RandomCentres(contents, 2, 2));
  EXPECT_EQ(ruc::DepositBallistically(contents.Radii(), contents.Edge, 1, 2, 0.2).Centres,
    ruc::DepositBallistically(contents.Radii(), contents.Edge, 1, 2, 0.2).Centres);
  EXPECT_NE(ruc::DepositBallistically(contents.Radii(), contents.Edge, 1, 2, 0.2).Centres,
    ruc::DepositBallistically(contents.Radii(), contents.Edge, 2, 2, 0.2).Centres);
}

TEST(CellStart, BallisticDepositionKeepsItsDegreeOfOverlap)
{
  for (const ruc::CellContents& contents :
    { Contents({ 300 }, { 1.0 }, 0.63), Contents({ 40, 200 }, { 1.0, 0.5 }, 0.63),
      Contents({ 3, 30, 200 }, { 3.0, 1.0, 0.4 }, 0.63) })
  {
    for (std::uint32_t number : { 0u, 1u, 2u })
    {
      const ruc::BallisticDeposition deposition = ruc::DepositBallistically(
        contents.Radii(), contents.Edge, 5, number, ruc::DefaultDepositionDegree);
      ExpectInCell(contents, deposition.Centres);
      EXPECT_LE(deposition.Degree, ruc::DefaultDepositionDegree);
      // Rounding of a distance
      EXPECT_NEAR(DegreeOf(contents, deposition.Centres), deposition.Degree, 1e-12);
    }
  }
  // Few spheres find places that touch nothing
  const ruc::CellContents dilute = Contents({ 10, 40 }, { 1.0, 0.5 }, 0.1);
  EXPECT_EQ(ruc::DepositBallistically(dilute.Radii(), dilute.Edge, 5, 0, 0.0).Degree, 0.0);
}

TEST(CellStart, ACellLittleLargerThanItsLargestSphere)
{
  const ruc::CellContents contents = { { 1, 30 }, { 1.0, 0.2 }, 2.1 };
  const ruc::BallisticDeposition deposition =
    ruc::DepositBallistically(contents.Radii(), contents.Edge, 1, 0, 0.25);
  EXPECT_LE(deposition.Degree, 0.25);
  EXPECT_NEAR(DegreeOf(contents, deposition.Centres), deposition.Degree, 1e-12);
}

TEST(CellStart, ADegreeThatCannotBeKeptIsToldAndTheLeastOfTheDraws)
{
  // Above the fraction 0.382 at which random sequential addition jams
  const ruc::CellContents contents = Contents({ 60 }, { 1.0 }, 0.6);
  const ruc::BallisticDeposition deposition =
    ruc::DepositBallistically(contents.Radii(), contents.Edge, 1, 0, 0.0);
  EXPECT_GT(deposition.Degree, 0.0);
  EXPECT_NEAR(DegreeOf(contents, deposition.Centres), deposition.Degree, 1e-12);
  // Random centres of so many spheres overlap far more
  EXPECT_LT(deposition.Degree, 0.5 * DegreeOf(contents, ruc::RandomCentres(contents, 1, 0)));
}

TEST(CellStart, ADegreeOfOneAllowsAnyOverlap)
{
  const ruc::CellContents contents = Contents({ 2000 }, { 1.0 }, 0.6);
  const std::vector<double> centres =
    ruc::DepositBallistically(contents.Radii(), contents.Edge, 1, 0, 1.0).Centres;
  ExpectUniform(centres, contents.Edge);
}

TEST(CellStart, DegreesOutOfRangeAreRefused)
{
  const ruc::CellContents contents = Contents({ 2 }, { 1.0 }, 0.1);
  for (double degree : { -0.1, 1.1, std::nan("") })
  {
    EXPECT_SAYS(ruc::DepositBallistically(contents.Radii(), contents.Edge, 1, 0, degree),
      "DepositionDegree requires 0 <= DepositionDegree <= 1, got");
  }
}
