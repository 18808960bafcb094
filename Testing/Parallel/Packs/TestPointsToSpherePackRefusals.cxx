// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// What Points To Sphere Pack refuses, on all ranks alike
#include "Refusals.h"

#include "vtkRUCPointsToSpherePack.h"

#include "vtkDoubleArray.h"
#include "vtkStringArray.h"

#include <limits>

using Points = vtkRUCPointsToSpherePack;

namespace
{
// The name of this filter in messages
const std::string Name = "Points To Sphere Pack";

void RefusesPoints(const std::vector<std::string>& parts,
  const std::function<void(vtkPolyData*)>& spoil,
  const std::function<void(Points*)>& configure = {})
{
  Refuses<Points>(parts, { {}, spoil, configure });
}
}

TEST(PointsToSpherePackRefusals, NoPoints)
{
  RefusesPack<Points>({ Name, "requires at least one sphere" }, [](auto& p) { p = {}; });
}

TEST(PointsToSpherePackRefusals, NoRadii)
{
  const auto spoil = [](vtkPolyData* d) { d->GetPointData()->RemoveArray("Radius"); };
  RefusesPoints({ Name, "Radii are required", "UniformRadius or RadiusByType, got 'Mode'" }, spoil);
  RefusesPoints({ Name, "The pack requires radii", "got neither radii nor types" }, spoil,
    [](Points* f) { f->SetRadiusByType("1=2"); });
  RefusesPoints({ Name, "Radii are required", "got 'Mode', 'Radius' (text)" },
    [](vtkPolyData* d)
    {
      d->GetPointData()->RemoveArray("Radius");
      vtkNew<vtkStringArray> texts;
      texts->SetName("Radius");
      texts->SetNumberOfValues(d->GetNumberOfPoints());
      d->GetPointData()->AddArray(texts);
    });
  RefusesPoints(
    { Name, "RadiusByType requires a radius of type 3, or UniformRadius, got '1=2;2=3'" }, spoil,
    [](Points* f)
    {
      f->SetTypeArray("Mode");
      f->SetRadiusByType("1=2;2=3");
    });
}

TEST(PointsToSpherePackRefusals, RadiiThatAreNone)
{
  RefusesPack<Points>({ Name, "requires finite values > 0, got nan" },
    [](auto& p) { p.Radius[7] = std::numeric_limits<double>::quiet_NaN(); });
  RefusesPack<Points>(
    { Name, "requires finite values > 0, got -1" }, [](auto& p) { p.Radius[7] = -1.0; });
  RefusesSettings<Points>({ Name, "UniformRadius requires a finite number >= 0, got -2" },
    [](Points* f) { f->SetUniformRadius(-2.0); });
  RefusesSettings<Points>({ Name, "RadiusByType requires types and radii > 0", "got 'steel'" },
    [](Points* f) { f->SetRadiusByType("steel"); });
}

TEST(PointsToSpherePackRefusals, ArraysThatDoNotFit)
{
  RefusesSettings<Points>({ Name, "A point array 'size' is required, got 'Radius', 'Mode'" },
    [](Points* f) { f->SetRadiusArray("size"); });
  RefusesPoints(
    { Name, "'short' requires a value for each of", "points, got 0" },
    [](vtkPolyData* d)
    {
      vtkNew<vtkDoubleArray> array;
      array->SetName("short");
      d->GetPointData()->AddArray(array);
    },
    [](Points* f) { f->SetRadiusArray("short"); });
  const auto addHalves = [](vtkPolyData* d)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName("half");
    array->SetNumberOfValues(d->GetNumberOfPoints());
    array->Fill(0.5);
    d->GetPointData()->AddArray(array);
  };
  RefusesPoints({ Name, "'half' requires whole numbers as ids, got 0.5" }, addHalves,
    [](Points* f) { f->SetIdArray("half"); });
  RefusesPoints({ Name, "'half' requires whole numbers or names of types, got 0.5" }, addHalves,
    [](Points* f) { f->SetTypeArray("half"); });
}

TEST(PointsToSpherePackRefusals, Settings)
{
  RefusesSettings<Points>(
    { Name, "Scale requires a finite number > 0, got 0" }, [](Points* f) { f->SetScale(0.0); });
  RefusesSettings<Points>({ Name, "MemoryLimit requires at least", "got 0.001" },
    [](Points* f) { f->SetMemoryLimit(0.001); });
}
