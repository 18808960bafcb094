// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Homogenisation/EffectiveBounds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

using ruc::ElasticModuli;
using ruc::PropertyBounds;
using ruc::TwoPhaseParameters;

namespace
{
constexpr TwoPhaseParameters Some = { 0.15, 0.01, 0.3, 0.02 };

PropertyBounds Conductivity(double c, double k1, double k2, const TwoPhaseParameters& of)
{
  PropertyBounds bounds = ruc::BoundConductivity({ c, 1.0 - c }, { k2, k1 });
  ruc::AddThirdOrderConductivity(c, k1, k2, of, bounds);
  return bounds;
}
PropertyBounds Bulk(
  double c, const ElasticModuli& a, const ElasticModuli& b, const TwoPhaseParameters& of)
{
  PropertyBounds bounds = ruc::BoundBulk({ c, 1.0 - c }, { b, a });
  ruc::AddThirdOrderBulk(c, a, b, of, bounds);
  return bounds;
}
PropertyBounds Shear(
  double c, const ElasticModuli& a, const ElasticModuli& b, const TwoPhaseParameters& of)
{
  PropertyBounds bounds = ruc::BoundShear({ c, 1.0 - c }, { b, a });
  ruc::AddThirdOrderShear(c, a, b, of, bounds);
  return bounds;
}

void ExpectOrder(const PropertyBounds& of)
{
  const double rounding = 1e-12 * of.Voigt;
  EXPECT_LE(of.Reuss, of.HashinShtrikmanLower + rounding);
  EXPECT_LE(of.HashinShtrikmanLower, of.ThirdOrderLower + rounding);
  EXPECT_LE(of.ThirdOrderLower, of.ThirdOrderUpper + rounding);
  EXPECT_LE(of.ThirdOrderUpper, of.HashinShtrikmanUpper + rounding);
  EXPECT_LE(of.HashinShtrikmanUpper, of.Voigt + rounding);
}

// I_qrs of two phases, spheres first, of which only I_222 = 2 c (1 - c) zeta / 9 and that of the
// matrix are free: the sums over one index vanish
ruc::ManyPhaseIntegrals IntegralsOf(double c, double zeta)
{
  ruc::ManyPhaseIntegrals integrals;
  integrals.Error.assign(8, 0.0);
  for (int q = 0; q < 2; ++q)
  {
    for (int r = 0; r < 2; ++r)
    {
      for (int s = 0; s < 2; ++s)
      {
        const double own = 2.0 * c * (1.0 - c) / 9.0 * (q == 0 ? zeta : 1.0 - zeta);
        integrals.Value.push_back(r == s ? own : -own);
      }
    }
  }
  return integrals;
}
}

TEST(EffectiveBounds, LieInTheOrderOfWhatTheyKnow)
{
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> share(0.05, 0.95), power(-2.0, 2.0);
  for (int n = 0; n < 1000; ++n)
  {
    const double c = share(engine), zeta = share(engine);
    // Of any medium eta is at least 5 zeta / 21, as J_rrr is the mean of a square
    const double eta = 5.0 / 21.0 * zeta + (16.0 / 21.0) * share(engine);
    const TwoPhaseParameters of = { zeta, 0.0, eta, 0.0 };
    const auto modulus = [&]() { return std::pow(10.0, power(engine)); };
    const ElasticModuli a = { modulus(), modulus() };
    // Walpole's bounds are of phases of which one is the stiffer in both moduli
    const double factor = 1.0 + share(engine);
    const ElasticModuli b = { factor * a.Bulk, factor * a.Shear * 1.3 };
    ExpectOrder(Conductivity(c, modulus(), modulus(), of));
    ExpectOrder(Bulk(c, a, b, of));
    ExpectOrder(Shear(c, a, b, of));
  }
}

TEST(EffectiveBounds, OfThirdOrderMeetTheOthersWhereZetaIsNoneOrAll)
{
  const double c = 0.4;
  const TwoPhaseParameters none = { 0.0, 0.0, 0.0, 0.0 }, all = { 1.0, 0.0, 1.0, 0.0 };
  const ElasticModuli a = { 2.0, 1.0 }, b = { 30.0, 20.0 };
  for (const auto& [without, with] :
    { std::pair(Conductivity(c, 1.0, 20.0, none), Conductivity(c, 1.0, 20.0, all)),
      std::pair(Bulk(c, a, b, none), Bulk(c, a, b, all)),
      std::pair(Shear(c, a, b, none), Shear(c, a, b, all)) })
  {
    const double rounding = 1e-12 * with.Voigt;
    EXPECT_NEAR(without.ThirdOrderLower, without.HashinShtrikmanLower, rounding);
    EXPECT_NEAR(without.ThirdOrderUpper, without.HashinShtrikmanLower, rounding);
    EXPECT_NEAR(with.ThirdOrderLower, with.HashinShtrikmanUpper, rounding);
    EXPECT_NEAR(with.ThirdOrderUpper, with.HashinShtrikmanUpper, rounding);
  }
}

