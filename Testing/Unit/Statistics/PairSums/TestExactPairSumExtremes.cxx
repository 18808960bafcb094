// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/PairSums/ExactPairSum.h"

#include "Oracles.h"
#include "PairSumComparison.h"
#include "ruc/Statistics/PairSums/PairHistogram.h"

using ruc::LagGrid;
using ruc::SpherePack;
using ruc::TwoPointProbability;
using ruc::Window;

namespace
{
void ExpectMoved(const TwoPointProbability& got, const TwoPointProbability& expected, double bound)
{
  ASSERT_EQ(got.Pairs(), expected.Pairs());
  for (int p = 0; p < got.Pairs(); ++p)
  {
    ExpectNear(got.Values[p], expected.Values[p], bound);
  }
}
}

// A centre 1e9 away from the origin is rounded by 6e-8, which moves no S_rs by more than its slope,
// a quarter of the surface per volume, times that
TEST(ExactPairSum, OffsetsOfABillion)
{
  const Window box = oracle::PeriodicCube(12.0);
  const SpherePack pack = oracle::RelaxedPack({ 60, 120 }, { 1.0, 0.6 }, box, 3);
  const LagGrid lags = { 0.25, 40 };
  const TwoPointProbability expected = ruc::SumPairs(pack, box, lags);
  for (bool periodic : { true, false })
  {
    const Window here = Window::MakeBox({ 0, 0, 0 }, box.Size, { periodic, periodic, periodic });
    const Window there =
      Window::MakeBox({ 1e9, -1e9, 1e9 }, box.Size, { periodic, periodic, periodic });
    SpherePack moved = pack;
    for (std::size_t i = 0; i < pack.Size(); ++i)
    {
      moved.X[i] += 1e9;
      moved.Y[i] -= 1e9;
      moved.Z[i] += 1e9;
    }
    const LagGrid shorter = { 0.25, 30 };
    ExpectMoved(ruc::SumPairs(moved, there, shorter), ruc::SumPairs(pack, here, shorter), 1e-6);
  }
  ASSERT_EQ(expected.Lags.Count, 40); // beyond half the box
}

// Centres on the faces, edges and corners of a periodic box are those of the lattice that is moved
// away from them
TEST(ExactPairSum, SpheresOnFacesAndCorners)
{
  const Window box = oracle::PeriodicCube(3.0);
  const LagGrid lags = { 0.1, 60 };
  const auto lattice = [](double shift)
  {
    SpherePack pack;
    for (int i = 0; i < 27; ++i)
    {
      pack.X.push_back(i % 3 + shift);
      pack.Y.push_back(i / 3 % 3 + shift);
      pack.Z.push_back(i / 9 + shift);
      pack.Radius.push_back(i == 0 ? 0.45 : 0.4);
      pack.Mode.push_back(i == 0 ? 2 : 1);
    }
    return pack;
  };
  ExpectMoved(ruc::SumPairs(lattice(0.0), box, lags), ruc::SumPairs(lattice(0.5), box, lags), 1e-9);
}

// Lags far finer than the spheres would take tables of gigabytes. For them S_rr = c_r - s r / 4,
// with s the surface of the spheres of a mode per volume, to the second order.
TEST(ExactPairSum, LagsFarFinerThanTheSpheres)
{
  const Window box = oracle::PeriodicCube(6.0);
  const SpherePack pack = oracle::RelaxedPack({ 10, 20 }, { 0.9, 0.5 }, box, 3);
  const LagGrid lags = { 1e-7, 277 };
  std::vector<ruc::SphereType> types = { { 1, 0.9 }, { 2, 0.5 } };
  EXPECT_GT(ruc::PairHistogram::EstimateTables(types, lags), 1e9);
  const TwoPointProbability found = ruc::SumPairs(pack, box, lags);
  const double counts[] = { 10.0, 20.0 }, radii[] = { 0.9, 0.5 };
  for (int r : { 0, 1 })
  {
    const double surface = 4.0 * oracle::Pi * radii[r] * radii[r] * counts[r] / box.Volume();
    for (int k = 0; k <= lags.Count; ++k)
    {
      const double lag = k * lags.Spacing;
      EXPECT_NEAR(found.S(r, r)[k], found.Fractions[r] - 0.25 * surface * lag, 1e-8) << k;
    }
  }
  ruc::PackFigures figures;
  figures.Spheres = 30.0;
  figures.Observed = box;
  figures.MeanRadius = figures.LargestRadius = 0.9;
  figures.Types = figures.Modes = 2;
  EXPECT_LT(ruc::EstimatePairSum(figures, lags).MegabytesOfRank, 1.0);
  EXPECT_GT(ruc::EstimatePairSum(figures, { 1e-5, 277 }).MegabytesOfRank, 5.0); // in tables
}
