// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Packing/HardSpheres.h"

#include "ruc/Base/Random.h"

#include <algorithm>

namespace ruc
{
// Whether a sphere with this radius would fit where sphere i is
bool HardSpheres::MayTake(int i, double radius, int except) const
{
  const Vector3& place = this->Spheres[i].Place;
  for (int q = 0; q < 3; ++q)
  {
    const double low = place[q] - this->Box.Origin[q];
    if (!this->Box.Periodic[q] && std::min(low, this->Box.Size[q] - low) < radius)
    {
      return false;
    }
  }
  return std::all_of(this->Near[i].begin(), this->Near[i].end(),
    [&](int k)
    {
      const Vector3 d = this->Between(place, this->Spheres[k].Place);
      const double contact = radius + this->RadiusAt(this->Spheres[k], this->Time);
      return k == except || Dot(d, d) >= contact * contact * (1.0 + 1e-14);
    });
}

// The lists stay valid, for what a radius gains is taken from the room in them
void HardSpheres::ExchangeRadii()
{
  const int spheres = static_cast<int>(this->Spheres.size());
  RandomSequence random(this->Chosen.Seed, RandomStream::Exchange, this->Exchanges++);
  for (int tries = 4 * spheres; tries > 0; --tries)
  {
    int i = random.NextIndex(spheres), j = random.NextIndex(spheres);
    if (this->Spheres[i].Radius > this->Spheres[j].Radius)
    {
      std::swap(i, j);
    }
    Sphere &small = this->Spheres[i], &large = this->Spheres[j];
    const double gain = large.Final - small.Final;
    if (i == j || !(gain > 0.0) || gain > 0.5 * this->Room[i] ||
      !this->MayTake(i, this->RadiusAt(large, this->Time), j))
    {
      continue;
    }
    // Where the two are near each other, both change
    const Vector3 d = this->Between(small.Place, large.Place);
    const double contact = this->RadiusAt(small, this->Time) + this->RadiusAt(large, this->Time);
    if (Dot(d, d) < contact * contact)
    {
      continue;
    }
    std::swap(small.Radius, large.Radius);
    std::swap(small.Growth, large.Growth);
    std::swap(small.Final, large.Final);
    this->Room[i] -= gain;
  }
}
}
