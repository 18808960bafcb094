// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Results/TaperedBlocks.h"

#include "ruc/Base/Text.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace ruc
{
namespace
{
// Two directions across a third, all of length 1
std::array<Vector3, 3> AxesAround(const Vector3& axis)
{
  int least = 0;
  for (int q = 1; q < 3; ++q)
  {
    least = std::abs(axis[q]) < std::abs(axis[least]) ? q : least;
  }
  Vector3 a{};
  a[least] = 1.0;
  const double along = axis[least];
  double length = 0.0;
  for (int q = 0; q < 3; ++q)
  {
    a[q] -= along * axis[q];
    length += a[q] * a[q];
  }
  for (double& number : a)
  {
    number /= std::sqrt(length);
  }
  const Vector3 b = { axis[1] * a[2] - axis[2] * a[1], axis[2] * a[0] - axis[0] * a[2],
    axis[0] * a[1] - axis[1] * a[0] };
  return { a, b, axis };
}
}

TaperedBlocks::TaperedBlocks(
  const Window& window, int about, double leastEdge, const char* property)
  : Observed(window)
  , Frame(window)
{
  this->Axes = { Vector3{ 1, 0, 0 }, Vector3{ 0, 1, 0 }, Vector3{ 0, 0, 1 } };
  this->Corner = window.Origin;
  if (window.GetShape() == Window::Shape::Cylinder)
  {
    const double width = 2.0 * window.Radius;
    this->Frame =
      Window::MakeBox({ 0, 0, 0 }, { width, width, window.Height }, { false, false, false });
    this->Axes = AxesAround(window.Axis);
    for (int q = 0; q < 3; ++q)
    {
      this->Corner[q] = window.Base[q] - window.Radius * (this->Axes[0][q] + this->Axes[1][q]);
    }
  }
  const double width = std::max(std::cbrt(this->Frame.Volume() / about), leastEdge);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double edge = this->Frame.Size[axis];
    const double most = std::min(std::floor(edge / leastEdge), double(about));
    this->Divisions[axis] =
      static_cast<int>(std::max(std::min(std::round(edge / width), most), 1.0));
  }
  if (this->Count() < Fewest)
  {
    throw std::invalid_argument(
      Text(property, " requires a window with room for ", Fewest, " blocks with edges of at least ",
        leastEdge, ", got a ", window.Describe(), " for ", this->Count(), " of ", about, "."));
  }
  for (int cell = 0; cell < this->Cells(); ++cell)
  {
    const Vector3 middle = this->MiddleOf(cell);
    bool inside = true;
    if (window.GetShape() == Window::Shape::Cylinder)
    {
      inside = std::hypot(middle[0] - window.Radius, middle[1] - window.Radius) <= window.Radius;
    }
    this->Inside.push_back(inside);
    this->NumberInside += inside;
  }
  std::vector<int> groups;
  groups.reserve(this->Count());
  for (int block = 0; block < this->Count(); ++block)
  {
    groups.push_back(this->MirrorGroup(block));
  }
  this->Mirrors = this->MakeGroups(std::move(groups));
}

int TaperedBlocks::CellOf(const Vector3& point) const
{
  int cell = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    double along = 0.0;
    for (int q = 0; q < 3; ++q)
    {
      along += (point[q] - this->Corner[q]) * this->Axes[axis][q];
    }
    const int count = this->CellsAlong(axis);
    const double place = std::floor(along / this->Frame.Size[axis] * count);
    cell = cell * count + static_cast<int>(std::clamp(place, 0.0, count - 1.0));
  }
  return cell;
}

Vector3 TaperedBlocks::MiddleOf(int cell) const
{
  const std::array<int, 3> at = this->PlaceOfCell(cell);
  Vector3 middle;
  for (int axis = 0; axis < 3; ++axis)
  {
    middle[axis] = (at[axis] + 0.5) / this->CellsAlong(axis) * this->Frame.Size[axis];
  }
  return middle;
}

TaperedBlocks::Parts TaperedBlocks::PartsOf(int axis, int cell) const
{
  const int count = this->Divisions[axis];
  // The middle of the cell, in eighths of an edge, from that of block 0 on
  const int place = 2 * cell + 1 - CellsOfEdge;
  const int whole = 2 * CellsOfEdge;
  const int lower = place < 0 ? -1 : place / whole;
  const int above = place - whole * lower;
  if (count == 1 || (!this->IsPeriodic(axis) && (lower < 0 || lower == count - 1)))
  {
    return { 1, { std::max(lower, 0), 0 }, { whole, 0 } };
  }
  return { 2, { (lower + count) % count, (lower + 1) % count }, { whole - above, above } };
}

int TaperedBlocks::WeightAlong(int axis, int block, int cell) const
{
  const Parts parts = this->PartsOf(axis, cell);
  int weight = 0;
  for (int n = 0; n < parts.Number; ++n)
  {
    weight += parts.Block[n] == block ? parts.Weight[n] : 0;
  }
  return weight;
}

int TaperedBlocks::MirrorGroup(int block, int except) const
{
  const std::array<int, 3> at = this->PlaceOfBlock(block);
  int group = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int count = this->Divisions[axis];
    const int mirror = std::min(at[axis], count - 1 - at[axis]);
    group = group * count + (axis == except ? at[axis] : this->IsPeriodic(axis) ? 0 : mirror);
  }
  return group;
}

TaperedBlocks::Groups TaperedBlocks::MakeGroups(std::vector<int> of) const
{
  Groups groups;
  std::map<int, int> numbers;
  for (int& group : of)
  {
    group = numbers.emplace(group, static_cast<int>(numbers.size())).first->second;
  }
  groups.Sizes.assign(numbers.size(), 0);
  for (int group : of)
  {
    ++groups.Sizes[group];
  }
  for (int cell = 0; cell < this->Cells(); ++cell)
  {
    if (!this->Inside[cell])
    {
      continue;
    }
    std::map<int, double> sums;
    this->ForEachBlock(cell,
      [&](int block, int weight)
      {
        const double share = double(weight) / WholeWeight;
        groups.ExpectedSquares += share * share;
        sums[of[block]] += share;
      });
    for (const auto& [group, sum] : sums)
    {
      groups.ExpectedSquares -= sum * sum / groups.Sizes[group];
    }
  }
  groups.Of = std::move(of);
  return groups;
}

double TaperedBlocks::SquaresWithin(const Groups& groups, const std::vector<double>& values)
{
  std::vector<double> means(groups.Sizes.size(), 0.0);
  for (std::size_t block = 0; block < values.size(); ++block)
  {
    means[groups.Of[block]] += values[block] / groups.Sizes[groups.Of[block]];
  }
  double squares = 0.0;
  for (std::size_t block = 0; block < values.size(); ++block)
  {
    const double difference = values[block] - means[groups.Of[block]];
    squares += difference * difference;
  }
  return squares;
}

double TaperedBlocks::VarianceOfSum(const std::vector<double>& parts) const
{
  return SquaresWithin(this->Mirrors, parts) * this->NumberInside / this->Mirrors.ExpectedSquares;
}
}
