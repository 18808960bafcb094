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
constexpr int MostThrowsInBatch = 32;

Vector3 Wrapped(Vector3 point, const Window& box)
{
  for (int q = 0; q < 3; ++q)
  {
    point[q] -= box.Size[q] * std::floor((point[q] - box.Origin[q]) / box.Size[q]);
  }
  return point;
}
}

SampledTwoPoint SampleTemplate(const SpherePack& own, int modes, const SamplingRegion& region,
  const LagGrid& lags, const SamplingSettings& settings, Communicator& communicator,
  const SamplingProgress& progress)
{
  CheckSampling(settings, Throws, modes, lags, region);
  const SphereGrid grid(own, region.GetBounds());
  const RayDirections rays(NumberOfRays);
  const int throwsInBatch = SamplesInBatch(settings, MostThrowsInBatch);
  const int size = communicator.Size(), phases = modes + 1;
  SampledSums sums(modes, lags, static_cast<double>(throwsInBatch) * NumberOfRays);

  // The centre, then the points of each ray
  const std::size_t points = 1 + static_cast<std::size_t>(NumberOfRays) * lags.Count;
  std::vector<std::int32_t> found;
  const auto lookUp = [&](const Vector3& point) -> std::int32_t
  {
    if (region.IsFullyPeriodic())
    {
      return grid.LowestModeAt(Wrapped(point, region.GetBounds()), modes);
    }
    return region.Contains(point) ? grid.LowestModeAt(point, modes) : OutsideRegion;
  };
  const auto take = [&](const BatchRange& range)
  {
    const std::int64_t first = range.FirstSample(range.First);
    const std::int64_t count = range.EndSample(range.End - 1) - first;
    found.resize(count * points);
#pragma omp parallel for schedule(dynamic)
    for (std::int64_t n = 0; n < count; ++n)
    {
      const auto sample = static_cast<std::uint32_t>(first + n);
      std::int32_t* place = &found[n * points];
      const RayFan fan = RayFan::Random(region, settings.Seed, sample);
      const Vector3& centre = fan.Centre;
      *place++ = lookUp(centre);
      for (int i = 0; i < NumberOfRays; ++i)
      {
        const Vector3 ray = rays.Of(fan, i);
        for (int k = 1; k <= lags.Count; ++k)
        {
          const double r = k * lags.Spacing;
          *place++ =
            lookUp({ centre[0] + r * ray[0], centre[1] + r * ray[1], centre[2] + r * ray[2] });
        }
      }
    }
    // The matrix is the highest phase, so that what any rank finds there comes first.
    communicator.Minimum(found.data(), found.size());

#pragma omp parallel
    {
      std::vector<std::vector<double>> counts(static_cast<std::size_t>(phases) * phases);
      std::vector<const double*> rows(counts.size());
#pragma omp for schedule(dynamic)
      for (std::int64_t batch = range.First; batch < range.End; ++batch)
      {
        if (batch % size != communicator.Rank())
        {
          continue;
        }
        for (std::vector<double>& row : counts)
        {
          row.clear();
        }
        const auto count = [&](int r, int s, int k, double number)
        {
          std::vector<double>& row = counts[static_cast<std::size_t>(r) * phases + s];
          if (row.empty())
          {
            row.assign(lags.Count + 1, 0.0);
          }
          row[k] += number;
        };
        for (std::int64_t i = range.FirstSample(batch); i < range.EndSample(batch); ++i)
        {
          const std::int32_t* place = &found[(i - first) * points];
          const std::int32_t centre = *place++;
          count(centre, centre, 0, NumberOfRays);
          for (int ray = 0; ray < NumberOfRays; ++ray)
          {
            for (int k = 1; k <= lags.Count; ++k, ++place)
            {
              if (*place != OutsideRegion)
              {
                count(centre, *place, k, 1.0);
              }
            }
          }
        }
        for (std::size_t n = 0; n < rows.size(); ++n)
        {
          rows[n] = counts[n].empty() ? nullptr : counts[n].data();
        }
        sums.AddBatch(rows);
      }
    }
  };
  // About 10 MB of points
  const double batchBytes = 4.0 * static_cast<double>(points) * throwsInBatch;
  const int batchesAtOnce = std::max({ static_cast<int>(1e7 / batchBytes), 2 * size, 1 });
  return TakeSamples(
    settings, Throws, throwsInBatch, batchesAtOnce, sums, {}, communicator, progress, take);
}

namespace
{
constexpr double SecondsPerPoint = 50e-9; // whose phase is looked up
}

Estimate EstimateTemplate(const PackFigures& pack, const LagGrid& lags, double throws)
{
  const double ordered = (pack.Modes + 1.0) * (pack.Modes + 1.0);
  return { throws * NumberOfRays * lags.Count * SecondsPerPoint +
      FewestBatches * ordered * lags.Count * SecondsPerBatchEntry,
    100.0 * ordered * lags.Count / BytesOfMegabyte + 10.0, 0.0 };
}
}
