// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Homogenisation/PackMixture.h"

#include "ruc/Images/LabelImage.h"
#include "ruc/Images/SphereFractions.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ruc
{
namespace
{
// Spheres are cut once for each chunk of planes that they reach
constexpr int PlanesOfChunk = 16;

struct Chunk
{
  VoxelBlock Block;
  std::vector<std::vector<float>> Fractions, Normal;
  std::vector<float> Distance; // from the nearest surface
};

// Notes where a sphere's surface is the nearest, from the centres of voxels that it reaches
void FindNormals(const SpherePack& spheres, std::size_t i, const VoxelGrid& grid, Chunk& chunk)
{
  const Vector3 centre = spheres.Centre(i);
  const double radius = spheres.Radius[i];
  std::array<std::pair<int, int>, 3> reached;
  for (int q = 0; q < 3; ++q)
  {
    reached[q] = VoxelsReached(centre[q] - grid.Lower[q], radius, grid.Spacing[q],
      chunk.Block.First[q], chunk.Block.First[q] + chunk.Block.Count[q]);
  }
  const double near = 0.5 * Length(grid.Spacing);
  for (int z = reached[2].first; z < reached[2].second; ++z)
  {
    for (int y = reached[1].first; y < reached[1].second; ++y)
    {
      std::size_t place =
        (std::size_t(z - chunk.Block.First[2]) * chunk.Block.Count[1] + y) * chunk.Block.Count[0] +
        reached[0].first;
      for (int x = reached[0].first; x < reached[0].second; ++x, ++place)
      {
        const Vector3 at = grid.CentreOf(x, y, z);
        const Vector3 away = { at[0] - centre[0], at[1] - centre[1], at[2] - centre[2] };
        const double length = Length(away);
        const double distance = std::abs(length - radius);
        if (distance <= near && distance < chunk.Distance[place] && length > 0.0)
        {
          chunk.Distance[place] = static_cast<float>(distance);
          for (int q = 0; q < 3; ++q)
          {
            chunk.Normal[q][place] = static_cast<float>(away[q] / length);
          }
        }
      }
    }
  }
}

// Materials that overlap share the voxel in proportion
void LimitFractions(Chunk& chunk)
{
  for (std::size_t n = 0; n < chunk.Block.Voxels(); ++n)
  {
    float sum = 0.0f;
    for (const std::vector<float>& of : chunk.Fractions)
    {
      sum += of[n];
    }
    for (std::vector<float>& of : chunk.Fractions)
    {
      of[n] = sum > 1.0f ? of[n] / sum : of[n];
    }
  }
}

Chunk MakeChunk(const SpherePack& spheres, const VoxelGrid& grid, int first, int last,
  const std::vector<int>& materialOfMode, bool withNormals)
{
  Chunk chunk;
  chunk.Block = { { 0, 0, first }, { grid.Dimensions[0], grid.Dimensions[1], last - first } };
  const std::size_t voxels = chunk.Block.Voxels();
  const int materials = *std::max_element(materialOfMode.begin(), materialOfMode.end()) + 1;
  chunk.Fractions.assign(materials, std::vector<float>(voxels, 0.0f));
  if (withNormals)
  {
    chunk.Normal.assign(3, std::vector<float>(voxels, 0.0f));
    chunk.Distance.assign(voxels, std::numeric_limits<float>::max());
  }
  SphereFractions fractions(grid, FractionMethod::Exact, 1);
  for (std::size_t i = 0; i < spheres.Size(); ++i)
  {
    const auto [from, to] =
      VoxelsReached(spheres.Z[i] - grid.Lower[2], spheres.Radius[i], grid.Spacing[2], first, last);
    if (from >= to)
    {
      continue;
    }
    const int material = materialOfMode[spheres.Mode[i] - 1];
    fractions.Add(spheres.Centre(i), spheres.Radius[i], chunk.Block, { first, last },
      chunk.Fractions[material].data());
    if (withNormals)
    {
      FindNormals(spheres, i, grid, chunk);
    }
  }
  LimitFractions(chunk);
  return chunk;
}
}

std::vector<int> WantedPlanes(const CellSlab& slab)
{
  std::vector<int> planes(slab.VoxelPlanes());
  for (int n = 0; n < slab.VoxelPlanes(); ++n)
  {
    planes[n] = slab.SourceOf(2, slab.PlaneOf(n));
  }
  std::sort(planes.begin(), planes.end());
  planes.erase(std::unique(planes.begin(), planes.end()), planes.end());
  return planes;
}

void MixtureOfPack(const SpherePack& piece, const Window& window, const CellSlab& slab,
  const std::vector<int>& materialOfMode, bool withNormals, Communicator& ranks,
  const VisitMixture& visit)
{
  const VoxelGrid& grid = slab.Source;
  const std::vector<int> wanted = WantedPlanes(slab);
  VoxelBlock block;
  if (!wanted.empty())
  {
    block = { { 0, 0, wanted.front() },
      { grid.Dimensions[0], grid.Dimensions[1], wanted.back() + 1 - wanted.front() } };
  }
  const SpherePack spheres = SpheresOfBlock(piece, window, grid, block, 0, ranks);
  std::vector<std::pair<int, int>> chunks;
  for (int plane : wanted)
  {
    if (chunks.empty() || plane > chunks.back().second ||
      plane - chunks.back().first == PlanesOfChunk)
    {
      chunks.emplace_back(plane, plane);
    }
    chunks.back().second = plane + 1;
  }
#pragma omp parallel for schedule(dynamic)
  for (std::size_t n = 0; n < chunks.size(); ++n)
  {
    const auto [first, last] = chunks[n];
    const Chunk chunk = MakeChunk(spheres, grid, first, last, materialOfMode, withNormals);
    for (int plane = first; plane < last; ++plane)
    {
      const std::size_t begin =
        std::size_t(plane - first) * grid.Dimensions[0] * grid.Dimensions[1];
      PlaneMixture mixture = {};
      for (const std::vector<float>& of : chunk.Fractions)
      {
        mixture.Fractions.push_back(of.data() + begin);
      }
      for (int q = 0; withNormals && q < 3; ++q)
      {
        mixture.Normal[q] = chunk.Normal[q].data() + begin;
      }
      visit(plane, mixture);
    }
  }
}
}
