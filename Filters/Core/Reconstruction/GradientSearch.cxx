// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/GradientSearch.h"

#include "ruc/Packing/EventRemoval.h"
#include "ruc/Packing/OverlapRemoval.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace ruc
{
namespace
{
// For dense cells; found on equal spheres and on two sizes
constexpr double SoftStiffness = 1.0, FirstStiffness = 10.0; // mu
constexpr int IterationsOfRound = 40, MostRounds = 40;
constexpr double LeastSoftProgress = 0.02; // of F2 in IterationsOfRound
constexpr double LeastOverlap = 3e-7;      // of a contact, that events take out without a trace
constexpr double FirstStepIfDense = 0.1;
// For neighbours and pores; found on the example pack
constexpr double ShareOfReference = 0.5; // F0 in F2 of the first descent
constexpr double ShareOfObjective = 0.8; // of the target objective, at which they are added

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
    , Best{ {}, contents.MakeBox(), 0.0, 0.0, {}, {}, 0, EndReason::None, target, {} }
    , Dense(IsDense(contents))
  {
  }

  void Start()
  {
    const auto carryOn = [&]()
    {
      this->AskAll({ SearchPhase::RemovingOverlap, 0, 0.0, 0.0, 0.0, {} });
      return !this->Stopped;
    };
    const std::vector<double> centres = this->Dense
      ? DenseCentres(this->Contents, this->Settings.Seed, carryOn)
      : RandomCentres(this->Contents, this->Settings.Seed, 0);
    this->State.Contacts.Stiffness = this->Dense ? SoftStiffness : 0.0;
    this->State.Edge = this->Contents.Edge;
    this->MakeObjective();
    this->Evaluate(centres.data(), nullptr);
    this->Record(SearchPhase::RemovingOverlap, this->Terms.TwoPoint, this->Overlap(), {});
    this->Keep(centres);
    this->RecordBest();
    this->State.StartObjective = this->Best.Objective;
    this->State.Kept = this->Best.Objective;
    this->State.Tried = this->Best.Objective;
    this->State.Descent.Place = CentresOf(this->Best.Pack);
  }

  void Resume(const GradientState& state)
  {
    CheckState(state, this->Contents, this->Dense);
    this->State = state;
    this->Contents.Edge = state.Edge;
    this->MakeObjective();
    if (state.Reference > 0.0)
    {
      this->Objective->BeginNeighbours(state.Reference);
      this->Objective->MoveLattice(state.Lattice);
    }
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
    else if (descends && !this->StageIsOver())
    {
      endedBy = this->Descend();
    }
    if (descends && !this->Stopped && this->HasNextStage())
    {
      this->Keep(this->State.Descent.Place);
      this->BeginNeighbours();
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
    const NeighbourTarget& neighbours = this->Settings.Neighbours;
    if (neighbours.HasSpectrum() && this->Best.Overlap.IsNone())
    {
      this->Best.Zeta = MeasureZeta(this->Best.Pack, this->Best.Box, neighbours.Spectrum);
    }
    this->Best.StartObjective = this->State.StartObjective;
    this->Best.Convergence = this->State.Convergence;
    this->Best.EndedBy = endedBy;
    this->Best.Iterations = this->Best.Convergence.back().Iteration;
    return this->Best;
  }

private:
  // Once it is known how large the cell is
  void MakeObjective()
  {
    this->Best.Box = this->Contents.MakeBox();
    this->Objective.emplace(this->Contents, this->Target, this->Settings.Neighbours, this->Dense,
      this->State.Contacts, this->Ranks);
  }

  // A wish to stop on any rank reaches all ranks with the sums of the evaluation
  void Evaluate(const double* centres, double* gradient)
  {
    this->Terms = this->Objective->Evaluate(centres, gradient, &this->Wish);
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

  // The same on all ranks, at once
  void AskAll(const SearchState& state)
  {
    if (!this->Stopped)
    {
      this->Ask(state);
      std::int64_t wish = this->Wish;
      this->Ranks.Sum(&wish, 1);
      this->Wish = 0;
      this->Stopped = wish > 0;
    }
  }

  double Overlap() const { return OverlapPercentOf(this->Objective->GetProbability()); }

  void Record(
    SearchPhase phase, double objective, double overlapPercent, const NeighbourMisfits& misfits)
  {
    const int iteration = static_cast<int>(this->State.Convergence.size());
    const std::vector<double>& forces = this->State.Contacts.Multiplier;
    const double sum = std::accumulate(forces.begin(), forces.end(), 0.0);
    this->State.Convergence.push_back(
      { phase, iteration, objective, overlapPercent, sum, misfits });
    this->Ask(this->State.Convergence.back());
  }

  bool HasNeighbours() const { return !this->Settings.Neighbours.Empty(); }
  bool WithNeighbours() const { return this->State.Reference > 0.0; }

  // The F2 that ends the descent. Neighbours and pores cost some of it, so that they are added
  // below the target.
  double ObjectiveOfStage() const
  {
    const bool first = this->HasNeighbours() && !this->WithNeighbours();
    return this->Settings.TargetObjective * (first ? ShareOfObjective : 1.0);
  }

  // Whether it is met
  bool MeetsObjective() const
  {
    return this->Best.TooNear.IsNone() && this->Best.Objective <= this->ObjectiveOfStage() &&
      (!this->WithNeighbours() || this->BestMisfits.Largest() <= 1.0);
  }

  // Whether it ends the search
  bool MeetsTarget() const
  {
    return this->MeetsObjective() && this->WithNeighbours() == this->HasNeighbours();
  }

  StageLengths Lengths() const
  {
    return StageLengths(this->Settings.MaximumIterations, this->HasNeighbours());
  }

  bool StageIsOver() const
  {
    const int iterations = this->State.Descent.Iterations - this->State.Before;
    const StageLengths lengths = this->Lengths();
    return iterations >= (this->WithNeighbours() ? lengths.WithNeighbours : lengths.First);
  }

  // A dense cell adds the neighbours between its soft contacts and the multipliers
  bool HasNextStage() const
  {
    return this->HasNeighbours() && !this->WithNeighbours() && !this->Dense;
  }

  // Adds near neighbours and pores to what is minimised
  void BeginNeighbours()
  {
    this->ForgetDescent();
    this->State.Reference =
      std::max(ShareOfReference * this->Best.Objective, std::numeric_limits<double>::min());
    this->State.Before = this->State.Descent.Iterations;
    this->State.Kept = std::numeric_limits<double>::max();
    this->State.Tried = this->State.Kept;
    this->State.Converged = false;
    this->Objective->BeginNeighbours(this->State.Reference);
    this->MeasureBest();
  }

  // What is minimised is then another function, but of nearly the same curvature
  void MoveLattice()
  {
    this->Objective->MoveLattice(++this->State.Lattice);
    this->State.Kept = std::numeric_limits<double>::max();
    this->State.Descent.Gradient.clear();
    this->RoundEnds = true;
  }

  void ForgetDescent()
  {
    this->State.Descent.Gradient.clear();
    this->State.Descent.Steps.clear();
    this->State.Descent.GradientChanges.clear();
  }

  void MeasureBest() { this->BestMisfits = this->Objective->FindMisfits(this->State.Best.data()); }

  void RecordBest()
  {
    this->Record(SearchPhase::RemovingOverlap, this->Best.Objective, this->Best.Overlap.Percent,
      this->BestMisfits);
  }

  // Frees a copy of the centres from overlap, and keeps it if it is the best so far. A cell with
  // overlap is kept only while there is none without.
  void Keep(const std::vector<double>& centres)
  {
    // A search that is to stop still gets the few steps in which most cells are freed, unless it
    // has none yet
    constexpr int MostQuestions = 50;
    int questions = this->Best.Pack.Empty() && !this->Dense ? MostQuestions : 0;
    const SearchState state = { SearchPhase::RemovingOverlap,
      static_cast<int>(this->State.Convergence.size()), this->Terms.TwoPoint, this->Overlap(), 0.0,
      this->Terms.Misfits };
    const auto carryOn = [&]()
    {
      this->AskAll(state);
      return !this->Stopped || ++questions < MostQuestions;
    };
    SpherePack pack = this->Contents.Enlarged().MakePack(centres.data());
    if (this->Dense)
    {
      RemoveOverlapByEvents(pack, this->Best.Box, this->Settings.Seed, carryOn);
    }
    else
    {
      RemoveOverlap(pack, this->Best.Box, this->Settings.Seed, carryOn);
    }
    const PackOverlap tooNear = MeasureOverlap(pack, this->Best.Box);
    pack.Radius = this->Contents.Radii();
    UnitCell cell = MeasureUnitCell(std::move(pack), this->Best.Box, this->Target, this->Ranks);
    cell.TooNear = tooNear;
    const bool first = this->Best.Pack.Empty();
    if (!first)
    {
      this->MeasureBest(); // the lattice has moved
    }
    const NeighbourMisfits misfits = this->Objective->FindMisfits(CentresOf(cell.Pack).data());
    const bool freer = cell.TooNear.IsNone() && !this->Best.TooNear.IsNone();
    if (first || freer ||
      (cell.TooNear.IsNone() == this->Best.TooNear.IsNone() &&
        this->Objective->ValueOf(cell.Objective, misfits) <
          this->Objective->ValueOf(this->Best.Objective, this->BestMisfits)))
    {
      this->Best = std::move(cell);
      this->BestMisfits = misfits;
      this->State.Best = CentresOf(this->Best.Pack);
    }
  }

  EndReason Descend()
  {
    EndReason endedBy = EndReason::None;
    DescentSettings settings;
    settings.FirstStep = FirstStepOf(this->Contents) * (this->Dense ? FirstStepIfDense : 1.0);
    DescentEnd end = DescentEnd::Told;
    do
    {
      this->RoundEnds = false;
      end = ruc::Descend(
        this->State.Descent, settings,
        [&](const double* place, double* gradient, double& value)
        {
          this->Ask(this->State.Convergence.back());
          this->Evaluate(place, gradient);
          value = this->Terms.Total;
          return !this->Stopped;
        },
        [&](const DescentState& descent)
        {
          endedBy = this->AfterIteration(descent);
          if (this->Save)
          {
            this->Save(this->State);
          }
          return endedBy == EndReason::None && !this->RoundEnds;
        });
      if (end == DescentEnd::NowhereTo)
      {
        endedBy = this->Dense ? this->EndRound() : EndReason::Converged;
      }
    } while (end != DescentEnd::GivenUp && endedBy == EndReason::None);
    return end == DescentEnd::GivenUp ? EndReason::Stopped : endedBy;
  }

  // Ends a round of the multipliers, or the soft stage before them, and keeps its cell. The
  // function that is minimised is then another. Returns what ends the search, or None.
  EndReason EndRound()
  {
    ContactState& contacts = this->State.Contacts;
    DescentState& descent = this->State.Descent;
    this->RoundEnds = true;
    descent.Gradient.clear();
    this->Keep(descent.Place);
    if (this->MeetsTarget())
    {
      return EndReason::TargetObjective;
    }
    const double before = contacts.Deepest;
    if (contacts.Round++ == 0)
    {
      contacts.Stiffness = FirstStiffness;
      this->ForgetDescent();
      if (this->HasNeighbours())
      {
        this->BeginNeighbours();
      }
      return EndReason::None;
    }
    contacts.Deepest = this->Objective->Multipliers().Update(descent.Place.data());
    if (contacts.Deepest < LeastOverlap || contacts.Round > MostRounds)
    {
      this->State.Converged = true;
      return EndReason::Converged;
    }
    if (contacts.Deepest > 0.25 * before)
    {
      contacts.Stiffness *= 2.0;
    }
    return EndReason::None;
  }

  // The same for a dense cell
  EndReason AfterDenseIteration(const DescentState& descent)
  {
    const double objective = this->Terms.TwoPoint;
    EndReason endedBy = EndReason::None;
    if (descent.Iterations % IterationsOfRound == 0)
    {
      const bool soft = this->State.Contacts.Round == 0;
      if (!soft || objective > (1.0 - LeastSoftProgress) * this->State.Kept)
      {
        endedBy = this->EndRound();
      }
      this->State.Kept = objective;
    }
    return endedBy == EndReason::None && this->StageIsOver() ? EndReason::MaximumIterations
                                                             : endedBy;
  }

  // Returns what ends the descent, or None
  EndReason AfterIteration(const DescentState& descent)
  {
    const int iterations = descent.Iterations - this->State.Before;
    this->Record(
      this->WithNeighbours() ? SearchPhase::FittingNeighbours : SearchPhase::MinimisingObjective,
      this->Terms.TwoPoint, this->Overlap(), this->Terms.Misfits);
    const EndReason endedBy =
      this->Dense ? this->AfterDenseIteration(descent) : this->AfterLooseIteration(iterations);
    const int since = descent.Iterations - this->State.Before;
    if (this->WithNeighbours() && this->Settings.Neighbours.HasPores() &&
      endedBy == EndReason::None && since > 0 && since % IterationsOfLattice == 0)
    {
      this->MoveLattice();
    }
    return endedBy;
  }

  // The same for a cell that is not dense
  EndReason AfterLooseIteration(int iterations)
  {
    const double objective = this->Terms.TwoPoint;
    const bool fits = this->Terms.Misfits.Largest() <= 1.0;
    const bool due = iterations % IterationsBetweenKept == 0;
    const bool promising =
      fits && objective <= this->ObjectiveOfStage() && objective < 0.99 * this->State.Tried;
    if (due || promising)
    {
      this->State.Tried = objective;
      this->Keep(this->State.Descent.Place);
      if (this->MeetsObjective())
      {
        return EndReason::TargetObjective;
      }
    }
    if (due)
    {
      this->State.Converged = fits && objective > (1.0 - LeastProgress) * this->State.Kept;
      this->State.Kept = objective;
      if (this->State.Converged)
      {
        return EndReason::Converged;
      }
    }
    return this->StageIsOver() ? EndReason::MaximumIterations : EndReason::None;
  }

  CellContents Contents; // with another edge where spheres jam
  const GradientSearchSettings& Settings;
  const TwoPointProbability& Target;
  Communicator& Ranks;
  const std::function<bool(const SearchState&)>& CarryOn;
  const std::function<void(const GradientState&)>& Save;
  std::optional<SearchObjective> Objective;
  SearchObjective::Terms Terms;
  GradientState State;
  bool RoundEnds = false;
  UnitCell Best;
  NeighbourMisfits BestMisfits;
  bool Dense;
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
}
