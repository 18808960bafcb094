// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Homogenisation/EffectiveResult.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace ruc;

namespace
{
CellRun RunOf(double edge, InterfaceRule rule, double value)
{
  CellRun run;
  run.Edge = edge;
  run.Rule = rule;
  run.Cell.Tensor.Size = 3;
  for (int a = 0; a < 3; ++a)
  {
    run.Cell.Tensor.Value[a][a] = value + a;
    run.Cell.Tensor.IterationError[a] = 0.01 * (a + 1);
  }
  run.Cell.Tensor.Value[0][1] = run.Cell.Tensor.Value[1][0] = 0.5;
  return run;
}

EffectiveTensor Isotropic(const ElasticModuli& of)
{
  EffectiveTensor tensor;
  tensor.Size = 6;
  const double lambda = of.Bulk - 2.0 / 3.0 * of.Shear;
  for (int a = 0; a < 6; ++a)
  {
    for (int b = 0; b < 6; ++b)
    {
      tensor.Value[a][b] =
        (a < 3 && b < 3 ? lambda : 0.0) + (a == b ? (a < 3 ? 2.0 : 1.0) * of.Shear : 0.0);
    }
  }
  return tensor;
}
}

TEST(EffectiveResult, HasThePartsOfATensor)
{
  const std::vector<CellQuantity> of =
    CombineRuns(CellProperty::Conductivity, { RunOf(1.0, InterfaceRule::Laminate, 3.0) });
  const char* const names[] = { "k_xx", "k_yy", "k_zz", "k_yz", "k_xz", "k_xy", "k" };
  const double values[] = { 3.0, 4.0, 5.0, 0.0, 0.0, 0.5, 4.0 };
  ASSERT_EQ(of.size(), 7u);
  for (int n = 0; n < 7; ++n)
  {
    EXPECT_EQ(of[n].Name, names[n]);
    EXPECT_DOUBLE_EQ(of[n].Value, values[n]);
    EXPECT_TRUE(std::isnan(of[n].DiscretisationError));
  }
  EXPECT_DOUBLE_EQ(of[6].IterationError, 0.02);
  EXPECT_DOUBLE_EQ(of[5].IterationError, std::sqrt(0.01 * 0.02));
}

TEST(EffectiveResult, TellsHowFarGridsAndRulesAreApart)
{
  // 3 at h = 1 and 3.5 at h = 2: 2.5 at h = 0
  const std::vector<CellQuantity> line = CombineRuns(CellProperty::Conductivity,
    { RunOf(2.0, InterfaceRule::Laminate, 3.5), RunOf(1.0, InterfaceRule::Laminate, 3.0) });
  EXPECT_DOUBLE_EQ(line[0].Value, 3.0);
  EXPECT_DOUBLE_EQ(line[0].DiscretisationError, 0.5);
  // Harmonic from below: 2 at h = 1, 1.8 at h = 2, 2.2 at h = 0
  const std::vector<CellQuantity> pair = CombineRuns(CellProperty::Conductivity,
    { RunOf(1.0, InterfaceRule::Laminate, 3.0), RunOf(2.0, InterfaceRule::Laminate, 3.5),
      RunOf(1.0, InterfaceRule::Harmonic, 2.0), RunOf(2.0, InterfaceRule::Harmonic, 1.8) });
  EXPECT_DOUBLE_EQ(pair[0].Value, 2.5);
  EXPECT_NEAR(pair[0].DiscretisationError, 0.5, 1e-12);
}

TEST(EffectiveResult, HasTheModuliOfAnIsotropicStiffness)
{
  CellRun run;
  run.Cell.Tensor = Isotropic({ 7.0, 3.0 });
  const std::vector<CellQuantity> of = CombineRuns(CellProperty::Elasticity, { run });
  ASSERT_EQ(of.size(), 23u);
  EXPECT_EQ(of[0].Name, "C_11");
  EXPECT_EQ(of[20].Name, "C_66");
  EXPECT_EQ(of[21].Name, "K");
  EXPECT_NEAR(of[21].Value, 7.0, 1e-12);
  EXPECT_EQ(of[22].Name, "G");
  EXPECT_NEAR(of[22].Value, 3.0, 1e-12);
}

