// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCPeriodicMesh.h"

#include "MeshOutputs.h"
#include "OutputSummary.h"
#include "PackData.h"
#include "RankCommunicator.h"
#include "ruc/Base/Range.h"
#include "ruc/Images/LabelImage.h"
#include "ruc/Meshing/PeriodicMesh.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <vector>

vtkStandardNewMacro(vtkRUCPeriodicMesh);

namespace
{
// What all ranks tell of the mesh that rank 0 has
struct MeshSummary
{
  ruc::Vector3 Shift{};
  double Margin = 0.0, ElementSize = 0.0, LeastGap = 0.0;
  std::int64_t NarrowGaps = 0;
  std::vector<double> Fractions; // of the phases 1 to N and of the matrix

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(
      self.Shift, self.Margin, self.ElementSize, self.LeastGap, self.NarrowGaps, self.Fractions);
  }
};

// Modes 1 for a pack without any, and Ids from 1 on
MeshOutputs::PlacedMesh LabelSpheres(const ruc::SpherePack& pack, RankCommunicator& ranks)
{
  MeshOutputs::PlacedMesh mesh;
  mesh.Mode = pack.Mode.empty() ? std::vector<int>(pack.Size(), 1) : pack.Mode;
  mesh.Id = pack.Id;
  const std::int64_t raise = ruc::FindRaise(pack, ranks);
  for (std::int64_t& id : mesh.Id)
  {
    id += raise;
  }
  return mesh;
}

// The fractions of the phases by the volumes of their parts; what is left is the matrix
template <class PhaseOf, class VolumeOf>
std::vector<double> FractionsOf(
  std::size_t parts, int phases, double box, PhaseOf&& phaseOf, VolumeOf&& volumeOf)
{
  std::vector<double> fractions(static_cast<std::size_t>(phases) + 1, 0.0);
  for (std::size_t part = 0; part < parts; ++part)
  {
    if (const int phase = phaseOf(part); phase > 0)
    {
      fractions[phase - 1] += volumeOf(part) / box;
    }
  }
  fractions.back() = 1.0 - std::accumulate(fractions.begin(), fractions.end() - 1, 0.0);
  return fractions;
}

MeshSummary Summarise(const MeshOutputs::PlacedMesh& placed, int phases, double box)
{
  const ruc::PeriodicMesh& mesh = placed.Mesh;
  MeshSummary summary;
  summary.Shift = mesh.Shift;
  summary.Margin = mesh.Margin;
  summary.ElementSize = mesh.ElementSize;
  summary.LeastGap = mesh.Gaps.Least;
  summary.NarrowGaps = mesh.Gaps.Narrow;
  summary.Fractions = FractionsOf(
    mesh.Cells.size(), phases, box,
    [&](std::size_t cell)
    { return mesh.Particle[cell] < 0 ? 0 : placed.Mode[mesh.Particle[cell]]; },
    [&](std::size_t cell) { return mesh.VolumeOf(cell); });
  return summary;
}

void FillOutputs(const MeshOutputs::PlacedMesh& mesh, double volume, vtkInformationVector* outputs)
{
  using Port = vtkRUCPeriodicMesh;
  const std::array<ruc::MeshQuality, 2> quality = ruc::MeasureQuality(mesh.Mesh);
  MeshOutputs::FillTetrahedra(mesh, vtkUnstructuredGrid::GetData(outputs, Port::TETRAHEDRA));
  MeshOutputs::FillSurfaces(mesh, vtkPolyData::GetData(outputs, Port::SURFACES));
  MeshOutputs::FillAngles(quality, vtkTable::GetData(outputs, Port::ANGLES));
  MeshOutputs::FillQuality(quality, volume, vtkTable::GetData(outputs, Port::QUALITY));
}

void AddSummary(const MeshSummary& summary, vtkDataObject* data)
{
  PackData::AddField(
    data, "OriginShift", std::vector<double>(summary.Shift.begin(), summary.Shift.end()));
  PackData::AddField(data, "OriginMargin", std::vector<double>{ summary.Margin });
  PackData::AddField(data, "ElementSize", std::vector<double>{ summary.ElementSize });
  PackData::AddField(data, "LeastGap", std::vector<double>{ summary.LeastGap });
  PackData::AddField(
    data, "NarrowGaps", std::vector<long long>{ static_cast<long long>(summary.NarrowGaps) });
  PackData::AddField(data, "MeshFractions", summary.Fractions);
}
}

