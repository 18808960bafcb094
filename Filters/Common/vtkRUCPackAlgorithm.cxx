// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCPackAlgorithm.h"

#include "PackData.h"
#include "PackEstimate.h"
#include "RankCommunicator.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <stdexcept>

int vtkRUCPackAlgorithm::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

void vtkRUCPackAlgorithm::Execute(
  vtkInformationVector** inputs, vtkInformationVector* outputs, RankCommunicator& ranks)
{
  this->Execute(vtkPointSet::GetData(inputs[0]), outputs, ranks);
}

PackData::WindowProperties vtkRUCPackAlgorithm::GetWindowProperties() const
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

ruc::PackFigures vtkRUCPackAlgorithm::FindFigures()
{
  const RankCommunicator ranks(this->GetController());
  return PackEstimate::FindFigures(vtkPointSet::SafeDownCast(this->GetInputDataObject(0, 0)),
    this->GetWindowProperties(), static_cast<double>(this->SpheresInInput), ranks.Size());
}

ruc::Estimate vtkRUCPackAlgorithm::MakeEstimate()
{
  throw std::invalid_argument("not known");
}

double vtkRUCPackAlgorithm::GetEstimatedTime()
{
  const RankCommunicator ranks(this->GetController());
  try
  {
    const double seconds = this->MakeEstimate().Seconds / PackEstimate::Cores(ranks.Size());
    return std::isfinite(seconds) && seconds > 0.0 ? seconds : 0.0;
  }
  catch (const std::exception&)
  {
    return 0.0;
  }
}

double vtkRUCPackAlgorithm::GetEstimatedMemory()
{
  const RankCommunicator ranks(this->GetController());
  try
  {
    const ruc::Estimate estimate = this->MakeEstimate();
    const double megabytes = estimate.MegabytesOfRank + estimate.MegabytesOfAll / ranks.Size();
    return std::isfinite(megabytes) && megabytes > 0.0 ? megabytes : 0.0;
  }
  catch (const std::exception&)
  {
    return 0.0;
  }
}

const char* vtkRUCPackAlgorithm::GetAutomaticValues()
{
  try
  {
    this->AutomaticValues = this->MakeEstimate().Automatic;
  }
  catch (const std::exception&)
  {
    this->AutomaticValues.clear();
  }
  return this->AutomaticValues.c_str();
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
