// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Geometry/SpherePack.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ruc
{
/**
 * The centres of a pack sorted into a grid of cells, for finding every pair of centres closer than
 * a cut-off.
 *
 * Along a periodic axis the images of a centre count as centres of their own; the cut-off may
 * exceed the box, in which case a sphere meets several images of another one, and of itself. Memory
 * is linear in the number of spheres; images are not stored.
 */
class CellList
{
public:
  /** `pack` must lie in `window` with the periodic axes wrapped (WrapIntoBox); `cutoff` > 0. */
  CellList(const SpherePack& pack, const Window& window, double cutoff);

  /** Centres, in the order of the cells. */
  std::vector<double> X, Y, Z;
  /** Place of each of these centres in the pack. */
  std::vector<std::uint32_t> Index;

  double GetCutoff() const { return this->Cutoff; }
  std::size_t Size() const { return this->X.size(); }

  /** Sorted places [Begin, End), to be met by a centre at (X, Y, Z): its own place, less the
   * range's periodic shift. */
  struct Range
  {
    std::size_t Begin, End;
    double X, Y, Z;
  };

  /**
   * Puts into `ranges` the places that the i-th centre has to be paired with. Over all i, every
   * unordered pair of a centre and an image of a centre closer than the cut-off appears in exactly
   * one range. A range also holds centres beyond the cut-off.
   */
  void FindRanges(std::size_t i, std::vector<Range>& ranges) const;

  /**
   * The places of all centres closer to a point than the cut-off, and of others: for lists without
   * periodic axes. The ranges' X, Y, Z are the point's.
   */
  void FindRangesAround(const Vector3& point, std::vector<Range>& ranges) const;

  /** No centre can have more than this many others, images included, within the cut-off. */
  std::int64_t MostNeighbours() const;

private:
  struct Axis
  {
    double Origin, Edge, Width;
    int Count;
    bool Periodic;

    int CellOf(double c) const;
    // First and last cell, images included, that c - reach to c + reach meets
    int FirstCell(double c, double reach) const;
    int LastCell(double c, double reach) const;
    // Distance from c to the slab of cell k
    double DistanceTo(double c, int k) const;
    // By how many edges the cell k lies outside the box
    int ImageOf(int k) const;
  };

  std::size_t CellNumber(int cx, int cy, int cz) const;

  double Cutoff;
  Axis Axes[3];
  std::vector<std::size_t> CellBegin; // first sorted place of each cell, and the end
};
}
