// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCSpherePackReader.h"

#include "PackData.h"
#include "PackFiles.h"
#include "RankCommunicator.h"
#include "ruc/Base/Text.h"
#include "ruc/Formats/GzipBytes.h"
#include "ruc/Particles/FoundWindow.h"
#include "ruc/Particles/PackOverview.h"
#include "ruc/Particles/SeamOverlap.h"

#include "vtkDataObject.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationExecutivePortKey.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <exception>
#include <limits>
#include <optional>

vtkStandardNewMacro(vtkRUCSpherePackReader);
vtkCxxSetObjectMacro(vtkRUCSpherePackReader, Controller, vtkMultiProcessController);

vtkRUCSpherePackReader::vtkRUCSpherePackReader()
  : Files(std::make_unique<PackFiles>())
{
  this->SetNumberOfInputPorts(0);
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkRUCSpherePackReader::~vtkRUCSpherePackReader()
{
  this->SetController(nullptr);
}

int vtkRUCSpherePackReader::CanReadFile(const char* fileName)
{
  try
  {
    return fileName && ruc::FindFormat(*ruc::Unpack(RegularFile::Open(fileName))) ? 1 : 0;
  }
  catch (const std::exception&)
  {
    return 0;
  }
}

ruc::ReadSettings vtkRUCSpherePackReader::GetReadSettings() const
{
  ruc::ReadSettings settings;
  settings.Columns = this->Columns;
  settings.RadiusColumn = this->RadiusColumn;
  settings.RadiusIsDiameter = this->RadiusIsDiameter;
  settings.SkipLines = this->SkipLines;
  return settings;
}

ruc::PackSettings vtkRUCSpherePackReader::GetPackSettings() const
{
  ruc::PackSettings settings;
  settings.Scale = this->Scale;
  settings.UniformRadius = this->UniformRadius;
  settings.RadiusByType = this->RadiusByType;
  const std::array<bool, 3> periodic = { this->BoxPeriodic[0] != 0, this->BoxPeriodic[1] != 0,
    this->BoxPeriodic[2] != 0 };
  if (this->BoxSize[0] != 0.0 || this->BoxSize[1] != 0.0 || this->BoxSize[2] != 0.0)
  {
    settings.Observed =
      ruc::Window::MakeBox({ this->BoxOrigin[0], this->BoxOrigin[1], this->BoxOrigin[2] },
        { this->BoxSize[0], this->BoxSize[1], this->BoxSize[2] }, periodic);
  }
  else if (periodic != std::array<bool, 3>{})
  {
    settings.Periodic = periodic;
  }
  return settings;
}

int vtkRUCSpherePackReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* info = outputs->GetInformationObject(0);
  // vtkFileSeriesReader also asks when it changes files before data are made, with information that
  // it throws away, and only on ranks that need data
  if (!vtkExecutive::PRODUCER()->Has(info))
  {
    return 1;
  }
  RankCommunicator ranks(this->Controller);
  std::vector<double> times;
  if (ranks.Rank() == 0)
  {
    try
    {
      times = this->Files->Find(this->FileName, this->Format, this->GetReadSettings()).Times();
    }
    catch (const std::exception&) // RequestData tells of it
    {
    }
  }
  ranks.Broadcast(times, 0);
  info->Remove(Pipeline::TIME_STEPS());
  info->Remove(Pipeline::TIME_RANGE());
  if (!times.empty())
  {
    const double range[2] = { times.front(), times.back() };
    info->Set(Pipeline::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
    info->Set(Pipeline::TIME_RANGE(), range, 2);
  }
  return 1;
}

int vtkRUCSpherePackReader::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  // Filters of this plugin ask for no ghosts, and ParaView, on several ranks, for one level. As a
  // pack has none, data made for the one serve the other, and no frame is read twice.
  vtkInformation* info = outputs->GetInformationObject(0);
  const auto levels = vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS();
  info->Set(levels, std::max(1, info->Get(levels)));
  return 1;
}

int vtkRUCSpherePackReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  vtkInformation* info = outputs->GetInformationObject(0);
  output->Initialize();
  this->Summary.clear();
  try
  {
    this->Read(info->Has(Pipeline::UPDATE_TIME_STEP()) ? info->Get(Pipeline::UPDATE_TIME_STEP())
                                                       : std::numeric_limits<double>::lowest(),
      output);
  }
  catch (const std::exception& e) // also where there is not enough memory
  {
    const std::string refusal = ruc::Text("FileName '", this->FileName, "': ", e.what());
    output->Initialize();
    PackData::AddField(
      output, PackData::RefusalField, this->GetObjectDescription() + ", " + refusal);
    vtkErrorMacro(<< refusal);
  }
  // The request does not fail: the other ranks, which read nothing, would wait for this one in the
  // filters downstream.
  return 1;
}

void vtkRUCSpherePackReader::Read(double time, vtkPolyData* output)
{
  const ruc::ReadSettings settings = this->GetReadSettings();
  const PackFile& file = this->Files->Find(this->FileName, this->Format, settings);
  const std::size_t n = file.FrameAt(time);
  const ruc::FramePack read =
    ruc::MakePack(this->Files->Read(this->FileName, n, settings), this->GetPackSettings());
  this->Warn(read.Warnings);
  this->WarnOfUnused(read);
  const ruc::FoundWindow window = this->TakeWindow(read);
  this->FillOutput(read, window, output);
  const std::vector<double> times = file.Times();
  if (!times.empty())
  {
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), times[n]);
  }
  const std::size_t frames = file.Frames.size();
  this->Describe(read, window,
    ruc::Text(frames > 1 ? ruc::Text(", frame ", n + 1, " of ", frames) : "",
      times.empty() ? "" : ruc::Text(" at time ", times[n])));
}

void vtkRUCSpherePackReader::WarnOfUnused(const ruc::FramePack& read)
{
  std::vector<std::string> warnings;
  if (read.Format != "table" &&
    (!this->Columns.empty() || !this->RadiusColumn.empty() || this->RadiusIsDiameter ||
      this->SkipLines > 0))
  {
    warnings.push_back(ruc::Text("Columns, RadiusColumn, RadiusIsDiameter and SkipLines are for "
                                 "tables and are not used, as the file is a ",
      read.Format, "."));
  }
  const ruc::WindowChoices choices{ this->WindowErosion, this->FaceKinds };
  if ((read.BoxIsWindow || !this->FindWindow) && !choices.AreAutomatic())
  {
    warnings.push_back(ruc::TellUnused(choices, read.BoxIsWindow));
  }
  if (!this->LengthUnit.empty() && this->Scale == 1.0 && !read.LengthUnit.empty() &&
    this->LengthUnit != read.LengthUnit)
  {
    warnings.push_back(
      ruc::Text("LengthUnit '", this->LengthUnit, "' stands in place of the file's '",
        read.LengthUnit, "', and no length is converted: Scale does that."));
  }
  this->Warn(warnings);
}

ruc::FoundWindow vtkRUCSpherePackReader::TakeWindow(const ruc::FramePack& read)
{
  const ruc::WindowChoices choices{ this->WindowErosion, this->FaceKinds };
  ruc::CheckChoices(choices);
  ruc::FoundWindow window;
  if (read.BoxIsWindow)
  {
    window.Observed = read.Box;
    window.Source = this->GetPackSettings().Observed ? "Properties" : "File";
  }
  else if (this->FindWindow)
  {
    ruc::Communicator alone;
    window = ruc::FindWindow(read.Pack, read.Box, choices, alone);
  }
  if (read.Box && ruc::OverlapsAcrossSeams(read.Pack, *read.Box))
  {
    window.Warnings.push_back("spheres overlap across the box: is it periodic?");
  }
  this->Warn(window.Warnings);
  return window;
}

