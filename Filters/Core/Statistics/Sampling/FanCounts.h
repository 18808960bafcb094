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
 * Counts the pairs of points of traced fans, a batch of throws after the other. A pair of intervals
 * of two rays is a rectangle of the (r1, r2) grid, four corners in a table of second differences,
 * which is summed up once: for every batch where standard errors are wanted, which need the counts
 * of each, and else at the end of all.
 */
class FanCounts
{
public:
  /** Counts `triples`, all different and with s <= q. `lags` is kept as a reference. */
  FanCounts(const FanLags& lags, const ThreePointGrid& grid, int modes,
    const std::vector<PhaseTriple>& triples, bool withErrors, std::int64_t batches);

  /** Counts the fans from `first` on, of which FanLags::Find knows the lags, as a batch. Each batch
   * is counted by one rank. */
  void AddBatch(std::int64_t batch, const TracedFan* first, std::int64_t fans);

  /** The counts of all ranks, `batches` of them with so many throws, and so many squared and
   * summed. Collective; nothing is left here. */
  ThreePointCounts Finish(
    std::int64_t batches, std::int64_t throws, std::int64_t throwsSquares, Communicator& ranks);

private:
  static constexpr int AnyPhase = -1;

  // The counts of a batch for one triple, or last of the points in the region. Until it is finished
  // it holds second differences.
  struct Table
  {
    int CentrePhase;
    int First, Second; // lists of the phases s and q
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
  std::vector<Table> Tables; // of Counts.Triples; with a border the last is of the region
  ThreePointCounts Counts;
};
}
