// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Window/ConvexSurface.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace ruc
{
namespace
{
// The part of a polyhedron where heights are >= 0, made from the faces of the whole, corner by
// corner
class Half
{
public:
  Half(const ConvexSurface& whole, const std::vector<double>& height, int axis, double level)
    : Whole(whole)
    , Height(height)
    , Axis(axis)
    , Level(level)
  {
  }

  void AddPartOf(const std::vector<int>& face)
  {
    std::vector<int> part;
    std::vector<bool> onPlane;
    for (std::size_t k = 0; k < face.size(); ++k)
    {
      const int a = face[k];
      const int b = face[(k + 1) % face.size()];
      if (this->Height[a] >= 0.0)
      {
        part.push_back(this->Add(a, a));
        onPlane.push_back(this->Height[a] == 0.0);
      }
      if (this->Height[a] * this->Height[b] < 0.0)
      {
        part.push_back(this->Add(a, b));
        onPlane.push_back(true);
      }
    }
    for (std::size_t k = 0; k < part.size(); ++k)
    {
      const std::size_t next = (k + 1) % part.size();
      if (onPlane[k] && onPlane[next])
      {
        this->Rim[part[next]] = part[k];
      }
    }
    this->Kept.Faces.push_back(part);
  }

  ConvexSurface Close()
  {
    if (!this->Rim.empty())
    {
      std::vector<int> closing;
      for (int i = this->Rim.begin()->first; closing.size() < this->Rim.size(); i = this->Rim.at(i))
      {
        closing.push_back(i);
      }
      this->Kept.Faces.push_back(closing);
    }
    return std::move(this->Kept);
  }

private:
  // The number of point a where b is the same, else of the point where the plane cuts the edge from
  // a to b
  int Add(int a, int b)
  {
    const auto ends = std::minmax(a, b);
    const auto [found, isNew] =
      this->Numbers.try_emplace(ends, static_cast<int>(this->Kept.Points.size()));
    if (isNew)
    {
      this->Kept.Points.push_back(
        a == b ? this->Whole.Points[a] : this->CutEdge(ends.first, ends.second));
    }
    return found->second;
  }

  Vector3 CutEdge(int a, int b) const
  {
    // From the lower end, so that both halves get the same point
    const bool upwards = this->Whole.Points[a][this->Axis] < this->Whole.Points[b][this->Axis];
    const Vector3& low = this->Whole.Points[upwards ? a : b];
    const Vector3& high = this->Whole.Points[upwards ? b : a];
    const double part = (this->Level - low[this->Axis]) / (high[this->Axis] - low[this->Axis]);
    Vector3 point;
    for (int q = 0; q < 3; ++q)
    {
      point[q] = low[q] + part * (high[q] - low[q]);
    }
    point[this->Axis] = this->Level;
    return point;
  }

  const ConvexSurface& Whole;
  const std::vector<double>& Height; // of the points of the whole
  const int Axis;
  const double Level;
  ConvexSurface Kept;
  std::map<std::pair<int, int>, int> Numbers; // of a point twice, or of the ends of a cut edge
  std::map<int, int> Rim; // the edges in the plane, in the sense of the closing face
};
}

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
  Half half(*this, height, axis, level);
  for (const std::vector<int>& face : this->Faces)
  {
    if (std::any_of(face.begin(), face.end(), [&](int i) { return height[i] > 0.0; }))
    {
      half.AddPartOf(face);
    }
  }
  *this = half.Close();
}
}
