// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Packing/DensePack.h"

#include "ruc/Base/Random.h"
#include "ruc/Base/Require.h"
#include "ruc/Packing/HardSpheres.h"
#include "ruc/Packing/MaximumFraction.h"
#include "ruc/Packing/OverlapRemoval.h"
#include "ruc/Particles/SphereOverlap.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ruc
{
namespace
{
constexpr double SlowestRate = 0.001, Shrinking = 0.98, Slowing = 1.0 / 3.0;

// The slower the growth, the denser are the packs in which it jams
double RateFor(double share)
{
  return share <= 0.95 ? 0.1 : share <= 0.985 ? 0.02 : share <= 1.0 ? 0.01 : 0.003;
}

void Scale(SpherePack& pack, double radii)
{
  for (double& r : pack.Radius)
  {
    r *= radii;
  }
}

class Packer
{
public:
  using Progress = std::function<bool(const GrowthStep&, double)>;

  Packer(const DensePackSettings& settings, const Progress& carryOn)
    : Settings(settings)
    , CarryOn(carryOn)
  {
    this->Result.MaximumFraction = MaximumRandomFraction(settings.Radii);
    this->Result.Box = this->MakeBox();
    this->Check();
  }

  DensePack Run()
  {
    const double share = this->Settings.Fraction / this->Result.MaximumFraction;
    const bool soft = this->Settings.Protocol == PackingProtocol::Soft ||
      (this->Settings.Protocol == PackingProtocol::Automatic && share <= SoftShare);
    this->Result.IsSoft = soft;
    this->Reached = soft ? this->Settings.Fraction : this->FractionOfStart();
    bool free = this->Begin();
    for (; !free && !soft && !this->Result.Stopped && this->Reached > 0.01; free = this->Begin())
    {
      this->Reached *= 0.9;
    }
    if (!free)
    {
      this->Result.Jammed = !this->Result.Stopped;
      this->Result.Pack = {};
      return std::move(this->Result);
    }
    if (!soft)
    {
      this->Grow(this->Settings.Rate > 0.0 ? this->Settings.Rate : RateFor(share));
    }
    if (!this->Result.Jammed && !this->Result.Stopped && this->Settings.Equilibration > 0.0)
    {
      this->Equilibrate();
    }
    this->Finish();
    return std::move(this->Result);
  }

private:
  // Returns whether there is a pack of the fraction Reached
  bool Begin()
  {
    this->PutAtRandom();
    const GrowthStep step = { 0.0, this->Reached, 1.0, 0.0 };
    return this->Tell(step, 0.0) &&
      RemoveOverlap(this->Result.Pack, this->Result.Box, this->Settings.Seed,
        [&]() { return this->Tell(step, 0.0); });
  }

  Window MakeBox() const
  {
    double volume = 0.0;
    for (double r : this->Settings.Radii)
    {
      volume += SphereVolume(r);
    }
    const Vector3& p = this->Settings.Proportions;
    for (double proportion : p)
    {
      Require(proportion > 0.0 && std::isfinite(proportion), "BoxProportions", "numbers above 0",
        proportion);
    }
    Require(this->Settings.Fraction > 0.0 && this->Settings.Fraction < 1.0, "Fraction",
      "a number between 0 and 1", this->Settings.Fraction);
    const double unit = std::cbrt(volume / this->Settings.Fraction / (p[0] * p[1] * p[2]));
    return Window::MakeBox(
      { 0.0, 0.0, 0.0 }, { unit * p[0], unit * p[1], unit * p[2] }, this->Settings.Periodic);
  }

  void Check() const
  {
    const std::vector<double>& radii = this->Settings.Radii;
    const auto spheres = static_cast<std::int64_t>(radii.size());
    Require(spheres >= 2 && spheres <= MostPackedSpheres, "NumberOfSpheres",
      Text("2 to ", MostPackedSpheres), spheres);
    const double maximum = this->Result.MaximumFraction;
    if (this->Settings.Fraction > maximum + 0.015)
    {
      throw std::invalid_argument(Text("Fraction ", this->Settings.Fraction,
        " is more than random packs of these sizes reach (about ", maximum, ")."));
    }
    const double largest = *std::max_element(radii.begin(), radii.end());
    for (int q = 0; q < 3; ++q)
    {
      const double needed = 2.0 * largest *
        (this->Settings.Periodic[q] ? SphereRooms::LeastEdgeInDiameters : 1.0 + 1e-6);
      Require(this->Result.Box.Size[q] > needed, "NumberOfSpheres",
        Text("enough spheres for a box with edges above ", needed, ", ",
          this->Settings.Periodic[q] ? SphereRooms::LeastEdgeInDiameters : 1.0,
          " diameters of the largest sphere"),
        Text(spheres, " spheres and an edge of ", this->Result.Box.Size[q]));
    }
    Require(this->Settings.Rate >= 0.0 && this->Settings.Rate <= 1.0, "Rate",
      "a number from 0 to 1", this->Settings.Rate);
    Require(this->Settings.Equilibration >= 0.0 && this->Settings.Equilibration <= 1e9,
      "EquilibrationTime", "a number from 0 to 1e9", this->Settings.Equilibration);
  }

  double FractionOfStart() const
  {
    const double wanted = this->Settings.Fraction;
    return std::min({ 0.58, 0.85 * wanted, SoftShare * this->Result.MaximumFraction });
  }

  // The centres keep a radius away from walls
  void PutAtRandom()
  {
    SpherePack pack;
    const Window& box = this->Result.Box;
    const double scale = std::cbrt(this->Reached / this->Settings.Fraction);
    for (std::size_t i = 0; i < this->Settings.Radii.size(); ++i)
    {
      const double r = this->Settings.Radii[i] * scale;
      const std::array<double, 3> u =
        UniformTriple(this->Settings.Seed, RandomStream::CellCentres, i);
      Vector3 centre;
      for (int q = 0; q < 3; ++q)
      {
        const double away = box.Periodic[q] ? 0.0 : this->Settings.Radii[i];
        centre[q] = away + u[q] * (box.Size[q] - 2.0 * away);
      }
      pack.X.push_back(centre[0]);
      pack.Y.push_back(centre[1]);
      pack.Z.push_back(centre[2]);
      pack.Radius.push_back(r);
    }
    this->Result.Pack = std::move(pack);
  }

  // Returns whether to go on
  bool Tell(const GrowthStep& step, double done)
  {
    if (step.Collisions > 0.0)
    {
      this->Result.History.push_back(step);
    }
    this->Result.Stopped = this->Result.Stopped || !this->CarryOn(step, done);
    return !this->Result.Stopped;
  }

  void Grow(double rate)
  {
    double collisions = 0.0;
    while (true)
    {
      SpherePack& pack = this->Result.Pack;
      const double wanted = this->Settings.Fraction, from = this->Reached;
      const double growth = std::cbrt(wanted / from) * (1.0 + HardSpheres::Spare);
      HardSpheres spheres(
        pack, this->Result.Box, growth, { this->Settings.Seed, this->Settings.Exchange });
      const auto fraction = [&]() { return from * std::pow(spheres.GetGrowth(), 3); };
      const HardSpheres::End end = spheres.Grow(growth, rate,
        [&]()
        {
          return this->Tell({ rate, fraction(), spheres.ReducedPressure(),
                              collisions + spheres.CollisionsOfSphere() },
            std::clamp((fraction() - from) / (wanted - from), 0.0, 1.0));
        });
      this->Reached = fraction();
      collisions += spheres.CollisionsOfSphere();
      this->History(rate, spheres, collisions);
      pack = spheres.GetPack();
      if (end != HardSpheres::End::Jammed)
      {
        return;
      }
      rate *= Slowing;
      if (rate < SlowestRate * (1.0 - 1e-9) || this->Settings.Rate > 0.0)
      {
        this->Result.Jammed = true;
        return;
      }
      Scale(pack, Shrinking);
      this->Reached *= Shrinking * Shrinking * Shrinking;
    }
  }

  void History(double rate, const HardSpheres& spheres, double collisions)
  {
    this->Result.History.push_back({ rate, this->Reached, spheres.ReducedPressure(), collisions });
  }

  void Equilibrate()
  {
    HardSpheres spheres(this->Result.Pack, this->Result.Box, 1.0,
      { this->Settings.Seed + 1, this->Settings.Exchange });
    const double before =
      this->Result.History.empty() ? 0.0 : this->Result.History.back().Collisions;
    spheres.Equilibrate(this->Settings.Equilibration,
      [&]()
      {
        return this->Tell(
          { 0.0, this->Reached, spheres.ReducedPressure(), before + spheres.CollisionsOfSphere() },
          1.0);
      });
    this->History(0.0, spheres, before + spheres.CollisionsOfSphere());
    this->Result.Pack = spheres.GetPack();
  }

  // The radii are those asked for, whichever spheres have them after exchanges
  void Finish()
  {
    DensePack& result = this->Result;
    const double wanted = this->Settings.Fraction;
    const bool whole = !result.Jammed && !result.Stopped;
    const double scale =
      whole ? 1.0 : std::cbrt(wanted / this->Reached) * (1.0 + HardSpheres::Spare);
    // By falling radius
    const auto order = [](const std::vector<double>& radii)
    {
      std::vector<std::size_t> places(radii.size());
      std::iota(places.begin(), places.end(), 0);
      std::stable_sort(places.begin(), places.end(),
        [&](std::size_t a, std::size_t b) { return radii[a] > radii[b]; });
      return places;
    };
    const std::vector<std::size_t> from = order(result.Pack.Radius);
    const std::vector<std::size_t> to = order(this->Settings.Radii);
    SpherePack pack = result.Pack;
    for (std::size_t n = 0; n < from.size(); ++n)
    {
      pack.X[to[n]] = result.Pack.X[from[n]];
      pack.Y[to[n]] = result.Pack.Y[from[n]];
      pack.Z[to[n]] = result.Pack.Z[from[n]];
    }
    pack.Radius = this->Settings.Radii;
    if (!whole)
    {
      for (std::vector<double>* coordinate : { &pack.X, &pack.Y, &pack.Z })
      {
        for (double& c : *coordinate)
        {
          c *= scale;
        }
      }
      result.Box = result.Box.Scaled(scale);
    }
    result.Pack = std::move(pack);
    result.Fraction = whole ? wanted : wanted / (scale * scale * scale);
  }

  const DensePackSettings& Settings;
  const Progress& CarryOn;
  double Reached = 0.0; // fraction
  DensePack Result;
};
}

DensePack MakeDensePack(
  const DensePackSettings& settings, const std::function<bool(const GrowthStep&, double)>& carryOn)
{
  return Packer(settings, carryOn).Run();
}

namespace
{
constexpr double SecondsOfSoft = 2e-5, SecondsOfCollision = 1e-6;
constexpr double CollisionsTimesRate = 12.0; // of a sphere, in a growth
constexpr double FlightsOfThinPack = 0.5;
constexpr double BytesOfSphere = 600.0;
}

Estimate EstimateDensePack(const DensePackSettings& settings, double spheres)
{
  const double maximum = MaximumRandomFraction(settings.Radii);
  const double share = settings.Fraction / maximum;
  const bool events = settings.Protocol == PackingProtocol::Events ||
    (settings.Protocol == PackingProtocol::Automatic && share > SoftShare);
  const double rate = settings.Rate > 0.0 ? settings.Rate : RateFor(share);
  const double collisions = settings.Equilibration + (events ? CollisionsTimesRate / rate : 0.0);
  // The thinner the pack, the more often spheres are listed anew between two collisions
  const double flights =
    FlightsOfThinPack * std::pow(1.0 - settings.Fraction, 3) / settings.Fraction;
  const double ofSphere = 0.5 * collisions * (1.0 + flights) * SecondsOfCollision;
  Estimate estimate = { spheres * (SecondsOfSoft + ofSphere),
    spheres * BytesOfSphere / BytesOfMegabyte, 0.0 };
  if (events && settings.Rate == 0.0)
  {
    estimate.Automatic = Text("Rate ", rate);
  }
  return estimate;
}
}
