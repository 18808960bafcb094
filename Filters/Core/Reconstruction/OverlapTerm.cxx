// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/OverlapTerm.h"

#include "ruc/Particles/SphereOverlap.h"

#include <algorithm>
#include <functional>

namespace ruc
{
OverlapTerm::OverlapTerm(const CellContents& contents, const PairHistogram& classes)
  : Classes(classes)
  , Gap(contents.Gap)
{
  double volume = 0.0;
  double weighted = 0.0;
  for (std::size_t m = 0; m < contents.Count.size(); ++m)
  {
    const double modeVolume = contents.Count[m] * SphereVolume(contents.Radius[m]);
    volume += modeVolume;
    weighted += modeVolume * contents.Radius[m];
  }
  this->MeanRadius = weighted / volume;
  this->SetWeight(1.0);
}

void OverlapTerm::SetWeight(double weight)
{
  const double factor = weight / (this->MeanRadius * this->MeanRadius);
  this->Penalties.assign(this->Classes.Size(), 0.0);
  for (int c = 0; c < this->Classes.NumberOfClasses(); ++c)
  {
    const double contact = this->Gap.Enlarged(this->Classes.LowerType(c).Radius) +
      this->Gap.Enlarged(this->Classes.HigherType(c).Radius);
    this->Classes.Kernel(c).AddOverlapPenalty(
      factor, contact, &this->Penalties[this->Classes.Begin(c)]);
  }
}

double OverlapTerm::Evaluate(const PairCounts& pairs) const
{
  double sum = 0.0;
  for (std::size_t n = 0; n < this->Penalties.size(); ++n)
  {
    sum += this->Penalties[n] * (pairs.Sums[n] / pairs.Scale);
  }
  return sum;
}

void OverlapTerm::AddPotential(std::vector<double>& potential) const
{
  std::transform(
    potential.begin(), potential.end(), this->Penalties.begin(), potential.begin(), std::plus<>());
}
}
