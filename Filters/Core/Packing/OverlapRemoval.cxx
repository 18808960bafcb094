// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Packing/OverlapRemoval.h"

#include "ruc/Base/Random.h"
#include "ruc/Particles/Contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

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

// With enlarged contacts the search ends at a point where the true ones are free. Near jamming
// there is room for less enlargement.
constexpr double Enlargements[] = { 1e-4, 1e-5, 1e-6, 1e-4, 1e-5, 1e-6, 1e-5, 1e-6, 1e-5, 1e-6 };
constexpr auto Attempts = static_cast<std::uint32_t>(std::size(Enlargements));
constexpr std::uint32_t AttemptsUnshaken = 3;
constexpr int MaximumIterations = 4000, IterationsBetweenStates = 50;

using Saving = std::function<void(const OverlapRemovalState&)>;

// Descends until no two spheres overlap or nothing is to be gained. Returns whether the caller
// wants to go on.
bool PushApart(SpherePack& pack, const Window& box, OverlapRemovalState state,
  const std::function<bool()>& carryOn, const Saving& save)
{
  int evaluations = 0;
  DescentSettings settings;
  settings.FirstStep = pack.LargestRadius(); // of all spheres together
  const double reach = 1.0 + Enlargements[state.Attempt];
  bool free = false, stopped = false;
  Descend(
    state.Descent, settings,
    [&](const double* place, double* gradient, double& value)
    {
      SetCentres(pack, box, place);
      const ContactEnergy energy = FindContactEnergy(pack, box, reach, gradient);
      free = energy.Free;
      value = energy.Value;
      stopped = ++evaluations % 10 == 0 && !carryOn();
      return !stopped;
    },
    [&](const DescentState& now)
    {
      const bool goesOn = !free && now.Iterations < MaximumIterations;
      if (goesOn && save && now.Iterations % IterationsBetweenStates == 0)
      {
        save(state);
      }
      return goesOn;
    });
  if (stopped && save && !state.Descent.Gradient.empty())
  {
    save(state);
  }
  SetCentres(pack, box, state.Descent.Place.data());
  return !stopped;
}
}

void OverlapRemovalState::Check(std::size_t spheres) const
{
  const auto isOfAll = [&](const std::vector<double>& numbers)
  {
    return numbers.size() == 3 * spheres &&
      std::all_of(numbers.begin(), numbers.end(), [](double q) { return std::isfinite(q); });
  };
  const auto areOfAll = [&](const std::vector<std::vector<double>>& all) {
    return all.size() <= DescentSettings().Memory && std::all_of(all.begin(), all.end(), isOfAll);
  };
  const DescentState& descent = this->Descent;
  const bool good = this->Attempt < Attempts && isOfAll(descent.Place) &&
    isOfAll(descent.Gradient) && descent.Value > 0.0 && std::isfinite(descent.Value) &&
    descent.Iterations >= 0 && descent.Iterations < MaximumIterations && areOfAll(descent.Steps) &&
    areOfAll(descent.GradientChanges) && descent.Steps.size() == descent.GradientChanges.size();
  if (!good)
  {
    throw std::invalid_argument("The checkpoint is damaged: it holds a value that cannot be.");
  }
}

bool RemoveOverlap(SpherePack& pack, const Window& box, std::uint32_t seed,
  const std::function<bool()>& carryOn, const OverlapRemovalState* resume, const Saving& save)
{
  WrapIntoBox(pack, box);
  bool goesOn = true;
  for (std::uint32_t attempt = resume ? resume->Attempt : 0; attempt < Attempts; ++attempt)
  {
    if (resume)
    {
      goesOn = PushApart(pack, box, *std::exchange(resume, nullptr), carryOn, save);
      continue;
    }
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
    OverlapRemovalState state;
    state.Attempt = attempt;
    state.Descent.Place = CentresOf(pack);
    goesOn = PushApart(pack, box, std::move(state), carryOn, save);
  }
  return IsFree(pack, box);
}
}
