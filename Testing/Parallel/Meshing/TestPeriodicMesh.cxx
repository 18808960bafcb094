// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Meshes are the same on any number of ranks; what their arrays and field data say; what is refused
#include "Equality.h"
#include "Refusals.h"

#include "vtkRUCPeriodicMesh.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkUnstructuredGrid.h"

#include <map>
#include <set>

using Mesh = vtkRUCPeriodicMesh;

namespace
{
const std::string Name = "Periodic Mesh";

class MeshEquality : public EveryPack
{
};
INSTANTIATE_EVERY_PACK(MeshEquality);

// Few tetrahedra, as they come
void Quick(Mesh* filter)
{
  filter->SetElementSize(1.5);
  filter->SetImprovementRounds(0);
}

double Field(vtkDataObject* data, const char* name, int n = 0)
{
  return vtkDataArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(name))
    ->GetComponent(n, 0);
}

// Two spheres of modes 2 and 1 and ids 0 and 7 in a box
vtkSmartPointer<vtkPolyData> TwoSpheres(bool withModes)
{
  ruc::SpherePack pack;
  pack.X = { 0.5, 2.5 };
  pack.Y = { 0.5, 2.5 };
  pack.Z = { 0.5, 2.5 };
  pack.Radius = { 1.0, 1.5 };
  pack.Mode = { 2, 1 };
  const auto data = MakePolyData(pack, 4.0, true, [](std::size_t) { return Rank() == 0; });
  if (Rank() == 0)
  {
    vtkNew<vtkIntArray> id;
    id->SetName("Id");
    id->InsertNextValue(0);
    id->InsertNextValue(7);
    data->GetPointData()->AddArray(id);
    if (!withModes)
    {
      data->GetPointData()->RemoveArray("Mode");
    }
  }
  return data;
}
}

TEST_P(MeshEquality, OfTetrahedraAndTables)
{
  if (EveryPack::IsPeriodic())
  {
    ExpectSame<Mesh>(
      [](Mesh* f)
      {
        f->SetElementSize(1.5);
        f->SetImprovementRounds(1);
      });
  }
}

TEST(PeriodicMesh, LabelsAndCopies)
{
  for (const bool withModes : { true, false })
  {
    vtkNew<Mesh> filter;
    const Errors errors(filter);
    filter->SetInputData(TwoSpheres(withModes));
    filter->Update();
    EXPECT_TRUE(errors.Texts.empty());
    auto* mesh = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(Mesh::TETRAHEDRA));
    EXPECT_EQ(Field(mesh, "NumberOfSpheres"), 2);
    // The volumes of the balls; the gap is that of the diagonal
    EXPECT_NEAR(Field(mesh, "VolumeFractions", withModes ? 1 : 0),
      4.0 / 3.0 * ruc::Pi * (withModes ? 1.0 : 1.0 + 3.375) / 64.0, 1e-15);
    EXPECT_NEAR(Field(mesh, "LeastGap"), std::sqrt(12.0) - 2.5, 1e-14);
    EXPECT_LT(Field(mesh, "MeshFractions"), Field(mesh, "VolumeFractions"));
    if (Rank() > 0)
    {
      EXPECT_EQ(mesh->GetNumberOfCells(), 0);
      continue;
    }
    std::map<int, std::set<int>> phases;
    vtkDataArray* phase = mesh->GetCellData()->GetArray("Phase");
    vtkDataArray* id = mesh->GetCellData()->GetArray("ParticleId");
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
    {
      phases[static_cast<int>(id->GetComponent(cell, 0))].insert(
        static_cast<int>(phase->GetComponent(cell, 0)));
    }
    const std::map<int, std::set<int>> expected = { { 0, { 0 } }, { 1, { withModes ? 2 : 1 } },
      { 8, { 1 } } };
    EXPECT_EQ(phases, expected);
    vtkDataArray* copyOf = mesh->GetPointData()->GetArray("PeriodicOf");
    vtkDataArray* boundary = mesh->GetPointData()->GetArray("Boundary");
    for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
    {
      double own[3], base[3];
      mesh->GetPoint(point, own);
      mesh->GetPoint(static_cast<vtkIdType>(copyOf->GetComponent(point, 0)), base);
      const int faces = static_cast<int>(boundary->GetComponent(point, 0));
      for (int axis = 0; axis < 3; ++axis)
      {
        const double origin = Field(mesh, "BoxOrigin", axis);
        EXPECT_EQ(own[axis] == origin, (faces >> (2 * axis) & 1) == 1);
        const bool isHigh = faces >> (2 * axis) & 2;
        EXPECT_EQ(own[axis] == origin + 4.0, isHigh);
        EXPECT_EQ(base[axis], isHigh ? origin : own[axis]);
      }
    }
  }
}

TEST(MeshRefusals, SettingsOutOfRange)
{
  const auto refuses = [](const std::string& part, const std::string& got,
                         const std::function<void(Mesh*)>& spoil) {
    RefusesSettings<Mesh>({ Name, part, got }, spoil, true, Quick);
  };
  refuses(
    "ElementSize requires ElementSize >= 0", "got -1", [](Mesh* f) { f->SetElementSize(-1.0); });
  refuses("ElementSize requires 0 or a length from 0.012 to 6", "got 7",
    [](Mesh* f) { f->SetElementSize(7.0); });
  refuses("MemoryLimit", "4000", [](Mesh* f) { f->SetElementSize(0.02); });
  refuses("LeastGap requires LeastGap >= 0", "got -1", [](Mesh* f) { f->SetLeastGap(-1.0); });
  refuses("LeastGap requires gaps >= 0.3", "set MinimumGap", [](Mesh* f) { f->SetLeastGap(0.3); });
  refuses("ImprovementRounds requires", "got 1001", [](Mesh* f) { f->SetImprovementRounds(1001); });
  refuses("Seed requires Seed >= 0", "got -1", [](Mesh* f) { f->SetSeed(-1); });
}

TEST(MeshRefusals, PacksWithoutAMesh)
{
  const auto configure = Quick;
  Refuses<Mesh>({ Name, "requires spheres that do not touch", "which overlap by" },
    { [](ruc::SpherePack& p) { p.Radius[3] *= 2.5; }, {}, {} }, true, configure);
  Refuses<Mesh>({ Name, "requires a box that is periodic along three axes", "got a box window" },
    { {}, [](vtkPolyData* d) { d->GetFieldData()->RemoveArray("BoxPeriodic"); }, {} }, true,
    configure);
}
