// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Sampling/ChordSampling.h"

#include "ruc/Base/Text.h"
#include "ruc/Statistics/Sampling/LineCorrelation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

namespace ruc
{
namespace
{
constexpr SampleNames LineNames = { "NumberOfLines", "lines" };
// The most places of the square grid around a region, of which many more than meet the region are
// needed where it is long and thin; each takes 4 bytes
constexpr double MostPlacesOfGrid = 2.5e7;
// The closer the lines of a batch are, the less each of them tells; the fewer the batches, the less
// is known about their scatter
constexpr int LinesInAimedBatch = 512, MostLinesInBatch = 4096;

// Batches of parallel lines. All ranks trace them through their own spheres; the hits of a batch
// come together on the rank that owns it, batch % ranks.
class ChordSampler
{
public:
  ChordSampler(const SpherePack& own, int modes, const SamplingRegion& region, const LagGrid& lags,
    const SamplingSettings& settings, Communicator& communicator)
    : Own(own)
    , Modes(modes)
    , Region(region)
    , Lags(lags)
    , Settings(settings)
    , Ranks(communicator)
  {
  }

  // Takes lines along a direction instead of isotropic ones
  void SetDirection(const Vector3& direction, std::uint32_t set)
  {
    this->Direction = direction;
    this->Set = set;
  }

  SampledTwoPoint Sample(ChordLengths* chordLengths, const SamplingProgress& progress)
  {
    const bool aimed = this->Settings.TargetError > 0.0;
    const int most = this->UsefulLinesInBatch();
    const int linesInBatch =
      SamplesInBatch(this->Settings, aimed ? std::min(most, LinesInAimedBatch) : most);
    const std::int64_t batches = (this->Settings.Samples + linesInBatch - 1) / linesInBatch;
    this->LinesInBatch =
      aimed ? linesInBatch : static_cast<double>(this->Settings.Samples) / batches;
    const double longest = this->Region.LongestLine(this->Lags.Maximum());
    const double mostLines = this->CheckedMostLines();
    SampledSums sums(this->Modes, this->Lags, mostLines * longest);
    std::optional<ChordLengthSums> lengths;
    if (chordLengths)
    {
      lengths.emplace(this->Modes, this->Lags, longest, mostLines);
    }
    // These are some 10 MB of hits where a line meets 100 spheres
    const int batchesAtOnce = std::max(MostLinesInBatch / linesInBatch, 2 * this->Ranks.Size());
    this->Drawn = 0;
    SampledTwoPoint result = TakeSamples(this->Settings, LineNames, linesInBatch, batchesAtOnce,
      sums, lengths ? lengths->GetRatios() : std::vector<SampledRatios*>(), this->Ranks, progress,
      [&](const BatchRange& range)
      {
        this->Trace(range);
        this->Gather(range);
        this->Accumulate(range, sums, lengths ? &*lengths : nullptr);
      });
    result.Samples = this->Drawn;
    if (chordLengths)
    {
      *chordLengths = lengths->Result();
    }
    return result;
  }

private:
  double CheckedMostLines() const
  {
    const double most = this->Region.MostLines(this->LinesInBatch);
    if (!(most <= MostPlacesOfGrid))
    {
      throw std::invalid_argument(Text("Chord Sampling requires a region whose lines lie in a grid "
                                       "of at most ",
        MostPlacesOfGrid, " places, got ", most, " for the ", this->Region.GetBounds().Describe(),
        ", which is too long for its width. Set a window, or leave out centres that lie far from "
        "the others."));
    }
    return most;
  }

  // Lines that are much closer to each other than the spheres tell the same, while more directions
  // tell more
  int UsefulLinesInBatch() const
  {
    std::int64_t spheres = static_cast<std::int64_t>(this->Own.Size());
    this->Ranks.Sum(&spheres, 1);
    const double distance =
      0.75 * std::cbrt(this->Region.GetBounds().Volume() / std::max<std::int64_t>(spheres, 1));
    return static_cast<int>(
      std::clamp(this->Region.LinesOfSpacing(distance), 1.0, double(MostLinesInBatch)));
  }

