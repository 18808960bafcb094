// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCSamplingAlgorithm.h"

#include "ruc/Statistics/Sampling/SampledSums.h"

ruc::SamplingSettings vtkRUCSamplingAlgorithm::GetSettings(bool throws) const
{
  ruc::SamplingSettings settings;
  settings.Seed = this->GetCheckedSeed();
  settings.Samples = throws ? this->NumberOfThrows : this->NumberOfLines;
  settings.TargetError = this->TargetError;
  return settings;
}

void vtkRUCSamplingAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfLines: " << this->NumberOfLines << "\n";
  os << indent << "NumberOfThrows: " << this->NumberOfThrows << "\n";
  os << indent << "TargetError: " << this->TargetError << "\n";
}
