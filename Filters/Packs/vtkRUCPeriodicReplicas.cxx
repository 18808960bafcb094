// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCPeriodicReplicas.h"

#include "PackData.h"
#include "PackInput.h"
#include "RankCommunicator.h"
#include "SphereSurface.h"
#include "ruc/Base/Estimate.h"
#include "ruc/Base/Require.h"
#include "ruc/Base/Text.h"
#include "ruc/Particles/PeriodicReplicas.h"
#include "ruc/Window/BoxOutline.h"

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
#include "vtkSmartPointer.h"

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

Copies TileAll(const ruc::SpherePack& pack, const ruc::Window& box, const std::array<int, 3>& tiles)
{
  const Copies once{ pack, std::vector<std::array<int, 3>>(pack.Size(), { 0, 0, 0 }) };
  return TakeCopies(once, box, ruc::Tiling(pack, tiles), { 1, 1, 1 });
}

// Returns this rank's part
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

// Returns every sphere and image whose facets, with corners at `scale` radii, reach into the block
Copies TakeCopiesOfFacets(
  const Copies& all, const ruc::Window& block, double scale, const std::array<int, 3>& tiles)
{
  ruc::SpherePack corners = all.Pack;
  for (double& radius : corners.Radius)
  {
    radius *= scale;
  }
  return TakeCopies(all, block, ruc::BoundaryCopies(corners, block), tiles);
}