  // The lines of a batch and the spheres that they meet
  struct Batch
  {
    std::vector<SampleLine> Lines;
    std::vector<std::vector<SphereHit>> Hits;
  };

  void Trace(const BatchRange& range)
  {
    this->Batches.assign(range.End - range.First, {});
#pragma omp parallel for schedule(dynamic)
    for (std::int64_t n = 0; n < range.End - range.First; ++n)
    {
      const auto sample = static_cast<std::uint32_t>(range.First + n);
      LineBundle bundle = this->Direction
        ? this->Region.ParallelLinesAlong(*this->Direction, this->Set, this->Settings.Seed, sample,
            this->LinesInBatch, this->Lags.Maximum())
        : this->Region.ParallelLines(
            this->Settings.Seed, sample, this->LinesInBatch, this->Lags.Maximum());
      Batch& batch = this->Batches[n];
      batch.Hits.resize(bundle.Lines.size());
      bundle.FindHits(this->Own, batch.Hits);
      batch.Lines = std::move(bundle.Lines);
    }
    for (const Batch& batch : this->Batches)
    {
      this->Drawn += static_cast<std::int64_t>(batch.Lines.size());
    }
  }

  // Calls visit(hits) for every line of the batches that a rank owns, in order
  template <class Visit>
  void ForEachLineOf(int rank, const BatchRange& range, Visit&& visit)
  {
    for (std::int64_t batch = range.First; batch < range.End; ++batch)
    {
      if (batch % this->Ranks.Size() == rank)
      {
        for (std::vector<SphereHit>& hits : this->Batches[batch - range.First].Hits)
        {
          visit(hits);
        }
      }
    }
  }

  // Sends the hits of every line to the owner of its batch: their number, then three numbers for
  // each
  void Gather(const BatchRange& range)
  {
    const int size = this->Ranks.Size(), own = this->Ranks.Rank();
    if (size == 1)
    {
      return;
    }
    std::vector<std::vector<double>> parcels(size);
    for (int rank = 0; rank < size; ++rank)
    {
      if (rank != own)
      {
        this->ForEachLineOf(rank, range,
          [&](const std::vector<SphereHit>& hits)
          {
            parcels[rank].push_back(static_cast<double>(hits.size()));
            for (const SphereHit& hit : hits)
            {
              parcels[rank].insert(
                parcels[rank].end(), { hit.In, hit.Out, static_cast<double>(hit.Mode) });
            }
          });
      }
    }
    parcels = this->Ranks.AllToAll(std::move(parcels));
    for (int rank = 0; rank < size; ++rank)
    {
      if (rank != own)
      {
        const double* number = parcels[rank].data();
        this->ForEachLineOf(own, range,
          [&](std::vector<SphereHit>& hits)
          {
            for (auto left = static_cast<std::int64_t>(*number++); left > 0; --left, number += 3)
            {
              hits.push_back({ number[0], number[1], static_cast<int>(number[2]) });
            }
          });
      }
    }
  }

  void Accumulate(const BatchRange& range, SampledSums& sums, ChordLengthSums* lengths)
  {
#pragma omp parallel
    {
      LineCorrelation correlation(this->Modes, this->Lags);
      ChordLengthSums::Batch chords;
      if (lengths)
      {
        chords = lengths->NewBatch();
      }
      std::vector<PhaseChange> changes;
#pragma omp for schedule(dynamic)
      for (std::int64_t batch = range.First; batch < range.End; ++batch)
      {
        if (batch % this->Ranks.Size() != this->Ranks.Rank())
        {
          continue;
        }
        Batch& own = this->Batches[batch - range.First];
        for (std::size_t n = 0; n < own.Lines.size(); ++n)
        {
          FindPhaseChanges(own.Hits[n], own.Lines[n].Inside, this->Modes, changes);
          correlation.AddLine(changes);
          if (lengths)
          {
            lengths->AddLine(changes, own.Lines[n].Inside, chords);
          }
        }
        sums.AddBatch(correlation.Finish());
        correlation.Clear();
        if (lengths)
        {
          lengths->AddBatch(chords);
        }
      }
    }
  }

