// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/PairSums/PairSumErrors.h"

#include "ruc/Base/Require.h"
#include "ruc/Base/Text.h"
#include "ruc/Particles/SphereOverlap.h"
#include "ruc/Statistics/PairSums/PairBlockSums.h"
#include "ruc/Statistics/Results/Phases.h"
#include "ruc/Statistics/Results/TaperedBlocks.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ruc
{
namespace
{
constexpr double LeastBlockEdge = 2.0; // in mean diameters
constexpr double LeastWall = 0.03;     // the difference that counts, of c_m squared
constexpr int MostBlocks = 1000;
constexpr double MostNumbers = 5e7;
constexpr int BlurredLags = 24; // at which the blur is found; between them it is linear

// The weights of blocks in cells along an axis, blurred as by a step of length `lag` in a random
// direction, whose mean square along an axis is lag^2 / 3
std::vector<double> BlurredWeights(const TaperedBlocks& blocks, int axis, double lag)
{
  const int cells = blocks.CellsAlong(axis), count = blocks.CountAlong(axis);
  const double edge = blocks.EdgeAlong(axis) / cells;
  std::vector<double> weights(count * cells, 0.0);
  for (int from = 0; from < cells; ++from)
  {
    std::vector<double> steps(cells, 0.0);
    double sum = 0.0;
    for (int to = 0; to < cells; ++to)
    {
      int apart = std::abs(to - from);
      apart = blocks.IsPeriodic(axis) ? std::min(apart, cells - apart) : apart;
      const double length = apart * edge;
      steps[to] = lag > 0.0 ? std::exp(-1.5 * length * length / (lag * lag)) : apart == 0;
      sum += steps[to];
    }
    for (int block = 0; block < count; ++block)
    {
      const double weight = blocks.WeightAlong(axis, block, from) / 8.0;
      for (int to = 0; to < cells; ++to)
      {
        weights[block * cells + to] += weight * steps[to] / sum;
      }
    }
  }
  return weights;
}

// Returns the sums over cells with weights along each axis: what is there for each cell is then
// there for each block
std::vector<double> SumOverCells(const TaperedBlocks& blocks, std::vector<double> values,
  const std::array<std::vector<double>, 3>& weights)
{
  int before = 1, behind = static_cast<int>(values.size());
  for (int axis = 0; axis < 3; ++axis)
  {
    const int cells = blocks.CellsAlong(axis), count = blocks.CountAlong(axis);
    behind /= cells;
    std::vector<double> sums(std::size_t(before) * count * behind, 0.0);
    for (int n = 0; n < before; ++n)
    {
      for (int block = 0; block < count; ++block)
      {
        double* to = &sums[(std::size_t(n) * count + block) * behind];
        for (int cell = 0; cell < cells; ++cell)
        {
          const double weight = weights[axis][block * cells + cell];
          const double* of = &values[(std::size_t(n) * cells + cell) * behind];
          for (int m = 0; weight != 0.0 && m < behind; ++m)
          {
            to[m] += weight * of[m];
          }
        }
      }
    }
    values = std::move(sums);
    before *= count;
  }
  return values;
}

std::vector<double> SumOverCells(
  const TaperedBlocks& blocks, const std::vector<double>& values, double lag)
{
  return SumOverCells(blocks, values,
    { BlurredWeights(blocks, 0, lag), BlurredWeights(blocks, 1, lag),
      BlurredWeights(blocks, 2, lag) });
}

// From the sums to the parts of the blocks in S_rs V at a lag, and to the errors
class BlockParts
{
public:
  BlockParts(const PairSteps& steps, const TaperedBlocks& blocks, const BlockSums& sums,
    const TwoPointProbability& probability)
    : Steps(steps)
    , Blocks(blocks)
    , Sums(sums)
    , Probability(probability)
    , Count(blocks.Count())
    , BlurStep(steps.Near / BlurredLags)
  {
    this->Modes = steps.Modes;
    for (int n = 0; n <= BlurredLags; ++n)
    {
      this->Blurred.push_back(SumOverCells(blocks, sums.Volumes, n * this->BlurStep));
    }
  }

  // The standard deviations of S_rs V at lag k, for every pair of phases
  std::vector<double> Errors(int k) const
  {
    const int modes = this->Modes;
    const TwoPointProbability& p = this->Probability;
    std::vector<std::vector<double>> parts(p.Pairs(), std::vector<double>(this->Count, 0.0));
    std::vector<double>& matrix = parts[p.PairOf(modes, modes)];
    for (int r = 0; r < modes; ++r)
    {
      std::vector<double>& mixed = parts[p.PairOf(r, modes)];
      for (int block = 0; block < this->Count; ++block)
      {
        mixed[block] += this->Volume(block, r);
        matrix[block] -= 2.0 * this->Volume(block, r);
      }
      for (int s = r; s < modes; ++s)
      {
        std::vector<double>& part = parts[p.PairOf(r, s)];
        part = this->PartsOf(r, s, k);
        for (int block = 0; block < this->Count; ++block)
        {
          mixed[block] -= part[block];
          matrix[block] += (r == s ? 1.0 : 2.0) * part[block];
          if (s > r)
          {
            parts[p.PairOf(s, modes)][block] -= part[block];
          }
        }
      }
    }
    std::vector<double> errors;
    errors.reserve(parts.size());
    for (const std::vector<double>& part : parts)
    {
      errors.push_back(std::sqrt(this->Blocks.VarianceOfSum(part)));
    }
    return errors;
  }

  // The parts in c_r V of a phase, but for the sign
  std::vector<double> Volumes(int phase) const
  {
    std::vector<double> volumes(this->Count, 0.0);
    for (int block = 0; block < this->Count; ++block)
    {
      for (int mode = 0; mode < this->Modes; ++mode)
      {
        volumes[block] += phase == mode || phase == this->Modes ? this->Volume(block, mode) : 0.0;
      }
    }
    return volumes;
  }

private:
  double Volume(int block, int mode) const { return this->Blurred[0][block * this->Modes + mode]; }

  std::vector<double> PartsOf(int r, int s, int k) const
  {
    const double lag = k * this->Probability.Lags.Spacing;
    const double cr = this->Probability.Fractions[r], cs = this->Probability.Fractions[s];
    std::vector<double> parts(this->Count);
    if (lag > this->Steps.Near)
    {
      for (int block = 0; block < this->Count; ++block)
      {
        parts[block] = cs * this->Volume(block, r) + cr * this->Volume(block, s);
      }
      return parts;
    }
    const int pair = this->Steps.PairOf(r, s), begin = this->Steps.Begin[pair];
    const double a = this->Steps.Radius[r], b = this->Steps.Radius[s];
    std::vector<double> overlap;
    for (int n = begin; n < this->Steps.Begin[pair + 1]; ++n)
    {
      const double d = (n - begin + 0.5) * this->Steps.Step[pair];
      overlap.push_back(OrientationAveragedOverlap(a, b, lag, d).Value * (r == s ? 1.0 : 0.5));
    }
    const double self = r == s ? LensVolume(a, a, lag) / this->Steps.Volume[r] : 0.0;
    const int blur = std::min(static_cast<int>(lag / this->BlurStep), BlurredLags - 1);
    const double between = lag / this->BlurStep - blur;
    for (int block = 0; block < this->Count; ++block)
    {
      const double* counts = &this->Sums.Pairs[std::size_t(block) * this->Steps.Size() + begin];
      const auto moved = [&](int mode)
      {
        const int n = block * this->Modes + mode;
        return this->Volume(block, mode) - (1.0 - between) * this->Blurred[blur][n] -
          between * this->Blurred[blur + 1][n];
      };
      parts[block] = std::inner_product(overlap.begin(), overlap.end(), counts, 0.0) +
        self * this->Volume(block, r) + 0.5 * (cs * moved(r) + cr * moved(s));
    }
    return parts;
  }

  const PairSteps& Steps;
  const TaperedBlocks& Blocks;
  const BlockSums& Sums;
  const TwoPointProbability& Probability;
  int Count, Modes = 0;
  double BlurStep;
  std::vector<std::vector<double>> Blurred;
};
}

TwoPointErrors FindPairSumErrors(const PackShare& share, const TwoPointProbability& sums,
  int number, Communicator& ranks, const char* property)
{
  Require(number >= TaperedBlocks::Fewest && number <= MostBlocks, property,
    ruc::Text("a number from ", TaperedBlocks::Fewest, " to ", MostBlocks), number);
  const TaperedBlocks blocks(
    share.Observed, number, LeastBlockEdge * share.MeanDiameter(), property);
  const PairSteps steps(share, sums.Lags);
  const double numbers = double(steps.Size()) * blocks.Count();
  Require(numbers <= MostNumbers, property,
    ruc::Text(
      "at most ", MostNumbers, " numbers for all pairs of modes; fewer modes or blocks take less"),
    numbers);
  const BlockSums found = SumBlocks(share, steps, blocks, ranks);
  const BlockParts parts(steps, blocks, found, sums);
  const double volume = share.Observed.Volume();
  TwoPointErrors errors;
  errors.Blocks = blocks.Count();
  errors.Values.assign(sums.Pairs(), std::vector<double>(sums.Lags.Count + 1));
#pragma omp parallel for schedule(dynamic)
  for (int k = 0; k <= sums.Lags.Count; ++k)
  {
    const std::vector<double> ofLag = parts.Errors(k);
    for (int pair = 0; pair < sums.Pairs(); ++pair)
    {
      errors.Values[pair][k] = ofLag[pair] / volume;
    }
  }
  for (int phase = 0; phase < sums.Phases(); ++phase)
  {
    errors.Fractions.push_back(std::sqrt(blocks.VarianceOfSum(parts.Volumes(phase))) / volume);
  }
  errors.Surface =
    std::sqrt(blocks.VarianceOfSum(SumOverCells(blocks, found.Surface, 0.0))) / volume;
  std::vector<double> ofCells(blocks.Cells(), 0.0);
  for (std::size_t n = 0; n < found.Volumes.size(); ++n)
  {
    ofCells[n / steps.Modes] += found.Volumes[n];
  }
  errors.Layers = TestLayers(blocks, ofCells, found.Rings, volume);
  return errors;
}

std::string DescribeWalls(const TwoPointProbability& sums, const TwoPointErrors& errors)
{
  const int m = sums.Modes, last = sums.Lags.Count;
  const double product = sums.Fractions[m] * sums.Fractions[m];
  const double off = sums.S(m, m)[last] - product;
  if (sums.Fractions[m] <= 0.0 || std::abs(off) <= LeastWall * product ||
    std::abs(off) <= 3.0 * errors.Values[sums.PairOf(m, m)][last])
  {
    return {};
  }
  return Text("At the last lag S_m_m is ", sums.S(m, m)[last], ", where c_m squared is ", product,
    ": the window cuts through layers at walls, or its lags end before S_m_m is saturated. A "
    "window "
    "without the layers, or a larger MaximumLag, tells which.");
}

double ObjectiveFloor(const TwoPointProbability& sums, const TwoPointErrors& errors)
{
  double floor = 0.0;
  for (int r = 0; r < sums.Phases(); ++r)
  {
    for (int s = 0; s < sums.Phases(); ++s)
    {
      floor += DiscreteNorm(errors.Values[sums.PairOf(r, s)]);
    }
  }
  return floor;
}

namespace
{
constexpr double SecondsPerNeighbour = 8e-9;
constexpr double SecondsPerPart = 1.2e-9; // of a block, a pair of modes and a step of distances
}

Estimate EstimatePairSumErrors(const PackFigures& pack, const LagGrid& lags, int blocks)
{
  const double near = std::min(NearLagOfErrors * 2.0 * pack.MeanRadius, lags.Maximum());
  const double pairs = 2.0 * pack.PairsWithin(near + 2.0 * pack.MeanRadius);
  const double steps = (near + 2.0 * pack.MeanRadius) / (StepOfErrors * pack.MeanRadius);
  const double numbers = PairsOfPhases(pack.Modes) * steps * blocks;
  const double lagsNear = near / lags.Spacing;
  return { pairs * SecondsPerNeighbour + numbers * (lagsNear + 64.0) * SecondsPerPart,
    16.0 * numbers / BytesOfMegabyte, 0.0 };
}
}
