// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Statistics/Results/LagGrid.h"
#include "ruc/Statistics/ThirdOrder/ThreePointProbability.h"
#include "ruc/Tracing/PhaseChanges.h"
#include "ruc/Tracing/RayFan.h"
#include "ruc/Tracing/SamplingRegion.h"

#include <cstdint>
#include <vector>

namespace ruc
{
/**
 * A fan that was traced through the spheres of a pack. Every ray has lists of the lags in one phase
 * or another. Along the ray, the phase begins at the first lag of its list and ends before the
 * second, begins again at the third, and so on. An end beyond the last lag of all is left out.
 */
struct TracedFan
{
  RayFan Fan;
  std::vector<RayHit> Hits;
  int Phase = 0; // of the centre
  std::vector<std::int32_t> Lags;
  /** Where each list begins in Lags, and the end: list l of ray i at i x lists + l. */
  std::vector<std::int32_t> Begin;
};

/** Finds the lags of traced fans. */
class FanLags
{
public:
  /**
   * There is a list for every phase that is s or q in one of the triples, and, where the region has
   * a border, a last one for the lags in the region. Rays reach half a spacing beyond the last lag.
   * The region and `rays` are kept as references.
   */
  FanLags(const SamplingRegion& region, const RayDirections& rays, const LagGrid& lags, int modes,
    const std::vector<PhaseTriple>& triples);

  bool IsBounded() const { return !this->Region.IsFullyPeriodic(); }
  /** The length of a ray. */
  double Length() const { return (this->Lags.Count + 0.5) * this->Lags.Spacing; }
  /** The number of lists on every ray. */
  int Lists() const { return this->ListsOfPhases + (this->IsBounded() ? 1 : 0); }
  int ListOf(int phase) const { return this->ListOfPhase[phase]; }
  int ListOfRegion() const { return this->ListsOfPhases; }

  /** Memory that Find uses for one ray after the other. Each thread has its own. */
  struct Scratch
  {
    std::vector<std::vector<SphereHit>> Hits; // for every ray
    std::vector<LineInterval> Inside;
    std::vector<PhaseChange> Changes;
  };

  /** Finds the lags of a fan and the phase of its centre from its hits. May run concurrently. */
  void Find(TracedFan& fan, Scratch& scratch) const;

private:
  void AddLagsOfPhases(const std::vector<PhaseChange>& changes, TracedFan& fan) const;
  void AddLags(double begin, double end, TracedFan& fan) const;

  const SamplingRegion& Region;
  const RayDirections& Rays;
  LagGrid Lags;
  int Modes;
  std::vector<int> ListOfPhase; // -1 for phases that play no part
  int ListsOfPhases = 0;
};
}
