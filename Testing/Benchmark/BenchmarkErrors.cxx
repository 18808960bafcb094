// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The standard errors of exact pair sums: what they cost for the example pack, and how they compare
 * with the scatter of blocks that are cut from large packs of hard spheres of two sizes.
 *
 *     BenchmarkErrors [blocks along an edge of a pack, spheres in a block, packs, blocks for
 * errors]
 */
#include "ExamplePack.h"
#include "ruc/Packing/DensePack.h"
#include "ruc/Statistics/PairSums/ExactPairSum.h"
#include "ruc/Statistics/PairSums/PairSumErrors.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace
{
template <class Work>
double Seconds(Work&& work)
{
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void TimeExample()
{
  const ruc::SpherePack pack = ReadPack();
  const ruc::PackShare share = ruc::SharePack(pack, Block);
  const ruc::LagGrid lags = { 394.553 / 277, 277 };
  ruc::Communicator alone;
  ruc::TwoPointProbability sums(1, lags);
  ruc::TwoPointErrors errors;
  double plain = 1e9, more = 1e9;
  for (int n = 0; n < 5; ++n)
  {
    plain = std::min(plain, Seconds([&]() { sums = ruc::SumPairs(share, lags, alone); }));
    more =
      std::min(more, Seconds([&]() { errors = ruc::FindPairSumErrors(share, sums, 64, alone); }));
  }
  std::printf("example pack: sum %.3f s, errors by %d blocks %.3f s, together %.2f of the sum\n",
    plain, errors.Blocks, more, (plain + more) / plain);
  const int m = sums.Modes;
  std::printf("  c_m %.4f +- %.4f, objective floor %.4f\n", sums.Fractions[m], errors.Fractions[m],
    ruc::ObjectiveFloor(sums, errors));
  for (const ruc::LayerTest& test : errors.Layers)
  {
    std::printf("  along %s %.4f to %.4f: %.1f standard deviations\n", test.Axis.c_str(),
      test.First, test.Last, test.Deviate);
  }
  std::printf("  %s\n  %s\n", ruc::DescribeFailures(errors.Layers).c_str(),
    ruc::DescribeWalls(sums, errors).c_str());
}

ruc::SpherePack MakePack(int spheres, std::uint32_t seed, ruc::Window& box)
{
  ruc::DensePackSettings settings;
  settings.Radii.assign(spheres / 3, 1.0);
  settings.Radii.insert(settings.Radii.end(), spheres - spheres / 3, 0.7);
  settings.Fraction = 0.5;
  settings.Protocol = ruc::PackingProtocol::Events;
  settings.Equilibration = 60.0;
  settings.Seed = seed;
  ruc::DensePack made =
    ruc::MakeDensePack(settings, [](const ruc::GrowthStep&, double) { return true; });
  for (double radius : made.Pack.Radius)
  {
    made.Pack.Mode.push_back(radius == 1.0 ? 1 : 2);
  }
  box = made.Box;
  return made.Pack;
}

ruc::SpherePack Cut(const ruc::SpherePack& pack, const ruc::Window& window)
{
  ruc::SpherePack part;
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    if (window.Contains(pack.Centre(i)))
    {
      part.Append(pack, i);
    }
  }
  return part;
}

struct Measured
{
  ruc::TwoPointProbability Sums;
  ruc::TwoPointErrors Errors;
};

std::vector<Measured> MeasureBlocks(int edge, int spheres, int packs, int blocks)
{
  std::vector<Measured> measured;
  ruc::Communicator alone;
  for (int p = 0; p < packs; ++p)
  {
    ruc::Window box;
    const ruc::SpherePack pack = MakePack(spheres * edge * edge * edge, 1 + p, box);
    const double length = box.Size[0] / edge;
    for (int n = 0; n < edge * edge * edge; ++n)
    {
      const ruc::Vector3 at = { n % edge * length, n / edge % edge * length,
        n / edge / edge * length };
      const ruc::Window window =
        ruc::Window::MakeBox(at, { length, length, length }, { false, false, false });
      const ruc::PackShare share = ruc::SharePack(Cut(pack, window), window);
      const ruc::LagGrid lags = { 0.45 * length / 60, 60 };
      const ruc::TwoPointProbability sums = ruc::SumPairs(share, lags, alone);
      measured.push_back({ sums, ruc::FindPairSumErrors(share, sums, blocks, alone) });
    }
  }
  return measured;
}

void Compare(const std::vector<Measured>& measured)
{
  int tests = 0, failures = 0;
  for (const Measured& m : measured)
  {
    for (const ruc::LayerTest& test : m.Errors.Layers)
    {
      ++tests;
      failures += !test.Passed();
    }
  }
  std::printf("not one medium: %d of %d tests\n", failures, tests);

  const ruc::TwoPointProbability& first = measured.front().Sums;
  const double number = measured.size();
  std::printf(
    "%zu blocks, errors by %d\n pair  error/scatter  in 1  in 2   at lags 1/6, ... 1 of the last\n",
    measured.size(), measured.front().Errors.Blocks);
  double all = 0.0, in1 = 0.0, in2 = 0.0;
  for (int pair = 0; pair < first.Pairs(); ++pair)
  {
    double mean = 0.0, one = 0.0, two = 0.0;
    std::string row;
    const int count = first.Lags.Count;
    for (int k = 1; k <= count; ++k)
    {
      double sum = 0.0, squares = 0.0, variances = 0.0;
      for (const Measured& m : measured)
      {
        sum += m.Sums.Values[pair][k] / number;
        variances += m.Errors.Values[pair][k] * m.Errors.Values[pair][k] / number;
      }
      for (const Measured& m : measured)
      {
        const double off = m.Sums.Values[pair][k] - sum;
        squares += off * off / (number - 1);
        one += std::abs(off) < 1.0 * m.Errors.Values[pair][k];
        two += std::abs(off) < 1.96 * m.Errors.Values[pair][k];
      }
      const double ratio = std::sqrt(variances / squares);
      mean += ratio / count;
      if (k % (count / 6) == 0)
      {
        char text[16];
        std::snprintf(text, sizeof text, " %5.2f", ratio);
        row += text;
      }
    }
    one /= number * count;
    two /= number * count;
    std::printf("  %2d   %6.3f  %6.3f %6.3f  %s\n", pair, mean, one, two, row.c_str());
    all += mean / first.Pairs();
    in1 += one / first.Pairs();
    in2 += two / first.Pairs();
  }
  std::printf("  all  %6.3f  %6.3f %6.3f\n", all, in1, in2);
}
}

int main(int argc, char** argv)
{
  const auto argument = [&](int n, int value) { return argc > n ? std::atoi(argv[n]) : value; };
  TimeExample();
  Compare(MeasureBlocks(argument(1, 5), argument(2, 1500), argument(3, 2), argument(4, 64)));
}
