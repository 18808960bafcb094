// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Dense packs and the cells of dense packs: how long they take on one core, and how near the cells
 * come. Run it on a quiet machine with OMP_NUM_THREADS=1.
 */
#include "ruc/Packing/DensePack.h"
#include "ruc/Packing/SphereSizes.h"
#include "ruc/Particles/PackOverlap.h"
#include "ruc/Reconstruction/GradientSearch.h"
#include "ruc/Statistics/PairSums/ExactPairSum.h"

#include <chrono>
#include <cmath>
#include <cstdio>

namespace
{
class Clock
{
public:
  double Seconds() const
  {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - this->Start;
    return passed.count();
  }

private:
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
};

ruc::SphereSizes TwoSizes(double ratio, double share)
{
  ruc::SphereSizes sizes;
  if (ratio > 1.0)
  {
    sizes.Law = ruc::SizeLaw::Classes;
    sizes.Diameters = { 1.0, ratio };
    sizes.Shares = { 1.0 - share, share };
  }
  return sizes;
}

ruc::DensePack Make(const ruc::SphereSizes& sizes, int spheres, double fraction, std::uint32_t seed)
{
  ruc::DensePackSettings settings;
  const ruc::SphereSizes::Spheres made = sizes.Make(spheres);
  settings.Radii = made.Radius;
  settings.Fraction = fraction;
  settings.Seed = seed;
  settings.Protocol = ruc::PackingProtocol::Events;
  settings.Exchange = sizes.Law == ruc::SizeLaw::LogNormal;
  ruc::DensePack pack =
    ruc::MakeDensePack(settings, [](const ruc::GrowthStep&, double) { return true; });
  pack.Pack.Mode = made.Mode;
  return pack;
}

void PrintPack(const char* what, const ruc::SphereSizes& sizes, int spheres, double fraction)
{
  const Clock clock;
  const ruc::DensePack pack = Make(sizes, spheres, fraction, 1);
  const double seconds = clock.Seconds();
  std::printf(
    "%-34s %6.2f s; fraction %.4f of at most about %.3f, rate %g, overlapping pairs %lld\n", what,
    seconds, pack.Fraction, pack.MaximumFraction, pack.History.back().Rate,
    static_cast<long long>(ruc::MeasureOverlap(pack.Pack, pack.Box).Pairs));
}

// The target is a pack of 4000 spheres
void PrintCell(const char* what, const ruc::SphereSizes& sizes, double fraction,
  const ruc::LagGrid& lags, int spheres)
{
  const ruc::DensePack pack = Make(sizes, 4000, fraction, 7);
  const ruc::TwoPointProbability target = ruc::SumPairs(pack.Pack, pack.Box, lags);
  const ruc::CellContents contents =
    ruc::FindCellContents(ruc::SharePack(pack.Pack, pack.Box), spheres);
  ruc::Communicator alone;
  const Clock clock;
  double start = 0.0;
  const ruc::UnitCell cell = ruc::SearchByGradient(contents, target, {}, alone,
    [&](const ruc::SearchState& state)
    {
      start = state.Iteration <= 1 ? clock.Seconds() : start;
      return true;
    });
  const double seconds = clock.Seconds();
  std::printf("%-34s %6.2f s, of which %.2f s for the start; F2 %.5f, of the start %.5f, %d "
              "iterations, overlapping pairs %lld\n",
    what, seconds, start, cell.Objective, cell.StartObjective, cell.Iterations,
    static_cast<long long>(cell.Overlap.Pairs));
}
}

int main()
{
  ruc::SphereSizes logNormal;
  logNormal.Law = ruc::SizeLaw::LogNormal;
  // Whose logarithm has the standard deviation 0.6
  logNormal.StandardDeviation = std::sqrt(std::expm1(0.36));
  std::printf("Packs\n");
  PrintPack("1000 equal, 0.64", TwoSizes(1.0, 0.0), 1000, 0.64);
  PrintPack("1000 equal, 0.6449", TwoSizes(1.0, 0.0), 1000, 0.6449);
  PrintPack("10 000 equal, 0.64", TwoSizes(1.0, 0.0), 10000, 0.64);
  PrintPack("4000 of 5:1, 0.76", TwoSizes(5.0, 0.75), 4000, 0.76);
  PrintPack("10 000 of 10:1, 0.78", TwoSizes(10.0, 0.75), 10000, 0.78);
  PrintPack("1000 log-normal, 0.70", logNormal, 1000, 0.70);
  std::printf("Cells of 1000 spheres\n");
  PrintCell("equal, 0.6449, K = 140", TwoSizes(1.0, 0.0), 0.6449, { 0.03, 140 }, 1000);
  PrintCell("3:1, 0.70, K = 100", TwoSizes(3.0, 0.70), 0.70, { 0.035, 100 }, 1000);
  return 0;
}
