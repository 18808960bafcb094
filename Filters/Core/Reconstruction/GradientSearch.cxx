// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Reconstruction/GradientSearch.h"

#include "Random.h"
#include "Reconstruction/CellObjective.h"
#include "Reconstruction/Minimise.h"

#include <algorithm>
#include <cmath>

namespace ruc
{
namespace
{
// A cell without overlap is kept this often, for a search that is stopped or cannot be freed of
// overlap at its end
constexpr int IterationsBetweenKept = 100;
// The search has converged when F2 fell by less than this share in as many iterations
constexpr double LeastProgress = 1e-3;

std::vector<double> Centres(const SpherePack& pack)
{
  std::vector<double> centres;
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    centres.insert(centres.end(), { pack.X[i], pack.Y[i], pack.Z[i] });
  }
  return centres;
}

// Overlap in percent, as MeasureOverlap defines it, from S_rs(0): every pair that overlaps adds its
// lens volume twice
double OverlapPercent(const TwoPointProbability& probability)
{
  double fraction = 0.0;
  double counted = 0.0;
  for (int r = 0; r < probability.Modes; ++r)
  {
    fraction += probability.Fractions[r];
    for (int s = 0; s < probability.Modes; ++s)
    {
      counted += probability.S(r, s)[0];
    }
  }
  return std::max(0.5 * (counted - fraction) / fraction, 0.0) * 100.0;
}

class Search
{
public:
  Search(const CellContents& contents, const TwoPointProbability& target,
    const GradientSearchSettings& settings, Communicator& communicator,
    const std::function<bool(const SearchState&)>& carryOn)
    : Settings(settings)
    , Target(target)
    , Ranks(communicator)
    , CarryOn(carryOn)
    , Objective(contents, target, communicator)
    , Best{ {}, this->Objective.MakeBox(), 0.0, 0.0, {}, 0, {}, target, {} }
  {
    for (int i = 0; i < contents.NumberOfSpheres(); ++i)
    {
      for (double u : UniformTriple(settings.Seed, 0, i))
      {
        this->Start.push_back(contents.Edge * u);
      }
    }
  }

  UnitCell Run()
  {
    std::vector<double> centres = this->Start;
    this->Evaluate(centres.data(), nullptr);
    this->Record(
      "removing overlap", this->Terms.TwoPoint, OverlapPercent(this->Objective.GetProbability()));
    this->Keep(centres);
    this->RecordBest();
    this->Best.StartObjective = this->Best.Objective;
    centres = Centres(this->Best.Pack);
    std::string endedBy = this->Stopped ? "Stopped" : "Maximum iterations";
    if (this->MeetsTarget())
    {
      endedBy = "Target objective";
    }
    else if (!this->Stopped && this->Settings.MaximumIterations > 0)
    {
      endedBy = this->Descend(centres);
      this->Keep(centres);
      this->RecordBest();
    }
    this->Best.EndedBy = endedBy;
    this->Best.Iterations = this->Best.Convergence.back().Iteration;
    return this->Best;
  }

private:
  // The wish to stop of any rank reaches all
  void Evaluate(const double* centres, double* gradient)
  {
    this->Terms = this->Objective.Evaluate(centres, gradient, &this->Wish);
    this->Stopped = this->Stopped || this->Wish > 0;
    this->Wish = 0;
  }

  void Ask(const SearchState& state)
  {
    if (!this->CarryOn(state))
    {
      this->Wish = 1;
    }
  }

  void Record(const char* phase, double objective, double overlapPercent)
  {
    const int iteration = static_cast<int>(this->Best.Convergence.size());
    this->Best.Convergence.push_back({ phase, iteration, objective, overlapPercent });
    this->Ask(this->Best.Convergence.back());
  }

  bool MeetsTarget() const
  {
    return this->Best.Overlap.IsNone() && this->Best.Objective <= this->Settings.TargetObjective;
  }

  void RecordBest()
  {
    this->Record("removing overlap", this->Best.Objective, this->Best.Overlap.Percent);
  }

