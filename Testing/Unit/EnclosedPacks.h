// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/**
 * @file
 * Packs of which it is known how they end: dense ones between walls, and parts that are taken out
 * of a larger pack. They need no test framework.
 */

#include "ruc/Particles/CellList.h"
#include "ruc/Particles/SpherePack.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace oracle
{
/** How spheres are taken out of a larger pack. */
enum class Taken
{
  ByCentre,
  Whole,   // only those that lie in the box as a whole
  Touching // all that lie in it in part
};

inline ruc::SpherePack TakeBlock(
  const ruc::SpherePack& pack, const ruc::Vector3& low, const ruc::Vector3& high, Taken taken)
{
  ruc::SpherePack block;
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    const ruc::Vector3 c = pack.Centre(i);
    const double beyond = taken == Taken::Whole ? -pack.Radius[i]
      : taken == Taken::Touching                ? pack.Radius[i]
                                                : 0.0;
    bool in = true;
    for (int q = 0; q < 3; ++q)
    {
      in = in && c[q] >= low[q] - beyond && c[q] <= high[q] + beyond;
    }
    if (in)
    {
      block.Append(pack, i);
    }
  }
  return block;
}

/** The volume of the spheres with centres in a window over that of the window. */
inline double FractionIn(const ruc::SpherePack& pack, const ruc::Window& window)
{
  double volume = 0.0;
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    const double r = pack.Radius[i];
    volume += window.Contains(pack.Centre(i)) ? 4.0 / 3.0 * M_PI * r * r * r : 0.0;
  }
  return volume / window.Volume();
}

/**
 * The share of a window that lies in spheres, by points drawn in it. It asks for no centres, so
 * layers of them near the faces do not matter. With 400 000 points its standard error is 0.0008.
 */
inline double FractionByPoints(const ruc::SpherePack& pack, const ruc::Window& window)
{
  constexpr int Points = 400000;
  const double reach = pack.LargestRadius();
  const ruc::Vector3 low = { *std::min_element(pack.X.begin(), pack.X.end()),
    *std::min_element(pack.Y.begin(), pack.Y.end()),
    *std::min_element(pack.Z.begin(), pack.Z.end()) };
  const ruc::Vector3 edges = { *std::max_element(pack.X.begin(), pack.X.end()) - low[0],
    *std::max_element(pack.Y.begin(), pack.Y.end()) - low[1],
    *std::max_element(pack.Z.begin(), pack.Z.end()) - low[2] };
  const ruc::CellList cells(pack, ruc::Window::MakeBox(low, edges, {}), reach);
  const ruc::Window box = window.GetBounds();
  std::mt19937 engine(1);
  std::vector<ruc::CellList::Range> ranges;
  int inside = 0;
  for (int n = 0; n < Points;)
  {
    ruc::Vector3 point;
    for (int q = 0; q < 3; ++q)
    {
      point[q] = box.Origin[q] + box.Size[q] * (engine() / 4294967296.0);
    }
    if (!window.Contains(point))
    {
      continue;
    }
    ++n;
    ranges.clear();
    cells.FindRangesAround(point, 0, ranges);
    bool in = false;
    for (const ruc::CellList::Range& range : ranges)
    {
      for (std::size_t j = range.Begin; j < range.End && !in; ++j)
      {
        const double r = pack.Radius[cells.Index[j]];
        const ruc::Vector3 d = { cells.X[j] - range.X, cells.Y[j] - range.Y, cells.Z[j] - range.Z };
        in = ruc::Dot(d, d) < r * r;
      }
    }
    inside += in ? 1 : 0;
  }
  return static_cast<double>(inside) / Points;
}

/** Radii whose logarithms are normal with that deviation; 0 gives equal ones. */
inline std::vector<double> LognormalRadii(int count, double deviation, std::uint32_t seed)
{
  std::mt19937 engine(seed);
  std::vector<double> radii(count);
  for (double& radius : radii)
  {
    // A normal number as the sum of twelve even ones, which every library draws alike
    double normal = -6.0;
    for (int n = 0; n < 12; ++n)
    {
      normal += engine() / 4294967296.0;
    }
    radius = std::exp(deviation * normal);
  }
  return radii;
}

/**
 * Spheres of these radii from the origin to the box's far corner, with walls where the box is not
 * periodic. They start at random and are pushed apart, and off the walls, until they hardly
 * overlap.
 */
inline ruc::SpherePack PackBetweenWalls(
  const std::vector<double>& radii, const ruc::Window& box, std::uint32_t seed, int sweeps = 400)
{
  std::mt19937 engine(seed);
  ruc::SpherePack pack;
  std::vector<double>* axes[3] = { &pack.X, &pack.Y, &pack.Z };
  pack.Radius = radii;
  for (int q = 0; q < 3; ++q)
  {
    for (std::size_t i = 0; i < radii.size(); ++i)
    {
      axes[q]->push_back(box.Size[q] * (engine() / 4294967296.0));
    }
  }
  for (int sweep = 0; sweep < sweeps; ++sweep)
  {
    for (int q = 0; q < 3; ++q)
    {
      for (std::size_t i = 0; i < radii.size() && !box.Periodic[q]; ++i)
      {
        double& c = (*axes[q])[i];
        c = std::clamp(c, radii[i], box.Size[q] - radii[i]);
      }
    }
    ruc::WrapIntoBox(pack, box);
    std::vector<ruc::Vector3> push(radii.size(), ruc::Vector3{});
    const ruc::CellList cells(pack, box, 2.0 * pack.LargestRadius());
    cells.ForEachPair(
      [&](std::size_t i, std::size_t j, double dx, double dy, double dz, double d2)
      {
        const double d = std::sqrt(d2), overlap = radii[i] + radii[j] - d;
        if (overlap > 0.0 && d > 0.0)
        {
          const double step = 0.3 * overlap / d;
          const ruc::Vector3 v = { dx * step, dy * step, dz * step };
          for (int q = 0; q < 3; ++q)
          {
            push[i][q] -= v[q];
            push[j][q] += v[q];
          }
        }
      });
    for (std::size_t i = 0; i < radii.size(); ++i)
    {
      for (int q = 0; q < 3; ++q)
      {
        (*axes[q])[i] += push[i][q];
      }
    }
  }
  for (int q = 0; q < 3; ++q)
  {
    for (std::size_t i = 0; i < radii.size() && !box.Periodic[q]; ++i)
    {
      double& c = (*axes[q])[i];
      c = std::clamp(c, radii[i], box.Size[q] - radii[i]);
    }
  }
  ruc::WrapIntoBox(pack, box);
  return pack;
}

/** A cube with walls, or without, in which these radii take a fraction of the volume. */
inline ruc::Window CubeFor(
  const std::vector<double>& radii, double fraction, const std::array<bool, 3>& periodic)
{
  double volume = 0.0;
  for (double r : radii)
  {
    volume += 4.0 / 3.0 * M_PI * r * r * r;
  }
  const double edge = std::cbrt(volume / fraction);
  return ruc::Window::MakeBox({ 0, 0, 0 }, { edge, edge, edge }, periodic);
}

/** Reads the rows x, y, z, radius below a header. */
inline ruc::SpherePack ReadTable(const std::string& name)
{
  ruc::SpherePack pack;
  std::ifstream file(name);
  std::string line;
  for (std::getline(file, line); std::getline(file, line);)
  {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream row(line);
    double x, y, z, r;
    if (row >> x >> y >> z >> r)
    {
      pack.X.push_back(x);
      pack.Y.push_back(y);
      pack.Z.push_back(z);
      pack.Radius.push_back(r);
    }
  }
  return pack;
}
}
