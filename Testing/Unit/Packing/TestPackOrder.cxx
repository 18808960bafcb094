// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Packing/PackOrder.h"

#include "Oracles.h"

namespace
{
// `basis` in each of 4^3 cubes with edges of 1
ruc::SpherePack Crystal(const std::vector<ruc::Vector3>& basis, double radius)
{
  ruc::SpherePack pack;
  for (int n = 0; n < 64; ++n)
  {
    for (const ruc::Vector3& b : basis)
    {
      pack.X.push_back(n % 4 + b[0] + 0.25);
      pack.Y.push_back(n / 4 % 4 + b[1] + 0.25);
      pack.Z.push_back(n / 16 + b[2] + 0.25);
      pack.Radius.push_back(radius);
    }
  }
  return pack;
}
}

// The values of Q_6 are those of Steinhardt, Nelson and Ronchetti
TEST(PackOrder, FaceCentredCubic)
{
  const ruc::SpherePack pack =
    Crystal({ { 0, 0, 0 }, { 0.5, 0.5, 0 }, { 0.5, 0, 0.5 }, { 0, 0.5, 0.5 } }, std::sqrt(0.125));
  const ruc::PackOrder order = ruc::MeasureOrder(pack, oracle::PeriodicCube(4.0), 1e-6);
  EXPECT_EQ(order.CoordinationNumber, 12.0);
  EXPECT_EQ(order.RattlerPercent, 0.0);
  EXPECT_NEAR(order.Q6, 0.57452, 1e-5);
  EXPECT_EQ(order.Neighbours, 256 * 6);
  EXPECT_TRUE(order.IsCrystalline());
}

// Some order is no crystal where there are few neighbours, and little order where there are many
TEST(PackOrder, WhatIsACrystal)
{
  ruc::PackOrder order;
  const auto isCrystalline = [&](double q6, std::int64_t neighbours)
  {
    order.Q6 = q6;
    order.Neighbours = neighbours;
    return order.IsCrystalline();
  };
  EXPECT_FALSE(isCrystalline(0.09, 1'000'000));
  EXPECT_TRUE(isCrystalline(0.11, 7000));
  EXPECT_FALSE(isCrystalline(0.2, 100));
  EXPECT_TRUE(isCrystalline(0.57, 100));
  EXPECT_FALSE(isCrystalline(0.0, 0));
}

TEST(PackOrder, SimpleCubic)
{
  const ruc::PackOrder order =
    ruc::MeasureOrder(Crystal({ { 0, 0, 0 } }, 0.5), oracle::PeriodicCube(4.0), 1e-6);
  EXPECT_EQ(order.CoordinationNumber, 6.0);
  EXPECT_NEAR(order.Q6, 0.35355, 1e-5);
}

TEST(PackOrder, WhatIsNotHeldFalls)
{
  // A sphere that touches nothing in a crystal, beside one more that has lost two of six contacts
  ruc::SpherePack pack = Crystal({ { 0, 0, 0 } }, 0.5);
  pack.Radius[21] = 0.4;
  ruc::PackOrder order = ruc::MeasureOrder(pack, oracle::PeriodicCube(4.0), 1e-6);
  EXPECT_EQ(order.RattlerPercent, 100.0 / 64.0);
  EXPECT_EQ(order.CoordinationNumber, (57 * 6 + 6 * 5) / 63.0);
  // Touching spheres in a row: no one is held, by falling one after the other
  ruc::SpherePack row;
  for (int n = 0; n < 10; ++n)
  {
    row.X.push_back(n + 0.5);
    row.Y.push_back(5.0);
    row.Z.push_back(5.0);
    row.Radius.push_back(0.5);
  }
  order = ruc::MeasureOrder(row, oracle::PeriodicCube(10.0), 1e-6);
  EXPECT_EQ(order.RattlerPercent, 100.0);
  EXPECT_EQ(order.CoordinationNumber, 0.0);
}

TEST(PackOrder, WallsHoldToo)
{
  ruc::SpherePack pack = Crystal({ { 0, 0, 0 } }, 0.5);
  for (std::vector<double>* c : { &pack.X, &pack.Y, &pack.Z })
  {
    for (double& x : *c)
    {
      x += 0.25;
    }
  }
  const ruc::Window walled =
    ruc::Window::MakeBox({ 0, 0, 0 }, { 4, 4, 4 }, { false, false, false });
  EXPECT_EQ(ruc::MeasureOrder(pack, walled, 1e-6).CoordinationNumber, 6.0);
}
