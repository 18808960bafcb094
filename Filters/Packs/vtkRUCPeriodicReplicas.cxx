// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCPeriodicReplicas.h"

#include "PackData.h"
#include "RankCommunicator.h"
#include "ruc/Base/Text.h"
#include "ruc/Particles/PeriodicReplicas.h"
#include "ruc/Window/ConvexSurface.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <array>
#include <stdexcept>

vtkStandardNewMacro(vtkRUCPeriodicReplicas);

namespace
{
struct Copies
{
  ruc::SpherePack Pack;
  std::vector<std::array<int, 3>> Image;
};

Copies TakeCopies(const Copies& source, const ruc::Window& box,
  const std::vector<ruc::Replica>& replicas, const std::array<int, 3>& edgesPerImage)
{
  Copies copies;
  for (const ruc::Replica& replica : replicas)
  {
    copies.Pack.Append(source.Pack, replica.Original);
    const ruc::Vector3 centre = ruc::CentreOf(replica, source.Pack, box);
    copies.Pack.X.back() = centre[0];
    copies.Pack.Y.back() = centre[1];
    copies.Pack.Z.back() = centre[2];
    std::array<int, 3> image = source.Image[replica.Original];
    for (int q = 0; q < 3; ++q)
    {
      image[q] += replica.Image[q] * edgesPerImage[q];
    }
    copies.Image.push_back(image);
  }
  return copies;
}

// This rank's part
Copies ShareOf(const Copies& all, const RankCommunicator& ranks)
{
  Copies own;
  const std::size_t begin = all.Pack.Size() * ranks.Rank() / ranks.Size();
  const std::size_t end = all.Pack.Size() * (ranks.Rank() + 1) / ranks.Size();
  for (std::size_t i = begin; i < end; ++i)
  {
    own.Pack.Append(all.Pack, i);
    own.Image.push_back(all.Image[i]);
  }
  return own;
}

void FillPoints(const Copies& copies, vtkPolyData* output)
{
  PackData::FillPolyData(copies.Pack, output);
  vtkNew<vtkIntArray> images;
  images->SetName("Image");
  images->SetNumberOfComponents(3);
  images->SetNumberOfTuples(static_cast<vtkIdType>(copies.Image.size()));
  for (std::size_t i = 0; i < copies.Image.size(); ++i)
  {
    images->SetTypedTuple(static_cast<vtkIdType>(i), copies.Image[i].data());
  }
  output->GetPointData()->AddArray(images);
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

// The sphere's surface, closed where the box cuts it: triangles, on a cut around its middle
void CutSurface(const ruc::Vector3& centre, double radius, const ruc::Window& box, int resolution,
  vtkPolyData* surface)
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

// Every point of a surface takes the arrays of its centre
void FillSurfaces(const Copies& copies, const ruc::Window& box, int resolution, vtkPolyData* output)
{
  vtkNew<vtkPolyData> points;
  FillPoints(copies, points);
  vtkNew<vtkAppendPolyData> append;
  for (std::size_t i = 0; i < copies.Pack.Size(); ++i)
  {
    vtkNew<vtkPolyData> surface;
    CutSurface(copies.Pack.Centre(i), copies.Pack.Radius[i], box, resolution, surface);
    vtkPointData* data = surface->GetPointData();
    data->Initialize();
    data->CopyAllocate(points->GetPointData(), surface->GetNumberOfPoints());
    for (vtkIdType p = 0; p < surface->GetNumberOfPoints(); ++p)
    {
      data->CopyData(points->GetPointData(), static_cast<vtkIdType>(i), p);
    }
    append->AddInputData(surface);
  }
  if (copies.Pack.Size() > 0)
  {
    append->Update();
    output->ShallowCopy(append->GetOutput());
  }
}

// The twelve edges of every tile
void FillOutline(const ruc::Window& box, const std::array<int, 3>& tiles, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (int z = 0; z < tiles[2]; ++z)
  {
    for (int y = 0; y < tiles[1]; ++y)
    {
      for (int x = 0; x < tiles[0]; ++x)
      {
        const vtkIdType first = points->GetNumberOfPoints();
        for (int corner = 0; corner < 8; ++corner)
        {
          points->InsertNextPoint(box.Origin[0] + (x + (corner & 1)) * box.Size[0],
            box.Origin[1] + (y + (corner >> 1 & 1)) * box.Size[1],
            box.Origin[2] + (z + (corner >> 2)) * box.Size[2]);
        }
        for (int corner = 0; corner < 8; ++corner)
        {
          for (int bit : { 1, 2, 4 })
          {
            if (!(corner & bit))
            {
              const vtkIdType ends[2] = { first + corner, first + (corner | bit) };
              lines->InsertNextCell(2, ends);
            }
          }
        }
      }
    }
  }
  output->SetPoints(points);
  output->SetLines(lines);
}
}

vtkRUCPeriodicReplicas::vtkRUCPeriodicReplicas()
{
  this->SetNumberOfOutputPorts(3);
}

int vtkRUCPeriodicReplicas::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPolyData");
  return 1;
}

