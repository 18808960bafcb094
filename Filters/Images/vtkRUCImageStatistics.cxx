// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCImageStatistics.h"

#include "ImageSlab.h"
#include "LabelInput.h"
#include "OutputSummary.h"
#include "PackData.h"
#include "ProgressReport.h"
#include "RankCommunicator.h"
#include "TwoPointTables.h"
#include "ruc/Base/Estimate.h"
#include "ruc/Base/Require.h"
#include "ruc/Statistics/Results/Phases.h"
#include "ruc/Statistics/Voxels/ImageCorrelation.h"
#include "ruc/Statistics/Voxels/RunLengths.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <numeric>

vtkStandardNewMacro(vtkRUCImageStatistics);

namespace
{
using Pipeline = vtkStreamingDemandDrivenPipeline;

// Labels as they come, are sent and come again; later one byte of a voxel is kept
constexpr double BytesToRead = 4.0, BytesOfVoxel = 1.0;

std::vector<std::array<int, 2>> ParsePairs(const std::string& text, int modes)
{
  const std::string required = ruc::Text("ImagePairs requires pairs of phases, 1 to ", modes,
    " or m, such as '1 1; 1 m; m m', or nothing");
  std::vector<std::array<int, 2>> pairs;
  for (const std::vector<int>& phases : ruc::ParsePhaseLists(text, modes, 2, required))
  {
    pairs.push_back({ std::min(phases[0], phases[1]), std::max(phases[0], phases[1]) });
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

// Throws where a mask has other voxels than the image
void RequireSameGrid(const ruc::VoxelGrid& mask, const ruc::VoxelGrid& image)
{
  const auto describe = [](const ruc::VoxelGrid& grid)
  {
    return ruc::Text(grid.Dimensions[0], " x ", grid.Dimensions[1], " x ", grid.Dimensions[2],
      " from ", grid.Lower[0], " ", grid.Lower[1], " ", grid.Lower[2], " of edges ",
      grid.Spacing[0], " ", grid.Spacing[1], " ", grid.Spacing[2]);
  };
  bool same = mask.Dimensions == image.Dimensions;
  for (int q = 0; q < 3; ++q)
  {
    const double tolerance = 1e-3 * image.Spacing[q];
    same = same && std::abs(mask.Lower[q] - image.Lower[q]) <= tolerance &&
      std::abs(mask.Spacing[q] - image.Spacing[q]) * image.Dimensions[q] <= tolerance;
  }
  ruc::Require(same, "Mask", "the voxels of the image, " + describe(image), describe(mask));
}

ruc::Window BoxOf(const ruc::VoxelGrid& grid, const std::array<bool, 3>& periodic)
{
  ruc::Vector3 size;
  for (int q = 0; q < 3; ++q)
  {
    size[q] = grid.Spacing[q] * grid.Dimensions[q];
  }
  return ruc::Window::MakeBox(grid.Lower, size, periodic);
}

// Fills the table, whole on rank 0, of the runs of all ranks
void FillChords(const ruc::PhaseSlab& slab, const ruc::ImageSettings& settings,
  const ruc::ImageTwoPoint& measured, RankCommunicator& ranks, vtkTable* table)
{
  const double edge = settings.Lags.VoxelEdge();
  const auto runs = ruc::CountRuns(slab, settings.Phases, settings.Periodic, ranks);
  const ruc::ChordLengths chords = ruc::ChordsOfRuns(runs, settings.Lags.Spacing, edge,
    static_cast<int>(settings.Lags.Lags.Maximum() / edge * (1.0 + 1e-9)),
    measured.Probability.Fractions, measured.Surface);
  if (ranks.Rank() == 0)
  {
    TwoPointTables::FillChordLengths(chords, table);
  }
}

// 1.5 mean chords of all particles, which is the diameter of spheres of one size
double ParticleLength(const ruc::ImageTwoPoint& measured)
{
  return 1.5 * 4.0 * (1.0 - measured.Probability.Fractions.back()) / measured.Surface.back();
}
}

vtkRUCImageStatistics::vtkRUCImageStatistics()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(7);
}

int vtkRUCImageStatistics::FillInputPortInformation(int port, vtkInformation* info)
{
  // A composite image is taken, to be refused as one without voxels; else the pipeline would go
  // through its blocks
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port);
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1); // Execute refuses more than one
  return 1;
}

int vtkRUCImageStatistics::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == MAP ? "vtkImageData" : "vtkTable");
  return 1;
}

