// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Sampling/FanCounts.h"

#include <algorithm>
#include <utility>

namespace ruc
{
namespace
{
template <class Number>
void SumUp(Number* slice, int points)
{
  for (int j = 0; j < points; ++j)
  {
    Number* row = slice + static_cast<std::size_t>(j) * points;
    for (int i = 1; i < points; ++i)
    {
      row[i] += row[i - 1];
    }
    for (int i = 0; j > 0 && i < points; ++i)
    {
      row[i] += row[i - points];
    }
  }
}

template <class Number>
void AddTransposed(Number* slice, int points)
{
  for (std::size_t j = 0; j < static_cast<std::size_t>(points); ++j)
  {
    for (std::size_t i = 0; i <= j; ++i)
    {
      const Number sum = slice[j * points + i] + slice[i * points + j];
      slice[j * points + i] = slice[i * points + j] = sum;
    }
  }
}
}

FanCounts::FanCounts(const FanLags& lags, const ThreePointGrid& grid, int modes,
  const std::vector<PhaseTriple>& triples, bool withErrors, std::int64_t batches)
  : Lags(lags)
  , Grid(grid)
  , Rule(grid)
{
  this->Counts.Modes = modes;
  this->Counts.Grid = grid;
  this->Counts.WithErrors = withErrors;
  for (const PhaseTriple& triple : triples)
  {
    this->AddTriple(triple, batches);
  }
  if (lags.IsBounded())
  {
    this->AddTable(AnyPhase, lags.ListOfRegion(), lags.ListOfRegion());
    this->Counts.Inside.assign(grid.Size(), 0);
    this->Counts.InsideSquares.assign(withErrors ? grid.Size() : 0, 0);
  }
}

void FanCounts::AddTriple(const PhaseTriple& phases, std::int64_t batches)
{
  const bool withErrors = this->Counts.WithErrors;
  ThreePointCounts::Triple counted = { phases, {}, {}, {}, {} };
  counted.Sum.assign(this->Grid.Size(), 0);
  counted.Squares.assign(withErrors ? this->Grid.Size() : 0, 0);
  counted.Products.assign(withErrors ? this->Grid.Size() : 0, 0);
  if (withErrors && phases.R == phases.S && phases.S == phases.Q)
  {
    counted.Integrals.assign(batches, { 0.0, 0.0, 0.0 });
  }
  this->Counts.Triples.push_back(std::move(counted));
  this->AddTable(phases.R, this->Lags.ListOf(phases.S), this->Lags.ListOf(phases.Q));
}

void FanCounts::AddTable(int centrePhase, int first, int second)
{
  this->Tables.push_back(
    { centrePhase, first, second, std::vector<std::int32_t>(this->Grid.Size(), 0) });
}

void FanCounts::AddBatch(std::int64_t batch, const TracedFan* first, std::int64_t fans)
{
  const int angles = this->Grid.Angles();
  const auto slices = static_cast<std::int64_t>(this->Tables.size()) * angles;
#pragma omp parallel
  {
#pragma omp for schedule(dynamic)
    for (std::int64_t n = 0; n < slices; ++n)
    {
      Table& table = this->Tables[n / angles];
      const int t = static_cast<int>(n % angles);
      for (const TracedFan* fan = first; fan < first + fans; ++fan)
      {
        if (table.CentrePhase == AnyPhase || table.CentrePhase == fan->Phase)
        {
          this->AddPairs(*fan, table, t);
        }
      }
      if (this->Counts.WithErrors)
      {
        this->FinishSlice(table.Batch.data(), table.IsSymmetric(), t);
      }
    }
#pragma omp for schedule(dynamic)
    for (std::int64_t n = 0; n < slices; ++n)
    {
      this->AddSlice(n / angles, static_cast<int>(n % angles), fans);
    }
  }
  this->FindIntegrals(batch, fans);
  for (Table& table : this->Tables)
  {
    std::fill(table.Batch.begin(), table.Batch.end(), 0);
  }
}

// Adds the pairs of rays of a throw at the angle t. Where both points have the same phase, the
// pairs of two different rays are half of all; the other half is their transpose.
void FanCounts::AddPairs(const TracedFan& fan, Table& table, int t) const
{
  const int rays = this->Grid.Directions;
  const bool opposite = 2 * t == rays;
  std::int32_t* slice = table.Batch.data() + t * this->Grid.SliceSize();
  for (int i = 0; i < (table.IsSymmetric() && opposite ? rays / 2 : rays); ++i)
  {
    const int j = i + t < rays ? i + t : i + t - rays;
    this->AddRectangles(fan, i, table.First, j, table.Second, slice);
    if (!table.IsSymmetric() && t > 0 && !opposite)
    {
      this->AddRectangles(fan, j, table.First, i, table.Second, slice);
    }
  }
}

// Adds a rectangle, whose corners have the signs + - - +, for every pair of intervals
void FanCounts::AddRectangles(
  const TracedFan& fan, int ray1, int list1, int ray2, int list2, std::int32_t* slice) const
{
  const int lists = this->Lags.Lists();
  const std::int32_t* begin1 = &fan.Begin[ray1 * lists + list1];
  const std::int32_t* begin2 = &fan.Begin[ray2 * lists + list2];
  const std::int32_t* lags = fan.Lags.data();
  std::int32_t sign2 = 1;
  for (std::int32_t b = begin2[0]; b < begin2[1]; ++b, sign2 = -sign2)
  {
    std::int32_t* row = slice + static_cast<std::size_t>(lags[b]) * this->Grid.Points();
    std::int32_t sign = sign2;
    for (std::int32_t a = begin1[0]; a < begin1[1]; ++a, sign = -sign)
    {
      row[lags[a]] += sign;
    }
  }
}

// Adds a slice of a batch to the sums
void FanCounts::AddSlice(std::size_t n, int t, std::int64_t throws)
{
  const std::size_t size = this->Grid.SliceSize(), begin = t * size;
  const std::int32_t* number = &this->Tables[n].Batch[begin];
  const bool isInside = n == this->Counts.Triples.size();
  std::int64_t* sum = isInside ? &this->Counts.Inside[begin] : &this->Counts.Triples[n].Sum[begin];
  for (std::size_t place = 0; place < size; ++place)
  {
    sum[place] += number[place];
  }
  if (!this->Counts.WithErrors)
  {
    return;
  }
  std::int64_t* squares =
    isInside ? &this->Counts.InsideSquares[begin] : &this->Counts.Triples[n].Squares[begin];
  for (std::size_t place = 0; place < size; ++place)
  {
    squares[place] += std::int64_t(number[place]) * number[place];
  }
  if (!isInside)
  {
    this->AddProducts(number, t, throws, &this->Counts.Triples[n].Products[begin]);
  }
}

// Adds N_b D_b for a slice
void FanCounts::AddProducts(
  const std::int32_t* number, int t, std::int64_t throws, std::int64_t* products) const
{
  const std::size_t size = this->Grid.SliceSize();
  const std::int32_t* inside =
    this->Lags.IsBounded() ? &this->Tables.back().Batch[t * size] : nullptr;
  const std::int64_t all = throws * this->Grid.RayPairs(t);
  for (std::size_t place = 0; place < size; ++place)
  {
    products[place] += number[place] * (inside ? inside[place] : all);
  }
}

// Finds what third-order parameters are made of for a batch by itself
void FanCounts::FindIntegrals(std::int64_t batch, std::int64_t throws)
{
  for (std::size_t n = 0; n < this->Counts.Triples.size(); ++n)
  {
    std::vector<ThirdOrderIntegrals>& integrals = this->Counts.Triples[n].Integrals;
    if (integrals.empty())
    {
      continue;
    }
    const std::vector<std::int32_t>& number = this->Tables[n].Batch;
    const auto denominator = [&](std::size_t place) -> double
    {
      return this->Lags.IsBounded()
        ? this->Tables.back().Batch[place]
        : throws * this->Grid.RayPairs(static_cast<int>(place / this->Grid.SliceSize()));
    };
    const double fraction = number[0] / denominator(0);
    // Where a batch has no points, which are then far apart, they are taken as independent
    const double apart = fraction * fraction * fraction;
    integrals[batch] = this->Rule.Integrate(fraction,
      [&](std::size_t place)
      {
        const double all = denominator(place);
        return all > 0.0 ? number[place] / all : apart;
      });
  }
}

ThreePointCounts FanCounts::Finish(
  std::int64_t batches, std::int64_t throws, std::int64_t throwsSquares, Communicator& ranks)
{
  this->Counts.Batches = batches;
  this->Counts.Throws = throws;
  this->Counts.ThrowsSquares = throwsSquares;
  const bool differences = !this->Counts.WithErrors;
  for (std::size_t n = 0; n < this->Tables.size(); ++n)
  {
    std::vector<std::int32_t>().swap(this->Tables[n].Batch);
    const bool symmetric = this->Tables[n].IsSymmetric();
    if (n == this->Counts.Triples.size())
    {
      this->FinishSums(this->Counts.Inside, differences, symmetric, ranks);
      this->FinishSums(this->Counts.InsideSquares, false, symmetric, ranks);
      continue;
    }
    ThreePointCounts::Triple& triple = this->Counts.Triples[n];
    this->FinishSums(triple.Sum, differences, symmetric, ranks);
    this->FinishSums(triple.Squares, false, symmetric, ranks);
    this->FinishSums(triple.Products, false, symmetric, ranks);
    triple.Integrals.resize(triple.Integrals.empty() ? 0 : batches, { 0.0, 0.0, 0.0 });
    static_assert(sizeof(ThirdOrderIntegrals) == 3 * sizeof(double));
    ranks.AllGatherInTurn(reinterpret_cast<double*>(triple.Integrals.data()),
      triple.Integrals.size(), [](std::size_t batch) { return 3 * batch; });
  }
  return std::move(this->Counts);
}

void FanCounts::FinishSums(
  std::vector<std::int64_t>& sums, bool differences, bool symmetric, Communicator& ranks) const
{
  ranks.Sum(sums.data(), sums.size());
  for (int t = 0; differences && t < this->Grid.Angles(); ++t)
  {
    this->FinishSlice(sums.data(), symmetric, t);
  }
}

// Turns second differences into counts
template <class Number>
void FanCounts::FinishSlice(Number* numbers, bool symmetric, int t) const
{
  Number* slice = numbers + t * this->Grid.SliceSize();
  SumUp(slice, this->Grid.Points());
  if (symmetric && t > 0)
  {
    AddTransposed(slice, this->Grid.Points());
  }
}
}
