// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Base/Estimate.h"
#include "ruc/Particles/PackFigures.h"
#include "ruc/Particles/PackShare.h"
#include "ruc/Statistics/Results/Jackknife.h"
#include "ruc/Tracing/SamplingRegion.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace ruc
{
/** How neighbours are measured. The gap of two spheres of radii a and b is d / (a + b) - 1. */
struct NeighbourSettings
{
  double ContactTolerance = 0.02; // pairs up to this gap touch; from 0 to MaximumGap
  double MaximumGap = 0.2;        // the last gap of the distributions; above 0, at most 2
  int Gaps = 100;                 // the number of steps up to it, from 1 to 10 000
  int Blocks = 32;                // about the number of blocks for the errors, from 2 to 1000
};

/** Throws std::invalid_argument for settings out of range. */
void CheckSettings(const NeighbourSettings& settings);

/** The centres that count: those in the region, and how far their surroundings are known. */
struct CountedCentres
{
  const SamplingRegion& Region;
  double Margin;   // that the region has taken off
  bool WithinMask; // whether it came from a mask; else from the window of the pack
};

/**
 * Who touches whom in a pack and how spheres are placed around each other. Only the spheres in a
 * region count, but all take part as their neighbours. Standard errors are those of the delete-one
 * jackknife over blocks of the region.
 */
struct NeighbourStatistics
{
  std::int64_t Counted = 0; // spheres in the region
  std::int64_t Cells = 0;   // those whose cell is whole and not empty
  int Blocks = 0;

  /** A sphere of this rank's share. The numbers of its cell are NaN unless that is whole. */
  struct Sphere
  {
    int Contacts = 0;    // that are known
    bool Counts = false; // whether it lies in the region
    /**
     * Whether it is a rattler: it has fewer than four contacts with spheres that are none. Spheres
     * outside the region count as held by what is unknown, and are no rattlers.
     */
    bool Rattler = false;
    double NearestGap;    // d - a - b of the nearest surface that is known; NaN outside the region
    double LocalFraction; // the sphere's volume over that of its radical cell
    double Q4, Q6;        // RadicalCell
    int Faces = 0;        // of the cell; 0 unless it is whole
  };
  std::vector<Sphere> Spheres; // in the order of the share

  /**
   * A pair that touches, which one of its ranks tells: that of the sphere with the lesser centre.
   */
  struct Contact
  {
    Vector3 From, To; // the centres; that at To may be an image beyond a periodic edge
    double Gap;
    int FromMode, ToMode;
  };
  std::vector<Contact> Contacts;

  /** The gaps x of the distributions, from 0 to MaximumGap. */
  std::vector<double> Gap;
  /**
   * The mean number of neighbours of mode s with a gap <= x of a sphere of mode r: at [r][s], where
   * the last r and s stand for all modes.
   */
  using Distribution = std::vector<ValueWithError>;
  std::vector<std::vector<Distribution>> Neighbours;

  /** The means over the spheres of a mode. */
  struct Means
  {
    std::int64_t Counted = 0;
    ValueWithError Contacts; // the coordination number
    ValueWithError NearestGap;
    ValueWithError LocalFraction;
    ValueWithError Faces;
    ValueWithError Q4, Q6;
    ValueWithError Rattlers; // their share
    /** Contacts with others that are no rattlers, of spheres that are none. */
    ValueWithError HeldContacts;
    /** The mean of n_a n_b over the contacts, which lie along n: xx, yy, zz, yz, xz, xy. */
    std::array<ValueWithError, 6> Fabric;
  };
  std::vector<Means> OfModes; // and last of all modes
};

/** With more modes than this only the last row and column of the distributions are there. */
constexpr int MostModesOfPairs = 32;

/**
 * Measures a pack. The result is equal, bit by bit, for any number of ranks and threads. The
 * `progress` is told the share that is done, on the calling thread. Collective.
 *
 * Throws std::invalid_argument, the same on every rank, for settings out of range and a region
 * without a centre.
 */
NeighbourStatistics MeasureNeighbours(const PackShare& share, const CountedCentres& centres,
  const NeighbourSettings& settings, Communicator& ranks,
  const std::function<void(double)>& progress = {});

/**
 * The margin for a window: one and a half largest diameters, more for a large MaximumGap. Within it
 * the contacts of every sphere are known, and the cell of nearly every one in a dense pack is
 * whole.
 */
double NeighbourMargin(double largestRadius, double maximumGap);

/** What MeasureNeighbours takes. Throws std::invalid_argument for settings out of range. */
Estimate EstimateNeighbours(const PackFigures& pack, const NeighbourSettings& settings);
}
