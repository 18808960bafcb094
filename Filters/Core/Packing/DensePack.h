// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Estimate.h"
#include "ruc/Packing/HardSphereState.h"
#include "ruc/Packing/OverlapRemoval.h"
#include "ruc/Particles/SpherePack.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace ruc
{
enum class PackingProtocol
{
  Automatic, // Soft up to SoftShare of the maximum fraction, and Events above
  Soft,      // random centres, whose spheres are pushed apart (RemoveOverlap)
  Events     // the same to a lower fraction, from which hard spheres collide and grow (HardSpheres)
};
constexpr int CountOf(PackingProtocol)
{
  return 3;
}
/** Pushed apart, spheres jam from some 0.98 of the maximum fraction on, and take long from here. */
constexpr double SoftShare = 0.93 * 0.633 / 0.6435;

constexpr int MostPackedSpheres = 10'000'000;

/** What MakeDensePack makes. */
struct DensePackSettings
{
  std::vector<double> Radii;
  double Fraction = 0.6; // of the volume of the box
  /** The edges of the box in proportion to each other, and which of them are periodic. */
  Vector3 Proportions = { 1.0, 1.0, 1.0 };
  std::array<bool, 3> Periodic = { true, true, true };
  std::uint32_t Seed = 1;
  PackingProtocol Protocol = PackingProtocol::Automatic;
  /** Of the growth (HardSpheres::Grow); 0 for one that suits the fraction. */
  double Rate = 0.0;
  bool Exchange = false;
  /** Collisions of each sphere at the end, without growth. */
  double Equilibration = 0.0;

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Radii, self.Fraction, self.Proportions, self.Periodic, self.Seed,
      self.Protocol, self.Rate, self.Exchange, self.Equilibration);
  }
};

/** One line of the history of a pack. */
struct GrowthStep
{
  double Rate;
  double Fraction;
  double ReducedPressure; // HardSpheres::ReducedPressure
  double Collisions;      // of a sphere since the growth began

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Rate, self.Fraction, self.ReducedPressure, self.Collisions);
  }
};

/** A mean over the rounds of an equilibration. */
struct MeanPressure
{
  double Value = 0.0;
  double Error = 0.0; // standard
};

/**
 * Returns the mean reduced pressure over the rounds without growth, or none where there are fewer
 * than five. The first fifth of them is left out, in which a pack comes to equilibrium.
 */
std::optional<MeanPressure> FindMeanPressure(const std::vector<GrowthStep>& history);

/** The state of a pack on the way. */
struct DensePackState
{
  enum class Stage : std::uint8_t
  {
    Pushing, // apart, before any collide: of what follows, there are Fraction and Removal
    Growing,
    Equilibrating
  };
  friend constexpr int CountOf(Stage) { return 3; }
  Stage At = Stage::Pushing;
  double Rate = 0.0; // of the growth
  /** The fraction, and the collisions of a sphere, when this stage began. */
  double Fraction = 0.0, Collisions = 0.0;
  std::vector<GrowthStep> History;
  HardSphereState Spheres; // between two rounds of collisions
  OverlapRemovalState Removal;

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(
      self.At, self.Rate, self.Fraction, self.Collisions, self.History, self.Spheres, self.Removal);
  }
};

struct DensePack
{
  SpherePack Pack; // in the order of the radii
  Window Box;
  double Fraction = 0.0;
  double MaximumFraction = 0.0; // MaximumRandomFraction
  bool Jammed = false;          // before the fraction that was wanted
  bool Stopped = false;
  bool IsSoft = false; // whether it was made by PackingProtocol::Soft
  std::vector<GrowthStep> History;
};

/**
 * Makes a random pack of hard spheres, in a box from the origin that their volume and the fraction
 * give. No two overlap, in exact comparison of doubles. Walls, on axes that are not periodic, are
 * hard, too.
 *
 * A growth that jams before its end is shrunk by 2 % and tried again at a third of the rate, down
 * to 0.001 of a diameter in the unit of time, more slowly than which equal spheres would
 * crystallise. Where that is not enough, or where `carryOn` returned false, the pack has the radii
 * that were asked for in a box that is larger, and so its fraction is the one that was reached.
 *
 * Throws std::invalid_argument for settings that cannot be, among them a fraction more than 0.015
 * above MaximumRandomFraction. One thread; the result depends on the settings alone. `carryOn` is
 * told the last step and what is done, from 0 to 1.
 *
 * `save`, if given, receives the state after every round of 50 collisions of a sphere, and now and
 * then while spheres are pushed apart. `resume` is such a state to go on from, to the same end, bit
 * by bit.
 */
DensePack MakeDensePack(const DensePackSettings& settings,
  const std::function<bool(const GrowthStep&, double)>& carryOn,
  const DensePackState* resume = nullptr, const std::function<void(DensePackState)>& save = {});

/**
 * What MakeDensePack takes for `spheres` spheres, of whose sizes `settings.Radii` are a sample. An
 * automatic rate is told in words.
 */
Estimate EstimateDensePack(const DensePackSettings& settings, double spheres);
}
