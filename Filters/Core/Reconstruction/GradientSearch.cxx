// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/GradientSearch.h"

#include "ruc/Base/Text.h"
#include "ruc/Reconstruction/CellObjective.h"
#include "ruc/Reconstruction/CellStart.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ruc
{
namespace
{
// The overlap in percent, as MeasureOverlap defines it, from S_rs(0), to which every pair that
// overlaps adds its lens volume twice
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
    const std::function<bool(const SearchState&)>& carryOn,
    const std::function<void(const GradientState&)>& save)
    : Contents(contents)
    , Settings(settings)
    , Target(target)
    , Ranks(communicator)
    , CarryOn(carryOn)
    , Save(save)
    , Objective(contents, target, communicator)
    , Best{ {}, contents.MakeBox(), 0.0, 0.0, {}, 0, EndReason::None, target, {} }
  {
    this->Objective.SetPenaltyWeight(DescentPenaltyWeight);
  }

  void Start()
  {
    const std::vector<double> centres = RandomCentres(this->Contents, this->Settings.Seed, 0);
    this->Evaluate(centres.data(), nullptr);
    this->Record(SearchPhase::RemovingOverlap, this->Terms.TwoPoint, this->Overlap());
    this->Keep(centres);
    this->RecordBest();
    this->State.StartObjective = this->Best.Objective;
    this->State.Kept = this->Best.Objective;
    this->State.Tried = this->Best.Objective;
    this->State.Descent.Place = CentresOf(this->Best.Pack);
  }

  void Resume(const GradientState& state)
  {
    const std::size_t length = 3 * std::size_t(this->Contents.NumberOfSpheres());
    if (state.Descent.Place.size() != length || state.Best.size() != length)
    {
      throw std::invalid_argument(Text("Resuming requires a state of ", length / 3,
        " spheres, got one of ", state.Descent.Place.size() / 3, "."));
    }
    this->State = state;
    this->Evaluate(state.Descent.Place.data(), nullptr);
    this->Keep(state.Best);
  }

  UnitCell Run()
  {
    // A search that is resumed may already be at its end
    const bool resumed = this->State.Descent.Iterations > 0;
    EndReason endedBy = this->Stopped ? EndReason::Stopped : EndReason::MaximumIterations;
    bool descends = !this->Stopped && this->Settings.MaximumIterations > 0;
    if (this->MeetsTarget())
    {
      endedBy = EndReason::TargetObjective;
      descends = resumed;
    }
    else if (this->State.Converged)
    {
      endedBy = EndReason::Converged;
    }
    else if (descends && this->State.Descent.Iterations < this->Settings.MaximumIterations)
    {
      endedBy = this->Descend();
    }
    if (descends)
    {
      this->Keep(this->State.Descent.Place);
      this->RecordBest();
      if (this->Stopped && !this->MeetsTarget())
      {
        endedBy = EndReason::Stopped; // if only while the last overlap was removed
      }
    }
    this->Best.StartObjective = this->State.StartObjective;
    this->Best.Convergence = this->State.Convergence;
    this->Best.EndedBy = endedBy;
    this->Best.Iterations = this->Best.Convergence.back().Iteration;
    return this->Best;
  }

private:
  // A wish to stop on any rank reaches all ranks with the sums of the evaluation
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

  double Overlap() const { return OverlapPercent(this->Objective.GetProbability()); }

  void Record(SearchPhase phase, double objective, double overlapPercent)
  {
    const int iteration = static_cast<int>(this->State.Convergence.size());
    this->State.Convergence.push_back({ phase, iteration, objective, overlapPercent });
    this->Ask(this->State.Convergence.back());
  }

  bool MeetsTarget() const
  {
    return this->Best.Overlap.IsNone() && this->Best.Objective <= this->Settings.TargetObjective;
  }

  void RecordBest()
  {
    this->Record(SearchPhase::RemovingOverlap, this->Best.Objective, this->Best.Overlap.Percent);
  }

  // Frees a copy of the centres from overlap, and keeps it if it is the best so far. A cell with
  // overlap is kept only while there is none without.
  void Keep(const std::vector<double>& centres)
  {
    // A search that is to stop still gets the few steps in which most cells are freed, unless it
    // has none yet
    constexpr int MostQuestions = 50;
    int questions = this->Best.Pack.Empty() ? MostQuestions : 0;
    const SearchState state = { SearchPhase::RemovingOverlap,
      static_cast<int>(this->State.Convergence.size()), this->Terms.TwoPoint, this->Overlap() };
    UnitCell cell = FinishUnitCell(this->Contents.MakePack(centres.data()), this->Best.Box,
      this->Target, this->Settings.Seed, this->Ranks,
      [&]()
      {
        if (!this->Stopped)
        {
          this->Ask(state);
          std::int64_t wish = this->Wish;
          this->Ranks.Sum(&wish, 1);
          this->Wish = 0;
          this->Stopped = wish > 0;
        }
        return !this->Stopped || ++questions < MostQuestions;
      });
    const bool first = this->Best.Pack.Empty();
    const bool freer = cell.Overlap.IsNone() && !this->Best.Overlap.IsNone();
    if (first || freer ||
      (cell.Overlap.IsNone() == this->Best.Overlap.IsNone() &&
        cell.Objective < this->Best.Objective))
    {
      this->Best = std::move(cell);
      this->State.Best = CentresOf(this->Best.Pack);
    }
  }

  EndReason Descend()
  {
    EndReason endedBy = EndReason::Converged;
    DescentSettings settings;
    settings.FirstStep = FirstStepOf(this->Contents);
    const DescentEnd end = ruc::Descend(
      this->State.Descent, settings,
      [&](const double* place, double* gradient, double& value)
      {
        this->Ask(this->State.Convergence.back());
        this->Evaluate(place, gradient);
        value = this->Terms.Total();
        return !this->Stopped;
      },
      [&](const DescentState& descent)
      {
        endedBy = this->AfterIteration(descent);
        if (this->Save)
        {
          this->Save(this->State);
        }
        return endedBy == EndReason::None;
      });
    if (end == DescentEnd::NowhereTo)
    {
      return EndReason::Converged;
    }
    return end == DescentEnd::GivenUp ? EndReason::Stopped : endedBy;
  }

  // Returns what ends the search, or None
  EndReason AfterIteration(const DescentState& descent)
  {
    const double objective = this->Terms.TwoPoint;
    this->Record(SearchPhase::MinimisingObjective, objective, this->Overlap());
    const bool due = descent.Iterations % IterationsBetweenKept == 0;
    const bool promising =
      objective <= this->Settings.TargetObjective && objective < 0.99 * this->State.Tried;
    if (due || promising)
    {
      this->State.Tried = objective;
      this->Keep(descent.Place);
      if (this->MeetsTarget())
      {
        return EndReason::TargetObjective;
      }
    }
    if (due)
    {
      this->State.Converged = objective > (1.0 - LeastProgress) * this->State.Kept;
      this->State.Kept = objective;
      if (this->State.Converged)
      {
        return EndReason::Converged;
      }
    }
    return descent.Iterations >= this->Settings.MaximumIterations ? EndReason::MaximumIterations
                                                                  : EndReason::None;
  }

  const CellContents& Contents;
  const GradientSearchSettings& Settings;
  const TwoPointProbability& Target;
  Communicator& Ranks;
  const std::function<bool(const SearchState&)>& CarryOn;
  const std::function<void(const GradientState&)>& Save;
  CellObjective Objective;
  CellObjective::Terms Terms{};
  GradientState State;
  UnitCell Best;
  std::int64_t Wish = 0; // 1 where this rank wishes to stop
  bool Stopped = false;  // the same on all ranks
};
}

double FirstStepOf(const CellContents& contents)
{
  return contents.Edge / std::cbrt(contents.NumberOfSpheres()) / 40.0;
}

UnitCell SearchByGradient(const CellContents& contents, const TwoPointProbability& target,
  const GradientSearchSettings& settings, Communicator& communicator,
  const std::function<bool(const SearchState&)>& carryOn, const GradientState* resume,
  const std::function<void(const GradientState&)>& save)
{
  CheckRanges(settings);
  Search search(contents, target, settings, communicator, carryOn, save);
  if (resume)
  {
    search.Resume(*resume);
  }
  else
  {
    search.Start();
  }
  return search.Run();
}

Estimate EstimateGradientSearch(const CellFigures& cell, const LagGrid& lags, int iterations)
{
  return { cell.Spheres * SecondsPerStartedSphere +
      (iterations + 1.0) * EstimateEvaluation(cell, lags, true),
    (cell.Spheres * 1000.0 + EstimateObjectiveBytes(cell, lags)) / BytesOfMegabyte, 0.0 };
}
}
