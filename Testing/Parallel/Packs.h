// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Random.h"
#include "ruc/Packing/OverlapRemoval.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cmath>
#include <functional>
#include <vector>

/**
 * A random pack of 600 spheres without overlap in a periodic cube. `sizeOf` gives radius and mode
 * of the i-th sphere.
 */
inline ruc::SpherePack MakePack(
  double edge, const std::function<std::pair<double, int>(int)>& sizeOf)
{
  ruc::SpherePack pack;
  for (int i = 0; i < 600; ++i)
  {
    const std::array<double, 3> u = ruc::UniformTriple(7, ruc::RandomStream::CellCentres, i);
    pack.X.push_back(edge * u[0]);
    pack.Y.push_back(edge * u[1]);
    pack.Z.push_back(edge * u[2]);
    pack.Radius.push_back(sizeOf(i).first);
    pack.Mode.push_back(sizeOf(i).second);
  }
  ruc::RemoveOverlap(pack,
    ruc::Window::MakeBox({ 0, 0, 0 }, { edge, edge, edge }, { true, true, true }), 1,
    [] { return true; });
  return pack;
}

/** The edge of the packs below, which are cubes with 600 spheres. */
constexpr double Edge = 12.0;

/** Three sizes of spheres, in as many modes. */
inline const ruc::SpherePack& FewSizes()
{
  static const ruc::SpherePack pack =
    MakePack(Edge, [](int i) { return std::make_pair(0.4 + 0.1 * (i % 3), 1 + i % 3); });
  return pack;
}

/** More distinct radii than the tables of the pair sum take, which then goes pair by pair. */
inline const ruc::SpherePack& ManySizes()
{
  static const ruc::SpherePack pack =
    MakePack(Edge, [](int i) { return std::make_pair(0.4 + 0.0004 * i, 1 + i / 300); });
  return pack;
}

/** Those spheres of a pack for which `keep(i)` holds, with its box as field data. */
inline vtkSmartPointer<vtkPolyData> MakePolyData(const ruc::SpherePack& pack, double edge,
  bool periodic, const std::function<bool(std::size_t)>& keep)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> radius;
  radius->SetName("Radius");
  vtkNew<vtkIntArray> mode;
  mode->SetName("Mode");
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    if (keep(i))
    {
      points->InsertNextPoint(pack.X[i], pack.Y[i], pack.Z[i]);
      radius->InsertNextValue(pack.Radius[i]);
      mode->InsertNextValue(pack.Mode[i]);
    }
  }
  data->SetPoints(points);
  // A rank without spheres gets a data set without arrays, as ParaView hands it out.
  if (points->GetNumberOfPoints() > 0)
  {
    data->GetPointData()->AddArray(radius);
    data->GetPointData()->AddArray(mode);
    for (const char* name : { "BoxSize", "BoxPeriodic" })
    {
      vtkNew<vtkDoubleArray> field;
      field->SetName(name);
      for (int q = 0; q < 3; ++q)
      {
        field->InsertNextValue(name == std::string("BoxSize") ? edge : periodic);
      }
      data->GetFieldData()->AddArray(field);
    }
  }
  return data;
}

/**
 * A mask of voxels of edge 0.5 around points, whose inside is a ball that nearly fills a cube. It
 * is the slab of one of `ranks` ranks; the planes of points between slabs are on both ranks, as
 * ParaView hands images out.
 */
inline vtkSmartPointer<vtkImageData> MakeMask(double edge, std::size_t rank, std::size_t ranks)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  const double spacing = 0.5;
  const int last = static_cast<int>(edge / spacing);
  const int from = static_cast<int>(last * rank / ranks);
  const int to = static_cast<int>(last * (rank + 1) / ranks);
  image->SetExtent(0, last, 0, last, from, to);
  image->SetSpacing(spacing, spacing, spacing);
  vtkNew<vtkIntArray> label;
  label->SetName("label");
  label->SetNumberOfValues(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* p = image->GetPoint(i);
    const double d = std::hypot(p[0] - 0.5 * edge, p[1] - 0.5 * edge, p[2] - 0.5 * edge);
    label->SetValue(i, d < 0.48 * edge ? 7 : 0);
  }
  image->GetPointData()->AddArray(label);
  return image;
}
