// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Tracing/RayFan.h"

#include "ruc/Base/Vector3.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ruc
{
namespace
{
Window WithoutPeriods(const Window& box)
{
  return Window::MakeBox(box.Origin, box.Size, { false, false, false });
}
}

RayFan RayFan::Random(const SamplingRegion& region, std::uint32_t seed, std::uint32_t sample)
{
  RayFan fan;
  fan.Centre = region.RandomPoint(seed, sample);
  const Vector3 n = SamplingRegion::RandomDirection(seed, sample);
  const double turn = 2.0 * Pi * SamplingRegion::RandomTurn(seed, sample);
  // Two directions across n, the first also across z, or across x where n is near z
  const Vector3 a =
    std::abs(n[2]) < 0.7 ? Vector3{ n[1], -n[0], 0.0 } : Vector3{ 0.0, n[2], -n[1] };
  const double norm = 1.0 / std::hypot(a[0], a[1], a[2]);
  const Vector3 u = { a[0] * norm, a[1] * norm, a[2] * norm };
  const Vector3 v = { n[1] * u[2] - n[2] * u[1], n[2] * u[0] - n[0] * u[2],
    n[0] * u[1] - n[1] * u[0] };
  const double c = std::cos(turn), s = std::sin(turn);
  for (int q = 0; q < 3; ++q)
  {
    fan.U[q] = c * u[q] + s * v[q];
    fan.V[q] = c * v[q] - s * u[q];
  }
  fan.Normal = n;
  return fan;
}

RayDirections::RayDirections(int number)
{
  for (int ray = 0; ray < number; ++ray)
  {
    this->Cosine.push_back(std::cos(2.0 * Pi * ray / number));
    this->Sine.push_back(std::sin(2.0 * Pi * ray / number));
  }
}

Vector3 RayDirections::Of(const RayFan& fan, int ray) const
{
  Vector3 direction;
  for (int q = 0; q < 3; ++q)
  {
    direction[q] = this->Cosine[ray] * fan.U[q] + this->Sine[ray] * fan.V[q];
  }
  return direction;
}

FanTracer::FanTracer(
  const SpherePack& pack, const Window& box, const RayDirections& rays, double length)
  : Pack(pack)
  , Box(box)
  , Rays(rays)
  , Length(length)
  , LargestRadius(pack.LargestRadius())
  , Cells(pack, WithoutPeriods(box), std::max(2.0 * this->LargestRadius, 1e-6 * length))
{
}

void FanTracer::FindHits(const RayFan& fan, std::vector<RayHit>& hits) const
{
  if (this->Pack.Empty())
  {
    return;
  }
  // The images of the box, by whole edges, in which spheres that the rays meet may lie
  const double reach = this->Length + this->LargestRadius;
  std::array<int, 3> first{}, last{};
  for (int q = 0; q < 3; ++q)
  {
    if (this->Box.Periodic[q])
    {
      const double edge = this->Box.Size[q], from = fan.Centre[q] - this->Box.Origin[q];
      first[q] = static_cast<int>(std::floor((from - reach) / edge));
      last[q] = static_cast<int>(std::floor((from + reach) / edge));
    }
  }
  for (int i = first[0]; i <= last[0]; ++i)
  {
    for (int j = first[1]; j <= last[1]; ++j)
    {
      for (int k = first[2]; k <= last[2]; ++k)
      {
        this->FindHitsOfImage(
          fan, { i * this->Box.Size[0], j * this->Box.Size[1], k * this->Box.Size[2] }, hits);
      }
    }
  }
}

void FanTracer::FindHitsOfImage(
  const RayFan& fan, const Vector3& shift, std::vector<RayHit>& hits) const
{
  const Vector3 from = { fan.Centre[0] - shift[0], fan.Centre[1] - shift[1],
    fan.Centre[2] - shift[2] };
  const Vector3 &u = fan.U, &v = fan.V, &n = fan.Normal;
  const int rays = this->Rays.Size();
  this->Cells.ForEachNearDisc(from, n, this->Length, this->LargestRadius,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t place = begin; place < end; ++place)
      {
        const double x = this->Cells.X[place] - from[0], y = this->Cells.Y[place] - from[1],
                     z = this->Cells.Z[place] - from[2];
        const double height = x * n[0] + y * n[1] + z * n[2];
        if (std::abs(height) >= this->LargestRadius)
        {
          continue;
        }
        const std::uint32_t sphere = this->Cells.Index[place];
        const double radius = this->Pack.Radius[sphere];
        // The sphere cuts the plane of the rays in a circle
        const double circle2 = radius * radius - height * height;
        const double alongU = x * u[0] + y * u[1] + z * u[2];
        const double alongV = x * v[0] + y * v[1] + z * v[2];
        for (int ray = 0; ray < rays && circle2 > 0.0; ++ray)
        {
          const double c = this->Rays.Cosine[ray], s = this->Rays.Sine[ray];
          const double across = alongV * c - alongU * s;
          const double half2 = circle2 - across * across;
          if (half2 > 0.0)
          {
            const double middle = alongU * c + alongV * s, half = std::sqrt(half2);
            if (middle + half > 0.0 && middle - half < this->Length)
            {
              hits.push_back(
                { ray, { middle - half, middle + half, this->Pack.Mode[sphere] - 1 } });
            }
          }
        }
      }
    });
}
}
