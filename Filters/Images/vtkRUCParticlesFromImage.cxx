// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCParticlesFromImage.h"

#include "ImageParticles.h"
#include "OutputSummary.h"
#include "PackData.h"
#include "ProgressReport.h"
#include "RankCommunicator.h"
#include "VoxelOutput.h"
#include "ruc/Base/Estimate.h"
#include "ruc/Base/Require.h"
#include "ruc/Images/Fit/FindSpheres.h"
#include "ruc/Images/Watershed/CutParticles.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <utility>

vtkStandardNewMacro(vtkRUCParticlesFromImage);

namespace
{
using ruc::Require;
using ruc::Text;

constexpr double DiameterOfParticle = 3.0; // the least, in voxels, where it is automatic
constexpr double SmallDiameter = 5.0;      // below which the fit finds fewer
constexpr int MostSmoothing = 10;
constexpr double MostStretched = 1.1; // an edge of a voxel, over the shortest
constexpr double FitShare = 0.75;     // of the time that a fit and what is measured after it take

double MeanEdge(const ruc::VoxelGrid& grid)
{
  return std::cbrt(grid.VoxelVolume());
}

// Throws where voxels are not nearly cubes
void RequireCubes(const ruc::VoxelGrid& grid)
{
  const auto [least, most] = std::minmax_element(grid.Spacing.begin(), grid.Spacing.end());
  Require(*most <= MostStretched * *least, "Input",
    "voxels whose edges differ by a tenth at most, as resampling makes them",
    Text(grid.Spacing[0], " x ", grid.Spacing[1], " x ", grid.Spacing[2]));
}
}

vtkRUCParticlesFromImage::vtkRUCParticlesFromImage()
{
  this->SetNumberOfOutputPorts(4);
}

int vtkRUCParticlesFromImage::FillInputPortInformation(int, vtkInformation* info)
{
  // A composite image is taken, to be refused as one without voxels; else the pipeline would go
  // through its blocks
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1); // Execute refuses more than one
  return 1;
}

int vtkRUCParticlesFromImage::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(),
    port == IDS || port == RESIDUAL ? "vtkImageData" : "vtkPolyData");
  return 1;
}

int vtkRUCParticlesFromImage::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const ruc::VoxelGrid grid = LabelInput::FindGridHere(*this);
  for (int port : { IDS, RESIDUAL })
  {
    VoxelOutput::Announce(
      grid, !LabelInput::HasCellsHere(*this), outputs->GetInformationObject(port));
  }
  return this->Superclass::RequestInformation(request, inputs, outputs);
}

void vtkRUCParticlesFromImage::ValidateProperties() const
{
  const auto choice = [](const char* name, int value, int most)
  { Require(value >= 0 && value <= most, name, Text("a value from 0 to ", most), value); };
  choice("Method", this->Method, WATERSHED);
  Require(this->MarkerHeight > 0.0 && std::isfinite(this->MarkerHeight), "MarkerHeight",
    "a finite number > 0", this->MarkerHeight);
  choice("ImageKind", this->ImageKind, LABELS);
  choice("ParticlesAre", this->ParticlesAre, DARK);
  choice("BorderParticles", this->BorderParticles, WHOLE_ONLY);
  Require(this->Smoothing >= -1 && this->Smoothing <= MostSmoothing, "Smoothing",
    Text("a number from -1 to ", MostSmoothing), this->Smoothing);
  const auto finite = [](const char* name, double value)
  { Require(std::isfinite(value), name, "a finite number", value); };
  finite("Threshold", this->Threshold);
  finite("MatrixValue", this->MatrixValue);
  finite("ParticleValue", this->ParticleValue);
  Require(this->MinimumDiameter >= 0.0 && std::isfinite(this->MinimumDiameter), "MinimumDiameter",
    "a finite number >= 0", this->MinimumDiameter);
  Require(this->OverlapTolerance >= 0.0 && this->OverlapTolerance <= 1.0, "OverlapTolerance",
    "a number from 0 to 1", this->OverlapTolerance);
}

bool vtkRUCParticlesFromImage::HasLabels(
  const LabelInput::Image& image, RankCommunicator& ranks) const
{
  const char* name = image.Piece.Values ? image.Piece.Values->GetName() : nullptr;
  const bool named = !image.Piece.Values || (name && std::string(name) == "ParticleId");
  return this->ImageKind == LABELS || (ranks.All(named) && this->ImageKind == AUTOMATIC);
}

