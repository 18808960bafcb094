// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Cells of the example pack by F2 alone, and with near neighbours and pores: how near they come,
 * and what they cost. Gaps and pores are measured here anew, by all pairs and by random points, and
 * with standard errors from nine columns of the pack.
 *
 *     BenchmarkNeighbours [contact weight, pore weight, spheres, iterations, seeds, target
 * objective]
 */
#include "ExamplePack.h"
#include "ruc/Reconstruction/GradientSearch.h"
#include "ruc/Statistics/PairSums/ExactPairSum.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <random>

namespace
{
const std::vector<double> Gaps = { 0.005, 0.01, 0.02, 0.05, 0.10, 0.20, 0.40 };
const std::vector<double> Pores = { 10.0, 12.0 };
constexpr int Columns = 9;

double CpuSeconds()
{
  return double(std::clock()) / CLOCKS_PER_SEC;
}

int ColumnOf(const ruc::Vector3& place, const ruc::Window& box)
{
  const auto third = [&](int q)
  { return std::min(2, static_cast<int>(3.0 * (place[q] - box.Origin[q]) / box.Size[q])); };
  return 3 * third(0) + third(1);
}

struct Figures
{
  // Neighbours of a sphere with gap <= Gaps, the share of the matrix with distance > Pores, the
  // median of the least gap
  std::vector<double> Values;
};

double Median(std::vector<double> values)
{
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values.empty() ? 0.0 : values[values.size() / 2];
}

// For all spheres (column -1) or those of one column, whose neighbours lie anywhere
Figures Measure(const ruc::SpherePack& pack, const ruc::Window& box, int column)
{
  const double largest = pack.LargestRadius();
  const auto apart = [&](const ruc::Vector3& a, const ruc::Vector3& b)
  {
    ruc::Vector3 d;
    for (int q = 0; q < 3; ++q)
    {
      d[q] = b[q] - a[q];
      d[q] -= box.Periodic[q] ? box.Size[q] * std::nearbyint(d[q] / box.Size[q]) : 0.0;
    }
    return d;
  };
  // Spheres by their x, to look only at those near by; images along x are found by all pairs
  std::vector<double> counts(Gaps.size(), 0.0), nearest;
  double spheres = 0.0;
  const double reach = 2.0 * largest * (1.0 + Gaps.back());
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    if (column >= 0 && ColumnOf(pack.Centre(i), box) != column)
    {
      continue;
    }
    ++spheres;
    bool inside = true;
    for (int q = 0; q < 3; ++q)
    {
      const double x = pack.Centre(i)[q] - box.Origin[q];
      inside = inside && (box.Periodic[q] || (x > reach && x < box.Size[q] - reach));
    }
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < pack.Size(); ++j)
    {
      const double x = pack.X[j] - pack.X[i];
      if (i == j || (!box.Periodic[0] && std::abs(x) > reach))
      {
        continue;
      }
      const ruc::Vector3 d = apart(pack.Centre(i), pack.Centre(j));
      const double distance = ruc::Length(d), contact = pack.Radius[i] + pack.Radius[j];
      least = std::min(least, distance - contact);
      const double weight = distance / contact - 1.0 <= Gaps.back()
        ? box.Volume() / box.SetCovariance(d[0], d[1], d[2])
        : 0.0;
      for (std::size_t k = 0; k < Gaps.size(); ++k)
      {
        counts[k] += distance / contact - 1.0 <= Gaps[k] ? weight : 0.0;
      }
    }
    if (inside)
    {
      nearest.push_back(least);
    }
  }
  Figures figures;
  for (double count : counts)
  {
    figures.Values.push_back(count / spheres);
  }
  // Random points of the matrix, in pores
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform;
  std::vector<double> wide(Pores.size(), 0.0);
  double matrix = 0.0;
  for (int n = 0; n < 400000; ++n)
  {
    ruc::Vector3 point;
    for (int q = 0; q < 3; ++q)
    {
      const double margin = box.Periodic[q] ? 0.0 : 42.0;
      point[q] = box.Origin[q] + margin + (box.Size[q] - 2.0 * margin) * uniform(random);
    }
    if (column >= 0 && ColumnOf(point, box) != column)
    {
      continue;
    }
    double least = std::numeric_limits<double>::infinity();
    std::size_t first = 0, last = pack.Size();
    if (!box.Periodic[0]) // the pack is sorted by x
    {
      first = std::lower_bound(pack.X.begin(), pack.X.end(), point[0] - 42.0) - pack.X.begin();
      last = std::upper_bound(pack.X.begin(), pack.X.end(), point[0] + 42.0) - pack.X.begin();
    }
    for (std::size_t j = first; j < last; ++j)
    {
      least = std::min(least, ruc::Length(apart(point, pack.Centre(j))) - pack.Radius[j]);
    }
    matrix += least > 0.0;
    for (std::size_t k = 0; k < Pores.size(); ++k)
    {
      wide[k] += least > Pores[k];
    }
  }
  for (double count : wide)
  {
    figures.Values.push_back(count / matrix);
  }
  figures.Values.push_back(Median(nearest));
  return figures;
}

