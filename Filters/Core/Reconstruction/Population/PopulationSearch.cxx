// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/Population/PopulationSearch.h"

#include "ruc/Packing/MassSpring.h"
#include "ruc/Packing/OverlapRemoval.h"
#include "ruc/Reconstruction/CellObjective.h"
#include "ruc/Reconstruction/CellStart.h"
#include "ruc/Reconstruction/GradientSearch.h"
#include "ruc/Reconstruction/Population/AnnealedSelection.h"
#include "ruc/Reconstruction/Population/GeneticOperators.h"
#include "ruc/Reconstruction/Population/MemberMaker.h"

#include <algorithm>
#include <cmath>

namespace ruc
{
namespace
{
class Search
{
public:
  Search(const CellContents& contents, const TwoPointProbability& target,
    const PopulationSettings& settings, Communicator& communicator,
    const std::function<bool(const SearchState&)>& carryOn,
    const std::function<void(const PopulationState&)>& save)
    : Contents(contents)
    , Settings(settings)
    , Target(target)
    , Ranks(communicator)
    , CarryOn(carryOn)
    , Save(save)
    , Shared(contents, target, communicator)
    , Members(contents, target, communicator)
    , Box(contents.MakeBox())
  {
    this->Shared.SetPenaltyWeight(DescentPenaltyWeight);
  }

  void Start()
  {
    this->State.Temperature = this->Settings.InitialTemperature;
    // This member is all that there is where the search is stopped before another one is made
    Member start = this->Evaluated(RandomCentres(this->Contents, this->Settings.Seed, 0));
    const SearchState startState = { SearchPhase::AnnealingPopulation, 0, start.Objective,
      start.OverlapPercent, 0.0, {} };
    const auto keep = [&](Member& member)
    {
      this->State.Add(std::move(member));
      this->State.First = this->State.Range(); // of the members made so far
    };
    this->MakeMembers(
      this->Settings.Population,
      [&](int i, const std::function<bool()>& carryOn)
      { return this->MakeFirst(static_cast<std::uint32_t>(i), carryOn); },
      keep, [&]() { return this->State.Centres.empty() ? startState : this->DescribeBest(); });
    if (this->State.Centres.empty())
    {
      keep(start);
    }
    this->FinishGeneration();
  }

  void Resume(const PopulationState& state)
  {
    state.Require(this->Settings.Population, this->Contents.NumberOfSpheres());
    this->State = state;
  }

  PopulationResult Run()
  {
    EndReason endedBy;
    while ((endedBy = this->FindEnd()) == EndReason::None)
    {
      if (!this->AdvanceGeneration())
      {
        endedBy = EndReason::Stopped;
        break;
      }
    }
    return { this->Finish(endedBy), this->State.First, this->State.Range() };
  }

private:
  // ---- Members ----

  Chromosome MakeFirst(std::uint32_t number, const std::function<bool()>& carryOn) const
  {
    const bool random =
      number < std::lround(this->Settings.RandomShare * this->Settings.Population);
    return random ? RandomCentres(this->Contents, this->Settings.Seed, number)
                  : DepositBallistically(this->Contents.Radii(), this->Contents.Edge,
                      this->Settings.Seed, number, this->Settings.DepositionDegree, carryOn)
                      .Centres;
  }

  Member Evaluated(Chromosome centres)
  {
    const double objective = this->Shared.Evaluate(centres.data(), nullptr).TwoPoint;
    const SpherePack pack = this->Contents.MakePack(centres.data());
    return { std::move(centres), objective, MeasureOverlap(pack, this->Box).Percent };
  }

