// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCTwoPointProbability.h"

#include "ImageSlab.h"
#include "PackData.h"
#include "PackEstimate.h"
#include "ProgressReport.h"
#include "RankCommunicator.h"
#include "TwoPointSum.h"
#include "TwoPointTables.h"
#include "ruc/Base/Text.h"
#include "ruc/Estimates/Estimates.h"
#include "ruc/Particles/PackOverlap.h"
#include "ruc/Statistics/PairSums/ProbabilityMap.h"
#include "ruc/Statistics/Results/OnePointProbability.h"
#include "ruc/Statistics/Results/Phases.h"
#include "ruc/Statistics/Sampling/ChordSampling.h"
#include "ruc/Statistics/Sampling/TemplateSampling.h"
#include "ruc/Window/Directions.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

vtkStandardNewMacro(vtkRUCTwoPointProbability);

namespace
{
const char* const MethodNames[] = { "Exact Pair Sum", "Chord Sampling", "Template Sampling" };

// "1 1; 3 m" as phases counted from 0, the matrix last
std::vector<std::array<int, 2>> ParsePairs(const std::string& text, int modes)
{
  const std::string required = ruc::Text(
    "ImagePairs requires pairs of phases, 1 to ", modes, " or m, such as '1 1; 1 m; m m'");
  std::vector<std::array<int, 2>> pairs;
  for (const std::vector<int>& phases : ruc::ParsePhaseLists(text, modes, 2, required))
  {
    pairs.push_back({ std::min(phases[0], phases[1]), std::max(phases[0], phases[1]) });
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}
}

vtkRUCTwoPointProbability::vtkRUCTwoPointProbability()
{
  this->SetNumberOfOutputPorts(9);
}

int vtkRUCTwoPointProbability::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == MAP ? "vtkImageData" : "vtkTable");
  return 1;
}

int vtkRUCTwoPointProbability::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* map = outputs->GetInformationObject(MAP);
  const int n = this->ImagePairs.empty() ? 0 : std::max(this->ImageResolution, 0);
  int extent[6] = { -n, n, -n, n, -n, n };
  if (this->ImagePairs.empty())
  {
    std::fill_n(extent, 6, 0);
    extent[1] = extent[3] = extent[5] = -1;
  }
  map->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  map->Set(vtkDataObject::ORIGIN(), 0.0, 0.0, 0.0);
  // Known before the pack is only what was set; the data say it in any case
  const double spacing = this->ImageSpacing > 0.0 ? this->ImageSpacing
    : this->MaximumLag > 0.0                      ? this->MaximumLag / std::max(n, 1)
                                                  : 1.0;
  map->Set(vtkDataObject::SPACING(), spacing, spacing, spacing);
  return this->Superclass::RequestInformation(request, inputs, outputs);
}

void vtkRUCTwoPointProbability::ValidateProperties()
{
  const auto require = [](bool good, const char* name, const char* what, double got)
  {
    if (!good)
    {
      throw std::invalid_argument(ruc::Text(name, " requires ", what, ", got ", got, "."));
    }
  };
  require(this->Method >= EXACT_PAIR_SUM && this->Method <= TEMPLATE_SAMPLING, "Method",
    "a value from 0 to 2", this->Method);
  require(this->SaturationTolerance > 0.0, "SaturationTolerance", "a number > 0",
    this->SaturationTolerance);
  require(this->NumberOfDirections == 0 || this->NumberOfDirections >= 2, "NumberOfDirections",
    "0 or a number >= 2", this->NumberOfDirections);
  require(this->ImageResolution >= 1 && this->ImageResolution <= 1000, "ImageResolution",
    "a number from 1 to 1000", this->ImageResolution);
  require(this->ImageSpacing >= 0.0 && std::isfinite(this->ImageSpacing), "ImageSpacing",
    "a finite number >= 0", this->ImageSpacing);
  const auto refuse = [](const char* what, const char* required, const char* got)
  { throw std::invalid_argument(ruc::Text(what, " requires ", required, ", got ", got, ".")); };
  if (this->NumberOfDirections > 0 && this->Method == TEMPLATE_SAMPLING)
  {
    refuse("NumberOfDirections", "Method Exact Pair Sum or Chord Sampling", "Template Sampling");
  }
  if (this->HasMask() && !this->SamplesRegion())
  {
    refuse("Mask", "Method Chord Sampling or Template Sampling", "Exact Pair Sum");
  }
  if (this->HasMask() && !this->ImagePairs.empty())
  {
    refuse("ImagePairs", "a box or cylinder window", "a mask");
  }
  if (this->HasMask() && this->RadialDistribution)
  {
    refuse("RadialDistribution", "a box or cylinder window", "a mask");
  }
}

