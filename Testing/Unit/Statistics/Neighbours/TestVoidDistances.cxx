// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Pores: lattices and overlapping spheres have closed forms
#include "HardPack.h"
#include "NeighbourPacks.h"
#include "ThreadRanks.h"
#include "ruc/Statistics/Neighbours/CriticalRadius.h"
#include "ruc/Statistics/Neighbours/VoidDistances.h"

#include <gtest/gtest.h>

#include <queue>
#include <set>

namespace
{
using ruc::VoidDistances;
using ruc::VoidSettings;

VoidDistances Measure(
  const oracle::PackInBox& made, const VoidSettings& settings = {}, double margin = 0.0)
{
  ruc::Communicator alone;
  return ruc::MeasureVoids(
    ruc::SharePack(made.Pack, made.Box), ruc::SamplingRegion(made.Box, margin), settings, alone);
}

// Spheres that touch, blown up by z, leave of the cell what their caps beyond its faces do not
// count
TEST(VoidDistances, OfTheSimpleCubicLattice)
{
  VoidSettings settings;
  settings.Spacing = 0.043;
  settings.MaximumDistance = 0.4;
  settings.Distances = 20;
  settings.Blocks = 8; // the cells
  const VoidDistances found = Measure(oracle::SimpleCubic(2), settings);
  const auto outside = [](double radius)
  {
    const double height = radius - 1.0;
    return 8.0 - 4.0 / 3.0 * oracle::Pi * std::pow(radius, 3) +
      2.0 * oracle::Pi * height * height * (3.0 * radius - height);
  };
  ASSERT_EQ(found.Distance.size(), 21u);
  EXPECT_EQ(found.Share[0].Value, 1.0);
  for (int k = 0; k <= 20; ++k)
  {
    // The lattice of points tells the volume of a body to some of its voxels
    EXPECT_NEAR(found.Share[k].Value, outside(1.0 + found.Distance[k]) / outside(1.0), 4e-3);
    EXPECT_NEAR(found.Share[k].Error, 0.0, 1e-3); // the same in all cells
  }
  EXPECT_NEAR(found.Beyond, found.Share.back().Value, 0.0);
}

void ExpectCritical(const oracle::PackInBox& lattice, double radius)
{
  VoidSettings settings;
  settings.Spacing = 0.047;
  const VoidDistances found = Measure(lattice, settings);
  for (const ruc::ValueWithError& critical : found.CriticalRadius)
  {
    // At most what is gained by passing a throat half a spacing before and behind it
    EXPECT_NEAR(critical.Value, radius, settings.Spacing * settings.Spacing / 8.0);
    EXPECT_LT(critical.Error, 0.05);
  }
}

// The circle between the centres that are the corners of the narrowest throat, less their radius
TEST(VoidDistances, CriticalRadiiOfLattices)
{
  ExpectCritical(oracle::SimpleCubic(3), std::sqrt(2.0) - 1.0);
  ExpectCritical(oracle::FaceCentred(3), 2.0 / std::sqrt(3.0) - 1.0);
  ExpectCritical(oracle::BodyCentred(3), std::sqrt(1.5) - 1.0);
}

// S. Torquato, Random Heterogeneous Materials, 2002, chapter 5: exp(-rho V(r + z)) of all points
TEST(VoidDistances, OfOverlappingSpheresAreExponential)
{
  const ruc::Window box = oracle::PeriodicCube(12.0);
  const oracle::PackInBox made = { oracle::RandomPack({ 900, 1500 }, { 0.5, 0.3 }, box, 8), box };
  for (bool periodic : { true, false })
  {
    oracle::PackInBox cut = made;
    cut.Box.Periodic = { periodic, periodic, periodic };
    VoidSettings settings;
    settings.Spacing = 0.08;
    settings.MaximumDistance = 0.7;
    settings.Distances = 14;
    settings.Blocks = 64;
    const VoidDistances found = Measure(cut, settings, periodic ? 0.0 : 1.2);
    for (int k = 1; k <= 14; ++k)
    {
      double volume = 0.0;
      for (std::size_t i = 0; i < made.Pack.Size(); ++i)
      {
        const double radius = made.Pack.Radius[i];
        volume +=
          4.0 / 3.0 * oracle::Pi * (std::pow(radius + found.Distance[k], 3) - std::pow(radius, 3));
      }
      EXPECT_NEAR(
        found.Share[k].Value, std::exp(-volume / box.Volume()), 4.0 * found.Share[k].Error);
      EXPECT_LT(found.Share[k].Error, 0.1 * found.Share[k].Value + 0.01);
    }
  }
}

// The mean is the integral of P
TEST(VoidDistances, TheMeanAgreesWithTheShares)
{
  const HardPack hard(150, 450, 0.5);
  const VoidDistances found = Measure({ hard.Pack, hard.Box });
  double integral = 0.0;
  for (std::size_t k = 1; k < found.Distance.size(); ++k)
  {
    integral += 0.5 * (found.Share[k].Value + found.Share[k - 1].Value) *
      (found.Distance[k] - found.Distance[k - 1]);
  }
  EXPECT_NEAR(found.Mean.Value, integral, 1e-3 * integral);
  EXPECT_GT(found.Mean.Error, 0.0);
  EXPECT_LT(found.Largest, found.MaximumDistance);
  EXPECT_EQ(found.Beyond, 0.0);
}

// To some of their errors of resolution, h^2 / 12 diameters
TEST(VoidDistances, ACoarserLatticeHasTheSameCriticalRadius)
{
  const HardPack hard(150, 450, 0.5);
  VoidSettings coarse, fine;
  coarse.Spacing = 0.2;
  fine.Spacing = 0.06;
  const VoidDistances one = Measure({ hard.Pack, hard.Box }, coarse);
  const VoidDistances other = Measure({ hard.Pack, hard.Box }, fine);
  for (int q = 0; q < 3; ++q)
  {
    EXPECT_NEAR(one.CriticalRadius[q].Value, other.CriticalRadius[q].Value, 0.01);
  }
}

TEST(VoidDistances, CriticalRadiiOfACylinderAreThoseOfTheBoxInside)
{
  const oracle::PackInBox made = oracle::SimpleCubic(5);
  const auto measure = [&](const ruc::Vector3& axis)
  {
    const ruc::Window cylinder = ruc::Window::MakeCylinder({ 5, 5, 1 }, axis, 4.4, 8.0);
    ruc::Communicator alone;
    VoidSettings settings;
    settings.Spacing = 0.06;
    const ruc::SpherePack inside = ruc::CropToWindow(made.Pack, cylinder);
    return ruc::MeasureVoids(
      ruc::SharePack(inside, cylinder), ruc::SamplingRegion(cylinder, 1.4), settings, alone);
  };
  const VoidDistances upright = measure({ 0, 0, 1 });
  for (const ruc::ValueWithError& critical : upright.CriticalRadius)
  {
    EXPECT_NEAR(critical.Value, std::sqrt(2.0) - 1.0, 0.06 * 0.06);
  }
  EXPECT_TRUE(std::isnan(measure({ 0, 0.1, 1 }).CriticalRadius[0].Value));
}

TEST(VoidDistances, OfOneSphere)
{
  oracle::PackInBox made;
  made.Pack = oracle::RandomPack({ 1 }, { 0.7 }, oracle::PeriodicCube(3.0), 1);
  made.Box = ruc::Window::MakeBox({ 0, 0, 0 }, { 3.0, 4.0, 5.0 }, { true, true, true });
  const VoidDistances found = Measure(made);
  EXPECT_GT(found.Points, 0);
  EXPECT_FALSE(std::isnan(found.Mean.Value));
  // Along x through the middle between the images in y and z
  EXPECT_GT(found.CriticalRadius[0].Value, 1.0);
}

TEST(VoidDistances, WhatIsRefused)
{
  const oracle::PackInBox cubic = oracle::SimpleCubic(2);
  VoidSettings settings;
  settings.Spacing = -1.0;
  EXPECT_SAYS(Measure(cubic, settings), "Spacing >= 0, got -1");
  settings.Spacing = 1e-4;
  EXPECT_SAYS(Measure(cubic, settings), "Spacing requires a lattice of at most 1e+09 points");
  settings = {};
  settings.MaximumDistance = 3.0;
  EXPECT_SAYS(Measure(cubic, settings), "without the largest radius, 3, got 3");
  settings = {};
  settings.Blocks = 0;
  EXPECT_SAYS(Measure(cubic, settings), "2 <= Blocks <= 1000, got 0");
  oracle::PackInBox full = cubic;
  std::fill(full.Pack.Radius.begin(), full.Pack.Radius.end(), 1.8);
  EXPECT_SAYS(Measure(full), "points outside the spheres");
}

TEST(VoidDistances, AreTheSameOnAnyRanks)
{
  for (bool periodic : { true, false })
  {
    const HardPack hard(120, 360, 0.5, periodic);
    const double margin = periodic ? 0.0 : 1.5;
    VoidSettings settings;
    settings.Spacing = 0.15;
    settings.Distances = 10;
    const VoidDistances whole = Measure({ hard.Pack, hard.Box }, settings, margin);
    for (int ranks = 2; ranks <= 4; ++ranks)
    {
      oracle::ThreadRanks::Run(ranks,
        [&](ruc::Communicator& communicator)
        {
          const ruc::SpherePack piece =
            oracle::PieceOf(hard.Pack, communicator.Rank(), ranks, ranks == 3);
          const VoidDistances found =
            ruc::MeasureVoids(ruc::SharePack(piece, hard.Box, true, communicator),
              ruc::SamplingRegion(hard.Box, margin), settings, communicator);
          EXPECT_EQ(found.Points, whole.Points);
          EXPECT_EQ(found.Mean.Value, whole.Mean.Value);
          EXPECT_EQ(found.Mean.Error, whole.Mean.Error);
          EXPECT_EQ(found.Largest, whole.Largest);
          for (std::size_t k = 0; k < whole.Share.size(); ++k)
          {
            EXPECT_EQ(found.Share[k].Value, whole.Share[k].Value);
            EXPECT_EQ(found.Share[k].Error, whole.Share[k].Error);
          }
          for (int q = 0; q < 3; ++q)
          {
            EXPECT_EQ(found.CriticalRadius[q].Value, whole.CriticalRadius[q].Value);
            EXPECT_EQ(found.CriticalRadius[q].Error, whole.CriticalRadius[q].Error);
          }
        });
    }
  }
}

// Whether the points from a value on connect, by a walk through the images of the box
bool Connects(const ruc::LatticeValues& values, int axis, float least)
{
  const std::array<int, 3>& count = values.Count;
  const auto wrapped = [&](int place, int q) { return (place % count[q] + count[q]) % count[q]; };
  const auto isIn = [&](const std::array<int, 3>& at)
  {
    for (int q = 0; q < 3; ++q)
    {
      if (!values.Periodic[q] && (at[q] < 0 || at[q] >= count[q]))
      {
        return false;
      }
    }
    return values.At(wrapped(at[0], 0), wrapped(at[1], 1), wrapped(at[2], 2)) >= least;
  };
  for (std::size_t n = 0; n < values.Size(); ++n)
  {
    const std::array<int, 3> start = { static_cast<int>(n / (count[1] * count[2])),
      static_cast<int>(n / count[2] % count[1]), static_cast<int>(n % count[2]) };
    if (!isIn(start) || (!values.Periodic[axis] && start[axis] != 0))
    {
      continue;
    }
    std::set<std::array<int, 3>> seen = { start };
    std::queue<std::array<int, 3>> next({ start });
    while (!next.empty())
    {
      const std::array<int, 3> at = next.front();
      next.pop();
      bool isImage = at[axis] != start[axis];
      for (int q = 0; q < 3; ++q)
      {
        isImage = isImage && wrapped(at[q], q) == start[q];
      }
      if (values.Periodic[axis] ? isImage : at[axis] == count[axis] - 1)
      {
        return true;
      }
      for (int m = 0; m < 6; ++m)
      {
        std::array<int, 3> other = at;
        other[m / 2] += m % 2 == 0 ? -1 : 1;
        bool isNear = true; // three boxes away at most
        for (int q = 0; q < 3; ++q)
        {
          isNear = isNear && std::abs(other[q] - start[q]) <= 3 * count[q];
        }
        if (isNear && isIn(other) && seen.insert(other).second)
        {
          next.push(other);
        }
      }
    }
  }
  return false;
}

TEST(CriticalRadius, IsWherePointsConnect)
{
  oracle::Uniform random(3);
  for (int n = 0; n < 30; ++n)
  {
    ruc::LatticeValues values = { nullptr, { 30, 5, 1 }, { 4, 6, 5 }, {} };
    for (int q = 0; q < 3; ++q)
    {
      values.Periodic[q] = random() < 0.5;
    }
    std::vector<float> numbers;
    for (int i = 0; i < 120; ++i)
    {
      numbers.push_back(static_cast<float>(random() < 0.5 ? 0.0 : random(0.01, 1.0)));
    }
    values.First = numbers.data();
    const std::array<double, 3> found = ruc::FindCriticalValues(values);
    for (int axis = 0; axis < 3; ++axis)
    {
      double expected = 0.0;
      for (float value : numbers)
      {
        if (value > expected && Connects(values, axis, value))
        {
          expected = value;
        }
      }
      EXPECT_EQ(found[axis], expected) << n << " " << axis;
    }
  }
}
}
