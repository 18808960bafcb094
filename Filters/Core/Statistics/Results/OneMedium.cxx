// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Results/OneMedium.h"
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <numeric>
#include <sstream>

namespace ruc
{
namespace
{
// Layers with the sums over them of what the particles have more than their share, and the
// covariance of these sums for noise of variance 1 in each cell
struct Layers
{
  std::vector<double> Excess;
  std::vector<std::vector<double>> Covariance;
  std::vector<double> Fraction;
};

// Returns x . A^-1 x for a positive definite A, by elimination
double QuadraticForm(std::vector<std::vector<double>> a, std::vector<double> x)
{
  const std::size_t size = x.size();
  double form = 0.0;
  for (std::size_t n = 0; n < size; ++n)
  {
    form += x[n] * x[n] / a[n][n];
    for (std::size_t m = n + 1; m < size; ++m)
    {
      const double factor = a[m][n] / a[n][n];
      x[m] -= factor * x[n];
      for (std::size_t q = n; q < size; ++q)
      {
        a[m][q] -= factor * a[n][q];
      }
    }
  }
  return form;
}

// The ratio F of two mean squares with so many degrees of freedom, as a standard normal deviate
double DeviateOf(double ratio, double above, double below)
{
  const double a = 2.0 / (9.0 * above), b = 2.0 / (9.0 * below), root = std::cbrt(ratio);
  return ((1.0 - b) * root - (1.0 - a)) / std::sqrt(a + b * root * root);
}

LayerTest Judge(const Layers& layers, const std::string& axis, double varianceOfCell, double below)
{
  LayerTest test;
  test.Axis = axis;
  test.First = layers.Fraction.front();
  test.Last = layers.Fraction.back();
  const auto ends = std::minmax_element(layers.Fraction.begin(), layers.Fraction.end());
  test.Least = *ends.first;
  test.Most = *ends.second;
  test.Freedoms = static_cast<int>(layers.Excess.size()) - 1;
  test.ChiSquared =
    varianceOfCell > 0.0 ? QuadraticForm(layers.Covariance, layers.Excess) / varianceOfCell : 0.0;
  test.Deviate = DeviateOf(test.ChiSquared / test.Freedoms, test.Freedoms, below);
  return test;
}

Layers FindLayers(const TaperedBlocks& blocks, int axis, const std::vector<double>& volumes,
  double fraction, double volumeOfCell)
{
  const int count = blocks.CountAlong(axis);
  Layers layers = { std::vector<double>(count, 0.0),
    std::vector<std::vector<double>>(count, std::vector<double>(count, 0.0)), {} };
  std::vector<double> sizes(count, 0.0);
  for (int cell = 0; cell < blocks.Cells(); ++cell)
  {
    const int at = blocks.PlaceOfCell(cell)[axis];
    for (int n = 0; n < count; ++n)
    {
      const double weight = blocks.WeightAlong(axis, n, at) / 8.0;
      layers.Excess[n] += weight * volumes[cell];
      if (blocks.IsInside(cell))
      {
        sizes[n] += weight;
        for (int m = 0; m < count; ++m)
        {
          layers.Covariance[n][m] += weight * blocks.WeightAlong(axis, m, at) / 8.0;
        }
      }
    }
  }
  for (int n = 0; n < count; ++n)
  {
    layers.Excess[n] -= fraction * sizes[n] * volumeOfCell;
    layers.Fraction.push_back(fraction + layers.Excess[n] / (sizes[n] * volumeOfCell));
  }
  return layers;
}
}

std::vector<LayerTest> TestLayers(const TaperedBlocks& blocks, const std::vector<double>& volumes,
  const std::vector<double>& rings, double volume)
{
  const double all = std::accumulate(volumes.begin(), volumes.end(), 0.0);
  const double volumeOfCell = volume / blocks.CellsInside();
  std::vector<double> parts(blocks.Count(), 0.0);
  for (int cell = 0; cell < blocks.Cells(); ++cell)
  {
    blocks.ForEachBlock(cell,
      [&](int block, int weight)
      { parts[block] += weight * volumes[cell] / TaperedBlocks::WholeWeight; });
  }
  std::vector<LayerTest> tests;
  // Across the axis of a cylinder there are rings instead of layers
  for (int axis = rings.empty() ? 0 : 2; axis < 3; ++axis)
  {
    std::vector<int> of;
    of.reserve(blocks.Count());
    for (int block = 0; block < blocks.Count(); ++block)
    {
      of.push_back(blocks.MirrorGroup(block, axis));
    }
    const TaperedBlocks::Groups groups = blocks.MakeGroups(std::move(of));
    const double below = double(blocks.Count()) - double(groups.Sizes.size());
    if (blocks.CountAlong(axis) > 1 && below >= 2.0)
    {
      const double variance = TaperedBlocks::SquaresWithin(groups, parts) / groups.ExpectedSquares;
      const std::string name = rings.empty() ? std::string(1, char('x' + axis)) : "axis";
      tests.push_back(Judge(
        FindLayers(blocks, axis, volumes, all / volume, volumeOfCell), name, variance, below));
    }
  }
  if (!rings.empty())
  {
    const double count = static_cast<double>(rings.size()), cells = blocks.CellsInside() / count;
    Layers layers;
    for (std::size_t n = 0; n < rings.size(); ++n)
    {
      layers.Excess.push_back(rings[n] - all / count);
      layers.Fraction.push_back(rings[n] / volume * count);
      layers.Covariance.push_back(std::vector<double>(rings.size(), 0.0));
      layers.Covariance.back()[n] = cells;
    }
    tests.push_back(Judge(
      layers, "radius", blocks.VarianceOfSum(parts) / blocks.CellsInside(), 0.5 * blocks.Count()));
  }
  return tests;
}

std::string LayerTest::Describe() const
{
  const bool named = this->Axis == "axis" || this->Axis == "radius";
  std::ostringstream text;
  text << std::fixed << std::setprecision(4) << "Along " << (named ? "the " : "") << this->Axis
       << " the fraction of the particles goes from " << this->First << " to " << this->Last
       << ", with layers from " << this->Least << " to " << this->Most
       << ", more than their scatter explains (" << std::setprecision(1) << this->Deviate
       << " standard deviations).";
  return text.str();
}

std::string DescribeFailures(const std::vector<LayerTest>& tests)
{
  std::string text;
  for (const LayerTest& test : tests)
  {
    text += test.Passed() ? "" : (text.empty() ? "" : " ") + test.Describe();
  }
  return text;
}
}
