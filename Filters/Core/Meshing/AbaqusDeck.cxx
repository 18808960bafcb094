// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Formats/WrittenPack.h"
#include "ruc/Meshing/SolverMesh.h"

#include <map>

namespace ruc
{
namespace
{
constexpr int NumbersOfLine = 16; // of a set, as both programs take them
constexpr int TermsOfLine = 4;    // of an equation
constexpr int DegreeOfTemperature = 11;

std::string NodeLine(std::size_t number, const Vector3& place)
{
  std::string line = std::to_string(number);
  for (const double coordinate : place)
  {
    line += ", ";
    AppendNumber(line, coordinate);
  }
  return line + "\n";
}

void AppendSet(const std::string& name, const std::vector<std::size_t>& numbers, std::string& deck)
{
  deck += "*NSET, NSET=" + name + "\n";
  for (std::size_t n = 0; n < numbers.size(); ++n)
  {
    const bool isLast = n + 1 == numbers.size() || (n + 1) % NumbersOfLine == 0;
    deck += std::to_string(numbers[n]) + (isLast ? "\n" : ", ");
  }
}

// One block, with the nodes of the periods at its end: readers such as meshio take the last block
// alone
void AppendNodes(const SolverMesh& mesh, std::string& deck)
{
  deck += "*NODE\n";
  for (std::size_t n = 0; n < mesh.Points.size(); ++n)
  {
    deck += NodeLine(n + 1, mesh.Points[n]);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    Vector3 place = mesh.Origin;
    place[axis] += mesh.Edge[axis];
    deck += NodeLine(mesh.Points.size() + 1 + axis, place);
  }
}

void AppendElements(const SolverMesh& mesh, SolverPhysics physics, std::string& deck)
{
  const std::string type = physics == SolverPhysics::Elasticity ? "C3D4" : "DC3D4";
  for (std::size_t region = 0; region < mesh.RegionNames.size(); ++region)
  {
    deck += "*ELEMENT, TYPE=" + type + ", ELSET=" + mesh.RegionNames[region] + "\n";
    for (std::size_t n = 0; n < mesh.Cells.size(); ++n)
    {
      if (mesh.Region[n] == static_cast<int>(region))
      {
        deck += std::to_string(n + 1);
        for (const int corner : mesh.Cells[n])
        {
          deck += ", " + std::to_string(corner + 1);
        }
        deck += "\n";
      }
    }
  }
}

void AppendEquations(const SolverMesh& mesh, SolverPhysics physics, std::string& deck)
{
  const bool isElastic = physics == SolverPhysics::Elasticity;
  const int first = isElastic ? 1 : DegreeOfTemperature, last = isElastic ? 3 : first;
  for (std::size_t n = 0; n < mesh.Points.size(); ++n)
  {
    std::vector<std::size_t> nodes{ n + 1, static_cast<std::size_t>(mesh.PeriodicOf[n]) + 1 };
    for (int axis = 0; axis < 3; ++axis)
    {
      if (mesh.Boundary[n] >> (2 * axis) & 2)
      {
        nodes.push_back(mesh.Points.size() + 1 + axis);
      }
    }
    if (nodes.size() == 2)
    {
      continue;
    }
    for (int degree = first; degree <= last; ++degree)
    {
      deck += "*EQUATION\n" + std::to_string(nodes.size()) + "\n";
      for (std::size_t k = 0; k < nodes.size(); ++k)
      {
        const bool endsLine = k + 1 == nodes.size() || (k + 1) % TermsOfLine == 0;
        deck += std::to_string(nodes[k]) + ", " + std::to_string(degree) +
          (k == 0 ? ", 1." : ", -1.") + (endsLine ? "\n" : ", ");
      }
    }
  }
}
}

std::string WriteAbaqusDeck(const SolverMesh& mesh, SolverPhysics physics)
{
  RequirePeriodic(mesh);
  std::string deck =
    "** Periodic cell by the ParaView plugin Representative Unit Cell.\n"
    "** Include this file, then give each element set a material and a section, hold "
    "CORNER_X0Y0Z0,\n"
    "** and give PERIOD_X, PERIOD_Y and PERIOD_Z the mean gradient times the edges.\n";
  AppendNodes(mesh, deck);
  AppendElements(mesh, physics, deck);
  std::map<std::string, std::vector<std::size_t>> sets;
  for (std::size_t n = 0; n < mesh.Points.size(); ++n)
  {
    if (mesh.Boundary[n] != 0)
    {
      sets[NameOfBoundary(mesh.Boundary[n])].push_back(n + 1);
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    sets[std::string("PERIOD_") + "XYZ"[axis]] = { mesh.Points.size() + 1 + axis };
  }
  for (const auto& [name, nodes] : sets)
  {
    AppendSet(name, nodes, deck);
  }
  AppendEquations(mesh, physics, deck);
  return deck;
}
}
