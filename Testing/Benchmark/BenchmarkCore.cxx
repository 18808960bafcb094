// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Times the loops that everything else waits for, on the example pack: the pair loop of the exact
 * sum (with its time for each pair); the objective of a cell of 1082 spheres and its gradient;
 * throws for three-point probabilities (with the time of a throw, and that of the plain template,
 * which counts the same and so has the same error); and the reading of a dump of 10^6 spheres (with
 * the most bytes for each sphere that it takes above the file). It runs on one thread unless
 * OMP_NUM_THREADS says otherwise.
 */
#include "ExamplePack.h"
#include "ruc/Base/Random.h"
#include "ruc/Formats/PackFormats.h"
#include "ruc/Particles/CellList.h"
#include "ruc/Reconstruction/CellObjective.h"
#include "ruc/Statistics/PairSums/ExactPairSum.h"
#include "ruc/Statistics/Sampling/FanSampling.h"
#include "ruc/Tracing/RayFan.h"
#include "ruc/Tracing/SphereGrid.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <string>

namespace
{
const ruc::LagGrid Lags = { 200.0 / 277, 277 };
// The number of pairs closer than the cut-off of the sum
double CountedPairs(const ruc::SpherePack& pack)
{
  const ruc::CellList cells(pack, Block, Lags.Maximum() + 2.0 * pack.LargestRadius());
  double pairs = 0.0;
  cells.ForEachPair(
    [&](std::size_t, std::size_t, double, double, double, double) { pairs += 1.0; });
  return pairs;
}

void PairLoop(benchmark::State& state)
{
  const ruc::SpherePack pack = ReadPack();
  const ruc::PackShare share = ruc::SharePack(pack, Block);
  ruc::Communicator serial;
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(ruc::SumPairs(share, Lags, serial));
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
    benchmark::DoNotOptimize(ruc::SumPairs(pack, Block, Lags));
  }
}
BENCHMARK(WholePairSum)->Unit(benchmark::kMillisecond);

