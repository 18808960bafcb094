// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Sampling/FanSampling.h"

#include "ruc/Base/Text.h"
#include "ruc/Statistics/Results/LagLimit.h"
#include "ruc/Statistics/Sampling/FanCounts.h"
#include "ruc/Statistics/Sampling/FanLags.h"
#include "ruc/Tracing/RayFan.h"

#include <algorithm>
#include <stdexcept>

namespace ruc
{
namespace
{
// With 2^31 throws there are 2^21 batches, and with up to 2^9 rays no N_b exceeds 2^20, so that
// sums of squares stay below 2^61
constexpr int MostThrowsInBatch = 1024, FewestBatchesForErrors = 64, FewestBatchesForRanks = 16,
              MostFanLags = 20000;
constexpr std::int64_t MostThrows = std::int64_t(1) << 31;

// Returns the different triples, with s <= q
std::vector<PhaseTriple> Different(const std::vector<PhaseTriple>& triples)
{
  std::vector<PhaseTriple> different;
  for (const PhaseTriple& triple : triples)
  {
    const PhaseTriple ordered = { triple.R, std::min(triple.S, triple.Q),
      std::max(triple.S, triple.Q) };
    if (std::find(different.begin(), different.end(), ordered) == different.end())
    {
      different.push_back(ordered);
    }
  }
  return different;
}

// Throws in batches, of which the last may be shorter
struct ThrowBatches
{
  explicit ThrowBatches(const FanSettings& settings)
    : Throws(settings.Throws)
  {
    const int fewest = settings.WithErrors ? FewestBatchesForErrors : FewestBatchesForRanks;
    this->Size =
      std::clamp<std::int64_t>((this->Throws + fewest - 1) / fewest, 1, MostThrowsInBatch);
    this->Number = (this->Throws + this->Size - 1) / this->Size;
  }

  // The throws of a batch are First to End - 1
  std::int64_t First(std::int64_t batch) const { return batch * this->Size; }
  std::int64_t End(std::int64_t batch) const
  {
    return std::min((batch + 1) * this->Size, this->Throws);
  }

  std::int64_t Throws, Size, Number;
};

// Packs the hits of a throw for another rank: their number, then four numbers for each
void Pack(const std::vector<RayHit>& hits, std::vector<double>& parcel)
{
  parcel.push_back(static_cast<double>(hits.size()));
  for (const RayHit& hit : hits)
  {
    parcel.insert(parcel.end(),
      { static_cast<double>(hit.Ray), hit.Sphere.In, hit.Sphere.Out,
        static_cast<double>(hit.Sphere.Mode) });
  }
}

// Appends what was packed, and returns what follows it
const double* Unpack(const double* number, std::vector<RayHit>& hits)
{
  for (auto left = static_cast<std::int64_t>(*number++); left > 0; --left, number += 4)
  {
    hits.push_back(
      { static_cast<int>(number[0]), { number[1], number[2], static_cast<int>(number[3]) } });
  }
  return number;
}

// Throws fans in rounds of one batch for each rank. All ranks trace them through their own spheres,
// and each counts its own batch.
class FanSampler
{
public:
  FanSampler(const SpherePack& own, int modes, const SamplingRegion& region,
    const ThreePointGrid& grid, const std::vector<PhaseTriple>& triples,
    const FanSettings& settings, Communicator& communicator)
    : Region(region)
    , Seed(settings.Seed)
    , Ranks(communicator)
    , Batches(settings)
    , Rays(grid.Directions)
    , Lags(region, this->Rays, grid.Lags, modes, triples)
    , Tracer(own, region.GetBounds(), this->Rays, this->Lags.Length())
    , Counts(this->Lags, grid, modes, Different(triples), settings.WithErrors, this->Batches.Number)
  {
  }

  ThreePointCounts Sample(const SamplingProgress& progress)
  {
    std::int64_t end = 0, taken = 0, squares = 0;
    for (bool goOn = true; goOn && end < this->Batches.Number;)
    {
      const std::int64_t first = end;
      end = std::min<std::int64_t>(first + this->Ranks.Size(), this->Batches.Number);
      taken = this->Batches.End(end - 1);
      this->Trace(first, end);
      this->Gather(first, end);
      this->CountOwn(first, end);
      for (std::int64_t batch = first; batch < end; ++batch)
      {
        const std::int64_t throws = this->Batches.End(batch) - this->Batches.First(batch);
        squares += throws * throws;
      }
      goOn = this->Ranks.All(!progress ||
        progress(static_cast<double>(taken) / this->Batches.Throws, Text(taken, " throws")));
    }
    return this->Counts.Finish(end, taken, squares, this->Ranks);
  }

private:
  // Traces the batches first to end - 1, one for each rank, through the spheres of this rank
  void Trace(std::int64_t first, std::int64_t end)
  {
    const std::int64_t sample = this->Batches.First(first);
    const std::int64_t throws = this->Batches.End(end - 1) - sample;
    this->Fans.resize(throws);
#pragma omp parallel for schedule(dynamic, 16)
    for (std::int64_t n = 0; n < throws; ++n)
    {
      TracedFan& fan = this->Fans[n];
      fan.Fan = RayFan::Random(this->Region, this->Seed, static_cast<std::uint32_t>(sample + n));
      fan.Hits.clear();
      this->Tracer.FindHits(fan.Fan, fan.Hits);
    }
  }

