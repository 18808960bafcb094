// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Communicator.h"
#include "Geometry/PackShare.h"
#include "Statistics/PairKernel.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace ruc
{
/**
 * The two-point probability functions S_rs(r_k) of a medium of N_p particle modes and the matrix.
 *
 * Phases are counted from 0 here: 0 to N_p - 1 are the modes 1 to N_p, N_p is the matrix.
 * Normalisation is raw: S_rs(0) = c_r delta_rs, S_rs(infinity) = c_r c_s. S_rs = S_sr is stored
 * once.
 */
struct TwoPointProbability
{
  TwoPointProbability(int modes, const LagGrid& lags);

  int Modes;
  LagGrid Lags;
  std::vector<double> Fractions;           // c_r of every phase, the matrix last
  std::vector<std::vector<double>> Values; // of every unordered pair of phases, K + 1 numbers each

  int Phases() const { return this->Modes + 1; }
  int Pairs() const { return static_cast<int>(this->Values.size()); }
  int PairOf(int r, int s) const;
  std::vector<double>& S(int r, int s) { return this->Values[this->PairOf(r, s)]; }
  const std::vector<double>& S(int r, int s) const { return this->Values[this->PairOf(r, s)]; }

  /**
   * Fills the matrix's fraction and functions in from those of the particles, which is exact for
   * spheres that do not overlap: S_rm = c_r - sum_s S_rs, S_mm = 1 - 2 sum_r c_r + sum_rs S_rs.
   */
  void CompleteMatrix();

  /** "1", "2", …, "m". */
  std::string PhaseName(int phase) const;
};

/** ||f|| = sqrt(sum over k = 1…K of f(r_k)^2), the paper's discrete norm; not divided by K. */
double DiscreteNorm(const std::vector<double>& values);

/**
 * F2, equation (13): the sum over all N^2 ordered pairs of phases of || S_rs of a - S_rs of b ||.
 * Both must have the same phases and lags.
 */
double TwoPointDifference(const TwoPointProbability& a, const TwoPointProbability& b);

/**
 * Exact S_rs of a pack of spheres, as a sum over pairs of the orientation-averaged overlap
 * (Geometry/SphereOverlap.h):
 *
 *     S_rs(r) = delta_rs / V sum_i V_ii(r)
 *               + sum over i in r, j in s, i != j of g(r; d_ij) / gamma(d_ij)
 *
 * with V the volume of the window of the centres and gamma its set covariance; over all images
 * along periodic axes. It is unbiased for a stationary pack, without clipping spheres at the border
 * of the window. Spheres that overlap are counted twice where they do.
 *
 * The pack may be spread over ranks (PackShare): every rank works on its share and the surroundings
 * within LargestLag + a + b that it asks the others for. The work is a number of chunks; a chunk
 * adds integers to an array of SumsSize(), so the chunks may be shared out in any way and the
 * arrays of different threads and ranks added up. Few sphere types (mode and radius) share tables
 * over the distance, with an error below 1e-6 c_r (1e-5 where lags are much finer than the
 * spheres); many use the closed form for every pair.
 */
class ExactPairSum
{
public:
  /**
   * Collective. Throws std::invalid_argument, the same on every rank, for lags out of range: see
   * LargestLag().
   */
  ExactPairSum(const PackShare& share, const LagGrid& lags, Communicator& ranks);
  /** For one rank that holds all of a pack, in any order. */
  ExactPairSum(const SpherePack& pack, const Window& window, const LagGrid& lags);
  ~ExactPairSum();

  /**
   * The largest lag the window allows: 0.999 of (the shortest non-periodic edge less the largest
   * diameter), so that every pair that matters has a place in the window with some weight left;
   * four times the shortest edge where all axes are periodic.
   */
  static double LargestLag(double largestRadius, const Window& window);

  /** Throws std::invalid_argument for a number of lags, or of all numbers of S_rs, out of range. */
  static void CheckNumberOfLags(int modes, const LagGrid& lags);
  /** The same, and for a maximum lag out of range: what the constructor asks of lags. */
  static void CheckLags(const PackShare& share, const LagGrid& lags);

  /** Of this rank. */
  std::size_t NumberOfChunks() const;
  /** The same on every rank. */
  std::size_t SumsSize() const;

  /**
   * Adds the chunks first, first + stride, …, on all threads of OpenMP, to `sums`. `progress` is
   * told the share that is done, on the calling thread.
   */
  void AddChunks(std::size_t first, std::size_t stride, std::int64_t* sums,
    const std::function<void(double)>& progress = {}) const;

  /** From the sums over all chunks of all ranks. */
  TwoPointProbability Result(const std::vector<std::int64_t>& sums) const;

private:
  class Method;
  class Tabulated;
  class Direct;
  std::unique_ptr<Method> Sum;
};
}
