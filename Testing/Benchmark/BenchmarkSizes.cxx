// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * How much dearer the exact pair sum is for spheres of different sizes, as ratios of medians, which
 * depend little on the machine, and what they should not exceed: one large sphere among small ones;
 * radii from 1 to 1/30 with the same volume in every octave; a radius of its own for every sphere.
 */
#include "ruc/Base/Random.h"
#include "ruc/Statistics/PairSums/ExactPairSum.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numeric>

namespace
{
constexpr int Runs = 7;

double Seconds(const ruc::PackShare& share, const ruc::LagGrid& lags)
{
  ruc::Communicator serial;
  const auto begin = std::chrono::steady_clock::now();
  ruc::SumPairs(share, lags, serial);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

double Median(std::vector<double> values)
{
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

// The runs of the two packs take turns, so that both see the same neighbours on the machine
void Compare(const char* what, double most, const ruc::SpherePack& pack,
  const ruc::SpherePack& reference, const ruc::Window& box, const ruc::LagGrid& lags)
{
  const ruc::PackShare shares[2] = { ruc::SharePack(pack, box), ruc::SharePack(reference, box) };
  std::vector<double> seconds[2];
  for (int run = 0; run < Runs; ++run)
  {
    for (int n : { 0, 1 })
    {
      seconds[n].push_back(Seconds(shares[n], lags));
    }
  }
  std::printf("%-62s %5.2f, at most %g  (%.3f s, %.3f s)\n", what,
    Median(seconds[0]) / Median(seconds[1]), most, Median(seconds[0]), Median(seconds[1]));
}

ruc::Window PeriodicCube(double edge)
{
  return ruc::Window::MakeBox({ 0, 0, 0 }, { edge, edge, edge }, { true, true, true });
}

// Spheres of one mode at random; where they overlap makes no difference to the time
ruc::SpherePack RandomPack(int spheres, double edge, const std::function<double(int)>& radiusOf)
{
  ruc::SpherePack pack;
  for (int i = 0; i < spheres; ++i)
  {
    const auto u = ruc::UniformTriple(1, ruc::RandomStream::CellCentres, i);
    pack.X.push_back(edge * u[0]);
    pack.Y.push_back(edge * u[1]);
    pack.Z.push_back(edge * u[2]);
    pack.Radius.push_back(radiusOf(i));
    pack.Mode.push_back(1);
  }
  return pack;
}

// One sphere of radius 10 in the middle of some 22 500 of radius 0.1
void OneLargeSphere()
{
  constexpr double edge = 30.0;
  ruc::SpherePack small;
  const ruc::SpherePack all = RandomPack(27000, edge, [](int) { return 0.1; });
  for (std::size_t i = 0; i < all.Size(); ++i)
  {
    if (std::hypot(all.X[i] - 15.0, all.Y[i] - 15.0, all.Z[i] - 15.0) > 10.2)
    {
      small.Append(all, i);
    }
  }
  ruc::SpherePack pack = small;
  for (auto* centre : { &pack.X, &pack.Y, &pack.Z })
  {
    centre->push_back(15.0);
  }
  pack.Radius.push_back(10.0);
  pack.Mode.push_back(2);
  Compare(
    "one sphere of ratio 100 among small ones", 2.0, pack, small, PeriodicCube(edge), { 0.25, 20 });
}

// Five octaves of radius down to 1/30 with equal volumes, and as many spheres of one size with the
// same volume in all
void EqualVolumeAnOctave()
{
  constexpr int spheres = 20000, sizes = 6;
  std::vector<double> radii(sizes), shares(sizes);
  for (int n = 0; n < sizes; ++n)
  {
    radii[n] = std::pow(30.0, -n / (sizes - 1.0));
    shares[n] = std::pow(radii[n], -3.0);
  }
  std::partial_sum(shares.begin(), shares.end(), shares.begin());
  const auto radiusOf = [&](int i)
  {
    const double place = (i + 0.5) / spheres * shares.back();
    return radii[std::upper_bound(shares.begin(), shares.end(), place) - shares.begin()];
  };
  double cubes = 0.0;
  for (int i = 0; i < spheres; ++i)
  {
    cubes += std::pow(radiusOf(i), 3.0);
  }
  const double mean = std::cbrt(cubes / spheres);
  const double edge = std::cbrt(4.0 / 3.0 * ruc::Pi * cubes / 0.3); // volume fraction
  Compare("radii from 1 to 1/30, equal volume an octave, against one", 4.0,
    RandomPack(spheres, edge, radiusOf), RandomPack(spheres, edge, [&](int) { return mean; }),
    PeriodicCube(edge), { 4.0 * mean / 100, 100 });
}

// Radii spread over a factor of three, all different, against 256 of them
void ContinuousSizes()
{
  constexpr int spheres = 10245;
  constexpr double edge = 40.0;
  const auto radiusOf = [&](int i) { return 0.5 + i / (spheres - 1.0); };
  const auto roundedTo256 = [&](int i) { return 0.5 + i / ((spheres + 255) / 256) / 255.0; };
  Compare("10 245 distinct radii against 256", 2.0, RandomPack(spheres, edge, radiusOf),
    RandomPack(spheres, edge, roundedTo256), PeriodicCube(edge), { 0.05, 100 });
}
}

int main()
{
  OneLargeSphere();
  EqualVolumeAnOctave();
  ContinuousSizes();
}