// Makes the surfaces. Every point of a surface takes the arrays of its centre
void FillSurfaces(
  const Copies& copies, const ruc::Window& box, int resolution, double scale, vtkPolyData* output)
{
  vtkNew<vtkPolyData> points;
  FillPoints(copies, points);
  vtkNew<vtkAppendPolyData> append;
  for (std::size_t i = 0; i < copies.Pack.Size(); ++i)
  {
    vtkNew<vtkPolyData> surface;
    SphereSurface::Fill(
      copies.Pack.Centre(i), scale * copies.Pack.Radius[i], box, resolution, surface);
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

// Makes the twelve edges of every tile
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
        ruc::ForEachOfOutline(
          box.Origin, box.Size, { x, y, z },
          [&](const ruc::Vector3& corner) { points->InsertNextPoint(corner.data()); },
          [&](int a, int b)
          {
            const vtkIdType ends[2] = { first + a, first + b };
            lines->InsertNextCell(2, ends);
          });
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

void vtkRUCPeriodicReplicas::CheckProperties() const
{
  ruc::Require(this->Method == BOUNDARY_COPIES || this->Method == TILING, "Method",
    "the value 0 or 1", this->Method);
  ruc::Require(this->SurfaceResolution >= 8 && this->SurfaceResolution <= 256, "SurfaceResolution",
    "8 <= SurfaceResolution <= 256", this->SurfaceResolution);
}

std::array<int, 3> vtkRUCPeriodicReplicas::FindTiles(
  const ruc::Window& box, std::size_t spheres) const
{
  constexpr double mostCopies = 1e8;
  std::array<int, 3> tiles = { 1, 1, 1 };
  if (this->Method == TILING)
  {
    std::copy_n(this->Tiles, 3, tiles.begin());
  }
  const double copies = double(tiles[0]) * tiles[1] * tiles[2] * spheres;
  for (int q = 0; q < 3; ++q)
  {
    ruc::Require(tiles[q] >= 1 && (tiles[q] == 1 || box.Periodic[q]) && copies <= mostCopies,
      "Tiles",
      ruc::Text("numbers >= 1, 1 along axes that are not periodic, and at most ", mostCopies,
        " copies in all"),
      ruc::Text(tiles[0], " ", tiles[1], " ", tiles[2], " for ", spheres, " spheres"));
  }
  return tiles;
}

void vtkRUCPeriodicReplicas::Execute(
  vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks)
{
  this->CheckProperties();
  PackData::ObservedPack observed =
    this->GatherPack(input, PackData::HasArray(input, "Mode", ranks), ranks);
  const ruc::Window& box = observed.Observed;
  if (!box.IsPeriodic())
  {
    throw std::invalid_argument(ruc::Text(
      "A periodic box is required (field data BoxPeriodic, or BoxSize and BoxPeriodic), got a ",
      box.Describe(), "."));
  }
  const std::array<int, 3> tiles = this->FindTiles(box, observed.Pack.Size());
  const ruc::Window block = ruc::Window::MakeBox(box.Origin,
    { box.Size[0] * tiles[0], box.Size[1] * tiles[1], box.Size[2] * tiles[2] }, box.Periodic);
  ruc::WrapIntoBox(observed.Pack, box);
  const Copies all = TileAll(observed.Pack, box, tiles);
  const Copies filled = this->Method == BOUNDARY_COPIES
    ? TakeCopies(all, block, ruc::BoundaryCopies(all.Pack, block), tiles)
    : Copies(); // every sphere that reaches into the block
  const Copies& shown = this->Method == BOUNDARY_COPIES ? filled : all;

  FillPoints(ShareOf(shown, ranks), vtkPolyData::GetData(outputs, 0));
  if (ranks.Rank() == 0)
  {
    FillOutline(box, tiles, vtkPolyData::GetData(outputs, 1));
  }
  if (this->ClipToBox)
  {
    const SphereSurface::Facets facets = SphereSurface::Measure(this->SurfaceResolution);
    const Copies cut = TakeCopiesOfFacets(all, block, facets.Radius, tiles);
    vtkPolyData* surfaces = vtkPolyData::GetData(outputs, 2);
    FillSurfaces(ShareOf(cut, ranks), block, this->SurfaceResolution, facets.Radius, surfaces);
    PackData::AddField(
      surfaces, "VolumeErrorPercent", std::vector<double>{ facets.VolumeErrorPercent });
    PackData::AddField(
      surfaces, "AreaErrorPercent", std::vector<double>{ facets.AreaErrorPercent });
  }
  this->AddSummary(observed, tiles, block, shown.Pack.Size(), outputs);
}

void vtkRUCPeriodicReplicas::AddSummary(const PackData::ObservedPack& observed,
  const std::array<int, 3>& tiles, const ruc::Window& block, std::size_t copies,
  vtkInformationVector* outputs) const
{
  for (int port = 0; port < 3; ++port)
  {
    vtkPolyData* data = vtkPolyData::GetData(outputs, port);
    PackData::AddField(
      data, "Method", std::string(this->Method == TILING ? "Tiling" : "Boundary Copies"));
    PackData::AddField(data, "Tiles", std::vector<long long>{ tiles[0], tiles[1], tiles[2] });
    PackData::AddField(data, "NumberOfSpheres",
      std::vector<long long>{ static_cast<long long>(observed.Pack.Size()) });
    PackData::AddField(
      data, "NumberOfCopies", std::vector<long long>{ static_cast<long long>(copies) });
    // Boundary copies get no window, as some lie outside the box; a whole tiling is a pack in its
    // block
    PackData::AddOrigin(data, observed);
    if (this->Method == TILING)
    {
      PackData::AddWindow(data, block);
    }
  }
}

std::optional<ruc::Estimate> vtkRUCPeriodicReplicas::MakeEstimate()
{
  constexpr double secondsPerCopy = 1e-6, secondsPerFacet = 1e-6;
  constexpr double bytesPerCopy = 110.0, bytesPerTile = 600.0; // on every rank
  constexpr double bytesPerPoint = 100.0, bytesPerFacet = 130.0;
  const vtkSmartPointer<vtkPointSet> input = PackInput::FindHere(this->GetInputDataObject(0, 0));
  const vtkIdType points = input ? input->GetNumberOfPoints() : 0;
  const double spheres = static_cast<double>(std::max(points, this->GetKnownSpheres()));
  // Boundary copies may be about as many as the spheres
  const double tiles = this->Method == TILING
    ? static_cast<double>(this->Tiles[0]) * this->Tiles[1] * this->Tiles[2]
    : 2.0;
  const double copies = spheres * tiles;
  const double facets =
    this->ClipToBox ? copies * this->SurfaceResolution * this->SurfaceResolution : 0.0;
  ruc::Estimate estimate;
  estimate.Seconds = copies * secondsPerCopy + facets * secondsPerFacet;
  estimate.MegabytesOfRank =
    (copies * bytesPerCopy * (this->ClipToBox ? 2.0 : 1.0) + tiles * bytesPerTile) /
    ruc::BytesOfMegabyte;
  estimate.MegabytesOfAll =
    (copies * bytesPerPoint + facets * bytesPerFacet) / ruc::BytesOfMegabyte;
  return estimate;
}

void vtkRUCPeriodicReplicas::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "Tiles: " << this->Tiles[0] << " " << this->Tiles[1] << " " << this->Tiles[2]
     << "\n";
  os << indent << "ClipToBox: " << this->ClipToBox << "\n";
  os << indent << "SurfaceResolution: " << this->SurfaceResolution << "\n";
}