bool vtkRUCTwoPointProbability::SamplesRegion() const
{
  return this->Method != EXACT_PAIR_SUM || this->ChordLengths;
}

void vtkRUCTwoPointProbability::Execute(
  vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks)
{
  this->ValidateProperties();
  ProgressReport report(this, this->GetLabel());
  const PackData::SharedPack pack =
    PackData::FindShare(input, this->GetWindowProperties(), true, ranks);
  const ruc::PackShare& share = pack.Share;
  const std::vector<std::array<int, 2>> imagePairs =
    ParsePairs(this->ImagePairs, share.NumberOfModes());
  const std::unique_ptr<ruc::SamplingRegion> region =
    this->SamplesRegion() ? this->MakeRegion(pack, ranks) : nullptr;
  const double automatic = this->Method == EXACT_PAIR_SUM
    ? TwoPointSum::AutomaticLag(share)
    : std::min(0.5 * (this->HasMask() ? region->GetBounds() : share.Observed).ShortestEdge(),
        region->LargestLag());
  const ruc::LagGrid lags = TwoPointSum::MakeLags(this->MaximumLag, this->NumberOfLags, automatic);

  ruc::ChordLengths chords;
  ruc::SampledTwoPoint measured = this->Measure(share, region.get(), lags, ranks, report, chords);
  if (ranks.Rank() == 0)
  {
    this->FillTables(measured, chords, share, outputs);
  }
  if (!imagePairs.empty())
  {
    this->FillMap(pack, imagePairs, lags, outputs, ranks, report);
  }
  if (this->NumberOfDirections > 0)
  {
    measured.Stopped =
      this->FillDirections(pack, region.get(), lags, outputs, ranks, report) || measured.Stopped;
  }
  if (this->RadialDistribution)
  {
    this->FillRadialDistribution(share, lags, outputs, ranks, report);
  }

  const double overlap = ruc::MeasureOverlap(share, ranks).Percent;
  const double saturation =
    ruc::SaturationLength(measured.Mean, this->SaturationTolerance, share.MeanDiameter());
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataObject* data = outputs->GetInformationObject(port)->Get(vtkDataObject::DATA_OBJECT());
    PackData::AddField(data, "Method", std::string(MethodNames[this->Method]));
    PackData::AddField(data, "NumberOfLags", std::vector<long long>{ lags.Count });
    PackData::AddField(data, "MaximumLag", std::vector<double>{ lags.Maximum() });
    PackData::AddField(data, "SaturationLength", std::vector<double>{ saturation });
    PackData::AddPackSummary(data, pack, share.NumberOfSpheres, measured.Mean.Fractions, overlap);
    if (region)
    {
      this->AddRegionSummary(data, *region);
      PackData::AddField(data, "Stopped", std::vector<long long>{ measured.Stopped });
    }
    if (this->Method != EXACT_PAIR_SUM)
    {
      PackData::AddField(data,
        this->Method == TEMPLATE_SAMPLING ? "NumberOfThrows" : "NumberOfLines",
        std::vector<long long>{ static_cast<long long>(measured.Samples) });
      PackData::AddField(data, "TotalError", std::vector<double>{ measured.TotalError });
    }
  }
  this->AddConsistency(measured.Mean, share, vtkTable::GetData(outputs, CHECKS));
  if (measured.Stopped && ranks.Rank() == 0)
  {
    vtkWarningMacro(<< this->GetLabel() << ": stopped before all samples were taken.");
  }
  const bool sumsPairs = this->Method == EXACT_PAIR_SUM || !imagePairs.empty();
  if (sumsPairs && ranks.Rank() == 0 && overlap > PackData::TolerableOverlap)
  {
    vtkWarningMacro(<< this->GetLabel() << PackData::OverlapWarning(overlap));
  }
}

ruc::SampledTwoPoint vtkRUCTwoPointProbability::Measure(const ruc::PackShare& share,
  const ruc::SamplingRegion* region, const ruc::LagGrid& lags, RankCommunicator& ranks,
  ProgressReport& report, ruc::ChordLengths& chords) const
{
  const auto progress = [&](double done, const std::string& text)
  { return ranks.Rank() != 0 || report.Update(done, text); };
  const int modes = share.NumberOfModes();
  ruc::SampledTwoPoint byChords = { ruc::TwoPointProbability(modes, lags), {}, {}, {}, 0, 0.0 };
  if (this->Method == CHORD_SAMPLING || this->ChordLengths)
  {
    byChords = ruc::SampleChords(share.Own, modes, *region, lags, this->GetSettings(false), ranks,
      progress, this->ChordLengths ? &chords : nullptr);
  }
  switch (this->Method)
  {
    case CHORD_SAMPLING:
      return byChords;
    case TEMPLATE_SAMPLING:
    {
      ruc::SampledTwoPoint byThrows = ruc::SampleTemplate(
        share.Own, modes, *region, lags, this->GetSettings(true), ranks, progress);
      byThrows.Stopped = byThrows.Stopped || byChords.Stopped;
      return byThrows;
    }
    default: // exact, so without errors
      return { TwoPointSum::Compute(share, lags, ranks, report), {}, {}, {}, 0, 0.0,
        byChords.Stopped };
  }
}

