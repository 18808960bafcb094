// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * How often the faces of packs are told apart rightly, and how far the fraction in the window that
 * is found lies from the true one: blocks taken at random out of a settled pack, by their centres,
 * whole, or all that touch, and with the floor of its container; then whole packs, where the truth
 * is the fraction deep inside. RUC_THIRD_PARTY_DATA adds a pack of others.
 */
#include "EnclosedPacks.h"
#include "ruc/Particles/FoundWindow.h"

#include <cstdio>
#include <cstdlib>

namespace
{
constexpr int Blocks = 150;
constexpr double LargestDiameter = 56.0; // of the settled pack

double Random(std::mt19937& engine, double from, double to)
{
  return from + (to - from) * (engine() / 4294967296.0);
}

struct Tally
{
  int Faces = 0, Kinds[CountOf(ruc::FaceKind())] = {};
  int Windows = 0, Refused = 0;
  double Error = 0.0, SquaredError = 0.0;

  void Add(ruc::FaceKind kind)
  {
    ++this->Faces;
    ++this->Kinds[static_cast<int>(kind)];
  }
  void Print(const char* what) const
  {
    std::printf("%-28s", what);
    for (ruc::FaceKind kind :
      { ruc::FaceKind::Cut, ruc::FaceKind::Wall, ruc::FaceKind::Loose, ruc::FaceKind::Unknown })
    {
      std::printf(" %4d %s", this->Kinds[static_cast<int>(kind)], NameOf(kind));
    }
    const double mean = this->Error / std::max(this->Windows, 1);
    std::printf(" of %4d", this->Faces);
    if (this->Windows > 0)
    {
      std::printf("; %3d windows, fraction %+.4f +- %.4f", this->Windows, mean,
        std::sqrt(std::max(this->SquaredError / this->Windows - mean * mean, 0.0)));
    }
    std::printf("\n");
  }
};

// Of a block with edges from `least` to `most` D. With `floor` it stands on the floor at z = 0.
void AddBlock(const ruc::SpherePack& pack, double least, double most, oracle::Taken taken,
  bool floor, std::mt19937& engine, Tally& tally)
{
  ruc::Vector3 low, high;
  for (int q = 0; q < 3; ++q)
  {
    const double edge = LargestDiameter * Random(engine, least, most);
    const double from = q < 2 ? -600.0 : floor ? -1.0 : 112.0;
    const double to = q < 2 ? 600.0 : 790.0;
    low[q] = floor && q == 2 ? from : Random(engine, from, std::max(to - edge, from));
    high[q] = low[q] + edge;
  }
  const ruc::SpherePack block = TakeBlock(pack, low, high, taken);
  ruc::Communicator alone;
  const ruc::PackBounds bounds(block, std::nullopt, alone);
  const std::optional<ruc::Mantle> mantle = ruc::FindMantle(block, bounds, alone);
  const ruc::PackFaces faces = ruc::FindFaces(block, bounds, mantle, alone);
  for (int f = floor ? 4 : 0; f < (floor ? 5 : ruc::NumberOfFaces); ++f)
  {
    tally.Add(faces.Kinds[f]);
  }
  const ruc::FoundWindow found = ruc::FindWindow(block, std::nullopt, {}, alone);
  if (found.Observed && !floor)
  {
    const double error = oracle::FractionIn(block, *found.Observed) -
      oracle::FractionIn(pack,
        ruc::Window::MakeBox(
          low, { high[0] - low[0], high[1] - low[1], high[2] - low[2] }, { false, false, false }));
    ++tally.Windows;
    tally.Error += error;
    tally.SquaredError += error * error;
  }
}

void PrintBlocks(const ruc::SpherePack& pack, double least, double most)
{
  std::printf("Blocks with edges of %g to %g D\n", least, most);
  std::mt19937 engine(1);
  const auto print = [&](const char* what, oracle::Taken taken, bool floor)
  {
    Tally tally;
    for (int n = 0; n < Blocks; ++n)
    {
      AddBlock(pack, least, most, taken, floor, engine, tally);
    }
    tally.Print(what);
  };
  print("cut", oracle::Taken::ByCentre, false);
  print("floor", oracle::Taken::ByCentre, true);
  print("whole only", oracle::Taken::Whole, false);
  print("all that touch", oracle::Taken::Touching, false);
}

double PrintPack(const char* what, const ruc::SpherePack& pack, double reference)
{
  ruc::Communicator alone;
  const ruc::FoundWindow found = ruc::FindWindow(pack, std::nullopt, {}, alone);
  const double fraction = found.Observed ? oracle::FractionIn(pack, *found.Observed) : 0.0;
  const ruc::PackBounds bounds(pack, std::nullopt, alone);
  const double volume = found.Observed ? oracle::FractionByPoints(pack, *found.Observed) : 0.0;
  std::printf("%-28s V %.2f, e %.2f, %.4f (%.4f of its volume), deep %.4f, error %+.4f; %s\n", what,
    bounds.VolumeMean, found.Erosion, fraction, volume, reference, fraction - reference,
    found.Faces.c_str());
  for (const std::string& warning : found.Warnings)
  {
    std::printf("    %s\n", warning.c_str());
  }
  return fraction - reference;
}

double Deep(const ruc::SpherePack& pack, const ruc::Vector3& low, const ruc::Vector3& high)
{
  return oracle::FractionIn(
    pack, ruc::Window::MakeBox(low, { high[0] - low[0], high[1] - low[1], high[2] - low[2] }, {}));
}

double DeepOfCube(const ruc::SpherePack& pack, const ruc::Window& cube, double away)
{
  const double to = cube.Size[0] - away;
  const double edge = to - away;
  return oracle::FractionByPoints(
    pack, ruc::Window::MakeBox({ away, away, away }, { edge, edge, edge }, {}));
}

// The mean over several packs, as a window of one holds few spheres
void PrintWalled(const char* what, int spheres, double deviation, double fraction, double deep)
{
  constexpr int Packs = 3;
  double error = 0.0;
  for (int n = 1; n <= Packs; ++n)
  {
    const std::vector<double> radii = oracle::LognormalRadii(spheres, deviation, n);
    const ruc::Window cube = oracle::CubeFor(radii, fraction, { false, false, false });
    const ruc::SpherePack pack = oracle::PackBetweenWalls(radii, cube, n);
    error += PrintPack(what, pack, DeepOfCube(pack, cube, deep * 2.0 * pack.LargestRadius()));
  }
  std::printf("%-28s mean error %+.4f\n", what, error / Packs);
}

ruc::SpherePack ReadDump(const std::string& name)
{
  ruc::SpherePack pack;
  std::ifstream file(name);
  std::string line;
  for (int n = 0; n < 9; ++n)
  {
    std::getline(file, line);
  }
  double row[13];
  while (std::getline(file, line))
  {
    std::istringstream numbers(line);
    for (double& number : row)
    {
      numbers >> number;
    }
    pack.X.push_back(row[2]);
    pack.Y.push_back(row[3]);
    pack.Z.push_back(row[4]);
    pack.Radius.push_back(row[11]);
  }
  return pack;
}
}

