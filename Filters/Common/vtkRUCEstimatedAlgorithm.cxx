// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCEstimatedAlgorithm.h"

#include "PackEstimate.h"
#include "RankCommunicator.h"
#include "ruc/Base/Estimate.h"
#include "ruc/Base/Text.h"

#include <cmath>
#include <exception>
#include <stdexcept>

namespace
{
double KnownOrZero(double number)
{
  return std::isfinite(number) && number > 0.0 ? number : 0.0;
}
}

void vtkRUCEstimatedAlgorithm::RequireMemory(double megabytes, RankCommunicator& ranks) const
{
  double negative = -megabytes;
  ranks.Minimum(&negative, 1);
  if (-negative > 0.0 && !(-negative <= this->MemoryLimit))
  {
    throw std::invalid_argument(ruc::Text("MemoryLimit requires at least ", std::ceil(-negative),
      " MB on every rank for this input with these properties, got ", this->MemoryLimit, "."));
  }
}

std::optional<ruc::Estimate> vtkRUCEstimatedAlgorithm::MakeEstimate()
{
  return {};
}

std::optional<ruc::Estimate> vtkRUCEstimatedAlgorithm::FindEstimate()
{
  try
  {
    return this->MakeEstimate();
  }
  catch (const std::exception&)
  {
    // The run says what is wrong
    return {};
  }
}

ruc::Estimate vtkRUCEstimatedAlgorithm::EstimateRegion()
{
  return {};
}

double vtkRUCEstimatedAlgorithm::GetEstimatedTime()
{
  const RankCommunicator ranks(this->GetController());
  const std::optional<ruc::Estimate> estimate = this->FindEstimate();
  return estimate ? KnownOrZero(estimate->Seconds / PackEstimate::Cores(ranks.Size())) : 0.0;
}

double vtkRUCEstimatedAlgorithm::GetEstimatedMemory()
{
  const RankCommunicator ranks(this->GetController());
  std::optional<ruc::Estimate> estimate = this->FindEstimate();
  if (!estimate)
  {
    return 0.0;
  }
  *estimate += this->EstimateRegion();
  return KnownOrZero(estimate->MegabytesOfRank + estimate->MegabytesOfAll / ranks.Size());
}

const char* vtkRUCEstimatedAlgorithm::GetAutomaticValues()
{
  const std::optional<ruc::Estimate> estimate = this->FindEstimate();
  this->AutomaticValues = estimate ? estimate->Automatic : std::string();
  return this->AutomaticValues.c_str();
}

void vtkRUCEstimatedAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
}
