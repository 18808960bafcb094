// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Sampling/FanSampling.h"

#include "ruc/Base/Text.h"
#include "ruc/Statistics/Results/LagLimit.h"
#include "ruc/Tracing/PhaseChanges.h"
#include "ruc/Tracing/RayFan.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ruc
{
namespace
{
// At 2^31 throws there are 2^21 batches, and with up to 2^9 rays no N_b exceeds 2^20: sums of
// squares stay below 2^61
constexpr int MostThrowsInBatch = 1024, FewestBatchesForErrors = 64, FewestBatchesForRanks = 16,
              MostFanLags = 20000;
constexpr std::int64_t MostThrows = std::int64_t(1) << 31;

// A fan traced: which lags of its rays lie in the phases that play a part. Along a ray a phase
// begins at the first lag of its list and ends before the second, and so on; an end beyond the last
// lag of all is left out.
struct Throw
{
  RayFan Fan;
  std::vector<RayHit> Hits;
  int Phase = 0; // of the centre
  std::vector<std::int32_t> Lags;
  std::vector<std::int32_t> Begin; // in Lags of the list of a ray and a phase, and the end
};

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

double EstimateFanMemory(
  const ThreePointGrid& grid, std::size_t triples, bool withErrors, bool bounded)
{
  // A batch in 32 bits and the sums in 64, of every triple and of the points in the region
  const double sums = 4.0 + 8.0 * (withErrors ? 3 : 1), inside = 4.0 + 8.0 * (withErrors ? 2 : 1);
  return static_cast<double>(grid.Size()) * (triples * sums + (bounded ? inside : 0.0));
}

namespace
{
class FanSampler
{
public:
  FanSampler(const SpherePack& own, int modes, const SamplingRegion& region,
    const ThreePointGrid& grid, const std::vector<PhaseTriple>& triples,
    const FanSettings& settings, Communicator& communicator)
    : Region(region)
    , Modes(modes)
    , Grid(grid)
    , Settings(settings)
    , Ranks(communicator)
    , Rays(grid.Directions)
    // Half a spacing more, so that the last lag is on every ray
    , Length((grid.Lags.Count + 0.5) * grid.Lags.Spacing)
    , Tracer(own, region.GetBounds(), this->Rays, this->Length)
    , Rule(grid)
    , ListOfPhase(modes + 1, -1)
  {
    this->Counts.Modes = modes;
    this->Counts.Grid = grid;
    this->Counts.WithErrors = settings.WithErrors;
    this->Counts.Throws = settings.Throws;
    const int fewest = settings.WithErrors ? FewestBatchesForErrors : FewestBatchesForRanks;
    this->ThrowsInBatch =
      std::clamp<std::int64_t>((settings.Throws + fewest - 1) / fewest, 1, MostThrowsInBatch);
    this->Counts.Batches = (settings.Throws + this->ThrowsInBatch - 1) / this->ThrowsInBatch;
    for (const PhaseTriple& triple : triples)
    {
      this->AddTable({ triple.R, std::min(triple.S, triple.Q), std::max(triple.S, triple.Q) });
    }
    if (this->IsBounded())
    {
      this->Tables.push_back(this->NewTable(AnyPhase, this->Lists, this->Lists));
      this->Allocate(this->Counts.Inside, true);
      this->Allocate(this->Counts.InsideSquares, settings.WithErrors);
      ++this->Lists;
    }
  }

  ThreePointCounts Count(const SamplingProgress& progress)
  {
    for (std::int64_t first = 0; first < this->Counts.Batches; first += this->Ranks.Size())
    {
      const std::int64_t end =
        std::min<std::int64_t>(first + this->Ranks.Size(), this->Counts.Batches);
      this->Trace(first, end);
      this->Gather(end - first);
      if (first + this->Ranks.Rank() < end)
      {
        this->CountBatch(first);
      }
      const std::int64_t taken = std::min(end * this->ThrowsInBatch, this->Counts.Throws);
      if (!this->Ranks.All(!progress ||
            progress(static_cast<double>(taken) / this->Counts.Throws, Text(taken, " throws"))))
      {
        this->EndAfter(end, taken);
      }
    }
    this->Finish();
    return std::move(this->Counts);
  }

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

  bool IsBounded() const { return !this->Region.IsFullyPeriodic(); }

  void Allocate(std::vector<std::int64_t>& sums, bool wanted) const
  {
    sums.assign(wanted ? this->Grid.Size() : 0, 0);
  }

  Table NewTable(int centrePhase, int first, int second) const
  {
    return { centrePhase, first, second, std::vector<std::int32_t>(this->Grid.Size(), 0) };
  }

  int ListOf(int phase)
  {
    int& list = this->ListOfPhase[phase];
    list = list < 0 ? this->Lists++ : list;
    return list;
  }

  void AddTable(const PhaseTriple& phases)
  {
    for (const ThreePointCounts::Triple& known : this->Counts.Triples)
    {
      if (known.Phases == phases)
      {
        return;
      }
    }
    ThreePointCounts::Triple counted = { phases, {}, {}, {}, {} };
    this->Allocate(counted.Sum, true);
    this->Allocate(counted.Squares, this->Settings.WithErrors);
    this->Allocate(counted.Products, this->Settings.WithErrors);
    if (this->Settings.WithErrors && phases.R == phases.S && phases.S == phases.Q)
    {
      counted.Integrals.assign(this->Counts.Batches, { 0.0, 0.0, 0.0 });
    }
    this->Counts.Triples.push_back(std::move(counted));
    this->Tables.push_back(
      this->NewTable(phases.R, this->ListOf(phases.S), this->ListOf(phases.Q)));
  }

  std::int64_t ThrowsOf(std::int64_t batch) const
  {
    return std::min(this->ThrowsInBatch, this->Counts.Throws - batch * this->ThrowsInBatch);
  }

  RayFan FanOf(std::int64_t sample) const
  {
    return RayFan::Random(this->Region, this->Settings.Seed, static_cast<std::uint32_t>(sample));
  }

  void EndAfter(std::int64_t batches, std::int64_t throws)
  {
    this->Counts.Batches = batches;
    this->Counts.Throws = throws;
    for (ThreePointCounts::Triple& triple : this->Counts.Triples)
    {
      triple.Integrals.resize(triple.Integrals.empty() ? 0 : batches, { 0.0, 0.0, 0.0 });
    }
  }

  // Batches first to end - 1, one for each rank, through the spheres of this rank
  void Trace(std::int64_t first, std::int64_t end)
  {
    this->Throws.resize((end - 1 - first) * this->ThrowsInBatch + this->ThrowsOf(end - 1));
    const auto throws = static_cast<std::int64_t>(this->Throws.size());
#pragma omp parallel for schedule(dynamic, 16)
    for (std::int64_t n = 0; n < throws; ++n)
    {
      Throw& thrown = this->Throws[n];
      thrown.Fan = this->FanOf(first * this->ThrowsInBatch + n);
      thrown.Hits.clear();
      this->Tracer.FindHits(thrown.Fan, thrown.Hits);
    }
    for (std::int64_t batch = first; batch < end; ++batch)
    {
      this->Counts.ThrowsSquares += this->ThrowsOf(batch) * this->ThrowsOf(batch);
    }
  }

  // The throws in hand that a rank counts
  template <class Visit>
  void ForEachThrowOf(int rank, Visit&& visit)
  {
    const auto throws = static_cast<std::int64_t>(this->Throws.size());
    const std::int64_t end = std::min((rank + 1) * this->ThrowsInBatch, throws);
    for (std::int64_t n = rank * this->ThrowsInBatch; n < end; ++n)
    {
      visit(this->Throws[n]);
    }
  }

  // Sends the hits of a throw to the rank that counts it: their number, then four numbers each
  void Gather(std::int64_t batches)
  {
    const int own = this->Ranks.Rank(), size = this->Ranks.Size();
    if (size == 1)
    {
      return;
    }
    std::vector<std::vector<double>> parcels(size);
    for (int rank = 0; rank < batches; ++rank)
    {
      if (rank != own)
      {
        this->ForEachThrowOf(rank,
          [&](const Throw& thrown)
          {
            parcels[rank].push_back(static_cast<double>(thrown.Hits.size()));
            for (const RayHit& hit : thrown.Hits)
            {
              parcels[rank].insert(parcels[rank].end(),
                { static_cast<double>(hit.Ray), hit.Sphere.In, hit.Sphere.Out,
                  static_cast<double>(hit.Sphere.Mode) });
            }
          });
      }
    }
    parcels = this->Ranks.Exchange(std::move(parcels));
    for (int rank = 0; own < batches && rank < size; ++rank)
    {
      if (rank != own)
      {
        const double* number = parcels[rank].data();
        this->ForEachThrowOf(own,
          [&](Throw& thrown)
          {
            for (auto left = static_cast<std::int64_t>(*number++); left > 0; --left, number += 4)
            {
              thrown.Hits.push_back({ static_cast<int>(number[0]),
                { number[1], number[2], static_cast<int>(number[3]) } });
            }
          });
      }
    }
  }

  // What a thread needs for one ray after the other
  struct Scratch
  {
    std::vector<std::vector<SphereHit>> Hits; // of every ray
    std::vector<LineInterval> Inside;
    std::vector<PhaseChange> Changes;
  };

  void FindLags(Throw& thrown, Scratch& scratch) const
  {
    scratch.Hits.resize(this->Grid.Directions);
    for (std::vector<SphereHit>& hits : scratch.Hits)
    {
      hits.clear();
    }
    for (const RayHit& hit : thrown.Hits)
    {
      scratch.Hits[hit.Ray].push_back(hit.Sphere);
    }
    thrown.Lags.clear();
    thrown.Begin.assign(1, 0);
    const auto endList = [&]()
    { thrown.Begin.push_back(static_cast<std::int32_t>(thrown.Lags.size())); };
    for (int ray = 0; ray < this->Grid.Directions; ++ray)
    {
      scratch.Inside.assign(1, { 0.0, this->Length });
      if (this->IsBounded())
      {
        this->Region.Clip(
          thrown.Fan.Centre, this->Rays.Of(thrown.Fan, ray), this->Length, scratch.Inside);
      }
      FindPhaseChanges(scratch.Hits[ray], scratch.Inside, this->Modes, scratch.Changes);
      this->FindLagsOfPhases(scratch.Changes, thrown, endList);
      if (this->IsBounded())
      {
        for (const LineInterval& inside : scratch.Inside)
        {
          this->AddLags(this->FirstLag(inside.Begin), this->FirstLag(inside.End), thrown);
        }
        endList();
      }
    }
  }

  template <class EndList>
  void FindLagsOfPhases(
    const std::vector<PhaseChange>& changes, Throw& thrown, EndList&& endList) const
  {
    for (int list = 0; list < this->ListsOfPhases(); ++list)
    {
      for (std::size_t n = 0; n + 1 < changes.size(); ++n)
      {
        const int phase = changes[n].After;
        if (phase <= this->Modes && this->ListOfPhase[phase] == list)
        {
          this->AddLags(
            this->FirstLag(changes[n].Position), this->FirstLag(changes[n + 1].Position), thrown);
        }
      }
      endList();
    }
    for (std::size_t n = 0; n + 1 < changes.size() && changes[n].Position <= 0.0; ++n)
    {
      thrown.Phase = changes[n].After;
    }
  }

  int ListsOfPhases() const
  {
    return this->Lists - (this->IsBounded() ? 1 : 0);
  }

  // The first lag at or after a position on a ray, at most one beyond the last
  int FirstLag(double position) const
  {
    const double lag = std::ceil(position / this->Grid.Lags.Spacing);
    return static_cast<int>(std::clamp(lag, 0.0, static_cast<double>(this->Grid.Points())));
  }

  void AddLags(int begin, int end, Throw& thrown) const
  {
    if (begin < end)
    {
      thrown.Lags.push_back(begin);
      if (end < this->Grid.Points())
      {
        thrown.Lags.push_back(end);
      }
    }
  }

  // The batch of this rank, of those from `first` on
  void CountBatch(std::int64_t first)
  {
    const std::int64_t batch = first + this->Ranks.Rank();
    const std::int64_t from = this->Ranks.Rank() * this->ThrowsInBatch;
    const std::int64_t to = from + this->ThrowsOf(batch);
    const int angles = this->Grid.Angles();
    const auto slices = static_cast<std::int64_t>(this->Tables.size()) * angles;
#pragma omp parallel
    {
      Scratch scratch;
#pragma omp for schedule(dynamic, 16)
      for (std::int64_t n = from; n < to; ++n)
      {
        this->FindLags(this->Throws[n], scratch);
      }
#pragma omp for schedule(dynamic)
      for (std::int64_t n = 0; n < slices; ++n)
      {
        Table& table = this->Tables[n / angles];
        const int t = static_cast<int>(n % angles);
        for (std::int64_t thrown = from; thrown < to; ++thrown)
        {
          if (table.CentrePhase == AnyPhase || table.CentrePhase == this->Throws[thrown].Phase)
          {
            this->AddPairs(this->Throws[thrown], table, t);
          }
        }
        if (this->Settings.WithErrors)
        {
          this->FinishSlice(table.Batch.data(), table.IsSymmetric(), t);
        }
      }
#pragma omp for schedule(dynamic)
      for (std::int64_t n = 0; n < slices; ++n)
      {
        this->AddSlice(n / angles, static_cast<int>(n % angles), to - from);
      }
    }
    this->FindIntegrals(batch, to - from);
    for (Table& table : this->Tables)
    {
      std::fill(table.Batch.begin(), table.Batch.end(), 0);
    }
  }

  // The pairs of rays of a throw at the angle t. Where both points have one phase, the pairs of two
  // different rays are half of all; the other half is their transpose.
  void AddPairs(const Throw& thrown, Table& table, int t) const
  {
    const int rays = this->Grid.Directions;
    const bool opposite = 2 * t == rays;
    std::int32_t* slice = table.Batch.data() + t * this->Grid.SliceSize();
    for (int i = 0; i < (table.IsSymmetric() && opposite ? rays / 2 : rays); ++i)
    {
      const int j = i + t < rays ? i + t : i + t - rays;
      this->AddRectangles(thrown, i, table.First, j, table.Second, slice);
      if (!table.IsSymmetric() && t > 0 && !opposite)
      {
        this->AddRectangles(thrown, j, table.First, i, table.Second, slice);
      }
    }
  }

  // Every pair of intervals is a rectangle, whose corners have the signs + - - +
  void AddRectangles(
    const Throw& thrown, int ray1, int list1, int ray2, int list2, std::int32_t* slice) const
  {
    const std::int32_t* begin1 = &thrown.Begin[ray1 * this->Lists + list1];
    const std::int32_t* begin2 = &thrown.Begin[ray2 * this->Lists + list2];
    const std::int32_t* lags = thrown.Lags.data();
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

  // From second differences to counts
  template <class Number>
  void FinishSlice(Number* numbers, bool symmetric, int t) const
  {
    Number* slice = numbers + t * this->Grid.SliceSize();
    SumUp(slice, this->Grid.Points());
    if (symmetric && t > 0)
    {
      AddTransposed(slice, this->Grid.Points());
    }
  }

  // Adds a slice of a batch to the sums
  void AddSlice(std::size_t n, int t, std::int64_t throws)
  {
    const std::size_t size = this->Grid.SliceSize(), begin = t * size;
    const std::int32_t* number = &this->Tables[n].Batch[begin];
    const bool isInside = n == this->Counts.Triples.size();
    ThreePointCounts::Triple* triple = isInside ? nullptr : &this->Counts.Triples[n];
    std::int64_t* sum = isInside ? &this->Counts.Inside[begin] : &triple->Sum[begin];
    for (std::size_t place = 0; place < size; ++place)
    {
      sum[place] += number[place];
    }
    if (!this->Settings.WithErrors)
    {
      return;
    }
    std::int64_t* squares = isInside ? &this->Counts.InsideSquares[begin] : &triple->Squares[begin];
    for (std::size_t place = 0; place < size; ++place)
    {
      squares[place] += std::int64_t(number[place]) * number[place];
    }
    if (isInside)
    {
      return;
    }
    const std::int32_t* inside = this->IsBounded() ? &this->Tables.back().Batch[begin] : nullptr;
    const std::int64_t all = throws * this->Grid.RayPairs(t);
    for (std::size_t place = 0; place < size; ++place)
    {
      triple->Products[begin + place] += number[place] * (inside ? inside[place] : all);
    }
  }

  // What third-order parameters are made of, of a batch by itself
  void FindIntegrals(std::int64_t batch, std::int64_t throws)
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
        return this->IsBounded()
          ? this->Tables.back().Batch[place]
          : throws * this->Grid.RayPairs(static_cast<int>(place / this->Grid.SliceSize()));
      };
      const double fraction = number[0] / denominator(0);
      // Where a batch knows nothing, far apart, points are independent
      const double apart = fraction * fraction * fraction;
      integrals[batch] = this->Rule.Integrate(fraction,
        [&](std::size_t place)
        {
          const double all = denominator(place);
          return all > 0.0 ? number[place] / all : apart;
        });
    }
  }

  void Finish()
  {
    const bool differences = !this->Settings.WithErrors;
    for (std::size_t n = 0; n < this->Tables.size(); ++n)
    {
      std::vector<std::int32_t>().swap(this->Tables[n].Batch);
      const bool symmetric = this->Tables[n].IsSymmetric();
      if (n == this->Counts.Triples.size())
      {
        this->FinishSums(this->Counts.Inside, differences, symmetric);
        this->FinishSums(this->Counts.InsideSquares, false, symmetric);
        continue;
      }
      ThreePointCounts::Triple& triple = this->Counts.Triples[n];
      this->FinishSums(triple.Sum, differences, symmetric);
      this->FinishSums(triple.Squares, false, symmetric);
      this->FinishSums(triple.Products, false, symmetric);
      // Every batch was one rank's
      static_assert(sizeof(ThirdOrderIntegrals) == 3 * sizeof(double));
      this->Ranks.Share(
        reinterpret_cast<double*>(triple.Integrals.data()), 3 * triple.Integrals.size());
    }
  }

  void FinishSums(std::vector<std::int64_t>& sums, bool differences, bool symmetric)
  {
    this->Ranks.Sum(sums.data(), sums.size());
    for (int t = 0; differences && t < this->Grid.Angles(); ++t)
    {
      this->FinishSlice(sums.data(), symmetric, t);
    }
  }

  const SamplingRegion& Region;
  int Modes;
  ThreePointGrid Grid;
  FanSettings Settings;
  Communicator& Ranks;
  RayDirections Rays;
  double Length;
  FanTracer Tracer;
  ThirdOrderRule Rule;
  std::vector<int> ListOfPhase; // -1 for phases that play no part
  int Lists = 0;                // on every ray; with a border the last is of the region
  std::int64_t ThrowsInBatch;
  std::vector<Table> Tables; // of Counts.Triples; with a border the last is of the region
  std::vector<Throw> Throws; // in hand
  ThreePointCounts Counts;
};
}

