// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CellSearch.h"

#include "CheckpointFile.h"
#include "RankCommunicator.h"
#include "RankSignal.h"
#include "ruc/Base/Bytes.h"
#include "ruc/Reconstruction/SearchCheckpoint.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>

namespace
{
// The two ways to search, under the same names
struct ByGradient
{
  using Settings = ruc::GradientSearchSettings;
  using State = ruc::GradientState;
  static Settings Of(const CellSearch::Settings& settings) { return settings.Gradient; }
  static State Read(const std::string& bytes, const ruc::SearchKey& key, ruc::SearchStops& stops)
  {
    return ruc::ReadGradientCheckpoint(bytes, key, &stops);
  }
  static void Run(const ruc::CellContents& contents, const ruc::TwoPointProbability& target,
    const Settings& settings, RankCommunicator& ranks,
    const std::function<bool(const ruc::SearchState&)>& carryOn, const State* resume,
    const std::function<void(const State&)>& save, CellSearch::FoundCell& found)
  {
    found.Cell = ruc::SearchByGradient(contents, target, settings, ranks, carryOn, resume, save);
    const double start = found.Cell.StartObjective, end = found.Cell.Objective;
    found.Before = { start, start, start };
    found.After = { end, end, end };
  }
};

struct ByPopulation
{
  using Settings = ruc::PopulationSettings;
  using State = ruc::PopulationState;
  static Settings Of(const CellSearch::Settings& settings) { return settings.FindPopulation(); }
  static State Read(const std::string& bytes, const ruc::SearchKey& key, ruc::SearchStops& stops)
  {
    return ruc::ReadPopulationCheckpoint(bytes, key, &stops);
  }
  static void Run(const ruc::CellContents& contents, const ruc::TwoPointProbability& target,
    const Settings& settings, RankCommunicator& ranks,
    const std::function<bool(const ruc::SearchState&)>& carryOn, const State* resume,
    const std::function<void(const State&)>& save, CellSearch::FoundCell& found)
  {
    ruc::PopulationResult result =
      ruc::SearchByPopulation(contents, target, settings, ranks, carryOn, resume, save);
    found.Cell = std::move(result.Best);
    found.Before = result.Before;
    found.After = result.After;
  }
};

CellSearch::FoundCell NewCell(int number, const ruc::TwoPointProbability& target)
{
  const ruc::TwoPointProbability none(target.Modes, target.Lags);
  return { number, { {}, ruc::Window(), 0.0, 0.0, {}, {}, 0, ruc::EndReason::None, none, {} }, {},
    {} };
}

// Whether the box is that of the contents, or larger, as where spheres jam
bool IsBoxOf(const ruc::Window& box, ruc::CellContents contents)
{
  const bool larger = box.Size[0] >= contents.Edge && box.Size[0] <= 1.25 * contents.Edge;
  contents.Edge = box.Size[0];
  return larger && box == contents.MakeBox();
}

// Throws if a cell that was read cannot be one of these contents and this target
void RequireFit(const CellSearch::FoundCell& found, const ruc::CellContents& contents,
  const ruc::TwoPointProbability& target)
{
  const std::size_t spheres = contents.NumberOfSpheres(), lags = target.Lags.Count + 1;
  const ruc::SpherePack expected = contents.MakePack(std::vector<double>(3 * spheres).data());
  const ruc::SpherePack& pack = found.Cell.Pack;
  const ruc::TwoPointProbability& s = found.Cell.Probability;
  const bool fits = pack.X.size() == spheres && pack.Y.size() == spheres &&
    pack.Z.size() == spheres && pack.Radius == expected.Radius && pack.Mode == expected.Mode &&
    pack.Id == expected.Id && IsBoxOf(found.Cell.Box, contents) &&
    !found.Cell.Convergence.empty() && ruc::IsFromOutside(found.Cell.EndedBy) &&
    s.Modes == target.Modes && s.Lags.Count == target.Lags.Count &&
    s.Fractions.size() == target.Fractions.size() && s.Values.size() == target.Values.size() &&
    std::all_of(s.Values.begin(), s.Values.end(),
      [&](const std::vector<double>& values) { return values.size() == lags; });
  if (!fits)
  {
    throw std::invalid_argument("The checkpoint is damaged: its cell is of another search.");
  }
}

template <class Method>
class Searches
{
public:
  Searches(const ruc::CellContents& contents, const ruc::TwoPointProbability& target,
    const CellSearch::Settings& settings, const CellSearch::Callbacks& callbacks,
    RankCommunicator& ranks)
    : Contents(contents)
    , Target(target)
    , Settings(settings)
    , Callbacks(callbacks)
    , Ranks(ranks)
  {
  }