void vtkRUCParticlesFromImage::SetPhases(const ImageParticles& work, ruc::PhaseSearch& search) const
{
  const double sign = this->ParticlesAre == DARK ? -1.0 : 1.0;
  if (work.HasLabels)
  {
    search.Binary = true;
  }
  else
  {
    if (this->ImageKind != AUTOMATIC)
    {
      search.Binary = this->ImageKind == BINARY;
    }
    if (this->Threshold != 0.0)
    {
      search.Threshold = sign * this->Threshold;
    }
    if (this->MatrixValue != this->ParticleValue)
    {
      search.MatrixValue = sign * this->MatrixValue;
      search.ParticleValue = sign * this->ParticleValue;
    }
  }
  search.Smoothing = this->Smoothing;
}

double vtkRUCParticlesFromImage::LeastDiameterOf(const ImageParticles& work) const
{
  return this->MinimumDiameter > 0.0 ? this->MinimumDiameter / work.Edge : DiameterOfParticle;
}

ruc::SphereSearch vtkRUCParticlesFromImage::MakeSearch(const ImageParticles& work) const
{
  ruc::SphereSearch search;
  this->SetPhases(work, search);
  search.Edges = work.Edges;
  search.LeastDiameter = this->LeastDiameterOf(work);
  search.OverlapTolerance = this->OverlapTolerance;
  search.WholeOnly = this->BorderParticles == WHOLE_ONLY;
  return search;
}

ruc::ParticleSearch vtkRUCParticlesFromImage::MakeCut(const ImageParticles& work) const
{
  ruc::ParticleSearch search;
  this->SetPhases(work, search);
  search.Edges = work.Edges;
  search.MarkerHeight = this->MarkerHeight;
  search.LeastDiameter = this->LeastDiameterOf(work);
  search.WholeOnly = this->BorderParticles == WHOLE_ONLY;
  return search;
}

void vtkRUCParticlesFromImage::ReadImage(ImageParticles& work, RankCommunicator& ranks) const
{
  std::vector<float> values = LabelInput::ReadValues(work.Input, ranks);
  if (this->ParticlesAre == DARK && !work.HasLabels)
  {
    std::transform(values.begin(), values.end(), values.begin(), std::negate<>());
  }
  work.Slab =
    ruc::SpreadGrey(work.Input.Piece.Block, std::move(values), work.Input.Grid.Dimensions, ranks);
  if (work.HasLabels)
  {
    work.NumberLabels(ranks);
  }
}

void vtkRUCParticlesFromImage::FitSpheres(
  ImageParticles& work, RankCommunicator& ranks, ProgressReport& report) const
{
  const auto labels = static_cast<std::int32_t>(work.Labels.size());
  std::vector<ruc::Ball> starts;
  if (work.HasLabels)
  {
    work.Shapes = ruc::MeasureShapes(work.Number, labels, work.Edges, ranks);
    for (const ruc::ParticleShape& shape : work.Shapes)
    {
      starts.push_back({ shape.Centre, shape.EqualVolumeRadius() });
    }
    Require(!starts.empty(), "ImageArray", "labels above 0", "none");
    Require(!ranks.All(std::find(work.Slab.Values.begin(), work.Slab.Values.end(), 0.0f) ==
              work.Slab.Values.end()),
      "Sphere Fit", "voxels of matrix, with the label 0",
      "none; Watershed takes labels as they are");
  }
  work.Found = ruc::FindSpheres(work.Slab, this->MakeSearch(work), starts, ranks,
    [&](double done, const std::string& what)
    { return ranks.Rank() != 0 || report.Update(FitShare * done, what); });
}

void vtkRUCParticlesFromImage::CutImage(
  ImageParticles& work, RankCommunicator& ranks, ProgressReport& report) const
{
  const ruc::ParticleSearch search = this->MakeCut(work);
  if (work.HasLabels)
  {
    work.TakeCut(ruc::TakeLabels(std::exchange(work.Number, {}),
      static_cast<std::int32_t>(work.Labels.size()), search, ranks));
    return;
  }
  work.TakeCut(ruc::CutImage(std::exchange(work.Slab, {}), search, ranks,
    [&](double done, const std::string& what)
    { return ranks.Rank() != 0 || report.Update(done, what); }));
}

