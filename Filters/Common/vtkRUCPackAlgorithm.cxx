// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCPackAlgorithm.h"

#include "PackData.h"
#include "PackEstimate.h"
#include "PackInput.h"
#include "RankCommunicator.h"
#include "ruc/Base/Text.h"
#include "ruc/Particles/PackOverlap.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace
{
// Returns what is wrong with a pack that cannot exist, as the end of a sentence, or an empty text
std::string DescribeImpossible(double fraction, double overlapPercent)
{
  constexpr const char* advice =
    ". If the radii are diameters, set RadiusIsDiameter of the Sphere Pack Reader; if their unit "
    "is "
    "not that of the window, Scale. For spheres that do overlap there is Chord Sampling.";
  if (fraction >= 1.0)
  {
    return ruc::Text(
      "volumes that add up to less than that of the window, got ", fraction, " of it", advice);
  }
  return overlapPercent > PackData::MostOverlap
    ? ruc::Text("an overlap of at most ", PackData::MostOverlap, " % of their volume, got ",
        overlapPercent, " %", advice)
    : std::string();
}

}

int vtkRUCPackAlgorithm::FillInputPortInformation(int, vtkInformation* info)
{
  PackInput::Accept(info);
  return 1;
}

void vtkRUCPackAlgorithm::Execute(
  vtkInformationVector** inputs, vtkInformationVector* outputs, RankCommunicator& ranks)
{
  RequireOne(inputs[0], "Input", "pack");
  const vtkSmartPointer<vtkPointSet> points =
    PackInput::Find(vtkDataObject::GetData(inputs[0]), ranks, this->TakesTables());
  std::int64_t spheres = points ? points->GetNumberOfPoints() : 0;
  ranks.Sum(&spheres, 1);
  this->SpheresFound = spheres;
  this->CheckMemory(ranks);
  this->SpheresFound = 0;
  this->Execute(points.Get(), outputs, ranks);
}

void vtkRUCPackAlgorithm::CheckMemory(RankCommunicator& ranks)
{
  double megabytes = 0.0;
  try
  {
    megabytes = this->GetMemoryToCheck();
  }
  catch (const std::exception&)
  {
    // What is wrong may be seen on this rank alone; the run says it on all of them
  }
  try
  {
    this->RequireMemory(megabytes, ranks);
  }
  catch (const std::invalid_argument&)
  {
    this->SpheresFound = 0;
    throw;
  }
}

PackData::WindowProperties vtkRUCPackAlgorithm::GetWindowProperties()
{
  PackData::WindowProperties properties;
  std::copy_n(this->BoxOrigin, 3, properties.BoxOrigin);
  std::copy_n(this->BoxSize, 3, properties.BoxSize);
  std::copy_n(this->BoxPeriodic, 3, properties.BoxPeriodic);
  std::copy_n(this->CylinderBase, 3, properties.CylinderBase);
  std::copy_n(this->CylinderAxis, 3, properties.CylinderAxis);
  properties.CylinderRadius = this->CylinderRadius;
  properties.CylinderHeight = this->CylinderHeight;
  properties.Crop = this->CropToWindow;
  return properties;
}

void vtkRUCPackAlgorithm::Warn(const PackData::PackOrigin& origin, const RankCommunicator& ranks)
{
  for (std::size_t n = 0; ranks.Rank() == 0 && n < origin.Warnings.size(); ++n)
  {
    vtkWarningMacro(<< origin.Warnings[n]);
  }
}

PackData::PackPiece vtkRUCPackAlgorithm::FindPiece(
  vtkPointSet* input, bool withModes, RankCommunicator& ranks, double leastDiameter)
{
  PackData::PackPiece pack =
    PackData::FindPiece(input, this->GetWindowProperties(), withModes, ranks, leastDiameter);
  this->Warn(pack, ranks);
  return pack;
}

PackData::SharedPack vtkRUCPackAlgorithm::FindShare(vtkPointSet* input, RankCommunicator& ranks)
{
  PackData::SharedPack pack = PackData::FindShare(input, this->GetWindowProperties(), true, ranks);
  this->Warn(pack, ranks);
  return pack;
}

PackData::ObservedPack vtkRUCPackAlgorithm::GatherPack(
  vtkPointSet* input, bool withModes, RankCommunicator& ranks)
{
  PackData::ObservedPack pack =
    PackData::GatherPack(input, this->GetWindowProperties(), withModes, ranks);
  this->Warn(pack, ranks);
  return pack;
}

PackData::SharedPack vtkRUCPackAlgorithm::FindShareEarly(
  vtkInformationVector** inputs, vtkInformationVector* outputs, RankCommunicator& ranks)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
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
  return PackData::FindShare(points, this->GetWindowProperties(), true, ranks);
}

double vtkRUCPackAlgorithm::CheckOverlap(
  const ruc::PackShare& share, bool exact, RankCommunicator& ranks)
{
  const double percent = ruc::MeasureOverlap(share, ranks).Percent;
  const double volume = std::accumulate(share.Volume.begin(), share.Volume.end(), 0.0);
  const std::string impossible = DescribeImpossible(volume / share.Observed.Volume(), percent);
  if (exact && !impossible.empty())
  {
    throw std::invalid_argument("Exact sums require spheres with " + impossible);
  }
  if (ranks.Rank() == 0 && !impossible.empty())
  {
    vtkWarningMacro(<< "a pack of spheres has " << impossible);
  }
  else if (ranks.Rank() == 0 && exact && percent > PackData::TolerableOverlap)
  {
    vtkWarningMacro(<< "the spheres overlap by " << percent
                    << " % of their volume, which counts twice; above "
                    << PackData::TolerableOverlap << " % the result is no longer exact.");
  }
  return percent;
}

void vtkRUCPackAlgorithm::WarnOfVolume(
  double volume, double ofWindow, const RankCommunicator& ranks)
{
  const std::string impossible = DescribeImpossible(volume / ofWindow, 0.0);
  if (ranks.Rank() == 0 && !impossible.empty())
  {
    vtkWarningMacro(<< "a pack of spheres has " << impossible);
  }
}

std::optional<ruc::PackFigures> vtkRUCPackAlgorithm::FindFigures()
{
  const RankCommunicator ranks(this->GetController());
  return PackEstimate::FindFigures(PackInput::FindHere(this->GetInputDataObject(0, 0)),
    this->GetWindowProperties(), static_cast<double>(this->GetKnownSpheres()), ranks.Size());
}

void vtkRUCPackAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&](const char* name, const auto& v)
  { os << indent << name << ": " << v[0] << " " << v[1] << " " << v[2] << "\n"; };
  print("BoxOrigin", this->BoxOrigin);
  print("BoxSize", this->BoxSize);
  print("BoxPeriodic", this->BoxPeriodic);
  print("CylinderBase", this->CylinderBase);
  print("CylinderAxis", this->CylinderAxis);
  os << indent << "CylinderRadius: " << this->CylinderRadius << "\n";
  os << indent << "CylinderHeight: " << this->CylinderHeight << "\n";
  os << indent << "CropToWindow: " << this->CropToWindow << "\n";
}
