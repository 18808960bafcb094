// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Images/LabelImage.h"

#include "ruc/Base/Require.h"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace ruc
{
namespace
{
bool Reaches(const Vector3& centre, double radius, const VoxelGrid& grid, const VoxelBlock& block)
{
  bool reaches = true;
  for (int q = 0; q < 3; ++q)
  {
    const auto [first, last] = VoxelsReached(centre[q] - grid.Lower[q], radius, grid.Spacing[q],
      block.First[q], block.First[q] + block.Count[q]);
    reaches = reaches && first < last;
  }
  return reaches;
}

// Calls visit(centre) for the centre of the sphere, wrapped into the box, and for its images
template <class Visit>
void ForEachImage(const SpherePack& wrapped, std::size_t i, const Window& window, Visit&& visit)
{
  // An edge exceeds the diameter, so only the nearest images can reach into the box
  const auto last = [&](int q) { return window.Periodic[q] ? 1 : 0; };
  for (int z = -last(2); z <= last(2); ++z)
  {
    for (int y = -last(1); y <= last(1); ++y)
    {
      for (int x = -last(0); x <= last(0); ++x)
      {
        const Vector3 centre = wrapped.Centre(i);
        visit(Vector3{ centre[0] + x * window.Size[0], centre[1] + y * window.Size[1],
          centre[2] + z * window.Size[2] });
      }
    }
  }
}

void SortByPriority(SpherePack& pack)
{
  std::vector<std::size_t> order(pack.Size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto key = [&](std::size_t i)
  {
    return std::tuple(pack.Mode[i], pack.Id.empty() ? 0 : pack.Id[i], pack.X[i], pack.Y[i],
      pack.Z[i], pack.Radius[i]);
  };
  std::sort(
    order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  SpherePack sorted;
  for (std::size_t i : order)
  {
    sorted.Append(pack, i);
  }
  pack = std::move(sorted);
}
}

void ValidateLabels(const LabelSettings& settings, int modes)
{
  Require(settings.Phases || settings.ParticleIds || settings.Fractions, "Label Image",
    "Phases, ParticleIds or VolumeFractions", "none of them");
  Require(
    settings.Method == FractionMethod::Exact || settings.Method == FractionMethod::Supersampled,
    "FractionMethod", "the value 0 or 1", static_cast<int>(settings.Method));
  Require(settings.SamplesPerAxis >= 1 && settings.SamplesPerAxis <= MostSamplesPerAxis,
    "SamplesPerAxis", Text("a number from 1 to ", MostSamplesPerAxis), settings.SamplesPerAxis);
  Require(!settings.Phases || modes <= MostLabelledModes, "Phases",
    Text("at most ", MostLabelledModes, " modes"), modes);
}

std::int64_t FindRaise(const SpherePack& piece, Communicator& ranks)
{
  if (!ranks.All(piece.Empty() || !piece.Id.empty()))
  {
    throw std::invalid_argument(
      "ParticleIds requires a point array 'Id', got a pack without; Points "
      "To Sphere Pack makes it.");
  }
  constexpr double most = std::numeric_limits<std::int32_t>::max();
  double range[2] = { most, most }; // the least id, and the greatest with its sign changed
  for (std::int64_t id : piece.Id)
  {
    range[0] = std::min(range[0], static_cast<double>(id));
    range[1] = std::min(range[1], -static_cast<double>(id));
  }
  ranks.Minimum(range, 2);
  const double raise = std::max(1.0 - range[0], 0.0);
  Require(raise - range[1] <= most, "ParticleIds",
    Text("ids from 1, or a lesser one, to at most ", most, " more"),
    Text("ids from ", range[0], " to ", -range[1]));
  return static_cast<std::int64_t>(raise);
}

std::int64_t CountRepeatedIds(const SpherePack& piece, Communicator& ranks)
{
  const std::size_t size = ranks.Size();
  std::vector<std::vector<std::int64_t>> outgoing(size);
  for (std::int64_t id : piece.Id)
  {
    outgoing[static_cast<std::uint64_t>(id) % size].push_back(id);
  }
  std::vector<std::int64_t> ids;
  for (const std::vector<std::int64_t>& of : ranks.AllToAll(std::move(outgoing)))
  {
    ids.insert(ids.end(), of.begin(), of.end());
  }
  std::sort(ids.begin(), ids.end());
  std::int64_t repeated = ids.end() - std::unique(ids.begin(), ids.end());
  ranks.Sum(&repeated, 1);
  return repeated;
}

SpherePack SpheresOfBlock(const SpherePack& piece, const Window& window, const VoxelGrid& grid,
  const VoxelBlock& block, std::int64_t raised, Communicator& ranks)
{
  const std::vector<VoxelBlock> blocks = ranks.AllGather(block);
  SpherePack wrapped = piece;
  WrapIntoBox(wrapped, window);
  for (std::int64_t& id : wrapped.Id)
  {
    id += raised;
  }
  std::vector<SpherePack> outgoing(ranks.Size());
  for (std::size_t i = 0; i < wrapped.Size(); ++i)
  {
    ForEachImage(wrapped, i, window,
      [&](const Vector3& centre)
      {
        for (std::size_t rank = 0; rank < blocks.size(); ++rank)
        {
          if (Reaches(centre, wrapped.Radius[i], grid, blocks[rank]))
          {
            SpherePack& to = outgoing[rank];
            to.Append(wrapped, i);
            std::tie(to.X.back(), to.Y.back(), to.Z.back()) =
              std::tie(centre[0], centre[1], centre[2]);
          }
        }
      });
  }
  wrapped = {};
  SpherePack own;
  for (SpherePack& part : ranks.AllToAll(std::move(outgoing)))
  {
    own.Append(std::exchange(part, {}));
  }
  SortByPriority(own);
  return own;
}

LabelImage::LabelImage(const VoxelGrid& grid, const VoxelBlock& block, SpherePack spheres,
  int modes, const LabelSettings& settings)
  : Grid(grid)
  , Block(block)
  , Spheres(std::move(spheres))
  , Modes(modes)
  , Settings(settings)
{
}

void LabelImage::Fill(int step, int steps, const LabelArrays& arrays) const
{
  const auto plane = [&](std::int64_t n, std::int64_t of, int begin, int count)
  { return begin + static_cast<int>(n * count / of); };
  const int begin = plane(step, steps, this->Block.First[2], this->Block.Count[2]);
  const int end = plane(step + 1, steps, this->Block.First[2], this->Block.Count[2]);
#pragma omp parallel
  {
    const int thread = omp_get_thread_num(), threads = omp_get_num_threads();
    this->FillPlanes({ plane(thread, threads, begin, end - begin),
                       plane(thread + 1, threads, begin, end - begin) },
      arrays);
  }
}

void LabelImage::FillPlanes(const VoxelRange& planes, const LabelArrays& arrays) const
{
  if (planes.First >= planes.Last || this->Block.Voxels() == 0)
  {
    return;
  }
  this->Clear(planes, arrays);
  SphereFractions fractions(this->Grid, this->Settings.Method, this->Settings.SamplesPerAxis);
  const SpherePack& pack = this->Spheres;
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    const auto [first, last] = VoxelsReached(pack.Z[i] - this->Grid.Lower[2], pack.Radius[i],
      this->Grid.Spacing[2], planes.First, planes.Last);
    if (first >= last)
    {
      continue;
    }
    if (arrays.Phase)
    {
      this->Mark(i, planes, static_cast<std::uint8_t>(pack.Mode[i]), arrays.Phase);
    }
    if (arrays.ParticleId)
    {
      this->Mark(i, planes, static_cast<std::int32_t>(pack.Id[i]), arrays.ParticleId);
    }
    if (this->Settings.Fractions)
    {
      const int place = this->Settings.EveryMode ? pack.Mode[i] : 0;
      fractions.Add(pack.Centre(i), pack.Radius[i], this->Block, planes, arrays.Fractions[place]);
    }
  }
  this->Complete(planes, arrays);
}

namespace
{
// The places of the voxels of a range of planes
std::pair<std::size_t, std::size_t> PlacesOf(const VoxelBlock& block, const VoxelRange& planes)
{
  const std::size_t plane = std::size_t(block.Count[0]) * block.Count[1];
  return { plane * (planes.First - block.First[2]), plane * (planes.Last - block.First[2]) };
}
}

void LabelImage::Clear(const VoxelRange& planes, const LabelArrays& arrays) const
{
  const auto [begin, end] = PlacesOf(this->Block, planes);
  const auto clear = [&, from = begin, to = end](auto* values)
  {
    if (values)
    {
      std::fill(values + from, values + to, 0);
    }
  };
  clear(arrays.Phase);
  clear(arrays.ParticleId);
  std::for_each(arrays.Fractions.begin(), arrays.Fractions.end(), clear);
}

template <class Label>
void LabelImage::Mark(
  std::size_t sphere, const VoxelRange& planes, Label label, Label* labels) const
{
  const double radius = this->Spheres.Radius[sphere], square = radius * radius;
  const Vector3 centre = this->Spheres.Centre(sphere);
  const VoxelBlock& block = this->Block;
  // From the sphere's centre to that of a voxel
  const auto away = [&](int q, int voxel)
  { return (voxel + 0.5) * this->Grid.Spacing[q] - (centre[q] - this->Grid.Lower[q]); };
  const auto reached = [&](int q, int first, int last)
  {
    return VoxelsReached(
      centre[q] - this->Grid.Lower[q], radius, this->Grid.Spacing[q], first, last);
  };
  const auto [beginX, endX] = reached(0, block.First[0], block.First[0] + block.Count[0]);
  const auto [beginY, endY] = reached(1, block.First[1], block.First[1] + block.Count[1]);
  const auto [beginZ, endZ] = reached(2, planes.First, planes.Last);
  for (int z = beginZ; z < endZ; ++z)
  {
    const double dz = away(2, z);
    for (int y = beginY; y < endY; ++y)
    {
      const double dy = away(1, y), yz2 = dy * dy + dz * dz;
      const double half = std::sqrt(std::max(square - yz2, 0.0)) / this->Grid.Spacing[0];
      const double middle = (centre[0] - this->Grid.Lower[0]) / this->Grid.Spacing[0] - 0.5;
      // The root tells where the row enters and leaves the sphere but for rounding
      int first =
        static_cast<int>(std::clamp<double>(std::ceil(middle - half) - 1.0, beginX, endX));
      int last =
        static_cast<int>(std::clamp<double>(std::floor(middle + half) + 2.0, beginX, endX));
      const auto outside = [&](int x)
      {
        const double dx = away(0, x);
        return !(dx * dx + yz2 <= square);
      };
      while (first < last && outside(first))
      {
        ++first;
      }
      while (first < last && outside(last - 1))
      {
        --last;
      }
      Label* row = labels +
        (std::size_t(z - block.First[2]) * block.Count[1] + (y - block.First[1])) * block.Count[0];
      for (int x = first - block.First[0]; x < last - block.First[0]; ++x)
      {
        row[x] = row[x] == 0 ? label : row[x];
      }
    }
  }
}

void LabelImage::Complete(const VoxelRange& planes, const LabelArrays& arrays) const
{
  if (!this->Settings.Fractions)
  {
    return;
  }
  const auto [begin, end] = PlacesOf(this->Block, planes);
  float* all = arrays.Fractions[0];
  if (this->Settings.EveryMode)
  {
    for (int mode = 1; mode <= this->Modes; ++mode)
    {
      float* share = arrays.Fractions[mode];
      for (std::size_t n = begin; n < end; ++n)
      {
        share[n] = std::min(share[n], 1.0f);
        all[n] += share[n];
      }
    }
  }
  for (std::size_t n = begin; n < end; ++n)
  {
    all[n] = std::min(all[n], 1.0f);
  }
  if (this->Settings.EveryMode)
  {
    float* matrix = arrays.Fractions[this->Modes + 1];
    for (std::size_t n = begin; n < end; ++n)
    {
      matrix[n] = 1.0f - all[n];
    }
  }
}

int StepsOfLabels(const VoxelGrid& grid, double largestRadius)
{
  constexpr double mostSteps = 100.0;
  const double diameters = grid.Dimensions[2] * grid.Spacing[2] / (2.0 * largestRadius);
  return static_cast<int>(std::clamp(diameters, 1.0, mostSteps));
}

double MegabytesOfLabels(double voxels, int modes, const LabelSettings& settings)
{
  const double bytes = (settings.Phases ? sizeof(std::uint8_t) : 0) +
    (settings.ParticleIds ? sizeof(std::int32_t) : 0) +
    sizeof(float) * static_cast<double>(settings.FractionArrays(modes));
  return voxels * bytes / BytesOfMegabyte;
}

Estimate EstimateLabels(
  const PackFigures& pack, const VoxelGrid& grid, const LabelSettings& settings)
{
  constexpr double secondsPerByte = 1.5e-9;
  constexpr double secondsPerRow = 4e-8; // of voxels in a sphere
  constexpr double secondsPerWedge = 1e-7;
  constexpr double secondsPerVoxelOfSphere = 4e-9; // of the box around it, for fractions
  constexpr double secondsPerSample = 8e-10;
  constexpr double bytesPerSphere = 400.0;
  const double across =
    2.0 * std::sqrt(pack.MeanSquareRadius) / std::cbrt(grid.VoxelVolume()) + 1.0;
  const double square = across * across;
  Estimate estimate;
  estimate.MegabytesOfAll = MegabytesOfLabels(grid.Voxels(), pack.Modes, settings);
  estimate.Seconds = estimate.MegabytesOfAll * BytesOfMegabyte * secondsPerByte +
    pack.Spheres * square * secondsPerRow * (settings.Phases + settings.ParticleIds);
  if (settings.Fractions)
  {
    const double border = 6.0 * square;
    estimate.Seconds += pack.Spheres *
      (square * across * secondsPerVoxelOfSphere +
        (settings.Method == FractionMethod::Exact
            ? 3.0 * square * secondsPerWedge
            : border * std::pow(settings.SamplesPerAxis, 3) * secondsPerSample));
  }
  estimate.MegabytesOfAll += pack.Spheres * bytesPerSphere / BytesOfMegabyte;
  return estimate;
}
}
