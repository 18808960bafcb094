// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCSpherePackSource.h"

#include "CheckpointFile.h"
#include "OutputSummary.h"
#include "PackData.h"
#include "PackEstimate.h"
#include "PackWindow.h"
#include "ProgressReport.h"
#include "RankCommunicator.h"
#include "RegularFile.h"
#include "ruc/Base/Require.h"
#include "ruc/Formats/SizeTable.h"
#include "ruc/Packing/DensePackCheckpoint.h"
#include "ruc/Packing/PackOrder.h"
#include "ruc/Packing/SphereSizes.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <functional>

vtkStandardNewMacro(vtkRUCSpherePackSource);

namespace
{
enum Port
{
  PACK,
  GROWTH
};
constexpr int MostClasses = 256;
// What is asked of the distribution of sizes for estimates
constexpr int SpheresForEstimate = 2000;
// Of the distance of two spheres that touch
constexpr double ContactTolerance = 1e-5;

void SetPlace(std::vector<double>& values, int place, double value)
{
  if (place >= static_cast<int>(values.size()))
  {
    values.resize(place + 1, 0.0);
  }
  values[place] = value;
}

void FillGrowth(const ruc::DensePack& made, vtkTable* table)
{
  std::vector<double> collisions, fraction, pressure, rate;
  for (const ruc::GrowthStep& step : made.History)
  {
    collisions.push_back(step.Collisions);
    fraction.push_back(step.Fraction);
    pressure.push_back(step.ReducedPressure);
    rate.push_back(step.Rate);
  }
  PackData::AddColumn(table, "Collisions", collisions);
  PackData::AddColumn(table, "Fraction", fraction);
  PackData::AddColumn(table, "ReducedPressure", pressure);
  PackData::AddColumn(table, "Rate", rate);
}

// Throws where there is no pack of the fraction that was wanted
void RequireWhole(const ruc::DensePack& made, double fraction)
{
  if (made.Jammed && made.Pack.Empty())
  {
    throw std::invalid_argument(
      ruc::Text("Protocol Soft finds no pack without overlap at Fraction ", fraction,
        "; Events reaches denser ones."));
  }
  if (made.Jammed)
  {
    throw std::invalid_argument(ruc::Text("The spheres jam at a fraction of ", made.Fraction,
      ", below Fraction ", fraction, ". A lower Rate, Exchange or another Seed may reach more."));
  }
}
}

struct vtkRUCSpherePackSource::SizeFile
{
  std::string Name;
  RegularFile::Stamp Stamp;
  ruc::SizeTable Sizes;
};

vtkRUCSpherePackSource::vtkRUCSpherePackSource()
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(2);
}

vtkRUCSpherePackSource::~vtkRUCSpherePackSource() = default;

int vtkRUCSpherePackSource::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == PACK ? "vtkPolyData" : "vtkTable");
  return 1;
}

void vtkRUCSpherePackSource::ClearDiameters()
{
  this->Diameters.clear();
  this->Modified();
}

void vtkRUCSpherePackSource::SetDiameter(int place, double diameter)
{
  if (place < 0 || place >= MostClasses)
  {
    vtkErrorMacro(<< "Diameters has places 0 to " << MostClasses - 1 << ", got " << place);
    return;
  }
  SetPlace(this->Diameters, place, diameter);
  this->Modified();
}

void vtkRUCSpherePackSource::ClearShares()
{
  this->Shares.clear();
  this->Modified();
}

void vtkRUCSpherePackSource::SetShare(int place, double share)
{
  if (place < 0 || place >= MostClasses)
  {
    vtkErrorMacro(<< "Shares has places 0 to " << MostClasses - 1 << ", got " << place);
    return;
  }
  SetPlace(this->Shares, place, share);
  this->Modified();
}

void vtkRUCSpherePackSource::CheckProperties() const
{
  ruc::Require(this->NumberOfSpheres >= 2 && this->NumberOfSpheres <= ruc::MostPackedSpheres,
    "NumberOfSpheres", ruc::Text("2 to ", ruc::MostPackedSpheres), this->NumberOfSpheres);
  ruc::Require(this->Seed >= 0, "Seed", "a number >= 0", this->Seed);
  ruc::Require(this->Sizes >= EQUAL && this->Sizes <= FILE_OF_SIZES, "Sizes", "a value from 0 to 4",
    this->Sizes);
  ruc::Require(this->Protocol >= AUTOMATIC && this->Protocol <= EVENTS, "Protocol",
    "a value from 0 to 2", this->Protocol);
  ruc::Require(this->Exchange >= SWITCH_AUTOMATIC && this->Exchange <= SWITCH_ON, "Exchange",
    "a value from 0 to 2", this->Exchange);
  ruc::Require(this->CheckpointInterval >= 0.0, "CheckpointInterval", "a number >= 0",
    this->CheckpointInterval);
}

