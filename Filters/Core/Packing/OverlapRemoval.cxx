// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Packing/OverlapRemoval.h"

#include "ruc/Base/Descent.h"
#include "ruc/Base/Random.h"
#include "ruc/Particles/Contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ruc
{
namespace
{
// The sum of (reach (a + b) - d)+^2 over the pairs of a wrapped pack; FindContactEnergy also gives
// its gradient with respect to the centres
struct ContactEnergy
{
  double Value = 0.0;
  bool Free = true; // whether no two spheres overlap
};

const std::vector<double>& CoordinatesAlong(const SpherePack& pack, int axis)
{
  return axis == 0 ? pack.X : axis == 1 ? pack.Y : pack.Z;
}

// Adds what the two walls across an axis add: the sum of (reach a - distance)+^2
void AddWalls(const SpherePack& pack, const Window& box, int axis, double reach,
  ContactEnergy& energy, double* gradient)
{
  const std::vector<double>& along = CoordinatesAlong(pack, axis);
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    const double low = along[i] - box.Origin[axis], high = box.Size[axis] - low;
    for (double distance : { low, high })
    {
      const double overlap = reach * pack.Radius[i] - distance;
      if (overlap > 0.0)
      {
        energy.Free = energy.Free && distance >= pack.Radius[i];
        energy.Value += overlap * overlap;
        gradient[3 * i + axis] += distance == low ? -2.0 * overlap : 2.0 * overlap;
      }
    }
  }
}

ContactEnergy FindContactEnergy(
  const SpherePack& pack, const Window& box, double reach, double* gradient)
{
  ContactEnergy energy;
  std::fill_n(gradient, 3 * pack.Size(), 0.0);
  ForEachContact(pack, box, reach,
    [&](std::size_t i, std::size_t j, double dx, double dy, double dz, double d)
    {
      const double contact = pack.Radius[i] + pack.Radius[j];
      const double overlap = reach * contact - d;
      energy.Free = energy.Free && d >= contact;
      energy.Value += overlap * overlap;
      const double pull = 2.0 * overlap / std::max(d, std::numeric_limits<double>::min());
      const double difference[3] = { dx, dy, dz };
      for (int q = 0; q < 3; ++q)
      {
        gradient[3 * i + q] += pull * difference[q];
        gradient[3 * j + q] -= pull * difference[q];
      }
    });
  for (int q = 0; q < 3; ++q)
  {
    if (!box.Periodic[q])
    {
      AddWalls(pack, box, q, reach, energy, gradient);
    }
  }
  return energy;
}

// Whether no two spheres overlap, and none a wall
bool IsFree(const SpherePack& pack, const Window& box)
{
  for (int q = 0; q < 3; ++q)
  {
    const std::vector<double>& along = CoordinatesAlong(pack, q);
    for (std::size_t i = 0; i < pack.Size() && !box.Periodic[q]; ++i)
    {
      const double low = along[i] - box.Origin[q];
      if (std::min(low, box.Size[q] - low) < pack.Radius[i])
      {
        return false;
      }
    }
  }
  return MeasureOverlap(pack, box).IsNone();
}

// Moves every sphere by up to half the smallest radius along each axis
void Shake(SpherePack& pack, const Window& box, std::uint32_t seed, std::uint32_t attempt)
{
  const double smallest = *std::min_element(pack.Radius.begin(), pack.Radius.end());
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    const std::array<double, 3> u = UniformTriple(seed, RandomStream::Shaking, i, attempt);
    pack.X[i] += smallest * (u[0] - 0.5);
    pack.Y[i] += smallest * (u[1] - 0.5);
    pack.Z[i] += smallest * (u[2] - 0.5);
  }
  WrapIntoBox(pack, box);
}

// Descends until no two spheres overlap or nothing is to be gained. Returns whether the caller
// wants to go on.
bool PushApart(
  SpherePack& pack, const Window& box, double reach, const std::function<bool()>& carryOn)
{
  constexpr int MaximumIterations = 4000;
  int evaluations = 0;
  DescentState state;
  state.Place = CentresOf(pack);
  DescentSettings settings;
  settings.FirstStep = pack.LargestRadius(); // of all spheres together
  bool free = false, stopped = false;
  Descend(
    state, settings,
    [&](const double* place, double* gradient, double& value)
    {
      SetCentres(pack, box, place);
      const ContactEnergy energy = FindContactEnergy(pack, box, reach, gradient);
      free = energy.Free;
      value = energy.Value;
      stopped = ++evaluations % 10 == 0 && !carryOn();
      return !stopped;
    },
    [&](const DescentState& now) { return !free && now.Iterations < MaximumIterations; });
  SetCentres(pack, box, state.Place.data());
  return !stopped;
}
}

bool RemoveOverlap(
  SpherePack& pack, const Window& box, std::uint32_t seed, const std::function<bool()>& carryOn)
{
  // With enlarged contacts the search ends at a point where the true ones are free. Near jamming
  // there is room for less enlargement.
  constexpr double Enlargements[] = { 1e-4, 1e-5, 1e-6, 1e-4, 1e-5, 1e-6, 1e-5, 1e-6, 1e-5, 1e-6 };
  constexpr std::uint32_t AttemptsUnshaken = 3;
  WrapIntoBox(pack, box);
  bool goesOn = true;
  std::uint32_t attempt = 0;
  for (double enlargement : Enlargements)
  {
    if (IsFree(pack, box))
    {
      return true;
    }
    if (!goesOn)
    {
      return false;
    }
    if (attempt >= AttemptsUnshaken) // jammed
    {
      Shake(pack, box, seed, attempt);
    }
    ++attempt;
    goesOn = PushApart(pack, box, 1.0 + enlargement, carryOn);
  }
  return IsFree(pack, box);
}
}
