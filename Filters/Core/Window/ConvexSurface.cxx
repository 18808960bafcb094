// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Window/ConvexSurface.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace ruc
{
void ConvexSurface::Cut(int axis, double level, int side, double tolerance)
{
  std::vector<double> height(this->Points.size());
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    if (std::abs(this->Points[i][axis] - level) < tolerance)
    {
      this->Points[i][axis] = level;
    }
    height[i] = side * (this->Points[i][axis] - level);
  }
  if (std::all_of(height.begin(), height.end(), [](double h) { return h >= 0.0; }))
  {
    return;
  }

  ConvexSurface kept;
  std::map<std::pair<int, int>, int> numbers; // of a point twice, or of the ends of a cut edge
  auto add = [&](int a, int b)
  {
    const auto ends = std::minmax(a, b);
    const auto [found, isNew] = numbers.try_emplace(ends, static_cast<int>(kept.Points.size()));
    if (isNew)
    {
      Vector3 point = this->Points[ends.first];
      if (a != b)
      {
        // From the lower end, whichever half is kept
        const bool upwards = this->Points[ends.first][axis] < this->Points[ends.second][axis];
        const Vector3& low = this->Points[upwards ? ends.first : ends.second];
        const Vector3& high = this->Points[upwards ? ends.second : ends.first];
        const double part = (level - low[axis]) / (high[axis] - low[axis]);
        for (int q = 0; q < 3; ++q)
        {
          point[q] = low[q] + part * (high[q] - low[q]);
        }
        point[axis] = level;
      }
      kept.Points.push_back(point);
    }
    return found->second;
  };
  std::map<int, int> rim; // the edges in the plane, as the closing face has them
  for (const std::vector<int>& face : this->Faces)
  {
    if (std::none_of(face.begin(), face.end(), [&](int i) { return height[i] > 0.0; }))
    {
      continue;
    }
    std::vector<int> part;
    std::vector<bool> onPlane;
    for (std::size_t k = 0; k < face.size(); ++k)
    {
      const int a = face[k];
      const int b = face[(k + 1) % face.size()];
      if (height[a] >= 0.0)
      {
        part.push_back(add(a, a));
        onPlane.push_back(height[a] == 0.0);
      }
      if (height[a] * height[b] < 0.0)
      {
        part.push_back(add(a, b));
        onPlane.push_back(true);
      }
    }
    for (std::size_t k = 0; k < part.size(); ++k)
    {
      const std::size_t next = (k + 1) % part.size();
      if (onPlane[k] && onPlane[next])
      {
        rim[part[next]] = part[k];
      }
    }
    kept.Faces.push_back(part);
  }
  if (!rim.empty())
  {
    std::vector<int> closing;
    for (int i = rim.begin()->first; closing.size() < rim.size(); i = rim.at(i))
    {
      closing.push_back(i);
    }
    kept.Faces.push_back(closing);
  }
  *this = std::move(kept);
}
}