  // Makes `number` members, the n-th by make(n, carryOn) on one thread of rank n % ranks, and gives
  // them to keep(member) in their order on all ranks. Meanwhile the caller is told describe() and
  // asked whether to go on; when it does not, the other members are left out.
  template <class Make, class Keep, class Describe>
  void MakeMembers(int number, Make&& make, Keep&& keep, Describe&& describe)
  {
    constexpr int MembersOfRank = 64; // after these, the wish of another rank is heard
    const int some = MembersOfRank * this->Ranks.Size();
    for (int first = 0; first < number && !this->Stopped; first += some)
    {
      const int last = std::min(first + some, number);
      const SearchState told = describe();
      const auto carryOn = [&]()
      {
        this->Ask(told);
        return this->Wish == 0;
      };
      for (Member& member : this->Members.Make(first, last, make, carryOn))
      {
        if (member.IsMade())
        {
          keep(member);
        }
      }
      this->HearAll();
    }
  }

  std::vector<double> FitnessOfAll() const
  {
    return this->State.Fitness(this->Settings.HalfOverlap);
  }

  int BestMember() const { return this->State.BestMember(this->Settings.HalfOverlap); }

  // ---- Generations ----

  // Returns false when a rank wished to stop on the way; the state is then that of the last
  // generation
  bool AdvanceGeneration()
  {
    const double before = this->FitnessOfAll()[this->BestMember()];
    bool poolRests = false;
    if (this->Settings.RefinementSteps > 0 && !this->RefineBest(poolRests))
    {
      return false;
    }
    if (!poolRests && !this->Breed())
    {
      return false;
    }
    const double after = this->FitnessOfAll()[this->BestMember()];
    this->State.Stagnation = after < before ? 0 : this->State.Stagnation + 1;
    this->State.Temperature *= this->Settings.CoolingFactor;
    if (this->State.Stagnation > 0 &&
      this->State.Stagnation % this->Settings.ReheatingGenerations == 0)
    {
      this->State.Temperature = this->Settings.InitialTemperature;
    }
    ++this->State.Generation;
    this->FinishGeneration();
    return true;
  }

  // The steps of Algorithm 1: select, alter and replace. Returns false when a rank wished to stop.
  bool Breed()
  {
    const std::vector<double> fitness = this->FitnessOfAll();
    RandomSequence random(this->Settings.Seed, RandomStream::MatingPool, this->State.Generation);
    const std::vector<int> pool = DrawMatingPool(
      RankByFitness(fitness), this->Settings.MatingPool, this->Settings.SelectionPressure, random);
    std::vector<int> mates;
    for (int parent : pool)
    {
      mates.push_back(this->DrawMate(parent, pool, random));
    }
    std::vector<Member> children;
    this->MakeMembers(
      this->Settings.MatingPool,
      [&](int j, const std::function<bool()>& carryOn)
      { return this->MakeChild(j, pool[j], mates[j], fitness, carryOn); },
      [&](Member& child) { children.push_back(std::move(child)); },
      [&]() { return this->State.Convergence.back(); });
    if (this->Stopped)
    {
      return false;
    }
    for (Member& child : children)
    {
      if (this->Settings.RefinementSteps > 0 && !this->Refine(child))
      {
        return false;
      }
    }
    for (std::size_t j = 0; j < children.size(); ++j)
    {
      this->Compete(children[j], pool[j], random.Next());
    }
    return true;
  }

  // Draws a mate from the pool, or from all members where the pool is a single one
  int DrawMate(int parent, const std::vector<int>& pool, RandomSequence& random) const
  {
    const int number = static_cast<int>(pool.size() > 1 ? pool.size() : this->State.Centres.size());
    int mate = parent;
    while (mate == parent)
    {
      const int place = random.NextIndex(number);
      mate = pool.size() > 1 ? pool[place] : place;
    }
    return mate;
  }

  Chromosome MakeChild(int child, int parent, int mate, const std::vector<double>& fitness,
    const std::function<bool()>& carryOn) const
  {
    RandomSequence random(this->Settings.Seed, RandomStream::MutationOperator,
      std::uint64_t(this->State.Generation) * this->Settings.MatingPool + child);
    Chromosome centres = this->Alter(parent, mate, fitness, random);
    if (random.Next() < this->Settings.MassSpringProbability)
    {
      SpherePack pack = this->Contents.MakePack(centres.data());
      MoveBySpringsUntilFree(pack, this->Box, this->Settings.Seed, carryOn);
      centres = CentresOf(pack);
    }
    return centres;
  }

