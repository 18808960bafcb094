// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Statistics/ThirdOrder/SolidHarmonics.h"

#include <array>
#include <cstddef>
#include <vector>

namespace ruc
{
/** How far the sums of LocalMultipoles go. Lengths are in the unit of the pack. */
struct MultipoleSettings
{
  double CutOff = 0.0;    // up to here spheres count in the degrees 2 to 6
  int Degree = 10;        // from 4 to GreatestDegree
  int Sources = 1;        // the number of phases that spheres may be of
  bool WithFourth = true; // whether A is summed too
  // Of Ewald's sum (ThirdOrderEwald), whose near part these sums then are. 0: the sums end
  // smoothly.
  double Alpha = 0.0;

  /** Up to here spheres count in the degrees above 6, whose terms fall faster. */
  double NearCutOff() const { return 0.75 * this->CutOff; }
};

/**
 * The field of the spheres around a centre i, which is harmonic inside the sphere i, as multipoles
 * around the centre. For every phase s of the other spheres j, at x = x_j - x_i and the distance r,
 * and with all lengths in units of the radius of i,
 *
 *     q_lm = sum over j in s of a_j^3 g_l(r) I_lm(x),
 *     A_lm = sum over j in s of a_j^3 (a_j^2 / 5 - r^2 / (2l - 1)) g_l(r) I_lm(x),   l >= 4,
 *
 * where I_lm is that of SolidHarmonics.h. q alone makes zeta; eta has A as well. g_l = 1 - t^3 (10
 * - 15 t + 6 t^2) ends the sums smoothly, with t from 0 at 0.7 of the cut-off to 1 at the cut-off.
 * In a periodic box the two sums that fall as r^-3, q_2m and the second term of A_4m, have the
 * factor of Ewald's near part instead, and ThirdOrderEwald adds the far one.
 *
 * Every term is rounded to a multiple of 2^-38 n_lm^(-1/2), and sums of these are exact as long as
 * they are smaller than 2^15 n_lm^(-1/2), as they are for spheres that do not overlap. So the sums
 * are the same bits in whatever order the spheres come.
 */
class LocalMultipoles
{
public:
  explicit LocalMultipoles(const MultipoleSettings& settings);

  const MultipoleSettings& GetSettings() const { return this->Settings; }

  /** The spheres around one centre, in units of its radius. */
  class Neighbours
  {
  public:
    explicit Neighbours(const MultipoleSettings& settings);

    /** Starts with the surroundings of a centre of this radius. */
    void Start(double radius);
    /**
     * Adds a sphere of phase `source`, counted from 0, closer than the cut-off: its displacement
     * from the centre and its squared distance, in the unit of the pack.
     */
    void Add(double dx, double dy, double dz, double d2, double radius, int source);

    /** How many have been added. */
    std::size_t Size() const { return this->Count; }

    struct List
    {
      std::vector<double> X, Y, Z, Radius;
      std::vector<std::size_t> Order; // when each was added
    };

  private:
    friend class LocalMultipoles;
    double Inverse = 1.0, Near2;
    std::size_t Count = 0;
    std::vector<List> Near, Far; // for every source those within the near cut-off and those beyond
  };

  /** The numbers that a centre has: for every source q and then A, each in real and imaginary
   * parts. */
  std::size_t Size() const { return this->Settings.Sources * this->SizeOfSource(); }
  std::size_t SizeOfSource() const { return (this->Settings.WithFourth ? 2 : 1) * this->Count(); }
  /** Where A of a source starts after its q. */
  std::size_t Count() const { return 2 * HarmonicCount(this->Settings.Degree); }

  /** Puts the multipoles of a centre, but for the far part of Ewald's sum, into `sums`. */
  void Sum(const Neighbours& around, double* sums) const;

  /**
   * Puts the gradients of the sum of lambda times the numbers q of a centre by the places of its
   * neighbours into `forces`: three numbers for each, in the order in which they were added. The
   * gradient by the place of the centre is the opposite of their sum. The far part of Ewald's sum
   * has its own (ThirdOrderEwald::AddForces); A does not count.
   */
  void FindForces(const Neighbours& around, const double* lambda, double* forces) const;

private:
  struct Kernel;
  // Value and slope times the width of a step of Ewald's two factors, at equal steps of
  // (r/cut-off)^2
  using Knot = std::array<double, 4>;

  MultipoleSettings Settings;
  std::vector<Knot> Factors;
  std::vector<double> Rounders; // for every l, m
};
}
