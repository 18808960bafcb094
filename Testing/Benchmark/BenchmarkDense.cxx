// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Dense packs and the cells of dense packs: the seconds of one core that they take, with the
 * estimate over them, and how near the cells come. Run it with OMP_NUM_THREADS=1.
 */
#include "ruc/Packing/DensePack.h"
#include "ruc/Packing/SphereSizes.h"
#include "ruc/Particles/PackOverlap.h"
#include "ruc/Reconstruction/GradientSearch.h"
#include "ruc/Statistics/PairSums/ExactPairSum.h"

#include <sys/resource.h>

#include <cmath>
#include <cstdio>

namespace
{
// Seconds of the processor, which other work on the machine does not change much
class Clock
{
public:
  double Seconds() const { return Now() - this->Start; }

private:
  static double Now()
  {
    rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * usage.ru_utime.tv_usec;
  }

  double Start = Now();
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

ruc::DensePackSettings SettingsOf(
  const ruc::SphereSizes& sizes, int spheres, double fraction, std::uint32_t seed)
{
  ruc::DensePackSettings settings;
  settings.Radii = sizes.Make(spheres).Radius;
  settings.Fraction = fraction;
  settings.Seed = seed;
  settings.Protocol = ruc::PackingProtocol::Events;
  settings.Exchange = sizes.Law == ruc::SizeLaw::LogNormal;
  return settings;
}

ruc::DensePack Make(const ruc::DensePackSettings& settings)
{
  return ruc::MakeDensePack(settings, [](const ruc::GrowthStep&, double) { return true; });
}

void PrintPack(const char* what, const ruc::SphereSizes& sizes, int spheres, double fraction)
{
  const ruc::DensePackSettings settings = SettingsOf(sizes, spheres, fraction, 1);
  const Clock clock;
  const ruc::DensePack pack = Make(settings);
  const double seconds = clock.Seconds();
  std::printf(
    "%-34s %6.2f s; fraction %.4f of at most about %.3f, rate %g, overlapping pairs %lld; "
    "estimated over measured %.1f\n",
    what, seconds, pack.Fraction, pack.MaximumFraction, pack.History.back().Rate,
    static_cast<long long>(ruc::MeasureOverlap(pack.Pack, pack.Box).Pairs),
    ruc::EstimateDensePack(settings, spheres).Seconds / seconds);
}

// The target is a pack of 4000 spheres. The search ends at the F2 that is wanted, or at its own end
// where that is 0.
void PrintCell(const char* what, const ruc::SphereSizes& sizes, double fraction,
  const ruc::LagGrid& lags, int spheres, double wanted)
{
  ruc::DensePack pack = Make(SettingsOf(sizes, 4000, fraction, 7));
  pack.Pack.Mode = sizes.Make(4000).Mode;
  const ruc::TwoPointProbability target = ruc::SumPairs(pack.Pack, pack.Box, lags);
  const ruc::CellContents contents =
    ruc::FindCellContents(ruc::SharePack(pack.Pack, pack.Box), spheres);
  ruc::Communicator alone;
  ruc::GradientSearchSettings settings;
  settings.TargetObjective = wanted;
  const Clock clock;
  double start = 0.0, last = 0.0; // F2 before the finish
  const ruc::UnitCell cell = ruc::SearchByGradient(contents, target, settings, alone,
    [&](const ruc::SearchState& state)
    {
      start = state.Iteration <= 1 ? clock.Seconds() : start;
      last = state.Phase == ruc::SearchPhase::MinimisingObjective ? state.Objective : last;
      return true;
    });
  const double seconds = clock.Seconds();
  std::printf("%-34s %6.2f s, of which %.2f s for the start; F2 %.5f, over that before the "
              "finish %.4f, of the start %.5f, %d iterations, overlapping pairs %lld\n",
    what, seconds, start, cell.Objective, cell.Objective / last, cell.StartObjective,
    cell.Iterations, static_cast<long long>(cell.Overlap.Pairs));
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
  PrintCell("equal, 0.6449, to F2 0.0025", TwoSizes(1.0, 0.0), 0.6449, { 0.03, 140 }, 1000, 0.0025);
  PrintCell("equal, 0.6449, K = 140", TwoSizes(1.0, 0.0), 0.6449, { 0.03, 140 }, 1000, 0.0);
  PrintCell("3:1, 0.70, to F2 0.024", TwoSizes(3.0, 0.70), 0.70, { 0.035, 100 }, 1000, 0.024);
  PrintCell("3:1, 0.70, K = 100", TwoSizes(3.0, 0.70), 0.70, { 0.035, 100 }, 1000, 0.0);
  return 0;
}
