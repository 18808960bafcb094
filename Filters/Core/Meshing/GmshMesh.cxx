// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Formats/WrittenPack.h"
#include "ruc/Meshing/SolverMesh.h"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace ruc
{
namespace
{
constexpr const char* NamesOfFaces[] = { "x_min", "x_max", "y_min", "y_max", "z_min", "z_max" };
constexpr int TypeOfTriangle = 2, TypeOfTetrahedron = 4;
constexpr std::size_t Faces = 6;

using Triangle = std::array<int, 3>;

std::string Line(std::initializer_list<std::size_t> numbers)
{
  std::string line;
  for (const std::size_t number : numbers)
  {
    line += (line.empty() ? "" : " ") + std::to_string(number);
  }
  return line + "\n";
}

// The triangles on each face of the box, whose normals lead out of it
std::array<std::vector<Triangle>, Faces> TrianglesOfBox(const SolverMesh& mesh)
{
  constexpr int faceOf[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };
  std::array<std::vector<Triangle>, Faces> triangles;
  for (const Tetrahedron& cell : mesh.Cells)
  {
    for (const auto& face : faceOf)
    {
      const Triangle triangle{ cell[face[0]], cell[face[1]], cell[face[2]] };
      const int common =
        mesh.Boundary[triangle[0]] & mesh.Boundary[triangle[1]] & mesh.Boundary[triangle[2]];
      for (std::size_t side = 0; side < Faces; ++side)
      {
        if (common >> side & 1)
        {
          triangles[side].push_back(triangle);
        }
      }
    }
  }
  return triangles;
}

std::string Bounds(const Vector3& low, const Vector3& high)
{
  std::string line;
  AppendNumbers(line, { low[0], low[1], low[2], high[0], high[1], high[2] });
  return line;
}

void AppendEntities(const SolverMesh& mesh, std::string& text)
{
  const std::size_t regions = mesh.RegionNames.size();
  text += "$PhysicalNames\n" + std::to_string(Faces + regions) + "\n";
  for (std::size_t n = 0; n < Faces; ++n)
  {
    text += "2 " + std::to_string(n + 1) + " \"" + NamesOfFaces[n] + "\"\n";
  }
  for (std::size_t n = 0; n < regions; ++n)
  {
    text += "3 " + std::to_string(Faces + n + 1) + " \"" + mesh.RegionNames[n] + "\"\n";
  }
  text += "$EndPhysicalNames\n$Entities\n" + Line({ 0, 0, Faces, regions });
  Vector3 end = mesh.Origin;
  for (int axis = 0; axis < 3; ++axis)
  {
    end[axis] += mesh.Edge[axis];
  }
  for (std::size_t n = 0; n < Faces; ++n)
  {
    Vector3 low = mesh.Origin, high = end;
    (n % 2 ? low[n / 2] : high[n / 2]) = n % 2 ? high[n / 2] : low[n / 2];
    text +=
      std::to_string(n + 1) + " " + Bounds(low, high) + " 1 " + std::to_string(n + 1) + " 0\n";
  }
  for (std::size_t n = 0; n < regions; ++n)
  {
    const std::string tag = std::to_string(Faces + n + 1);
    text += tag + " " + Bounds(mesh.Origin, end) + " 1 " + tag + " 0\n";
  }
  text += "$EndEntities\n";
}

// All nodes are classified on the first volume: a node has one entity, and regions share nodes
void AppendNodes(const SolverMesh& mesh, std::string& text)
{
  const std::size_t count = mesh.Points.size();
  text += "$Nodes\n" + Line({ 1, count, 1, count }) + Line({ 3, Faces + 1, 0, count });
  for (std::size_t n = 0; n < count; ++n)
  {
    text += std::to_string(n + 1) + "\n";
  }
  for (const Vector3& place : mesh.Points)
  {
    AppendNumbers(text, { place[0], place[1], place[2] });
    text += "\n";
  }
  text += "$EndNodes\n";
}

void AppendElements(const SolverMesh& mesh, std::string& text)
{
  const auto triangles = TrianglesOfBox(mesh);
  const std::size_t regions = mesh.RegionNames.size();
  std::vector<std::vector<std::size_t>> cells(regions);
  for (std::size_t n = 0; n < mesh.Cells.size(); ++n)
  {
    cells[mesh.Region[n]].push_back(n);
  }
  std::size_t count = mesh.Cells.size(), number = 0;
  for (const std::vector<Triangle>& of : triangles)
  {
    count += of.size();
  }
  text += "$Elements\n" + Line({ Faces + regions, count, 1, count });
  for (std::size_t side = 0; side < Faces; ++side)
  {
    text += Line({ 2, side + 1, TypeOfTriangle, triangles[side].size() });
    for (const Triangle& c : triangles[side])
    {
      text += Line({ ++number, c[0] + 1u, c[1] + 1u, c[2] + 1u });
    }
  }
  for (std::size_t region = 0; region < regions; ++region)
  {
    text += Line({ 3, Faces + region + 1, TypeOfTetrahedron, cells[region].size() });
    for (const std::size_t cell : cells[region])
    {
      const Tetrahedron& c = mesh.Cells[cell];
      text += Line({ ++number, c[0] + 1u, c[1] + 1u, c[2] + 1u, c[3] + 1u });
    }
  }
  text += "$EndElements\n";
}

// For each axis the nodes of the high face and those of the low face an edge away
void AppendPeriods(const SolverMesh& mesh, std::string& text)
{
  text += "$Periodic\n3\n";
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto high = static_cast<std::uint8_t>(2u << (2 * axis));
    const auto low = static_cast<std::uint8_t>(1u << (2 * axis));
    // A copy is told by its original and the other faces that it lies on
    std::vector<std::array<std::size_t, 3>> onLow, onHigh;
    for (std::size_t n = 0; n < mesh.Points.size(); ++n)
    {
      const auto base = static_cast<std::size_t>(mesh.PeriodicOf[n]);
      const int others = mesh.Boundary[n] & ~(low | high);
      if (mesh.Boundary[n] & (low | high))
      {
        (mesh.Boundary[n] & low ? onLow : onHigh)
          .push_back({ base, static_cast<std::size_t>(others), n + 1 });
      }
    }
    std::sort(onLow.begin(), onLow.end());
    std::sort(onHigh.begin(), onHigh.end());
    const auto isSame = [](const auto& a, const auto& b) { return a[0] == b[0] && a[1] == b[1]; };
    if (!std::equal(onLow.begin(), onLow.end(), onHigh.begin(), onHigh.end(), isSame))
    {
      throw std::invalid_argument(
        "a deck requires the whole mesh of Periodic Mesh, got points on a face without a copy.");
    }
    text += Line({ 2, 2 * axis + 2, 2 * axis + 1 }) + "16";
    for (std::size_t n = 0; n < 16; ++n)
    {
      text += " ";
      AppendNumber(text, n == 4 * axis + 3 ? mesh.Edge[axis] : n % 5 == 0 ? 1.0 : 0.0);
    }
    text += "\n" + std::to_string(onHigh.size()) + "\n";
    for (std::size_t n = 0; n < onHigh.size(); ++n)
    {
      text += Line({ onHigh[n][2], onLow[n][2] });
    }
  }
  text += "$EndPeriodic\n";
}
}

std::string WriteGmshMesh(const SolverMesh& mesh)
{
  RequirePeriodic(mesh);
  std::string text = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
  AppendEntities(mesh, text);
  AppendNodes(mesh, text);
  AppendElements(mesh, text);
  AppendPeriods(mesh, text);
  return text;
}
}
