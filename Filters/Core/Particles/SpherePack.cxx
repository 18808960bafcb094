// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Particles/SpherePack.h"

#include "ruc/Base/Text.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <tuple>

namespace ruc
{
namespace
{
template <class T>
void Permute(std::vector<T>& values, const std::vector<std::size_t>& order)
{
  if (values.empty())
  {
    return;
  }
  std::vector<T> sorted(order.size());
  std::transform(
    order.begin(), order.end(), sorted.begin(), [&](std::size_t i) { return values[i]; });
  values = std::move(sorted);
}

std::string At(const SpherePack& pack, std::size_t i)
{
  return Text("the sphere at (", pack.X[i], ", ", pack.Y[i], ", ", pack.Z[i], ")");
}
}

int SpherePack::NumberOfModes() const
{
  return this->Mode.empty() ? 0 : *std::max_element(this->Mode.begin(), this->Mode.end());
}

double SpherePack::LargestRadius() const
{
  return this->Radius.empty() ? 0.0 : *std::max_element(this->Radius.begin(), this->Radius.end());
}

void SpherePack::Append(const SpherePack& other, std::size_t i)
{
  this->X.push_back(other.X[i]);
  this->Y.push_back(other.Y[i]);
  this->Z.push_back(other.Z[i]);
  this->Radius.push_back(other.Radius[i]);
  if (!other.Mode.empty())
  {
    this->Mode.push_back(other.Mode[i]);
  }
  if (!other.Id.empty())
  {
    this->Id.push_back(other.Id[i]);
  }
}

void SpherePack::Append(const SpherePack& other)
{
  const auto append = [](auto& values, const auto& others)
  { values.insert(values.end(), others.begin(), others.end()); };
  append(this->X, other.X);
  append(this->Y, other.Y);
  append(this->Z, other.Z);
  append(this->Radius, other.Radius);
  append(this->Mode, other.Mode);
  append(this->Id, other.Id);
}

void SortCanonically(SpherePack& pack)
{
  const auto key = [&](std::size_t i)
  {
    return std::make_tuple(
      pack.X[i], pack.Y[i], pack.Z[i], pack.Radius[i], pack.Mode.empty() ? 0 : pack.Mode[i]);
  };
  std::vector<std::size_t> order(pack.Size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(
    order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return key(i) < key(j); });
  Permute(pack.X, order);
  Permute(pack.Y, order);
  Permute(pack.Z, order);
  Permute(pack.Radius, order);
  Permute(pack.Mode, order);
  Permute(pack.Id, order);
}

const char* const NoSpheres = "The input requires at least one sphere, got no points.";

std::string FindFaultySphere(const SpherePack& pack, bool withModes, std::int64_t total)
{
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    if (!(std::isfinite(pack.X[i]) && std::isfinite(pack.Y[i]) && std::isfinite(pack.Z[i])))
    {
      return Text("Points require finite coordinates, got (", pack.X[i], ", ", pack.Y[i], ", ",
        pack.Z[i], ").");
    }
    if (!(std::isfinite(pack.Radius[i]) && pack.Radius[i] > 0.0))
    {
      return Text("Array 'Radius' requires finite values > 0, got ", pack.Radius[i], " for ",
        At(pack, i),
        pack.Radius[i] == 0.0 ? "; Particle Modes with a MinimumDiameter leaves such points out."
                              : ".");
    }
    if (pack.Radius[i] < LeastLength || pack.Radius[i] > GreatestLength)
    {
      return Text("Array 'Radius' requires values from ", LeastLength, " to ", GreatestLength,
        ", got ", pack.Radius[i], " for ", At(pack, i), "; try another unit.");
    }
    if (std::abs(pack.X[i]) > GreatestLength || std::abs(pack.Y[i]) > GreatestLength ||
      std::abs(pack.Z[i]) > GreatestLength)
    {
      return Text("Points require coordinates of at most ", GreatestLength, ", got ", At(pack, i),
        "; try another unit.");
    }
    // More modes than spheres cannot be without a gap. The check also keeps a wild value from
    // sizing the table of modes.
    if (withModes && (pack.Mode[i] < 1 || pack.Mode[i] > total))
    {
      return Text("Array 'Mode' requires the values 1 to the number of modes without a gap, got ",
        pack.Mode[i], " for ", At(pack, i), ".");
    }
  }
  return {};
}

std::string FindCoincidence(const SpherePack& pack, const Window& window)
{
  for (std::size_t i = 1; i < pack.Size(); ++i)
  {
    if (pack.Centre(i) == pack.Centre(i - 1))
    {
      return Text("Points require distinct centres, got two spheres at (", pack.X[i], ", ",
        pack.Y[i], ", ", pack.Z[i], ")", window.IsPeriodic() ? " or a periodic image of it." : ".");
    }
  }
  return {};
}

std::string FindModeGap(const std::vector<std::int64_t>& counts)
{
  const auto gap = std::find(counts.begin(), counts.end(), 0);
  return gap == counts.end()
    ? ""
    : Text("Array 'Mode' requires the values 1 to the number of modes without a gap, got no sphere "
           "of mode ",
        gap - counts.begin() + 1, " but some of mode ", counts.size(), ".");
}

