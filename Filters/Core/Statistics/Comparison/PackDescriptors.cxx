// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Comparison/PackDescriptors.h"

#include "ruc/Base/Text.h"
#include "ruc/Statistics/Comparison/GapCounts.h"
#include "ruc/Statistics/Neighbours/NeighbourStatistics.h"
#include "ruc/Statistics/Neighbours/VoidDistances.h"
#include "ruc/Statistics/PairSums/ExactPairSum.h"
#include "ruc/Statistics/Results/LagLimit.h"
#include "ruc/Statistics/Sampling/ChordSampling.h"
#include "ruc/Statistics/ThirdOrder/ThirdOrderOfSpheres.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace ruc
{
namespace
{
constexpr double NotKnown = std::numeric_limits<double>::quiet_NaN();

// In mean diameters
constexpr double PoreSpacing = 0.1;
constexpr double LargestPore = 0.5; // distances beyond count as that
constexpr int PoreSteps = 8;
constexpr int ChordSteps = 16; // of a mean diameter

constexpr int ChordBlocks = 27; // about as many of a pack
constexpr int LinesOfWhole = 8000;
constexpr int LinesOfPart = 1000;

class Measurement
{
public:
  Measurement(
    const PackShare& share, const DescriptorSettings& settings, bool isCell, Communicator& ranks)
    : Share(share)
    , Settings(settings)
    , IsCell(isCell)
    , Ranks(ranks)
  {
  }

  void MeasureTwoPoint()
  {
    this->Found.Sums = SumPairs(this->Share, this->Settings.Lags, this->Ranks);
    const TwoPointProbability& sums = this->Found.Sums;
    if (!this->IsCell)
    {
      this->Found.Errors = FindPairSumErrors(this->Share, sums, this->Settings.Blocks, this->Ranks);
    }
    const auto& errors = this->Found.Errors;
    for (int r = 0; r < sums.Phases(); ++r)
    {
      this->Add("c_" + sums.PhaseName(r), DescriptorKind::Fraction,
        { sums.Fractions[r], errors ? errors->Fractions[r] : NotKnown });
    }
    const double surface =
      std::accumulate(this->Share.Surface.begin(), this->Share.Surface.end(), 0.0);
    this->Add("Surface", DescriptorKind::Fraction,
      { surface / this->Share.Observed.Volume(), errors ? errors->Surface : NotKnown });
  }

  void MeasureGaps()
  {
    const std::vector<ValueWithError> counts = CountGaps(
      this->Share, { 0.02, 0.05, 0.10 }, this->IsCell ? 0 : this->Settings.Blocks, this->Ranks);
    const char* names[] = { "Neighbours 2 %", "Neighbours 5 %", "Neighbours 10 %" };
    for (int n = 0; n < 3; ++n)
    {
      this->Add(names[n], DescriptorKind::Gaps, counts[n]);
    }
  }

  void MeasureNeighbours()
  {
    NeighbourSettings neighbours;
    neighbours.MaximumGap = 0.1;
    neighbours.Gaps = 2;
    neighbours.Blocks = this->Settings.Blocks;
    const double margin = NeighbourMargin(this->Share.LargestRadius, neighbours.MaximumGap);
    const SamplingRegion region(this->Share.Observed, margin);
    const NeighbourStatistics found =
      ruc::MeasureNeighbours(this->Share, { region, margin, false }, neighbours, this->Ranks);
    const NeighbourStatistics::Means& all = found.OfModes.back();
    this->Add("Nearest gap", DescriptorKind::Gaps, all.NearestGap);
    this->Add("Q6", DescriptorKind::Order, all.Q6);
    this->Add("Faces", DescriptorKind::Order, all.Faces);
  }

  void MeasurePores()
  {
    const double diameter = this->Settings.MeanDiameter;
    VoidSettings voids;
    voids.Spacing = PoreSpacing * diameter;
    voids.MaximumDistance = LargestPore * diameter;
    voids.Distances = PoreSteps;
    voids.Blocks = this->Settings.Blocks;
    voids.WithCriticalRadius = false;
    const SamplingRegion region(
      this->Share.Observed, this->Share.LargestRadius + voids.MaximumDistance);
    const VoidDistances found = MeasureVoids(this->Share, region, voids, this->Ranks);
    this->Add("Pore mean", DescriptorKind::Pores, found.Mean);
    this->Add("Pores > D/8", DescriptorKind::Pores, found.Share[PoreSteps / 4]);
    this->Add("Pores > D/4", DescriptorKind::Pores, found.Share[PoreSteps / 2]);
  }

  void MeasureChords()
  {
    const SamplingRegion region(this->Share.Observed, this->Share.LargestRadius);
    std::array<ValueWithError, 4> whole = this->SampleChordsIn(region, LinesOfWhole);
    const std::vector<Window> parts = this->PartsForChords();
    std::array<std::vector<double>, 4> values;
    for (const Window& part : parts)
    {
      const std::array<ValueWithError, 4> found =
        this->SampleChordsIn(SamplingRegion(part, 0.0), LinesOfPart);
      for (int n = 0; n < 4; ++n)
      {
        values[n].push_back(found[n].Value);
      }
    }
    const char* names[] = { "Chord", "Lineal path D/4", "Lineal path D/2", "Lineal path D" };
    for (int n = 0; n < 4; ++n)
    {
      if (parts.size() > 1)
      {
        whole[n].Error = std::hypot(whole[n].Error, ErrorOfMean(values[n]));
      }
      this->Add(names[n], DescriptorKind::Chords, whole[n]);
    }
  }

  void MeasureThirdOrder()
  {
    ThirdOrderSettings third;
    third.Blocks = this->Settings.Blocks;
    third.Slabs = 1;
    const ThirdOrderOfSpheres found = ruc::MeasureThirdOrder(this->Share, third, this->Ranks);
    const auto& of = found.Spheres;
    this->Add("zeta", DescriptorKind::ThirdOrder, { of.Zeta.Value, of.Zeta.Error });
    this->Add("eta", DescriptorKind::ThirdOrder, { of.Eta.Value, of.Eta.Error });
  }

  // Does what may be refused, the same on all ranks; what was found by then is kept
  template <class Work>
  void Try(Work&& work)
  {
    try
    {
      work();
    }
    catch (const std::invalid_argument& refusal)
    {
      this->Found.LeftOut.emplace_back(refusal.what());
    }
  }

  PackDescriptors Found;

private:
  void Add(const std::string& name, DescriptorKind kind, const ValueWithError& value)
  {
    if (std::isfinite(value.Value))
    {
      this->Found.Values.push_back({ name, kind, value });
    }
  }

  static double ErrorOfMean(const std::vector<double>& values)
  {
    const double count = static_cast<double>(values.size());
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
    double squares = 0.0;
    for (double value : values)
    {
      squares += (value - mean) * (value - mean);
    }
    return std::sqrt(squares / (count * (count - 1.0)));
  }

  // The mean chord of the matrix, and its lineal path at a quarter, half and all of a mean diameter
  std::array<ValueWithError, 4> SampleChordsIn(const SamplingRegion& region, int lines) const
  {
    SamplingSettings sampling;
    sampling.Samples = lines;
    const LagGrid lags = { this->Settings.MeanDiameter / ChordSteps, ChordSteps };
    ChordLengths chords;
    SampleChords(this->Share.Own, this->Share.NumberOfModes(), region, lags, sampling, this->Ranks,
      {}, &chords);
    const std::vector<double>& path = chords.LinealPath.back();
    const std::vector<double>& errors = chords.LinealPathError.back();
    const auto at = [&](int k) { return ValueWithError{ path[k], errors[k] }; };
    // The mean chord has no error of its own; that of the path at its length is as large in
    // relation
    const double chord = chords.MeanChord.back();
    return { ValueWithError{ chord, chord * errors[ChordSteps / 4] / path[ChordSteps / 4] },
      at(ChordSteps / 4), at(ChordSteps / 2), at(ChordSteps) };
  }

  // Equal boxes of a pack with edges of at least three mean diameters, for the scatter of chords;
  // none for a cell
  std::vector<Window> PartsForChords() const
  {
    std::vector<Window> parts;
    const Window& window = this->Share.Observed;
    if (this->IsCell || window.GetShape() != Window::Shape::Box)
    {
      return parts;
    }
    const Window box = Window::MakeBox(window.Origin, window.Size, { false, false, false })
                         .Shrunk(this->Share.LargestRadius);
    const double width =
      std::max(3.0 * this->Settings.MeanDiameter, std::cbrt(box.Volume() / ChordBlocks));
    std::array<int, 3> counts{};
    Vector3 size{};
    for (int axis = 0; axis < 3; ++axis)
    {
      counts[axis] = std::max(static_cast<int>(box.Size[axis] / width + 0.2), 1);
      size[axis] = box.Size[axis] / counts[axis];
    }
    for (int n = 0; n < counts[0] * counts[1] * counts[2]; ++n)
    {
      const int at[] = { n / (counts[1] * counts[2]), n / counts[2] % counts[1], n % counts[2] };
      Vector3 origin;
      for (int axis = 0; axis < 3; ++axis)
      {
        origin[axis] = box.Origin[axis] + at[axis] * size[axis];
      }
      parts.push_back(Window::MakeBox(origin, size, { false, false, false }));
    }
    return parts;
  }

  const PackShare& Share;
  const DescriptorSettings& Settings;
  bool IsCell;
  Communicator& Ranks;
};
}

PackDescriptors MeasureDescriptors(const PackShare& share, const DescriptorSettings& settings,
  bool isCell, Communicator& ranks, const DescriptorProgress& progress)
{
  Measurement measurement(share, settings, isCell, ranks);
  const auto tell = [&](double done, const char* what)
  {
    if (progress)
    {
      progress(done, what);
    }
  };
  tell(0.0, "S_rs");
  measurement.MeasureTwoPoint();
  tell(0.2, "gaps");
  measurement.Try([&]() { measurement.MeasureGaps(); });
  measurement.Try([&]() { measurement.MeasureNeighbours(); });
  tell(0.4, "pores");
  measurement.Try([&]() { measurement.MeasurePores(); });
  tell(0.7, "chords");
  measurement.Try([&]() { measurement.MeasureChords(); });
  tell(0.8, "third order");
  measurement.Try([&]() { measurement.MeasureThirdOrder(); });
  return std::move(measurement.Found);
}
}
