// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CellProperties.h"

#include "ruc/Base/Require.h"
#include "ruc/Reconstruction/SearchSettings.h"

void CellProperties::Check() const
{
  ruc::CheckRanges(*this);
  ruc::Require(this->NumberOfParticles == 0 || this->CellSize == 0.0, "CellSize",
    "0 when NumberOfParticles is set", this->CellSize);
  ruc::Require(this->ModeCounts.empty() || this->CellSize == 0.0, "CellSize",
    "0 when ModeCounts are set", this->CellSize);
  ruc::Require(this->ModeCounts.empty() || this->NumberOfParticles == 0, "NumberOfParticles",
    "0 when ModeCounts are set", this->NumberOfParticles);
}

ruc::ModeAmounts CellProperties::FindAmounts(const ruc::ModeAmounts& ofInput) const
{
  if (this->ModeDiameters.empty())
  {
    return ofInput;
  }
  std::vector<double> fractions;
  for (int mode = 0; mode < ofInput.NumberOfModes(); ++mode)
  {
    fractions.push_back(ofInput.Fraction(mode));
  }
  return ruc::ModeAmounts(fractions, this->ModeDiameters);
}

ruc::CellContents CellProperties::FindContents(
  const ruc::ModeAmounts& amounts, const std::function<double()>& findEdge) const
{
  ruc::CellContents contents = !this->ModeCounts.empty()
    ? ruc::FindCellContents(amounts, this->ModeCounts)
    : this->NumberOfParticles > 0
    ? ruc::FindCellContents(amounts, this->NumberOfParticles)
    : ruc::FindCellContents(amounts, this->CellSize > 0.0 ? this->CellSize : findEdge());
  contents.Gap = this->Gap;
  return contents;
}
