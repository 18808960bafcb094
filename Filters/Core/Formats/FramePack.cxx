// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Formats/FramePack.h"

#include "ruc/Base/Require.h"
#include "ruc/Formats/Fields.h"
#include "ruc/Formats/TiltedCell.h"
#include "ruc/Particles/PeriodicReplicas.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <numeric>
#include <stdexcept>

namespace ruc
{
namespace
{
// "1=0.3; 2=0.42", also with commas or blanks between
std::map<std::string, double, std::less<>> ParseRadiusByType(const std::string& given)
{
  std::string text = given;
  std::replace_if(
    text.begin(), text.end(), [](char c) { return c == ';' || c == ','; }, ' ');
  Fields entries;
  SplitBlanks(text, entries);
  std::map<std::string, double, std::less<>> radii;
  for (std::string_view entry : entries)
  {
    const std::size_t sign = std::min(entry.find('='), entry.size());
    double radius = 0.0;
    Require(sign > 0 && sign + 1 < entry.size() && ParseNumber(entry.substr(sign + 1), radius) &&
        radius > 0.0 && std::isfinite(radius),
      "RadiusByType", "types and radii > 0, such as 1=0.3; 2=0.42", Quote(entry));
    const bool first = radii.emplace(entry.substr(0, sign), radius).second;
    Require(first, "RadiusByType", "one radius of each type", Quote(entry));
  }
  return radii;
}

void ScaleLengths(PackFrame& frame, double scale)
{
  Require(std::isfinite(scale) && scale > 0.0, "Scale", "a finite number > 0", scale);
  for (std::size_t i = 0; i < frame.Size(); ++i)
  {
    const double radius = frame.Radius.empty() ? 0.0 : frame.Radius[i];
    for (double value : { frame.X[i], frame.Y[i], frame.Z[i], radius })
    {
      if (!(std::abs(scale * value) <= GreatestLength) ||
        (radius > 0.0 && scale * radius < LeastLength))
      {
        throw std::invalid_argument(Text("Row ", i + 1, ": coordinates of at most ", GreatestLength,
          " and radii of 0 or from ", LeastLength, " are required, got ", value, " and radius ",
          radius, " times Scale, ", scale, "."));
      }
    }
  }
  if (scale == 1.0)
  {
    return;
  }
  for (std::vector<double>* values : { &frame.X, &frame.Y, &frame.Z, &frame.Radius })
  {
    for (double& value : *values)
    {
      value *= scale;
    }
  }
  if (frame.Box)
  {
    for (Vector3* lengths : { &frame.Box->Origin, &frame.Box->Edges, &frame.Box->Tilts })
    {
      *lengths = { scale * (*lengths)[0], scale * (*lengths)[1], scale * (*lengths)[2] };
    }
  }
}

void SetRadii(PackFrame& frame, const PackSettings& settings)
{
  std::vector<double> radii =
    MakeRadii(frame.Radius.empty() ? frame.Size() : 0, frame.Type, frame.TypeNames, settings);
  if (frame.Radius.empty())
  {
    frame.Radius = std::move(radii);
    if (frame.Type.empty() && !settings.RadiusByType.empty())
    {
      frame.Warnings.push_back("RadiusByType is not used, since the file tells no types.");
    }
  }
  else if (settings.UniformRadius > 0.0 || !settings.RadiusByType.empty())
  {
    frame.Warnings.push_back(
      "UniformRadius and RadiusByType are not used, since the file tells radii.");
  }
}

template <class T>
void Keep(std::vector<T>& values, const std::vector<std::size_t>& order)
{
  if (values.empty())
  {
    return;
  }
  std::vector<T> kept;
  kept.reserve(order.size());
  for (std::size_t i : order)
  {
    kept.push_back(values[i]);
  }
  values = std::move(kept);
}

void Keep(PackFrame& frame, const std::vector<std::size_t>& order)
{
  for (std::vector<double>* values : { &frame.X, &frame.Y, &frame.Z, &frame.Radius })
  {
    Keep(*values, order);
  }
  Keep(frame.Id, order);
  Keep(frame.Type, order);
  Keep(frame.Mode, order);
}

// Whether the search for copies is due: a centre is beyond a face of an axis that is periodic, and
// none is so far away that it is refused, nor is a sphere as wide as the box
bool MayHaveGhosts(const PackFrame& frame, const Window& box)
{
  const double largest = *std::max_element(frame.Radius.begin(), frame.Radius.end());
  bool outside = false, near = FindNarrowEdge(largest, box).empty();
  for (std::size_t i = 0; i < frame.Size() && near; ++i)
  {
    const Vector3 centre = { frame.X[i], frame.Y[i], frame.Z[i] };
    for (int q = 0; q < 3; ++q)
    {
      const double edges = (centre[q] - box.Origin[q]) / box.Size[q];
      near = near && std::abs(edges) <= 1e9;
      outside = outside || (box.Periodic[q] && !(edges >= 0.0 && edges < 1.0));
    }
  }
  return outside && near;
}

// Copies beyond the faces of a periodic box, which some programs write along
std::size_t LeaveOutGhosts(PackFrame& frame, const Window& box)
{
  SpherePack pack;
  pack.X = frame.X;
  pack.Y = frame.Y;
  pack.Z = frame.Z;
  pack.Radius = frame.Radius;
  const std::vector<bool> copies = FindPeriodicCopies(pack, box);
  std::vector<std::size_t> originals;
  for (std::size_t i = 0; i < frame.Size(); ++i)
  {
    if (!copies[i])
    {
      originals.push_back(i);
    }
  }
  const std::size_t ghosts = frame.Size() - originals.size();
  if (ghosts > 0)
  {
    Keep(frame, originals);
  }
  return ghosts;
}

void SortById(PackFrame& frame)
{
  std::vector<std::int64_t>& ids = frame.Id;
  if (ids.empty())
  {
    ids.resize(frame.Size());
    std::iota(ids.begin(), ids.end(), std::int64_t(0));
    return;
  }
  std::vector<std::size_t> order(ids.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b) { return std::tie(ids[a], a) < std::tie(ids[b], b); });
  for (std::size_t n = 1; n < order.size(); ++n)
  {
    if (ids[order[n]] == ids[order[n - 1]])
    {
      throw std::invalid_argument(Text(
        "Id ", ids[order[n]], " stands in rows ", order[n - 1] + 1, " and ", order[n] + 1, "."));
    }
  }
  if (!std::is_sorted(order.begin(), order.end()))
  {
    Keep(frame, order);
  }
}

std::uint64_t HashOf(const Vector3& centre)
{
  std::uint64_t hash = 0;
  for (double x : centre)
  {
    x += 0.0; // one zero
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    hash = (hash ^ bits) * 0x9E3779B97F4A7C15u;
    hash ^= hash >> 32;
  }
  return hash;
}

void CheckCentres(const SpherePack& pack)
{
  std::vector<std::uint64_t> hashes(pack.Size());
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    hashes[i] = HashOf(pack.Centre(i));
  }
  std::sort(hashes.begin(), hashes.end());
  const auto twice = std::adjacent_find(hashes.begin(), hashes.end());
  if (twice == hashes.end())
  {
    return;
  }
  std::map<Vector3, std::size_t> seen; // of all centres: this is the way to a refusal
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    const auto [other, first] = seen.emplace(pack.Centre(i), i);
    if (!first)
    {
      throw std::invalid_argument(Text("Spheres ", pack.Id[other->second], " and ", pack.Id[i],
        " have one centre, (", pack.X[i], ", ", pack.Y[i], ", ", pack.Z[i], ")."));
    }
  }
}

