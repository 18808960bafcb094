// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Packing/SphereSizes.h"

#include "ruc/Base/Require.h"
#include "ruc/Window/Window.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
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

// The n-th of `number` quantiles of the diameters, which are steps, is that of the middle of its
// part; so the diameters themselves come out where there are as many
std::vector<double> QuantilesOf(std::vector<double> diameters, int number)
{
  std::sort(diameters.begin(), diameters.end());
  const auto measured = static_cast<std::int64_t>(diameters.size());
  std::vector<double> radii;
  for (int n = number; n-- > 0;)
  {
    radii.push_back(0.5 * diameters[(2 * std::int64_t(n) + 1) * measured / (2 * number)]);
  }
  return radii;
}

// The density of the number of spheres goes as D^-3 between two sieves, so that of their volume is
// even there. All follows in closed form from D^-2, which is evenly spread over the spheres.
std::vector<double> BetweenSieves(double narrow, double wide, int number)
{
  const double steps = (wide / narrow) * (wide / narrow) - 1.0;
  // The diameter, of that of the wide sieve, that n spheres exceed
  const auto edge = [&](int n) { return 1.0 / std::sqrt(1.0 + steps * n / number); };
  std::vector<double> radii;
  for (int n = 0; n < number; ++n)
  {
    const double a = edge(n), b = edge(n + 1);
    radii.push_back(0.5 * wide * std::cbrt(2.0 * a * a * b * b / (a + b)));
  }
  return radii;
}

std::vector<double> MakeSieved(const SphereSizes& sizes, int number)
{
  const std::vector<double>&openings = sizes.Diameters, &passing = sizes.Passing;
  Require(openings.size() >= 2 && passing.size() == openings.size(), "Passing",
    "two sieves or more, and one number for each", passing.size());
  const double widest = openings.back();
  std::vector<double> weights; // numbers of spheres
  for (std::size_t s = 0; s + 1 < openings.size(); ++s)
  {
    const double a = openings[s] / widest, b = openings[s + 1] / widest;
    const double share = passing[s + 1] - passing[s];
    Require(a > 0.0 && b > a, "Diameters", "openings that rise", openings[s + 1]);
    Require(share >= 0.0 && share <= 100.0, "Passing", "numbers that do not fall", passing[s + 1]);
    weights.push_back(share * (a + b) / (2.0 * a * a * b * b));
  }
  Require(passing.front() == 0.0 && passing.back() == 100.0, "Passing", "numbers from 0 to 100",
    passing.back());
  const std::vector<int> numbers = Divide(number, weights);
  std::vector<double> radii;
  for (std::size_t s = numbers.size(); s-- > 0;)
  {
    Require(numbers[s] > 0 || weights[s] == 0.0, "NumberOfSpheres",
      Text("enough spheres for one at least between any two sieves, such as those of ", openings[s],
        " and ", openings[s + 1]),
      number);
    const std::vector<double> between = BetweenSieves(openings[s], openings[s + 1], numbers[s]);
    radii.insert(radii.end(), between.begin(), between.end());
  }
  return radii;
}

std::vector<double> MakeMeasured(const SphereSizes& sizes, int number)
{
  Require(!sizes.Diameters.empty(), "Diameters", "one diameter at least", 0);
  for (double diameter : sizes.Diameters)
  {
    Require(IsLength(diameter), "Diameters", "lengths above 0", diameter);
  }
  return sizes.Passing.empty() ? QuantilesOf(sizes.Diameters, number) : MakeSieved(sizes, number);
}
}

SphereSizes::Spheres SphereSizes::Make(int number) const
{
  if (this->Law == SizeLaw::Classes)
  {
    return MakeClasses(*this, number);
  }
  if (this->Law == SizeLaw::Measured)
  {
    return { MakeMeasured(*this, number), std::vector<int>(number, 1) };
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
