// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Tracing/LineBundle.h"

#include "ruc/Base/Vector3.h"

#include <algorithm>
#include <cmath>

namespace ruc
{
namespace
{
// The vector whose product is 1 with a, and 0 with b and c
Vector3 Dual(const Vector3& a, const Vector3& b, const Vector3& c)
{
  const Vector3 across = Cross(b, c);
  const double product = Dot(a, across);
  return { across[0] / product, across[1] / product, across[2] / product };
}

// The whole numbers from middle - width to middle + width, with some slack, so that rounding loses
// none. (std::ceil and std::floor are function calls where the compiler cannot count on
// instructions for them.)
struct Range
{
  Range(double middle, double width)
  {
    const double slack = width * 1e-9 + 1e-9;
    const double low = middle - width - slack, high = middle + width + slack;
    this->First = static_cast<std::int64_t>(low);
    this->First += static_cast<double>(this->First) < low;
    this->Last = static_cast<std::int64_t>(high);
    this->Last -= static_cast<double>(this->Last) > high;
  }
  std::int64_t First, Last;
};

std::int64_t FloorDivided(std::int64_t a, std::int64_t b)
{
  return a >= 0 ? a / b : -((-a + b - 1) / b);
}
}

LineBundle::LineBundle(const Window& box, const Vector3& direction, const Vector3& origin,
  const Vector3& axisI, const Vector3& axisJ, const std::array<int, 2>& first,
  const std::array<int, 2>& count)
  : Direction(direction)
  , Box(box)
  , Closed(box.IsFullyPeriodic())
  , Origin(origin)
  , AxisI(axisI)
  , AxisJ(axisJ)
  , First(first)
  , Count(count)
  , LineAt(static_cast<std::size_t>(count[0]) * count[1], -1)
  , DualI(Dual(axisI, axisJ, direction))
  , DualJ(Dual(axisJ, direction, axisI))
  , DualT(Dual(direction, axisI, axisJ))
  , WidthI(Length(this->DualI))
  , WidthJ(Length(this->DualJ))
  , WidthT(Length(this->DualT))
{
  for (int q = 0; q < 3; ++q)
  {
    this->SpannedByI[q] = axisI[q] != 0.0;
    this->SpannedByJ[q] = axisJ[q] != 0.0;
  }
}

Vector3 LineBundle::StartOf(int i, int j) const
{
  Vector3 start;
  for (int q = 0; q < 3; ++q)
  {
    start[q] = this->Origin[q] + i * this->AxisI[q] + j * this->AxisJ[q];
  }
  return start;
}

void LineBundle::AddLine(int i, int j, std::vector<LineInterval> inside)
{
  this->LineAt[static_cast<std::size_t>(i - this->First[0]) * this->Count[1] + j - this->First[1]] =
    static_cast<int>(this->Lines.size());
  this->Longest = std::max(this->Longest, inside.back().End);
  this->Lines.push_back({ this->StartOf(i, j), std::move(inside) });
}

void LineBundle::FindHits(const SpherePack& pack, std::vector<std::vector<SphereHit>>& hits) const
{
  if (!this->Closed)
  {
    // Lines stay in the box. An edge exceeds the diameter, so only the nearest images reach in.
    const int lastX = this->Box.Periodic[0], lastY = this->Box.Periodic[1],
              lastZ = this->Box.Periodic[2];
    for (int x = -lastX; x <= lastX; ++x)
    {
      for (int y = -lastY; y <= lastY; ++y)
      {
        for (int z = -lastZ; z <= lastZ; ++z)
        {
          for (std::size_t n = 0; n < pack.Size(); ++n)
          {
            this->FindHitsOf(pack, n, { x, y, z }, hits);
          }
        }
      }
    }
    return;
  }
  // Only images along the axis that the lattice does not span are needed, as far as the lines go.
  // Where a line is nearest to a centre, no farther away than the radius, its position differs from
  // that of the centre by WidthT x radius at most.
  int across = 0;
  for (int q = 1; q < 3; ++q)
  {
    across = std::abs(this->DualT[q]) > std::abs(this->DualT[across]) ? q : across;
  }
  const double step = this->DualT[across] * this->Box.Size[across];
  for (std::size_t n = 0; n < pack.Size(); ++n)
  {
    const double t = Dot(this->DualT,
      { pack.X[n] - this->Origin[0], pack.Y[n] - this->Origin[1], pack.Z[n] - this->Origin[2] });
    const double slack = pack.Radius[n] * (1.0 + this->WidthT);
    const Range images(
      (0.5 * this->Longest - t) / step, (0.5 * this->Longest + slack) / std::abs(step));
    for (std::int64_t m = images.First; m <= images.Last; ++m)
    {
      std::array<int, 3> image = { 0, 0, 0 };
      image[across] = static_cast<int>(m);
      this->FindHitsOf(pack, n, image, hits);
    }
  }
}

void LineBundle::FindHitsOf(const SpherePack& pack, std::size_t sphere,
  const std::array<int, 3>& image, std::vector<std::vector<SphereHit>>& hits) const
{
  const Vector3& size = this->Box.Size;
  const double radius = pack.Radius[sphere];
  const Vector3 centre = pack.Centre(sphere);
  const Vector3 p = { centre[0] + image[0] * size[0] - this->Origin[0],
    centre[1] + image[1] * size[1] - this->Origin[1],
    centre[2] + image[2] * size[2] - this->Origin[2] };
  const Range rows(Dot(this->DualI, p), radius * this->WidthI);
  const Range columns(Dot(this->DualJ, p), radius * this->WidthJ);
  for (std::int64_t i = rows.First; i <= rows.Last; ++i)
  {
    for (std::int64_t j = columns.First; j <= columns.Last; ++j)
    {
      // A place beyond a closed lattice is a place in it, which another image meets
      const std::int64_t overI = this->Closed ? FloorDivided(i, this->Count[0]) : 0;
      const std::int64_t overJ = this->Closed ? FloorDivided(j, this->Count[1]) : 0;
      const std::int64_t row = i - overI * this->Count[0] - this->First[0];
      const std::int64_t column = j - overJ * this->Count[1] - this->First[1];
      if (row < 0 || row >= this->Count[0] || column < 0 || column >= this->Count[1])
      {
        continue;
      }
      const int n = this->LineAt[row * this->Count[1] + column];
      if (n < 0)
      {
        continue;
      }
      const SampleLine& line = this->Lines[n];
      Vector3 from;
      for (int q = 0; q < 3; ++q)
      {
        const std::int64_t edges =
          image[q] - overI * this->SpannedByI[q] - overJ * this->SpannedByJ[q];
        from[q] = centre[q] + edges * size[q] - line.Start[q];
      }
      const Vector3& d = this->Direction;
      const double middle = Dot(from, d);
      const double x = from[0] - middle * d[0], y = from[1] - middle * d[1],
                   z = from[2] - middle * d[2];
      const double half2 = radius * radius - (x * x + y * y + z * z);
      if (half2 > 0.0)
      {
        const double half = std::sqrt(half2);
        const double in = middle - half, out = middle + half;
        if (out > line.Inside.front().Begin && in < line.Inside.back().End)
        {
          hits[n].push_back({ in, out, pack.Mode[sphere] - 1 });
        }
      }
    }
  }
}
}