TEST(EffectiveBounds, AndEstimatesDifferInTheFourthOrderOfTheContrast)
{
  const auto apart = [](double d)
  {
    const PropertyBounds k = Conductivity(0.55, 1.0, 1.0 + d, Some);
    const ElasticModuli a = { 2.0, 1.0 }, b = { 2.0 * (1.0 + d), 1.0 - 0.7 * d };
    const PropertyBounds bulk = Bulk(0.55, a, b, Some), shear = Shear(0.55, a, b, Some);
    std::vector<double> values;
    for (const PropertyBounds& of : { k, bulk, shear })
    {
      values.push_back((of.ThirdOrderUpper - of.ThirdOrderLower) / std::pow(d, 4));
      values.push_back((of.Estimate - of.ThirdOrderLower) / std::pow(d, 4));
    }
    return values;
  };
  // A difference of the order d^4 has a limit over d^4, which is reached linearly in d: half of d
  // has half of the distance, while the order d^3 would double the ratio
  const std::vector<double> one = apart(0.04), half = apart(0.02), quarter = apart(0.01);
  for (std::size_t n = 0; n < one.size(); ++n)
  {
    EXPECT_GT(std::abs(quarter[n]), 0.0);
    EXPECT_LT(std::abs(quarter[n] - half[n]), 0.1 * std::abs(half[n])) << n;
    EXPECT_NEAR((half[n] - one[n]) / (quarter[n] - half[n]), 2.0, 0.5) << n;
  }
}

TEST(EffectiveBounds, OfManyPhasesAreThoseOfTwo)
{
  const double c = 0.55, zeta = 0.15;
  const TwoPhaseParameters of = { zeta, 0.0, 0.3, 0.0 };
  const ElasticModuli a = { 2.0, 1.0 }, b = { 30.0, 20.0 };
  PropertyBounds many = ruc::BoundConductivity({ c, 1.0 - c }, { 10.0, 1.0 });
  ruc::AddThirdOrderConductivity({ c, 1.0 - c }, { 10.0, 1.0 }, IntegralsOf(c, zeta), many);
  const PropertyBounds two = Conductivity(c, 1.0, 10.0, of);
  EXPECT_NEAR(many.ThirdOrderLower, two.ThirdOrderLower, 1e-11);
  EXPECT_NEAR(many.ThirdOrderUpper, two.ThirdOrderUpper, 1e-11);
  PropertyBounds manyBulk = ruc::BoundBulk({ c, 1.0 - c }, { b, a });
  ruc::AddThirdOrderBulk({ c, 1.0 - c }, { b, a }, IntegralsOf(c, zeta), manyBulk);
  const PropertyBounds twoBulk = Bulk(c, a, b, of);
  EXPECT_NEAR(manyBulk.ThirdOrderLower, twoBulk.ThirdOrderLower, 1e-10);
  EXPECT_NEAR(manyBulk.ThirdOrderUpper, twoBulk.ThirdOrderUpper, 1e-10);
}

TEST(EffectiveBounds, OfEqualPhasesAreThatPhase)
{
  const ElasticModuli a = { 2.0, 1.0 };
  for (const PropertyBounds& of : { Conductivity(0.3, 2.0, 2.0, Some), Bulk(0.3, a, a, Some) })
  {
    for (double value : { of.Voigt, of.Reuss, of.HashinShtrikmanLower, of.HashinShtrikmanUpper,
           of.ThirdOrderLower, of.ThirdOrderUpper, of.Estimate })
    {
      EXPECT_NEAR(value, 2.0, 1e-14);
    }
  }
  // Three phases, two of them alike: what needs no statistics is that of two phases
  const PropertyBounds three = ruc::BoundConductivity({ 0.2, 0.3, 0.5 }, { 7.0, 7.0, 1.0 });
  const PropertyBounds two = ruc::BoundConductivity({ 0.5, 0.5 }, { 7.0, 1.0 });
  EXPECT_NEAR(three.HashinShtrikmanLower, two.HashinShtrikmanLower, 1e-14);
  EXPECT_NEAR(three.HashinShtrikmanUpper, two.HashinShtrikmanUpper, 1e-14);
}

TEST(EffectiveBounds, HaveTheErrorsOfTheirParameters)
{
  const PropertyBounds at = Conductivity(0.5, 1.0, 10.0, Some);
  const double step = 1e-3;
  const auto moved = [&](double by) {
    return Conductivity(0.5, 1.0, 10.0, { Some.Zeta + by, 0.0, Some.Eta, 0.0 });
  };
  const double slope = (moved(step).ThirdOrderUpper - moved(-step).ThirdOrderUpper) / (2.0 * step);
  EXPECT_NEAR(at.ThirdOrderUpperError, slope * Some.ZetaError, 1e-4 * at.ThirdOrderUpperError);
}