void Print(const char* what, const std::vector<double>& values)
{
  std::printf("%-22s", what);
  for (double value : values)
  {
    std::printf(" %8.4f", value);
  }
  std::printf("\n");
  std::fflush(stdout);
}
}

int main(int argc, char** argv)
{
  const auto argument = [&](int n, double value) { return argc > n ? std::atof(argv[n]) : value; };
  const ruc::SpherePack pack = ReadPack();
  const ruc::CellContents contents =
    ruc::FindCellContents(ruc::SharePack(pack, Block), static_cast<int>(argument(3, 1082.0)));
  const ruc::TwoPointProbability target = ruc::SumPairs(pack, Block, { 200.0 / 277, 277 });
  ruc::Communicator alone;
  ruc::GradientSearchSettings settings;
  settings.Neighbours.ContactWeight = argument(1, 1.0);
  settings.Neighbours.PoreWeight = argument(2, 1.0);
  settings.MaximumIterations = static_cast<int>(argument(4, 1000.0));
  settings.TargetObjective = argument(6, 0.0);
  const double began = CpuSeconds();
  settings.Neighbours.Pack = ruc::MeasureNeighbourSums(ruc::SharePack(pack, Block), alone);
  std::printf("Near neighbours and pores of the pack: %.2f s of CPU\n", CpuSeconds() - began);
  std::printf("Neighbours of a sphere with a gap of at most 0.5, 1, 2, 5, 10, 20, 40 %%; P(pore > "
              "10), P(pore > 12 um); median least gap, um\n");
  if (std::getenv("SKIP_PACK") == nullptr)
  {
    const Figures whole = Measure(pack, Block, -1);
    std::vector<double> mean(whole.Values.size(), 0.0), squares(mean);
    for (int column = 0; column < Columns; ++column)
    {
      const Figures part = Measure(pack, Block, column);
      for (std::size_t n = 0; n < mean.size(); ++n)
      {
        mean[n] += part.Values[n] / Columns;
        squares[n] += part.Values[n] * part.Values[n] / Columns;
      }
    }
    std::vector<double> errors;
    for (std::size_t n = 0; n < mean.size(); ++n)
    {
      errors.push_back(std::sqrt(std::max(squares[n] - mean[n] * mean[n], 0.0) / (Columns - 1)));
    }
    Print("pack", whole.Values);
    Print("its standard error", errors);
  }
  for (int seed = 1; seed <= static_cast<int>(argument(5, 1.0)); ++seed)
  {
    settings.Seed = seed;
    int evaluations = 0;
    const double start = CpuSeconds();
    const ruc::UnitCell cell = ruc::SearchByGradient(
      contents, target, settings, alone, [&](const ruc::SearchState&) { ++evaluations; return true; });
    const double seconds = CpuSeconds() - start;
    Print("cell", Measure(cell.Pack, cell.Box, -1).Values);
    if (std::getenv("TRACE") != nullptr)
    {
      for (std::size_t n = 0; n < cell.Convergence.size(); n += 50)
      {
        const ruc::SearchState& s = cell.Convergence[n];
        std::printf("%zu %d F2 %.5f overlap %.3g misfits %.4g %.4g %.4g\n", n, (int)s.Phase, s.Objective, s.OverlapPercent, s.Misfits.Gaps, s.Misfits.Nearest, s.Misfits.Pores);
      }
    }
    std::printf("asked %d\n", evaluations);
    const ruc::NeighbourMisfits& misfits = cell.Convergence.back().Misfits;
    std::printf("seed %d: F2 %.4f after %d iterations, %s, overlap %g %%, misfits %.3g %.3g %.3g, "
                "%.1f s of CPU\n",
      seed, cell.Objective, cell.Iterations, ruc::NameOf(cell.EndedBy), cell.Overlap.Percent,
      misfits.Gaps, misfits.Nearest, misfits.Pores, seconds);
  }
  return 0;
}