void vtkRUCImageStatistics::Announce(const ruc::ImageLags& lags, vtkInformation* info) const
{
  const auto& n = lags.Last;
  const int extent[6] = { -n[0], n[0], -n[1], n[1], -n[2], n[2] };
  info->Set(Pipeline::WHOLE_EXTENT(), extent, 6);
  info->Set(vtkDataObject::ORIGIN(), 0.0, 0.0, 0.0);
  info->Set(vtkDataObject::SPACING(), lags.Spacing.data(), 3);
}

int vtkRUCImageStatistics::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  ruc::ImageLags lags = { {}, { 1.0, 1.0, 1.0 }, {} };
  try
  {
    const ruc::VoxelGrid grid = LabelInput::FindGridHere(*this);
    // A source may not know its spacing before it runs
    if (grid.Voxels() > 0.0 && grid.VoxelVolume() > 0.0)
    {
      lags =
        ruc::FindImageLags(grid.Dimensions, grid.Spacing, this->MaximumLag, this->NumberOfLags);
    }
  }
  catch (const std::exception&)
  {
    // The run says what is wrong
  }
  this->Announce(lags, outputs->GetInformationObject(MAP));
  return this->Superclass::RequestInformation(request, inputs, outputs);
}

void vtkRUCImageStatistics::ValidateProperties() const
{
  ruc::Require(this->Boundary >= FROM_IMAGE && this->Boundary <= WINDOW, "Boundary",
    "a value from 0 to 2", this->Boundary);
  ruc::Require(this->SaturationTolerance > 0.0, "SaturationTolerance", "a number > 0",
    this->SaturationTolerance);
}

std::array<bool, 3> vtkRUCImageStatistics::FindPeriodic(
  vtkImageData* image, RankCommunicator& ranks)
{
  vtkDataArray* told = image ? image->GetFieldData()->GetArray("BoxPeriodic") : nullptr;
  std::vector<int> own;
  for (vtkIdType q = 0; told && told->GetNumberOfValues() == 3 && q < 3; ++q)
  {
    own.push_back(told->GetVariantValue(q).ToInt() != 0);
  }
  // Those of the lowest rank that has them
  const std::vector<int> all = ranks.Concatenate(own);
  std::array<bool, 3> periodic{};
  for (int q = 0; q < 3; ++q)
  {
    const bool denied = all.size() >= 3 && all[q] == 0;
    periodic[q] = this->Boundary == PERIODIC ||
      (this->Boundary == FROM_IMAGE && all.size() >= 3 && all[q] != 0);
    if (this->Boundary == PERIODIC && denied && ranks.Rank() == 0)
    {
      vtkWarningMacro(<< "the image is taken as periodic, but its BoxPeriodic says that along "
                      << "xyz"[q] << " it is not.");
    }
  }
  return periodic;
}

ruc::PhaseSlab vtkRUCImageStatistics::ReadPhases(const LabelInput::Image& image, vtkImageData* mask,
  std::vector<std::int64_t>& labels, RankCommunicator& ranks)
{
  LabelInput::LocalLabels local = LabelInput::NumberLabels(image, this->PhaseArray, ranks);
  labels = LabelInput::FindPhases(local, this->MatrixLabel);
  LabelInput::Renumber(local, labels);
  ruc::PhaseSlab slab = ruc::SpreadPhases(local.Block, image.Grid.Dimensions, 2, ranks);
  if (this->HasMask())
  {
    const LabelInput::Image inside = LabelInput::FindImage(mask, this->MaskArray, "Mask", ranks);
    RequireSameGrid(inside.Grid, image.Grid);
    LabelInput::TakeMask(inside, this->MaskLabel, slab, ranks);
  }
  return slab;
}

ruc::ImageSettings vtkRUCImageStatistics::MakeSettings(
  const ruc::VoxelGrid& grid, int phases, const std::array<bool, 3>& periodic) const
{
  return { phases, periodic,
    ruc::FindImageLags(grid.Dimensions, grid.Spacing, this->MaximumLag, this->NumberOfLags), {},
    2 };
}

void vtkRUCImageStatistics::PlanMemory(
  const ruc::VoxelGrid& grid, ruc::ImageSettings& settings, RankCommunicator& ranks)
{
  const ruc::ImageWork work(grid.Dimensions, settings, ranks.Size());
  const double labels = BytesOfVoxel * grid.Voxels() / ranks.Size() / ruc::BytesOfMegabyte;
  this->RequireMemory(
    std::max(labels + work.ForSpectra(2).MegabytesOfRank, labels / BytesOfVoxel * BytesToRead),
    ranks);
  settings.Spectra = std::max(2, work.SpectraWithin(this->GetMemoryLimit() - labels));
}

