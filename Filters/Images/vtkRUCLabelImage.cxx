// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCLabelImage.h"

#include "PackData.h"
#include "ProgressReport.h"
#include "RankCommunicator.h"
#include "VoxelOutput.h"
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
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
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

ruc::VoxelGrid vtkRUCLabelImage::FindGrid(
  vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  RankCommunicator ranks(this->GetController());
  const PackData::SharedPack pack = this->FindShareEarly(inputs, outputs, ranks);
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
  VoxelOutput::Announce(grid, this->ArrayOn == POINTS, outputs->GetInformationObject(0));
  return this->Superclass::RequestInformation(request, inputs, outputs);
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
  vtkDataSetAttributes* voxels = VoxelOutput::VoxelsOf(image, this->ArrayOn == POINTS);
  const vtkIdType count =
    this->ArrayOn == POINTS ? image->GetNumberOfPoints() : image->GetNumberOfCells();
  ruc::LabelArrays arrays;
  if (this->Phases)
  {
    arrays.Phase = VoxelOutput::Add<vtkUnsignedCharArray>(voxels, count, "Phase");
  }
  if (this->ParticleIds)
  {
    arrays.ParticleId = VoxelOutput::Add<vtkIntArray>(voxels, count, "ParticleId");
  }
  for (int n = 0; n < this->GetSettings().FractionArrays(modes); ++n)
  {
    const std::string name = n == 0 ? "VolumeFraction"
      : n <= modes                  ? ruc::Text("VolumeFraction_", n)
                                    : "VolumeFraction_m";
    arrays.Fractions.push_back(VoxelOutput::Add<vtkFloatArray>(voxels, count, name));
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

std::int64_t vtkRUCLabelImage::CheckIds(const ruc::SpherePack& spheres, RankCommunicator& ranks)
{
  const std::int64_t raise = ruc::FindRaise(spheres, ranks);
  const std::int64_t repeated = ruc::CountRepeatedIds(spheres, ranks);
  if (repeated > 0 && ranks.Rank() == 0)
  {
    vtkWarningMacro(
      << repeated
      << " spheres have the Id of another one, such as that of which they are a copy; "
         "ParticleId does not tell them apart.");
  }
  return raise;
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
  VoxelOutput::Announce(grid, this->ArrayOn == POINTS, outputs->GetInformationObject(0));
  vtkImageData* image = vtkImageData::GetData(outputs);
  const bool onPoints = this->ArrayOn == POINTS;
  const ruc::VoxelBlock block = VoxelOutput::FindPiece(grid, onPoints, ranks);
  this->RequireRoom(block, share, ranks);
  VoxelOutput::SetPiece(image, grid, onPoints, ranks);
  const double overlap = this->CheckOverlap(share, false, ranks);

  const std::int64_t raise = this->ParticleIds ? this->CheckIds(spheres, ranks) : 0;
  const ruc::LabelArrays arrays = this->AddArrays(image, share.NumberOfModes());
  const ruc::LabelImage labels(grid, block,
    ruc::SpheresOfBlock(spheres, share.Observed, grid, block, raise, ranks), share.NumberOfModes(),
    settings);
  this->Label(labels, ruc::StepsOfLabels(grid, share.LargestRadius), arrays, ranks);

  if (share.Observed.GetShape() == ruc::Window::Shape::Cylinder)
  {
    vtkDataSetAttributes* voxels = VoxelOutput::VoxelsOf(image, this->ArrayOn == POINTS);
    MarkWindow(share.Observed, grid, block,
      VoxelOutput::Add<vtkUnsignedCharArray>(
        voxels, static_cast<vtkIdType>(block.Voxels()), "Window"));
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
