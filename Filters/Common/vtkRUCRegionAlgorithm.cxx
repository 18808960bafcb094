// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCRegionAlgorithm.h"

#include "MaskData.h"
#include "PackData.h"
#include "RankCommunicator.h"
#include "ruc/Base/Estimate.h"
#include "ruc/Base/Require.h"
#include "ruc/Base/Text.h"
#include "ruc/Images/MaskErosion.h"
#include "ruc/Images/VoxelMask.h"
#include "ruc/Tracing/SamplingRegion.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace
{
// The centres of this rank's spheres that a mask holds
std::int64_t CentresWithin(
  const MaskData::Mask& mask, const ruc::PackShare& share, RankCommunicator& ranks)
{
  const ruc::VoxelMask whole = ruc::VoxelMask::Gather(mask.Grid, mask.Inside, ranks);
  std::int64_t inside = 0;
  for (std::size_t i = 0; i < share.Own.Size(); ++i)
  {
    inside += whole.Contains(share.Own.Centre(i));
  }
  return inside;
}
}

vtkRUCRegionAlgorithm::vtkRUCRegionAlgorithm()
{
  this->SetNumberOfInputPorts(2);
}

vtkRUCRegionAlgorithm::~vtkRUCRegionAlgorithm() = default;

int vtkRUCRegionAlgorithm::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  // A composite image is taken, to be refused as one without voxels; else the pipeline would go
  // through its blocks
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1); // MakeRegion refuses more than one
  return 1;
}

PackData::WindowProperties vtkRUCRegionAlgorithm::GetWindowProperties()
{
  PackData::WindowProperties properties = this->Superclass::GetWindowProperties();
  properties.Masked = this->HasMask();
  return properties;
}

bool vtkRUCRegionAlgorithm::HasMask()
{
  return this->GetNumberOfInputConnections(1) > 0;
}

ruc::Estimate vtkRUCRegionAlgorithm::EstimateRegion()
{
  // Any place may be asked for, so that every rank has where runs of inside voxels end, and as much
  // again to gather it. This holds where such a run, and what follows it, has 32 voxels in the mean
  constexpr double bytesOnEveryRank = 0.5;
  // Of its planes a rank has what is sent, received and put together, or the distances from the
  // border of an eighth of the voxels in place of that
  constexpr double bytesOfPlanes = 4.0, bytesOfErosion = 5.0;
  vtkInformation* info = this->HasMask() ? this->GetInputInformation(1, 0) : nullptr;
  vtkImageData* piece = info ? vtkImageData::GetData(info) : nullptr;
  const auto voxelsOf = [](const int* extent)
  {
    double voxels = 1.0;
    for (int q = 0; q < 3; ++q)
    {
      voxels *= std::max(extent[2 * q + 1] - extent[2 * q] + 1.0, 0.0);
    }
    return voxels;
  };
  // Those of the whole image where its source tells them, and at least those that are on this rank
  double voxels = piece ? voxelsOf(piece->GetExtent()) : 0.0;
  if (info && info->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()))
  {
    int whole[6];
    info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
    voxels = std::max(voxels, voxelsOf(whole));
  }
  const double bytes = this->WindowMargin == 0.0 ? bytesOfPlanes : bytesOfErosion;
  const double megavoxels = voxels / ruc::BytesOfMegabyte;
  return { 0.0, bytesOnEveryRank * megavoxels, bytes * megavoxels };
}

std::unique_ptr<ruc::SamplingRegion> vtkRUCRegionAlgorithm::MakeRegion(
  const PackData::SharedPack& pack, RankCommunicator& ranks)
{
  const ruc::PackShare& share = pack.Share;
  if (!(this->WindowMargin >= 0.0 || this->WindowMargin == -1.0) || std::isinf(this->WindowMargin))
  {
    throw std::invalid_argument(
      ruc::Text("WindowMargin requires a finite number >= 0, or -1 for the automatic one, got ",
        this->WindowMargin, "."));
  }
  this->UsedMargin = share.Observed.IsFullyPeriodic() ? 0.0
    : this->WindowMargin >= 0.0                       ? this->WindowMargin
                                                      : this->GetAutomaticMargin(share);
  if (!this->HasMask())
  {
    return std::make_unique<ruc::SamplingRegion>(share.Observed, this->UsedMargin);
  }
  if (share.Observed.IsPeriodic())
  {
    throw std::invalid_argument(ruc::Text(
      "Mask requires a pack that is not periodic, got a ", share.Observed.Describe(), "."));
  }
  if (this->GetNumberOfInputConnections(1) > 1)
  {
    throw std::invalid_argument(
      ruc::Text("Mask takes one image, got ", this->GetNumberOfInputConnections(1), "."));
  }
  MaskData::Mask mask =
    MaskData::SpreadMask(vtkImageData::SafeDownCast(this->GetInputDataObject(1, 0)),
      this->MaskArray, this->MaskLabel, ranks);
  std::int64_t inside = CentresWithin(mask, share, ranks);
  ranks.Sum(&inside, 1);
  if (inside == 0)
  {
    throw std::invalid_argument(
      ruc::Text("Mask requires at least one centre of the pack inside, got none of ",
        share.NumberOfSpheres, "."));
  }
  mask.Inside = ruc::ErodeMask(std::move(mask.Inside), mask.Grid.Spacing, this->UsedMargin, ranks);
  return std::make_unique<ruc::SamplingRegion>(
    ruc::VoxelMask::Gather(mask.Grid, mask.Inside, ranks), 0.0);
}

double vtkRUCRegionAlgorithm::GetAutomaticMargin(const ruc::PackTotals& pack) const
{
  return pack.LargestRadius;
}

std::uint32_t vtkRUCRegionAlgorithm::GetCheckedSeed() const
{
  ruc::Require(this->Seed >= 0, "Seed", "a number >= 0", this->Seed);
  return static_cast<std::uint32_t>(this->Seed);
}

void vtkRUCRegionAlgorithm::AddRegionSummary(vtkDataObject* data, const ruc::SamplingRegion& region)
{
  PackData::AddField(data, "Seed", std::vector<long long>{ this->Seed });
  this->AddMarginSummary(data, region);
}

void vtkRUCRegionAlgorithm::AddMarginSummary(vtkDataObject* data, const ruc::SamplingRegion& region)
{
  PackData::AddField(data, "Mask", std::vector<long long>{ this->HasMask() });
  PackData::AddField(data, "WindowMargin", std::vector<double>{ this->UsedMargin });
  PackData::AddField(data, "SampledVolume", std::vector<double>{ region.Volume() });
}

void vtkRUCRegionAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaskArray: " << this->MaskArray << "\n";
  os << indent << "MaskLabel: " << this->MaskLabel << "\n";
  os << indent << "WindowMargin: " << this->WindowMargin << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