int main()
{
  const ruc::SpherePack settled = oracle::ReadTable(RUC_TEST_DATA "/settled_cylinder.csv");
  const ruc::SpherePack beads = oracle::ReadTable(RUC_EXAMPLE_DATA "/bead_block.csv");
  const ruc::Vector3 edges = { 1445.372, 1287.892, 789.106 };
  PrintPack("settled cylinder", settled,
    oracle::FractionByPoints(
      settled, ruc::Window::MakeCylinder({ 0, 0, 200 }, { 0, 0, 1 }, 800, 500)));
  if (const char* others = std::getenv("RUC_THIRD_PARTY_DATA"))
  {
    const ruc::SpherePack pack = ReadDump(std::string(others) + "/azamat/test.particles");
    PrintPack("LIGGGHTS cylinder", pack,
      oracle::FractionByPoints(
        pack, ruc::Window::MakeCylinder({ 0.25, 0.25, 0.315 }, { 0, 0, 1 }, 0.2, 0.945)));
  }
  PrintWalled("six walls, equal", 6000, 0.0, 0.60, 4.0);
  PrintWalled("six walls, lognormal", 12000, 0.35, 0.62, 1.3);
  const double deep = oracle::FractionByPoints(beads,
    ruc::Window::MakeBox({ 53, 53, 105 }, { edges[0] - 106, edges[1] - 106, edges[2] - 158 }, {}));
  const ruc::SpherePack whole = TakeBlock(beads, { 0, 0, 0 }, edges, oracle::Taken::Whole);
  PrintPack("bead block, whole beads", whole, deep);
  PrintPack("bead block", beads, deep);
  PrintBlocks(settled, 9.0, 12.0);
  PrintBlocks(settled, 5.0, 9.0);
  return 0;
}