void vtkRUCParticlesFromImage::FindParticles(ImageParticles& work, RankCommunicator& ranks)
{
  ProgressReport report(this, this->GetLabel());
  if (this->Method == WATERSHED)
  {
    this->CutImage(work, ranks, report);
  }
  else
  {
    this->FitSpheres(work, ranks, report);
  }
  Require(!work.Found.Balls.empty(), "Input", "an image of particles",
    work.Found.Stopped ? "a stop before any was found" : "none that is kept");
  if (!work.AreCut)
  {
    const bool fitted = !work.Found.Stopped; // what a stopped fit has is measured to the end
    const auto goOn = [&](double done)
    {
      const double share = FitShare + (1.0 - FitShare) * done;
      const bool yes = ranks.Rank() != 0 || report.Update(share, "measuring particles");
      work.Found.Stopped = !ranks.All(yes) || work.Found.Stopped;
      return !fitted || !work.Found.Stopped;
    };
    work.FindShapes(goOn, ranks);
  }
}

void vtkRUCParticlesFromImage::Warn(const ImageParticles& work)
{
  const double noise = work.Found.Levels.Noise / work.Found.Model.Contrast;
  if (!work.Found.Binary && noise > 0.5)
  {
    vtkWarningMacro(<< "the noise is " << noise
                    << " of what particles and matrix differ by; above 0.5 particles are missed.");
  }
  const auto small = std::count_if(work.Found.Balls.begin(), work.Found.Balls.end(),
    [](const ruc::FittedBall& ball) { return 2.0 * ball.At.Radius < SmallDiameter; });
  if (small > 0)
  {
    vtkWarningMacro(<< small << " of " << work.Found.Balls.size()
                    << " particles have diameters below " << SmallDiameter
                    << " voxels, of which some are missed.");
  }
  if (work.Found.Stopped)
  {
    vtkWarningMacro(<< (work.AreMeasured ? "stopped; the particles are as the fit had them so far."
                                         : "stopped before the particles were measured: "
                                           "EqualVolumeRadius and Sphericity are NaN, and outputs "
                                           "1 and 3 have no array."));
  }
}

void vtkRUCParticlesFromImage::FillImages(
  ImageParticles& work, vtkInformationVector* outputs, RankCommunicator& ranks) const
{
  const auto prepare = [&](int port, ruc::VoxelBlock& block)
  {
    vtkImageData* image = vtkImageData::GetData(outputs, port);
    VoxelOutput::Announce(work.Input.Grid, work.OfPoints, outputs->GetInformationObject(port));
    block = VoxelOutput::FindPiece(work.Input.Grid, work.OfPoints, ranks);
    VoxelOutput::SetPiece(image, work.Input.Grid, work.OfPoints, ranks);
    return VoxelOutput::VoxelsOf(image, work.OfPoints);
  };
  ruc::VoxelBlock block;
  vtkDataSetAttributes* voxels = prepare(IDS, block);
  if (!work.AreMeasured)
  {
    prepare(RESIDUAL, block);
    return;
  }
  const std::vector<std::int32_t> numbers =
    ruc::TakeBlock(std::exchange(work.Number, {}), block, ranks);
  int* ids =
    VoxelOutput::Add<vtkIntArray>(voxels, static_cast<vtkIdType>(numbers.size()), "ParticleId");
  std::transform(numbers.begin(), numbers.end(), ids,
    [&](std::int32_t number)
    { return number > 0 ? static_cast<int>(work.Ids[number - 1]) : number; });

  voxels = prepare(RESIDUAL, block);
  if (this->Residual && !work.AreCut)
  {
    const std::vector<float> left = ruc::TakeBlock(std::exchange(work.Slab, {}), block, ranks);
    const float sign = this->ParticlesAre == DARK && !work.HasLabels ? -1.0f : 1.0f;
    std::transform(left.begin(), left.end(),
      VoxelOutput::Add<vtkFloatArray>(voxels, static_cast<vtkIdType>(left.size()), "Residual"),
      [sign](float value) { return sign * value; });
  }
}

void vtkRUCParticlesFromImage::AddSummary(
  const ImageParticles& work, const std::string& unit, vtkDataObject* data) const
{
  const ruc::FoundSpheres& found = work.Found;
  const ruc::Window window = work.FindWindow();
  PackData::AddWindow(data, window);
  PackData::AddOrigin(data, { window, "Image", unit, {} });
  const double sign = this->ParticlesAre == DARK && !work.HasLabels ? -1.0 : 1.0;
  double diameters = 0.0;
  for (const ruc::FittedBall& ball : found.Balls)
  {
    diameters += 2.0 * ball.At.Radius;
  }
  const auto add = [&](const char* name, double value)
  { PackData::AddField(data, name, std::vector<double>{ value }); };
  const ruc::Vector3& edges = work.Input.Grid.Spacing;
  PackData::AddField(data, "VoxelSize", std::vector<double>(edges.begin(), edges.end()));
  add("MatrixValue", sign * found.Model.Matrix);
  add("ParticleValue", sign * (found.Model.Matrix + found.Model.Contrast));
  add("Threshold", sign * found.Threshold);
  if (!work.AreCut)
  {
    add("Blur", work.Edge * found.Model.Blur);
  }
  add("Noise", found.Levels.Noise / found.Model.Contrast);
  add("VoxelsPerDiameter", diameters / static_cast<double>(found.Balls.size()));
  if (!work.AreCut)
  {
    PackData::AddField(data, "Sweeps", std::vector<long long>{ found.Sweeps });
  }
  PackData::AddField(data, "Stopped", std::vector<long long>{ found.Stopped });
}