void vtkRUCImageStatistics::Execute(
  vtkInformationVector** inputs, vtkInformationVector* outputs, RankCommunicator& ranks)
{
  this->ValidateProperties();
  RequireOne(inputs[0], "Input", "image");
  RequireOne(inputs[1], "Mask", "image");
  ProgressReport report(this, this->GetLabel());
  vtkImageData* input = vtkImageData::GetData(inputs[0]);
  const LabelInput::Image image = LabelInput::FindImage(input, this->PhaseArray, "Input", ranks);
  // Before anything is allocated, for the least number of phases, and then for that of the image
  ruc::ImageSettings settings = this->MakeSettings(image.Grid, 2, this->FindPeriodic(input, ranks));
  this->PlanMemory(image.Grid, settings, ranks);
  std::vector<std::int64_t> labels;
  const ruc::PhaseSlab slab =
    this->ReadPhases(image, vtkImageData::GetData(inputs[1]), labels, ranks);
  settings.Phases = static_cast<int>(labels.size());
  settings.Maps = ParsePairs(this->ImagePairs, settings.Phases - 1);
  this->PlanMemory(image.Grid, settings, ranks);

  const ruc::ImageTwoPoint measured = ruc::CorrelateImage(slab, settings, ranks,
    [&](double done)
    { return ranks.Rank() != 0 || report.Update(done, "counting pairs of voxels"); });
  if (ranks.Rank() == 0)
  {
    this->FillTables(measured, labels, outputs);
  }
  if (this->ChordLengths)
  {
    FillChords(slab, settings, measured, ranks, vtkTable::GetData(outputs, CHORDS));
  }
  this->FillMap(measured, settings, ranks, outputs);
  const PackData::PackOrigin origin = { BoxOf(image.Grid, settings.Periodic), "Image",
    PackData::FindLengthUnit(input, ranks), {} };
  OutputSummary::ForEachOutput(outputs,
    [&](vtkDataObject* data)
    {
      PackData::AddWindow(data, origin.Observed);
      PackData::AddOrigin(data, origin);
      this->AddSummary(measured, settings, data);
    });
}

void vtkRUCImageStatistics::AddSummary(
  const ruc::ImageTwoPoint& measured, const ruc::ImageSettings& settings, vtkDataObject* data)
{
  const ruc::TwoPointProbability& probability = measured.Probability;
  const ruc::Vector3& edges = settings.Lags.Spacing;
  OutputSummary::AddLags(data, probability.Lags);
  PackData::AddField(data, "SaturationLength",
    std::vector<double>{
      ruc::SaturationLength(probability, this->SaturationTolerance, ParticleLength(measured)) });
  PackData::AddField(data, "VolumeFractions", probability.Fractions);
  PackData::AddField(data, "VoxelSize", std::vector<double>(edges.begin(), edges.end()));
  PackData::AddField(data, "Mask", std::vector<long long>{ this->HasMask() });
}

void vtkRUCImageStatistics::FillTables(const ruc::ImageTwoPoint& measured,
  const std::vector<std::int64_t>& labels, vtkInformationVector* outputs)
{
  const ruc::TwoPointProbability& probability = measured.Probability;
  const ruc::SampledTwoPoint exact = { probability, {}, {}, {}, 0, 0.0, false };
  TwoPointTables::FillProbabilities(exact, vtkTable::GetData(outputs, PROBABILITIES));
  TwoPointTables::FillChecks(probability,
    ruc::CheckTwoPointProbability(probability, this->SaturationTolerance, ParticleLength(measured)),
    {}, vtkTable::GetData(outputs, CHECKS));
  TwoPointTables::FillGradients(probability, vtkTable::GetData(outputs, GRADIENTS));
  TwoPointTables::FillAutocovariance(probability, vtkTable::GetData(outputs, AUTOCOVARIANCES));

  std::vector<std::string> names;
  std::vector<double> chords;
  for (int r = 0; r < probability.Phases(); ++r)
  {
    names.push_back(probability.PhaseName(r));
    chords.push_back(4.0 * probability.Fractions[r] / measured.Surface[r]);
  }
  const auto unknown = [](double value) { return std::isnan(value); };
  if (this->HasMask() &&
    std::any_of(measured.SurfaceAtOneVoxel.begin(), measured.SurfaceAtOneVoxel.end(), unknown))
  {
    vtkWarningMacro(<< "surfaces, mean chords and S_rs at some lags are NaN, as the mask holds no "
                       "two voxels so far apart.");
  }
  vtkTable* table = vtkTable::GetData(outputs, PHASES);
  PackData::AddColumn(table, "Phase", names);
  PackData::AddColumn(table, "Label", std::vector<long long>(labels.begin(), labels.end()));
  PackData::AddColumn(table, "VolumeFraction", probability.Fractions);
  PackData::AddColumn(table, "SurfacePerVolume", measured.Surface);
  PackData::AddColumn(table, "SurfaceAtOneVoxel", measured.SurfaceAtOneVoxel);
  PackData::AddColumn(table, "MeanChord", chords);
}

