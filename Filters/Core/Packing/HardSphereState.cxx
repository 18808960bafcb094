// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Packing/HardSphereState.h"

#include "ruc/Packing/HardSpheres.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace ruc
{
namespace
{
bool AreFinite(const Vector3& v)
{
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

bool IsPermutation(std::vector<int> order)
{
  std::sort(order.begin(), order.end());
  for (std::size_t n = 0; n < order.size(); ++n)
  {
    if (order[n] != static_cast<int>(n))
    {
      return false;
    }
  }
  return true;
}

// Whether spheres are near to others, and these to them
bool AreMutual(const std::vector<std::vector<int>>& near)
{
  std::vector<std::pair<int, int>> there, back;
  const int spheres = static_cast<int>(near.size());
  for (int i = 0; i < spheres; ++i)
  {
    for (int j : near[i])
    {
      if (j < 0 || j >= spheres || j == i)
      {
        return false;
      }
      there.emplace_back(i, j);
      back.emplace_back(j, i);
    }
  }
  std::sort(there.begin(), there.end());
  std::sort(back.begin(), back.end());
  return there == back;
}

[[noreturn]] void FailDamaged()
{
  throw std::invalid_argument("The state of the spheres is damaged or of another pack.");
}

// The spheres as large as they are to be, whose rooms are those of the state
SpherePack FinalPack(const HardSphereState& state)
{
  state.Check(state.Spheres.size());
  SpherePack pack;
  for (const FlyingSphere& sphere : state.Spheres)
  {
    pack.X.push_back(sphere.Place[0]);
    pack.Y.push_back(sphere.Place[1]);
    pack.Z.push_back(sphere.Place[2]);
    pack.Radius.push_back(sphere.Final);
  }
  return pack;
}
}

void HardSphereState::Check(std::size_t spheres) const
{
  bool good = this->Spheres.size() == spheres && this->Room.size() == spheres &&
    this->Reach.size() == spheres && this->Listed.size() == spheres &&
    this->Near.size() == spheres && this->Order.size() == spheres && IsPermutation(this->Order) &&
    AreMutual(this->Near) && this->Unit > 0.0 && std::isfinite(this->Unit) &&
    std::isfinite(this->Time) && this->Growth > 0.0 && std::isfinite(this->Growth) &&
    this->GrowthRate >= 0.0 && this->GrowthRate <= 1.0 && this->Collisions >= 0 &&
    this->Collisions < std::int64_t(1) << 60;
  for (std::size_t i = 0; i < spheres && good; ++i)
  {
    const FlyingSphere& sphere = this->Spheres[i];
    const bool larger = this->Reach[i] >= sphere.Final && std::isfinite(this->Reach[i]);
    good = AreFinite(sphere.Place) && AreFinite(sphere.Velocity) && AreFinite(this->Listed[i]) &&
      std::isfinite(sphere.Time) && std::isfinite(sphere.Growth) && sphere.Radius > 0.0 &&
      sphere.Radius <= sphere.Final * (1.0 + 1e-9) && larger && std::isfinite(this->Room[i]);
  }
  if (!good)
  {
    FailDamaged();
  }
}

HardSpheres::HardSpheres(const HardSphereState& state, const Window& box, const Settings& settings)
  : HardSpheres(FinalPack(state), box, 1.0, settings)
{
  const double most = this->Rooms.Greatest + this->Rooms.Of(this->Rooms.Greatest);
  if (std::any_of(
        state.Reach.begin(), state.Reach.end(), [&](double reach) { return reach > most; }))
  {
    FailDamaged();
  }
  this->Spheres = state.Spheres;
  this->Room = state.Room;
  this->Reach = state.Reach;
  this->Listed = state.Listed;
  this->Near = state.Near;
  for (int i : state.Order)
  {
    this->Grid.Put(i, this->Listed[i], this->Reach[i]);
  }
  this->Unit = state.Unit;
  this->Time = state.Time;
  this->Growth = state.Growth;
  this->GrowthRate = state.GrowthRate;
  this->Pressure = state.Pressure;
  this->Collisions = state.Collisions;
  this->Exchanges = state.Exchanges;
  this->Course = state.Course;
}

HardSphereState HardSpheres::GetState() const
{
  return { this->Spheres, this->Room, this->Reach, this->Listed, this->Near, this->Grid.GetOrder(),
    this->Unit, this->Time, this->Growth, this->GrowthRate, this->Pressure, this->Collisions,
    this->Exchanges, this->Course };
}
}
