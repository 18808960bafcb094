// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCOnePointProbability.h"

#include "PackData.h"
#include "RankCommunicator.h"
#include "Reconstruction/OverlapRemoval.h"
#include "Statistics/OnePointProbability.h"
#include "Text.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

#include <stdexcept>

vtkStandardNewMacro(vtkRUCOnePointProbability);

int vtkRUCOnePointProbability::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkTable");
  return 1;
}

void vtkRUCOnePointProbability::Execute(
  vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks)
{
  if (this->Method != SPHERE_VOLUMES)
  {
    throw std::invalid_argument(ruc::Text("Method requires the value 0, got ", this->Method, "."));
  }
  const PackData::SharedPack pack =
    PackData::FindShare(input, this->GetWindowProperties(), true, ranks);
  const std::vector<double> fractions = ruc::OnePointProbability(pack.Share);
  vtkTable* table = vtkTable::GetData(outputs, 0);
  if (ranks.Rank() == 0)
  {
    std::vector<std::string> phases;
    for (std::size_t r = 1; r < fractions.size(); ++r)
    {
      phases.push_back(std::to_string(r));
    }
    phases.push_back("m");
    PackData::AddColumn(table, "Phase", phases);
    PackData::AddColumn(table, "VolumeFraction", fractions);
    PackData::AddColumn(table, "VolumeFraction_error", std::vector<double>(fractions.size(), 0.0));
  }
  PackData::AddField(table, "Method", std::string("Sphere Volumes"));
  const double overlap = ruc::MeasureOverlap(pack.Share, ranks).Percent;
  PackData::AddPackSummary(table, pack, pack.Share.NumberOfSpheres, fractions, overlap);
  if (ranks.Rank() == 0 && overlap > PackData::TolerableOverlap)
  {
    vtkWarningMacro(<< this->GetLabel() << PackData::OverlapWarning(overlap));
  }
}

void vtkRUCOnePointProbability::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n";
}
