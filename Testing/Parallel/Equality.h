// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Helpers of the claim that every filter gives the same bits whatever the number of ranks, and
 * however the pack is spread over them: each rank compares what all ranks work out together with
 * what it works out alone.
 */
#pragma once

#include "Packs.h"
#include "Ranks.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"

#include <gtest/gtest.h>

#include <string>

/**
 * All numbers of a data set but those of the array EstimatedMemory, which is the memory of a rank.
 */
std::vector<double> Numbers(vtkDataObject* data);

/** Whether numbers are equal bit by bit, where two values that are not numbers count as equal. */
bool Same(const std::vector<double>& a, const std::vector<double>& b);

/** Whether a data set has neither points nor rows. */
bool IsEmpty(vtkDataObject* data);

/**
 * Expects that one output on all ranks, `got`, is that of this rank alone. Every rank has a slab of
 * an image; everything else is whole on rank 0 and empty on the others.
 */
void ExpectSameOutput(vtkDataObject* got, vtkDataObject* expected);

/**
 * Expects that the points and radii of the ranks, one rank after the other, are those of this rank
 * alone.
 */
void ExpectSamePieces(vtkDataObject* got, vtkDataObject* expected);

/**
 * Returns the rows of `width` numbers that all ranks have, or this rank alone, in ascending order.
 * Numbers that are NaN count as -1.
 */
std::vector<std::vector<double>> SortedRows(
  std::vector<double> own, std::size_t width, bool onAllRanks);

/** The pack of a test: with few or many sizes of spheres, in a window that is periodic or not. */
class EveryPack : public testing::TestWithParam<std::tuple<bool, bool>>
{
public:
  static bool HasFewSizes() { return std::get<0>(GetParam()); }
  static bool IsPeriodic() { return std::get<1>(GetParam()); }
  static const ruc::SpherePack& Pack() { return HasFewSizes() ? FewSizes() : ManySizes(); }
  /** The whole pack, on this rank. */
  static vtkSmartPointer<vtkPolyData> Whole();
};
#define INSTANTIATE_EVERY_PACK(Suite)                                                              \
  INSTANTIATE_TEST_SUITE_P(, Suite, testing::Combine(testing::Bool(), testing::Bool()),            \
    [](const auto& info)                                                                           \
    {                                                                                              \
      return std::string(std::get<0>(info.param) ? "FewSizes" : "ManySizes") +                     \
        (std::get<1>(info.param) ? "Periodic" : "Block");                                          \
    })

/** A way to spread a pack over the ranks. */
struct Spread
{
  const char* Name;
  std::function<bool(std::size_t)> IsMine;
};
/** All spheres on the last rank; in turn; backwards, with rank 0 empty where there are others. */
std::vector<Spread> Spreads();

/**
 * Runs a filter on the pack of the test, alone and then together with the pack spread in every way,
 * and expects the same outputs.
 *
 * `emptyPorts` are the outputs without points and rows; all others must have some. `pointPorts` are
 * those that stay where their spheres are.
 */
template <class Filter>
void ExpectSame(const std::function<void(Filter*)>& configure,
  const std::vector<int>& emptyPorts = {}, const std::vector<int>& pointPorts = {},
  bool withMask = false)
{
  const auto run = [&](vtkPolyData* pack, bool onAllRanks)
  {
    auto filter = vtkSmartPointer<Filter>::New();
    configure(filter);
    if (!onAllRanks)
    {
      filter->SetController(nullptr);
    }
    filter->SetInputDataObject(0, pack);
    if (withMask)
    {
      filter->SetInputDataObject(
        1, onAllRanks ? MakeMask(Edge, Rank(), NumberOfRanks()) : MakeMask(Edge, 0, 1));
    }
    filter->Update();
    return filter;
  };
  const auto has = [](const std::vector<int>& ports, int port)
  { return std::find(ports.begin(), ports.end(), port) != ports.end(); };

  const auto alone = run(EveryPack::Whole(), false);
  for (const Spread& spread : Spreads())
  {
    SCOPED_TRACE(spread.Name);
    const auto together =
      run(MakePolyData(EveryPack::Pack(), Edge, EveryPack::IsPeriodic(), spread.IsMine), true);
    for (int port = 0; port < alone->GetNumberOfOutputPorts(); ++port)
    {
      SCOPED_TRACE("output " + std::to_string(port));
      vtkDataObject* expected = alone->GetOutputDataObject(port);
      EXPECT_EQ(IsEmpty(expected), has(emptyPorts, port));
      (has(pointPorts, port) ? ExpectSamePieces : ExpectSameOutput)(
        together->GetOutputDataObject(port), expected);
    }
  }
}
