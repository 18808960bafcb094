// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCLabelImage.h"

#include "ImageSlab.h"
#include "PackData.h"
#include "PackInput.h"
#include "ProgressReport.h"
#include "RankCommunicator.h"
#include "ruc/Base/Require.h"
#include "ruc/Base/Text.h"
#include "ruc/Images/LabelImage.h"
#include "ruc/Particles/PackShare.h"
#include "ruc/Statistics/Results/OnePointProbability.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkRUCLabelImage);

namespace
{
constexpr double VoxelsOfDiameter = 20.0; // where VoxelSize is automatic

// Adds an array with a value for each voxel, not yet set, and returns its values
template <class Array>
auto AddArray(vtkDataSetAttributes* voxels, vtkIdType count, const std::string& name)
{
  vtkNew<Array> array;
  array->SetName(name.c_str());
  array->SetNumberOfValues(count);
  voxels->AddArray(array); // the image keeps it
  if (!voxels->GetScalars())
  {
    voxels->SetActiveScalars(name.c_str());
  }
  return array->GetPointer(0);
}

void MarkWindow(const ruc::Window& window, const ruc::VoxelGrid& grid, const ruc::VoxelBlock& block,
  std::uint8_t* inside)
{
  for (int z = 0; z < block.Count[2]; ++z)
  {
    for (int y = 0; y < block.Count[1]; ++y)
    {
      for (int x = 0; x < block.Count[0]; ++x)
      {
        *inside++ = window.Contains(
          grid.CentreOf(block.First[0] + x, block.First[1] + y, block.First[2] + z));
      }
    }
  }
}
}

int vtkRUCLabelImage::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkImageData");
  return 1;
}

std::array<int, 6> vtkRUCLabelImage::ExtentOf(const std::array<int, 3>& dimensions) const
{
  std::array<int, 6> extent;
  for (int q = 0; q < 3; ++q)
  {
    extent[2 * q] = 0;
    extent[2 * q + 1] = std::max(dimensions[q], 1) - (this->ArrayOn == POINTS ? 1 : 0);
  }
  return extent;
}

ruc::VoxelGrid vtkRUCLabelImage::FindGrid(
  vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  RankCommunicator ranks(this->GetController());
  vtkInformation* input = inputs[0]->GetInformationObject(0);
  int port = 0;
  vtkAlgorithm* producer = this->GetInputAlgorithm(0, 0, port);
  vtkNew<vtkInformationVector> requests;
  requests->SetNumberOfInformationObjects(port + 1);
  vtkInformation* request = requests->GetInformationObject(port);
  request->Set(Pipeline::UPDATE_PIECE_NUMBER(), ranks.Rank());
  request->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), ranks.Size());
  request->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  if (vtkInformation* last = outputs->GetInformationObject(0);
      last->Has(Pipeline::UPDATE_TIME_STEP()))
  {
    request->Set(Pipeline::UPDATE_TIME_STEP(), last->Get(Pipeline::UPDATE_TIME_STEP()));
  }
  producer->Update(port, requests);
  const vtkSmartPointer<vtkPointSet> points = PackInput::Find(vtkDataObject::GetData(input), ranks);
  const PackData::SharedPack pack =
    PackData::FindShare(points, this->GetWindowProperties(), true, ranks);
  return this->MakeGrid(pack.Observed, pack.Share.MeanDiameter());
}

int vtkRUCLabelImage::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  ruc::VoxelGrid grid;
  std::copy_n(this->Dimensions, 3, grid.Dimensions.begin());
  if (grid.Dimensions == std::array<int, 3>{ 0, 0, 0 } &&
    inputs[0]->GetNumberOfInformationObjects() == 1)
  {
    try
    {
      grid = this->FindGrid(inputs, outputs);
    }
    catch (const std::exception&)
    {
      // The run says what is wrong
    }
  }
  this->Announced = grid.Dimensions;
  this->Announce(grid, outputs->GetInformationObject(0));
  return this->Superclass::RequestInformation(request, inputs, outputs);
}

void vtkRUCLabelImage::Announce(const ruc::VoxelGrid& grid, vtkInformation* info)
{
  info->Set(
    vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), this->ExtentOf(grid.Dimensions).data(), 6);
  info->Remove(vtkDataObject::ORIGIN());
  info->Remove(vtkDataObject::SPACING());
  if (grid.Spacing[0] > 0.0) // else only the run knows them
  {
    const ruc::Vector3 origin = this->OriginOf(grid);
    info->Set(vtkDataObject::ORIGIN(), origin.data(), 3);
    info->Set(vtkDataObject::SPACING(), grid.Spacing.data(), 3);
  }
}

