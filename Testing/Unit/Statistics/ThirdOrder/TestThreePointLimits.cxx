// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/ThirdOrder/ThreePointLimits.h"

#include "Oracles.h"
#include "ruc/Statistics/Sampling/FanSampling.h"

TEST(ThreePointLimits, AreEquation10)
{
  const ruc::Window box = oracle::PeriodicCube(4.0);
  const ruc::SpherePack pack = oracle::RandomPack({ 6, 4 }, { 0.5, 0.7 }, box, 5);
  const ruc::ThreePointGrid grid = { { 0.25, 6 }, 8 };
  ruc::Communicator serial;
  const std::vector<ruc::PhaseTriple> triples = { { 0, 1, 1 }, { 1, 1, 0 }, { 0, 1, 0 },
    { 2, 2, 2 }, { 0, 1, 2 } };
  const ruc::ThreePointProbability probability = ruc::SampleFans(
    pack, 2, ruc::SamplingRegion(box, 0.0), grid, triples, { 1, 200, true }, serial);
  // Any functions serve, as long as they can be told apart
  ruc::TwoPointProbability twoPoint(2, grid.Lags);
  for (int pair = 0; pair < twoPoint.Pairs(); ++pair)
  {
    twoPoint.Values[pair].assign(grid.Points(), 0.1 * (pair + 1));
  }
  for (std::size_t n = 0; n < triples.size(); ++n)
  {
    const auto [r, s, q] = triples[n];
    const auto limits = ruc::FindDegenerateLimits(probability, n, twoPoint);
    const struct
    {
      const char* Place;
      int Along1, Along2, Other;
      bool Degenerates;
    } expected[] = { { "r1 axis", 1, 0, s, r == q }, { "r2 axis", 0, 1, q, r == s },
      { "diagonal", 1, 1, s, s == q } };
    for (int place = 0; place < 3; ++place)
    {
      const auto& e = expected[place];
      EXPECT_EQ(limits[place].Place, e.Place);
      double squares = 0.0;
      for (int k = 0; k < grid.Points(); ++k)
      {
        const double value = probability.Value(n, e.Along1 * k, e.Along2 * k, 0);
        const double limit = e.Degenerates ? twoPoint.S(r, e.Other)[k] : 0.0;
        EXPECT_EQ(limits[place].Values[k], value);
        EXPECT_EQ(limits[place].Errors[k], probability.Error(n, e.Along1 * k, e.Along2 * k, 0));
        EXPECT_EQ(limits[place].Limit[k], limit);
        squares += k > 0 ? (value - limit) * (value - limit) : 0.0;
      }
      EXPECT_NEAR(limits[place].Difference(), std::sqrt(squares), 1e-14);
      // Two of three points coincide: nothing is there where their phases differ
      if (!e.Degenerates)
      {
        EXPECT_EQ(limits[place].Expected, "0");
        EXPECT_EQ(limits[place].Difference(), 0.0);
      }
    }
  }
  EXPECT_EQ(ruc::FindDegenerateLimits(probability, 0, twoPoint)[2].Expected, "S_1_2");
  EXPECT_EQ(ruc::FindDegenerateLimits(probability, 1, twoPoint)[1].Expected, "S_2_1");
}
