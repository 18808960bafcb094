// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Particles/PackShare.h"

#include "ruc/Base/FixedPoint.h"
#include "ruc/Base/Text.h"
#include "ruc/Particles/Regions.h"
#include "ruc/Particles/SphereOverlap.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace ruc
{
namespace
{
// Sends every sphere to the rank whose region holds its centre
SpherePack ExchangeSpheres(SpherePack piece, std::int64_t total, Communicator& ranks)
{
  const RegionTree regions(piece, total, ranks);
  std::vector<SpherePack> outgoing(ranks.Size());
  for (std::size_t i = 0; i < piece.Size(); ++i)
  {
    outgoing[regions.OwnerOf(piece.Centre(i))].Append(piece, i);
  }
  piece = {};
  SpherePack own;
  for (SpherePack& part : ranks.AllToAll(std::move(outgoing)))
  {
    own.Append(std::exchange(part, {}));
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

// Returns the radius in units of which those of every mode are summed: the largest of the pack; if
// a whole mode is so much smaller that too few digits of its cubes would be left, the largest of
// the mode
std::vector<double> FindUnits(const SpherePack& own, std::size_t modes, Communicator& ranks)
{
  constexpr double muchSmaller = 0x1p-10;
  std::vector<double> units(modes, 0.0);
  for (std::size_t i = 0; i < own.Size(); ++i)
  {
    double& unit = units[own.Mode.empty() ? 0 : own.Mode[i] - 1];
    unit = std::min(unit, -own.Radius[i]);
  }
  ranks.Minimum(units.data(), modes);
  const double largest = *std::min_element(units.begin(), units.end());
  for (double& unit : units)
  {
    unit = unit < 0.0 && unit > muchSmaller * largest ? -unit : -largest;
  }
  return units;
}

void FindTotals(PackShare& share, Communicator& ranks)
{
  const SpherePack& own = share.Own;
  double most[2] = { -own.LargestRadius(), -1.0 * std::max(own.NumberOfModes(), 1) };
  ranks.Minimum(most, 2);
  share.LargestRadius = -most[0];
  const std::size_t modes = static_cast<std::size_t>(-most[1]);
  const std::vector<double> units = FindUnits(own, modes, ranks);
  // Sums of r^3 and r^2 in these units, in fixed point, so that they are equal for any sharing
  constexpr double scale = 0x1p50;
  struct Mode
  {
    std::int64_t Count, Cubes[2], Squares[2];
  };
  constexpr std::size_t numbers = sizeof(Mode) / sizeof(std::int64_t);
  std::vector<Mode> sums(modes, Mode{});
  for (std::size_t i = 0; i < own.Size(); ++i)
  {
    const std::size_t number = own.Mode.empty() ? 0 : own.Mode[i] - 1;
    Mode& mode = sums[number];
    const double ratio = own.Radius[i] / units[number];
    ++mode.Count;
    AddWide(RoundToFixedPoint(scale * ratio * ratio * ratio), mode.Cubes);
    AddWide(RoundToFixedPoint(scale * ratio * ratio), mode.Squares);
  }
  ranks.Sum(&sums.front().Count, numbers * modes);
  for (std::size_t m = 0; m < modes; ++m)
  {
    const Mode& mode = sums[m];
    const double radius = units[m];
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

PackShare SharePack(CheckedPiece piece, Communicator& ranks)
{
  PackShare share;
  const Window& window = share.Observed = piece.Observed();
  share.NumberOfSpheres = piece.NumberOfSpheres();
  const bool withModes = piece.WithModes();
  share.Own = piece.Take();

  // After wrapping, equal centres lie in one region, and so on one rank
  share.Own.Id.clear();
  WrapIntoBox(share.Own, window);
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

PackShare SharePack(SpherePack piece, const Window& window, bool withModes, Communicator& ranks)
{
  return SharePack(CheckedPiece(std::move(piece), window, withModes, ranks), ranks);
}

PackShare SharePack(SpherePack pack, const Window& window)
{
  Communicator serial;
  return SharePack(std::move(pack), window, true, serial);
}

SpherePack GatherPack(CheckedPiece checked, Communicator& ranks)
{
  constexpr std::int64_t none = -1;
  SpherePack piece = checked.Take();
  if (piece.Id.empty())
  {
    piece.Id.assign(piece.Size(), none);
  }
  SpherePack pack;
  for (const SpherePack& part : ranks.AllGather(piece))
  {
    pack.Append(part);
  }
  SortCanonically(pack);
  if (std::find(pack.Id.begin(), pack.Id.end(), none) != pack.Id.end())
  {
    std::iota(pack.Id.begin(), pack.Id.end(), 0);
  }
  ValidatePack(pack, checked.WithModes());
  ValidateWindow(pack, checked.Observed());
  return pack;
}
}
