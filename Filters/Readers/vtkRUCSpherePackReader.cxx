// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCSpherePackReader.h"

#include "PackData.h"
#include "RegularFile.h"
#include "ruc/Base/Text.h"
#include "ruc/Formats/SpherePackText.h"
#include "ruc/Particles/PackOverview.h"
#include "ruc/Particles/PeriodicReplicas.h"

#include "vtkInformationVector.h"
#include "vtkLogger.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <exception>
#include <optional>
#include <stdexcept>

vtkStandardNewMacro(vtkRUCSpherePackReader);

vtkRUCSpherePackReader::vtkRUCSpherePackReader()
{
  this->SetNumberOfInputPorts(0);
}

int vtkRUCSpherePackReader::CanReadFile(const char* fileName)
{
  return fileName && RegularFile::IsReadable(fileName) ? 1 : 0;
}

int vtkRUCSpherePackReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->Initialize();
  this->Summary.clear();
  try
  {
    this->Read(output);
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

void vtkRUCSpherePackReader::Read(vtkPolyData* output)
{
  const std::string text = RegularFile::Read(this->FileName);
  ruc::SpherePackTextSettings settings;
  settings.SkipLines = this->SkipLines;
  settings.RadiusColumn = this->RadiusColumn;
  settings.RadiusIsDiameter = this->RadiusIsDiameter;
  settings.Scale = this->Scale;
  ruc::SpherePackText spheres = ruc::ParseSpherePack(text, settings);
  for (const std::string& column : spheres.LeftOut)
  {
    vtkWarningMacro(<< column);
  }
  std::optional<ruc::Window> window;
  if (this->BoxSize[0] != 0.0 || this->BoxSize[1] != 0.0 || this->BoxSize[2] != 0.0)
  {
    window = ruc::Window::MakeBox({ this->BoxOrigin[0], this->BoxOrigin[1], this->BoxOrigin[2] },
      { this->BoxSize[0], this->BoxSize[1], this->BoxSize[2] },
      { this->BoxPeriodic[0] != 0, this->BoxPeriodic[1] != 0, this->BoxPeriodic[2] != 0 });
    this->PutIntoBox(spheres, *window, output);
  }
  const ruc::PackOverview overview(spheres.Pack, window, "Box Size", this->LengthUnit);
  this->Summary = overview.Text;
  vtkLog(INFO, << this->GetObjectDescription() << ": " << this->Summary);
  for (const std::string& warning : overview.Warnings)
  {
    vtkWarningMacro(<< warning);
  }
  PackData::FillPolyData(spheres.Pack, output);
  PackData::AddField(output, "LengthUnit", this->LengthUnit);
}

void vtkRUCSpherePackReader::PutIntoBox(
  ruc::SpherePackText& spheres, const ruc::Window& window, vtkPolyData* output)
{
  const std::vector<bool> copies = ruc::FindPeriodicCopies(spheres.Pack, window);
  ruc::SpherePackText once;
  for (std::size_t i = 0; i < copies.size(); ++i)
  {
    if (!copies[i])
    {
      once.Append(spheres, i);
    }
  }
  const std::size_t ghosts = copies.size() - once.Pack.Size();
  if (ghosts > 0)
  {
    vtkWarningMacro(
      "left " << ghosts << " of " << copies.size() << " rows out as periodic copies of others.");
  }
  if (const std::int64_t moved = ruc::MoveIntoBox(once.Pack, window); moved > 0)
  {
    vtkWarningMacro(<< moved << " of " << once.Pack.Size() << " centres lay outside the "
                    << window.Describe() << " and were moved into it by whole edges.");
  }
  for (std::size_t i = 0; i < once.Pack.Size(); ++i)
  {
    if (!window.Contains(once.Pack.Centre(i)))
    {
      throw std::invalid_argument(ruc::Text("Line ", once.Line[i],
        ": BoxOrigin and BoxSize require every centre inside the box, got (", once.Pack.X[i], ", ",
        once.Pack.Y[i], ", ", once.Pack.Z[i], ") outside the ", window.Describe(), "."));
    }
  }
  spheres = std::move(once);
  PackData::AddWindow(output, window);
  PackData::AddField(
    output, "NumberOfGhosts", std::vector<long long>{ static_cast<long long>(ghosts) });
}

void vtkRUCSpherePackReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
  os << indent << "RadiusColumn: " << this->RadiusColumn << "\n";
  os << indent << "RadiusIsDiameter: " << this->RadiusIsDiameter << "\n";
  os << indent << "Scale: " << this->Scale << "\n";
  os << indent << "SkipLines: " << this->SkipLines << "\n";
  os << indent << "LengthUnit: " << this->LengthUnit << "\n";
  os << indent << "BoxOrigin: " << this->BoxOrigin[0] << " " << this->BoxOrigin[1] << " "
     << this->BoxOrigin[2] << "\n";
  os << indent << "BoxSize: " << this->BoxSize[0] << " " << this->BoxSize[1] << " "
     << this->BoxSize[2] << "\n";
  os << indent << "BoxPeriodic: " << this->BoxPeriodic[0] << " " << this->BoxPeriodic[1] << " "
     << this->BoxPeriodic[2] << "\n";
}
