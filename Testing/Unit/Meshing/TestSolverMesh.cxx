// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Decks read back line by line; what solvers make of them is tested with the solvers themselves
#include "ruc/Meshing/PeriodicMesh.h"
#include "ruc/Meshing/SolverMesh.h"

#include <map>
#include <set>
#include <sstream>
#include <stdexcept>

using namespace ruc;

namespace
{
// A ball in a box with unequal edges, whose centre is the origin
SolverMesh OneBall()
{
  SpherePack pack;
  pack.X = pack.Y = pack.Z = { 0.3 };
  pack.Radius = { 0.4 };
  const Window box = Window::MakeBox({ -1, 2, 5 }, { 1, 1.25, 1.5 }, { true, true, true });
  MeshSettings settings;
  settings.ElementSize = 0.2;
  const PeriodicMesh made = MakePeriodicMesh(pack, box, settings);
  SolverMesh mesh;
  mesh.Origin = box.Origin;
  mesh.Edge = made.Edge;
  for (const Vector3& place : made.Points)
  {
    mesh.Points.push_back(
      { box.Origin[0] + place[0], box.Origin[1] + place[1], box.Origin[2] + place[2] });
  }
  mesh.Boundary = made.Boundary;
  mesh.PeriodicOf.assign(made.PeriodicOf.begin(), made.PeriodicOf.end());
  mesh.Cells = made.Cells;
  for (const int particle : made.Particle)
  {
    mesh.Region.push_back(particle + 1);
  }
  mesh.RegionNames = { "MATRIX", "PARTICLES" };
  return mesh;
}

// A deck as blocks: the line of a keyword, and the numbers of the lines after it
struct Block
{
  std::string Keyword;
  std::vector<std::vector<double>> Lines;
};

std::vector<Block> BlocksOf(const std::string& deck)
{
  std::vector<Block> blocks;
  std::istringstream lines(deck);
  for (std::string line; std::getline(lines, line);)
  {
    if (line.rfind("**", 0) == 0)
    {
      continue;
    }
    if (line[0] == '*')
    {
      blocks.push_back({ line, {} });
      continue;
    }
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream numbers(line);
    blocks.back().Lines.emplace_back();
    for (double number; numbers >> number;)
    {
      blocks.back().Lines.back().push_back(number);
    }
  }
  return blocks;
}

std::string Refusal(const SolverMesh& mesh)
{
  try
  {
    WriteAbaqusDeck(mesh, SolverPhysics::Elasticity);
  }
  catch (const std::invalid_argument& e)
  {
    return e.what();
  }
  return {};
}
}

TEST(SolverMesh, NamesOfBoundaries)
{
  EXPECT_EQ(NameOfBoundary(0), "");
  EXPECT_EQ(NameOfBoundary(LowX), "FACE_X0");
  EXPECT_EQ(NameOfBoundary(HighZ), "FACE_Z1");
  EXPECT_EQ(NameOfBoundary(HighX | LowY), "EDGE_X1Y0");
  EXPECT_EQ(NameOfBoundary(LowX | HighY | LowZ), "CORNER_X0Y1Z0");
}

TEST(SolverMesh, AbaqusHasElementsAndDisjointSets)
{
  const SolverMesh mesh = OneBall();
  std::map<std::string, std::size_t> elements;
  std::set<double> inSets;
  std::size_t sets = 0, members = 0;
  for (const Block& block : BlocksOf(WriteAbaqusDeck(mesh, SolverPhysics::Elasticity)))
  {
    if (block.Keyword == "*NODE")
    {
      ASSERT_EQ(block.Lines.size(), mesh.Points.size() + 3);
      for (std::size_t n = 0; n < mesh.Points.size(); ++n)
      {
        const Vector3& place = mesh.Points[n];
        ASSERT_EQ(block.Lines[n], (std::vector<double>{ n + 1.0, place[0], place[1], place[2] }));
      }
    }
    if (block.Keyword.rfind("*ELEMENT, TYPE=C3D4", 0) == 0)
    {
      elements[block.Keyword] = block.Lines.size();
    }
    if (block.Keyword.rfind("*NSET", 0) == 0)
    {
      ++sets;
      for (const std::vector<double>& line : block.Lines)
      {
        EXPECT_LE(line.size(), 16u);
        members += line.size();
        inSets.insert(line.begin(), line.end());
      }
    }
  }
  const auto inside =
    static_cast<std::size_t>(std::count(mesh.Region.begin(), mesh.Region.end(), 1));
  const std::map<std::string, std::size_t> expected = { { "*ELEMENT, TYPE=C3D4, ELSET=MATRIX",
                                                          mesh.Cells.size() - inside },
    { "*ELEMENT, TYPE=C3D4, ELSET=PARTICLES", inside } };
  EXPECT_EQ(elements, expected);
  // 6 faces, 12 edges, 8 corners and 3 periods
  EXPECT_EQ(sets, 29u);
  EXPECT_EQ(members, inSets.size());
  const auto free = std::count(mesh.Boundary.begin(), mesh.Boundary.end(), 0);
  EXPECT_EQ(members, mesh.Points.size() - free + 3);
}

