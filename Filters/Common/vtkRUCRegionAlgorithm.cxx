// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCRegionAlgorithm.h"

#include "MaskData.h"
#include "PackData.h"
#include "RankCommunicator.h"
#include "ruc/Base/Estimate.h"
#include "ruc/Base/Require.h"
#include "ruc/Base/Text.h"
#include "ruc/Tracing/SamplingRegion.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

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
  constexpr double bytesPerVoxel = 4.0; // to send it, receive it and put the mask together
  // The mask, two more on the way, and the distances from the border of an eighth of the voxels
  constexpr double bytesOfErosion = 5.0;
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
  const double bytes = this->WindowMargin == 0.0 ? bytesPerVoxel : bytesOfErosion;
  return { 0.0, voxels * bytes / ruc::BytesOfMegabyte, 0.0 };
}

std::unique_ptr<ruc::SamplingRegion> vtkRUCRegionAlgorithm::MakeRegion(
  const PackData::SharedPack& pack, RankCommunicator& ranks)
{
  const ruc::PackShare& share = pack.Share;
  if (!(this->WindowMargin >= 0.0 || this->WindowMargin == -1.0) || std::isinf(this->WindowMargin))
  {
    throw std::invalid_argument(
      ruc::Text("WindowMargin requires a finite number >= 0, or -1 for the largest radius, got ",
        this->WindowMargin, "."));
  }
  this->UsedMargin = share.Observed.IsFullyPeriodic() ? 0.0
    : this->WindowMargin >= 0.0                       ? this->WindowMargin
                                                      : share.LargestRadius;
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
  const ruc::VoxelMask mask =
    MaskData::GatherMask(vtkImageData::SafeDownCast(this->GetInputDataObject(1, 0)),
      this->MaskArray, this->MaskLabel, ranks);
  std::int64_t inside = 0;
  for (std::size_t i = 0; i < share.Own.Size(); ++i)
  {
    inside += mask.Contains(share.Own.Centre(i));
  }
  ranks.Sum(&inside, 1);
  if (inside == 0)
  {
    throw std::invalid_argument(
      ruc::Text("Mask requires at least one centre of the pack inside, got none of ",
        share.NumberOfSpheres, "."));
  }
  return std::make_unique<ruc::SamplingRegion>(mask, this->UsedMargin);
}

std::uint32_t vtkRUCRegionAlgorithm::GetCheckedSeed() const
{
  ruc::Require(this->Seed >= 0, "Seed", "a number >= 0", this->Seed);
  return static_cast<std::uint32_t>(this->Seed);
}

void vtkRUCRegionAlgorithm::AddRegionSummary(vtkDataObject* data, const ruc::SamplingRegion& region)
{
  PackData::AddField(data, "Seed", std::vector<long long>{ this->Seed });
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