  std::vector<CellSearch::FoundCell> Run()
  {
    this->ReadCheckpoints();
    std::int64_t stopped = 0;
    for (Search& search : this->Rounds)
    {
      search.Begun = stopped == 0 || search.Found.IsShown;
      if (stopped == 0)
      {
        stopped = this->RunOne(search);
        this->Ranks.Sum(&stopped, 1);
      }
    }
    return this->Gather();
  }

private:
  // The cell that this rank works on in a round
  struct Search
  {
    int Number;
    std::unique_ptr<RankCommunicator> Group; // the ranks that work on it
    typename Method::Settings Settings;
    CheckpointFile File;
    std::optional<typename Method::State> State; // at first the one to resume from, then the last
    CellSearch::FoundCell Found;                 // from the file, if the search is shown as it was
    bool Begun;
  };

  // All groups must know what is wrong with any checkpoint before any of them begins
  void ReadCheckpoints()
  {
    std::string error;
    const int cells = this->Settings.NumberOfCells, ranks = this->Ranks.Size();
    for (int first = 0; first < cells; first += ranks)
    {
      const int group = this->Ranks.Rank() % std::min(cells - first, ranks);
      const int number = first + group;
      typename Method::Settings settings = Method::Of(this->Settings);
      settings.Seed += static_cast<std::uint32_t>(number);
      std::string name = this->Settings.CheckpointFile;
      if (cells > 1 && !name.empty())
      {
        name += "." + std::to_string(number + 1);
      }
      this->Rounds.push_back({ number, this->Ranks.Split(group), settings,
        CheckpointFile(name, this->Settings.CheckpointInterval), std::nullopt,
        NewCell(number, this->Target), false });
      Search& search = this->Rounds.back();
      try
      {
        const std::string bytes = search.File.Read(*search.Group);
        if (!bytes.empty())
        {
          this->TakeCheckpoint(search, bytes);
        }
      }
      catch (const std::invalid_argument& e)
      {
        error = error.empty() ? "CheckpointFile '" + name + "': " + e.what() : error;
      }
    }
    this->Ranks.ThrowIfAny(error);
  }

  void TakeCheckpoint(Search& search, const std::string& bytes) const
  {
    ruc::SearchStops stops;
    typename Method::State state = Method::Read(bytes, this->KeyOf(search), stops);
    if (!stops.BeforeState)
    {
      search.State = std::move(state);
    }
    const int passed = this->Settings.ContinueAfterStops;
    if (!stops.Shown.empty() && passed >= 0 && stops.Count > passed)
    {
      ruc::FromBytes(stops.Shown, search.Found);
      RequireFit(search.Found, this->Contents, this->Target);
      search.Found.Number = search.Number;
      search.Found.IsShown = true;
    }
    search.Found.Stops = stops.Count;
  }

  ruc::SearchKey KeyOf(const Search& search) const
  {
    return ruc::MakeKey(this->Contents, this->Target, search.Settings);
  }

  // Returns whether the search was stopped, now or before
  bool RunOne(Search& search)
  {
    RankSignal signal(this->Ranks);
    if (!search.Found.IsShown)
    {
      this->RunSearch(search, signal);
    }
    signal.Close(
      [&]()
      {
        return static_cast<int>(
          this->Callbacks.StopReason(search.Number, search.Found.Cell.Convergence.back()));
      });
    return ruc::IsFromOutside(search.Found.Cell.EndedBy);
  }

