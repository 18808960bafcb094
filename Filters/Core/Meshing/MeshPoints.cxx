// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Meshing/MeshPoints.h"

#include <algorithm>

namespace ruc
{
namespace
{
constexpr std::uint8_t LowBit(int axis)
{
  return static_cast<std::uint8_t>(1u << (2 * axis));
}

constexpr std::uint8_t HighBit(int axis)
{
  return static_cast<std::uint8_t>(2u << (2 * axis));
}
}

MeshPoints::MeshPoints(const MeshCell& cell, const std::vector<CellPoint>& points)
  : Cell(cell)
{
  for (const CellPoint& point : points)
  {
    this->AddAllCopies(point);
  }
}

int MeshPoints::PartFor(int sphere, const std::array<int, 3>& image)
{
  const auto [found, isNew] =
    this->PartNumbers.try_emplace({ sphere, image }, static_cast<int>(this->AllParts.size()));
  if (isNew)
  {
    this->AllParts.push_back({ sphere, image, {}, {} });
  }
  return found->second;
}

int MeshPoints::AddCopy(const CellPoint& point, const std::array<bool, 3>& high, int base)
{
  const int made = static_cast<int>(this->Place.size());
  Vector3 place = point.Place;
  std::array<int, 3> image = point.Image;
  std::uint8_t boundary = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (high[axis])
    {
      place[axis] = this->Cell.Edge[axis];
      --image[axis];
    }
    boundary |= !point.OnPlane[axis] ? 0 : high[axis] ? HighBit(axis) : LowBit(axis);
  }
  this->Place.push_back(place);
  this->Boundary.push_back(boundary);
  this->PeriodicOf.push_back(base < 0 ? made : base);
  this->Inner.push_back(point.IsInside);
  this->Owner.push_back(point.Sphere < 0 ? -1 : this->PartFor(point.Sphere, image));
  if (point.Sphere >= 0)
  {
    Part& part = this->AllParts[this->Owner.back()];
    (point.IsInside ? part.Inside : part.OnSurface).push_back(made);
  }
  return made;
}

void MeshPoints::AddAllCopies(const CellPoint& point)
{
  int base = -1;
  for (int copy = 0; copy < 8; ++copy)
  {
    std::array<bool, 3> high{};
    bool isOne = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      high[axis] = copy >> axis & 1;
      isOne = isOne && (!high[axis] || point.OnPlane[axis]);
    }
    if (isOne)
    {
      const int made = this->AddCopy(point, high, base);
      base = base < 0 ? made : base;
    }
  }
}

std::vector<int> MeshPoints::OpenDisc(const Part& part, int axis) const
{
  std::vector<int> disc;
  for (const int point : part.OnSurface)
  {
    if (this->Boundary[point] & LowBit(axis))
    {
      disc.push_back(point);
    }
  }
  const bool isOpen = std::none_of(part.Inside.begin(), part.Inside.end(),
    [&](int point) { return this->Boundary[point] & LowBit(axis); });
  return isOpen && disc.size() >= 3 ? disc : std::vector<int>();
}

void MeshPoints::AddMiddles()
{
  const auto middleOf = [&](const std::vector<int>& points)
  {
    Vector3 middle{};
    for (const int point : points)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        middle[axis] += this->Place[point][axis] / static_cast<double>(points.size());
      }
    }
    return middle;
  };
  const std::size_t count = this->AllParts.size();
  for (std::size_t n = 0; n < count; ++n)
  {
    CellPoint middle;
    middle.Sphere = this->AllParts[n].Sphere;
    middle.Image = this->AllParts[n].Image;
    middle.IsInside = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      const std::vector<int> disc = this->OpenDisc(this->AllParts[n], axis);
      if (!disc.empty())
      {
        middle.Place = middleOf(disc);
        middle.Place[axis] = 0.0;
        middle.OnPlane = {};
        middle.OnPlane[axis] = true;
        this->AddAllCopies(middle);
      }
    }
    const Part& part = this->AllParts[n];
    if (part.OnSurface.size() >= 4 &&
      std::none_of(part.Inside.begin(), part.Inside.end(),
        [&](int point) { return this->Boundary[point] == 0; }))
    {
      middle.Place = middleOf(part.OnSurface);
      middle.OnPlane = {};
      this->AddAllCopies(middle);
    }
  }
}

void MeshPoints::Fill(PeriodicMesh& mesh) const
{
  mesh.Edge = this->Cell.Edge;
  mesh.Points = this->Place;
  mesh.Boundary = this->Boundary;
  mesh.PeriodicOf = this->PeriodicOf;
  for (std::size_t point = 0; point < this->Owner.size(); ++point)
  {
    mesh.Surface.push_back(this->Inner[point] ? -1 : this->Owner[point]);
  }
  for (const Part& part : this->AllParts)
  {
    Vector3 centre = this->Cell.Centre[part.Sphere];
    for (int axis = 0; axis < 3; ++axis)
    {
      centre[axis] -= part.Image[axis] * this->Cell.Edge[axis];
    }
    mesh.PartCentre.push_back(centre);
    mesh.PartRadius.push_back(this->Cell.Radius[part.Sphere]);
  }
}
}
