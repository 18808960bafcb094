// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Statistics/Sampling/FanLags.h"
#include "ruc/Statistics/ThirdOrder/ThirdOrderParameters.h"
#include "ruc/Statistics/ThirdOrder/ThreePointProbability.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ruc
{
/**
 * Counts the pairs of points of traced fans, one batch of throws after the other. A pair of
 * intervals of two rays is a rectangle of the (r1, r2) grid, which takes four corners in a table of
 * second differences. Each table is summed up once: for every batch where standard errors are
 * wanted, which need the counts of each batch, and else after all batches.
 */
class FanCounts
{
public:
  /**
   * Counts `triples`, which all differ and have s <= q, in up to `batches` batches. `lags` is kept
   * as a reference.
   */
  FanCounts(const FanLags& lags, const ThreePointGrid& grid, int modes,
    const std::vector<PhaseTriple>& triples, bool withErrors, std::int64_t batches);

  /**
   * Counts the fans from `first` on as a batch, once FanLags::Find knows their lags. Each batch is
   * counted by one rank.
   */
  void AddBatch(std::int64_t batch, const TracedFan* first, std::int64_t fans);

  /**
   * Returns the counts of all ranks, from `batches` batches with `throws` throws; `throwsSquares`
   * is the sum over batches of the squared number of throws. Nothing is left here. Collective.
   */
  ThreePointCounts Finish(
    std::int64_t batches, std::int64_t throws, std::int64_t throwsSquares, Communicator& ranks);

private:
  static constexpr int AnyPhase = -1;

  // The counts of a batch for one triple, or, in the last table, of the points in the region. Until
  // the batch is finished, it holds second differences.
  struct Table
  {
    int CentrePhase;
    int First, Second; // the lists of FanLags for the phases s and q
    std::vector<std::int32_t> Batch;

    bool IsSymmetric() const { return this->First == this->Second; }
  };

  void AddTriple(const PhaseTriple& phases, std::int64_t batches);
  void AddTable(int centrePhase, int first, int second);
  void AddPairs(const TracedFan& fan, Table& table, int t) const;
  void AddRectangles(
    const TracedFan& fan, int ray1, int list1, int ray2, int list2, std::int32_t* slice) const;
  void AddSlice(std::size_t table, int t, std::int64_t throws);
  void AddProducts(
    const std::int32_t* number, int t, std::int64_t throws, std::int64_t* products) const;
  void FindIntegrals(std::int64_t batch, std::int64_t throws);
  template <class Number>
  void FinishSlice(Number* numbers, bool symmetric, int t) const;
  void FinishSums(
    std::vector<std::int64_t>& sums, bool differences, bool symmetric, Communicator& ranks) const;

  const FanLags& Lags;
  ThreePointGrid Grid;
  ThirdOrderRule Rule;
  std::vector<Table> Tables; // one for each of Counts.Triples, and one for a region with a border
  ThreePointCounts Counts;
};
}
