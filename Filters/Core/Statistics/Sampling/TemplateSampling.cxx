// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Sampling/TemplateSampling.h"

#include "ruc/Tracing/RayFan.h"
#include "ruc/Tracing/SphereGrid.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace ruc
{
namespace
{
constexpr SampleNames Throws = { "NumberOfThrows", "throws" };
constexpr std::int32_t OutsideRegion = -1;
constexpr int ThrowsInBatch = 32;

Vector3 Wrapped(Vector3 point, const Window& box)
{
  for (int q = 0; q < 3; ++q)
  {
    point[q] -= box.Size[q] * std::floor((point[q] - box.Origin[q]) / box.Size[q]);
  }
  return point;
}

// The phases at all points of a run of throws: for each throw that of the centre, then those of
// each ray
class ThrownPoints
{
public:
  ThrownPoints(const SpherePack& own, int modes, const SamplingRegion& region, const LagGrid& lags)
    : Spheres(own, region.GetBounds())
    , Rays(NumberOfRays)
    , Modes(modes)
    , Region(region)
    , Lags(lags)
  {
  }

  std::size_t PointsOfThrow() const
  {
    return 1 + static_cast<std::size_t>(NumberOfRays) * this->Lags.Count;
  }

  // Collective
  void LookUp(std::uint32_t seed, std::int64_t first, std::int64_t count, Communicator& ranks)
  {
    this->First = first;
    this->Phases.resize(count * this->PointsOfThrow());
#pragma omp parallel for schedule(dynamic)
    for (std::int64_t n = 0; n < count; ++n)
    {
      const auto sample = static_cast<std::uint32_t>(first + n);
      this->LookUpFan(
        RayFan::Random(this->Region, seed, sample), &this->Phases[n * this->PointsOfThrow()]);
    }
    // The matrix is the highest phase, so that the minimum is what any rank finds there
    ranks.Minimum(this->Phases.data(), this->Phases.size());
  }

  // The phases of one of the throws that were looked up last
  const std::int32_t* Of(std::int64_t sample) const
  {
    return &this->Phases[(sample - this->First) * this->PointsOfThrow()];
  }

private:
  void LookUpFan(const RayFan& fan, std::int32_t* place) const
  {
    const Vector3& centre = fan.Centre;
    *place++ = this->PhaseAt(centre);
    for (int i = 0; i < NumberOfRays; ++i)
    {
      const Vector3 ray = this->Rays.Of(fan, i);
      for (int k = 1; k <= this->Lags.Count; ++k)
      {
        const double r = k * this->Lags.Spacing;
        *place++ =
          this->PhaseAt({ centre[0] + r * ray[0], centre[1] + r * ray[1], centre[2] + r * ray[2] });
      }
    }
  }

  std::int32_t PhaseAt(const Vector3& point) const
  {
    if (this->Region.IsFullyPeriodic())
    {
      return this->Spheres.LowestModeAt(Wrapped(point, this->Region.GetBounds()), this->Modes);
    }
    return this->Region.Contains(point) ? this->Spheres.LowestModeAt(point, this->Modes)
                                        : OutsideRegion;
  }

  const SphereGrid Spheres;
  const RayDirections Rays;
  const int Modes;
  const SamplingRegion& Region;
  const LagGrid Lags;
  std::int64_t First = 0;
  std::vector<std::int32_t> Phases;
};

// The number of points of a batch in every pair of phases, lag by lag. Rows that stay empty are not
// allocated.
class PairCounts
{
public:
  PairCounts(int phases, const LagGrid& lags)
    : Phases(phases)
    , Lags(lags)
    , Counts(static_cast<std::size_t>(phases) * phases)
    , Rows(this->Counts.size())
  {
  }

  void Clear()
  {
    for (std::vector<double>& row : this->Counts)
    {
      row.clear();
    }
  }

  void AddThrow(const std::int32_t* place)
  {
    const std::int32_t centre = *place++;
    this->Add(centre, centre, 0, NumberOfRays);
    for (int ray = 0; ray < NumberOfRays; ++ray)
    {
      for (int k = 1; k <= this->Lags.Count; ++k, ++place)
      {
        if (*place != OutsideRegion)
        {
          this->Add(centre, *place, k, 1.0);
        }
      }
    }
  }

  // The rows that SampledSums::AddBatch takes
  const std::vector<const double*>& GetRows()
  {
    for (std::size_t n = 0; n < this->Rows.size(); ++n)
    {
      this->Rows[n] = this->Counts[n].empty() ? nullptr : this->Counts[n].data();
    }
    return this->Rows;
  }

private:
  void Add(int r, int s, int k, double number)
  {
    std::vector<double>& row = this->Counts[static_cast<std::size_t>(r) * this->Phases + s];
    if (row.empty())
    {
      row.assign(this->Lags.Count + 1, 0.0);
    }
    row[k] += number;
  }

  const int Phases;
  const LagGrid Lags;
  std::vector<std::vector<double>> Counts;
  std::vector<const double*> Rows;
};

// Every rank counts every size-th batch
void CountBatches(const BatchRange& range, const ThrownPoints& points, int phases,
  const LagGrid& lags, const Communicator& ranks, SampledSums& sums)
{
#pragma omp parallel
  {
    PairCounts counts(phases, lags);
#pragma omp for schedule(dynamic)
    for (std::int64_t batch = range.First; batch < range.End; ++batch)
    {
      if (batch % ranks.Size() == ranks.Rank())
      {
        counts.Clear();
        for (std::int64_t i = range.FirstSample(batch); i < range.EndSample(batch); ++i)
        {
          counts.AddThrow(points.Of(i));
        }
        sums.AddBatch(counts.GetRows());
      }
    }
  }
}
}

SampledTwoPoint SampleTemplate(const SpherePack& own, int modes, const SamplingRegion& region,
  const LagGrid& lags, const SamplingSettings& settings, Communicator& communicator,
  const SamplingProgress& progress)
{
  CheckSampling(settings, Throws, modes, lags, region);
  const int throwsInBatch = SamplesInBatch(settings, ThrowsInBatch);
  SampledSums sums(modes, lags, static_cast<double>(throwsInBatch) * NumberOfRays);
  ThrownPoints points(own, modes, region, lags);
  const auto take = [&](const BatchRange& range)
  {
    const std::int64_t first = range.FirstSample(range.First);
    points.LookUp(settings.Seed, first, range.EndSample(range.End - 1) - first, communicator);
    CountBatches(range, points, modes + 1, lags, communicator, sums);
  };
  // About 10 MB of points
  const double batchBytes = 4.0 * static_cast<double>(points.PointsOfThrow()) * throwsInBatch;
  const int batchesAtOnce =
    std::max({ static_cast<int>(1e7 / batchBytes), 2 * communicator.Size(), 1 });
  return TakeSamples(
    settings, Throws, throwsInBatch, batchesAtOnce, sums, {}, communicator, progress, take);
}

namespace
{
constexpr double SecondsPerPoint = 50e-9; // to look up its phase
}

Estimate EstimateTemplate(const PackFigures& pack, const LagGrid& lags, double throws)
{
  const double ordered = (pack.Modes + 1.0) * (pack.Modes + 1.0);
  return { throws * NumberOfRays * lags.Count * SecondsPerPoint +
      FewestBatches * ordered * lags.Count * SecondsPerBatchEntry,
    100.0 * ordered * lags.Count / BytesOfMegabyte + 10.0, 0.0 };
}
}