void vtkRUCSpherePackReader::FillOutput(
  const ruc::FramePack& read, const ruc::FoundWindow& window, vtkPolyData* output) const
{
  PackData::FillPolyData(read.Pack, output);
  if (!read.Type.empty())
  {
    vtkNew<vtkIntArray> type;
    type->SetName("Type");
    type->SetNumberOfValues(static_cast<vtkIdType>(read.Type.size()));
    std::copy(read.Type.begin(), read.Type.end(), type->GetPointer(0));
    output->GetPointData()->AddArray(type);
  }
  if (!read.TypeNames.empty())
  {
    PackData::AddField(output, "TypeNames", read.TypeNames);
  }
  PackData::AddFoundWindow(output, window);
  if (read.Box)
  {
    PackData::AddField(
      output, "NumberOfGhosts", std::vector<long long>{ static_cast<long long>(read.Ghosts) });
  }
  if (read.Time)
  {
    PackData::AddField(output, "TimeValue", std::vector<double>{ *read.Time });
  }
  PackData::AddField(output, "LengthUnit", this->UnitOf(read));
}

std::string vtkRUCSpherePackReader::UnitOf(const ruc::FramePack& read) const
{
  return !this->LengthUnit.empty() ? this->LengthUnit
    : this->Scale == 1.0           ? read.LengthUnit
                                   : std::string();
}

void vtkRUCSpherePackReader::Describe(
  const ruc::FramePack& read, const ruc::FoundWindow& window, const std::string& place)
{
  const std::string source = window.Source == "Properties" ? "Box Size"
    : window.Source == "File"                              ? "the file"
                              : ruc::Text("its faces (", window.Faces, ")");
  const ruc::SpherePack inside =
    window.Outside > 0 ? ruc::CropToWindow(read.Pack, *window.Observed) : ruc::SpherePack();
  const ruc::PackOverview overview(
    window.Outside > 0 ? inside : read.Pack, window.Observed, source, this->UnitOf(read));
  this->Summary = ruc::Text(read.Format, place, ": ", overview.Text);
  if (window.Erosion > 0.0)
  {
    this->Summary += ruc::Text(
      " The window stays ", window.Erosion, " largest diameters away from faces that cut no pack.");
  }
  if (window.Outside > 0)
  {
    this->Summary += ruc::Text(" ", window.Outside, " spheres outside it do not count.");
  }
  if (read.Box && !read.BoxIsWindow)
  {
    this->Summary +=
      " The " + read.Box->Describe() + " of the file is not periodic along all axes.";
  }
  vtkLog(INFO, << this->GetObjectDescription() << ": " << this->Summary);
  this->Warn(overview.Warnings);
}

void vtkRUCSpherePackReader::Warn(const std::vector<std::string>& warnings)
{
  if (this->WarnedAt != this->GetMTime())
  {
    this->WarnedAt = this->GetMTime();
    this->Warned.clear();
  }
  for (const std::string& warning : warnings)
  {
    if (this->Warned.insert(warning).second)
    {
      vtkWarningMacro(<< warning);
    }
  }
}

void vtkRUCSpherePackReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
  os << indent << "Format: " << this->Format << "\n";
  os << indent << "Columns: " << this->Columns << "\n";
  os << indent << "RadiusColumn: " << this->RadiusColumn << "\n";
  os << indent << "RadiusIsDiameter: " << this->RadiusIsDiameter << "\n";
  os << indent << "UniformRadius: " << this->UniformRadius << "\n";
  os << indent << "RadiusByType: " << this->RadiusByType << "\n";
  os << indent << "Scale: " << this->Scale << "\n";
  os << indent << "SkipLines: " << this->SkipLines << "\n";
  os << indent << "LengthUnit: " << this->LengthUnit << "\n";
  os << indent << "BoxOrigin: " << this->BoxOrigin[0] << " " << this->BoxOrigin[1] << " "
     << this->BoxOrigin[2] << "\n";
  os << indent << "BoxSize: " << this->BoxSize[0] << " " << this->BoxSize[1] << " "
     << this->BoxSize[2] << "\n";
  os << indent << "BoxPeriodic: " << this->BoxPeriodic[0] << " " << this->BoxPeriodic[1] << " "
     << this->BoxPeriodic[2] << "\n";
  os << indent << "FindWindow: " << this->FindWindow << "\n";
  os << indent << "WindowErosion: " << this->WindowErosion << "\n";
  os << indent << "FaceKinds: " << this->FaceKinds << "\n";
}
