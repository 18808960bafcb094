// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SphereSurface.h"

#include "ruc/Base/Vector3.h"
#include "ruc/Window/ConvexSurface.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <cmath>
#include <vector>

namespace
{
void MakeSphere(const ruc::Vector3& centre, double radius, int resolution, vtkPolyData* surface)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(centre[0], centre[1], centre[2]);
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(resolution);
  sphere->SetPhiResolution(resolution / 2 + 1);
  sphere->GenerateNormalsOff(); // they would be wrong on the cut faces
  // Copies of a sphere must have the same cuts on opposite faces
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sphere->Update();
  surface->ShallowCopy(sphere->GetOutput());
}

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

// Divides faces of more than three corners into triangles around their middle. A cut meets the
// diagonal of two facets in one plane, and has three corners on a line there, which would make no
// triangle
void FillTriangles(const ruc::ConvexSurface& convex, vtkPolyData* surface)
{
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
    if (face.size() == 3)
    {
      insert(face[0], face[1], face[2]);
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

SphereSurface::Facets SphereSurface::Measure(int resolution)
{
  vtkNew<vtkPolyData> surface;
  MakeSphere({ 0.0, 0.0, 0.0 }, 1.0, resolution, surface);
  const ruc::ConvexSurface facets = ToConvex(surface);
  double volume = 0.0, area = 0.0;
  for (const std::vector<int>& face : facets.Faces)
  {
    const ruc::Vector3& a = facets.Points[face[0]];
    for (std::size_t k = 1; k + 1 < face.size(); ++k)
    {
      const ruc::Vector3 &b = facets.Points[face[k]], &c = facets.Points[face[k + 1]];
      volume += ruc::Dot(a, ruc::Cross(b, c)) / 6.0;
      area += ruc::Length(ruc::Cross({ b[0] - a[0], b[1] - a[1], b[2] - a[2] },
                { c[0] - a[0], c[1] - a[1], c[2] - a[2] })) /
        2.0;
    }
  }
  const double ofSphere = 4.0 / 3.0 * ruc::Pi;
  const double radius = std::cbrt(ofSphere / volume);
  return { radius, 100.0 * (volume * radius * radius * radius / ofSphere - 1.0),
    100.0 * (area * radius * radius / (3.0 * ofSphere) - 1.0) };
}

void SphereSurface::Fill(const ruc::Vector3& centre, double radius, const ruc::Window& box,
  int resolution, vtkPolyData* surface)
{
  MakeSphere(centre, radius, resolution, surface);
  ruc::ConvexSurface cut;
  for (int q = 0; q < 3; ++q)
  {
    for (int side : { 1, -1 }) // keeps what is above the lower face, and below the upper one
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
