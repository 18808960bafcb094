// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Images/Watershed/Basins.h"

#include "Images/Fit/GreyScenes.h"
#include "ruc/Images/Fit/DistanceMap.h"

#include <functional>
#include <set>

namespace
{
using Size = std::array<int, 3>;
using ruc::Vector3;

std::vector<std::int32_t> MapOf(
  const Size& n, const std::function<bool(const Vector3& centre)>& isParticle)
{
  std::vector<float> image;
  for (int k = 0; k < n[0] * n[1] * n[2]; ++k)
  {
    image.push_back(
      isParticle({ k % n[0] + 0.5, k / n[0] % n[1] + 0.5, k / n[0] / n[1] + 0.5 }) ? 1.0f : 0.0f);
  }
  ruc::Communicator one;
  return ruc::SquaredDistances(ruc::FindAbove(oracle::SlabOf(image, n, one), 0.5f), one).Values;
}

std::vector<std::int32_t> Cut(
  const std::vector<std::int32_t>& map, const Size& n, double height, int size = 1)
{
  return oracle::Together<std::int32_t>(size,
    [&](ruc::Communicator& ranks)
    {
      const ruc::Basins basins = ruc::FindBasins(oracle::SlabOf(map, n, ranks), height, ranks);
      for (std::int32_t number : basins.Number.Values)
      {
        EXPECT_LE(number, basins.Count);
      }
      return basins.Number.Values;
    });
}

/** Calls use(other) for the 26 neighbours of a voxel. */
template <class Use>
void ForNeighbours(const Size& n, int k, Use&& use)
{
  const int x = k % n[0], y = k / n[0] % n[1], z = k / n[0] / n[1];
  for (int w = std::max(0, z - 1); w <= std::min(n[2] - 1, z + 1); ++w)
  {
    for (int v = std::max(0, y - 1); v <= std::min(n[1] - 1, y + 1); ++v)
    {
      for (int u = std::max(0, x - 1); u <= std::min(n[0] - 1, x + 1); ++u)
      {
        const int other = (w * n[1] + v) * n[0] + u;
        if (other != k)
        {
          use(other);
        }
      }
    }
  }
}

/** Numbers the connected parts of equal values above 0, from 1. */
template <class Value>
std::vector<int> PartsOf(const std::vector<Value>& values, const Size& n, int& count)
{
  std::vector<int> parts(values.size(), 0), stack;
  count = 0;
  for (int k = 0; k < static_cast<int>(values.size()); ++k)
  {
    if (values[k] <= 0 || parts[k] > 0)
    {
      continue;
    }
    parts[k] = ++count;
    stack.push_back(k);
    while (!stack.empty())
    {
      const int at = stack.back();
      stack.pop_back();
      ForNeighbours(n, at,
        [&](int other)
        {
          if (parts[other] == 0 && values[other] == values[at])
          {
            parts[other] = count;
            stack.push_back(other);
          }
        });
    }
  }
  return parts;
}

/**
 * The maxima that are higher than all around them by a height, by their definition (Soille 2003):
 * the distance less the height is dilated below the distance until nothing changes; they are what
 * then has no higher neighbour. Returns the number of each; 0 elsewhere.
 */
std::vector<int> MarkersOf(
  const std::vector<std::int32_t>& map, const Size& n, double height, int& count)
{
  // What is not connected stays apart: the matrix lies lower than all else
  constexpr double bottom = 1.0, shift = 1e4;
  std::vector<double> above, low;
  for (std::int32_t square : map)
  {
    above.push_back(square > 0 ? shift + std::sqrt(static_cast<double>(square)) : bottom);
    low.push_back(square > 0 ? above.back() - height : bottom);
  }
  for (bool changed = true; changed;)
  {
    changed = false;
    for (int k = 0; k < static_cast<int>(map.size()); ++k)
    {
      double most = low[k];
      ForNeighbours(n, k, [&](int other) { most = std::max(most, low[other]); });
      most = std::min(most, above[k]);
      changed = changed || most > low[k];
      low[k] = std::max(low[k], most);
    }
  }
  int parts = 0;
  const std::vector<int> part = PartsOf(low, n, parts);
  std::vector<bool> isMaximum(parts + 1, true);
  for (int k = 0; k < static_cast<int>(map.size()); ++k)
  {
    isMaximum[part[k]] = isMaximum[part[k]] && map[k] > 0;
    ForNeighbours(
      n, k, [&](int other) { isMaximum[part[k]] = isMaximum[part[k]] && low[other] <= low[k]; });
  }
  std::vector<int> numbers(parts + 1, 0), markers;
  count = 0;
  for (int p = 1; p <= parts; ++p)
  {
    numbers[p] = isMaximum[p] ? ++count : 0;
  }
  for (int p : part)
  {
    markers.push_back(numbers[p]);
  }
  return markers;
}

/** Balls at random places that overlap as they like, in a box. */
std::vector<std::int32_t> RandomMap(const Size& n, int balls, std::uint64_t seed)
{
  oracle::Uniform random(seed);
  std::vector<ruc::Ball> scene;
  for (int b = 0; b < balls; ++b)
  {
    scene.push_back(
      { { n[0] * random(), n[1] * random(), n[2] * random() }, 2.0 + 4.0 * random() });
  }
  return MapOf(n,
    [&](const Vector3& p)
    {
      return std::any_of(scene.begin(), scene.end(),
        [&](const ruc::Ball& ball)
        {
          return std::hypot(p[0] - ball.Centre[0], p[1] - ball.Centre[1], p[2] - ball.Centre[2]) <
            ball.Radius;
        });
    });
}
}

