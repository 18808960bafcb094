// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Particles/CellList.h"
#include "ruc/Statistics/PairSums/PairKernel.h"

#include <cstdint>
#include <vector>

namespace ruc
{
/** The type of a sphere, which is its mode and radius. */
struct SphereType
{
  int Mode;
  double Radius;

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Mode, self.Radius);
  }

  bool operator<(const SphereType& other) const
  {
    return this->Mode != other.Mode ? this->Mode < other.Mode : this->Radius < other.Radius;
  }
  bool operator==(const SphereType& other) const
  {
    return this->Mode == other.Mode && this->Radius == other.Radius;
  }
};

/**
 * A histogram of the pair distances of a pack for every class of pairs, where a class is an
 * unordered pair of sphere types.
 *
 * A pair adds the four Hermite weights of its distance to the knots of its class (PairKernel), as
 * integers in fixed point. Sums over pairs are thus exact, and the same in whatever order and on
 * however many threads and ranks they are taken.
 */
class PairHistogram
{
public:
  /**
   * Throws std::invalid_argument if there are so many numbers that a place among them takes more
   * than 31 bits, as with radii that differ by a factor of a hundred million.
   */
  PairHistogram(std::vector<SphereType> types, const LagGrid& lags,
    const KnotResolution& resolution = ExactKnots);

  int NumberOfTypes() const { return static_cast<int>(this->Types.size()); }
  int NumberOfClasses() const { return static_cast<int>(this->Kernels.size()); }
  const PairKernel& Kernel(int pairClass) const { return this->Kernels[pairClass]; }
  /**
   * The place of a class's first number in a histogram, or in any function on the knots of all
   * classes.
   */
  std::size_t Begin(int pairClass) const { return this->ClassBegin[pairClass]; }
  /** How many numbers a histogram holds. */
  std::size_t Size() const { return this->ClassBegin.back(); }
  /** The place of the lower type of a class among the types. */
  int LowerTypeIndex(int pairClass) const { return this->ClassTypes[pairClass].first; }
  /** The lower and the higher sphere type of a class. */
  const SphereType& LowerType(int pairClass) const
  {
    return this->Types[this->ClassTypes[pairClass].first];
  }
  const SphereType& HigherType(int pairClass) const
  {
    return this->Types[this->ClassTypes[pairClass].second];
  }

  /**
   * How many numbers a histogram for these types would hold, without making its tables, to decide
   * whether they are few enough.
   */
  static double EstimateSize(const std::vector<SphereType>& types, const LagGrid& lags,
    const KnotResolution& resolution = ExactKnots);

  /** How many bytes the tables of all classes would take. */
  static double EstimateTables(const std::vector<SphereType>& types, const LagGrid& lags,
    const KnotResolution& resolution = ExactKnots);

  /**
   * Returns the largest power of two by which weights up to `heaviest` may be scaled to integers
   * such that no sum over `spheres` spheres of up to `mostNeighbours` pairs each reaches 2^62, and
   * no single weight 2^50.
   */
  static double FixedPointScale(std::int64_t spheres, std::int64_t mostNeighbours, double heaviest);

  /**
   * Where the hot loops find a distance: at knot floor(u) with u = distance x InverseSpacing +
   * Shift. u is at most Last, which lies between two knots at which there is no overlap at any lag.
   * Begin is the place of the class's first number.
   */
  struct alignas(32) Lookup
  {
    double InverseSpacing, Shift, Last;
    std::int32_t Begin;
  };
  /** The lookups of the pairs of a type with every type. */
  const Lookup* LookupRow(int type) const
  {
    return &this->Lookups[std::size_t(type) * this->Types.size()];
  }

private:
  std::vector<SphereType> Types;
  std::vector<PairKernel> Kernels;
  std::vector<std::pair<int, int>> ClassTypes;
  std::vector<std::size_t> ClassBegin;
  std::vector<Lookup> Lookups;
};
}
