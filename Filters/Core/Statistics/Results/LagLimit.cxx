// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Results/LagLimit.h"

#include "ruc/Base/Require.h"
#include "ruc/Base/Text.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ruc
{
namespace
{
constexpr double PeriodicEdges = 4.0;
constexpr double ShareOfLength = 0.999;
constexpr double FinestSpacing = 1e-9; // of the shortest edge

double LargestPairLag(const Window& window, double largestRadius)
{
  return window.IsFullyPeriodic() ? PeriodicEdges * window.ShortestEdge()
                                  : (window.Reach() - 2.0 * largestRadius) * ShareOfLength;
}

double LargestSampledLag(const Window& sampled)
{
  return (sampled.IsFullyPeriodic() ? PeriodicEdges : ShareOfLength) * sampled.ShortestEdge();
}

double LargestReach(const Window& window, double largestRadius)
{
  if (window.GetShape() == Window::Shape::Box)
  {
    return LargestPairLag(window, largestRadius);
  }
  // The corners of the cube reach farthest, both along the axis and across it
  double along = 0.0, across = 0.0;
  for (int corner = 0; corner < 4; ++corner)
  {
    const double a = std::abs(window.Axis[0] + (corner & 1 ? -1.0 : 1.0) * window.Axis[1] +
      (corner & 2 ? -1.0 : 1.0) * window.Axis[2]);
    along = std::max(along, a);
    across = std::max(across, std::sqrt(std::max(3.0 - a * a, 0.0)));
  }
  return ShareOfLength *
    std::min((window.Height - 2.0 * largestRadius) / along,
      2.0 * (window.Radius - largestRadius) / across);
}

std::string DescribePack(const Window& window, double largestRadius)
{
  return Text(
    " for this ", window.Describe(), " and spheres of up to ", 2.0 * largestRadius, " diameter");
}

std::string DescribeLack(const Window& window, double largestRadius)
{
  return Text("The window requires edges longer than the largest sphere's diameter, ",
    2.0 * largestRadius, ", got a ", window.Describe(), ".");
}
}

LagLimit::LagLimit(double automatic, double largest, double shortestEdge, std::string where)
  : Automatic(std::min(automatic, largest))
  , Largest(largest)
  , Finest(FinestSpacing * shortestEdge)
  , Where(std::move(where))
{
}

LagLimit LagLimit::ForPairSum(const Window& window, double largestRadius)
{
  LagLimit limit(0.5 * window.ShortestEdge(), LargestPairLag(window, largestRadius),
    window.ShortestEdge(), DescribePack(window, largestRadius));
  limit.Lack = DescribeLack(window, largestRadius);
  return limit;
}

LagLimit LagLimit::ForMap(const Window& window, double largestRadius, double lag)
{
  LagLimit limit(lag, LargestReach(window, largestRadius), window.ShortestEdge(),
    DescribePack(window, largestRadius));
  limit.Required = "Spacing x Resolution requires a length > 0 and <= ";
  limit.SpacingName = "Spacing";
  limit.Lack = DescribeLack(window, largestRadius);
  return limit;
}

LagLimit LagLimit::ForDistances(const Window& window, int numberOfLags)
{
  // The last distance is r_K + Spacing / 2 = r_K (1 + 1 / 2K)
  return { 0.5 * window.ShortestEdge(), LargestPairLag(window, 0.0) / (1.0 + 0.5 / numberOfLags),
    window.ShortestEdge(),
    Text(" for distances of centres in this ", window.Describe(), " in ", numberOfLags, " bins") };
}

LagLimit LagLimit::ForSampling(const Window& window, const Window& sampled)
{
  return { 0.5 * window.ShortestEdge(), LargestSampledLag(sampled), window.ShortestEdge() };
}

LagLimit LagLimit::ForFans(const Window& window, const Window& sampled)
{
  const bool periodic = sampled.IsFullyPeriodic();
  return { (periodic ? 0.5 : 0.25) * window.ShortestEdge(),
    LargestSampledLag(sampled) * (periodic ? 1.0 : 0.5), window.ShortestEdge() };
}

LagLimit LagLimit::ForCell(double edge)
{
  return { 0.5 * edge, 2.0 * edge, edge, Text(" for a cell of edge ", edge) };
}

LagGrid LagLimit::MakeGrid(double maximum, int numberOfLags) const
{
  Require(std::isfinite(maximum) && maximum >= 0.0, "MaximumLag",
    "a finite number >= 0 (0: automatic)", maximum);
  Require(numberOfLags >= 1 && numberOfLags <= MostLags, "NumberOfLags",
    Text("1 <= NumberOfLags <= ", MostLags), numberOfLags);
  this->RequireRoom();
  return { (maximum > 0.0 ? maximum : this->Automatic) / numberOfLags, numberOfLags };
}

void LagLimit::Check(double maximum) const
{
  this->RequireRoom();
  constexpr double rounding = 1.0 + 1e-12;
  if (!(maximum > 0.0 && maximum <= this->Largest * rounding))
  {
    throw std::invalid_argument(
      Text(this->Required, this->Largest, this->Where, ", got ", maximum, "."));
  }
}

void LagLimit::CheckSpacing(double spacing) const
{
  if (!(spacing >= this->Finest))
  {
    throw std::invalid_argument(Text(
      this->SpacingName, " requires at least ", this->Finest, this->Where, ", got ", spacing, "."));
  }
}

void LagLimit::Check(const LagGrid& lags) const
{
  this->Check(lags.Maximum());
  this->CheckSpacing(lags.Spacing);
}

void LagLimit::RequireRoom() const
{
  if (!this->Lack.empty() && !(this->Largest > 0.0))
  {
    throw std::invalid_argument(this->Lack);
  }
}
}
