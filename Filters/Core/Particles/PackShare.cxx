// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Particles/PackShare.h"

#include "ruc/Base/FixedPoint.h"
#include "ruc/Base/Text.h"
#include "ruc/Particles/Regions.h"
#include "ruc/Particles/SphereOverlap.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ruc
{
namespace
{
// x, y, z, radius, mode
constexpr std::size_t NumbersPerSphere = 5;

void AppendNumbers(const SpherePack& pack, std::size_t i, std::vector<double>& numbers)
{
  numbers.insert(numbers.end(),
    { pack.X[i], pack.Y[i], pack.Z[i], pack.Radius[i], pack.Mode.empty() ? 0.0 : pack.Mode[i] });
}

// Every sphere to the rank whose region holds its centre
SpherePack ExchangeSpheres(SpherePack piece, std::int64_t total, Communicator& ranks)
{
  const RegionTree regions(piece, total, ranks);
  const bool withModes = !piece.Mode.empty();
  std::vector<std::vector<double>> outgoing(ranks.Size());
  for (std::size_t i = 0; i < piece.Size(); ++i)
  {
    AppendNumbers(piece, i, outgoing[regions.OwnerOf(piece.Centre(i))]);
  }
  std::int64_t modesGiven = withModes;
  ranks.Sum(&modesGiven, 1); // a rank without spheres cannot tell
  piece = {};
  SpherePack own;
  for (const std::vector<double>& numbers : ranks.AllToAll(std::move(outgoing)))
  {
    for (std::size_t n = 0; n < numbers.size(); n += NumbersPerSphere)
    {
      own.X.push_back(numbers[n]);
      own.Y.push_back(numbers[n + 1]);
      own.Z.push_back(numbers[n + 2]);
      own.Radius.push_back(numbers[n + 3]);
      if (modesGiven > 0)
      {
        own.Mode.push_back(static_cast<int>(numbers[n + 4]));
      }
    }
  }
  std::int64_t arrived = static_cast<std::int64_t>(own.Size());
  ranks.Sum(&arrived, 1);
  if (arrived != total)
  {
    throw std::runtime_error(
      Text("Sharing the pack out lost spheres: ", total, " were sent, ", arrived, " arrived."));
  }
  return own;
}

void FindTotals(PackShare& share, Communicator& ranks)
{
  const SpherePack& own = share.Own;
  double most[2] = { -own.LargestRadius(), -1.0 * std::max(own.NumberOfModes(), 1) };
  ranks.Minimum(most, 2);
  share.LargestRadius = -most[0];
  const std::size_t modes = static_cast<std::size_t>(-most[1]);
  // Sums of r^3 and r^2 in units of the largest, in fixed point: equal for any sharing
  constexpr double scale = 0x1p50;
  struct Mode
  {
    std::int64_t Count, Cubes[2], Squares[2];
  };
  constexpr std::size_t numbers = sizeof(Mode) / sizeof(std::int64_t);
  std::vector<Mode> sums(modes, Mode{});
  for (std::size_t i = 0; i < own.Size(); ++i)
  {
    Mode& mode = sums[own.Mode.empty() ? 0 : own.Mode[i] - 1];
    const double ratio = own.Radius[i] / share.LargestRadius;
    ++mode.Count;
    AddWide(RoundToFixedPoint(scale * ratio * ratio * ratio), mode.Cubes);
    AddWide(RoundToFixedPoint(scale * ratio * ratio), mode.Squares);
  }
  ranks.Sum(&sums.front().Count, numbers * modes);
  const double radius = share.LargestRadius;
  for (const Mode& mode : sums)
  {
    share.Count.push_back(mode.Count);
    share.Volume.push_back(SphereVolume(radius) * (WideValue(mode.Cubes) / scale));
    share.Surface.push_back(
      3.0 / radius * SphereVolume(radius) * (WideValue(mode.Squares) / scale));
  }
}
}

double PackTotals::MeanDiameter() const
{
  double volume = 0.0;
  for (double v : this->Volume)
  {
    volume += v;
  }
  return 2.0 * std::cbrt(volume / SphereVolume(1.0) / this->NumberOfSpheres);
}

PackShare SharePack(SpherePack piece, const Window& window, bool withModes, Communicator& ranks)
{
  PackShare share;
  share.Observed = window;
  share.NumberOfSpheres = static_cast<std::int64_t>(piece.Size());
  ranks.Sum(&share.NumberOfSpheres, 1);
  if (share.NumberOfSpheres == 0)
  {
    throw std::invalid_argument(NoSpheres);
  }
  ranks.ThrowIfAny(FindFaultySphere(piece, withModes, share.NumberOfSpheres));
  ranks.ThrowIfAny(FindNarrowEdge(piece, window));

  std::int64_t outside = 0;
  const std::string example = FindOutside(piece, window, outside);
  ranks.Sum(&outside, 1);
  ranks.ThrowIfAny(
    example.empty() ? example : OutsideMessage(window, outside, share.NumberOfSpheres, example));

  // Equal centres meet on one rank
  WrapIntoBox(piece, window);
  share.Own = std::move(piece);
  if (ranks.Size() > 1)
  {
    share.Own = ExchangeSpheres(std::move(share.Own), share.NumberOfSpheres, ranks);
  }
  SortCanonically(share.Own);
  ranks.ThrowIfAny(FindCoincidence(share.Own, window));
  FindTotals(share, ranks);
  if (withModes)
  {
    ranks.ThrowIfAny(FindModeGap(share.Count));
  }
  return share;
}

PackShare SharePack(SpherePack pack, const Window& window)
{
  Communicator serial;
  return SharePack(std::move(pack), window, true, serial);
}
}
