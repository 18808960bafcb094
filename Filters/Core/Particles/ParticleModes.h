// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Base/Estimate.h"

#include <cstddef>
#include <vector>

namespace ruc
{
/** How spheres are divided into modes. */
enum class ModeMethod
{
  EqualWidth,    // modes of equal width in diameter, from the smallest to the largest
  EqualVolume,   // modes that hold about equal volumes of spheres
  ExplicitEdges, // modes between the given diameters
  OnePerSize     // one mode for every diameter that occurs, to 1e-9 of it
};

struct ModeSettings
{
  ModeMethod Method = ModeMethod::EqualWidth;
  /** From 1 to MostModes, for EqualWidth and EqualVolume. */
  int NumberOfModes = 9;
  /** From 2 to MostModes + 1 ascending diameters >= 0, for ExplicitEdges. Every diameter must lie
   * between the first and the last. A mode holds its lower edge. */
  std::vector<double> Edges;
  /** Smaller spheres belong to no mode and are left out. >= 0. */
  double MinimumDiameter = 0.0;
};

/**
 * The statistics hold N (N + 1) / 2 functions for N phases, so more modes than this would take too
 * much memory.
 */
constexpr int MostModes = 256;

/** Estimates what it takes to sort so many spheres, and to hand them on with their modes. */
Estimate EstimateModes(double spheres, ModeMethod method);

/** The spheres of one mode. */
struct ModeSummary
{
  std::size_t Count = 0;
  double MinimumDiameter = 0.0, MaximumDiameter = 0.0;
  double VolumeMeanDiameter = 0.0; // (sum d^3 / Count)^(1/3)
  double Volume = 0.0;             // of the spheres
};

/** The modes of a pack, which are classes of size. */
class ParticleModes
{
public:
  /**
   * Finds the modes of a pack with these diameters, of which every rank has some or none. Modes
   * that would be empty are left out, and the others are numbered without a gap. The modes are the
   * same on every rank, bit by bit, for any sharing. No rank learns of the single spheres of
   * another, save for EqualVolume, which gathers the diameters of all on every rank. Collective.
   *
   * Throws std::invalid_argument, on all ranks, for settings out of range, for diameters that the
   * explicit edges leave out, for a minimum diameter that leaves no sphere, and for more than
   * MostModes sizes with OnePerSize.
   */
  ParticleModes(std::vector<double> diameters, const ModeSettings& settings, Communicator& ranks);
  /** The same for one rank that has all diameters. */
  ParticleModes(std::vector<double> diameters, const ModeSettings& settings);

  int NumberOfModes() const { return static_cast<int>(this->Summaries.size()); }

  /**
   * Returns the mode, 1 to NumberOfModes(), of one of these diameters, or 0 for one below the
   * minimum.
   */
  int ModeOf(double diameter) const;

  const ModeSummary& Summary(int mode) const { return this->Summaries[mode - 1]; }

private:
  double MinimumDiameter;
  std::vector<double> LowerEdges; // the least diameters of the modes 2, 3, …
  std::vector<ModeSummary> Summaries;
};
}
