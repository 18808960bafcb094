// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCParticleModes.h"

#include "PackData.h"
#include "PackEstimate.h"
#include "PackInput.h"
#include "PackPoints.h"
#include "RankCommunicator.h"
#include "ruc/Base/Require.h"
#include "ruc/Particles/ParticleModes.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>

vtkStandardNewMacro(vtkRUCParticleModes);

namespace
{
const char* const MethodNames[] = { "Equal Width", "Equal Volume", "Explicit Edges",
  "One Per Size" };

// Outputs the points of the input that have a mode and, with `crop`, lie in the window
void FillOutput(vtkPointSet* input, const ruc::ParticleModes& modes, const ruc::CheckedPiece& piece,
  bool crop, vtkPolyData* output)
{
  vtkDataArray* radius = PackData::RequireArray(input, "Radius");
  const auto modeOf = [&](vtkIdType i) { return modes.ModeOf(2.0 * radius->GetTuple1(i)); };
  vtkNew<vtkIntArray> mode;
  mode->SetName("Mode");
  for (vtkIdType i : PackPoints::Copy(
         input, piece, crop, [&](vtkIdType point) { return modeOf(point) > 0; }, output))
  {
    mode->InsertNextValue(modeOf(i));
  }
  output->GetPointData()->AddArray(mode);
  output->GetPointData()->SetActiveScalars("Mode"); // views colour by it
}

void FillTable(const ruc::ParticleModes& modes, double volume, vtkTable* table)
{
  std::vector<long long> number, count;
  std::vector<double> smallest, largest, mean, fraction;
  for (int m = 1; m <= modes.NumberOfModes(); ++m)
  {
    const ruc::ModeSummary& summary = modes.Summary(m);
    number.push_back(m);
    count.push_back(static_cast<long long>(summary.Count));
    smallest.push_back(summary.MinimumDiameter);
    largest.push_back(summary.MaximumDiameter);
    mean.push_back(summary.VolumeMeanDiameter);
    fraction.push_back(summary.Volume / volume);
  }
  PackData::AddColumn(table, "Mode", number);
  PackData::AddColumn(table, "Count", count);
  PackData::AddColumn(table, "MinimumDiameter", smallest);
  PackData::AddColumn(table, "MaximumDiameter", largest);
  PackData::AddColumn(table, "VolumeMeanDiameter", mean);
  PackData::AddColumn(table, "VolumeFraction", fraction);
}
}

vtkRUCParticleModes::vtkRUCParticleModes()
{
  this->SetNumberOfOutputPorts(2);
}

int vtkRUCParticleModes::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkTable");
  return 1;
}

void vtkRUCParticleModes::ClearEdges()
{
  this->Edges.clear();
  this->Modified();
}

void vtkRUCParticleModes::SetEdge(int i, double diameter)
{
  if (i < 0 || i > ruc::MostModes + 1)
  {
    vtkErrorMacro(<< "Edges has places 0 to " << ruc::MostModes << ", got " << i);
    return;
  }
  if (i >= this->GetNumberOfEdges())
  {
    this->Edges.resize(i + 1, 0.0);
  }
  this->Edges[i] = diameter;
  this->Modified();
}

ruc::ParticleModes vtkRUCParticleModes::FindModes(
  const std::vector<double>& radii, RankCommunicator& ranks)
{
  ruc::ModeSettings settings;
  settings.Method = static_cast<ruc::ModeMethod>(this->Method);
  settings.NumberOfModes = this->NumberOfModes;
  settings.Edges = this->Method == EXPLICIT_EDGES ? this->Edges : std::vector<double>{};
  settings.MinimumDiameter = this->MinimumDiameter;
  std::vector<double> diameters(radii.size());
  std::transform(radii.begin(), radii.end(), diameters.begin(), [](double r) { return 2.0 * r; });
  ruc::ParticleModes modes(std::move(diameters), settings, ranks);

  const int wanted = this->Method == ONE_PER_SIZE ? modes.NumberOfModes()
    : this->Method == EXPLICIT_EDGES              ? this->GetNumberOfEdges() - 1
                                                  : this->NumberOfModes;
  if (modes.NumberOfModes() < wanted && ranks.Rank() == 0)
  {
    vtkWarningMacro(<< wanted - modes.NumberOfModes() << " of " << wanted
                    << " modes would hold no sphere and are left out; the others are numbered 1 to "
                    << modes.NumberOfModes() << ".");
  }
  return modes;
}

void vtkRUCParticleModes::AddSummary(
  vtkDataObject* data, const PackData::PackOrigin& origin, const ruc::ParticleModes& modes) const
{
  long long spheres = 0;
  for (int m = 1; m <= modes.NumberOfModes(); ++m)
  {
    spheres += static_cast<long long>(modes.Summary(m).Count);
  }
  PackData::AddField(data, "Method", std::string(MethodNames[this->Method]));
  PackData::AddField(data, "NumberOfSpheres", std::vector<long long>{ spheres });
  PackData::AddOrigin(data, origin);
  PackData::AddKnownWindow(data, origin);
}

std::optional<ruc::Estimate> vtkRUCParticleModes::MakeEstimate()
{
  const RankCommunicator ranks(this->GetController());
  const std::optional<double> spheres =
    PackEstimate::FindSpheres(PackInput::FindHere(this->GetInputDataObject(0, 0)),
      static_cast<double>(this->GetKnownSpheres()), ranks.Size());
  return spheres
    ? std::optional(ruc::EstimateModes(*spheres, static_cast<ruc::ModeMethod>(this->Method)))
    : std::nullopt;
}

void vtkRUCParticleModes::Execute(
  vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks)
{
  ruc::Require(this->Method >= EQUAL_WIDTH && this->Method <= ONE_PER_SIZE, "Method",
    "a value from 0 to 3", this->Method);
  const PackData::PackPiece pack = this->FindPiece(input, false, ranks, this->MinimumDiameter);
  const ruc::ParticleModes modes = this->FindModes(pack.Piece.Spheres().Radius, ranks);

  vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
  if (input && input->GetNumberOfPoints() > 0)
  {
    FillOutput(input, modes, pack.Piece, this->GetCropToWindow(), output);
    output->GetFieldData()->PassData(input->GetFieldData());
  }
  double volume = 0.0;
  for (int m = 1; m <= modes.NumberOfModes(); ++m)
  {
    volume += modes.Summary(m).Volume;
  }
  this->WarnOfVolume(volume, pack.Observed.Volume(), ranks);
  vtkTable* table = vtkTable::GetData(outputs, 1);
  if (ranks.Rank() == 0)
  {
    FillTable(modes, pack.Observed.Volume(), table);
  }
  this->AddSummary(output, pack, modes);
  this->AddSummary(table, pack, modes);
}

void vtkRUCParticleModes::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "NumberOfModes: " << this->NumberOfModes << "\n";
  os << indent << "Edges:";
  for (double edge : this->Edges)
  {
    os << " " << edge;
  }
  os << "\n" << indent << "MinimumDiameter: " << this->MinimumDiameter << "\n";
}
