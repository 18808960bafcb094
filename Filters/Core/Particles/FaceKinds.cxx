// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Particles/FaceKinds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace ruc
{
namespace
{
// The thresholds were set on packs of known faces; Testing/Benchmark counts how often they are
// right
constexpr double WallCovered = 0.25;   // of the face
constexpr double WallOverMiddle = 4.0; // times what a layer in the middle covers
constexpr std::int64_t WallSpheres = 15;
constexpr double LargestError = 0.2; // of the volume in a layer, else the face is unknown
constexpr double LooseLoss = 0.1;    // of the volume in the outermost layer
constexpr double LooseErrors = 3.0;  // standard errors
// The denser they lie the less spheres scatter than independent ones; in a settled pack half as
// much
constexpr double LeastScatter = 0.5;
constexpr double LogLikelihood = 4.0; // by which another end is more likely
constexpr double BandWidth = 0.12;    // mean radii: how far spheres at a wall may lie from it
constexpr int StepsOfBand = 8;

constexpr int Directions = 64;
constexpr int Fits = 6;

// How much of a surface the spheres cover that lie at nearly one depth below it. Depths are those
// of the points of the spheres that are next to the surface.
class Bands
{
public:
  explicit Bands(const PackBounds& bounds)
    : Step(BandWidth * std::max(bounds.VolumeMean, 0.01) * bounds.LargestRadius / StepsOfBand)
    , Count(static_cast<std::size_t>(bounds.LargestRadius / this->Step) + StepsOfBand)
    , LargestRadius(bounds.LargestRadius)
  {
  }
  std::size_t Size() const { return 2 * this->Count; }
  double Width() const { return StepsOfBand * this->Step; }
  void Add(double depth, double radius, std::int64_t* sums) const
  {
    if (depth >= 0.0 && depth < this->Step * static_cast<double>(this->Count))
    {
      const auto n = std::min(static_cast<std::size_t>(depth / this->Step), this->Count - 1);
      const double share = radius / this->LargestRadius;
      sums[n] += FixedShare(share * share);
      ++sums[this->Count + n];
    }
  }

  struct Layer
  {
    std::int64_t Discs = 0; // FixedShare of the squares of their radii
    std::int64_t Spheres = 0;
  };
  // The band that begins within a radius of the surface and covers most
  Layer FindFullest(const std::int64_t* sums) const
  {
    Layer fullest;
    for (std::size_t n = 0; n + StepsOfBand <= this->Count; ++n)
    {
      Layer layer;
      for (std::size_t k = n; k < n + StepsOfBand; ++k)
      {
        layer.Discs += sums[k];
        layer.Spheres += sums[this->Count + k];
      }
      fullest = layer.Discs > fullest.Discs ? layer : fullest;
    }
    return fullest;
  }

private:
  double Step;
  std::size_t Count;
  double LargestRadius;
};

double ShareOf(std::int64_t fixed)
{
  return static_cast<double>(fixed) / (1 << 30);
}

double AreaOf(std::int64_t discs, const PackBounds& bounds)
{
  return Pi * ShareOf(discs) * bounds.LargestRadius * bounds.LargestRadius;
}

double DistanceFromAxis(const Vector3& centre, const Mantle& mantle)
{
  const int a = (mantle.Axis + 1) % 3, b = (mantle.Axis + 2) % 3;
  return std::hypot(centre[a] - mantle.Centre[a], centre[b] - mantle.Centre[b]);
}

// One face and its core, the spheres away from the other faces. Heights grow outwards.
class Face
{
public:
  Face(const PackBounds& bounds, const std::optional<Mantle>& mantle, int face)
    : Bounds(bounds)
    , Around(mantle)
    , Axis(face / 2)
    , Outwards(face % 2 == 1 ? 1.0 : -1.0)
    , Layers(bounds)
  {
    const double part = bounds.Extent(this->Axis) / 4.0;
    const double top = face % 2 == 1 ? bounds.Greatest[this->Axis] : -bounds.Least[this->Axis];
    this->MiddleTop = top - part;
    this->MiddleBottom = top - 3.0 * part;
  }

  // The area of the core, or <= 0 if there is none
  double Area() const
  {
    const double away = this->Bounds.LargestDiameter();
    if (this->Around)
    {
      const double radius = this->Around->Radius - away;
      return radius > 0.0 ? Pi * radius * radius : 0.0;
    }
    double area = 1.0;
    for (int p = 0; p < 3; ++p)
    {
      if (p != this->Axis)
      {
        const double edge = this->Bounds.Extent(p) - (this->Bounds.Periodic[p] ? 0.0 : 2.0 * away);
        area *= std::max(edge, 0.0);
      }
    }
    return area;
  }

  bool IsInCore(const Vector3& centre) const
  {
    const double away = this->Bounds.LargestDiameter();
    if (this->Around)
    {
      return DistanceFromAxis(centre, *this->Around) <= this->Around->Radius - away;
    }
    for (int p = 0; p < 3; ++p)
    {
      if (p != this->Axis && !this->Bounds.Periodic[p] &&
        !(centre[p] >= this->Bounds.Least[p] + away &&
          centre[p] <= this->Bounds.Greatest[p] - away))
      {
        return false;
      }
    }
    return true;
  }

  // Where the spheres of the core end: their centres, outer and inner surfaces
  static constexpr int NumberOfEnds = 3;
  void FindEnds(const Vector3& centre, double radius, double* minusEnds) const
  {
    const double height = this->Outwards * centre[this->Axis];
    minusEnds[0] = std::min(minusEnds[0], -height);
    minusEnds[1] = std::min(minusEnds[1], -(height + radius));
    minusEnds[2] = std::min(minusEnds[2], -(height - radius));
  }
  void SetEnds(const double* minusEnds)
  {
    std::transform(minusEnds, minusEnds + NumberOfEnds, this->Ends, [](double c) { return -c; });
  }

  std::size_t NumberOfSums() const { return MiddleSums + this->Layers.Size(); }
  void Add(const Vector3& centre, double radius, std::int64_t* sums) const
  {
    const double height = this->Outwards * centre[this->Axis];
    const double share = radius / this->Bounds.LargestRadius;
    const double volume = share * share * share;
    if (height > this->MiddleBottom && height <= this->MiddleTop)
    {
      ++sums[Spheres];
      sums[Radii] += FixedShare(share);
      sums[Discs] += FixedShare(share * share);
      sums[Volumes] += FixedShare(volume);
      sums[SquaredVolumes] += FixedShare(volume * volume);
    }
    if (height > this->Ends[0] - this->Bounds.LargestRadius)
    {
      sums[OuterVolumes] += FixedShare(volume);
    }
    this->Layers.Add(this->Ends[1] - (height + radius), radius, sums + MiddleSums);
  }

  double Covered(const std::int64_t* sums) const
  {
    return AreaOf(this->Layers.FindFullest(sums + MiddleSums).Discs, this->Bounds) / this->Area();
  }
  FaceKind Judge(const std::int64_t* sums) const;

private:
  enum Sum
  {
    Spheres,
    Radii,
    Discs,
    Volumes,
    SquaredVolumes,
    OuterVolumes,
    MiddleSums
  };
  bool IsWall(const std::int64_t* sums) const;
  bool EndsBySurfaces(const std::int64_t* sums) const;

  const PackBounds& Bounds;
  const std::optional<Mantle>& Around;
  int Axis;
  double Outwards;
  Bands Layers;
  double MiddleTop = 0.0, MiddleBottom = 0.0;
  double Ends[NumberOfEnds] = { 0.0, 0.0, 0.0 };
};

bool Face::IsWall(const std::int64_t* sums) const
{
  const Bands::Layer layer = this->Layers.FindFullest(sums + MiddleSums);
  const double middle = AreaOf(sums[Discs], this->Bounds) / this->Area() * this->Layers.Width() /
    (this->MiddleTop - this->MiddleBottom);
  const double covered = AreaOf(layer.Discs, this->Bounds) / this->Area();
  return layer.Spheres >= WallSpheres && covered > WallCovered && covered > WallOverMiddle * middle;
}

bool Face::EndsBySurfaces(const std::int64_t* sums) const
{
  const double spheres = static_cast<double>(sums[Spheres]);
  const double perHeight = spheres / (this->MiddleTop - this->MiddleBottom);
  const double radius = ShareOf(sums[Radii]) / spheres * this->Bounds.LargestRadius;
  const double lowest = std::min(this->Ends[1] - radius, this->Ends[2] + radius);
  return perHeight * (this->Ends[0] - lowest) > LogLikelihood;
}

FaceKind Face::Judge(const std::int64_t* sums) const
{
  if (!(this->Area() > 0.0) || sums[Volumes] == 0)
  {
    return FaceKind::Unknown;
  }
  if (this->IsWall(sums))
  {
    return FaceKind::Wall;
  }
  const double middle = ShareOf(sums[Volumes]), squares = ShareOf(sums[SquaredVolumes]);
  const double layer = this->Bounds.LargestRadius / (this->MiddleTop - this->MiddleBottom);
  // The errors of the layer and of the middle
  const double fraction = 4.0 / 3.0 * Pi * middle * std::pow(this->Bounds.LargestRadius, 3) /
    (this->Area() * (this->MiddleTop - this->MiddleBottom));
  const double error =
    std::max(LeastScatter, 1.0 - fraction) * std::sqrt(squares * (1.0 / layer + 1.0)) / middle;
  const double filled = ShareOf(sums[OuterVolumes]) / (middle * layer);
  if (this->EndsBySurfaces(sums))
  {
    return FaceKind::Loose;
  }
  return error > LargestError                                 ? FaceKind::Unknown
    : filled < 1.0 - std::max(LooseLoss, LooseErrors * error) ? FaceKind::Loose
                                                              : FaceKind::Cut;
}

// How far out the spheres reach in each direction around a point of the axis; < 0 for none
std::array<double, Directions> ReachAround(
  const SpherePack& piece, const Mantle& mantle, Communicator& ranks)
{
  std::array<double, Directions> reach; // minus the reach until it is returned
  reach.fill(1.0);
  const int a = (mantle.Axis + 1) % 3, b = (mantle.Axis + 2) % 3;
  for (std::size_t i = 0; i < piece.Size(); ++i)
  {
    const Vector3 centre = piece.Centre(i);
    const double x = centre[a] - mantle.Centre[a], y = centre[b] - mantle.Centre[b];
    const double turn = std::atan2(y, x) / (2.0 * Pi) + 0.5;
    const int n = std::min(static_cast<int>(turn * Directions), Directions - 1);
    reach[n] = std::min(reach[n], -(std::hypot(x, y) + piece.Radius[i]));
  }
  ranks.Minimum(reach.data(), reach.size());
  std::transform(reach.begin(), reach.end(), reach.begin(), [](double r) { return -r; });
  return reach;
}

double FindCovered(
  const SpherePack& piece, const PackBounds& bounds, const Mantle& mantle, Communicator& ranks)
{
  const double away = bounds.Periodic[mantle.Axis] ? 0.0 : bounds.LargestDiameter();
  const double low = bounds.Least[mantle.Axis] + away, high = bounds.Greatest[mantle.Axis] - away;
  if (!(high > low))
  {
    return 0.0;
  }
  const Bands bands(bounds);
  std::vector<std::int64_t> sums(bands.Size(), 0);
  for (std::size_t i = 0; i < piece.Size(); ++i)
  {
    const Vector3 centre = piece.Centre(i);
    if (centre[mantle.Axis] >= low && centre[mantle.Axis] <= high)
    {
      bands.Add(mantle.Radius - DistanceFromAxis(centre, mantle) - piece.Radius[i], piece.Radius[i],
        sums.data());
    }
  }
  ranks.Sum(sums.data(), sums.size());
  return AreaOf(bands.FindFullest(sums.data()).Discs, bounds) /
    (2.0 * Pi * mantle.Radius * (high - low));
}
}

const char* NameOf(FaceKind kind)
{
  static const char* const names[CountOf(FaceKind())] = { "cut", "wall", "loose", "unknown",
    "periodic" };
  return names[static_cast<int>(kind)];
}

const char* NameOfFace(int face)
{
  static const char* const names[NumberOfFaces] = { "x-", "x+", "y-", "y+", "z-", "z+" };
  return names[face];
}

std::optional<Mantle> FitMantle(
  const SpherePack& piece, const PackBounds& bounds, int axis, Communicator& ranks)
{
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  Mantle mantle;
  mantle.Axis = axis;
  mantle.Centre[a] = 0.5 * (bounds.Least[a] + bounds.Greatest[a]);
  mantle.Centre[b] = 0.5 * (bounds.Least[b] + bounds.Greatest[b]);
  for (int fit = 0;; ++fit)
  {
    const std::array<double, Directions> reach = ReachAround(piece, mantle, ranks);
    mantle.Radius = *std::max_element(reach.begin(), reach.end());
    if (*std::min_element(reach.begin(), reach.end()) < 0.0)
    {
      return std::nullopt;
    }
    if (fit == Fits)
    {
      break;
    }
    // A circle that is a little off centre reaches r + c . n in the direction n
    for (int n = 0; n < Directions; ++n)
    {
      const double angle = 2.0 * Pi * ((n + 0.5) / Directions - 0.5);
      mantle.Centre[a] += 2.0 / Directions * reach[n] * std::cos(angle);
      mantle.Centre[b] += 2.0 / Directions * reach[n] * std::sin(angle);
    }
  }
  mantle.Covered = FindCovered(piece, bounds, mantle, ranks);
  return mantle;
}

std::optional<Mantle> FindMantle(
  const SpherePack& piece, const PackBounds& bounds, Communicator& ranks)
{
  for (int axis : { 2, 1, 0 })
  {
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    // A cylinder is as wide as it is deep
    if (bounds.Periodic[a] || bounds.Periodic[b] ||
      std::abs(bounds.Extent(a) - bounds.Extent(b)) > bounds.LargestRadius)
    {
      continue;
    }
    const std::optional<Mantle> mantle = FitMantle(piece, bounds, axis, ranks);
    if (mantle && mantle->Covered > WallCovered)
    {
      return mantle;
    }
  }
  return std::nullopt;
}

PackFaces FindFaces(const SpherePack& piece, const PackBounds& bounds,
  const std::optional<Mantle>& mantle, Communicator& ranks)
{
  PackFaces found;
  std::vector<Face> faces;
  std::vector<int> numbers;
  for (int f = 0; f < NumberOfFaces; ++f)
  {
    found.Kinds[f] = bounds.Periodic[f / 2] ? FaceKind::Periodic : FaceKind::Unknown;
    if (!bounds.Periodic[f / 2] && (!mantle || mantle->Axis == f / 2))
    {
      faces.emplace_back(bounds, mantle, f);
      numbers.push_back(f);
    }
  }
  std::vector<double> ends(
    Face::NumberOfEnds * faces.size(), std::numeric_limits<double>::infinity());
  const auto forEachInCore = [&](auto&& visit)
  {
    for (std::size_t i = 0; i < piece.Size(); ++i)
    {
      const Vector3 centre = piece.Centre(i);
      for (std::size_t n = 0; n < faces.size(); ++n)
      {
        if (faces[n].IsInCore(centre))
        {
          visit(n, centre, piece.Radius[i]);
        }
      }
    }
  };
  forEachInCore([&](std::size_t n, const Vector3& centre, double radius)
    { faces[n].FindEnds(centre, radius, &ends[Face::NumberOfEnds * n]); });
  ranks.Minimum(ends.data(), ends.size());
  for (std::size_t n = 0; n < faces.size(); ++n)
  {
    faces[n].SetEnds(&ends[Face::NumberOfEnds * n]);
  }
  const std::size_t width = faces.empty() ? 0 : faces.front().NumberOfSums();
  std::vector<std::int64_t> sums(width * faces.size(), 0);
  forEachInCore([&](std::size_t n, const Vector3& centre, double radius)
    { faces[n].Add(centre, radius, &sums[width * n]); });
  ranks.Sum(sums.data(), sums.size());
  for (std::size_t n = 0; n < faces.size(); ++n)
  {
    found.Kinds[numbers[n]] = faces[n].Judge(&sums[width * n]);
    found.Covered[numbers[n]] = faces[n].Area() > 0.0 ? faces[n].Covered(&sums[width * n]) : 0.0;
  }
  return found;
}
}
