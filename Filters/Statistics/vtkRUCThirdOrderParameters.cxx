// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCThirdOrderParameters.h"

#include "OutputSummary.h"
#include "PackData.h"
#include "ProgressReport.h"
#include "RankCommunicator.h"
#include "ThirdOrderTables.h"
#include "ruc/Base/Require.h"
#include "ruc/Statistics/Results/OnePointProbability.h"
#include "ruc/Statistics/ThirdOrder/ThirdOrderOfSpheres.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkRUCThirdOrderParameters);

namespace
{
constexpr std::int64_t FewCentres = 100;
constexpr double LargeRest = 0.01; // of zeta
const char* const PhaseNames[] = { "Spheres", "Modes" };
}

vtkRUCThirdOrderParameters::vtkRUCThirdOrderParameters()
{
  this->SetNumberOfOutputPorts(5);
}

int vtkRUCThirdOrderParameters::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == PACK ? "vtkPolyData" : "vtkTable");
  return 1;
}

ruc::ThirdOrderSettings vtkRUCThirdOrderParameters::MakeSettings() const
{
  ruc::Require(this->Phases == SPHERES || this->Phases == MODES, "Phases", "a value from 0 to 1",
    this->Phases);
  ruc::ThirdOrderSettings settings;
  settings.CutOff = this->CutOff;
  settings.MaximumDegree = this->MaximumDegree;
  settings.ByMode = this->Phases == MODES;
  settings.WithEta = this->Eta;
  settings.Blocks = this->Blocks;
  settings.Slabs = this->Slabs;
  return settings;
}

void vtkRUCThirdOrderParameters::Execute(
  vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks)
{
  const ruc::ThirdOrderSettings settings = this->MakeSettings();
  ProgressReport report(this, this->GetLabel());
  const PackData::SharedPack pack = this->FindShare(input, ranks);
  const ruc::ThirdOrderOfSpheres found =
    ruc::MeasureThirdOrder(pack.Share, settings, ranks, report.ForPairs(ranks));
  const double overlap = this->CheckOverlap(pack.Share, false, ranks);
  if (ranks.Rank() == 0)
  {
    ThirdOrderTables::FillParameters(found, vtkTable::GetData(outputs, PARAMETERS));
    ThirdOrderTables::FillIntegrals(found, vtkTable::GetData(outputs, INTEGRALS));
    ThirdOrderTables::FillSpectrum(found, vtkTable::GetData(outputs, SPECTRUM));
    ThirdOrderTables::FillSlabs(found, vtkTable::GetData(outputs, SLABS));
    this->Warn(found);
  }
  vtkPolyData* spheres = vtkPolyData::GetData(outputs, PACK);
  ThirdOrderTables::FillPack(pack.Share.Own, found, spheres);
  OutputSummary::ForEachOutput(outputs,
    [&](vtkDataObject* data)
    {
      this->AddSummary(found, data);
      if (data != spheres)
      {
        PackData::AddPackSummary(
          data, pack, pack.Share.NumberOfSpheres, ruc::OnePointProbability(pack.Share), overlap);
      }
    });
  // A pack for filters downstream, which take a window of its field data for one that is known
  PackData::AddField(spheres, "NumberOfSpheres",
    std::vector<long long>{ static_cast<long long>(pack.Share.NumberOfSpheres) });
  PackData::AddOrigin(spheres, pack);
  PackData::AddKnownWindow(spheres, pack);
}

void vtkRUCThirdOrderParameters::AddSummary(
  const ruc::ThirdOrderOfSpheres& found, vtkDataObject* data) const
{
  PackData::AddField(data, "Phases", std::string(PhaseNames[this->Phases]));
  PackData::AddField(data, "Method", std::string(found.Ewald ? "Ewald Sum" : "Cut-Off"));
  PackData::AddField(data, "CutOff", std::vector<double>{ found.CutOff });
  PackData::AddField(data, "MaximumDegree", std::vector<long long>{ found.MaximumDegree });
  PackData::AddField(
    data, "NumberOfCentres", std::vector<long long>{ static_cast<long long>(found.Centres) });
  PackData::AddField(data, "NumberOfBlocks", std::vector<long long>{ found.Blocks });
  PackData::AddField(data, "RestOfZeta", std::vector<double>{ found.Spectrum.back().Value });
}

void vtkRUCThirdOrderParameters::Warn(const ruc::ThirdOrderOfSpheres& found)
{
  if (found.Centres < FewCentres)
  {
    vtkWarningMacro(<< "only " << found.Centres << " spheres are centres, which lie CutOff, "
                    << found.CutOff << ", from every face that is not periodic; fewer than "
                    << FewCentres << " centres tell little of a pack.");
  }
  const double rest = found.Spectrum.back().Value / found.Spheres.Zeta.Value;
  if (rest > LargeRest)
  {
    vtkWarningMacro(<< 100.0 * rest << " % of zeta is from degrees above MaximumDegree, "
                    << found.MaximumDegree
                    << ", where only each neighbour with itself counts. Spheres of so different "
                       "sizes require more degrees.");
  }
}

std::optional<ruc::Estimate> vtkRUCThirdOrderParameters::MakeEstimate()
{
  const ruc::ThirdOrderSettings settings = this->MakeSettings();
  const std::optional<ruc::PackFigures> pack = this->FindFigures();
  if (!pack)
  {
    return {};
  }
  ruc::Estimate estimate = ruc::EstimatePack(*pack);
  estimate += ruc::EstimateThirdOrder(*pack, settings);
  estimate.Automatic = ruc::EstimateThirdOrder(*pack, settings).Automatic;
  return estimate;
}

void vtkRUCThirdOrderParameters::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Phases: " << this->Phases << "\n";
  os << indent << "CutOff: " << this->CutOff << "\n";
  os << indent << "MaximumDegree: " << this->MaximumDegree << "\n";
  os << indent << "Eta: " << this->Eta << "\n";
  os << indent << "Blocks: " << this->Blocks << "\n";
  os << indent << "Slabs: " << this->Slabs << "\n";
}