void vtkRUCImageStatistics::FillMap(const ruc::ImageTwoPoint& measured,
  const ruc::ImageSettings& settings, const RankCommunicator& ranks,
  vtkInformationVector* outputs) const
{
  vtkImageData* image = vtkImageData::GetData(outputs, MAP);
  const auto& n = settings.Lags.Last;
  ImageSlab::SetExtent(
    image, { -n[0], n[0], -n[1], n[1], -n[2], n[2] }, settings.Lags.Spacing, ranks);
  this->Announce(settings.Lags, outputs->GetInformationObject(MAP));
  for (std::size_t p = 0; p < settings.Maps.size(); ++p)
  {
    ImageSlab::AddArray(image,
      PackData::PairName(measured.Probability, settings.Maps[p][0], settings.Maps[p][1]),
      [&](int i, int j, int k)
      {
        const std::size_t row = 2 * std::size_t(n[0]) + 1, rows = 2 * std::size_t(n[1]) + 1;
        return measured.Maps[p][((k + n[2]) * rows + (j + n[1])) * row + (i + n[0])];
      });
  }
}

std::optional<ruc::Estimate> vtkRUCImageStatistics::MakeEstimate()
{
  constexpr double secondsPerVoxel = 3e-8; // to read labels and count runs
  this->ValidateProperties();
  const ruc::VoxelGrid grid = LabelInput::FindGridHere(*this);
  if (grid.Voxels() == 0.0 || grid.VoxelVolume() == 0.0)
  {
    return {};
  }
  auto* piece = vtkImageData::SafeDownCast(this->GetInputDataObject(0, 0));
  const RankCommunicator ranks(this->GetController());
  int phases = this->LabelsInInput;
  if (phases == 0)
  {
    const VoxelPiece voxels = VoxelInput::Find(piece, this->PhaseArray, "Input");
    if (!voxels.Values)
    {
      return {};
    }
    const double* range = voxels.Values->GetFiniteRange();
    phases = static_cast<int>(
      std::clamp(range[1] - range[0] + 1.0, 2.0, static_cast<double>(ruc::MostImageLabels)));
  }
  vtkDataArray* told = piece->GetFieldData()->GetArray("BoxPeriodic");
  const bool periodic = this->Boundary == PERIODIC ||
    (this->Boundary == FROM_IMAGE && told && told->GetVariantValue(0).ToInt() != 0);
  ruc::ImageSettings settings = this->MakeSettings(grid, phases, { periodic, periodic, periodic });
  settings.Maps = ParsePairs(this->ImagePairs, phases - 1);
  const ruc::ImageWork work(grid.Dimensions, settings, ranks.Size());
  const double labels = BytesOfVoxel * grid.Voxels() / ranks.Size() / ruc::BytesOfMegabyte;
  ruc::Estimate estimate =
    work.ForSpectra(std::max(2, work.SpectraWithin(this->GetMemoryLimit() - labels)));
  estimate += { secondsPerVoxel * grid.Voxels(), labels, 0.0 };
  if (this->MaximumLag == 0.0 || this->NumberOfLags == 0)
  {
    estimate.Automatic = ruc::Text(
      "Maximum Lag ", settings.Lags.Lags.Maximum(), ", Number Of Lags ", settings.Lags.Lags.Count);
  }
  return estimate;
}

void vtkRUCImageStatistics::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PhaseArray: " << this->PhaseArray << "\n";
  os << indent << "MatrixLabel: " << this->MatrixLabel << "\n";
  os << indent << "Boundary: " << this->Boundary << "\n";
  os << indent << "MaximumLag: " << this->MaximumLag << "\n";
  os << indent << "NumberOfLags: " << this->NumberOfLags << "\n";
  os << indent << "SaturationTolerance: " << this->SaturationTolerance << "\n";
  os << indent << "ImagePairs: " << this->ImagePairs << "\n";
  os << indent << "ChordLengths: " << this->ChordLengths << "\n";
  os << indent << "MaskArray: " << this->MaskArray << "\n";
  os << indent << "MaskLabel: " << this->MaskLabel << "\n";
  os << indent << "LabelsInInput: " << this->LabelsInInput << "\n";
}
