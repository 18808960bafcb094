// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/Population/PopulationState.h"

#include "ruc/Base/Text.h"
#include "ruc/Reconstruction/Population/AnnealedSelection.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace ruc
{
void PopulationState::Add(Member member)
{
  this->Centres.push_back(std::move(member.Centres));
  this->Objective.push_back(member.Objective);
  this->OverlapPercent.push_back(member.OverlapPercent);
}

std::vector<double> PopulationState::Fitness(double halfOverlap) const
{
  std::vector<double> fitness;
  for (std::size_t i = 0; i < this->Objective.size(); ++i)
  {
    fitness.push_back(
      ruc::Fitness(this->Objective[i], this->First.Maximum, this->OverlapPercent[i], halfOverlap));
  }
  return fitness;
}

int PopulationState::BestMember(double halfOverlap) const
{
  const std::vector<double> fitness = this->Fitness(halfOverlap);
  return static_cast<int>(std::min_element(fitness.begin(), fitness.end()) - fitness.begin());
}

ObjectiveRange PopulationState::Range() const
{
  const std::vector<double>& f2 = this->Objective;
  const auto [low, high] = std::minmax_element(f2.begin(), f2.end());
  return { *low, std::accumulate(f2.begin(), f2.end(), 0.0) / f2.size(), *high };
}

void PopulationState::Require(std::size_t members, std::size_t spheres) const
{
  const bool fits = this->Centres.size() == members && this->Objective.size() == members &&
    this->OverlapPercent.size() == members && !this->Convergence.empty() &&
    std::all_of(this->Centres.begin(), this->Centres.end(),
      [&](const Chromosome& centres) { return centres.size() == 3 * spheres; });
  if (!fits)
  {
    throw std::invalid_argument(Text("Resuming requires a state of ", members, " members of ",
      spheres, " spheres, got one of ", this->Centres.size(), " members",
      this->Centres.empty() ? std::string() : Text(" of ", this->Centres[0].size() / 3), "."));
  }
}
}
