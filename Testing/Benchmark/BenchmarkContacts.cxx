// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Neighbours and voids of the example pack, and neighbours of that pack 8 and 64 times,
 * side by side: what they are, and the seconds of the processor.
 * Run it with OMP_NUM_THREADS=1; other work on the machine does not count.
 */
#include "ExamplePack.h"
#include "ruc/Particles/PackShare.h"
#include "ruc/Statistics/Neighbours/NeighbourStatistics.h"
#include "ruc/Statistics/Neighbours/VoidDistances.h"

#include <cstdio>
#include <ctime>

namespace
{
double ProcessorSeconds()
{
  timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return now.tv_sec + 1e-9 * now.tv_nsec;
}

void PrintNeighbours(const char* what, const ruc::PackShare& share)
{
  ruc::Communicator serial;
  const ruc::NeighbourSettings settings;
  const double margin = ruc::NeighbourMargin(share.LargestRadius, settings.MaximumGap);
  const ruc::SamplingRegion region(share.Observed, margin);
  const double begin = ProcessorSeconds();
  const ruc::NeighbourStatistics found =
    ruc::MeasureNeighbours(share, { region, margin, false }, settings, serial);
  const double seconds = ProcessorSeconds() - begin;
  const ruc::NeighbourStatistics::Means& all = found.OfModes.back();
  std::printf("%-30s %8.3f s; %8lld spheres count, contacts %.4f +- %.4f, Q6 %.4f +- %.4f\n", what,
    seconds, static_cast<long long>(found.Counted), all.Contacts.Value, all.Contacts.Error,
    all.Q6.Value, all.Q6.Error);
}

void PrintVoids(const ruc::PackShare& share)
{
  ruc::Communicator serial;
  const ruc::VoidSettings settings = ruc::WithMaximumDistance({}, share);
  const ruc::SamplingRegion region(share.Observed, share.LargestRadius + settings.MaximumDistance);
  const double begin = ProcessorSeconds();
  const ruc::VoidDistances found = ruc::MeasureVoids(share, region, settings, serial);
  const double seconds = ProcessorSeconds() - begin;
  std::printf("%-30s %8.3f s; %8lld points, mean %.4f +- %.4f, critical radius %.2f +- %.2f\n",
    "  voids", seconds, static_cast<long long>(found.Points), found.Mean.Value, found.Mean.Error,
    found.CriticalRadius[2].Value, found.CriticalRadius[2].Error);
}

// The pack side by side, which overlaps a little where blocks meet
ruc::PackShare Tile(const ruc::SpherePack& pack, int tiles)
{
  ruc::SpherePack all;
  for (int n = 0; n < tiles * tiles * tiles; ++n)
  {
    const std::size_t first = all.Size();
    all.Append(pack);
    for (std::size_t i = first; i < all.Size(); ++i)
    {
      all.X[i] += Block.Size[0] * (n % tiles);
      all.Y[i] += Block.Size[1] * (n / tiles % tiles);
      all.Z[i] += Block.Size[2] * (n / tiles / tiles);
    }
  }
  return ruc::SharePack(all,
    ruc::Window::MakeBox(
      { 0, 0, 0 }, { tiles * Block.Size[0], tiles * Block.Size[1], tiles * Block.Size[2] }, {}));
}
}

int main()
{
  const ruc::SpherePack pack = ReadPack();
  PrintNeighbours("example pack", Tile(pack, 1));
  PrintVoids(Tile(pack, 1));
  PrintNeighbours("8 times", Tile(pack, 2));
  PrintNeighbours("64 times, 1 500 608 spheres", Tile(pack, 4));
  return 0;
}
