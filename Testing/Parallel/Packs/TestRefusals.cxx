// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Bad input of the filters that make packs from packs
#include "Refusals.h"

#include "PackData.h"
#include "ResultData.h"
#include "vtkRUCParticleModes.h"
#include "vtkRUCPeriodicReplicas.h"

#include <limits>

using Modes = vtkRUCParticleModes;
using Replicas = vtkRUCPeriodicReplicas;

TEST(ParticleModesRefusals, NoPoints)
{
  RefusesPack<Modes>({ "Particle Modes", "no points" }, [](auto& p) { p = {}; });
}

TEST(ParticleModesRefusals, TooLittleMemory)
{
  RefusesSettings<Modes>(
    { "Particle Modes", "MemoryLimit requires at least", "MB on every rank", "got 0.001" },
    [](Modes* f) { f->SetMemoryLimit(0.001); });
}

// It makes no list of so many diameters
TEST(ParticleModesRefusals, AnEdgeFarBehindTheOthers)
{
  vtkNew<Modes> filter;
  const Errors errors(filter);
  filter->SetEdge(std::numeric_limits<int>::max(), 1.0);
  filter->SetEdge(-1, 1.0);
  EXPECT_EQ(filter->GetNumberOfEdges(), 0);
  EXPECT_EQ(errors.Texts.size(), 2u);
}

TEST(ParticleModesRefusals, NoModesWanted)
{
  RefusesSettings<Modes>({ "Particle Modes", "NumberOfModes requires", "got 0" },
    [](Modes* f) { f->SetNumberOfModes(0); });
}

TEST(ParticleModesRefusals, EdgesThatLeaveSpheresOut)
{
  RefusesSettings<Modes>({ "Particle Modes", "Edges requires every diameter" },
    [](Modes* f)
    {
      f->SetMethod(Modes::EXPLICIT_EDGES);
      f->SetEdge(0, 0.9);
      f->SetEdge(1, 2.0);
    });
}

TEST(ParticleModes, ArraysShorterThanThePointsAreLeftOut)
{
  const auto data = MakePolyData(FewSizes(), Edge, true, IsMine);
  for (vtkIdType count : { vtkIdType(2), data->GetNumberOfPoints() })
  {
    vtkNew<vtkDoubleArray> other;
    other->SetName(count == 2 ? "Short" : "Whole");
    other->SetNumberOfValues(count);
    other->FillComponent(0, 3.0);
    data->GetPointData()->AddArray(other);
  }
  vtkNew<Modes> filter;
  filter->SetInputData(data);
  filter->Update();
  vtkPointData* arrays = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0))->GetPointData();
  EXPECT_FALSE(arrays->HasArray("Short"));
  EXPECT_TRUE(arrays->HasArray("Whole"));
}

TEST(ParticleModes, AWindowOfTheOtherShapeReplacesOneThatWasFound)
{
  const auto found = [](const ruc::Window& window)
  {
    auto data = MakePolyData(FewSizes(), Edge, true, IsMine);
    PackData::AddWindow(data, window);
    PackData::AddField(data, "WindowSource", std::string("Eroded"));
    return data;
  };
  const ruc::Window box = ruc::Window::MakeBox({ 0, 0, 0 }, { Edge, Edge, Edge }, {});
  const ruc::Window cylinder =
    ruc::Window::MakeCylinder({ 0.5 * Edge, 0.5 * Edge, 0.0 }, { 0, 0, 1 }, Edge, Edge);
  vtkNew<Modes> inCylinder;
  inCylinder->SetInputData(found(box));
  inCylinder->SetCylinderBase(cylinder.Base.data());
  inCylinder->SetCylinderRadius(cylinder.Radius);
  inCylinder->SetCylinderHeight(cylinder.Height);
  inCylinder->Update();
  vtkFieldData* fields = inCylinder->GetOutputDataObject(0)->GetFieldData();
  EXPECT_EQ(fields->GetArray("BoxSize"), nullptr);
  EXPECT_EQ(fields->GetArray("BoxPeriodic"), nullptr);
  EXPECT_NE(fields->GetArray("CylinderRadius"), nullptr);
  vtkNew<Modes> inBox;
  inBox->SetInputData(found(cylinder));
  inBox->SetBoxSize(Edge, Edge, Edge);
  inBox->Update();
  fields = inBox->GetOutputDataObject(0)->GetFieldData();
  EXPECT_EQ(fields->GetArray("CylinderRadius"), nullptr);
  EXPECT_NE(fields->GetArray("BoxSize"), nullptr);
}

TEST(ParticleModesRefusals, NothingLeft)
{
  RefusesSettings<Modes>({ "Particle Modes", "MinimumDiameter requires", "got 50" },
    [](Modes* f) { f->SetMinimumDiameter(50.0); });
}

TEST(PeriodicReplicasRefusals, NoPoints)
{
  RefusesPack<Replicas>({ "Periodic Replicas", "no points" }, [](auto& p) { p = {}; });
}

TEST(PeriodicReplicasRefusals, NoTiles)
{
  RefusesSettings<Replicas>({ "Periodic Replicas", "Tiles requires", "got 0 1 1" },
    [](Replicas* f)
    {
      f->SetMethod(Replicas::TILING);
      f->SetTiles(0, 1, 1);
    });
}

TEST(PeriodicReplicasRefusals, TilesThatTakeTooMuchMemory)
{
  RefusesSettings<Replicas>(
    { "Periodic Replicas", "MemoryLimit requires at least", "MB on every rank", "got 4000" },
    [](Replicas* f)
    {
      f->SetMethod(Replicas::TILING);
      f->SetTiles(100, 100, 10);
    });
  RefusesSettings<Replicas>({ "Periodic Replicas", "MemoryLimit requires at least", "got 4000" },
    [](Replicas* f)
    {
      f->SetMethod(Replicas::TILING);
      f->SetTiles(10, 10, 2);
      f->SetClipToBox(true);
      f->SetSurfaceResolution(256);
    });
}
