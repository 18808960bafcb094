// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Particles/FilledShare.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace ruc
{
namespace
{
constexpr std::array<double, 4> SpheresPerCell = { 2.0, 4.0, 8.0, 16.0 };

// Places in a window as coordinates from 0 to 1, whose equal steps are equal volumes. In a box they
// go along its axes; in a cylinder they are the square of the distance from the axis, the angle and
// the height
class UnitCube
{
public:
  explicit UnitCube(const Window& window)
    : Of(window)
  {
    const Vector3& a = window.Axis;
    this->Across = std::abs(a[0]) < 0.5 ? Cross(a, { 1.0, 0.0, 0.0 }) : Cross(a, { 0.0, 1.0, 0.0 });
    const double length = std::max(Length(this->Across), LeastLength);
    this->Across = { this->Across[0] / length, this->Across[1] / length, this->Across[2] / length };
    this->Beside = Cross(a, this->Across);
  }

  Vector3 To(const Vector3& place) const
  {
    Vector3 unit;
    if (this->Of.GetShape() == Window::Shape::Box)
    {
      for (int q = 0; q < 3; ++q)
      {
        unit[q] = (place[q] - this->Of.Origin[q]) / this->Of.Size[q];
        unit[q] -= this->Of.Periodic[q] ? std::floor(unit[q]) : 0.0;
      }
      return unit;
    }
    const Vector3 p = { place[0] - this->Of.Base[0], place[1] - this->Of.Base[1],
      place[2] - this->Of.Base[2] };
    const double x = Dot(p, this->Across) / this->Of.Radius;
    const double y = Dot(p, this->Beside) / this->Of.Radius;
    return { x * x + y * y, std::atan2(y, x) / (2.0 * Pi) + 0.5,
      Dot(p, this->Of.Axis) / this->Of.Height };
  }

  Vector3 From(const Vector3& unit) const
  {
    Vector3 place;
    const double r = this->Of.Radius * std::sqrt(unit[0]), angle = 2.0 * Pi * (unit[1] - 0.5);
    for (int q = 0; q < 3; ++q)
    {
      place[q] = this->Of.GetShape() == Window::Shape::Box
        ? this->Of.Origin[q] + unit[q] * this->Of.Size[q]
        : this->Of.Base[q] + r * std::cos(angle) * this->Across[q] +
          r * std::sin(angle) * this->Beside[q] + unit[2] * this->Of.Height * this->Of.Axis[q];
    }
    return place;
  }

  // Returns about the lengths of the coordinates
  Vector3 Edges() const
  {
    return this->Of.GetShape() == Window::Shape::Box
      ? this->Of.Size
      : Vector3{ this->Of.Radius, Pi * this->Of.Radius, this->Of.Height };
  }

  // Returns the most cells along each coordinate. Of many rings of equal area the outer ones would
  // be thin
  Vector3 MostCells() const
  {
    return { this->Of.GetShape() == Window::Shape::Box ? 16.0 : 2.0, 16.0, 16.0 };
  }

private:
  const Window& Of;
  Vector3 Across, Beside; // the axes of a cylinder's base
};

class Cells
{
public:
  Cells(const UnitCube& cube, double width)
    : Cube(cube)
  {
    const Vector3 edges = cube.Edges(), most = cube.MostCells();
    for (int q = 0; q < 3; ++q)
    {
      this->Number[q] = static_cast<int>(std::clamp(std::floor(edges[q] / width), 1.0, most[q]));
      this->Width = std::min(this->Width, edges[q] / this->Number[q]);
    }
  }

  std::size_t Count() const
  {
    return std::size_t(this->Number[0]) * this->Number[1] * this->Number[2];
  }

  // Adds 1 for the cell of the centre, and for every cell that lies in a sphere larger than the
  // cell
  void Add(const Vector3& centre, double radius, const Window& window, std::int64_t* filled) const
  {
    const Vector3 unit = this->Cube.To(centre);
    std::array<int, 3> cell;
    for (int q = 0; q < 3; ++q)
    {
      cell[q] = std::clamp(static_cast<int>(unit[q] * this->Number[q]), 0, this->Number[q] - 1);
    }
    ++filled[this->PlaceOf(cell)];
    if (radius < 0.5 * this->Width)
    {
      return;
    }
    for (cell[2] = 0; cell[2] < this->Number[2]; ++cell[2])
    {
      for (cell[1] = 0; cell[1] < this->Number[1]; ++cell[1])
      {
        for (cell[0] = 0; cell[0] < this->Number[0]; ++cell[0])
        {
          filled[this->PlaceOf(cell)] += this->IsMiddleWithin(cell, centre, radius, window) ? 1 : 0;
        }
      }
    }
  }

private:
  std::size_t PlaceOf(const std::array<int, 3>& cell) const
  {
    return (std::size_t(cell[2]) * this->Number[1] + cell[1]) * this->Number[0] + cell[0];
  }
  bool IsMiddleWithin(const std::array<int, 3>& cell, const Vector3& centre, double radius,
    const Window& window) const
  {
    const Vector3 middle = this->Cube.From({ (cell[0] + 0.5) / this->Number[0],
      (cell[1] + 0.5) / this->Number[1], (cell[2] + 0.5) / this->Number[2] });
    Vector3 d;
    for (int q = 0; q < 3; ++q)
    {
      d[q] = middle[q] - centre[q];
      d[q] -= window.Periodic[q] ? window.Size[q] * std::round(d[q] / window.Size[q]) : 0.0;
    }
    return Length(d) <= radius;
  }

  const UnitCube& Cube;
  std::array<int, 3> Number{};
  double Width = GreatestLength;
};

// Returns (sum v)^2 / sum v^2 of all ranks
double EvenNumber(const SpherePack& piece, Communicator& ranks)
{
  double sums[2] = { 0.0, 0.0 };
  for (double radius : piece.Radius)
  {
    const double volume = radius * radius * radius;
    sums[0] += volume;
    sums[1] += volume * volume;
  }
  ranks.Sum(sums, 2);
  return sums[0] / sums[1] * sums[0];
}

// std::lgamma writes the sign of gamma into a variable that all threads share
double LogGamma(double x)
{
  int sign;
  return lgamma_r(x, &sign);
}

// The logarithm of C(m, E) (1 - E/m)^n
double LogBound(double m, double empty, double n)
{
  return LogGamma(m + 1.0) - LogGamma(empty + 1.0) - LogGamma(m - empty + 1.0) +
    n * std::log1p(-empty / m);
}
}

double FindFilledShare(const SpherePack& piece, const Window& window, Communicator& ranks)
{
  const double number = EvenNumber(piece, ranks);
  const UnitCube cube(window);
  std::vector<Cells> ways;
  std::vector<std::size_t> begin = { 0 };
  for (double spheres : SpheresPerCell)
  {
    ways.emplace_back(cube, std::cbrt(spheres * window.Volume() / number));
    begin.push_back(begin.back() + ways.back().Count());
  }
  std::vector<std::int64_t> filled(begin.back(), 0);
  for (std::size_t i = 0; i < piece.Size(); ++i)
  {
    for (std::size_t w = 0; w < ways.size(); ++w)
    {
      ways[w].Add(piece.Centre(i), piece.Radius[i], window, &filled[begin[w]]);
    }
  }
  ranks.Sum(filled.data(), filled.size());

  double share = 1.0;
  for (std::size_t w = 0; w < ways.size(); ++w)
  {
    const auto first = filled.begin() + static_cast<std::ptrdiff_t>(begin[w]);
    const auto last = filled.begin() + static_cast<std::ptrdiff_t>(begin[w + 1]);
    const double m = static_cast<double>(last - first);
    const double empty = static_cast<double>(std::count(first, last, 0));
    if (empty >= LeastEmptyShare * m &&
      LogBound(m, empty, number) < std::log(FilledShareRisk / SpheresPerCell.size()))
    {
      share = std::min(share, 1.0 - empty / m);
    }
  }
  return share;
}
}
