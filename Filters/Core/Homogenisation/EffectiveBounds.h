// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

namespace ruc
{
/** The bulk and the shear modulus of an isotropic material, both > 0. */
struct ElasticModuli
{
  double Bulk, Shear;
};

/** Moduli from Young's modulus > 0 and Poisson's ratio > -1 and < 0.5. */
ElasticModuli ModuliOf(double young, double poisson);

/**
 * What bounds and estimates say about one property of an isotropic mixture. What is not known is
 * NaN.
 */
struct PropertyBounds
{
  double Voigt, Reuss;
  double HashinShtrikmanLower, HashinShtrikmanUpper;
  double ThirdOrderLower, ThirdOrderUpper;
  /** From the standard errors of what the third order is made of; at most, with many materials. */
  double ThirdOrderLowerError, ThirdOrderUpperError;
  double Estimate;
};

/**
 * The three-point parameters of the spheres in a mixture of two materials, with their standard
 * errors.
 */
struct TwoPhaseParameters
{
  double Zeta, ZetaError, Eta, EtaError;
};

/**
 * The integrals I_qrs of all phases with their standard errors, both symmetric in r and s, at (q n
 * + r) n + s for n phases.
 */
struct ManyPhaseIntegrals
{
  std::vector<double> Value, Error;
};

/**
 * Voigt's bound <a>, Reuss' 1 / <1/a>, and the bounds of Hashin and Shtrikman for any number of
 * phases, [sum c / (a + y)]^-1 - y, with y = 2 k of the least and the greatest conductivity. The
 * phases' fractions add up to 1, and conductivities are >= 0. (Z. Hashin, S. Shtrikman, J. Appl.
 * Phys. 33, 3125, 1962.)
 */
PropertyBounds BoundConductivity(
  const std::vector<double>& fractions, const std::vector<double>& conductivities);

/**
 * The same of the bulk modulus, with y = 4 G / 3, and of the shear modulus, with y = G (9 K + 8 G)
 * / (6 (K + 2 G)), each of the least and of the greatest K and G among the phases (L. J. Walpole,
 * J. Mech. Phys. Solids 14, 151, 1966).
 */
PropertyBounds BoundBulk(
  const std::vector<double>& fractions, const std::vector<ElasticModuli>& moduli);
PropertyBounds BoundShear(
  const std::vector<double>& fractions, const std::vector<ElasticModuli>& moduli);

/**
 * Adds the third order to bounds of spheres of fraction `c` in a matrix: the bounds of Beran
 * (conductivity), Beran and Molyneux (bulk), Milton and Phan-Thien (shear), and Torquato's
 * estimates for dispersions (S. Torquato, Random Heterogeneous Materials, Springer 2002, chapters
 * 20 and 21). Errors are those of the parameters times the slopes, added as of independent ones.
 */
void AddThirdOrderConductivity(
  double c, double matrix, double spheres, const TwoPhaseParameters& of, PropertyBounds& bounds);
void AddThirdOrderBulk(double c, const ElasticModuli& matrix, const ElasticModuli& spheres,
  const TwoPhaseParameters& of, PropertyBounds& bounds);
void AddThirdOrderShear(double c, const ElasticModuli& matrix, const ElasticModuli& spheres,
  const TwoPhaseParameters& of, PropertyBounds& bounds);

/**
 * Adds the bounds of third order of any number of phases, of which the trial field has an amplitude
 * each. For two phases they are those above. There is no estimate. All values are > 0.
 */
void AddThirdOrderConductivity(const std::vector<double>& fractions,
  const std::vector<double>& conductivities, const ManyPhaseIntegrals& integrals,
  PropertyBounds& bounds);
void AddThirdOrderBulk(const std::vector<double>& fractions,
  const std::vector<ElasticModuli>& moduli, const ManyPhaseIntegrals& integrals,
  PropertyBounds& bounds);
}
