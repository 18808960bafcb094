// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Decks have the same bytes on any number of ranks; what is refused leaves no file
#include "Equality.h"
#include "Refusals.h"

#include "vtkRUCPeriodicMesh.h"
#include "vtkRUCSolverDeckWriter.h"

#include "vtkCellData.h"
#include "vtkUnstructuredGrid.h"

#include <filesystem>
#include <fstream>
#include <sstream>

using Mesh = vtkRUCPeriodicMesh;
using Writer = vtkRUCSolverDeckWriter;

namespace
{
constexpr std::size_t Spheres = 60;

// A folder of its own for every number of ranks, since tests run beside each other
std::string NameOf(const std::string& file)
{
  const std::string folder = "decks_of_" + std::to_string(NumberOfRanks());
  std::filesystem::create_directories(folder);
  return folder + "/" + file;
}

std::string Contents(const std::string& name)
{
  std::ifstream file(name, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

vtkSmartPointer<Mesh> MeshOf(bool onAllRanks)
{
  auto mesh = vtkSmartPointer<Mesh>::New();
  mesh->SetElementSize(1.5);
  mesh->SetImprovementRounds(0);
  if (!onAllRanks)
  {
    mesh->SetController(nullptr);
  }
  mesh->SetInputData(MakePolyData(FewSizes(), Edge, true,
    [&](std::size_t i) { return i < Spheres && (!onAllRanks || IsMine(i)); }));
  return mesh;
}

// Expects that the writer refuses the tetrahedra of a mesh that was spoiled, and writes nothing
void Refuses(const std::vector<std::string>& parts, const std::function<void(Writer*)>& configure,
  const std::function<void(vtkUnstructuredGrid*)>& spoil)
{
  const std::string name = NameOf("refused.inp");
  const auto mesh = MeshOf(true);
  mesh->Update();
  vtkNew<vtkUnstructuredGrid> grid;
  grid->ShallowCopy(mesh->GetOutputDataObject(0));
  spoil(grid);
  vtkNew<Writer> writer;
  const Errors errors(writer);
  writer->SetInputData(grid);
  writer->SetFileName(name.c_str());
  configure(writer);
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_EQ(errors.Texts.size(), Rank() == 0 ? 1u : 0u);
  for (const std::string& text : errors.Texts)
  {
    ExpectParts(text, parts);
  }
  EXPECT_FALSE(std::filesystem::exists(name));
}
}

TEST(SolverDeckWriter, BytesAreTheSameOnAnyRanks)
{
  for (const char* extension : { ".inp", ".msh" })
  {
    for (const int regions : { Writer::PHASES, Writer::MODES, Writer::PARTICLES })
    {
      std::string texts[2];
      for (const bool onAllRanks : { false, true })
      {
        const std::string name =
          NameOf((onAllRanks ? "all" : "rank_" + std::to_string(Rank())) + std::string(extension));
        vtkNew<Writer> writer;
        if (!onAllRanks)
        {
          writer->SetController(nullptr);
        }
        writer->SetInputConnection(MeshOf(onAllRanks)->GetOutputPort());
        writer->SetFileName(name.c_str());
        writer->SetRegions(regions);
        writer->SetLengthFactor(1e-3);
        EXPECT_EQ(writer->Write(), 1);
        texts[onAllRanks] = Contents(name);
      }
      if (Rank() == 0)
      {
        EXPECT_FALSE(texts[0].empty());
        EXPECT_TRUE(texts[0] == texts[1]);
        const char* names[] = { "PARTICLES", "MODE_3", "PARTICLE_60" };
        EXPECT_NE(texts[0].find(names[regions]), std::string::npos);
      }
    }
  }
}

TEST(SolverDeckWriter, Refusals)
{
  const auto keep = [](Writer*) {};
  const auto whole = [](vtkUnstructuredGrid*) {};
  Refuses(
    { "Regions requires a value from 0 to 2", "got 3" }, [](Writer* w) { w->SetRegions(3); },
    whole);
  Refuses(
    { "Physics requires", "got -1" }, [](Writer* w) { w->SetPhysics(-1); }, whole);
  Refuses(
    { "LengthFactor requires LengthFactor > 0", "got 0" },
    [](Writer* w) { w->SetLengthFactor(0.0); }, whole);
  Refuses(
    { "FileName requires a name that ends by .inp or .msh", "cell.deck" },
    [](Writer* w) { w->SetFileName(NameOf("cell.deck").c_str()); }, whole);
  Refuses({ "Input requires the tetrahedra of Periodic Mesh", "no array 'PeriodicOf'" }, keep,
    [](vtkUnstructuredGrid* grid) { grid->GetPointData()->RemoveArray("PeriodicOf"); });
  Refuses({ "Input requires the tetrahedra of Periodic Mesh", "no array 'Phase'" }, keep,
    [](vtkUnstructuredGrid* grid) { grid->GetCellData()->RemoveArray("Phase"); });
  Refuses({ "Input requires the tetrahedra of Periodic Mesh", "no field data 'BoxSize'" }, keep,
    [](vtkUnstructuredGrid* grid) { grid->GetFieldData()->RemoveArray("BoxSize"); });
  Refuses({ "Input requires the tetrahedra of Periodic Mesh", "no cells on rank 0" }, keep,
    [](vtkUnstructuredGrid* grid) { grid->Initialize(); });
  Refuses({ "the whole mesh of Periodic Mesh", "is not the copy of point" }, keep,
    [](vtkUnstructuredGrid* grid)
    {
      if (grid->GetNumberOfPoints() > 0)
      {
        vtkNew<vtkPoints> moved;
        moved->DeepCopy(grid->GetPoints());
        moved->SetPoint(0, -5.0, 0.0, 0.0);
        grid->SetPoints(moved);
      }
    });
}
