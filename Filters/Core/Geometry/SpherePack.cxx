// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/SpherePack.h"

#include "Text.h"

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

void ValidatePack(const SpherePack& pack, bool withModes)
{
  if (pack.Empty())
  {
    throw std::invalid_argument("The input requires at least one sphere, got no points.");
  }
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    if (!(std::isfinite(pack.X[i]) && std::isfinite(pack.Y[i]) && std::isfinite(pack.Z[i])))
    {
      throw std::invalid_argument(Text("Points require finite coordinates, got (", pack.X[i], ", ",
        pack.Y[i], ", ", pack.Z[i], ")."));
    }
    if (!(std::isfinite(pack.Radius[i]) && pack.Radius[i] > 0.0))
    {
      throw std::invalid_argument(Text("Array 'Radius' requires finite values > 0, got ",
        pack.Radius[i], " for ", At(pack, i), "."));
    }
  }
  for (std::size_t i = 1; i < pack.Size(); ++i)
  {
    if (pack.Centre(i) == pack.Centre(i - 1))
    {
      throw std::invalid_argument(Text("Points require distinct centres, got two spheres at (",
        pack.X[i], ", ", pack.Y[i], ", ", pack.Z[i], ")."));
    }
  }
  if (!withModes)
  {
    return;
  }
  std::vector<bool> seen;
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    // More modes than spheres cannot be without a gap; this also keeps a wild value from sizing the
    // table.
    if (pack.Mode[i] < 1 || std::size_t(pack.Mode[i]) > pack.Size())
    {
      throw std::invalid_argument(
        Text("Array 'Mode' requires the values 1 to the number of modes without a gap, got ",
          pack.Mode[i], " for ", At(pack, i), "."));
    }
    if (std::size_t(pack.Mode[i]) > seen.size())
    {
      seen.resize(pack.Mode[i], false);
    }
    seen[pack.Mode[i] - 1] = true;
  }
  const auto gap = std::find(seen.begin(), seen.end(), false);
  if (gap != seen.end())
  {
    throw std::invalid_argument(Text("Array 'Mode' requires the values 1 to the number of modes "
                                     "without a gap, got no sphere of mode ",
      gap - seen.begin() + 1, " but some of mode ", seen.size(), "."));
  }
}

void ValidateWindow(const SpherePack& pack, const Window& window)
{
  std::size_t outside = 0;
  std::size_t first = 0;
  for (std::size_t i = pack.Size(); i-- > 0;)
  {
    if (!window.Contains(pack.Centre(i)))
    {
      ++outside;
      first = i;
    }
  }
  if (outside > 0)
  {
    throw std::invalid_argument(
      Text("The ", window.Describe(), " requires every centre inside, got ", outside, " of ",
        pack.Size(), " outside, such as ", At(pack, first), "."));
  }
  const double diameter = 2.0 * pack.LargestRadius();
  for (int q = 0; q < 3; ++q)
  {
    if (window.Periodic[q] && !(window.Size[q] > diameter))
    {
      throw std::invalid_argument(
        Text("BoxSize requires periodic edges longer than the largest sphere's diameter, ",
          diameter, ", got ", window.Size[0], " ", window.Size[1], " ", window.Size[2], "."));
    }
  }
  if (window.IsPeriodic())
  {
    SpherePack wrapped = pack;
    WrapIntoBox(wrapped, window);
    SortCanonically(wrapped);
    for (std::size_t i = 1; i < wrapped.Size(); ++i)
    {
      if (wrapped.Centre(i) == wrapped.Centre(i - 1))
      {
        throw std::invalid_argument(Text("A periodic box requires each sphere once, got ",
          At(wrapped, i), " together with its periodic image."));
      }
    }
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
      c -= box.Size[q] * std::floor((c - box.Origin[q]) / box.Size[q]);
      if (!(c >= box.Origin[q] &&
            c < box.Origin[q] + box.Size[q])) // rounding, for a centre just off a face
      {
        c = box.Origin[q];
      }
    }
  }
}
}
