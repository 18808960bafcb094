// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Particles/CellList.h"
#include "ruc/Particles/PackShare.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace ruc
{
/**
 * This rank's share of a pack and its surroundings. These are all spheres, of other ranks and
 * images along periodic axes, that are close enough to the box around the share's own centres to
 * matter: closer than the reach of their classes of size (SizeClasses).
 *
 * Over the own centres of all ranks, every unordered pair of a centre and an image of a centre
 * closer than their reach is met exactly once. A pair within one rank is met by that rank, a pair
 * of two ranks by the lower one. Where the image lies whole edges away, the pair is met by the rank
 * of the sphere from which these edges are lexicographically positive. A displacement is (x_j -
 * x_i) + shift, which changes its sign exactly when i and j change places. Hence what is summed up
 * from it in integers is the same for any sharing.
 */
class PairNeighbourhood
{
public:
  /** Collective. */
  PairNeighbourhood(const PackShare& share, const SizeClasses& classes, Communicator& ranks);
  /** Collective. All pairs have one reach, `cutoff` > 0. */
  PairNeighbourhood(const PackShare& share, double cutoff, Communicator& ranks);

  /**
   * Spheres that are displaced by the same whole edges, Shift. The first part holds the share's own
   * spheres.
   */
  struct Part
  {
    SpherePack Pack;
    CellList Cells; // the centres of Pack, as if no axis were periodic
    Vector3 Shift;
  };
  std::vector<Part> Parts;

  const CellList& Own() const { return this->Parts.front().Cells; }
  /** The number of own centres, which are the places in Own(). */
  std::size_t Size() const { return this->Own().Size(); }
  /** No pair is farther apart than this. */
  double LargestReach() const { return this->Classes.LargestReach(); }

  /** The sorted places [Begin, End) of the cells of a part, and how close they have to be. */
  struct Range
  {
    std::size_t Part, Begin, End;
    double Reach;
  };

  /**
   * Replaces `ranges` by those that the own centre at place i has to be paired with. They also hold
   * centres beyond the reach.
   */
  void FindRanges(std::size_t i, std::vector<Range>& ranges) const;

  /** An upper bound of how many others any centre meets. */
  std::int64_t MostNeighbours() const;

  /**
   * Calls visit(i, part, j, dx, dy, dz, d2) for every pair of the own centres at places [begin,
   * end) that is closer than its reach. i is the place of the sphere in Parts[0].Pack and j that in
   * part.Pack; (dx, dy, dz) is the displacement from i to j and d2 its squared length.
   */
  template <class Visit>
  void ForEachPair(std::size_t begin, std::size_t end, Visit&& visit) const
  {
    const CellList& own = this->Own();
    std::vector<Range> ranges;
    for (std::size_t i = begin; i < end; ++i)
    {
      const double x = own.X[i], y = own.Y[i], z = own.Z[i];
      this->FindRanges(i, ranges);
      for (const Range& range : ranges)
      {
        const Part& part = this->Parts[range.Part];
        const double reach2 = range.Reach * range.Reach;
        for (std::size_t j = range.Begin; j < range.End; ++j)
        {
          const double dx = (part.Cells.X[j] - x) + part.Shift[0];
          const double dy = (part.Cells.Y[j] - y) + part.Shift[1];
          const double dz = (part.Cells.Z[j] - z) + part.Shift[2];
          const double d2 = dx * dx + dy * dy + dz * dz;
          if (d2 < reach2)
          {
            visit(own.Index[i], part, part.Cells.Index[j], dx, dy, dz, d2);
          }
        }
      }
    }
  }

private:
  SizeClasses Classes;
};

/**
 * This rank's share of a pack and everything around each of its centres: all spheres, of other
 * ranks and images along periodic axes, that are closer to an own centre than one reach. Here every
 * centre meets all others, so that a pair is met from both sides, by the ranks of both. The
 * displacements are those of PairNeighbourhood.
 */
class Surroundings
{
public:
  /** `reach` > 0. Collective. */
  Surroundings(const PackShare& share, double reach, Communicator& ranks);

  /** The number of own centres, which have a sorted place each. */
  std::size_t Size() const { return this->Parts.front().Cells.Size(); }
  /** The place in the share of the centre at a sorted place. */
  std::size_t PlaceOf(std::size_t i) const { return this->Parts.front().Cells.Index[i]; }
  /** Whether a part holds the share's own spheres, in their own places. */
  bool IsOwn(const PairNeighbourhood::Part& part) const { return &part == &this->Parts.front(); }

  /**
   * Calls visit(part, j, dx, dy, dz, d2) for every other centre, images of its own included, closer
   * to the own centre at the sorted place i than the reach. j is the place of the sphere in
   * part.Pack.
   */
  template <class Visit>
  void ForEachAround(std::size_t i, Visit&& visit) const
  {
    const CellList& own = this->Parts.front().Cells;
    const double x = own.X[i], y = own.Y[i], z = own.Z[i];
    thread_local std::vector<CellList::Range> ranges;
    for (std::size_t p = 0; p < this->Parts.size(); ++p)
    {
      const PairNeighbourhood::Part& part = this->Parts[p];
      const Vector3& shift = part.Shift;
      part.Cells.FindRangesAround({ x - shift[0], y - shift[1], z - shift[2] }, 0, ranges);
      for (const CellList::Range& range : ranges)
      {
        for (std::size_t j = range.Begin; j < range.End; ++j)
        {
          const double dx = (part.Cells.X[j] - x) + shift[0];
          const double dy = (part.Cells.Y[j] - y) + shift[1];
          const double dz = (part.Cells.Z[j] - z) + shift[2];
          const double d2 = dx * dx + dy * dy + dz * dz;
          if (d2 < this->Reach2 && (p > 0 || j != i))
          {
            visit(part, part.Cells.Index[j], dx, dy, dz, d2);
          }
        }
      }
    }
  }

private:
  double Reach2;
  std::vector<PairNeighbourhood::Part> Parts; // the first holds the share's own spheres
};
}
