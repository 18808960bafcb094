// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Reconstruction/GradientSearch.h"
#include "ruc/Reconstruction/Population/PopulationSearch.h"

#include <functional>
#include <string>
#include <tuple>
#include <vector>

class RankCommunicator;

/** The search for one or more cells with the same contents and target, and their checkpoints. */
namespace CellSearch
{
enum Methods
{
  GRADIENT = 0,
  ANNEALED_POPULATION = 1,
  HYBRID = 2
};

/** The most cells that one filter looks for. */
constexpr int MostCells = 10000;

/** The settings of all cells' searches. */
struct Settings
{
  int Method = GRADIENT;
  ruc::GradientSearchSettings Gradient; // its seed and target objective are those of every method
  ruc::PopulationSettings Annealed;
  ruc::HybridSettings Hybrid; // see ruc::HybridOf for what a hybrid has from Annealed
  int NumberOfCells = 1;      // cell n, counted from 0, has the seed of the settings plus n
  // The name of the file; for several cells it is followed by "." and n + 1. Empty means none
  std::string CheckpointFile;
  double CheckpointInterval = 60.0; // in seconds
  /**
   * A search goes on from its checkpoint after at most this many stops. A search that was stopped
   * more often is shown as it was. -1 means that it always goes on.
   */
  int ContinueAfterStops = 0;

  /**
   * See ruc::SearchSettings. These are the settings of this struct alone, without those of the
   * methods.
   */
  template <class Self, class Visit>
  static void VisitSearch(Self& self, Visit&& visit)
  {
    visit("Method", self.Method, ruc::Range::From(GRADIENT, HYBRID));
    visit("NumberOfCells", self.NumberOfCells, ruc::Range::From(1, MostCells));
    visit("CheckpointInterval", self.CheckpointInterval, ruc::Range::AtLeast(0));
    visit("ContinueAfterStops", self.ContinueAfterStops, ruc::Range::AtLeast(-1));
  }
  template <class Self, class Visit>
  static void VisitEnd(Self&, Visit&&)
  {
  }

  bool IsByPopulation() const { return this->Method != GRADIENT; }

  /**
   * Returns the settings of a search by population: those of the annealed population, or of the
   * hybrid.
   */
  ruc::PopulationSettings FindPopulation() const;

  /**
   * Throws std::invalid_argument for settings out of range. The settings of the populations are
   * checked only if the method has a population.
   */
  void Check() const;
};

/** A cell that was found. */
struct FoundCell
{
  int Number = 0; // counted from 0
  ruc::UnitCell Cell;
  // F2 of the first and the last population; for a gradient search, of the start and of the cell
  ruc::ObjectiveRange Before, After;
  int Stops = 0;        // how often its search has been ended from outside so far
  bool IsShown = false; // whether it is shown as it was when it was stopped, without a search

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Number, self.Cell, self.Before, self.After, self.Stops, self.IsShown);
  }
};

/**
 * Returns the place of the cell with the least F2, among those without overlap if there are any.
 */
std::size_t FindBest(const std::vector<FoundCell>& cells);

/** What the search asks and tells. */
struct Callbacks
{
  /**
   * Returns why the search should end now, or None to carry on. `cell` counts from 0. It is asked
   * on every rank; a reason that only rank 0 knows reaches the others through the search.
   */
  std::function<ruc::EndReason(int cell, const ruc::SearchState& state)> StopReason;
  /** Is told, once, that a checkpoint could not be written. */
  std::function<void(const std::string& text)> Warn;
};

/**
 * Finds all cells and returns them in order, the same on every rank and for any number of ranks.
 * They are found in rounds: one on each rank as long as there are at least as many left as ranks;
 * then the ranks form as many groups as there are cells left. When a cell of a round was stopped,
 * no other round begins, so that cells may be missing; there is at least one. EndedBy of a cell
 * that was stopped gives the reason.
 *
 * A search goes on from its checkpoint if the file exists, unless it was stopped more often than
 * ContinueAfterStops; then the cell is the one that it had when it was stopped, bit by bit. Throws
 * std::invalid_argument, the same on every rank, for a checkpoint that is not of this search, and
 * for a population of dense cells (ruc::RequireLoose). Collective.
 */
std::vector<FoundCell> Find(const ruc::CellContents& contents,
  const ruc::TwoPointProbability& target, const Settings& settings, const Callbacks& callbacks,
  RankCommunicator& ranks);
}
