// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Packing/EventQueue.h"
#include "ruc/Packing/HardSphereState.h"
#include "ruc/Packing/PlaceGrid.h"
#include "ruc/Packing/SphereRooms.h"
#include "ruc/Particles/SpherePack.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace ruc
{
/**
 * Hard spheres that fly, collide and grow: the event-driven molecular dynamics of Lubachevsky and
 * Stillinger (J. Stat. Phys. 60, 561, 1990), with a list of near spheres for each sphere (Donev,
 * Torquato and Stillinger, J. Comput. Phys. 202, 737, 2005). No two spheres overlap at any time.
 *
 * All spheres have the mass 1, and kT is set to 1 every 50 collisions of a sphere. The unit of
 * length of the motion is the mean diameter. Faces of the box that are not periodic are hard
 * walls. The motion goes on one thread and depends on the arguments alone.
 */
class HardSpheres
{
public:
  struct Settings
  {
    std::uint32_t Seed = 1;
    /**
     * Whether spheres of nearly the same size exchange their radii where the larger fits into the
     * place of the smaller. It lets packs of many sizes get denser, and every state that it passes
     * through is a state of hard spheres.
     */
    bool Exchange = false;
  };

  /**
   * So much more than their radii spheres should grow that no distance rounds to less than their
   * contact, in a box of 100 diameters and with 17 digits in a file.
   */
  static constexpr double Spare = 1e-10;

  enum class End
  {
    Done,
    Jammed, // the spheres can grow no further
    Stopped
  };

  /**
   * Begins with a pack in which nothing overlaps. Throws std::invalid_argument unless every
   * periodic edge is longer than SphereRooms::LeastEdgeInDiameters times the largest diameter of
   * `pack` and of what it is to grow to.
   */
  HardSpheres(
    const SpherePack& pack, const Window& box, double largestGrowth, const Settings& settings);

  /** Begins where GetState was called. Throws std::invalid_argument for what can be no state. */
  HardSpheres(const HardSphereState& state, const Window& box, const Settings& settings);

  /**
   * Lets all radii grow in proportion to `growth` times what they are, at the rate `rate`: that
   * much of a diameter in the unit of time. It is Jammed where the spheres collide without growing.
   */
  End Grow(double growth, double rate, const std::function<bool()>& carryOn);
  /** Lets the spheres collide, without growing, `collisions` times each on average. */
  End Equilibrate(double collisions, const std::function<bool()>& carryOn);
  /** Goes on with the Grow or Equilibrate in which GetState was called. */
  End Resume(const std::function<bool()>& carryOn);

  /** Whether a round has just ended: only then `carryOn` may call GetState. */
  bool IsBetweenRounds() const { return this->BetweenRounds; }
  HardSphereState GetState() const;

  /** The spheres as they are, in the order in which they were given, wrapped into the box. */
  SpherePack GetPack() const;
  /** The factor by which the radii have grown since the beginning. */
  double GetGrowth() const { return this->Growth * (1.0 + this->GrowthRate * this->Time); }
  std::int64_t GetCollisions() const { return this->Collisions; }
  /** The collisions of a sphere since the beginning, on average. */
  double CollisionsOfSphere() const
  {
    return 2.0 * this->Collisions / static_cast<double>(this->Spheres.size());
  }
  /**
   * P V / (N k T) over the last 50 collisions of a sphere, by the virial of the collisions; 1
   * before there were any.
   */
  double ReducedPressure() const { return this->Pressure; }
  /** Half of the squares of the velocities of all spheres, in squares of the unit of length. */
  double KineticEnergy() const;

private:
  using Sphere = FlyingSphere;

  double RadiusAt(const Sphere& sphere, double time) const
  {
    return sphere.Radius + sphere.Growth * time;
  }
  // From a to b, whose images are as near as can be
  Vector3 Between(const Vector3& a, const Vector3& b) const
  {
    constexpr double Rounding = 0x1.8p52; // added and taken away it rounds, quicker than nearbyint
    Vector3 d;
    for (int q = 0; q < 3; ++q)
    {
      d[q] = b[q] - a[q];
      d[q] -= this->Period[q] * (d[q] * this->Inverse[q] + Rounding - Rounding);
    }
    return d;
  }

  void SetVelocities();
  void SetTemperature();
  void MoveTo(int i, double time);
  void MoveAllTo(double time);
  void Place(int i);
  void List(int i);
  void Unlist(int i);
  double Predict(int i);
  void PredictWalls(int i, double& time);
  void PredictAgain(int i);
  void PredictAll();
  void Collide(int i, int j);
  void Bounce(int i, int face);
  void ExchangeRadii();
  bool MayTake(int i, double radius, int except) const;
  void Begin(double end, double collisions);
  bool BeginRound();
  End Run(const std::function<bool()>& carryOn);
  void HandleEvent(int i, double time);
  End Finish(End end);
  void FindPressure(double time);
  bool IsJammed() const;

  Window Box;
  Vector3 Period, Inverse; // the periodic edges, or 0, and their inverses
  Settings Chosen;
  double Unit;    // of length
  double Degrees; // of freedom
  std::vector<Sphere> Spheres;
  SphereRooms Rooms;
  std::vector<double> Room;    // how far each sphere may go from where it was listed
  std::vector<double> Reach;   // of each ball of PlaceGrid
  std::vector<Vector3> Listed; // where each sphere was listed
  std::vector<std::vector<int>> Near;
  PlaceGrid Grid;
  EventQueue Queue;
  std::vector<int> Partner;      // of the next event; LeavesPlace, or HitsWall - face
  std::vector<int> Count, Stamp; // collisions of each sphere, and of its partner when it was found
  double Time = 0.0, Growth = 1.0, GrowthRate = 0.0;
  double Virial = 0.0, Pressure = 1.0;
  std::int64_t Collisions = 0;
  std::uint64_t Exchanges = 0; // rounds of them
  HardSphereCourse Course;
  bool BetweenRounds = false;
};
}