void vtkRUCTwoPointProbability::FillTables(const ruc::SampledTwoPoint& measured,
  const ruc::ChordLengths& chords, const ruc::PackShare& share, vtkInformationVector* outputs) const
{
  const ruc::TwoPointProbability& probability = measured.Mean;
  std::vector<ruc::TwoPointCheck> checks =
    ruc::CheckTwoPointProbability(probability, this->SaturationTolerance, share.MeanDiameter());
  for (std::size_t pair = 0; pair < measured.Asymmetry.size(); ++pair)
  {
    checks[pair].Asymmetry = measured.Asymmetry[pair];
  }
  TwoPointTables::FillProbabilities(measured, vtkTable::GetData(outputs, PROBABILITIES));
  TwoPointTables::FillChecks(probability, checks, vtkTable::GetData(outputs, CHECKS));
  TwoPointTables::FillGradients(probability, vtkTable::GetData(outputs, GRADIENTS));
  if (this->ChordLengths)
  {
    TwoPointTables::FillChordLengths(chords, vtkTable::GetData(outputs, CHORDS));
  }
  if (this->Autocovariance)
  {
    TwoPointTables::FillAutocovariance(probability, vtkTable::GetData(outputs, AUTOCOVARIANCES));
  }
}

void vtkRUCTwoPointProbability::FillRadialDistribution(const ruc::PackShare& share,
  const ruc::LagGrid& lags, vtkInformationVector* outputs, RankCommunicator& ranks,
  ProgressReport& report) const
{
  const ruc::RadialDistribution distribution = ruc::MeasureRadialDistribution(share, lags, ranks,
    [&](double done)
    {
      if (ranks.Rank() == 0)
      {
        report.Update(done, "radial distribution");
      }
    });
  if (ranks.Rank() == 0)
  {
    TwoPointTables::FillRadialDistribution(
      distribution, vtkTable::GetData(outputs, RADIAL_DISTRIBUTIONS));
  }
}

void vtkRUCTwoPointProbability::AddConsistency(
  const ruc::TwoPointProbability& probability, const ruc::PackShare& share, vtkTable* table) const
{
  const double sum =
    std::accumulate(probability.Fractions.begin(), probability.Fractions.end(), 0.0);
  const double surface = std::accumulate(share.Surface.begin(), share.Surface.end(), 0.0);
  const int m = probability.Modes;
  const double slope = ruc::Gradient(probability.S(m, m), probability.Lags.Spacing).front();
  PackData::AddField(table, "VolumeCheck", std::vector<double>{ 1.0 - sum });
  PackData::AddField(table, "SphereVolumeFractions", ruc::OnePointProbability(share));
  PackData::AddField(
    table, "SpecificSurface", std::vector<double>{ surface / share.Observed.Volume() });
  PackData::AddField(table, "SpecificSurfaceFromSlope", std::vector<double>{ -4.0 * slope });
}

void vtkRUCTwoPointProbability::FillMap(const PackData::SharedPack& pack,
  const std::vector<std::array<int, 2>>& pairs, const ruc::LagGrid& lags,
  vtkInformationVector* outputs, RankCommunicator& ranks, ProgressReport& report)
{
  const int n = this->ImageResolution;
  const double reach = this->ImageSpacing > 0.0
    ? n * this->ImageSpacing
    : std::min(lags.Maximum(), ruc::LargestMapReach(pack.Share.LargestRadius, pack.Observed));
  const double spacing = reach / n;
  const ruc::ProbabilityMap map = ruc::MapPairs(pack.Share, pairs, spacing, reach, ranks,
    [&](double done)
    {
      if (ranks.Rank() == 0)
      {
        report.Update(done, "map of S_rs(x)");
      }
    });

  // The map is the same on all ranks
  vtkImageData* image = vtkImageData::GetData(outputs, MAP);
  ImageSlab::SetExtent(image, { -n, n, -n, n, -n, n }, { spacing, spacing, spacing }, ranks);
  const ruc::TwoPointProbability names(pack.Share.NumberOfModes(), { 1.0, 0 });
  for (std::size_t p = 0; p < pairs.size(); ++p)
  {
    ImageSlab::AddArray(image, PackData::PairName(names, pairs[p][0], pairs[p][1]),
      [&](int i, int j, int k) { return map.Values[p][map.PlaceOf(i, j, k)]; });
  }
  outputs->GetInformationObject(MAP)->Set(vtkDataObject::SPACING(), spacing, spacing, spacing);
}

