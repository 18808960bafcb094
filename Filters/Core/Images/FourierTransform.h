// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Images/LineTransform.h"
#include "ruc/Images/Slabs.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace ruc
{
/**
 * Fourier transforms of real three-dimensional images that are spread over the ranks in slabs of
 * planes z. In double precision; the numbers are equal, bit by bit, for any number of ranks and
 * threads.
 *
 * An image has Filled numbers along each axis and is 0 from there to Size, the period of the
 * transform. A rank transforms its planes along x and y, and sends to every other rank the columns
 * along z that belong to that one, which then transforms these. So no rank ever holds all of it.
 *
 * Of the frequencies along x, 0 to Size[0] / 2 are kept, since those of a real image are conjugate
 * to each other in pairs. Columns lie in blocks of LineTransform::Lanes: block y + Size[1] n holds
 * the frequencies (n Lanes + lane, y), and 0 where there are none. Blocks of even number and the
 * one after them belong to the same rank.
 */
class FourierTransform
{
public:
  /** The blocks of a rank, each as LineTransform has its lines, first the real parts. */
  using Spectrum = std::vector<double>;

  /** `filled` is at most `size` along each axis, and both are at least 1. */
  FourierTransform(
    const std::array<int, 3>& size, const std::array<int, 3>& filled, const Communicator& ranks);

  const std::array<int, 3>& GetSize() const { return this->Size; }
  int HalfX() const { return this->Size[0] / 2 + 1; }

  /** The planes z of an image that this rank transforms. */
  const Slabs& GetPlanes() const { return this->Planes; }

  /** How many numbers a spectrum has on the rank with the most. */
  std::size_t SpectrumSize() const;

  /**
   * Sets `spectrum` to sum over x of f(x) exp(-2 pi i k x / Size) of an image. fill(y, z, line)
   * writes the Filled[0] numbers of a line of a plane of this rank, from any thread. Collective.
   */
  void Forward(const std::function<void(int y, int z, double* line)>& fill, Spectrum& spectrum,
    Communicator& ranks) const;

  /**
   * Replaces a spectrum by what is left of it after its transform along z, and calls take(z,
   * values) with each plane of this rank, from any thread: Filled[1] rows of Filled[0] numbers, the
   * sum over k of the spectrum times exp(2 pi i k x / Size) over the number of frequencies. So
   * Forward and then Inverse gives the image. Collective.
   */
  void Inverse(Spectrum& spectrum, const std::function<void(int z, const double* values)>& take,
    Communicator& ranks) const;

  /** The frequencies of a block of this rank: those along x from FirstX on, and that along y. */
  struct Frequencies
  {
    int FirstX, Y;
  };
  std::int64_t NumberOfBlocks() const
  {
    return static_cast<std::int64_t>(this->NumberOfColumns(this->Rank) / Lanes);
  }
  Frequencies FrequenciesOf(std::int64_t block) const
  {
    const std::int64_t of =
      static_cast<std::int64_t>(this->FirstColumn(this->Rank) / Lanes) + block;
    return { static_cast<int>(of / this->Size[1]) * Lanes, static_cast<int>(of % this->Size[1]) };
  }

  /**
   * Calls visit(z, values) on each plane z = 0 … last[2] that this rank is given by `Slabs{last[2]
   * + 1, ranks}`. The values are g(x) + g(-x), where g(x) = sum over y of f(y) h(y + x) for the
   * images f and h of which `a` and `b` are the spectra; both are periodic with Size. The plane has
   * 2 last[1] + 1 rows y = -last[1] … last[1], with x = -last[0] … last[0] in each, and `last` is
   * at most half of Size. As the function is even, the planes z < 0 are known as well. `visit` is
   * called by one thread at a time. Collective.
   *
   * Only what leads to these planes is transformed.
   */
  void Correlate(const Spectrum& a, const Spectrum& b, const std::array<int, 3>& last,
    Communicator& ranks,
    const std::function<void(int z, const std::vector<double>& values)>& visit) const;

private:
  static constexpr int Lanes = LineTransform::Lanes;
  static constexpr std::size_t UnitColumns = 2 * Lanes;

  // Blocks of frequencies along x, and all columns of a plane with what fills the last blocks
  int BlocksX() const { return (this->HalfX() + Lanes - 1) / Lanes; }
  std::size_t ColumnsOfPlane() const { return this->Units.Count * UnitColumns; }
  std::size_t FirstColumn(int rank) const { return this->Units.Begin(rank) * UnitColumns; }
  std::size_t NumberOfColumns(int rank) const { return this->Units.Size(rank) * UnitColumns; }

  // Of a plane, numbers of the blocks in order: those of a block are a line along y
  struct Plane
  {
    std::vector<double> Real, Imaginary;
  };
  void TransformPlane(
    int z, const std::function<void(int, int, double*)>& fill, Plane& plane) const;
  void InvertColumns(Spectrum& spectrum) const;
  void InvertAll(Plane& plane, std::vector<double>& values) const;
  void InvertPlane(Plane& plane, const std::array<int, 3>& last, std::vector<double>& values) const;
  void TransformColumns(Spectrum& spectrum) const;
  // The products of two spectra, transformed along z: for every rank its planes of lags
  std::vector<std::vector<double>> ProductPlanes(
    const Spectrum& a, const Spectrum& b, const Slabs& lags) const;

  std::array<int, 3> Size, Filled;
  LineTransform AlongX, AlongY, AlongZ;
  int Rank;
  Slabs Planes; // of the image
  Slabs Units;  // pairs of blocks
};
}