  Chromosome Alter(
    int parent, int mate, const std::vector<double>& fitness, RandomSequence& random) const
  {
    const int all = this->Contents.NumberOfSpheres();
    const int some = std::clamp<int>(std::lround(this->Settings.MutatedShare * all), 1, all);
    const MutationRange range = {
      std::min(double(this->State.Generation) / this->Settings.MutationGenerations, 1.0),
      this->Settings.MutationShape, this->Settings.MutationReach
    };
    const GeneticOperator drawn = DrawOperator(this->Settings.OperatorWeights, random);
    return ApplyOperator(drawn, this->State.Centres[parent], this->State.Centres[mate],
      fitness[parent] <= fitness[mate], this->Contents.Edge, some, range, random);
  }

  // Lets a child take its parent's place, or not; `u` is the random number that decides
  void Compete(Member& child, int parent, double u)
  {
    const std::vector<double> fitness = this->FitnessOfAll();
    const int best = RankByFitness(fitness).front();
    const double own = Fitness(
      child.Objective, this->State.First.Maximum, child.OverlapPercent, this->Settings.HalfOverlap);
    const bool accepted = u < AcceptanceProbability(own, fitness[parent], this->State.Temperature);
    if (own < fitness[best] || (accepted && parent != best))
    {
      this->State.Centres[parent] = std::move(child.Centres);
      this->State.Objective[parent] = child.Objective;
      this->State.OverlapPercent[parent] = child.OverlapPercent;
      if (parent == this->State.Descending)
      {
        this->State.Descending = -1;
      }
    }
  }

  // ---- Refinement by gradient, all ranks together ----

  // Takes RefinementSteps of a descent, and makes a member of its place, freed from overlap.
  // Returns false when a rank wished to stop.
  bool Refine(DescentState& descent, Member& member)
  {
    DescentSettings settings;
    settings.FirstStep = FirstStepOf(this->Contents);
    const int end = descent.Iterations + this->Settings.RefinementSteps;
    bool stopped = false;
    Descend(
      descent, settings,
      [&](const double* place, double* gradient, double& value)
      {
        this->Ask(this->State.Convergence.back());
        value = this->Shared.Evaluate(place, gradient, &this->Wish).Total();
        stopped = this->Wish > 0;
        this->Wish = 0;
        return !stopped;
      },
      [&](const DescentState& now) { return now.Iterations < end; });
    if (stopped)
    {
      return false;
    }
    SpherePack pack = this->Contents.MakePack(descent.Place.data());
    if (!this->Free(pack))
    {
      return false;
    }
    member = this->Evaluated(CentresOf(pack));
    return true;
  }

  // Removes overlap on all ranks alike. Returns false when a rank wished to stop.
  bool Free(SpherePack& pack)
  {
    RemoveOverlap(pack, this->Box, this->Settings.Seed,
      [&]()
      {
        this->AskAll(this->State.Convergence.back());
        return !this->Stopped;
      });
    return !this->Stopped;
  }

  bool Refine(Member& member)
  {
    DescentState descent;
    descent.Place = member.Centres;
    return this->Refine(descent, member);
  }

  // Descends from the best member. The first time it is the random start of SearchByGradient, so
  // that the hybrid goes the same way as long as that leads down. The pool rests as long as the
  // descent gains more than children would.
  bool RefineBest(bool& poolRests)
  {
    const int best = this->State.Generation == 0 ? 0 : this->BestMember();
    DescentState descent;
    if (best == this->State.Descending)
    {
      descent = this->State.Descent;
    }
    else
    {
      SpherePack pack = this->Contents.MakePack(this->State.Centres[best].data());
      if (!this->Free(pack))
      {
        return false;
      }
      descent.Place = CentresOf(pack);
    }
    Member refined;
    if (!this->Refine(descent, refined))
    {
      return false;
    }
    const double worthwhile =
      LeastProgress * this->Settings.RefinementSteps / IterationsBetweenKept;
    poolRests = refined.Objective < (1.0 - worthwhile) * this->State.Objective[best];
    this->Compete(refined, best, 1.0);
    this->State.Descending = best;
    this->State.Descent = std::move(descent);
    return true;
  }

