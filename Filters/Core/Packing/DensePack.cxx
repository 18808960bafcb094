// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Packing/DensePack.h"

#include "ruc/Base/Random.h"
#include "ruc/Base/Require.h"
#include "ruc/Packing/HardSpheres.h"
#include "ruc/Packing/MaximumFraction.h"
#include "ruc/Particles/SphereOverlap.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

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

// The fraction from which a pack grows by events
double StartFor(double wanted, double maximum)
{
  return std::min({ 0.58, 0.85 * wanted, SoftShare * maximum });
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

  using Saving = std::function<void(DensePackState)>;
  using Stage = DensePackState::Stage;

  Packer(const DensePackSettings& settings, const Progress& carryOn, const Saving& save)
    : Settings(settings)
    , CarryOn(carryOn)
    , Save(save)
  {
    this->Result.MaximumFraction = MaximumRandomFraction(settings.Radii);
    this->Result.Box = this->MakeBox();
    this->Check();
  }

  DensePack Run(const DensePackState* resume)
  {
    const double share = this->Settings.Fraction / this->Result.MaximumFraction;
    const bool soft = this->Settings.Protocol == PackingProtocol::Soft ||
      (this->Settings.Protocol == PackingProtocol::Automatic && share <= SoftShare);
    this->Result.IsSoft = soft;
    if (resume && resume->At != Stage::Pushing)
    {
      this->Reached = resume->Fraction;
      this->Result.History = resume->History;
    }
    else if (!this->Start(soft, std::exchange(resume, nullptr)))
    {
      return std::move(this->Result);
    }
    if (resume && resume->At == Stage::Growing)
    {
      this->Grow(resume->Rate, resume);
    }
    else if (!soft && !resume)
    {
      this->Grow(this->Settings.Rate > 0.0 ? this->Settings.Rate : RateFor(share), nullptr);
    }
    if (!this->Result.Jammed && !this->Result.Stopped && this->Settings.Equilibration > 0.0)
    {
      this->Equilibrate(resume && resume->At == Stage::Equilibrating ? resume : nullptr);
    }
    this->Finish();
    return std::move(this->Result);
  }

private:
  // Makes the pack from which spheres grow, or the whole of a soft one; returns whether there is
  // one
  bool Start(bool soft, const DensePackState* resume)
  {
    this->Reached = resume ? resume->Fraction
      : soft               ? this->Settings.Fraction
                           : StartFor(this->Settings.Fraction, this->Result.MaximumFraction);
    bool free = this->Begin(resume ? &resume->Removal : nullptr);
    for (; !free && !soft && !this->Result.Stopped && this->Reached > 0.01; free = this->Begin())
    {
      this->Reached *= 0.9;
    }
    if (!free)
    {
      this->Result.Jammed = !this->Result.Stopped;
      this->Result.Pack = {};
    }
    return free;
  }

  // Returns whether there is a pack of the fraction Reached
  bool Begin(const OverlapRemovalState* resume = nullptr)
  {
    this->PutAtRandom();
    const GrowthStep step = { 0.0, this->Reached, 1.0, 0.0 };
    const auto save = [&](const OverlapRemovalState& removal)
    {
      if (this->Save)
      {
        this->Save({ Stage::Pushing, 0.0, this->Reached, 0.0, {}, {}, removal });
      }
    };
    return this->Tell(step, 0.0) &&
      RemoveOverlap(
        this->Result.Pack, this->Result.Box, this->Settings.Seed,
        [&]() { return this->Tell(step, 0.0); }, resume, save);
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

  // Tells a step between collisions, and saves what can be saved then. Returns whether to go on.
  bool TellRound(
    const HardSpheres& spheres, const GrowthStep& step, double done, Stage at, double before)
  {
    const bool goesOn = this->Tell(step, done);
    if (this->Save && spheres.IsBetweenRounds())
    {
      this->Save(
        { at, step.Rate, this->Reached, before, this->Result.History, spheres.GetState(), {} });
    }
    return goesOn;
  }

  void Grow(double rate, const DensePackState* resume)
  {
    const HardSpheres::Settings motion = { this->Settings.Seed, this->Settings.Exchange };
    double collisions = resume ? resume->Collisions : 0.0;
    while (true)
    {
      SpherePack& pack = this->Result.Pack;
      const double wanted = this->Settings.Fraction, from = this->Reached;
      const double growth = std::cbrt(wanted / from) * (1.0 + HardSpheres::Spare);
      HardSpheres spheres = resume ? HardSpheres(resume->Spheres, this->Result.Box, motion)
                                   : HardSpheres(pack, this->Result.Box, growth, motion);
      const auto fraction = [&]() { return from * std::pow(spheres.GetGrowth(), 3); };
      const auto carryOn = [&]()
      {
        const GrowthStep step = { rate, fraction(), spheres.ReducedPressure(),
          collisions + spheres.CollisionsOfSphere() };
        const double done = std::clamp((fraction() - from) / (wanted - from), 0.0, 1.0);
        return this->TellRound(spheres, step, done, Stage::Growing, collisions);
      };
      const HardSpheres::End end =
        resume ? spheres.Resume(carryOn) : spheres.Grow(growth, rate, carryOn);
      resume = nullptr;
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

  void Equilibrate(const DensePackState* resume)
  {
    const HardSpheres::Settings motion = { this->Settings.Seed + 1, this->Settings.Exchange };
    HardSpheres spheres = resume ? HardSpheres(resume->Spheres, this->Result.Box, motion)
                                 : HardSpheres(this->Result.Pack, this->Result.Box, 1.0, motion);
    const double before = resume     ? resume->Collisions
      : this->Result.History.empty() ? 0.0
                                     : this->Result.History.back().Collisions;
    const auto carryOn = [&]()
    {
      const GrowthStep step = { 0.0, this->Reached, spheres.ReducedPressure(),
        before + spheres.CollisionsOfSphere() };
      return this->TellRound(spheres, step, 1.0, Stage::Equilibrating, before);
    };
    if (resume)
    {
      spheres.Resume(carryOn);
    }
    else
    {
      spheres.Equilibrate(this->Settings.Equilibration, carryOn);
    }
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
  const Saving& Save;
  double Reached = 0.0; // fraction
  DensePack Result;
};
}

DensePack MakeDensePack(const DensePackSettings& settings,
  const std::function<bool(const GrowthStep&, double)>& carryOn, const DensePackState* resume,
  const std::function<void(DensePackState)>& save)
{
  return Packer(settings, carryOn, save).Run(resume);
}

std::optional<MeanPressure> FindMeanPressure(const std::vector<GrowthStep>& history)
{
  std::vector<double> rounds;
  for (const GrowthStep& step : history)
  {
    // A thin pack has steps within a round, which tell the pressure of the round before
    const bool repeats = !rounds.empty() && step.ReducedPressure == rounds.back();
    if (step.Rate == 0.0 && step.Collisions > 0.0 && step.ReducedPressure != 1.0 && !repeats)
    {
      rounds.push_back(step.ReducedPressure);
    }
  }
  if (rounds.size() < 5)
  {
    return {};
  }
  rounds.erase(rounds.begin(), rounds.begin() + static_cast<std::ptrdiff_t>(rounds.size() / 5));
  const double count = static_cast<double>(rounds.size());
  const double mean = std::accumulate(rounds.begin(), rounds.end(), 0.0) / count;
  double squares = 0.0;
  for (double pressure : rounds)
  {
    squares += (pressure - mean) * (pressure - mean);
  }
  return MeanPressure{ mean, std::sqrt(squares / (count * (count - 1.0))) };
}

namespace
{
// Measured on packs of one size, of two sizes up to 10:1 and of many
constexpr double SecondsOfCollision = 1.1e-6;
constexpr double ExchangeOverCollision = 0.3; // what exchanges add to it
constexpr double FlightsOfThinPack = 0.5;
constexpr double LeastLeft = 1e-3, Heating = 18.0; // of a growth
constexpr double SpheresInCache = 1000.0;
constexpr double BytesOfSphere = 1200.0; // most of them for the last steps of the descent

// Of a power of the radii
double MeanPower(const std::vector<double>& radii, int power)
{
  double sum = 0.0;
  for (double r : radii)
  {
    sum += std::pow(r / radii.front(), power);
  }
  return sum / static_cast<double>(radii.size());
}

// How many spheres are near the spheres that collide, where equal ones have 1: sphere i has
// neighbours in proportion to the mean of (r_i + r_j)^3, and collides in proportion to that of
// (r_i + r_j)^2
double Crowd(const std::vector<double>& radii)
{
  double m[6];
  for (int power = 0; power < 6; ++power)
  {
    m[power] = MeanPower(radii, power);
  }
  // (r^2 + 2 r m1 + m2) (r^3 + 3 r^2 m1 + 3 r m2 + m3), on average
  const double near = m[5] + 3.0 * m[4] * m[1] + 3.0 * m[3] * m[2] + m[2] * m[3] +
    2.0 * m[1] * (m[4] + 3.0 * m[3] * m[1] + 3.0 * m[2] * m[2] + m[1] * m[3]) +
    m[2] * (m[3] + 3.0 * m[2] * m[1] + 3.0 * m[1] * m[2] + m[3]);
  return near / (2.0 * m[2] + 2.0 * m[1] * m[1]) / (8.0 * m[3]);
}

// To push a sphere of a pack apart: pairs are looked for in cells as large as the largest sphere
double SecondsOfSoft(const DensePackSettings& settings, double fraction, double share)
{
  const double cube = std::pow(
    *std::max_element(settings.Radii.begin(), settings.Radii.end()) / settings.Radii.front(), 3);
  const double inCell = fraction * cube / MeanPower(settings.Radii, 3);
  return (6e-6 + 3.5e-5 * std::pow(share, 4)) * (1.0 + inCell / 20.0);
}

// Collisions of a sphere in a growth between two shares of the maximum fraction. Near it the
// pressure is the inverse of the growth that is left, and a sphere collides 6 Z / pi^(1/2) times in
// the unit of time; quick growth heats the spheres.
double CollisionsOf(double from, double to, double rate)
{
  const auto left = [](double share) { return std::max(1.0 - std::cbrt(share), LeastLeft); };
  return 3.4 * std::log(left(from) / left(to)) * (1.0 + Heating * rate) / rate;
}

// Walls leave a layer without spheres, some part of a diameter wide
double ShareOfMaximum(const DensePackSettings& settings, double maximum, double spheres)
{
  constexpr double LayerOfWall = 0.15;
  const double cubes = 8.0 * MeanPower(settings.Radii, 3),
               largest = 2.0 * MeanPower(settings.Radii, 1);
  const double edge = std::cbrt(spheres * Pi / 6.0 * cubes / settings.Fraction);
  double room = 1.0;
  for (bool periodic : settings.Periodic)
  {
    room -= periodic ? 0.0 : 2.0 * LayerOfWall * largest / edge;
  }
  return settings.Fraction / maximum / std::max(room, 0.5);
}
}

Estimate EstimateDensePack(const DensePackSettings& settings, double spheres)
{
  const double maximum = MaximumRandomFraction(settings.Radii);
  const double share = settings.Fraction / maximum;
  const bool events = settings.Protocol == PackingProtocol::Events ||
    (settings.Protocol == PackingProtocol::Automatic && share > SoftShare);
  // Between walls spheres jam earlier, and are tried again more slowly
  const double walled = ShareOfMaximum(settings, maximum, spheres);
  const double rate = settings.Rate > 0.0 ? settings.Rate : RateFor(walled);
  const double start = events ? StartFor(settings.Fraction, maximum) : settings.Fraction;
  const double collisions =
    settings.Equilibration + (events ? CollisionsOf(start / maximum, walled, rate) : 0.0);
  // The thinner the pack, the more often spheres are listed anew between two collisions
  const double flights =
    FlightsOfThinPack * std::pow(1.0 - settings.Fraction, 3) / settings.Fraction;
  const double ofCollision = SecondsOfCollision * std::pow(Crowd(settings.Radii), 1.5) *
    (settings.Exchange ? 1.0 + ExchangeOverCollision : 1.0) *
    std::pow(std::max(spheres / SpheresInCache, 1.0), 0.15);
  const double ofCache = std::pow(std::max(spheres / 1e4, 1.0), 0.15);
  Estimate estimate = { spheres *
      (SecondsOfSoft(settings, start, start / maximum) * ofCache +
        0.5 * collisions * (1.0 + flights) * ofCollision),
    spheres * BytesOfSphere / BytesOfMegabyte, 0.0 };
  if (events && settings.Rate == 0.0)
  {
    estimate.Automatic = Text("Rate ", RateFor(share));
  }
  return estimate;
}
}