  void RunSearch(Search& search, RankSignal& signal)
  {
    const bool first = search.Group->Rank() == 0;
    const std::optional<typename Method::State> resume = std::move(search.State);
    search.State.reset();
    ruc::EndReason reason = ruc::EndReason::None;
    Method::Run(
      this->Contents, this->Target, search.Settings, *search.Group,
      [&](const ruc::SearchState& state)
      {
        // Some reasons are seen only on rank 0, which tells the others at once
        if (reason == ruc::EndReason::None)
        {
          const int heard = signal.Heard();
          reason = heard != 0 ? static_cast<ruc::EndReason>(heard)
                              : this->Callbacks.StopReason(search.Number, state);
          if (reason != ruc::EndReason::None && this->Ranks.Rank() == 0)
          {
            signal.Give(static_cast<int>(reason));
          }
        }
        return reason == ruc::EndReason::None;
      },
      resume ? &*resume : nullptr,
      [&](const typename Method::State& state)
      {
        if (first && search.File.IsWanted())
        {
          search.State = state;
          if (search.File.IsDue())
          {
            this->Write(search, state, { search.Found.Stops, false, {} });
          }
        }
      },
      search.Found);
    const bool stopped = search.Found.Cell.EndedBy == ruc::EndReason::Stopped;
    if (stopped)
    {
      search.Group->Broadcast(reason, search.Group->LowestRank(reason != ruc::EndReason::None));
      search.Found.Cell.EndedBy = reason;
      ++search.Found.Stops;
    }
    if (first && search.File.IsWanted() && (search.State || stopped))
    {
      const bool isNew = !search.State && !resume;
      this->Write(search,
        search.State ? *search.State
          : resume   ? *resume
                     : typename Method::State(),
        { search.Found.Stops, isNew, stopped ? ruc::ToBytes(search.Found) : std::string() });
    }
    search.State.reset();
  }

  void Write(Search& search, const typename Method::State& state, const ruc::SearchStops& stops)
  {
    const std::string error =
      search.File.Write(ruc::WriteCheckpoint(state, this->KeyOf(search), stops));
    if (!error.empty() && !this->Warned)
    {
      this->Warned = true;
      this->Callbacks.Warn("checkpoint not written, the last good one remains: " + error);
    }
  }

  // Returns the cells of all groups on every rank
  std::vector<CellSearch::FoundCell> Gather()
  {
    std::vector<CellSearch::FoundCell> all;
    for (int number = 0; number < this->Settings.NumberOfCells; ++number)
    {
      const Search& search = this->Rounds[number / this->Ranks.Size()];
      const bool own = search.Number == number && search.Group->Rank() == 0 && search.Begun;
      const int rank = this->Ranks.LowestRank(own);
      if (rank < this->Ranks.Size()) // otherwise the cell was not begun
      {
        all.push_back(search.Found);
        this->Ranks.Broadcast(all.back(), rank);
      }
    }
    return all;
  }

  const ruc::CellContents& Contents;
  const ruc::TwoPointProbability& Target;
  const CellSearch::Settings& Settings;
  const CellSearch::Callbacks& Callbacks;
  RankCommunicator& Ranks;
  std::vector<Search> Rounds;
  bool Warned = false;
};
}

ruc::PopulationSettings CellSearch::Settings::FindPopulation() const
{
  ruc::PopulationSettings population =
    this->Method == HYBRID ? ruc::HybridOf(this->Annealed, this->Hybrid) : this->Annealed;
  static_cast<ruc::SearchSettings&>(population) = this->Gradient;
  return population;
}

void CellSearch::Settings::Check() const
{
  ruc::CheckRanges(*this);
  ruc::CheckRanges(this->Gradient);
  if (this->IsByPopulation())
  {
    ruc::CheckSettings(this->FindPopulation());
  }
}

std::size_t CellSearch::FindBest(const std::vector<FoundCell>& cells)
{
  const auto better = [](const FoundCell& a, const FoundCell& b)
  {
    const bool freeA = a.Cell.TooNear.IsNone(), freeB = b.Cell.TooNear.IsNone();
    return freeA != freeB ? freeA : a.Cell.Objective < b.Cell.Objective;
  };
  return std::min_element(cells.begin(), cells.end(), better) - cells.begin();
}

std::vector<CellSearch::FoundCell> CellSearch::Find(const ruc::CellContents& contents,
  const ruc::TwoPointProbability& target, const Settings& settings, const Callbacks& callbacks,
  RankCommunicator& ranks)
{
  if (!settings.IsByPopulation())
  {
    return Searches<ByGradient>(contents, target, settings, callbacks, ranks).Run();
  }
  ruc::RequireLoose(contents);
  return Searches<ByPopulation>(contents, target, settings, callbacks, ranks).Run();
}