ruc::LabelSettings vtkRUCLabelImage::GetSettings() const
{
  ruc::LabelSettings settings;
  settings.Phases = this->Phases;
  settings.ParticleIds = this->ParticleIds;
  settings.Fractions = this->VolumeFractions;
  settings.EveryMode = this->Fractions == EVERY_MODE;
  settings.Method = static_cast<ruc::FractionMethod>(this->FractionMethod);
  settings.SamplesPerAxis = this->SamplesPerAxis;
  return settings;
}

void vtkRUCLabelImage::ValidateProperties() const
{
  ruc::Require(this->Fractions == PARTICLES || this->Fractions == EVERY_MODE, "Fractions",
    "the value 0 or 1", this->Fractions);
  ruc::Require(this->ArrayOn == CELLS || this->ArrayOn == POINTS, "ArrayOn", "the value 0 or 1",
    this->ArrayOn);
  ruc::ValidateLabels(this->GetSettings(), 1);
}

ruc::VoxelGrid vtkRUCLabelImage::MakeGrid(const ruc::Window& window, double meanDiameter) const
{
  const double size = this->VoxelSize == 0.0 ? meanDiameter / VoxelsOfDiameter : this->VoxelSize;
  return ruc::MakeVoxelGrid(
    window, size, { this->Dimensions[0], this->Dimensions[1], this->Dimensions[2] });
}

ruc::Vector3 vtkRUCLabelImage::OriginOf(const ruc::VoxelGrid& grid) const
{
  return this->ArrayOn == POINTS ? grid.CentreOf(0, 0, 0) : grid.Lower;
}

ruc::VoxelBlock vtkRUCLabelImage::SetPiece(vtkImageData* image, const ruc::VoxelGrid& grid,
  const ruc::PackTotals& totals, RankCommunicator& ranks) const
{
  std::array<int, 6> extent = ImageSlab::PieceOf(this->ExtentOf(grid.Dimensions), ranks);
  ruc::VoxelBlock block;
  for (int q = 0; q < 3; ++q)
  {
    block.First[q] = extent[2 * q];
    block.Count[q] =
      std::max(extent[2 * q + 1] - extent[2 * q] + (this->ArrayOn == POINTS ? 1 : 0), 0);
  }
  this->RequireRoom(block, totals, ranks);
  image->SetExtent(extent.data());
  image->SetSpacing(grid.Spacing.data());
  image->SetOrigin(this->OriginOf(grid).data());
  return block;
}

void vtkRUCLabelImage::RequireRoom(
  const ruc::VoxelBlock& block, const ruc::PackTotals& totals, RankCommunicator& ranks) const
{
  const double voxels = 1.0 * block.Count[0] * block.Count[1] * block.Count[2];
  double megabytes = ruc::MegabytesOfLabels(voxels, totals.NumberOfModes(), this->GetSettings());
  if (totals.Observed.GetShape() == ruc::Window::Shape::Cylinder)
  {
    megabytes += voxels / ruc::BytesOfMegabyte;
  }
  // Since VTK 9.4 an image has the coordinates along its edges, as soon as it has an extent
  const double edges = 1.0 * block.Count[0] + block.Count[1] + block.Count[2];
  megabytes += sizeof(double) * edges / ruc::BytesOfMegabyte;
  this->RequireMemory(megabytes, ranks);
}

ruc::LabelArrays vtkRUCLabelImage::AddArrays(vtkImageData* image, int modes) const
{
  vtkDataSetAttributes* voxels =
    image->GetAttributes(this->ArrayOn == POINTS ? vtkDataObject::POINT : vtkDataObject::CELL);
  const vtkIdType count =
    this->ArrayOn == POINTS ? image->GetNumberOfPoints() : image->GetNumberOfCells();
  ruc::LabelArrays arrays;
  if (this->Phases)
  {
    arrays.Phase = AddArray<vtkUnsignedCharArray>(voxels, count, "Phase");
  }
  if (this->ParticleIds)
  {
    arrays.ParticleId = AddArray<vtkIntArray>(voxels, count, "ParticleId");
  }
  for (int n = 0; n < this->GetSettings().FractionArrays(modes); ++n)
  {
    const std::string name = n == 0 ? "VolumeFraction"
      : n <= modes                  ? ruc::Text("VolumeFraction_", n)
                                    : "VolumeFraction_m";
    arrays.Fractions.push_back(AddArray<vtkFloatArray>(voxels, count, name));
  }
  return arrays;
}

void vtkRUCLabelImage::Label(
  const ruc::LabelImage& labels, int steps, const ruc::LabelArrays& arrays, RankCommunicator& ranks)
{
  ProgressReport report(this, this->GetLabel());
  for (int step = 0; step < steps; ++step)
  {
    const bool goOn =
      ranks.Rank() > 0 || report.Update(static_cast<double>(step) / steps, "labelling voxels");
    if (!ranks.All(goOn))
    {
      throw std::invalid_argument("stopped before all voxels were labelled; there is no image.");
    }
    labels.Fill(step, steps, arrays);
  }
}

