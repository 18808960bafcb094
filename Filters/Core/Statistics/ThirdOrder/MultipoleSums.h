// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Particles/PackShare.h"
#include "ruc/Particles/PairNeighbourhood.h"
#include "ruc/Statistics/ThirdOrder/LocalMultipoles.h"
#include "ruc/Statistics/ThirdOrder/MultipoleProducts.h"
#include "ruc/Statistics/ThirdOrder/ThirdOrderEwald.h"
#include "ruc/Statistics/ThirdOrder/ThirdOrderOfSpheres.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace ruc
{
/** The number of triples q, r <= s of some phases, and the place of one among them. */
constexpr std::size_t NumberOfTriples(int phases)
{
  return static_cast<std::size_t>(phases) * phases * (phases + 1) / 2;
}
std::size_t PlaceOfTriple(int phases, int q, int r, int s);

/**
 * Where the centres of the sums lie: the window without a margin, in blocks for the errors and in
 * slabs. Slabs lie across x, y and z, or across the axis of a cylinder.
 */
class CentreRegion
{
public:
  /** Throws std::invalid_argument where the window has no room for the margin. */
  CentreRegion(const Window& observed, double margin, const ThirdOrderSettings& settings);

  const Window& GetRegion() const { return this->Region; }
  int NumberOfBlocks() const;
  int BlockOf(const Vector3& centre) const;
  int NumberOfAxes() const { return this->Region.GetShape() == Window::Shape::Box ? 3 : 1; }
  int GetSlabs() const { return this->NumberOfSlabs; }
  int SlabOf(const Vector3& centre, int axis) const;
  /** A slab without values. */
  ThirdOrderOfSpheres::Slab MakeSlab(int axis, int n) const;

private:
  double Along(const Vector3& centre, int axis) const;
  double Low(int axis) const;
  double Length(int axis) const;

  Window Region, Bounds;
  int NumberOfSlabs;
  std::array<int, 3> Divisions{};
};

/**
 * Where the sums over centres stand in one list. All but the numbers of centres are weighted by the
 * cube of the centre's radius over that of the largest.
 */
struct SumLayout
{
  SumLayout(int sources, int degrees, const CentreRegion& region);

  std::size_t Triples, Degrees; // Degrees: the length of a spectrum, with the rest
  std::size_t BlockSize, Blocks, Slabs;

  // In a block: the weight, the spectrum of all phases, the second and the fourth of all triples
  static constexpr std::size_t Weight() { return 0; }
  static constexpr std::size_t Spectrum() { return 1; }
  std::size_t Second() const { return 1 + this->Degrees; }
  std::size_t Fourth() const { return this->Second() + this->Triples; }
  // After the blocks: the spectrum of each triple, then weight, field and number of centres of
  // every slab and block
  std::size_t TripleSpectrum(std::size_t triple) const
  {
    return this->Blocks * this->BlockSize + triple * this->Degrees;
  }
  std::size_t Slab(std::size_t slab, std::size_t block) const
  {
    return this->TripleSpectrum(this->Triples) + 3 * (slab * this->Blocks + block);
  }
  std::size_t Size() const { return this->Slab(this->Slabs, 0); }
};

/** The sums over the centres of a pack that is shared over ranks. */
class MultipoleSums
{
public:
  /** `source` is the phase of each sphere of the share, counted from 0. Collective. */
  MultipoleSums(const PackShare& share, const std::vector<int>& source,
    const MultipoleSettings& settings, const CentreRegion& region, const SumLayout& layout,
    Communicator& ranks);

  /** The number of centres of this rank. */
  std::size_t NumberOfCentres() const { return this->Centres.size(); }

  /** Returns the sums over the centres of all ranks, as SumLayout says. Collective. */
  std::vector<double> Sum(Communicator& ranks, const std::function<void(double)>& progress);

  /** After Sum, for every sphere of the share the mean of F : F in it; NaN off the centres. */
  std::vector<double> Field;

private:
  class FixedPoint;
  using Rests = std::vector<std::array<std::int64_t, 2>>; // of every source

  void AddBlock(std::size_t begin, std::size_t end, LocalMultipoles::Neighbours& around,
    std::vector<double>& sums, FixedPoint& own);
  Rests Gather(std::size_t i, LocalMultipoles::Neighbours& around) const;
  void AddCentre(std::size_t place, const double* sums, const Rests& rests, FixedPoint& own);

  const PackShare& Share;
  const std::vector<int>& Source;
  const CentreRegion& Region;
  const SumLayout& Layout;
  LocalMultipoles Multipoles;
  MultipoleProducts Products;
  Surroundings Around;
  double Weight;
  std::vector<std::size_t> Centres; // their sorted places
  std::optional<ThirdOrderEwald> Ewald;
};
}