  // Calls visit(fan) for the fans in hand that a rank counts
  template <class Visit>
  void ForEachFanOf(int rank, Visit&& visit)
  {
    const auto fans = static_cast<std::int64_t>(this->Fans.size());
    const std::int64_t end = std::min((rank + 1) * this->Batches.Size, fans);
    for (std::int64_t n = rank * this->Batches.Size; n < end; ++n)
    {
      visit(this->Fans[n]);
    }
  }

  // Sends the hits of every throw to the rank that counts it
  void Gather(std::int64_t first, std::int64_t end)
  {
    const int own = this->Ranks.Rank(), size = this->Ranks.Size();
    if (size == 1)
    {
      return;
    }
    std::vector<std::vector<double>> parcels(size);
    for (int rank = 0; rank < end - first; ++rank)
    {
      if (rank != own)
      {
        this->ForEachFanOf(rank, [&](const TracedFan& fan) { Pack(fan.Hits, parcels[rank]); });
      }
    }
    parcels = this->Ranks.AllToAll(std::move(parcels));
    for (int rank = 0; own < end - first && rank < size; ++rank)
    {
      if (rank != own)
      {
        const double* number = parcels[rank].data();
        this->ForEachFanOf(own, [&](TracedFan& fan) { number = Unpack(number, fan.Hits); });
      }
    }
  }

  // Counts the batch of this rank, if it has one
  void CountOwn(std::int64_t first, std::int64_t end)
  {
    const std::int64_t batch = first + this->Ranks.Rank();
    if (batch >= end)
    {
      return;
    }
    TracedFan* fans = &this->Fans[this->Ranks.Rank() * this->Batches.Size];
    const std::int64_t throws = this->Batches.End(batch) - this->Batches.First(batch);
#pragma omp parallel
    {
      FanLags::Scratch scratch;
#pragma omp for schedule(dynamic, 16)
      for (std::int64_t n = 0; n < throws; ++n)
      {
        this->Lags.Find(fans[n], scratch);
      }
    }
    this->Counts.AddBatch(batch, fans, throws);
  }

  const SamplingRegion& Region;
  const std::uint32_t Seed;
  Communicator& Ranks;
  const ThrowBatches Batches;
  const RayDirections Rays;
  const FanLags Lags;
  const FanTracer Tracer;
  FanCounts Counts;
  std::vector<TracedFan> Fans; // those in hand
};
}

double EstimateFanMemory(
  const ThreePointGrid& grid, std::size_t triples, bool withErrors, bool bounded)
{
  // Each triple, and the points in the region, have a batch in 32 bits and sums in 64
  const double sums = 4.0 + 8.0 * (withErrors ? 3 : 1), inside = 4.0 + 8.0 * (withErrors ? 2 : 1);
  return static_cast<double>(grid.Size()) * (triples * sums + (bounded ? inside : 0.0));
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
  require(!settings.WithErrors || settings.Throws >= 2,
    "NumberOfThrows requires a number >= 2, without which no standard error is known",
    settings.Throws);
  require(grid.Directions >= 2 && grid.Directions <= MostFanDirections,
    "NumberOfDirections requires a number from 2 to 512", grid.Directions);
  require(grid.Lags.Count >= 1 && grid.Lags.Count <= MostFanLags,
    "NumberOfLags requires a number from 1 to 20000", grid.Lags.Count);
  LagLimit::ForFans(region.GetShape(), region.GetShape()).Check(grid.Lags);
}

ThreePointProbability SampleFans(const SpherePack& own, int modes, const SamplingRegion& region,
  const ThreePointGrid& grid, const std::vector<PhaseTriple>& triples, const FanSettings& settings,
  Communicator& communicator, const SamplingProgress& progress)
{
  CheckFans(region, grid, settings);
  return ThreePointProbability(
    FanSampler(own, modes, region, grid, triples, settings, communicator).Sample(progress),
    triples);
}

namespace
{
constexpr double SecondsPerRayHit = 3.5e-7;
constexpr double SecondsPerPairOfIntervals = 1.4e-9; // on two rays of a fan
constexpr double SecondsPerGridEntry = 1e-9;         // for an entry of S_rsq in a batch
constexpr int FewestBatchesOfFans = 32;
}

Estimate EstimateFans(const PackFigures& pack, const ThreePointGrid& grid, std::size_t triples,
  bool withErrors, double throws)
{
  const double rays = grid.Directions;
  const double hits = pack.HitsOn(grid.Lags.Maximum());
  // The number of intervals of a phase on a ray; every pair of rays counts once
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
