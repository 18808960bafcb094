// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/AlignedNumbers.h"
#include "ruc/Base/Vector3.h"
#include "ruc/Statistics/ThirdOrder/SolidHarmonics.h"

#include <cstddef>
#include <tuple>
#include <vector>

namespace ruc
{
/** The highest degree of ShellMultipoles. Their gradients take harmonics of one degree more. */
constexpr int HighestOfShells = GreatestDegree - 1;

/** What ShellMultipoles look at. */
struct ShellSettings
{
  /** Of every shell the distance from the surface of the sphere around whose centre it lies, > 0.
   */
  std::vector<double> Distances;
  int Degree = 8;  // from 0 to HighestOfShells
  int Classes = 1; // the number of classes that spheres may be of

  /** The number of T of a centre, and the place of one among them; s <= q. */
  std::size_t NumberOfProducts() const
  {
    return this->PlaceOf(this->Classes - 1, this->Classes, 0, 0, 0);
  }
  std::size_t PlaceOf(int s, int q, int l, int n1, int n2) const
  {
    const std::size_t pair = std::size_t(s) * this->Classes - s * (s + 1) / 2 + q;
    const std::size_t shells = this->Distances.size();
    return ((pair * (this->Degree + 1) + l) * shells + n1) * shells + n2;
  }

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Distances, self.Degree, self.Classes);
  }
};

/**
 * Who is around a centre, and in which directions: on each shell n around the centre of a sphere of
 * radius a, of radius rho_n = a + Distances[n], a sphere j of radius b cuts a cap at whose border
 * the angle to its direction u_j has the cosine x = (d^2 + rho_n^2 - b^2) / (2 d rho_n), d being
 * its distance. The multipoles of what the spheres of a class s cut are
 *
 *     a_lm^s(n) = sum over j in s of C_l(x_jn) Y_lm(u_j),   C_l(x) = 2 pi int_x^1 P_l(t) dt,
 *
 * where Y_lm are real, such that the sum over m of Y_lm(u) Y_lm(v) is P_l(u v). Then, with
 *
 *     T_sq,l(n1, n2) = (2 l + 1) / (16 pi^2) sum over m of a_lm^s(n1) a_lm^q(n2),
 *
 * the sum over l of T_l P_l(cos theta) is the probability that a point of the shell n1 lies in
 * class s and a point of the shell n2, at the angle theta from it, in class q, if spheres do not
 * overlap.
 *
 * Every term of a_lm is rounded to a multiple of 2^-40, so that the sums, which are below 2^11, are
 * the same bits in whatever order the spheres come.
 */
class ShellMultipoles
{
public:
  explicit ShellMultipoles(const ShellSettings& settings);

  const ShellSettings& GetSettings() const { return this->Settings; }

  /** A sphere near a centre. */
  struct Neighbour
  {
    Vector3 Direction; // of length 1
    double Distance;
    double Radius;
    int Class; // from 0
  };

  /** The number of multipoles of a centre. They are best kept in AlignedNumbers. */
  std::size_t Size() const;
  /** Puts the multipoles around a sphere of this radius into `sums`. */
  void Sum(double radius, const std::vector<Neighbour>& around, double* sums) const;
  /**
   * Puts the gradients of the sum of lambda times the multipoles by the places of the neighbours
   * into `forces`, three numbers for each. That by the place of the centre is the opposite of their
   * sum.
   */
  void FindForces(double radius, const std::vector<Neighbour>& around, const double* lambda,
    double* forces) const;

  /** Puts T of a centre, from its multipoles, into `products`, as ShellSettings says. */
  void FindProducts(const double* sums, double* products) const;
  /**
   * Puts the gradient of the sum of mu times T by the multipoles into `lambda`. `factors` is what
   * MakeFactors makes of mu, which has a number for every T.
   */
  void FindGradient(const double* sums, const double* factors, double* lambda) const;
  AlignedNumbers MakeFactors(const double* mu) const;

private:
  // The place of the first shell of a harmonic of a class; shells come in blocks of lanes
  std::size_t PlaceOfHarmonic(int s, int harmonic) const;
  std::size_t PlaceOfFactor(int s, int q, int l, int n2) const;

  ShellSettings Settings;
  int Shells;                 // rounded up to whole blocks
  int Harmonics;              // the real parts of all l, m >= 0, each followed by the imaginary one
  std::vector<double> Padded; // the distances, the last of them repeated
};
}