void vtkRUCLabelImage::RequireAnnounced(const ruc::VoxelGrid& grid) const
{
  const auto& n = grid.Dimensions;
  ruc::Require(n == this->Announced, "Dimensions",
    "three numbers >= 1 where the window changes with time",
    ruc::Text("0 0 0, for which there would be ", n[0], " ", n[1], " ", n[2],
      " voxels now and were ", this->Announced[0], " ", this->Announced[1], " ",
      this->Announced[2]));
}

void vtkRUCLabelImage::Execute(
  vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks)
{
  this->ValidateProperties();
  PackData::PackPiece pack = this->FindPiece(input, true, ranks);
  const ruc::SpherePack spheres = pack.Piece.Spheres();
  const ruc::PackShare share = ruc::SharePack(std::move(pack.Piece), ranks);
  const ruc::LabelSettings settings = this->GetSettings();
  ruc::ValidateLabels(settings, share.NumberOfModes());
  const ruc::VoxelGrid grid = this->MakeGrid(share.Observed, share.MeanDiameter());
  this->RequireAnnounced(grid);
  this->Announce(grid, outputs->GetInformationObject(0));
  vtkImageData* image = vtkImageData::GetData(outputs);
  const ruc::VoxelBlock block = this->SetPiece(image, grid, share, ranks);
  const double overlap = this->CheckOverlap(share, false, ranks);

  const std::int64_t raise = this->ParticleIds ? ruc::FindRaise(spheres, ranks) : 0;
  const ruc::LabelArrays arrays = this->AddArrays(image, share.NumberOfModes());
  const ruc::LabelImage labels(grid, block,
    ruc::SpheresOfBlock(spheres, share.Observed, grid, block, raise, ranks), share.NumberOfModes(),
    settings);
  this->Label(labels, ruc::StepsOfLabels(grid, share.LargestRadius), arrays, ranks);

  if (share.Observed.GetShape() == ruc::Window::Shape::Cylinder)
  {
    vtkDataSetAttributes* voxels =
      image->GetAttributes(this->ArrayOn == POINTS ? vtkDataObject::POINT : vtkDataObject::CELL);
    MarkWindow(share.Observed, grid, block,
      AddArray<vtkUnsignedCharArray>(voxels, static_cast<vtkIdType>(block.Voxels()), "Window"));
  }
  PackData::AddPackSummary(
    image, pack, share.NumberOfSpheres, ruc::OnePointProbability(share), overlap);
  PackData::AddField(
    image, "VoxelSize", std::vector<double>{ grid.Spacing[0], grid.Spacing[1], grid.Spacing[2] });
  PackData::AddField(image, "IncompleteMargin",
    std::vector<double>{ share.Observed.IsFullyPeriodic() ? 0.0 : share.LargestRadius });
  PackData::AddField(image, "ParticleIdsRaised", std::vector<long long>{ raise });
}

std::optional<ruc::Estimate> vtkRUCLabelImage::MakeEstimate()
{
  this->ValidateProperties();
  const std::optional<ruc::PackFigures> pack = this->FindFigures();
  if (!pack)
  {
    return {};
  }
  const ruc::VoxelGrid grid = this->MakeGrid(pack->Observed, pack->MeanDiameter);
  ruc::Estimate estimate = ruc::EstimatePack(*pack);
  estimate += ruc::EstimateLabels(*pack, grid, this->GetSettings());
  const auto& n = grid.Dimensions;
  estimate.Automatic = this->VoxelSize == 0.0 || this->Dimensions[0] == 0
    ? ruc::Text("Voxel Size ", grid.Spacing[0], ", Dimensions ", n[0], " ", n[1], " ", n[2])
    : std::string();
  return estimate;
}

double vtkRUCLabelImage::GetMemoryToCheck()
{
  const std::optional<ruc::PackFigures> pack = this->FindFigures();
  if (!pack)
  {
    return 0.0;
  }
  const ruc::Estimate estimate = ruc::EstimatePack(*pack);
  return estimate.MegabytesOfRank +
    estimate.MegabytesOfAll / RankCommunicator(this->GetController()).Size();
}

void vtkRUCLabelImage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Phases: " << this->Phases << "\n";
  os << indent << "ParticleIds: " << this->ParticleIds << "\n";
  os << indent << "VolumeFractions: " << this->VolumeFractions << "\n";
  os << indent << "VoxelSize: " << this->VoxelSize << "\n";
  os << indent << "Dimensions: " << this->Dimensions[0] << " " << this->Dimensions[1] << " "
     << this->Dimensions[2] << "\n";
  os << indent << "FractionMethod: " << this->FractionMethod << "\n";
  os << indent << "SamplesPerAxis: " << this->SamplesPerAxis << "\n";
  os << indent << "Fractions: " << this->Fractions << "\n";
  os << indent << "ArrayOn: " << this->ArrayOn << "\n";
}