vtkRUCPeriodicMesh::vtkRUCPeriodicMesh()
{
  this->SetNumberOfOutputPorts(4);
}

int vtkRUCPeriodicMesh::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(),
    port == TETRAHEDRA   ? "vtkUnstructuredGrid"
      : port == SURFACES ? "vtkPolyData"
                         : "vtkTable");
  return 1;
}

ruc::MeshSettings vtkRUCPeriodicMesh::MakeSettings() const
{
  ruc::Range::AtLeast(0.0).Check("ElementSize", this->ElementSize);
  ruc::Range::AtLeast(0.0).Check("LeastGap", this->LeastGap);
  ruc::Range::From(0.0, 1000.0).Check("ImprovementRounds", this->ImprovementRounds);
  ruc::Range::AtLeast(0.0).Check("Seed", this->Seed);
  ruc::MeshSettings settings;
  settings.ElementSize = this->ElementSize;
  settings.ContactRings = this->ContactRings;
  settings.ShiftOrigin = this->ShiftOrigin;
  settings.ImprovementRounds = this->ImprovementRounds;
  settings.LeastGap = this->LeastGap;
  settings.Seed = static_cast<std::uint32_t>(this->Seed);
  return settings;
}

void vtkRUCPeriodicMesh::Execute(
  vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks)
{
  const ruc::MeshSettings settings = this->MakeSettings();
  const PackData::ObservedPack observed =
    this->GatherPack(input, PackData::HasArray(input, "Mode", ranks), ranks);
  const ruc::SpherePack& pack = observed.Pack;
  const ruc::Window& box = observed.Observed;
  MeshOutputs::PlacedMesh mesh = LabelSpheres(pack, ranks);
  const int phases = *std::max_element(mesh.Mode.begin(), mesh.Mode.end());
  MeshSummary summary;
  ranks.Agree(
    [&]
    {
      if (ranks.Rank() == 0)
      {
        mesh.Mesh = ruc::MakePeriodicMesh(pack, box, settings);
        summary = Summarise(mesh, phases, box.Volume());
      }
    });
  ranks.Broadcast(summary, 0);
  for (int axis = 0; axis < 3; ++axis)
  {
    mesh.Origin[axis] = box.Origin[axis] + summary.Shift[axis];
  }
  if (ranks.Rank() == 0)
  {
    FillOutputs(mesh, box.Volume(), outputs);
  }
  PackData::PackOrigin origin = observed;
  origin.Observed = ruc::Window::MakeBox(mesh.Origin, box.Size, box.Periodic);
  const std::vector<double> fractions = FractionsOf(
    pack.Size(), phases, box.Volume(), [&](std::size_t i) { return mesh.Mode[i]; },
    [&](std::size_t i) { return 4.0 / 3.0 * ruc::Pi * std::pow(pack.Radius[i], 3); });
  OutputSummary::ForEachOutput(outputs,
    [&](vtkDataObject* data)
    {
      PackData::AddPackSummary(
        data, origin, static_cast<std::int64_t>(pack.Size()), fractions, 0.0);
      AddSummary(summary, data);
    });
}

std::optional<ruc::Estimate> vtkRUCPeriodicMesh::MakeEstimate()
{
  const ruc::MeshSettings settings = this->MakeSettings();
  const std::optional<ruc::PackFigures> pack = this->FindFigures();
  if (!pack)
  {
    return {};
  }
  const ruc::Estimate mesh = ruc::EstimatePeriodicMesh(*pack, settings);
  ruc::Estimate estimate = ruc::EstimatePack(*pack);
  estimate += mesh;
  estimate.Automatic = mesh.Automatic;
  return estimate;
}

void vtkRUCPeriodicMesh::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ElementSize: " << this->ElementSize << "\n";
  os << indent << "ContactRings: " << this->ContactRings << "\n";
  os << indent << "ShiftOrigin: " << this->ShiftOrigin << "\n";
  os << indent << "ImprovementRounds: " << this->ImprovementRounds << "\n";
  os << indent << "LeastGap: " << this->LeastGap << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
