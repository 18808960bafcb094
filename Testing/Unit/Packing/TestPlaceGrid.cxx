// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Packing/EventQueue.h"
#include "ruc/Packing/PlaceGrid.h"

#include "Oracles.h"

#include <random>
#include <set>

// Every ball that meets another is found once, whatever their sizes, after any number of moves
TEST(PlaceGrid, FindsAllThatMeet)
{
  for (const std::array<bool, 3>& periodic :
    { std::array<bool, 3>{ true, true, true }, { false, true, false } })
  {
    const ruc::Window box = ruc::Window::MakeBox({ -3.0, 1.0, 5.0 }, { 10.0, 12.0, 9.0 }, periodic);
    std::mt19937 engine(1);
    const auto uniform = [&]() { return engine() / 4294967296.0; };
    const int balls = 300;
    ruc::PlaceGrid grid(box, balls, 0.05, 2.0);
    std::vector<ruc::Vector3> places(balls);
    std::vector<double> radii(balls);
    const auto put = [&](int ball)
    {
      radii[ball] = 0.05 * std::pow(40.0, uniform() * uniform());
      for (int q = 0; q < 3; ++q)
      {
        const double turns = periodic[q] ? 4.0 * uniform() - 2.0 : uniform();
        places[ball][q] = box.Origin[q] + turns * box.Size[q];
      }
      grid.Put(ball, places[ball], radii[ball]);
    };
    for (int n = 0; n < balls; ++n)
    {
      put(n);
    }
    for (int n = 0; n < 1000; ++n)
    {
      put(engine() % balls);
    }
    for (int i = 0; i < balls; ++i)
    {
      std::multiset<int> found;
      grid.ForEachNear(i, [&](int j) { found.insert(j); });
      EXPECT_EQ(found.count(i), 0u);
      for (int j = 0; j < balls; ++j)
      {
        double squares = 0.0;
        for (int q = 0; q < 3; ++q)
        {
          double d = places[j][q] - places[i][q];
          d -= periodic[q] ? box.Size[q] * std::round(d / box.Size[q]) : 0.0;
          squares += d * d;
        }
        EXPECT_LE(found.count(j), 1u);
        if (i != j && std::sqrt(squares) < radii[i] + radii[j])
        {
          EXPECT_EQ(found.count(j), 1u) << i << " " << j;
        }
      }
    }
  }
}

TEST(EventQueue, KnowsTheEarliest)
{
  std::mt19937 engine(1);
  std::vector<double> times(100);
  for (double& time : times)
  {
    time = engine() % 50;
  }
  ruc::EventQueue queue;
  queue.Assign(times);
  for (int n = 0; n < 2000; ++n)
  {
    const double least = *std::min_element(times.begin(), times.end());
    EXPECT_EQ(times[queue.Earliest()], least);
    EXPECT_EQ(queue.TimeOf(queue.Earliest()), least);
    const int changed = n % 2 == 0 ? queue.Earliest() : static_cast<int>(engine() % times.size());
    times[changed] = engine() % 100;
    queue.SetTime(changed, times[changed]);
  }
}