TEST(Basins, OnePartOfTheParticlesAroundEveryMarker)
{
  const Size n = { 31, 29, 27 };
  for (std::uint64_t seed : { 1, 2, 3 })
  {
    const std::vector<std::int32_t> map = RandomMap(n, 40, seed);
    for (double height : { 0.117, 0.517, 1.517, 1e3 })
    {
      int markers = 0, parts = 0;
      const std::vector<int> marker = MarkersOf(map, n, height, markers);
      const std::vector<std::int32_t> basins = Cut(map, n, height);
      PartsOf(basins, n, parts);
      EXPECT_EQ(parts, markers); // each basin is in one piece, and they are as many
      std::vector<int> of(markers + 1, 0);
      for (std::size_t k = 0; k < map.size(); ++k)
      {
        ASSERT_EQ(basins[k] > 0, map[k] > 0);
        if (marker[k] > 0)
        {
          of[marker[k]] = of[marker[k]] == 0 ? basins[k] : of[marker[k]];
          ASSERT_EQ(of[marker[k]], basins[k]); // a marker is in one basin
        }
      }
      EXPECT_EQ(std::set<int>(of.begin() + 1, of.end()).size(), static_cast<std::size_t>(markers));
      EXPECT_GE(markers, 1);
    }
  }
}

TEST(Basins, AreEqualOnAnyNumberOfRanks)
{
  // Also with ranks that have one plane or none
  for (const Size& n : { Size{ 31, 29, 27 }, Size{ 40, 17, 5 }, Size{ 30, 30, 3 } })
  {
    const std::vector<std::int32_t> map = RandomMap(n, 40, 4);
    const std::vector<std::int32_t> one = Cut(map, n, 0.5);
    EXPECT_GT(*std::max_element(one.begin(), one.end()), 3);
    for (int size : { 2, 3, 4 })
    {
      EXPECT_EQ(Cut(map, n, 0.5, size), one);
    }
  }
}

TEST(Basins, OfTwoEqualBallsAreCutByThePlaneBetweenThem)
{
  const Size n = { 61, 61, 61 };
  const Vector3 middle = { 30.3, 30.4, 30.1 };
  constexpr double radius = 14.0;
  for (const Vector3& direction : { Vector3{ 1, 0, 0 }, Vector3{ 0, 0.6, 0.8 },
         Vector3{ 0.36, 0.48, 0.8 }, Vector3{ -0.28, 0.96, 0 }, Vector3{ 0.577, 0.577, -0.578 } })
  {
    const auto along = [&](const Vector3& p)
    {
      return (p[0] - middle[0]) * direction[0] + (p[1] - middle[1]) * direction[1] +
        (p[2] - middle[2]) * direction[2];
    };
    constexpr double half = 10.0; // of the distance between the centres
    const std::vector<std::int32_t> map = MapOf(n,
      [&](const Vector3& p)
      {
        const double square = std::pow(p[0] - middle[0], 2) + std::pow(p[1] - middle[1], 2) +
          std::pow(p[2] - middle[2], 2);
        return square + half * half - 2.0 * half * std::abs(along(p)) < radius * radius;
      });
    const std::vector<std::int32_t> basins = Cut(map, n, 0.5);
    EXPECT_EQ(*std::max_element(basins.begin(), basins.end()), 2);
    const auto at = [&](double t)
    {
      Size voxel;
      for (int q = 0; q < 3; ++q)
      {
        voxel[q] = static_cast<int>(middle[q] + t * direction[q]);
      }
      return basins[(voxel[2] * n[1] + voxel[1]) * n[0] + voxel[0]];
    };
    const std::int32_t low = at(-half), high = at(half);
    EXPECT_NE(low, high);
    int wrong = 0;
    for (int k = 0; k < n[0] * n[1] * n[2]; ++k)
    {
      const double t = along({ k % n[0] + 0.5, k / n[0] % n[1] + 0.5, k / n[0] / n[1] + 0.5 });
      // Water runs to voxels, not along straight lines
      if (basins[k] > 0 && std::abs(t) > 0.5)
      {
        const bool right = basins[k] == (t < 0 ? low : high);
        wrong += right ? 0 : 1;
        EXPECT_TRUE(right || std::abs(t) < 2.0) << t;
      }
    }
    EXPECT_LT(wrong, 100); // of some 400 voxels that lie on the plane
  }
}

TEST(Basins, APassJoinsWhatIsLessHighThanTheMarkers)
{
  // A row of voxels with heights 5, 4, 4.6 and 3, 4
  const Size n = { 7, 1, 1 };
  const std::vector<std::int32_t> map = { 25, 16, 21, 9, 16, 0, 4 };
  EXPECT_EQ(Cut(map, n, 0.5), (std::vector<std::int32_t>{ 1, 1, 2, 2, 3, 0, 4 }));
  EXPECT_EQ(Cut(map, n, 0.6), (std::vector<std::int32_t>{ 1, 1, 1, 1, 2, 0, 3 }));
  EXPECT_EQ(Cut(map, n, 1.1), (std::vector<std::int32_t>{ 1, 1, 1, 1, 1, 0, 2 }));
  // Equal heights: a plateau is one maximum
  EXPECT_EQ(Cut({ 4, 4, 4, 9, 4, 4, 4 }, n, 0.01), (std::vector<std::int32_t>(7, 1)));
  EXPECT_EQ(Cut(std::vector<std::int32_t>(7, 4), n, 0.01), (std::vector<std::int32_t>(7, 1)));
  EXPECT_EQ(Cut(std::vector<std::int32_t>(7, 0), n, 0.01), (std::vector<std::int32_t>(7, 0)));
}