void CheckFans(
  const SamplingRegion& region, const ThreePointGrid& grid, const FanSettings& settings)
{
  const auto require = [](bool good, const char* what, auto got)
  {
    if (!good)
    {
      throw std::invalid_argument(Text(what, ", got ", got, "."));
    }
  };
  require(settings.Throws >= 1 && settings.Throws <= MostThrows,
    "NumberOfThrows requires a number from 1 to 2147483648", settings.Throws);
  require(grid.Directions >= 2 && grid.Directions <= MostFanDirections,
    "NumberOfDirections requires a number from 2 to 512", grid.Directions);
  require(grid.Lags.Count >= 1 && grid.Lags.Count <= MostFanLags,
    "NumberOfLags requires a number from 1 to 20000", grid.Lags.Count);
  LagLimit::ForFans(region.GetShape(), region.GetShape()).Check(grid.Lags.Maximum());
}

ThreePointProbability SampleFans(const SpherePack& own, int modes, const SamplingRegion& region,
  const ThreePointGrid& grid, const std::vector<PhaseTriple>& triples, const FanSettings& settings,
  Communicator& communicator, const SamplingProgress& progress)
{
  CheckFans(region, grid, settings);
  return ThreePointProbability(
    FanSampler(own, modes, region, grid, triples, settings, communicator).Count(progress), triples);
}