  // ---- The end ----

  void Ask(const SearchState& state)
  {
    if (!this->CarryOn(state))
    {
      this->Wish = 1;
    }
  }

  // A wish to stop on any rank reaches all ranks
  void AskAll(const SearchState& state)
  {
    this->Ask(state);
    this->HearAll();
  }

  void HearAll()
  {
    this->Ranks.Sum(&this->Wish, 1);
    this->Stopped = this->Stopped || this->Wish > 0;
    this->Wish = 0;
  }

  SearchState DescribeBest() const
  {
    const int best = this->BestMember();
    return { SearchPhase::AnnealingPopulation, this->State.Generation, this->State.Objective[best],
      this->State.OverlapPercent[best], 0.0, {} };
  }

  void FinishGeneration()
  {
    this->State.Convergence.push_back(this->DescribeBest());
    // Nothing can go on from a first population that was stopped on the way
    const bool whole = static_cast<int>(this->State.Centres.size()) == this->Settings.Population;
    if (whole)
    {
      this->AskAll(this->State.Convergence.back());
    }
    if (whole && this->Save)
    {
      this->Save(this->State);
    }
  }

  // Returns what ends the search, or None
  EndReason FindEnd()
  {
    const int best = this->BestMember();
    if (this->State.OverlapPercent[best] == 0.0 &&
      this->State.Objective[best] <= this->Settings.TargetObjective &&
      this->FreeBest().Objective <= this->Settings.TargetObjective)
    {
      return EndReason::TargetObjective;
    }
    if (this->Stopped)
    {
      return EndReason::Stopped;
    }
    if (this->State.Generation >= this->Settings.MaximumGenerations)
    {
      return EndReason::MaximumIterations;
    }
    return this->State.Stagnation >= this->Settings.PatienceGenerations ? EndReason::Converged
                                                                        : EndReason::None;
  }

  // A search that is to stop still gets the few steps in which most cells are freed
  UnitCell FreeBest()
  {
    constexpr int MostQuestions = 50;
    int questions = 0;
    const Chromosome& centres = this->State.Centres[this->BestMember()];
    return FinishUnitCell(this->Contents.MakePack(centres.data()), this->Box, this->Target,
      this->Settings.Seed, this->Ranks,
      [&]()
      {
        if (!this->Stopped)
        {
          this->AskAll(this->State.Convergence.back());
        }
        return !this->Stopped || ++questions < MostQuestions;
      });
  }

  UnitCell Finish(EndReason endedBy)
  {
    UnitCell cell = this->FreeBest();
    if (this->Stopped && !cell.Overlap.IsNone())
    {
      endedBy = EndReason::Stopped;
    }
    cell.StartObjective = this->State.First.Mean;
    cell.Convergence = this->State.Convergence;
    cell.Iterations = static_cast<int>(cell.Convergence.size());
    cell.Convergence.push_back({ SearchPhase::RemovingOverlap, cell.Iterations, cell.Objective,
      cell.Overlap.Percent, 0.0, {} });
    cell.EndedBy = endedBy;
    return cell;
  }

  const CellContents& Contents;
  const PopulationSettings& Settings;
  const TwoPointProbability& Target;
  Communicator& Ranks;
  const std::function<bool(const SearchState&)>& CarryOn;
  const std::function<void(const PopulationState&)>& Save;
  CellObjective Shared; // evaluates one cell on all ranks
  MemberMaker Members;
  Window Box;
  PopulationState State;
  std::int64_t Wish = 0; // 1 where this rank wishes to stop
  bool Stopped = false;  // the same on all ranks
};
}

PopulationResult SearchByPopulation(const CellContents& contents, const TwoPointProbability& target,
  const PopulationSettings& settings, Communicator& communicator,
  const std::function<bool(const SearchState&)>& carryOn, const PopulationState* resume,
  const std::function<void(const PopulationState&)>& save)
{
  CheckSettings(settings);
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
