// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/CellStart.h"

#include "Oracles.h"
#include "ruc/Base/Random.h"

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

void ExpectInCell(const ruc::CellContents& contents, const std::vector<double>& centres)
{
  ASSERT_EQ(centres.size(), 3 * std::size_t(contents.NumberOfSpheres()));
  for (double c : centres)
  {
    EXPECT_GE(c, 0.0);
    EXPECT_LT(c, contents.Edge);
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
    seen.push_back(ruc::RandomCentres(contents, 1, number));
    EXPECT_EQ(std::count(seen.begin(), seen.end(), seen.back()), 1);
  }
  EXPECT_EQ(ruc::RandomCentres(contents, 1, 2), ruc::RandomCentres(contents, 1, 2));
  EXPECT_NE(ruc::RandomCentres(contents, 1, 2), ruc::RandomCentres(contents, 2, 2));
}
