// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/**
 * @file
 * Grey images of spheres as a tomograph makes them: the exact share of each voxel in spheres,
 * blurred by the discrete Gaussian kernel along each axis, with independent normal noise.
 */

#include "Oracles.h"
#include "ThreadRanks.h"
#include "ruc/Images/Fit/SphereFit.h"
#include "ruc/Images/LabelImage.h"

#include <random>

namespace oracle
{
constexpr double SceneMatrix = 1000.0, SceneContrast = 500.0;

struct GreyScene
{
  std::array<int, 3> Dimensions;
  std::vector<ruc::Ball> Balls;
  double Noise = 0.1; // over the contrast
  double Blur = 1.0;  // of the kernel, in voxels
  ruc::Vector3 Edges = { 1.0, 1.0, 1.0 };
};

inline void BlurAlong(
  std::vector<float>& values, const std::array<int, 3>& n, int axis, double sigma)
{
  const int half = static_cast<int>(4.0 * sigma + 0.5);
  std::vector<double> weights;
  double total = 0.0;
  for (int k = -half; k <= half; ++k)
  {
    weights.push_back(std::exp(-0.5 * k * k / (sigma * sigma)));
    total += weights.back();
  }
  const std::size_t strides[3] = { 1, std::size_t(n[0]), std::size_t(n[0]) * n[1] };
  std::vector<double> line(n[axis]);
  for (std::size_t from = 0; from < values.size(); ++from)
  {
    if (from / strides[axis] % n[axis] != 0)
    {
      continue;
    }
    for (int x = 0; x < n[axis]; ++x)
    {
      line[x] = values[from + x * strides[axis]];
    }
    for (int x = 0; x < n[axis]; ++x)
    {
      double sum = 0.0;
      for (int k = -half; k <= half; ++k)
      {
        sum += weights[k + half] * line[std::clamp(x + k, 0, n[axis] - 1)];
      }
      values[from + x * strides[axis]] = static_cast<float>(sum / total);
    }
  }
}

/** The share of each voxel in spheres, 1 at most. */
inline std::vector<float> SharesOf(const GreyScene& scene)
{
  ruc::SpherePack pack;
  for (const ruc::Ball& ball : scene.Balls)
  {
    pack.X.push_back(ball.Centre[0]);
    pack.Y.push_back(ball.Centre[1]);
    pack.Z.push_back(ball.Centre[2]);
    pack.Radius.push_back(ball.Radius);
    pack.Mode.push_back(1);
  }
  ruc::VoxelGrid grid;
  grid.Dimensions = scene.Dimensions;
  grid.Spacing = scene.Edges;
  ruc::VoxelBlock block;
  block.Count = grid.Dimensions;
  ruc::LabelSettings settings;
  settings.Phases = false;
  settings.Fractions = true;
  std::vector<float> shares(block.Voxels());
  ruc::LabelArrays arrays;
  arrays.Fractions = { shares.data() };
  ruc::LabelImage(grid, block, std::move(pack), 1, settings).Fill(0, 1, arrays);
  return shares;
}

inline std::vector<float> GreysOf(const GreyScene& scene, std::uint64_t seed = 1)
{
  std::vector<float> values = SharesOf(scene);
  for (int q = 0; q < 3 && scene.Blur > 0.0; ++q)
  {
    BlurAlong(values, scene.Dimensions, q, scene.Blur / scene.Edges[q]);
  }
  Uniform random(seed);
  for (float& value : values)
  {
    // Box and Muller
    const double normal =
      std::sqrt(-2.0 * std::log(1.0 - random())) * std::cos(2.0 * Pi * random());
    value = static_cast<float>(SceneMatrix + SceneContrast * (value + scene.Noise * normal));
  }
  return values;
}

/** Spheres that do not overlap, each in a cell of a lattice; their radii are from 0.6 to 1 of the
 * largest. Three voxels are left to the border. */
inline GreyScene SpheresInCells(int cells, double largest, double noise, std::uint64_t seed)
{
  constexpr double margin = 3.0;
  const double edge = 2.0 * largest;
  GreyScene scene;
  scene.Noise = noise;
  scene.Dimensions.fill(static_cast<int>(std::ceil(edge * cells + 2.0 * margin)));
  Uniform random(seed);
  for (int n = 0; n < cells * cells * cells; ++n)
  {
    const int place[3] = { n % cells, n / cells % cells, n / cells / cells };
    ruc::Ball ball;
    ball.Radius = largest * random(0.6, 1.0);
    for (int q = 0; q < 3; ++q)
    {
      ball.Centre[q] =
        margin + edge * place[q] + ball.Radius + (edge - 2.0 * ball.Radius) * random();
    }
    scene.Balls.push_back(ball);
  }
  return scene;
}

/** The planes of a whole image that a rank has. */
template <class Value>
ruc::VoxelSlab<Value> SlabOf(const std::vector<Value>& values, const std::array<int, 3>& dimensions,
  const ruc::Communicator& ranks)
{
  const ruc::Slabs planes = { dimensions[2], ranks.Size() };
  ruc::VoxelSlab<Value> slab = { dimensions, static_cast<int>(planes.Begin(ranks.Rank())),
    static_cast<int>(planes.End(ranks.Rank())), {} };
  slab.Values.assign(
    values.begin() + slab.First * slab.PlaneSize(), values.begin() + slab.Last * slab.PlaneSize());
  return slab;
}

/** Runs work(communicator) on so many ranks, which returns the rank's part of an image; returns all
 * of it. */
template <class Value, class Work>
std::vector<Value> Together(int size, Work&& work)
{
  std::vector<std::vector<Value>> parts(size);
  ThreadRanks::Run(size, [&](ruc::Communicator& ranks) { parts[ranks.Rank()] = work(ranks); });
  std::vector<Value> all;
  for (const std::vector<Value>& part : parts)
  {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}
}