  const SpherePack& Own;
  int Modes;
  const SamplingRegion& Region;
  LagGrid Lags;
  SamplingSettings Settings;
  Communicator& Ranks;
  std::optional<Vector3> Direction;
  std::uint32_t Set = 0;
  double LinesInBatch = 0.0;  // in the mean
  std::int64_t Drawn = 0;     // how many lines were drawn so far
  std::vector<Batch> Batches; // those in hand
};
}

SampledTwoPoint SampleChords(const SpherePack& own, int modes, const SamplingRegion& region,
  const LagGrid& lags, const SamplingSettings& settings, Communicator& communicator,
  const SamplingProgress& progress, ChordLengths* chordLengths)
{
  CheckSampling(settings, LineNames, modes, lags, region);
  if (chordLengths && lags.Count < 1)
  {
    throw std::invalid_argument("Chord lengths require NumberOfLags >= 1, got 0.");
  }
  return ChordSampler(own, modes, region, lags, settings, communicator)
    .Sample(chordLengths, progress);
}

std::vector<SampledTwoPoint> SampleChordsAlong(const std::vector<Vector3>& directions,
  const SpherePack& own, int modes, const SamplingRegion& region, const LagGrid& lags,
  const SamplingSettings& settings, Communicator& communicator, const SamplingProgress& progress)
{
  CheckSampling(settings, LineNames, modes, lags, region);
  ChordSampler sampler(own, modes, region, lags, settings, communicator);
  std::vector<SampledTwoPoint> results;
  for (const Vector3& direction : directions)
  {
    const std::size_t number = results.size();
    sampler.SetDirection(direction, static_cast<std::uint32_t>(number));
    SamplingProgress part;
    if (progress)
    {
      part = [&](double done, const std::string& text)
      {
        return progress((number + done) / directions.size(),
          Text("direction ", number + 1, " of ", directions.size(), ", ", text));
      };
    }
    results.push_back(sampler.Sample(nullptr, part));
  }
  return results;
}

namespace
{
constexpr double SecondsPerSphereAndBatch = 4e-8; // to project a sphere onto the grid of lines
constexpr double SecondsPerHit = 110e-9;          // for a sphere that a line meets
constexpr double SecondsPerPairOfChanges = 7e-9;  // for two phase changes on a line

// The number of pairs of phase changes up to `lag` apart on a line; a sphere makes two changes
double PairsOfChanges(double hits, double length, double lag)
{
  const double reach = std::min(lag / length, 1.0);
  return 4.0 * hits * hits * reach * (1.0 - 0.5 * reach);
}
}

Estimate EstimateChords(const PackFigures& pack, const LagGrid& lags, double lines)
{
  // The mean chord of a cube is 4 volumes over its surface; a periodic line crosses the box and has
  // the last lag besides
  const double edge = std::cbrt(pack.Observed.Volume());
  const double length = pack.Observed.IsFullyPeriodic() ? edge + lags.Maximum() : 2.0 / 3.0 * edge;
  const double hits = pack.HitsOn(length);
  const double ordered = (pack.Modes + 1.0) * (pack.Modes + 1.0);
  // A batch has as many lines as spheres lie side by side
  const double ofBatch =
    std::clamp(1.8 * std::pow(pack.Spheres, 2.0 / 3.0), 1.0, 1.0 * MostLinesInBatch);
  const double batches = std::max(lines / ofBatch, 1.0 * FewestBatches);
  return { lines *
        (hits * SecondsPerHit +
          PairsOfChanges(hits, length, lags.Maximum()) * SecondsPerPairOfChanges) +
      batches *
        (pack.Spheres * SecondsPerSphereAndBatch + ordered * lags.Count * SecondsPerBatchEntry),
    100.0 * ordered * lags.Count / BytesOfMegabyte + 10.0, 0.0 };
}
}
