// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"

#include <cstddef>
#include <vector>

namespace ruc
{
enum class ModeMethod
{
  EqualWidth,    // modes of equal width in diameter, from the smallest to the largest
  EqualVolume,   // modes that hold about equal volumes of spheres
  ExplicitEdges, // modes between the given diameters
  OnePerSize     // one mode for every diameter that occurs
};

struct ModeSettings
{
  ModeMethod Method = ModeMethod::EqualWidth;
  int NumberOfModes = 9;        // for EqualWidth and EqualVolume, 1 to MostModes
  std::vector<double> Edges;    // for ExplicitEdges: ascending diameters > 0, two at the least
  double MinimumDiameter = 0.0; // smaller spheres belong to no mode and are left out
};

/** The statistics hold N (N + 1) / 2 functions for N phases; more modes than this ask for too much
 * memory. */
constexpr int MostModes = 256;

/** The spheres of one mode. */
struct ModeSummary
{
  std::size_t Count = 0;
  double MinimumDiameter = 0.0, MaximumDiameter = 0.0;
  double VolumeMeanDiameter = 0.0; // (sum d^3 / Count)^(1/3)
  double Volume = 0.0;             // of the spheres
};

/** Classes of particle sizes. */
class ParticleModes
{
public:
  /**
   * Collective: finds the modes of a pack with these diameters, of which every rank has some or
   * none. Modes that would be empty are left out and the others numbered through. The same on every
   * rank, bit by bit, for any sharing; of single spheres a rank learns nothing, save for
   * EqualVolume, which takes the diameters of all on every rank. Throws std::invalid_argument, on
   * all ranks, for settings out of range and for diameters that the explicit edges leave out.
   */
  ParticleModes(std::vector<double> diameters, const ModeSettings& settings, Communicator& ranks);
  /** For one rank that has all. */
  ParticleModes(std::vector<double> diameters, const ModeSettings& settings);

  int NumberOfModes() const { return static_cast<int>(this->Summaries.size()); }

  /** The mode, 1 to NumberOfModes(), of one of these diameters, or 0 for one below the minimum. */
  int ModeOf(double diameter) const;

  const ModeSummary& Summary(int mode) const { return this->Summaries[mode - 1]; }

private:
  double MinimumDiameter;
  std::vector<double> LowerEdges; // of modes 2, 3, …
  std::vector<ModeSummary> Summaries;
};
}