void vtkRUCPeriodicReplicas::Execute(
  vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks)
{
  constexpr double mostCopies = 1e8;
  if (this->Mode != BOUNDARY_COPIES && this->Mode != TILING)
  {
    throw std::invalid_argument(ruc::Text("Mode requires the value 0 or 1, got ", this->Mode, "."));
  }
  if (this->SurfaceResolution < 8 || this->SurfaceResolution > 256)
  {
    throw std::invalid_argument(
      ruc::Text("SurfaceResolution requires 8 <= SurfaceResolution <= 256, got ",
        this->SurfaceResolution, "."));
  }
  PackData::ObservedPack observed = PackData::GatherPack(
    input, this->GetWindowProperties(), PackData::HasArray(input, "Mode", ranks), ranks);
  const ruc::Window& box = observed.Observed;
  if (!box.IsPeriodic())
  {
    throw std::invalid_argument(ruc::Text(
      "A periodic box is required (field data BoxPeriodic, or BoxSize and BoxPeriodic), got a ",
      box.Describe(), "."));
  }
  std::array<int, 3> tiles = { 1, 1, 1 };
  if (this->Mode == TILING)
  {
    std::copy_n(this->Tiles, 3, tiles.begin());
  }
  const double copies = double(tiles[0]) * tiles[1] * tiles[2] * observed.Pack.Size();
  for (int q = 0; q < 3; ++q)
  {
    if (tiles[q] < 1 || (tiles[q] > 1 && !box.Periodic[q]) || copies > mostCopies)
    {
      throw std::invalid_argument(
        ruc::Text("Tiles requires numbers >= 1, 1 along axes that are not periodic, and at most ",
          mostCopies, " copies in all, got ", tiles[0], " ", tiles[1], " ", tiles[2], " for ",
          observed.Pack.Size(), " spheres."));
    }
  }

  ruc::WrapIntoBox(observed.Pack, box);
  Copies all{ observed.Pack, std::vector<std::array<int, 3>>(observed.Pack.Size(), { 0, 0, 0 }) };
  if (this->Mode == TILING)
  {
    all = TakeCopies(all, box, ruc::Tiling(all.Pack, tiles), { 1, 1, 1 });
  }
  const ruc::Window block = ruc::Window::MakeBox(box.Origin,
    { box.Size[0] * tiles[0], box.Size[1] * tiles[1], box.Size[2] * tiles[2] }, box.Periodic);
  Copies filled = all; // every sphere that reaches into the block
  if (this->Mode == BOUNDARY_COPIES || this->ClipToBox)
  {
    filled = TakeCopies(all, block, ruc::BoundaryCopies(all.Pack, block), tiles);
  }
  if (this->Mode == BOUNDARY_COPIES)
  {
    all = filled;
  }

  vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
  FillPoints(ShareOf(all, ranks), output);
  vtkPolyData* outline = vtkPolyData::GetData(outputs, 1);
  if (ranks.Rank() == 0)
  {
    FillOutline(box, tiles, outline);
  }
  vtkPolyData* surfaces = vtkPolyData::GetData(outputs, 2);
  if (this->ClipToBox)
  {
    FillSurfaces(ShareOf(filled, ranks), block, this->SurfaceResolution, surfaces);
  }
  for (vtkPolyData* data : { output, outline, surfaces })
  {
    PackData::AddField(
      data, "Method", std::string(this->Mode == TILING ? "Tiling" : "Boundary Copies"));
    PackData::AddField(data, "Tiles", std::vector<long long>{ tiles[0], tiles[1], tiles[2] });
    PackData::AddField(data, "NumberOfSpheres",
      std::vector<long long>{ static_cast<long long>(observed.Pack.Size()) });
    PackData::AddField(
      data, "NumberOfCopies", std::vector<long long>{ static_cast<long long>(all.Pack.Size()) });
    // Copies beyond the box are no pack in it; a whole tiling is one again
    PackData::AddOrigin(data, observed);
    if (this->Mode == TILING)
    {
      PackData::AddWindow(data, block);
    }
  }
}

void vtkRUCPeriodicReplicas::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mode: " << this->Mode << "\n";
  os << indent << "Tiles: " << this->Tiles[0] << " " << this->Tiles[1] << " " << this->Tiles[2]
     << "\n";
  os << indent << "ClipToBox: " << this->ClipToBox << "\n";
  os << indent << "SurfaceResolution: " << this->SurfaceResolution << "\n";
}