bool vtkRUCTwoPointProbability::FillDirections(const PackData::SharedPack& pack,
  const ruc::SamplingRegion* region, const ruc::LagGrid& lags, vtkInformationVector* outputs,
  RankCommunicator& ranks, ProgressReport& report)
{
  const std::vector<ruc::Vector3> directions = ruc::EvenDirections(this->NumberOfDirections);
  const auto progress = [&](double done, const std::string& text)
  { return ranks.Rank() != 0 || report.Update(done, "directions, " + text); };
  bool stopped = false;
  ruc::DirectionalProbability directional;
  if (this->Method == EXACT_PAIR_SUM)
  {
    directional = ruc::SumPairsAlong(
      pack.Share, directions, lags, ranks, [&](double done) { progress(done, "summing pairs"); });
  }
  else
  {
    directional.Directions = directions;
    for (ruc::SampledTwoPoint& along : ruc::SampleChordsAlong(directions, pack.Share.Own,
           pack.Share.NumberOfModes(), *region, lags, this->GetSettings(false), ranks, progress))
    {
      stopped = stopped || along.Stopped;
      directional.Values.push_back(std::move(along.Mean));
      directional.Errors.push_back(std::move(along.Errors));
    }
  }
  if (ranks.Rank() == 0)
  {
    TwoPointTables::FillIsotropy(directional, vtkTable::GetData(outputs, ISOTROPY));
    TwoPointTables::FillDirections(directional, vtkTable::GetData(outputs, DIRECTIONS));
  }
  return stopped;
}

ruc::Estimate vtkRUCTwoPointProbability::MakeEstimate()
{
  this->ValidateProperties();
  const ruc::PackFigures pack = this->FindFigures();
  const ruc::LagGrid lags = TwoPointSum::MakeLags(this->MaximumLag, this->NumberOfLags,
    PackEstimate::AutomaticLag(pack, this->Method == EXACT_PAIR_SUM));
  const ruc::SamplingSettings lines = this->GetSettings(false), throws = this->GetSettings(true);
  if ((this->SamplesRegion() && lines.TargetError > 0.0) || lines.Samples < 1 || throws.Samples < 1)
  {
    throw std::invalid_argument("How many samples an error takes is only known from samples.");
  }
  const bool byChords = this->Method == CHORD_SAMPLING;
  ruc::Estimate estimate = ruc::EstimatePack(pack);
  if (this->MaximumLag == 0.0)
  {
    estimate.Automatic = ruc::Text("Maximum Lag ", lags.Maximum());
  }
  if (byChords || this->ChordLengths)
  {
    ruc::Estimate chords = ruc::EstimateChords(pack, lags, lines.Samples);
    chords.Seconds *= byChords ? 1 + this->NumberOfDirections : 1;
    estimate += chords;
  }
  if (this->Method == TEMPLATE_SAMPLING)
  {
    estimate += ruc::EstimateTemplate(pack, lags, throws.Samples);
  }
  else if (this->Method == EXACT_PAIR_SUM)
  {
    estimate += ruc::EstimatePairSum(pack, lags);
    if (this->NumberOfDirections > 0)
    {
      estimate += ruc::EstimatePairSumAlong(pack, lags, this->NumberOfDirections);
    }
  }
  if (!this->ImagePairs.empty())
  {
    const int n = this->ImageResolution;
    estimate +=
      ruc::EstimateMap(pack, this->ImageSpacing > 0.0 ? n * this->ImageSpacing : lags.Maximum(),
        static_cast<int>(ParsePairs(this->ImagePairs, pack.Modes).size()), n);
  }
  if (this->RadialDistribution)
  {
    estimate += ruc::EstimateRadialDistribution(pack, lags);
  }
  return estimate;
}

void vtkRUCTwoPointProbability::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "MaximumLag: " << this->MaximumLag << "\n";
  os << indent << "NumberOfLags: " << this->NumberOfLags << "\n";
  os << indent << "SaturationTolerance: " << this->SaturationTolerance << "\n";
  os << indent << "NumberOfDirections: " << this->NumberOfDirections << "\n";
  os << indent << "ImagePairs: " << this->ImagePairs << "\n";
  os << indent << "ImageResolution: " << this->ImageResolution << "\n";
  os << indent << "ImageSpacing: " << this->ImageSpacing << "\n";
  os << indent << "ChordLengths: " << this->ChordLengths << "\n";
  os << indent << "RadialDistribution: " << this->RadialDistribution << "\n";
  os << indent << "Autocovariance: " << this->Autocovariance << "\n";
}
