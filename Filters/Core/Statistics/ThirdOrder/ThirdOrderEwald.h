// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Base/Vector3.h"
#include "ruc/Particles/PackShare.h"
#include "ruc/Statistics/ThirdOrder/LocalMultipoles.h"

#include <array>
#include <cstddef>
#include <vector>

namespace ruc
{
/**
 * The far part of LocalMultipoles in a periodic box, by Ewald's way: what the smooth remainders of
 * q_2m and of the second sum of A_4m, whose terms fall as r^-3 and do not sum up absolutely, add as
 * Fourier series,
 *
 *     q_2m += -(4 pi / 3V) sum over k != 0 of e^(-k^2/4 alpha^2) I_2m(k/|k|) S(k) e^(-i k x_i),
 *     A_4m -= (8 pi / 105V) sum of (1 + k^2/4 alpha^2) e^(-k^2/4 alpha^2) I_4m(k/|k|) S(k) e^(-i k
 * x_i),
 *
 * with S(k) = sum over j of a_j^3 e^(i k x_j) for every source. Wave vectors go up to |k| = 2
 * alpha^2 CutOff, where the factor is as small as in the near part at the cut-off, e^(-(alpha
 * CutOff)^2). There is no boundary term, since it would be a trace, which degree 2 has not; and the
 * term of the centre itself is 0.
 *
 * Every rank sums S(k) over its own spheres, each term rounded to a common unit so that all sums
 * are exact, and has the whole of it then.
 */
class ThirdOrderEwald
{
public:
  /**
   * `source` is the phase of each own sphere, counted from 0; the window is periodic along all
   * axes, and Alpha > 0. Collective.
   */
  ThirdOrderEwald(const PackShare& share, const std::vector<int>& source,
    const MultipoleSettings& settings, Communicator& ranks);

  /** The number of centres that Add takes at a time. */
  static constexpr int Block = 8;

  /**
   * Adds the far part to the multipoles of `count` centres of the share, at most Block. `centres`
   * are their places, and sums + n * LocalMultipoles::Size() the multipoles of the n-th.
   */
  void Add(
    const std::size_t* centres, int count, const LocalMultipoles& multipoles, double* sums) const;

  /** About the number of wave vectors for a box, half of those that there are. */
  static double NumberOfWaves(const Window& box, const MultipoleSettings& settings);

  /**
   * Adds the gradient of sum over the own centres of lambda times the far part of q to `forces`,
   * three numbers for every own sphere. `lambda` has the numbers of LocalMultipoles for every
   * sphere of the share, which are 0 off the centres; those of A do not count. Collective.
   */
  void AddForces(const std::vector<double>& lambda, const LocalMultipoles& multipoles,
    std::vector<double>& forces, Communicator& ranks) const;

  /** A wave vector and what it is multiplied by: one of each pair k, -k. */
  struct Wave
  {
    Vector3 K;
    // The factors of q_20, of the real and imaginary parts of q_21 and q_22, and those of A_4m
    std::array<double, 5> Second;
    std::array<double, 9> Fourth;
  };
  /** Wave vectors that differ along z alone: Places are those along x and y, and of the first along
   * z. */
  struct Row
  {
    std::array<int, 3> Places;
    std::size_t Begin, End; // of Waves
  };

private:
  void FindWaves(const MultipoleSettings& settings);
  void AddWave(const Vector3& k, double k2, double alpha);
  // Sums of complex numbers over spheres for every source and wave, in units of 2^unit: `spheres`
  // are those that count for each source, and add(source, block, count, tables, rounding, sums)
  // adds a block of them
  template <class AddBlock>
  std::vector<double> SumWaves(const std::vector<std::vector<std::size_t>>& spheres, int unit,
    Communicator& ranks, AddBlock&& add) const;

  const PackShare& Share;
  int Sources;
  std::vector<std::vector<std::size_t>> Spheres; // the own spheres of every source
  bool WithFourth;
  std::array<int, 3> Most; // the largest number of waves along each edge
  std::vector<Wave> Waves;
  std::vector<Row> Rows;
  std::vector<double> Structure; // for every source and wave the real and imaginary parts of S(k)
};
}
