// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/GradientSearch.h"

#include "ruc/Base/Text.h"
#include "ruc/Packing/DensePack.h"
#include "ruc/Packing/EventRemoval.h"
#include "ruc/Packing/HardSpheres.h"
#include "ruc/Packing/MaximumFraction.h"
#include "ruc/Packing/OverlapRemoval.h"
#include "ruc/Particles/SphereOverlap.h"
#include "ruc/Reconstruction/CellObjective.h"
#include "ruc/Reconstruction/CellStart.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
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

// For dense cells; found on equal spheres and on two sizes
constexpr double SoftStiffness = 1.0, FirstStiffness = 10.0; // mu
constexpr int IterationsOfRound = 40, MostRounds = 40;
constexpr double LeastSoftProgress = 0.02; // of F2 in IterationsOfRound
constexpr double LeastOverlap = 3e-7;      // of a contact, that events take out without a trace
constexpr double FirstStepIfDense = 0.1;
constexpr double LongestEdge = 1.2; // of that of the contents, where spheres jam
// Jammed spheres cannot be moved and freed again: their cell gets so much more room
constexpr double RoomOfJammed = 1.0003; // of the edge
// What is denser than random packs are on average jams also where it grows more slowly
constexpr double RateOfDensest = 0.003;

// Throws where no random pack is as dense as the cell
bool IsDense(const std::vector<double>& radii, double fraction, double edge)
{
  const double maximum = MaximumRandomFraction(radii);
  if (fraction > maximum + 0.015)
  {
    throw std::invalid_argument(Text("A cell of these spheres would have a fraction of ", fraction,
      ", which is more than random packs of these sizes reach (about ", maximum, ")."));
  }
  const double largest = 2.0 * *std::max_element(radii.begin(), radii.end());
  return radii.size() > 1 && fraction > DenseShare * maximum &&
    edge > SphereRooms::LeastEdgeInDiameters * largest * (1.0 + 1e-6);
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
    , Best{ {}, contents.MakeBox(), 0.0, 0.0, {}, 0, EndReason::None, target, {} }
    , Dense(IsDense(contents.Radii(), contents.Fraction(), contents.Edge))
  {
  }

  void Start()
  {
    const std::vector<double> centres =
      this->Dense ? this->DenseCentres() : RandomCentres(this->Contents, this->Settings.Seed, 0);
    this->State.Contacts.Stiffness = this->Dense ? SoftStiffness : 0.0;
    this->State.Edge = this->Contents.Edge;
    this->MakeObjective();
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
    const double longest = this->Dense ? LongestEdge * this->Contents.Edge : this->Contents.Edge;
    if ((state.Contacts.Stiffness > 0.0) != this->Dense ||
      !state.Contacts.CanBe(this->Contents.NumberOfSpheres()) ||
      !(state.Edge >= this->Contents.Edge && state.Edge <= longest))
    {
      throw std::invalid_argument("The contacts of the state are damaged or of another cell.");
    }
    this->State = state;
    this->Contents.Edge = state.Edge;
    this->MakeObjective();
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
  // Once it is known how large the cell is
  void MakeObjective()
  {
    this->Best.Box = this->Contents.MakeBox();
    this->Objective.emplace(this->Contents, this->Target, this->Ranks);
    this->Objective->SetPenaltyWeight(this->Dense ? 0.0 : DescentPenaltyWeight);
    if (this->Dense)
    {
      const std::vector<double> anywhere(3 * this->Contents.NumberOfSpheres(), 0.0);
      this->Contacts.emplace(
        this->Contents.MakePack(anywhere.data()), this->Best.Box, this->State.Contacts);
    }
  }

  // A wish to stop on any rank reaches all ranks with the sums of the evaluation
  void Evaluate(const double* centres, double* gradient)
  {
    this->Terms = this->Objective->Evaluate(centres, gradient, &this->Wish);
    if (this->Contacts)
    {
      this->Terms.Penalty = this->Contacts->Add(centres, gradient);
    }
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

  // A pack by events. Where it jams, the cell becomes larger; where it is stopped, it fills the
  // cell with some overlap.
  std::vector<double> DenseCentres()
  {
    DensePackSettings settings;
    settings.Radii = this->Contents.Radii();
    settings.Fraction = this->Contents.Fraction();
    settings.Seed = this->Settings.Seed;
    settings.Protocol = PackingProtocol::Events;
    settings.Rate = settings.Fraction > MaximumRandomFraction(settings.Radii) ? RateOfDensest : 0.0;
    const DensePack made = MakeDensePack(settings,
      [&](const GrowthStep&, double)
      {
        this->AskAll({ SearchPhase::RemovingOverlap, 0, 0.0, 0.0 });
        return !this->Stopped;
      });
    if (made.Pack.Empty())
    {
      return RandomCentres(this->Contents, this->Settings.Seed, 0);
    }
    if (made.Jammed)
    {
      this->Contents.Edge =
        std::min(RoomOfJammed * made.Box.Size[0], LongestEdge * this->Contents.Edge);
    }
    std::vector<double> centres = CentresOf(made.Pack);
    for (double& c : centres)
    {
      c *= this->Contents.Edge / made.Box.Size[0];
    }
    return centres;
  }

  double Overlap() const { return OverlapPercent(this->Objective->GetProbability()); }

  void Record(SearchPhase phase, double objective, double overlapPercent)
  {
    const int iteration = static_cast<int>(this->State.Convergence.size());
    const std::vector<double>& forces = this->State.Contacts.Multiplier;
    const double sum = std::accumulate(forces.begin(), forces.end(), 0.0);
    this->State.Convergence.push_back({ phase, iteration, objective, overlapPercent, sum });
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
    int questions = this->Best.Pack.Empty() && !this->Contacts ? MostQuestions : 0;
    const SearchState state = { SearchPhase::RemovingOverlap,
      static_cast<int>(this->State.Convergence.size()), this->Terms.TwoPoint, this->Overlap() };
    const auto carryOn = [&]()
    {
      this->AskAll(state);
      return !this->Stopped || ++questions < MostQuestions;
    };
    SpherePack pack = this->Contents.MakePack(centres.data());
    if (this->Contacts)
    {
      RemoveOverlapByEvents(pack, this->Best.Box, this->Settings.Seed, carryOn);
    }
    else
    {
      RemoveOverlap(pack, this->Best.Box, this->Settings.Seed, carryOn);
    }
    UnitCell cell = MeasureUnitCell(std::move(pack), this->Best.Box, this->Target, this->Ranks);
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
    EndReason endedBy = EndReason::None;
    DescentSettings settings;
    settings.FirstStep = FirstStepOf(this->Contents) * (this->Contacts ? FirstStepIfDense : 1.0);
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
          return endedBy == EndReason::None && !this->RoundEnds;
        });
      if (end == DescentEnd::NowhereTo)
      {
        endedBy = this->Contacts ? this->EndRound() : EndReason::Converged;
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
      descent.Steps.clear();
      descent.GradientChanges.clear();
      return EndReason::None;
    }
    contacts.Deepest = this->Contacts->Update(descent.Place.data());
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
    return endedBy == EndReason::None && descent.Iterations >= this->Settings.MaximumIterations
      ? EndReason::MaximumIterations
      : endedBy;
  }

  // Returns what ends the search, or None
  EndReason AfterIteration(const DescentState& descent)
  {
    const double objective = this->Terms.TwoPoint;
    this->Record(SearchPhase::MinimisingObjective, objective, this->Overlap());
    if (this->Contacts)
    {
      return this->AfterDenseIteration(descent);
    }
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

  CellContents Contents; // with another edge where spheres jam
  const GradientSearchSettings& Settings;
  const TwoPointProbability& Target;
  Communicator& Ranks;
  const std::function<bool(const SearchState&)>& CarryOn;
  const std::function<void(const GradientState&)>& Save;
  std::optional<CellObjective> Objective;
  CellObjective::Terms Terms{};
  GradientState State;
  std::optional<ContactMultipliers> Contacts; // of a dense cell
  bool RoundEnds = false;
  UnitCell Best;
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

namespace
{
// Of the pack by events with which a dense cell begins; nothing where it is not known to be dense
Estimate EstimateStart(const CellFigures& cell)
{
  constexpr double MostInSample = 2000.0;
  DensePackSettings settings;
  settings.Protocol = PackingProtocol::Events;
  settings.Fraction = 0.0;
  for (std::size_t mode = 0; mode < cell.Share.size() && mode < cell.Radius.size(); ++mode)
  {
    const double spheres = std::min(cell.Spheres, MostInSample) * cell.Share[mode];
    settings.Radii.insert(
      settings.Radii.end(), std::max(1, static_cast<int>(spheres)), cell.Radius[mode]);
    settings.Fraction += cell.Density * cell.Share[mode] * SphereVolume(cell.Radius[mode]);
  }
  const double edge = std::cbrt(cell.Spheres / cell.Density);
  return !settings.Radii.empty() && IsDense(settings.Radii, settings.Fraction, edge)
    ? EstimateDensePack(settings, cell.Spheres)
    : Estimate();
}
}

Estimate EstimateGradientSearch(const CellFigures& cell, const LagGrid& lags, int iterations)
{
  Estimate estimate = { cell.Spheres * SecondsPerStartedSphere +
      (iterations + 1.0) * EstimateEvaluation(cell, lags, true),
    (cell.Spheres * 1000.0 + EstimateObjectiveBytes(cell, lags)) / BytesOfMegabyte, 0.0 };
  estimate += EstimateStart(cell);
  return estimate;
}
}