TEST(EffectiveResult, ExpandsAsItsPhasesDo)
{
  const ElasticModuli a = { 4.0, 1.0 }, b = { 40.0, 30.0 };
  // All matrix, all spheres, and of two alike any stiffness
  EXPECT_NEAR(ExpansionOf(Isotropic(a), a, b, 5.0, 1.0)[0], 5.0, 1e-12);
  EXPECT_NEAR(ExpansionOf(Isotropic(b), a, b, 5.0, 1.0)[1], 1.0, 1e-12);
  const EffectiveTensor between = Isotropic({ 9.0, 2.0 });
  EXPECT_NEAR(ExpansionOf(between, a, b, 3.0, 3.0)[2], 3.0, 1e-12);
  // Levin's formula of a bulk modulus
  const double c = (1.0 / 9.0 - 1.0 / 4.0) / (1.0 / 40.0 - 1.0 / 4.0);
  EXPECT_NEAR(ExpansionOf(between, a, b, 5.0, 1.0)[0], 5.0 + (1.0 - 5.0) * c, 1e-12);
  EXPECT_NEAR(ExpansionOf(between, a, b, 5.0, 1.0)[4], 0.0, 1e-12);
  EXPECT_TRUE(std::isnan(ExpansionOf(between, a, { 4.0, 2.0 }, 5.0, 1.0)[0]));
}

TEST(EffectiveResult, BoundsModesOfOneMaterialAsOne)
{
  const std::vector<double> fractions = { 0.2, 0.3, 0.5 };
  const PropertyBounds two = BoundPack(MakeConductors(1.0, { 10.0 }, 2), fractions, nullptr)[0];
  EXPECT_DOUBLE_EQ(two.Voigt, 5.5);
  EXPECT_TRUE(std::isnan(two.ThirdOrderLower));
  ThirdOrderOfSpheres third;
  third.Spheres.Zeta = { 0.1, 0.01 };
  third.Spheres.Eta = { 0.3, 0.01 };
  const PropertyBounds with = BoundPack(MakeConductors(1.0, { 10.0 }, 2), fractions, &third)[0];
  PropertyBounds expected = two;
  AddThirdOrderConductivity(0.5, 1.0, 10.0, { 0.1, 0.01, 0.3, 0.01 }, expected);
  EXPECT_DOUBLE_EQ(with.ThirdOrderUpper, expected.ThirdOrderUpper);
  EXPECT_EQ(BoundPack(MakeElastic(3.0, 0.38, { 70.0 }, { 0.2 }, 2), fractions, &third).size(), 2u);
}

// Modes of three materials, two of which are alike but in name: no statistics can make the bounds
// wider than those of two
TEST(EffectiveResult, BoundsOfMoreMaterialsAreNoWider)
{
  SpherePack pack;
  const int edge = 4;
  for (int n = 0; n < edge * edge * edge; ++n)
  {
    pack.X.push_back(n % edge + 0.1 * (n % 3));
    pack.Y.push_back(n / edge % edge + 0.1 * (n % 2));
    pack.Z.push_back(n / edge / edge + 0.05 * (n % 5));
    pack.Radius.push_back(0.39);
    pack.Mode.push_back(1 + n * 7 % 5 / 3);
  }
  const Window box = Window::MakeBox({ 0, 0, 0 }, { edge, edge, edge }, { true, true, true });
  const PackShare share = SharePack(pack, box);
  Communicator one;
  ThirdOrderSettings settings;
  settings.ByMode = true;
  const ThirdOrderOfSpheres modes = MeasureThirdOrder(share, settings, one);
  settings.ByMode = false;
  const ThirdOrderOfSpheres spheres = MeasureThirdOrder(share, settings, one);
  const std::vector<double> c = { modes.Fractions[0], modes.Fractions[1], modes.Fractions[2] };
  const PropertyBounds two = BoundPack(MakeConductors(1.0, { 10.0 }, 2), c, &spheres)[0];
  const PropertyBounds three =
    BoundPack(MakeConductors(1.0, { 10.0, 10.0 * (1.0 + 1e-9) }, 2), c, &modes)[0];
  const double slack = 1e-3 * two.Voigt; // of the cut-off of the third order
  EXPECT_GE(three.ThirdOrderLower, two.ThirdOrderLower - slack);
  EXPECT_LE(three.ThirdOrderUpper, two.ThirdOrderUpper + slack);
  EXPECT_LT(three.ThirdOrderLower, three.ThirdOrderUpper);
}