namespace
{
constexpr double SecondsPerRayHit = 3.5e-7;
constexpr double SecondsPerPairOfIntervals = 1.4e-9; // on two rays of a fan
constexpr double SecondsPerGridEntry = 1e-9;         // of S_rsq, a batch
constexpr int FewestBatchesOfFans = 32;
}

Estimate EstimateFans(const PackFigures& pack, const ThreePointGrid& grid, std::size_t triples,
  bool withErrors, double throws)
{
  const double rays = grid.Directions;
  const double hits = pack.HitsOn(grid.Lags.Maximum());
  // Intervals of a phase on a ray; the rays of a pair at every angle once
  const double intervals = hits + 1.0;
  const double ofThrow = rays * hits * SecondsPerRayHit +
    static_cast<double>(triples) * 0.5 * rays * rays * intervals * intervals *
      SecondsPerPairOfIntervals;
  const double tables = static_cast<double>(grid.Size()) * (triples + 1.0);
  return { throws * ofThrow + FewestBatchesOfFans * tables * SecondsPerGridEntry,
    EstimateFanMemory(grid, triples, withErrors, true) / BytesOfMegabyte,
    8.0 * static_cast<double>(grid.Size()) * triples * (withErrors ? 2 : 1) / BytesOfMegabyte };
}
}