TEST(SolverMesh, EquationsHoldForEveryLinearField)
{
  const SolverMesh mesh = OneBall();
  const double gradient[3][3] = { { 0.3, -0.2, 0.7 }, { 0.1, 0.5, -0.4 }, { -0.6, 0.2, 0.9 } };
  for (const SolverPhysics physics : { SolverPhysics::Elasticity, SolverPhysics::Conduction })
  {
    const bool isElastic = physics == SolverPhysics::Elasticity;
    // u = gradient . x at the nodes; gradient . edge at those of the periods
    const auto valueAt = [&](int node, int degree)
    {
      const int n = node - 1, points = static_cast<int>(mesh.Points.size());
      const double* row = gradient[isElastic ? degree - 1 : 0];
      return n < points ? Dot({ row[0], row[1], row[2] }, mesh.Points[n])
                        : row[n - points] * mesh.Edge[n - points];
    };
    std::set<std::pair<int, int>> eliminated, used;
    for (const Block& block : BlocksOf(WriteAbaqusDeck(mesh, physics)))
    {
      if (block.Keyword != "*EQUATION")
      {
        continue;
      }
      std::vector<double> terms;
      for (std::size_t line = 1; line < block.Lines.size(); ++line)
      {
        EXPECT_LE(block.Lines[line].size(), 12u);
        terms.insert(terms.end(), block.Lines[line].begin(), block.Lines[line].end());
      }
      ASSERT_EQ(terms.size(), 3 * block.Lines[0][0]);
      double sum = 0.0;
      for (std::size_t k = 0; k < terms.size(); k += 3)
      {
        const std::pair<int, int> unknown(terms[k], terms[k + 1]);
        EXPECT_TRUE((k == 0 ? eliminated : used).insert(unknown).second || k > 0);
        sum += terms[k + 2] * valueAt(unknown.first, unknown.second);
      }
      EXPECT_NEAR(sum, 0.0, 1e-13);
    }
    for (const auto& unknown : used)
    {
      EXPECT_EQ(eliminated.count(unknown), 0u);
    }
    std::size_t high = 0;
    for (const std::uint8_t faces : mesh.Boundary)
    {
      high += (faces & (HighX | HighY | HighZ)) != 0;
    }
    EXPECT_EQ(eliminated.size(), high * (isElastic ? 3 : 1));
  }
}

TEST(SolverMesh, PeriodsOfGmshAreAnEdgeApart)
{
  const SolverMesh mesh = OneBall();
  std::istringstream text(WriteGmshMesh(mesh));
  for (std::string line; std::getline(text, line) && line != "$Periodic";)
  {
  }
  int links = 0;
  text >> links;
  ASSERT_EQ(links, 3);
  for (int axis = 0; axis < 3; ++axis)
  {
    int dimension, high, low, numbers;
    text >> dimension >> high >> low >> numbers;
    EXPECT_EQ((std::array<int, 4>{ dimension, high, low, numbers }),
      (std::array<int, 4>{ 2, 2 * axis + 2, 2 * axis + 1, 16 }));
    for (int n = 0; n < 16; ++n)
    {
      double number = 0.0;
      text >> number;
      EXPECT_EQ(number, n == 4 * axis + 3 ? mesh.Edge[axis] : n % 5 == 0 ? 1.0 : 0.0);
    }
    std::size_t pairs = 0;
    text >> pairs;
    std::set<std::size_t> seen;
    for (std::size_t n = 0; n < pairs; ++n)
    {
      std::size_t slave = 0, master = 0;
      text >> slave >> master;
      seen.insert(slave);
      Vector3 moved = mesh.Points[master - 1];
      moved[axis] += mesh.Edge[axis];
      EXPECT_EQ(mesh.Points[slave - 1], moved);
    }
    EXPECT_EQ(seen.size(),
      static_cast<std::size_t>(std::count_if(mesh.Boundary.begin(), mesh.Boundary.end(),
        [&](std::uint8_t faces) { return faces >> (2 * axis) & 2; })));
  }
}

TEST(SolverMesh, RefusesWhatIsNoWholeMesh)
{
  SolverMesh mesh = OneBall();
  EXPECT_EQ(Refusal(mesh), "");
  const auto high =
    std::find(mesh.Boundary.begin(), mesh.Boundary.end(), HighX) - mesh.Boundary.begin();
  mesh.PeriodicOf[high] = high;
  EXPECT_NE(Refusal(mesh).find("which is not the copy of point"), std::string::npos);
  mesh = OneBall();
  mesh.Points[high][1] += 1e-6;
  EXPECT_NE(Refusal(mesh).find("which is not the copy of point"), std::string::npos);
  mesh = OneBall();
  mesh.Cells[0][2] = static_cast<int>(mesh.Points.size());
  EXPECT_NE(Refusal(mesh).find("requires corners from 0"), std::string::npos);
}
