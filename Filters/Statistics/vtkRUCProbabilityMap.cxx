// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCProbabilityMap.h"

#include "ImageSlab.h"
#include "MeasuredLags.h"
#include "OutputSummary.h"
#include "PackData.h"
#include "ProgressReport.h"
#include "RankCommunicator.h"
#include "StatisticsEstimate.h"
#include "ruc/Base/Require.h"
#include "ruc/Base/Text.h"
#include "ruc/Statistics/PairSums/ProbabilityMap.h"
#include "ruc/Statistics/Results/LagLimit.h"
#include "ruc/Statistics/Results/OnePointProbability.h"
#include "ruc/Statistics/Results/Phases.h"

#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

vtkStandardNewMacro(vtkRUCProbabilityMap);

namespace
{
// Pairs such as "1 1; 3 m" as phases counted from 0, the matrix last
std::vector<std::array<int, 2>> ParsePairs(const std::string& text, int modes)
{
  const std::string required = ruc::Text(
    "PhasePairs requires pairs of phases, 1 to ", modes, " or m, such as '1 1; 1 m; m m'");
  std::vector<std::array<int, 2>> pairs;
  for (const std::vector<int>& phases : ruc::ParsePhaseLists(text, modes, 2, required))
  {
    pairs.push_back({ std::min(phases[0], phases[1]), std::max(phases[0], phases[1]) });
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  if (pairs.empty())
  {
    throw std::invalid_argument(required + ", got none.");
  }
  return pairs;
}
}

int vtkRUCProbabilityMap::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkImageData");
  return 1;
}

int vtkRUCProbabilityMap::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* image = outputs->GetInformationObject(0);
  const int n = std::max(this->Resolution, 0);
  const int extent[6] = { -n, n, -n, n, -n, n };
  image->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  image->Set(vtkDataObject::ORIGIN(), 0.0, 0.0, 0.0);
  // Before the pack is known, only what was set is known; the data say it in any case
  const double spacing = this->Spacing > 0.0 ? this->Spacing
    : this->MaximumLag > 0.0                 ? this->MaximumLag / std::max(n, 1)
                                             : 1.0;
  image->Set(vtkDataObject::SPACING(), spacing, spacing, spacing);
  return this->Superclass::RequestInformation(request, inputs, outputs);
}

void vtkRUCProbabilityMap::ValidateProperties() const
{
  ruc::Require(this->Resolution >= 1 && this->Resolution <= 1000, "Resolution",
    "a number from 1 to 1000", this->Resolution);
  ruc::Require(this->Spacing >= 0.0 && std::isfinite(this->Spacing), "Spacing",
    "a finite number >= 0", this->Spacing);
}

void vtkRUCProbabilityMap::Execute(
  vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks)
{
  this->ValidateProperties();
  ProgressReport report(this, this->GetLabel());
  const PackData::SharedPack pack = this->FindShare(input, ranks);
  const ruc::PackShare& share = pack.Share;
  const double overlap = this->CheckOverlap(share, true, ranks);
  const int modes = share.NumberOfModes();
  const double reach = this->FindReach(share);
  const ruc::ProbabilityMap map = ruc::MapPairs(share, ParsePairs(this->PhasePairs, modes),
    reach / this->Resolution, reach, ranks, report.ForSums(ranks));

  this->FillImage(map, modes, ranks, outputs);
  vtkImageData* image = vtkImageData::GetData(outputs);
  PackData::AddField(image, "MaximumLag", std::vector<double>{ reach });
  PackData::AddPackSummary(
    image, pack, share.NumberOfSpheres, ruc::OnePointProbability(share), overlap);
}

double vtkRUCProbabilityMap::FindReach(const ruc::PackShare& share) const
{
  const double maximum = MeasuredLags::Find(this->MaximumLag, 1, share).Maximum();
  return this->Spacing > 0.0
    ? this->Resolution * this->Spacing
    : ruc::LagLimit::ForMap(share.Observed, share.LargestRadius, maximum).Automatic;
}

void vtkRUCProbabilityMap::FillImage(const ruc::ProbabilityMap& map, int modes,
  const RankCommunicator& ranks, vtkInformationVector* outputs) const
{
  const int n = this->Resolution;
  const double spacing = map.Spacing;
  vtkImageData* image = vtkImageData::GetData(outputs);
  ImageSlab::SetExtent(image, { -n, n, -n, n, -n, n }, { spacing, spacing, spacing }, ranks);
  const ruc::TwoPointProbability names(modes, { 1.0, 0 });
  for (std::size_t p = 0; p < map.Pairs.size(); ++p)
  {
    ImageSlab::AddArray(image, PackData::PairName(names, map.Pairs[p][0], map.Pairs[p][1]),
      [&](int i, int j, int k) { return map.Values[p][map.PlaceOf(i, j, k)]; });
  }
  outputs->GetInformationObject(0)->Set(vtkDataObject::SPACING(), spacing, spacing, spacing);
}

std::optional<ruc::Estimate> vtkRUCProbabilityMap::MakeEstimate()
{
  this->ValidateProperties();
  const std::optional<ruc::PackFigures> pack = this->FindFigures();
  if (!pack)
  {
    return {};
  }
  const double maximum = this->Spacing > 0.0 ? this->Resolution * this->Spacing : this->MaximumLag;
  const ruc::LagGrid lags = StatisticsEstimate::FindLags(maximum, 1, *pack, true);
  const std::size_t pairs = ParsePairs(this->PhasePairs, pack->Modes).size();
  ruc::Estimate estimate = StatisticsEstimate::OfPack(*pack, maximum, lags);
  estimate += ruc::EstimateMap(*pack, lags.Maximum(), static_cast<int>(pairs), this->Resolution);
  return estimate;
}

void vtkRUCProbabilityMap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PhasePairs: " << this->PhasePairs << "\n";
  os << indent << "Resolution: " << this->Resolution << "\n";
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "MaximumLag: " << this->MaximumLag << "\n";
}
