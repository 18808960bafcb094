// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Times the loops that everything else waits for, on the example pack: the pair loop of the exact
 * sum (with its time a pair), the objective of a cell of 1082 spheres and its gradient. One thread
 * unless OMP_NUM_THREADS says otherwise.
 */
#include "Geometry/CellList.h"
#include "Geometry/SpherePackText.h"
#include "Random.h"
#include "Reconstruction/CellObjective.h"
#include "Statistics/ParticleModes.h"
#include "Statistics/TwoPointProbability.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace
{
const ruc::LagGrid Lags = { 200.0 / 277, 277 };
const ruc::Window Block =
  ruc::Window::MakeBox({ 0, 0, 0 }, { 1445.372, 1287.892, 789.106 }, { false, false, false });

ruc::SpherePack ReadPack()
{
  std::ifstream file(RUC_EXAMPLE_DATA "/bead_block.csv");
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  ruc::SpherePack pack = ruc::ParseSpherePack(text, {}).Pack;
  std::vector<double> diameters;
  for (double radius : pack.Radius)
  {
    diameters.push_back(2.0 * radius);
  }
  const ruc::ParticleModes modes(diameters, {});
  for (double d : diameters)
  {
    pack.Mode.push_back(modes.ModeOf(d));
  }
  ruc::SortCanonically(pack);
  return pack;
}

ruc::TwoPointProbability PairSum(const ruc::ExactPairSum& sum)
{
  std::vector<std::int64_t> sums(sum.SumsSize(), 0);
  sum.AddChunks(0, 1, sums.data());
  return sum.Result(sums);
}

// Pairs closer than the cut-off of the sum
double CountedPairs(const ruc::SpherePack& pack)
{
  const ruc::CellList cells(pack, Block, Lags.Maximum() + 2.0 * pack.LargestRadius());
  std::vector<ruc::CellList::Range> ranges;
  double pairs = 0.0;
  for (std::size_t i = 0; i < cells.Size(); ++i)
  {
    cells.FindRanges(i, ranges);
    for (const auto& range : ranges)
    {
      for (std::size_t j = range.Begin; j < range.End; ++j)
      {
        const double dx = cells.X[j] - range.X, dy = cells.Y[j] - range.Y,
                     dz = cells.Z[j] - range.Z;
        pairs += dx * dx + dy * dy + dz * dz < cells.GetCutoff() * cells.GetCutoff();
      }
    }
  }
  return pairs;
}

void PairLoop(benchmark::State& state)
{
  const ruc::SpherePack pack = ReadPack();
  const ruc::ExactPairSum sum(pack, Block, Lags);
  std::vector<std::int64_t> sums(sum.SumsSize(), 0);
  for (auto _ : state)
  {
    sum.AddChunks(0, 1, sums.data());
  }
  const double pairs = CountedPairs(pack);
  state.counters["pairs"] = pairs;
  state.counters["s/pair"] = benchmark::Counter(
    pairs, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(PairLoop)->Unit(benchmark::kMillisecond);

void WholePairSum(benchmark::State& state)
{
  const ruc::SpherePack pack = ReadPack();
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(PairSum(ruc::ExactPairSum(pack, Block, Lags)));
  }
}
BENCHMARK(WholePairSum)->Unit(benchmark::kMillisecond);

void Objective(benchmark::State& state)
{
  const ruc::SpherePack pack = ReadPack();
  const ruc::TwoPointProbability target = PairSum(ruc::ExactPairSum(pack, Block, Lags));
  const ruc::CellContents contents = ruc::FindCellContents(ruc::SharePack(pack, Block), 1082);
  ruc::Communicator serial;
  ruc::CellObjective objective(contents, target, serial);
  std::vector<double> centres;
  for (int i = 0; i < contents.NumberOfSpheres(); ++i)
  {
    for (double u : ruc::UniformTriple(1, 0, i))
    {
      centres.push_back(u * contents.Edge);
    }
  }
  std::vector<double> gradient(centres.size());
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(
      objective.Evaluate(centres.data(), state.range(0) ? gradient.data() : nullptr));
  }
}
BENCHMARK(Objective)->ArgName("gradient")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
}

BENCHMARK_MAIN();
