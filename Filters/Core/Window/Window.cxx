// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Window/Window.h"

#include "ruc/Base/Require.h"
#include "ruc/Base/Text.h"
#include "ruc/Base/Vector3.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace ruc
{
namespace
{
void RequireFinite(const char* name, const Vector3& v)
{
  for (double c : v)
  {
    if (!std::isfinite(c))
    {
      throw std::invalid_argument(
        Text(name, " requires three finite numbers, got ", v[0], " ", v[1], " ", v[2], "."));
    }
  }
}

void RequirePlace(const char* name, const Vector3& place)
{
  RequireFinite(name, place);
  for (double c : place)
  {
    if (std::abs(c) > GreatestLength)
    {
      throw std::invalid_argument(Text(name, " requires three numbers of at most ", GreatestLength,
        ", got ", place[0], " ", place[1], " ", place[2], "."));
    }
  }
}

void RequireLength(const char* name, double value)
{
  if (!(value >= LeastLength && value <= GreatestLength))
  {
    throw std::invalid_argument(Text(name, " requires a length from ", LeastLength, " to ",
      GreatestLength, ", got ", value, "; try another unit."));
  }
}

void RequirePositive(const char* name, double value)
{
  Require(value > 0.0 && std::isfinite(value), name, "a finite number > 0", value);
}

// The area that two discs of the same radius share
double SharedDiscArea(double radius, double distance)
{
  const double x = distance / (2.0 * radius);
  return x < 1.0 ? 2.0 * radius * radius * (std::acos(x) - x * std::sqrt(1.0 - x * x)) : 0.0;
}
}

void RequireMargin(double margin)
{
  Require(margin >= 0.0 && std::isfinite(margin), "Margin", "a finite number >= 0", margin);
}

Window Window::MakeBox(
  const Vector3& origin, const Vector3& size, const std::array<bool, 3>& periodic)
{
  RequirePlace("BoxOrigin", origin);
  for (double edge : size)
  {
    if (!(edge > 0.0 && std::isfinite(edge)))
    {
      throw std::invalid_argument(Text(
        "BoxSize requires three finite edges > 0, got ", size[0], " ", size[1], " ", size[2], "."));
    }
    RequireLength("BoxSize", edge);
  }
  Window window;
  window.WindowShape = Shape::Box;
  window.Origin = origin;
  window.Size = size;
  window.Periodic = periodic;
  return window;
}

Window Window::MakeCylinder(const Vector3& base, const Vector3& axis, double radius, double height)
{
  RequirePlace("CylinderBase", base);
  RequireFinite("CylinderAxis", axis);
  RequirePositive("CylinderRadius", radius);
  RequirePositive("CylinderHeight", height);
  RequireLength("CylinderRadius", radius);
  RequireLength("CylinderHeight", height);
  const double length = std::hypot(axis[0], axis[1], axis[2]);
  Require(length > 0.0, "CylinderAxis", "a direction", "0 0 0");
  Window window;
  window.WindowShape = Shape::Cylinder;
  window.Base = base;
  window.Axis = { axis[0] / length, axis[1] / length, axis[2] / length };
  window.Radius = radius;
  window.Height = height;
  return window;
}

bool Window::IsPeriodic() const
{
  return this->Periodic[0] || this->Periodic[1] || this->Periodic[2];
}

bool Window::IsFullyPeriodic() const
{
  return this->Periodic[0] && this->Periodic[1] && this->Periodic[2];
}

double Window::Volume() const
{
  return this->WindowShape == Shape::Box ? this->Size[0] * this->Size[1] * this->Size[2]
                                         : Pi * this->Radius * this->Radius * this->Height;
}

bool Window::Contains(const Vector3& centre) const
{
  if (this->WindowShape == Shape::Box)
  {
    for (int q = 0; q < 3; ++q)
    {
      if (!this->ContainsAlong(q, centre[q]))
      {
        return false;
      }
    }
    return true;
  }
  const Vector3 p = { centre[0] - this->Base[0], centre[1] - this->Base[1],
    centre[2] - this->Base[2] };
  const double along = p[0] * this->Axis[0] + p[1] * this->Axis[1] + p[2] * this->Axis[2];
  const double lateral2 = std::max(p[0] * p[0] + p[1] * p[1] + p[2] * p[2] - along * along, 0.0);
  return along >= 0.0 && along <= this->Height && lateral2 <= this->Radius * this->Radius;
}

bool Window::ContainsAlong(int axis, double coordinate) const
{
  const double slack = this->Periodic[axis] ? 1e-9 * this->Size[axis] : 0.0;
  return coordinate >= this->Origin[axis] - slack &&
    coordinate <= this->Origin[axis] + this->Size[axis] + slack;
}

double Window::DepthOf(const Vector3& point) const
{
  double depth = std::numeric_limits<double>::infinity();
  if (this->WindowShape == Shape::Box)
  {
    for (int q = 0; q < 3; ++q)
    {
      const double from = point[q] - this->Origin[q];
      depth = this->Periodic[q] ? depth : std::min({ depth, from, this->Size[q] - from });
    }
    return depth;
  }
  const Vector3 p = { point[0] - this->Base[0], point[1] - this->Base[1],
    point[2] - this->Base[2] };
  const double along = Dot(p, this->Axis);
  const double lateral = std::sqrt(std::max(Dot(p, p) - along * along, 0.0));
  return std::min({ along, this->Height - along, this->Radius - lateral });
}

double Window::SetCovariance(double dx, double dy, double dz) const
{
  if (this->WindowShape == Shape::Box)
  {
    const double d[3] = { dx, dy, dz };
    double product = 1.0;
    for (int q = 0; q < 3; ++q)
    {
      product *= this->Periodic[q] ? this->Size[q] : std::max(this->Size[q] - std::abs(d[q]), 0.0);
    }
    return product;
  }
  const double along = dx * this->Axis[0] + dy * this->Axis[1] + dz * this->Axis[2];
  const double lateral = std::sqrt(std::max(dx * dx + dy * dy + dz * dz - along * along, 0.0));
  return SharedDiscArea(this->Radius, lateral) * std::max(this->Height - std::abs(along), 0.0);
}

Window Window::Shrunk(double margin) const
{
  RequireMargin(margin);
  const auto require = [&](bool room)
  {
    if (!room)
    {
      throw std::invalid_argument(Text("The window requires room for a margin of ", margin,
        " along its border, got a ", this->Describe(), "."));
    }
  };
  if (this->WindowShape == Shape::Cylinder)
  {
    require(this->Radius > margin && this->Height > 2.0 * margin);
    Vector3 base = this->Base;
    for (int q = 0; q < 3; ++q)
    {
      base[q] += margin * this->Axis[q];
    }
    return MakeCylinder(base, this->Axis, this->Radius - margin, this->Height - 2.0 * margin);
  }
  Vector3 origin = this->Origin, size = this->Size;
  for (int q = 0; q < 3; ++q)
  {
    if (!this->Periodic[q])
    {
      require(size[q] > 2.0 * margin);
      origin[q] += margin;
      size[q] -= 2.0 * margin;
    }
  }
  return MakeBox(origin, size, this->Periodic);
}

Window Window::Scaled(double factor) const
{
  const auto times = [factor](const Vector3& v) {
    return Vector3{ factor * v[0], factor * v[1], factor * v[2] };
  };
  return this->WindowShape == Shape::Box
    ? MakeBox(times(this->Origin), times(this->Size), this->Periodic)
    : MakeCylinder(times(this->Base), this->Axis, factor * this->Radius, factor * this->Height);
}

Window Window::GetBounds() const
{
  if (this->WindowShape == Shape::Box)
  {
    return *this;
  }
  Vector3 origin, size;
  for (int q = 0; q < 3; ++q)
  {
    const double lateral =
      this->Radius * std::sqrt(std::max(1.0 - this->Axis[q] * this->Axis[q], 0.0));
    const double along = this->Height * this->Axis[q];
    origin[q] = this->Base[q] + std::min(along, 0.0) - lateral;
    size[q] = std::abs(along) + 2.0 * lateral;
  }
  return MakeBox(origin, size, { false, false, false });
}

// By the Brunn-Minkowski inequality the cube root of the set covariance of a convex window is
// concave, so its least value over a polytope is at a corner. This polytope holds the ball: no
// component above reach, the sum of no two above sqrt(2) reach, the sum of all three not above
// sqrt(3) reach.
double Window::LeastSetCovariance(double reach) const
{
  const double steps[3] = { reach, (std::sqrt(2.0) - 1.0) * reach,
    (std::sqrt(3.0) - std::sqrt(2.0)) * reach };
  double least = this->Volume();
  if (this->WindowShape == Shape::Cylinder)
  {
    const Vector3& a = this->Axis;
    // A direction across the axis
    Vector3 b = std::abs(a[0]) < 0.5 ? Vector3{ 0.0, a[2], -a[1] } : Vector3{ a[1], -a[0], 0.0 };
    const double length = std::hypot(b[0], b[1], b[2]);
    for (int along : { 0, 1 })
    {
      const double x = steps[along], y = steps[1 - along] / length;
      least = std::min(
        least, this->SetCovariance(x * a[0] + y * b[0], x * a[1] + y * b[1], x * a[2] + y * b[2]));
    }
    return least;
  }
  int order[3] = { 0, 1, 2 };
  do
  {
    least = std::min(least, this->SetCovariance(steps[order[0]], steps[order[1]], steps[order[2]]));
  } while (std::next_permutation(order, order + 3));
  return least;
}

double Window::Reach() const
{
  if (this->WindowShape == Shape::Cylinder)
  {
    return this->ShortestEdge();
  }
  double reach = std::numeric_limits<double>::infinity();
  for (int q = 0; q < 3; ++q)
  {
    if (!this->Periodic[q])
    {
      reach = std::min(reach, this->Size[q]);
    }
  }
  return reach;
}

double Window::ShortestEdge() const
{
  return this->WindowShape == Shape::Box ? *std::min_element(this->Size.begin(), this->Size.end())
                                         : std::min(2.0 * this->Radius, this->Height);
}

std::string Window::Describe() const
{
  if (this->WindowShape == Shape::Cylinder)
  {
    return Text("cylinder window of radius ", this->Radius, " and height ", this->Height);
  }
  return Text(this->IsFullyPeriodic() ? "periodic box "
      : this->IsPeriodic()            ? "partly periodic box "
                                      : "box window ",
    this->Size[0], " x ", this->Size[1], " x ", this->Size[2]);
}
}