// The row is told before spheres are sorted
void CheckContainer(const PackFrame& frame)
{
  const std::size_t n = frame.Size();
  const auto largest = static_cast<std::size_t>(
    std::max_element(frame.Radius.begin(), frame.Radius.end()) - frame.Radius.begin());
  std::size_t held = 0;
  for (std::size_t i = 0; i < n; ++i)
  {
    const Vector3 d = { frame.X[i] - frame.X[largest], frame.Y[i] - frame.Y[largest],
      frame.Z[i] - frame.Z[largest] };
    held += i != largest && Length(d) < frame.Radius[largest];
  }
  if (n > 3 && static_cast<double>(held) > 0.9 * static_cast<double>(n - 1))
  {
    throw std::invalid_argument(Text("Row ", largest + 1, " holds ",
      held == n - 1 ? Text("all") : Text(held), " others: a container? Take it out."));
  }
}

std::optional<Window> PlaceInBox(PackFrame& frame, FramePack& result, const PackSettings& settings)
{
  if (!frame.Box)
  {
    if (settings.Periodic)
    {
      frame.Warnings.push_back(
        "BoxPeriodic is not used, since neither BoxSize nor the file tells a box.");
    }
    return std::nullopt;
  }
  FrameBox box = *frame.Box;
  if (settings.Periodic)
  {
    box.Periodic = *settings.Periodic;
    box.PeriodicityKnown = true;
  }
  const std::array<bool, 3>& periodic = box.Periodic;
  result.BoxIsWindow = periodic[0] && periodic[1] && periodic[2];
  // A lattice of the brick takes the edges that its tilts lean along
  const auto [xy, xz, yz] = box.Tilts;
  if (((xy != 0.0 || xz != 0.0) && !periodic[0]) || (yz != 0.0 && !periodic[1]))
  {
    frame.Warnings.push_back("The tilted box is left out: it is not periodic along its tilt.");
    return std::nullopt;
  }
  Window brick = BrickOf(box);
  if (!box.IsTilted())
  {
    result.Ghosts = MayHaveGhosts(frame, brick) ? LeaveOutGhosts(frame, brick) : 0;
  }
  else if (brick.Periodic != periodic)
  {
    frame.Warnings.push_back(Text("The tilted cell is taken as the brick of its edges: the spheres "
                                  "are the same, but along ",
      brick.Periodic[1]     ? "z"
        : brick.Periodic[2] ? "y"
                            : "y and z",
      " its faces cut the pack."));
  }
  result.Wrapped = WrapIntoBrick(frame, box);
  return brick;
}