std::string FindNarrowEdge(double largestRadius, const Window& window)
{
  const double diameter = 2.0 * largestRadius;
  for (int q = 0; q < 3; ++q)
  {
    if (window.Periodic[q] && !(window.Size[q] > diameter))
    {
      return Text("BoxSize requires periodic edges longer than the largest sphere's diameter, ",
        diameter, ", got ", window.Size[0], " ", window.Size[1], " ", window.Size[2], ".");
    }
  }
  return window.ShortestEdge() > diameter
    ? ""
    : Text("The window requires edges longer than the largest sphere's diameter, ", diameter,
        ", got a ", window.Describe(), ".");
}

std::string FindOutside(const SpherePack& pack, const Window& window, std::int64_t& count)
{
  count = 0;
  std::string first;
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    if (!window.Contains(pack.Centre(i)))
    {
      first = count++ == 0 ? At(pack, i) : first;
    }
  }
  return first;
}

std::string OutsideMessage(
  const Window& window, std::int64_t count, std::int64_t total, const std::string& example)
{
  return Text("The ", window.Describe(), " requires every centre inside, got ", count, " of ",
    total, " outside, such as ", example, ": CropToWindow leaves them out.");
}

namespace
{
void ThrowIf(const std::string& error)
{
  if (!error.empty())
  {
    throw std::invalid_argument(error);
  }
}
}

void ValidatePack(const SpherePack& pack, bool withModes)
{
  ThrowIf(pack.Empty() ? NoSpheres : "");
  ThrowIf(FindFaultySphere(pack, withModes, static_cast<std::int64_t>(pack.Size())));
  ThrowIf(FindCoincidence(pack, Window()));
  if (withModes)
  {
    std::vector<std::int64_t> counts(pack.NumberOfModes(), 0);
    for (int mode : pack.Mode)
    {
      ++counts[mode - 1];
    }
    ThrowIf(FindModeGap(counts));
  }
}

void ValidateWindow(const SpherePack& pack, const Window& window)
{
  std::int64_t outside = 0;
  const std::string example = FindOutside(pack, window, outside);
  ThrowIf(example.empty() ? "" : OutsideMessage(window, outside, pack.Size(), example));
  ThrowIf(FindNarrowEdge(pack.LargestRadius(), window));
  if (window.IsPeriodic())
  {
    SpherePack wrapped = pack;
    WrapIntoBox(wrapped, window);
    SortCanonically(wrapped);
    ThrowIf(FindCoincidence(wrapped, window));
  }
}

SpherePack CropToWindow(const SpherePack& pack, const Window& window)
{
  SpherePack inside;
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    if (window.Contains(pack.Centre(i)))
    {
      inside.Append(pack, i);
    }
  }
  return inside;
}

namespace
{
double Wrap(double c, double origin, double edge)
{
  c -= edge * std::floor((c - origin) / edge);
  return c >= origin && c < origin + edge ? c : origin; // rounding, for a centre just off a face
}
}

void WrapIntoBox(SpherePack& pack, const Window& box)
{
  std::vector<double>* axes[3] = { &pack.X, &pack.Y, &pack.Z };
  for (int q = 0; q < 3; ++q)
  {
    if (!box.Periodic[q])
    {
      continue;
    }
    for (double& c : *axes[q])
    {
      c = Wrap(c, box.Origin[q], box.Size[q]);
    }
  }
}

bool MoveIntoBox(Vector3& centre, const Window& box)
{
  constexpr double mostEdges = 1e6;
  bool moved = false;
  for (int q = 0; q < 3; ++q)
  {
    if (box.Periodic[q] && !box.ContainsAlong(q, centre[q]) &&
      std::abs(centre[q] - box.Origin[q]) <= mostEdges * box.Size[q])
    {
      centre[q] = Wrap(centre[q], box.Origin[q], box.Size[q]);
      moved = true;
    }
  }
  return moved;
}

std::int64_t MoveIntoBox(SpherePack& pack, const Window& box)
{
  std::int64_t moved = 0;
  for (std::size_t i = 0; box.IsPeriodic() && i < pack.Size(); ++i)
  {
    Vector3 centre = pack.Centre(i);
    if (MoveIntoBox(centre, box))
    {
      pack.X[i] = centre[0];
      pack.Y[i] = centre[1];
      pack.Z[i] = centre[2];
      ++moved;
    }
  }
  return moved;
}

std::vector<double> CentresOf(const SpherePack& pack)
{
  std::vector<double> centres;
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    centres.insert(centres.end(), { pack.X[i], pack.Y[i], pack.Z[i] });
  }
  return centres;
}

void SetCentres(SpherePack& pack, const Window& box, const double* centres)
{
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    pack.X[i] = centres[3 * i];
    pack.Y[i] = centres[3 * i + 1];
    pack.Z[i] = centres[3 * i + 2];
  }
  WrapIntoBox(pack, box);
}
}