void Objective(benchmark::State& state)
{
  const ruc::SpherePack pack = ReadPack();
  const ruc::TwoPointProbability target = ruc::SumPairs(pack, Block, Lags);
  const ruc::CellContents contents = ruc::FindCellContents(ruc::SharePack(pack, Block), 1082);
  ruc::Communicator serial;
  ruc::CellObjective objective(contents, target, serial);
  std::vector<double> centres;
  for (int i = 0; i < contents.NumberOfSpheres(); ++i)
  {
    for (double u : ruc::UniformTriple(1, ruc::RandomStream::CellCentres, i))
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

const ruc::ThreePointGrid Grid = { Lags, 20 };

// Looks up the phase of every point of a throw, then goes through all pairs of points on all pairs
// of rays; returns the seconds of a throw
double TimePlainTemplate(const ruc::SpherePack& pack, const ruc::SamplingRegion& region,
  const std::vector<ruc::PhaseTriple>& triples, int throws)
{
  const auto begin = std::chrono::steady_clock::now();
  const int modes = pack.NumberOfModes(), rays = Grid.Directions, points = Grid.Points();
  const ruc::SphereGrid spheres(pack, region.GetBounds());
  const ruc::RayDirections directions(rays);
  std::vector<int> phase(rays * points);
  std::vector<std::vector<std::int64_t>> counts(
    triples.size() + 1, std::vector<std::int64_t>(Grid.Size(), 0));
  for (int n = 0; n < throws; ++n)
  {
    const ruc::RayFan fan = ruc::RayFan::Random(region, 1, n);
    for (int ray = 0; ray < rays; ++ray)
    {
      const ruc::Vector3 along = directions.Of(fan, ray);
      for (int k = 0; k < points; ++k)
      {
        ruc::Vector3 point = fan.Centre;
        for (int q = 0; q < 3; ++q)
        {
          point[q] += k * Lags.Spacing * along[q];
        }
        phase[ray * points + k] =
          region.Contains(point) ? spheres.LowestModeAt(point, modes) : modes + 1;
      }
    }
    for (int first = 0; first < rays; ++first)
    {
      for (int second = 0; second < rays; ++second)
      {
        const int apart = std::abs(first - second);
        std::size_t place = Grid.PlaceOf(0, 0, std::min(apart, rays - apart));
        for (int k2 = 0; k2 < points; ++k2)
        {
          const int q = phase[second * points + k2];
          for (int k1 = 0; k1 < points; ++k1, ++place)
          {
            const int s = phase[first * points + k1];
            counts.back()[place] += s <= modes && q <= modes;
            for (std::size_t t = 0; t < triples.size(); ++t)
            {
              counts[t][place] +=
                phase[0] == triples[t].R && s == triples[t].S && q == triples[t].Q;
            }
          }
        }
      }
    }
  }
  benchmark::DoNotOptimize(counts);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  return seconds.count() / throws;
}

void Fans(benchmark::State& state)
{
  const ruc::SpherePack pack = ReadPack();
  const ruc::SamplingRegion region(Block, pack.LargestRadius());
  const std::vector<ruc::PhaseTriple> triples =
    ruc::ParseTriples("3 5 5; 7 7 5; m m m", pack.NumberOfModes());
  ruc::Communicator serial;
  ruc::FanSettings settings;
  settings.Throws = 50000;
  const auto begin = std::chrono::steady_clock::now();
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(
      ruc::SampleFans(pack, pack.NumberOfModes(), region, Grid, triples, settings, serial));
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  const double fan = seconds.count() / (static_cast<double>(state.iterations()) * settings.Throws);
  const double plain = TimePlainTemplate(pack, region, triples, 20);
  state.counters["s/throw"] = fan;
  state.counters["template_s/throw"] = plain;
  state.counters["times_cheaper"] = plain / fan;
}
BENCHMARK(Fans)->Unit(benchmark::kMillisecond);

constexpr int DumpRows = 1000000;

// id type radius x y z of six digits, ids in no order
std::string MakeDump()
{
  std::string dump = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n" + std::to_string(DumpRows) +
    "\nITEM: BOX BOUNDS pp pp pp\n0 100\n0 100\n0 100\nITEM: ATOMS id type radius x y z\n";
  char row[128];
  for (int n = 0; n < DumpRows; ++n)
  {
    const auto u = ruc::UniformTriple(1, ruc::RandomStream::CellCentres, n);
    const long long id = 1 + 7919ll * n % DumpRows;
    std::snprintf(row, sizeof row, "%lld %d 0.25 %.6f %.6f %.6f\n", id, 1 + n % 3, 100 * u[0],
      100 * u[1], 100 * u[2]);
    dump += row;
  }
  return dump;
}

// VmHWM or VmRSS of this process, in bytes
double MemoryOf(const std::string& key)
{
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
  {
    double kilobytes;
    if (word == key && status >> kilobytes)
    {
      return 1024 * kilobytes;
    }
  }
  return 0.0;
}

void ReadDump(benchmark::State& state)
{
  const std::string dump = MakeDump();
  const ruc::PackFormat* format = nullptr;
  std::ofstream("/proc/self/clear_refs") << "5"; // the peak begins anew
  const double before = MemoryOf("VmRSS:");
  for (auto _ : state)
  {
    ruc::MemoryBytes bytes(dump);
    format = ruc::FindFormat(bytes);
    const auto frames = format->Scan(bytes);
    benchmark::DoNotOptimize(
      ruc::MakePack(ruc::ReadFrame(*format, bytes, frames, 0, {}), {}).Pack.X.data());
  }
  state.counters["bytes/sphere"] = (MemoryOf("VmHWM:") - before) / DumpRows;
}
BENCHMARK(ReadDump)->Unit(benchmark::kMillisecond);
}

BENCHMARK_MAIN();
