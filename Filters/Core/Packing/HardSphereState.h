// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Window/Window.h"

#include <cstdint>
#include <tuple>
#include <vector>

namespace ruc
{
/** A sphere of HardSpheres. */
struct FlyingSphere
{
  Vector3 Place, Velocity; // the place at its own time
  double Time;             // since the growth began
  double Radius, Growth;   // at time 0, and in the unit of time
  double Final;            // the largest radius that it may grow to

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Place, self.Velocity, self.Time, self.Radius, self.Growth, self.Final);
  }
};

/** How far a motion of HardSpheres goes, and where it is. */
struct HardSphereCourse
{
  double End = 0.0;              // the time at which it ends,
  double Last = 0.0;             // or the number of collisions
  double Before = 0.0;           // when the round began
  std::int64_t NextExchange = 0; // at this number of collisions

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.End, self.Last, self.Before, self.NextExchange);
  }
};

/**
 * The whole state of HardSpheres between two rounds of collisions, from which the motion goes on to
 * the same end, bit by bit.
 */
struct HardSphereState
{
  std::vector<FlyingSphere> Spheres;
  std::vector<double> Room, Reach; // see HardSpheres
  std::vector<Vector3> Listed;
  std::vector<std::vector<int>> Near;
  std::vector<int> Order; // PlaceGrid::GetOrder
  double Unit = 0.0, Time = 0.0, Growth = 0.0, GrowthRate = 0.0, Pressure = 0.0;
  std::int64_t Collisions = 0;
  std::uint64_t Exchanges = 0;
  HardSphereCourse Course;

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Spheres, self.Room, self.Reach, self.Listed, self.Near, self.Order,
      self.Unit, self.Time, self.Growth, self.GrowthRate, self.Pressure, self.Collisions,
      self.Exchanges, self.Course);
  }

  /** Throws std::invalid_argument unless it can be a state of so many spheres. */
  void Check(std::size_t spheres) const;
};
}