  // Frees a copy of the centres from overlap and keeps it if it is the best so far. A cell with
  // overlap is kept only while there is none without.
  void Keep(const std::vector<double>& centres)
  {
    SpherePack pack = this->Objective.MakePack(centres.data());
    const SearchState state = { "removing overlap", static_cast<int>(this->Best.Convergence.size()),
      this->Terms.TwoPoint, OverlapPercent(this->Objective.GetProbability()) };
    RemoveOverlap(pack, this->Best.Box, this->Settings.Seed,
      [&]()
      {
        this->Ask(state);
        std::int64_t wish = this->Wish;
        this->Ranks.Sum(&wish, 1);
        this->Wish = 0;
        this->Stopped = this->Stopped || wish > 0;
        return !this->Stopped;
      });
    const PackOverlap overlap = MeasureOverlap(pack, this->Best.Box);
    TwoPointProbability probability = this->FindProbability(pack);
    const double objective = TwoPointDifference(this->Target, probability);
    const bool first = this->Best.Pack.Empty();
    const bool freer = overlap.IsNone() && !this->Best.Overlap.IsNone();
    if (first || freer ||
      (overlap.IsNone() == this->Best.Overlap.IsNone() && objective < this->Best.Objective))
    {
      this->Best.Pack = std::move(pack);
      this->Best.Overlap = overlap;
      this->Best.Objective = objective;
      this->Best.Probability = std::move(probability);
    }
  }

  // By the estimator that made the target, which is a little finer than the objective's tables
  TwoPointProbability FindProbability(SpherePack pack)
  {
    SortCanonically(pack);
    const ExactPairSum sum(pack, this->Best.Box, this->Target.Lags);
    std::vector<std::int64_t> sums(sum.SumsSize(), 0);
    sum.AddChunks(this->Ranks.Rank(), this->Ranks.Size(), sums.data());
    this->Ranks.Sum(sums.data(), sums.size());
    return sum.Result(sums);
  }

  std::string Descend(std::vector<double>& centres)
  {
    std::string endedBy = "Converged";
    double checkpoint = this->Best.Objective;
    double tried = this->Best.Objective; // F2 at which a cell was last freed from overlap
    MinimiserSettings settings;
    settings.MaximumIterations = this->Settings.MaximumIterations;
    const int iterations = Minimise(
      centres, settings,
      [&](const double* x, double* gradient)
      {
        this->Evaluate(x, gradient);
        return this->Terms.Total();
      },
      [&](const double* x, double, int iteration)
      {
        const double objective = this->Terms.TwoPoint;
        this->Record("minimising F2", objective, OverlapPercent(this->Objective.GetProbability()));
        if (this->Stopped)
        {
          endedBy = "Stopped";
          return false;
        }
        const bool due = iteration % IterationsBetweenKept == 0;
        const bool promising =
          objective <= this->Settings.TargetObjective && objective < 0.99 * tried;
        if (due || promising)
        {
          tried = objective;
          this->Keep({ x, x + centres.size() });
          if (this->MeetsTarget())
          {
            endedBy = "Target objective";
            return false;
          }
        }
        if (due)
        {
          if (objective > (1.0 - LeastProgress) * checkpoint)
          {
            return false;
          }
          checkpoint = objective;
        }
        return true;
      });
    return iterations >= this->Settings.MaximumIterations && endedBy == "Converged"
      ? "Maximum iterations"
      : endedBy;
  }

  const GradientSearchSettings& Settings;
  const TwoPointProbability& Target;
  Communicator& Ranks;
  const std::function<bool(const SearchState&)>& CarryOn;
  CellObjective Objective;
  CellObjective::Terms Terms{};
  UnitCell Best;
  std::vector<double> Start;
  std::int64_t Wish = 0; // to stop, of this rank
  bool Stopped = false;  // agreed by all ranks
};
}

UnitCell SearchByGradient(const CellContents& contents, const TwoPointProbability& target,
  const GradientSearchSettings& settings, Communicator& communicator,
  const std::function<bool(const SearchState&)>& carryOn)
{
  return Search(contents, target, settings, communicator, carryOn).Run();
}
}
