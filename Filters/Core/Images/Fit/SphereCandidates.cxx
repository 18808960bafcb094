// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Images/Fit/SphereCandidates.h"

#include "ruc/Images/Fit/DistanceMap.h"

#include <cmath>
#include <map>
#include <numeric>

namespace ruc
{
namespace
{
// What a radius has more, on average, than the distance of the voxel that is nearest to the centre
constexpr double RadiusOverDistance = 0.4;

// Returns whether a voxel is a maximum, and then the sum of the places of it and its equals
bool IsMaximum(const VoxelSlab<std::int32_t>& map, int x, int y, int z, Vector3& place)
{
  const std::int32_t here = map.Row(y, z)[x];
  Vector3 sum{};
  int equals = 0;
  for (int w = std::max(map.First, z - 1); w <= std::min(map.Last - 1, z + 1); ++w)
  {
    for (int v = std::max(0, y - 1); v <= std::min(map.Dimensions[1] - 1, y + 1); ++v)
    {
      for (int u = std::max(0, x - 1); u <= std::min(map.Dimensions[0] - 1, x + 1); ++u)
      {
        const std::int32_t other = map.Row(v, w)[u];
        const bool earlier = std::tie(w, v, u) < std::tie(z, y, x);
        if (other > here || (other == here && earlier))
        {
          return false;
        }
        if (other == here)
        {
          sum = { sum[0] + u, sum[1] + v, sum[2] + w };
          ++equals;
        }
      }
    }
  }
  place = { sum[0] / equals + 0.5, sum[1] / equals + 0.5, sum[2] / equals + 0.5 };
  return true;
}

double LargestOf(const std::vector<Ball>& balls)
{
  double largest = 1.0;
  for (const Ball& ball : balls)
  {
    largest = std::max(largest, ball.Radius);
  }
  return largest;
}

double DistanceOf(const Ball& a, const Ball& b)
{
  return Length(
    Vector3{ a.Centre[0] - b.Centre[0], a.Centre[1] - b.Centre[1], a.Centre[2] - b.Centre[2] });
}

double OverlapOf(const Ball& a, const Ball& b)
{
  return a.Radius + b.Radius - DistanceOf(a, b);
}

/** Numbers in cubes of space, which are found again within the edge of a cube. */
class BallCells
{
public:
  explicit BallCells(double edge)
    : Edge(edge)
  {
  }
  void Add(const Vector3& centre, std::size_t number)
  {
    this->Numbers[this->CellOf(centre)].push_back(number);
  }
  /** Returns whether `is` holds for any number within an edge, which it asks in their order. */
  template <class Is>
  bool Any(const Vector3& centre, Is&& is) const
  {
    const Cell cell = this->CellOf(centre);
    for (int n = 0; n < 27; ++n)
    {
      const auto near =
        this->Numbers.find({ cell[0] + n % 3 - 1, cell[1] + n / 3 % 3 - 1, cell[2] + n / 9 - 1 });
      if (near != this->Numbers.end() && std::any_of(near->second.begin(), near->second.end(), is))
      {
        return true;
      }
    }
    return false;
  }

private:
  using Cell = std::array<std::int64_t, 3>;
  Cell CellOf(const Vector3& centre) const
  {
    Cell cell;
    for (int q = 0; q < 3; ++q)
    {
      cell[q] = static_cast<std::int64_t>(std::floor(centre[q] / this->Edge));
    }
    return cell;
  }

  double Edge;
  std::map<Cell, std::vector<std::size_t>> Numbers;
};

std::vector<Ball> MaximaOfPlane(
  const VoxelSlab<std::int32_t>& map, int z, double leastSquare, const Vector3& edges)
{
  std::vector<Ball> found;
  for (int y = 0; y < map.Dimensions[1]; ++y)
  {
    const std::int32_t* row = map.Row(y, z);
    for (int x = 0; x < map.Dimensions[0]; ++x)
    {
      Vector3 place;
      if (row[x] >= leastSquare && row[x] < NoMatrix && IsMaximum(map, x, y, z, place))
      {
        for (int q = 0; q < 3; ++q)
        {
          place[q] *= edges[q];
        }
        found.push_back({ place, std::sqrt(static_cast<double>(row[x])) + RadiusOverDistance });
      }
    }
  }
  return found;
}
}

std::vector<Ball> FindMaxima(
  VoxelSlab<std::int32_t> distances, double leastRadius, const Vector3& edges, Communicator& ranks)
{
  const int first = distances.First, count = distances.Last - distances.First;
  SetHalo(distances, 1, ranks);
  const double least = std::pow(std::max(1.0, leastRadius - RadiusOverDistance), 2);
  std::vector<std::vector<Ball>> ofPlanes(count);
#pragma omp parallel for schedule(dynamic)
  for (int n = 0; n < count; ++n)
  {
    ofPlanes[n] = MaximaOfPlane(distances, first + n, least, edges);
  }
  std::vector<Ball> own;
  for (const std::vector<Ball>& of : ofPlanes)
  {
    own.insert(own.end(), of.begin(), of.end());
  }
  std::vector<Ball> all = ranks.Concatenate(own);
  std::stable_sort(
    all.begin(), all.end(), [](const Ball& a, const Ball& b) { return a.Radius > b.Radius; });
  return all;
}

std::vector<Ball> KeepFirstOfEach(const std::vector<Ball>& balls)
{
  BallCells kept(1.2 * LargestOf(balls));
  std::vector<Ball> first;
  for (const Ball& ball : balls)
  {
    const bool known = kept.Any(ball.Centre,
      [&](std::size_t n)
      {
        const Ball& other = first[n];
        return DistanceOf(ball, other) <
          std::max({ ball.Radius, other.Radius, 0.6 * (ball.Radius + other.Radius) });
      });
    if (!known)
    {
      kept.Add(ball.Centre, first.size());
      first.push_back(ball);
    }
  }
  return first;
}

std::vector<bool> FindDeepOverlaps(const std::vector<Ball>& balls, double tolerance)
{
  std::vector<std::size_t> order(balls.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b) { return balls[a].Radius > balls[b].Radius; });
  BallCells kept(2.0 * LargestOf(balls));
  std::vector<bool> deep(balls.size());
  for (std::size_t i : order)
  {
    deep[i] = kept.Any(balls[i].Centre,
      [&](std::size_t n)
      { return OverlapOf(balls[i], balls[n]) > tolerance * 2.0 * balls[i].Radius; });
    if (!deep[i])
    {
      kept.Add(balls[i].Centre, i);
    }
  }
  return deep;
}

std::vector<double> FindOverlapDepths(const std::vector<Ball>& balls)
{
  BallCells cells(2.0 * LargestOf(balls));
  std::vector<double> depths(balls.size(), 0.0);
  for (std::size_t i = 0; i < balls.size(); ++i)
  {
    cells.Any(balls[i].Centre,
      [&](std::size_t n)
      {
        const double depth = OverlapOf(balls[i], balls[n]);
        depths[i] = std::max(depths[i], depth);
        depths[n] = std::max(depths[n], depth);
        return false;
      });
    cells.Add(balls[i].Centre, i);
  }
  return depths;
}
}