void vtkRUCParticlesFromImage::Execute(
  vtkInformationVector** inputs, vtkInformationVector* outputs, RankCommunicator& ranks)
{
  this->ValidateProperties();
  RequireOne(inputs[0], "Input", "image");
  vtkImageData* input = vtkImageData::GetData(inputs[0]);
  ImageParticles work;
  work.Input = LabelInput::FindImage(input, this->ImageArray, "Input", ranks);
  RequireCubes(work.Input.Grid);
  this->RequireMemory(this->EstimateOf(work.Input.Grid, ranks.Size()).MegabytesOfRank, ranks);
  work.Edge = MeanEdge(work.Input.Grid);
  for (int q = 0; q < 3; ++q)
  {
    work.Edges[q] = work.Input.Grid.Spacing[q] / work.Edge;
  }
  work.HasLabels = this->HasLabels(work.Input, ranks);
  work.OfPoints = !ranks.All(!work.Input.Piece.OfPoints);
  this->ReadImage(work, ranks);
  this->FindParticles(work, ranks);
  if (ranks.Rank() == 0)
  {
    this->Warn(work);
    work.FillPack(vtkPolyData::GetData(outputs, PACK));
    work.FillDropped(vtkPolyData::GetData(outputs, DROPPED));
  }
  this->FillImages(work, outputs, ranks);
  const std::string unit =
    this->LengthUnit.empty() ? PackData::FindLengthUnit(input, ranks) : this->LengthUnit;
  OutputSummary::ForEachOutput(
    outputs, [&](vtkDataObject* data) { this->AddSummary(work, unit, data); });
}

ruc::Estimate vtkRUCParticlesFromImage::EstimateOf(const ruc::VoxelGrid& grid, int ranks) const
{
  return this->Method == WATERSHED ? ruc::EstimateCut(grid.Dimensions, ranks)
                                   : ruc::EstimateSpheres(grid.Dimensions, ranks);
}

std::optional<ruc::Estimate> vtkRUCParticlesFromImage::MakeEstimate()
{
  this->ValidateProperties();
  ruc::VoxelGrid grid = LabelInput::FindGridHere(*this);
  if (grid.Voxels() == 0.0 || grid.VoxelVolume() == 0.0)
  {
    return {};
  }
  if (this->VoxelsInInput > 0)
  {
    grid.Dimensions.fill(
      static_cast<int>(std::ceil(std::cbrt(static_cast<double>(this->VoxelsInInput)))));
  }
  const RankCommunicator ranks(this->GetController());
  ruc::Estimate estimate = this->EstimateOf(grid, ranks.Size());
  if (this->MinimumDiameter == 0.0)
  {
    estimate.Automatic = Text("Minimum Diameter ", DiameterOfParticle * MeanEdge(grid));
  }
  return estimate;
}

void vtkRUCParticlesFromImage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "MarkerHeight: " << this->MarkerHeight << "\n";
  os << indent << "ImageArray: " << this->ImageArray << "\n";
  os << indent << "ImageKind: " << this->ImageKind << "\n";
  os << indent << "ParticlesAre: " << this->ParticlesAre << "\n";
  os << indent << "Threshold: " << this->Threshold << "\n";
  os << indent << "Smoothing: " << this->Smoothing << "\n";
  os << indent << "MinimumDiameter: " << this->MinimumDiameter << "\n";
  os << indent << "MatrixValue: " << this->MatrixValue << "\n";
  os << indent << "ParticleValue: " << this->ParticleValue << "\n";
  os << indent << "OverlapTolerance: " << this->OverlapTolerance << "\n";
  os << indent << "BorderParticles: " << this->BorderParticles << "\n";
  os << indent << "LengthUnit: " << this->LengthUnit << "\n";
  os << indent << "Residual: " << this->Residual << "\n";
  os << indent << "VoxelsInInput: " << this->VoxelsInInput << "\n";
}
