// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/**
 * @file
 * Small images of phases, and counts of them by their definitions.
 */

#include "Oracles.h"
#include "ruc/Images/PhaseSlab.h"
#include "ruc/Statistics/Voxels/ImageCorrelation.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace oracle
{
using Triple = std::array<int, 3>;

/** A whole image. */
struct PhaseImage
{
  Triple Dimensions;
  std::vector<std::uint8_t> Phases;

  std::uint8_t At(int x, int y, int z) const
  {
    return this->Phases[(std::size_t(z) * this->Dimensions[1] + y) * this->Dimensions[0] + x];
  }

  /** The slab of a rank. The blocks that the ranks have of the image overlap by a plane. */
  ruc::PhaseSlab Spread(ruc::Communicator& ranks, int axis = 2) const
  {
    ruc::PhaseBlock own;
    const ruc::Slabs parts = { this->Dimensions[0], ranks.Size() };
    const int begin = static_cast<int>(parts.Begin(ranks.Rank()));
    const int end = std::min(static_cast<int>(parts.End(ranks.Rank())) + 1, this->Dimensions[0]);
    own.Block = { { begin, 0, 0 }, { end - begin, this->Dimensions[1], this->Dimensions[2] } };
    for (int z = 0; z < this->Dimensions[2]; ++z)
    {
      for (int y = 0; y < this->Dimensions[1]; ++y)
      {
        for (int x = begin; x < end; ++x)
        {
          own.Phases.push_back(this->At(x, y, z));
        }
      }
    }
    return ruc::SpreadPhases(own, this->Dimensions, axis, ranks);
  }
};

/** Random phases in lumps of two voxels, some outside of a mask. */
inline PhaseImage RandomImage(const Triple& dimensions, int phases, bool masked, unsigned seed)
{
  PhaseImage image = { dimensions, {} };
  std::mt19937 engine(seed);
  std::vector<std::uint8_t> lumps;
  for (int n = 0; n < 4096; ++n)
  {
    lumps.push_back(static_cast<std::uint8_t>(engine() % phases));
  }
  for (int z = 0; z < dimensions[2]; ++z)
  {
    for (int y = 0; y < dimensions[1]; ++y)
    {
      for (int x = 0; x < dimensions[0]; ++x)
      {
        const bool outside = masked && engine() % 5 == 0;
        image.Phases.push_back(
          outside ? ruc::OutsideMask : lumps[(x / 2 + 16 * (y / 2) + 256 * (z / 2)) % 4096]);
      }
    }
  }
  return image;
}

/** A_rs(x) of every r and s by its definition, at r `phases` + s. */
inline std::vector<long> CountPairs(
  const PhaseImage& image, const std::array<bool, 3>& periodic, int phases, const Triple& lag)
{
  std::vector<long> counts(phases * phases, 0);
  for (int z = 0; z < image.Dimensions[2]; ++z)
  {
    for (int y = 0; y < image.Dimensions[1]; ++y)
    {
      for (int x = 0; x < image.Dimensions[0]; ++x)
      {
        Triple to = { x + lag[0], y + lag[1], z + lag[2] };
        bool in = image.At(x, y, z) != ruc::OutsideMask;
        for (int q = 0; q < 3; ++q)
        {
          const int n = image.Dimensions[q];
          in = in && (periodic[q] || (to[q] >= 0 && to[q] < n));
          to[q] = (to[q] % n + n) % n;
        }
        if (in && image.At(to[0], to[1], to[2]) != ruc::OutsideMask)
        {
          ++counts[image.At(x, y, z) * phases + image.At(to[0], to[1], to[2])];
        }
      }
    }
  }
  return counts;
}

/** Labels the centres of voxels of edge 1: mode - 1 of the sphere that holds it, else `matrix`. */
inline PhaseImage Voxelise(
  const ruc::SpherePack& pack, const Triple& dimensions, bool periodic, int matrix)
{
  PhaseImage image = { dimensions, {} };
  image.Phases.assign(
    std::size_t(dimensions[0]) * dimensions[1] * dimensions[2], static_cast<std::uint8_t>(matrix));
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    const double centre[3] = { pack.X[i], pack.Y[i], pack.Z[i] }, radius = pack.Radius[i];
    Triple first, last;
    for (int q = 0; q < 3; ++q)
    {
      first[q] = static_cast<int>(std::floor(centre[q] - radius));
      last[q] = static_cast<int>(std::ceil(centre[q] + radius));
    }
    for (int z = first[2]; z <= last[2]; ++z)
    {
      for (int y = first[1]; y <= last[1]; ++y)
      {
        for (int x = first[0]; x <= last[0]; ++x)
        {
          const double dx = x + 0.5 - centre[0], dy = y + 0.5 - centre[1], dz = z + 0.5 - centre[2];
          Triple place = { x, y, z };
          bool in = dx * dx + dy * dy + dz * dz <= radius * radius;
          for (int q = 0; q < 3; ++q)
          {
            in = in && (periodic || (place[q] >= 0 && place[q] < dimensions[q]));
            place[q] = ((place[q] % dimensions[q]) + dimensions[q]) % dimensions[q];
          }
          if (in)
          {
            image.Phases[(std::size_t(place[2]) * dimensions[1] + place[1]) * dimensions[0] +
              place[0]] = static_cast<std::uint8_t>(pack.Mode[i] - 1);
          }
        }
      }
    }
  }
  return image;
}
}
