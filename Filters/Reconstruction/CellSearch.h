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

struct Settings
{
  int Method = GRADIENT;
  ruc::GradientSearchSettings Gradient; // seed and target objective are those of every method
  ruc::PopulationSettings Annealed;
  ruc::HybridSettings Hybrid;       // the rest of a hybrid is as in Annealed
  int NumberOfCells = 1;            // cell n, from 0, has the seed of the settings plus n
  std::string CheckpointFile;       // of one cell; of several this is followed by "." and n + 1
  double CheckpointInterval = 60.0; // seconds
  /** A search goes on from its checkpoint after so many stops; one that was stopped more often is
   * shown as it was. -1: it always goes on. */
  int ContinueAfterStops = 0;

  /** As of ruc::SearchSettings; its own, without those of the methods. */
  template <class Self, class Visit>
  static void VisitSearch(Self& self, Visit&& visit)
  {
    visit("Method", self.Method, ruc::Range::From(GRADIENT, HYBRID));
    visit("NumberOfCells", self.NumberOfCells, ruc::Range::AtLeast(1));
    visit("CheckpointInterval", self.CheckpointInterval, ruc::Range::AtLeast(0));
    visit("ContinueAfterStops", self.ContinueAfterStops, ruc::Range::AtLeast(-1));
  }
  template <class Self, class Visit>
  static void VisitEnd(Self&, Visit&&)
  {
  }

  bool IsByPopulation() const { return this->Method != GRADIENT; }

  /** What a search by population is told: annealed, or the hybrid's. */
  ruc::PopulationSettings FindPopulation() const;

  /** Throws std::invalid_argument for settings out of range; those of other methods do not matter.
   */
  void Check() const;
};

struct FoundCell
{
  int Number = 0; // from 0
  ruc::UnitCell Cell;
  // F2 of the population before and after; of a gradient search that of the start and of the cell
  ruc::ObjectiveRange Before, After;
  int Stops = 0;        // how often its search was ended from outside so far
  bool IsShown = false; // as it was when it was stopped, without a search

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Number, self.Cell, self.Before, self.After, self.Stops, self.IsShown);
  }
};

/** The place of the cell with the least F2, among those without overlap if there are any. */
std::size_t FindBest(const std::vector<FoundCell>& cells);

/** What the search asks and tells. */
struct Callbacks
{
  /** Why the search should end now; None to carry on. `cell` counts from 0. Asked on every rank;
   * what only rank 0 knows reaches the others through it. */
  std::function<ruc::EndReason(int cell, const ruc::SearchState& state)> StopReason;
  /** That a checkpoint could not be written, once. */
  std::function<void(const std::string& text)> Warn;
};

/**
 * Collective: all cells in order, the same on every rank and for any number of ranks. They are
 * found in rounds: one on each rank as long as there are as many left as ranks, the rest in as many
 * groups of ranks. After a round in which one was stopped no other begins, so that cells may be
 * missing; there is at least one. EndedBy of a cell that was stopped is the reason.
 *
 * A search goes on from its checkpoint where the file is there, unless it was stopped more often
 * than ContinueAfterStops: then the cell is the one that it had when it was stopped, bit by bit.
 * Throws std::invalid_argument, the same on every rank, for a checkpoint that is not of this
 * search.
 */
std::vector<FoundCell> Find(const ruc::CellContents& contents,
  const ruc::TwoPointProbability& target, const Settings& settings, const Callbacks& callbacks,
  RankCommunicator& ranks);
}
