// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Packing/SphereSizes.h"

#include "ruc/Base/Require.h"
#include "ruc/Window/Window.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ruc
{
namespace
{
double NormalDistribution(double x)
{
  return 0.5 * std::erfc(-x / std::sqrt(2.0));
}

// Where the normal distribution, cut at -cut and cut, has the value `share`
double NormalQuantile(double share, double cut)
{
  const double from = NormalDistribution(-cut), to = NormalDistribution(cut);
  double low = -cut, high = cut;
  for (int n = 0; n < 60; ++n)
  {
    const double middle = 0.5 * (low + high);
    (NormalDistribution(middle) - from < share * (to - from) ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

bool IsLength(double length)
{
  return length >= LeastLength && length <= GreatestLength;
}

// Whole numbers in proportion to weights: those with the largest rests are rounded up
std::vector<int> Divide(int number, const std::vector<double>& weights)
{
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  std::vector<int> parts;
  std::vector<double> rests;
  for (double weight : weights)
  {
    const double part = number * (weight / total);
    parts.push_back(static_cast<int>(part));
    rests.push_back(part - parts.back());
  }
  for (int left = number - std::accumulate(parts.begin(), parts.end(), 0); left > 0; --left)
  {
    const auto largest = std::max_element(rests.begin(), rests.end());
    ++parts[largest - rests.begin()];
    *largest = -1.0;
  }
  return parts;
}

SphereSizes::Spheres MakeClasses(const SphereSizes& sizes, int number)
{
  const std::size_t classes = sizes.Diameters.size();
  Require(classes >= 1 && sizes.Shares.size() == classes, "Shares",
    Text("one share for each of the ", classes, " Diameters"), Text(sizes.Shares.size()));
  std::vector<double> weights;
  for (std::size_t c = 0; c < classes; ++c)
  {
    const double diameter = sizes.Diameters[c], share = sizes.Shares[c];
    Require(IsLength(diameter), "Diameters", "lengths above 0", diameter);
    Require(share > 0.0 && std::isfinite(share), "Shares", "numbers above 0", share);
    // Of the largest diameter, so that cubes neither overflow nor vanish
    const double scaled =
      diameter / *std::max_element(sizes.Diameters.begin(), sizes.Diameters.end());
    weights.push_back(
      sizes.SharesAre == ShareKind::Volume ? share / (scaled * scaled * scaled) : share);
  }
  const std::vector<int> numbers = Divide(number, weights);
  std::vector<std::size_t> order(classes);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b) { return sizes.Diameters[a] > sizes.Diameters[b]; });
  SphereSizes::Spheres spheres;
  for (std::size_t c : order)
  {
    Require(numbers[c] > 0, "NumberOfSpheres",
      Text("enough spheres for one at least of each class, such as that of diameter ",
        sizes.Diameters[c]),
      number);
    spheres.Radius.insert(spheres.Radius.end(), numbers[c], 0.5 * sizes.Diameters[c]);
    spheres.Mode.insert(spheres.Mode.end(), numbers[c], static_cast<int>(c) + 1);
  }
  return spheres;
}
}

SphereSizes::Spheres SphereSizes::Make(int number) const
{
  if (this->Law == SizeLaw::Classes)
  {
    return MakeClasses(*this, number);
  }
  const double mean = this->MeanDiameter, deviation = this->StandardDeviation;
  Require(IsLength(mean), "MeanDiameter", "a length above 0", mean);
  Spheres spheres;
  spheres.Mode.assign(number, 1);
  if (this->Law == SizeLaw::Equal)
  {
    spheres.Radius.assign(number, 0.5 * mean);
    return spheres;
  }
  Require(deviation > 0.0 && deviation <= 10.0 * mean, "StandardDeviation",
    Text("a length above 0 and up to ten times MeanDiameter, ", mean), deviation);
  Require(this->Cut > 0.0 && this->Cut <= 6.0, "Cut", "a number above 0 and up to 6", this->Cut);
  Require(this->Law != SizeLaw::Gaussian || this->Cut * deviation < 0.99 * mean,
    "StandardDeviation",
    Text("less than MeanDiameter / Cut for Gaussian sizes, so that no diameter is below 0, ",
      mean / this->Cut),
    deviation);
  // Of the logarithm of the diameter
  const double width = std::sqrt(std::log1p(deviation * deviation / (mean * mean)));
  for (int n = number; n-- > 0;)
  {
    const double x = NormalQuantile((n + 0.5) / number, this->Cut);
    const double diameter = this->Law == SizeLaw::Gaussian
      ? mean + deviation * x
      : mean * std::exp(width * x - 0.5 * width * width);
    spheres.Radius.push_back(0.5 * diameter);
  }
  return spheres;
}
}