const ruc::SizeTable& vtkRUCSpherePackSource::ReadSizes()
{
  ruc::Require(!this->FileName.empty(), "FileName", "a file of sizes", "none");
  const RegularFile::Stamp stamp = RegularFile::FindStamp(this->FileName);
  if (!this->LastSizes || this->LastSizes->Name != this->FileName ||
    this->LastSizes->Stamp != stamp)
  {
    try
    {
      const std::string text = RegularFile::Read(this->FileName);
      ruc::MemoryBytes bytes(text);
      this->LastSizes.reset(new SizeFile{ this->FileName, stamp, ruc::ReadSizeTable(bytes) });
    }
    catch (const std::invalid_argument& fault)
    {
      throw std::invalid_argument(ruc::Text("FileName '", this->FileName, "': ", fault.what()));
    }
  }
  return this->LastSizes->Sizes;
}

ruc::SphereSizes vtkRUCSpherePackSource::MakeSizes()
{
  ruc::SphereSizes sizes;
  sizes.Law = static_cast<ruc::SizeLaw>(this->Sizes);
  sizes.Diameters = this->Diameters;
  if (this->Sizes == FILE_OF_SIZES)
  {
    const ruc::SizeTable& read = this->ReadSizes();
    sizes.Diameters = read.Diameters;
    sizes.Passing = read.Passing;
  }
  sizes.Shares = this->Shares;
  sizes.SharesAre = this->SharesByVolume ? ruc::ShareKind::Volume : ruc::ShareKind::Number;
  sizes.MeanDiameter = this->MeanDiameter;
  sizes.StandardDeviation = this->StandardDeviation;
  sizes.Cut = this->Cut;
  return sizes;
}

ruc::DensePackSettings vtkRUCSpherePackSource::MakeSettings(const std::vector<double>& radii) const
{
  ruc::DensePackSettings settings;
  settings.Radii = radii;
  settings.Fraction = this->Fraction;
  for (int q = 0; q < 3; ++q)
  {
    settings.Proportions[q] = this->BoxProportions[q];
    settings.Periodic[q] = this->Walls[q] == 0;
  }
  settings.Seed = static_cast<std::uint32_t>(this->Seed);
  settings.Protocol = static_cast<ruc::PackingProtocol>(this->Protocol);
  settings.Rate = this->Rate;
  const bool continuous = this->Sizes >= LOG_NORMAL;
  settings.Exchange =
    this->Exchange == SWITCH_ON || (this->Exchange == SWITCH_AUTOMATIC && continuous);
  settings.Equilibration = this->EquilibrationTime;
  return settings;
}

std::optional<ruc::Estimate> vtkRUCSpherePackSource::MakeEstimate()
{
  this->CheckProperties();
  const std::vector<double> radii =
    this->MakeSizes().Make(std::min(this->NumberOfSpheres, SpheresForEstimate)).Radius;
  const ruc::DensePackSettings settings = this->MakeSettings(radii);
  ruc::Estimate estimate = ruc::EstimateDensePack(settings, this->NumberOfSpheres);
  if (!this->CheckpointFile.empty())
  {
    estimate.MegabytesOfRank +=
      this->NumberOfSpheres * ruc::MostBytesOfCheckpoint / ruc::BytesOfMegabyte;
  }
  const RankCommunicator ranks(this->GetController());
  estimate.Seconds *= PackEstimate::Cores(ranks.Size()); // rank 0 does it alone
  return estimate;
}

void vtkRUCSpherePackSource::Execute(
  vtkInformationVector**, vtkInformationVector* outputs, RankCommunicator& ranks)
{
  ProgressReport report(this, this->GetLabel());
  this->CheckProperties();
  this->RequireMemory(this->GetEstimatedMemory(), ranks);
  ranks.Agree(
    [&]()
    {
      if (ranks.Rank() == 0)
      {
        this->Make(outputs, report);
      }
    });
}

ruc::DensePack vtkRUCSpherePackSource::MakeSpheres(
  const ruc::DensePackSettings& settings, ProgressReport& report)
{
  ::CheckpointFile file(this->CheckpointFile, this->CheckpointInterval);
  const std::string bytes = file.ReadHere();
  std::optional<ruc::DensePackState> last;
  if (!bytes.empty())
  {
    try
    {
      last = ruc::ReadDensePackCheckpoint(bytes, settings);
    }
    catch (const std::invalid_argument& fault)
    {
      throw std::invalid_argument(
        ruc::Text("CheckpointFile '", this->CheckpointFile, "': ", fault.what()));
    }
  }
  bool warned = false;
  const auto write = [&]()
  {
    const std::string error = file.Write(ruc::WriteCheckpoint(*last, settings));
    if (!error.empty() && !warned)
    {
      warned = true;
      vtkWarningMacro(<< "checkpoint not written, the last good one remains: " << error);
    }
  };
  const auto keep = [&](ruc::DensePackState state)
  {
    last = std::move(state);
    if (file.IsDue())
    {
      write();
    }
  };
  const std::optional<ruc::DensePackState> resume = last;
  ruc::DensePack made = ruc::MakeDensePack(
    settings,
    [&](const ruc::GrowthStep& step, double done)
    {
      return report.Update(done,
        step.Rate > 0.0 ? ruc::Text("fraction ", step.Fraction, " at rate ", step.Rate)
                        : ruc::Text("fraction ", step.Fraction));
    },
    resume ? &*resume : nullptr,
    file.IsWanted() ? std::function<void(ruc::DensePackState)>(keep) : nullptr);
  if (made.Stopped)
  {
    const bool isKept = last && file.IsWanted();
    if (isKept)
    {
      write();
    }
    const char* goesOn = isKept ? " The next run goes on from there." : "";
    if (made.Pack.Empty())
    {
      throw std::invalid_argument(ruc::Text("Stopped before there was a pack.", goesOn));
    }
    vtkWarningMacro(<< "stopped at a fraction of " << made.Fraction << ", below Fraction "
                    << this->Fraction << ": the box is larger." << goesOn);
  }
  return made;
}

