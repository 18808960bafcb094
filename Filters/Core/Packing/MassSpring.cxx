// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Packing/MassSpring.h"

#include "ruc/Packing/OverlapRemoval.h"
#include "ruc/Particles/CellList.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace ruc
{
namespace
{
// The rest length of the springs, in contacts
constexpr double Rest = 1.0 + 1e-4;

class Masses
{
public:
  Masses(SpherePack& pack, const Window& box)
    : Pack(pack)
    , Box(box)
    , Skin(0.3 * (pack.Empty() ? 0.0 : *std::min_element(pack.Radius.begin(), pack.Radius.end())))
    , Centres(CentresOf(pack))
    , Velocity(3 * pack.Size(), 0.0)
    , Force(3 * pack.Size(), 0.0)
  {
    this->ListSprings();
  }

  /** Finds the forces at the present places, and returns whether any two spheres overlap. */
  bool FindForces()
  {
    if (this->LargestMove() > 0.5 * this->Skin)
    {
      this->ListSprings();
    }
    std::fill(this->Force.begin(), this->Force.end(), 0.0);
    bool overlap = false;
    for (const Spring& spring : this->Springs)
    {
      const double* a = &this->Centres[3 * spring.First];
      const double* b = &this->Centres[3 * spring.Second];
      const double dx = b[0] + spring.Image[0] - a[0], dy = b[1] + spring.Image[1] - a[1],
                   dz = b[2] + spring.Image[2] - a[2];
      const double d2 = dx * dx + dy * dy + dz * dz;
      const double rest = Rest * spring.Contact;
      if (d2 < rest * rest)
      {
        const double d = std::sqrt(d2);
        overlap = overlap || d < spring.Contact;
        const double push = (rest - d) / std::max(d, std::numeric_limits<double>::min());
        const double force[3] = { push * dx, push * dy, push * dz };
        for (int q = 0; q < 3; ++q)
        {
          this->Force[3 * spring.First + q] -= force[q];
          this->Force[3 * spring.Second + q] += force[q];
        }
      }
    }
    return overlap;
  }

  void Step()
  {
    double power = 0.0, speed2 = 0.0, force2 = 0.0;
    for (std::size_t k = 0; k < this->Force.size(); ++k)
    {
      power += this->Force[k] * this->Velocity[k];
      speed2 += this->Velocity[k] * this->Velocity[k];
      force2 += this->Force[k] * this->Force[k];
    }
    // The constants are those of the publication. A mass with twelve springs is stable with this
    // step.
    if (power > 0.0)
    {
      this->Turn *= ++this->StepsDownhill > 5 ? 0.99 : 1.0;
      this->TimeStep =
        this->StepsDownhill > 5 ? std::min(1.1 * this->TimeStep, LongestStep) : this->TimeStep;
    }
    else
    {
      this->StepsDownhill = 0;
      this->Turn = FirstTurn;
      this->TimeStep *= 0.5;
    }
    const double kept = power > 0.0 ? 1.0 - this->Turn : 0.0;
    const double turned =
      power > 0.0 && force2 > 0.0 ? this->Turn * std::sqrt(speed2 / force2) : 0.0;
    for (std::size_t k = 0; k < this->Force.size(); ++k)
    {
      this->Velocity[k] = kept * this->Velocity[k] + (turned + this->TimeStep) * this->Force[k];
      this->Centres[k] += this->TimeStep * this->Velocity[k];
    }
  }

  SpherePack Wrapped() const
  {
    SpherePack pack = this->Pack;
    SetCentres(pack, this->Box, this->Centres.data());
    return pack;
  }

private:
  static constexpr double LongestStep = 0.5, FirstTurn = 0.1;

  // Two spheres that are nearer to each other than contact and skin, with the shift to that image
  // of the second
  struct Spring
  {
    std::uint32_t First, Second;
    double Contact;
    Vector3 Image;
  };

  double LargestMove() const
  {
    double largest = 0.0;
    for (std::size_t k = 0; k < this->Centres.size(); k += 3)
    {
      const double dx = this->Centres[k] - this->Listed[k],
                   dy = this->Centres[k + 1] - this->Listed[k + 1],
                   dz = this->Centres[k + 2] - this->Listed[k + 2];
      largest = std::max(largest, dx * dx + dy * dy + dz * dz);
    }
    return std::sqrt(largest);
  }

  void ListSprings()
  {
    this->Listed = this->Centres;
    this->Springs.clear();
    const SpherePack pack = this->Wrapped();
    const CellList cells(pack, this->Box, SizeClasses(pack.Radius, this->Skin, Rest));
    cells.ForEachPair(
      [&](std::uint32_t p, std::uint32_t q, double dx, double dy, double dz, double d2)
      {
        const double contact = pack.Radius[p] + pack.Radius[q];
        const double reach = Rest * contact + this->Skin;
        if (d2 < reach * reach)
        {
          const double* a = &this->Centres[3 * std::size_t(p)];
          const double* b = &this->Centres[3 * std::size_t(q)];
          this->Springs.push_back(
            { p, q, contact, { dx - (b[0] - a[0]), dy - (b[1] - a[1]), dz - (b[2] - a[2]) } });
        }
      });
  }

  const SpherePack& Pack;
  const Window& Box;
  double Skin;
  std::vector<double> Centres; // not wrapped, as they move
  std::vector<double> Listed;  // the centres when the springs were listed
  std::vector<Spring> Springs;
  std::vector<double> Velocity, Force;
  double TimeStep = 0.1;
  double Turn = FirstTurn;
  int StepsDownhill = 0;
};
}

int MoveBySprings(
  SpherePack& pack, const Window& box, int maximumSteps, const std::function<bool()>& carryOn)
{
  if (pack.Empty())
  {
    return 0;
  }
  WrapIntoBox(pack, box);
  Masses masses(pack, box);
  int steps = 0;
  while (masses.FindForces() && steps < maximumSteps && ((steps + 1) % 10 != 0 || carryOn()))
  {
    masses.Step();
    ++steps;
  }
  pack = masses.Wrapped();
  return steps;
}

bool MoveBySpringsUntilFree(
  SpherePack& pack, const Window& box, std::uint32_t seed, const std::function<bool()>& carryOn)
{
  constexpr int stepsInGeneral = 2000;
  MoveBySprings(pack, box, stepsInGeneral, carryOn);
  return RemoveOverlap(pack, box, seed, carryOn);
}
}
