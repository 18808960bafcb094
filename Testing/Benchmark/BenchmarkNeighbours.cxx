// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Cells of the example pack by F2 alone, and with near neighbours, pores, the spectrum and third
 * order: how near they come, and what they cost. Gaps and pores are measured here anew, by all
 * pairs and by random points, and with standard errors from nine columns of the pack; zeta is that
 * of Third-Order Parameters.
 *
 *     BenchmarkNeighbours [contact weight, pore weight, spheres, iterations, seeds, target
 * objective, spectrum weight, third-order weight]
 */
#include "ExamplePack.h"
#include "ruc/Reconstruction/GradientSearch.h"
#include "ruc/Statistics/PairSums/ExactPairSum.h"
#include "ruc/Statistics/ThirdOrder/ThirdOrderOfSpheres.h"

#include <algorithm>
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

// A sphere, or a point, and those that may be near it: their distance along x is at most `reach`,
// where x is not periodic
struct Around
{
  const ruc::SpherePack& Pack; // sorted by x
  const ruc::Window& Box;

  template <class Visit>
  void Each(const ruc::Vector3& place, double reach, Visit&& visit) const
  {
    std::size_t first = 0, last = this->Pack.Size();
    if (!this->Box.Periodic[0])
    {
      const std::vector<double>& x = this->Pack.X;
      first = std::lower_bound(x.begin(), x.end(), place[0] - reach) - x.begin();
      last = std::upper_bound(x.begin(), x.end(), place[0] + reach) - x.begin();
    }
    for (std::size_t j = first; j < last; ++j)
    {
      ruc::Vector3 d;
      for (int q = 0; q < 3; ++q)
      {
        const double edge = this->Box.Size[q];
        d[q] = this->Pack.Centre(j)[q] - place[q];
        d[q] -= this->Box.Periodic[q] ? edge * std::nearbyint(d[q] / edge) : 0.0;
      }
      visit(j, d);
    }
  }
};

double Median(std::vector<double> values)
{
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values.empty() ? 0.0 : values[values.size() / 2];
}

// Neighbours of a sphere with gap <= Gaps, and the median of the least gap; of all spheres (column
// -1) or those of one column, whose neighbours lie anywhere
std::vector<double> MeasureGaps(const Around& around, int column, double& median)
{
  const ruc::SpherePack& pack = around.Pack;
  const ruc::Window& box = around.Box;
  const double reach = 2.0 * pack.LargestRadius() * (1.0 + Gaps.back());
  std::vector<double> counts(Gaps.size(), 0.0), nearest;
  double spheres = 0.0;
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
    around.Each(pack.Centre(i), reach,
      [&](std::size_t j, const ruc::Vector3& d)
      {
        const double distance = ruc::Length(d), contact = pack.Radius[i] + pack.Radius[j];
        const double gap = distance / contact - 1.0;
        if (i == j || gap > Gaps.back())
        {
          return;
        }
        least = std::min(least, distance - contact);
        const double weight = box.Volume() / box.SetCovariance(d[0], d[1], d[2]);
        for (std::size_t k = 0; k < Gaps.size(); ++k)
        {
          counts[k] += gap <= Gaps[k] ? weight : 0.0;
        }
      });
    if (inside)
    {
      nearest.push_back(least);
    }
  }
  for (double& count : counts)
  {
    count /= spheres;
  }
  median = Median(nearest);
  return counts;
}

// The share of the matrix that is farther than Pores from any surface, by random points
std::vector<double> MeasurePores(const Around& around, int column)
{
  const ruc::Window& box = around.Box;
  constexpr double margin = 42.0;
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform;
  std::vector<double> wide(Pores.size(), 0.0);
  double matrix = 0.0;
  for (int n = 0; n < 400000; ++n)
  {
    ruc::Vector3 point;
    for (int q = 0; q < 3; ++q)
    {
      const double rim = box.Periodic[q] ? 0.0 : margin;
      point[q] = box.Origin[q] + rim + (box.Size[q] - 2.0 * rim) * uniform(random);
    }
    if (column >= 0 && ColumnOf(point, box) != column)
    {
      continue;
    }
    double least = std::numeric_limits<double>::infinity();
    around.Each(point, margin,
      [&](std::size_t j, const ruc::Vector3& d)
      { least = std::min(least, ruc::Length(d) - around.Pack.Radius[j]); });
    matrix += least > 0.0;
    for (std::size_t k = 0; k < Pores.size(); ++k)
    {
      wide[k] += least > Pores[k];
    }
  }
  for (double& count : wide)
  {
    count /= matrix;
  }
  return wide;
}