void vtkRUCSpherePackSource::Make(vtkInformationVector* outputs, ProgressReport& report)
{
  const ruc::SphereSizes::Spheres spheres = this->MakeSizes().Make(this->NumberOfSpheres);
  const ruc::DensePackSettings settings = this->MakeSettings(spheres.Radius);
  ruc::DensePack made = this->MakeSpheres(settings, report);
  RequireWhole(made, this->Fraction);
  const ruc::PackOrder order = ruc::MeasureOrder(made.Pack, made.Box, ContactTolerance);
  this->RequireNoCrystal(order);
  made.Pack.Mode = spheres.Mode;
  vtkPolyData* pack = vtkPolyData::GetData(outputs, PACK);
  PackData::FillPolyData(made.Pack, pack);
  pack->GetPointData()->SetActiveScalars(this->Sizes == CLASSES ? "Mode" : "Radius");
  FillGrowth(made, vtkTable::GetData(outputs, GROWTH));
  OutputSummary::ForEachOutput(
    outputs, [&](vtkDataObject* data) { this->AddSummary(made, order, data); });
}

void vtkRUCSpherePackSource::RequireNoCrystal(const ruc::PackOrder& order)
{
  if (!order.IsCrystalline())
  {
    return;
  }
  const std::string what = ruc::Text("The spheres crystallise: Q6 is ", order.Q6,
    ", where that of a random pack is below ", ruc::PackOrder::MostQ6, ".");
  if (this->EquilibrationTime > 0.0) // after which a crystal may be what is in equilibrium
  {
    vtkWarningMacro(<< what);
    return;
  }
  throw std::invalid_argument(what + " A higher Rate, another Seed, or a range of sizes helps.");
}

void vtkRUCSpherePackSource::AddSummary(
  const ruc::DensePack& made, const ruc::PackOrder& order, vtkDataObject* data) const
{
  const auto add = [&](const char* name, double value)
  { PackData::AddField(data, name, std::vector<double>{ value }); };
  const auto count = [&](const char* name, long long value)
  { PackData::AddField(data, name, std::vector<long long>{ value }); };
  PackData::AddWindow(data, made.Box);
  if (!this->LengthUnit.empty())
  {
    PackData::AddField(data, "LengthUnit", this->LengthUnit);
  }
  count("NumberOfSpheres", static_cast<long long>(made.Pack.Size()));
  PackData::AddField(data, "Protocol", std::string(made.IsSoft ? "Soft" : "Events"));
  add("Fraction", made.Fraction);
  add("MaximumFraction", made.MaximumFraction);
  if (const std::optional<ruc::MeanPressure> pressure = ruc::FindMeanPressure(made.History))
  {
    add("ReducedPressure", pressure->Value);
    add("ReducedPressureError", pressure->Error);
  }
  else if (!made.History.empty())
  {
    add("ReducedPressure", made.History.back().ReducedPressure);
  }
  add("CoordinationNumber", order.CoordinationNumber);
  add("RattlerPercent", order.RattlerPercent);
  add("Q6", order.Q6);
  count("Seed", this->Seed);
  count("Stopped", made.Stopped);
}

void vtkRUCSpherePackSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&](const char* name, const auto& value)
  { os << indent << name << ": " << value << "\n"; };
  const auto printAll = [&](const char* name, const auto& values)
  {
    os << indent << name << ":";
    for (const auto& value : values)
    {
      os << " " << value;
    }
    os << "\n";
  };
  print("NumberOfSpheres", this->NumberOfSpheres);
  print("Fraction", this->Fraction);
  print("Seed", this->Seed);
  print("Sizes", this->Sizes);
  printAll("Diameters", this->Diameters);
  printAll("Shares", this->Shares);
  print("SharesByVolume", this->SharesByVolume);
  print("MeanDiameter", this->MeanDiameter);
  print("StandardDeviation", this->StandardDeviation);
  print("Cut", this->Cut);
  print("FileName", this->FileName);
  printAll("BoxProportions", this->BoxProportions);
  printAll("Walls", this->Walls);
  print("Protocol", this->Protocol);
  print("Rate", this->Rate);
  print("Exchange", this->Exchange);
  print("EquilibrationTime", this->EquilibrationTime);
  print("CheckpointFile", this->CheckpointFile);
  print("CheckpointInterval", this->CheckpointInterval);
  print("LengthUnit", this->LengthUnit);
}
