// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SphereSurface.h"

#include "ruc/Window/ConvexSurface.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <vector>

namespace
{
ruc::ConvexSurface ToConvex(vtkPolyData* surface)
{
  ruc::ConvexSurface convex;
  convex.Points.resize(surface->GetNumberOfPoints());
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    surface->GetPoint(i, convex.Points[i].data());
  }
  vtkIdType size;
  const vtkIdType* points;
  for (surface->GetPolys()->InitTraversal(); surface->GetPolys()->GetNextCell(size, points);)
  {
    convex.Faces.emplace_back(points, points + size);
  }
  return convex;
}

// Faces of many corners, the cuts, around their middle, which has no slivers
void FillTriangles(const ruc::ConvexSurface& convex, vtkPolyData* surface)
{
  constexpr std::size_t mostCornersOfAFacet = 6;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  for (const ruc::Vector3& point : convex.Points)
  {
    points->InsertNextPoint(point.data());
  }
  auto insert = [&](vtkIdType a, vtkIdType b, vtkIdType c)
  {
    const vtkIdType corners[3] = { a, b, c };
    triangles->InsertNextCell(3, corners);
  };
  for (const std::vector<int>& face : convex.Faces)
  {
    if (face.size() <= mostCornersOfAFacet)
    {
      for (std::size_t k = 1; k + 1 < face.size(); ++k)
      {
        insert(face[0], face[k], face[k + 1]);
      }
      continue;
    }
    ruc::Vector3 middle{};
    for (int corner : face)
    {
      for (int q = 0; q < 3; ++q)
      {
        middle[q] += convex.Points[corner][q] / face.size();
      }
    }
    const vtkIdType centre = points->InsertNextPoint(middle.data());
    for (std::size_t k = 0; k < face.size(); ++k)
    {
      insert(centre, face[k], face[(k + 1) % face.size()]);
    }
  }
  surface->Initialize();
  surface->SetPoints(points);
  surface->SetPolys(triangles);
}
}

void SphereSurface::Fill(const ruc::Vector3& centre, double radius, const ruc::Window& box,
  int resolution, vtkPolyData* surface)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(centre[0], centre[1], centre[2]);
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(resolution);
  sphere->SetPhiResolution(resolution / 2 + 1);
  sphere->GenerateNormalsOff(); // they would be wrong on the cut faces
  // Copies of a sphere are to have the same cuts on opposite faces
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sphere->Update();
  surface->ShallowCopy(sphere->GetOutput());
  ruc::ConvexSurface cut;
  for (int q = 0; q < 3; ++q)
  {
    for (int side : { 1, -1 }) // above the lower face, below the upper one
    {
      const double face = side > 0 ? box.Origin[q] : box.Origin[q] + box.Size[q];
      if (box.Periodic[q] && side * (centre[q] - face) < radius)
      {
        if (cut.Points.empty())
        {
          cut = ToConvex(surface);
        }
        cut.Cut(q, face, side, 1e-9 * radius);
        if (cut.Points.empty())
        {
          surface->Initialize(); // the sphere reaches into the box, its facets do not
          return;
        }
      }
    }
  }
  if (!cut.Points.empty())
  {
    FillTriangles(cut, surface);
  }
}