// All figures, in the order in which they are printed
std::vector<double> Measure(const ruc::SpherePack& pack, const ruc::Window& box, int column)
{
  const Around around{ pack, box };
  double median = 0.0;
  std::vector<double> values = MeasureGaps(around, column, median);
  const std::vector<double> wide = MeasurePores(around, column);
  values.insert(values.end(), wide.begin(), wide.end());
  values.push_back(median);
  return values;
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

void PrintZeta(const char* what, const ruc::SpherePack& pack, const ruc::Window& window)
{
  ruc::Communicator alone;
  ruc::ThirdOrderSettings settings;
  settings.WithEta = false;
  const ruc::ThirdOrderFigure zeta =
    ruc::MeasureThirdOrder(ruc::SharePack(pack, window), settings, alone).Spheres.Zeta;
  std::printf("zeta of the %s: %.4f +- %.4f\n", what, zeta.Value, zeta.Error);
}

// What an evaluation of a term takes
template <class Term>
void PrintTerm(const char* what, const ruc::CellContents& contents, Term&& term)
{
  constexpr int times = 20;
  const std::vector<double> centres = ruc::RandomCentres(contents, 1, 0);
  std::vector<double> gradient(centres.size(), 0.0);
  double seconds[2];
  for (bool withGradient : { false, true })
  {
    const double before = CpuSeconds();
    for (int n = 0; n < times; ++n)
    {
      term.Evaluate(centres.data(), 1.0, withGradient ? gradient.data() : nullptr);
    }
    seconds[withGradient] = (CpuSeconds() - before) / times;
  }
  std::printf("An evaluation of the %s: %.1f ms, with gradient %.1f ms of CPU\n", what,
    1e3 * seconds[0], 1e3 * seconds[1]);
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
  if (argument(7, 0.0) > 0.0)
  {
    const double before = CpuSeconds();
    settings.Neighbours.SpectrumWeight = argument(7, 0.0);
    settings.Neighbours.Spectrum =
      ruc::MeasureSpectrum(ruc::SharePack(pack, Block), "SpectrumWeight", alone);
    std::printf("Spectrum of the pack, to %.0f um: %.2f s of CPU\n",
      settings.Neighbours.Spectrum.CutOff, CpuSeconds() - before);
    PrintTerm(
      "spectrum", contents, ruc::SpectrumTerm(contents, settings.Neighbours.Spectrum, alone));
  }
  if (argument(8, 0.0) > 0.0)
  {
    const double before = CpuSeconds();
    settings.Neighbours.ThirdOrderWeight = argument(8, 0.0);
    settings.Neighbours.ThirdOrder =
      ruc::MeasureNeighbourhoods(ruc::SharePack(pack, Block), settings.ThirdOrder, alone);
    std::printf("Third order of the pack: %.2f s of CPU\n", CpuSeconds() - before);
    PrintTerm("third order", contents,
      ruc::ThirdOrderTerm(contents, settings.Neighbours.ThirdOrder, alone));
  }
  PrintZeta("pack", pack, Block);
  std::printf("Neighbours of a sphere with a gap of at most 0.5, 1, 2, 5, 10, 20, 40 %%; P(pore > "
              "10), P(pore > 12 um); median least gap, um\n");
  const std::vector<double> whole = Measure(pack, Block, -1);
  std::vector<double> mean(whole.size(), 0.0), squares(mean), errors;
  for (int column = 0; column < Columns; ++column)
  {
    const std::vector<double> part = Measure(pack, Block, column);
    for (std::size_t n = 0; n < mean.size(); ++n)
    {
      mean[n] += part[n] / Columns;
      squares[n] += part[n] * part[n] / Columns;
    }
  }
  for (std::size_t n = 0; n < mean.size(); ++n)
  {
    errors.push_back(std::sqrt(std::max(squares[n] - mean[n] * mean[n], 0.0) / (Columns - 1)));
  }
  Print("pack", whole);
  Print("its standard error", errors);

  for (int seed = 1; seed <= static_cast<int>(argument(5, 1.0)); ++seed)
  {
    settings.Seed = seed;
    const double start = CpuSeconds();
    const ruc::UnitCell cell = ruc::SearchByGradient(
      contents, target, settings, alone, [](const ruc::SearchState&) { return true; });
    const double seconds = CpuSeconds() - start;
    Print("cell", Measure(cell.Pack, cell.Box, -1));
    const ruc::NeighbourMisfits& misfits = cell.Convergence.back().Misfits;
    std::printf(
      "seed %d: F2 %.4f after %d iterations, %s, overlap %g %%, misfits %.3g %.3g %.3g %.3g %.3g, "
      "%.1f s of CPU\n",
      seed, cell.Objective, cell.Iterations, ruc::NameOf(cell.EndedBy), cell.Overlap.Percent,
      misfits.Gaps, misfits.Nearest, misfits.Pores, misfits.Spectrum, misfits.ThirdOrder, seconds);
    PrintZeta("cell", cell.Pack, cell.Box);
  }
  return 0;
}