// Moves the centres into the window that was given, where those of the pack are
void MoveIntoWindow(FramePack& result, const Window& window)
{
  SpherePack& pack = result.Pack;
  result.Wrapped = static_cast<std::size_t>(MoveIntoBox(pack, window));
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    if (!window.Contains(pack.Centre(i)))
    {
      throw std::invalid_argument(
        Text("BoxOrigin and BoxSize require every centre inside the box, got that of sphere ",
          pack.Id[i], " at (", pack.X[i], ", ", pack.Y[i], ", ", pack.Z[i], "), outside the ",
          window.Describe(), ". Particle Modes cuts a part out of a pack: set them there."));
    }
  }
  if (result.Wrapped > 0)
  {
    result.Warnings.push_back(Text(result.Wrapped, " of ", pack.Size(), " centres lay outside the ",
      window.Describe(), " and were moved into it by whole edges."));
  }
}
}

std::vector<double> MakeRadii(std::size_t count, const std::vector<int>& types,
  const std::vector<std::string>& names, const PackSettings& settings)
{
  Require(settings.UniformRadius >= 0.0 && std::isfinite(settings.UniformRadius), "UniformRadius",
    "a finite number >= 0", settings.UniformRadius);
  const auto byType = ParseRadiusByType(settings.RadiusByType);
  if (count == 0)
  {
    return {};
  }
  if (byType.empty() || types.empty())
  {
    Require(settings.UniformRadius > 0.0, "The pack",
      "radii: a column 'radius' or 'diameter', RadiusColumn, UniformRadius, or RadiusByType such "
      "as 1=0.3; 2=0.42",
      types.empty() ? "neither radii nor types" : "no radii");
    return std::vector<double>(count, settings.UniformRadius);
  }
  std::map<int, double> radii;
  for (int type : types)
  {
    if (radii.find(type) == radii.end())
    {
      const std::string name =
        names.empty() ? std::to_string(type) : names.at(static_cast<std::size_t>(type - 1));
      const auto given = byType.find(name);
      Require(given != byType.end() || settings.UniformRadius > 0.0, "RadiusByType",
        Text("a radius of type ", name, ", or UniformRadius"), Quote(settings.RadiusByType));
      radii[type] = given != byType.end() ? given->second : settings.UniformRadius;
    }
  }
  std::vector<double> ofSpheres;
  ofSpheres.reserve(count);
  for (int type : types)
  {
    ofSpheres.push_back(radii.at(type));
  }
  return ofSpheres;
}

FramePack MakePack(PackFrame frame, const PackSettings& settings)
{
  FramePack result;
  ScaleLengths(frame, settings.Scale);
  SetRadii(frame, settings);
  CheckContainer(frame);
  if (settings.Observed)
  {
    result.Box = settings.Observed;
    result.BoxIsWindow = true;
    result.Ghosts = LeaveOutGhosts(frame, *result.Box);
  }
  else
  {
    result.Box = PlaceInBox(frame, result, settings);
  }
  SortById(frame);
  result.Pack.X = std::move(frame.X);
  result.Pack.Y = std::move(frame.Y);
  result.Pack.Z = std::move(frame.Z);
  result.Pack.Radius = std::move(frame.Radius);
  result.Pack.Id = std::move(frame.Id);
  result.Pack.Mode = std::move(frame.Mode);
  result.Warnings = std::move(frame.Warnings);
  if (result.Ghosts > 0)
  {
    result.Warnings.push_back(
      Text(result.Ghosts, " rows that repeat a sphere beyond the periodic box are left out."));
  }
  if (settings.Observed)
  {
    MoveIntoWindow(result, *settings.Observed);
  }
  CheckCentres(result.Pack);
  result.Type = std::move(frame.Type);
  result.TypeNames = std::move(frame.TypeNames);
  result.LengthUnit = std::move(frame.LengthUnit);
  result.Time = frame.Time ? frame.Time
    : frame.Step           ? std::optional<double>(static_cast<double>(*frame.Step))
                           : std::nullopt;
  result.Format = std::move(frame.Format);
  return result;
}
}
