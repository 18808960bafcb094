// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/ContactMultipliers.h"

#include "ruc/Particles/Contacts.h"
#include "ruc/Reconstruction/NearPairs.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ruc
{
namespace
{
// Pairs up to this many contacts are listed, which holds until a sphere has gone the last of these
// parts of its radius
constexpr double NearReach = 1.25, MostGone = 0.2;
}

bool ContactState::CanBe(int spheres) const
{
  bool can = this->Stiffness >= 0.0 && this->Stiffness <= 1e30 && this->Round >= 0 &&
    this->Deepest >= 0.0 && this->First.size() == this->Second.size() &&
    this->First.size() == this->Multiplier.size();
  for (std::size_t n = 0; can && n < this->First.size(); ++n)
  {
    can = this->First[n] >= 0 && this->First[n] < this->Second[n] &&
      this->Second[n]<spheres&& this->Multiplier[n]> 0.0 && std::isfinite(this->Multiplier[n]);
  }
  return can;
}

ContactMultipliers::ContactMultipliers(
  const SpherePack& spheres, const Window& box, ContactState& state)
  : Spheres(spheres)
  , Box(box)
  , State(state)
{
}

void ContactMultipliers::FindNear(const double* centres)
{
  this->ListedAt.assign(centres, centres + 3 * this->Spheres.Size());
  SetCentres(this->Spheres, this->Box, centres);
  this->Near.clear();
  ForEachContact(this->Spheres, this->Box, NearReach,
    [&](std::size_t i, std::size_t j, double, double, double, double)
    {
      const auto a = static_cast<std::int32_t>(std::min(i, j));
      const auto b = static_cast<std::int32_t>(std::max(i, j));
      this->Near.push_back({ a, b, 0.0 });
    });
  // With those that press, wherever they have gone
  for (std::size_t n = 0; n < this->State.First.size(); ++n)
  {
    this->Near.push_back(
      { this->State.First[n], this->State.Second[n], this->State.Multiplier[n] });
  }
  const auto key = [](const Pair& pair) { return std::tie(pair.First, pair.Second); };
  std::sort(this->Near.begin(), this->Near.end(),
    [&](const Pair& a, const Pair& b)
    { return key(a) != key(b) ? key(a) < key(b) : a.Multiplier > b.Multiplier; });
  this->Near.erase(std::unique(this->Near.begin(), this->Near.end(),
                     [&](const Pair& a, const Pair& b) { return key(a) == key(b); }),
    this->Near.end());
}

// Calls visit(pair, d, distance, contact) for all listed pairs; d leads from the first to the
// nearest image of the second
template <class Visit>
void ContactMultipliers::ForEach(const double* centres, Visit&& visit)
{
  if (this->ListedAt.empty() || HaveGone(centres, this->ListedAt, this->Spheres.Radius, MostGone))
  {
    this->FindNear(centres);
  }
  for (Pair& pair : this->Near)
  {
    Vector3 d;
    for (int q = 0; q < 3; ++q)
    {
      d[q] = centres[3 * pair.Second + q] - centres[3 * pair.First + q];
      d[q] -= this->Box.Size[q] * std::nearbyint(d[q] / this->Box.Size[q]);
    }
    visit(pair, d, Length(d), this->Spheres.Radius[pair.First] + this->Spheres.Radius[pair.Second]);
  }
}

double ContactMultipliers::Add(const double* centres, double* gradient)
{
  const double stiffness = this->State.Stiffness;
  double sum = 0.0;
  this->ForEach(centres,
    [&](const Pair& pair, const Vector3& d, double distance, double contact)
    {
      const double c = distance / contact - 1.0 - Margin;
      const double force = std::max(0.0, pair.Multiplier - stiffness * c);
      sum += (force * force - pair.Multiplier * pair.Multiplier) / (2.0 * stiffness);
      if (force > 0.0 && gradient)
      {
        const double scale =
          force / (contact * std::max(distance, std::numeric_limits<double>::min()));
        for (int q = 0; q < 3; ++q)
        {
          gradient[3 * pair.First + q] += scale * d[q];
          gradient[3 * pair.Second + q] -= scale * d[q];
        }
      }
    });
  return sum;
}

double ContactMultipliers::Update(const double* centres)
{
  double deepest = 0.0;
  this->State.First.clear();
  this->State.Second.clear();
  this->State.Multiplier.clear();
  this->ForEach(centres,
    [&](Pair& pair, const Vector3&, double distance, double contact)
    {
      const double c = distance / contact - 1.0 - Margin;
      deepest = std::max(deepest, -c);
      pair.Multiplier = std::max(0.0, pair.Multiplier - this->State.Stiffness * c);
      if (pair.Multiplier > 0.0)
      {
        this->State.First.push_back(pair.First);
        this->State.Second.push_back(pair.Second);
        this->State.Multiplier.push_back(pair.Multiplier);
      }
    });
  return deepest;
}
}
