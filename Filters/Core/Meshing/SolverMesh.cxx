// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Meshing/SolverMesh.h"

#include "ruc/Base/Text.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ruc
{
namespace
{
constexpr std::uint8_t HighFaces = 2 | 8 | 32;
constexpr double Rounding = 1e-12; // of the edges

bool IsCopy(const SolverMesh& mesh, std::size_t point)
{
  const std::int64_t base = mesh.PeriodicOf[point];
  if (base < 0 || base >= static_cast<std::int64_t>(mesh.Points.size()) ||
    (mesh.Boundary[base] & HighFaces))
  {
    return false;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    const bool isHigh = mesh.Boundary[point] >> (2 * axis) & 2;
    const double edge = mesh.Edge[axis];
    const double moved = mesh.Points[point][axis] - (isHigh ? edge : 0.0);
    const double size = std::abs(mesh.Origin[axis]) + edge;
    if (!(std::abs(moved - mesh.Points[base][axis]) <= Rounding * size))
    {
      return false;
    }
  }
  return true;
}
}

void RequirePeriodic(const SolverMesh& mesh)
{
  for (std::size_t point = 0; point < mesh.Points.size(); ++point)
  {
    if (!IsCopy(mesh, point))
    {
      throw std::invalid_argument(
        Text("a deck requires the whole mesh of Periodic Mesh, got point ", point,
          ", which is not the copy of point ", mesh.PeriodicOf[point], "."));
    }
  }
  const auto points = static_cast<int>(mesh.Points.size());
  for (const Tetrahedron& cell : mesh.Cells)
  {
    const auto [least, most] = std::minmax_element(cell.begin(), cell.end());
    if (*least < 0 || *most >= points)
    {
      throw std::invalid_argument(Text("a deck requires corners from 0 to ", points - 1, ", got ",
        *least < 0 ? *least : *most, "."));
    }
  }
}

std::string NameOfBoundary(std::uint8_t boundary)
{
  std::string name;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int sides = boundary >> (2 * axis) & 3;
    if (sides != 0)
    {
      name += "XYZ"[axis];
      name += sides == 1 ? '0' : '1';
    }
  }
  constexpr const char* kinds[] = { "", "FACE_", "EDGE_", "CORNER_" };
  return kinds[name.size() / 2] + name;
}
}
