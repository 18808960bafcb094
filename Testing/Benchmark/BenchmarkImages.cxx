// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Times the labelling of an image of the example pack with as many voxels as the paper's, 513 x 457
 * x 280: medians of some runs, with the time that had been estimated over the time it took. It runs
 * on one thread unless OMP_NUM_THREADS says otherwise.
 */
#include "ExamplePack.h"
#include "ruc/Images/LabelImage.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

namespace
{
constexpr int Runs = 5;
ruc::PackFigures FiguresOf(const ruc::SpherePack& pack)
{
  ruc::PackFigures figures;
  figures.Spheres = static_cast<double>(pack.Size());
  figures.Observed = Block;
  figures.Modes = pack.NumberOfModes();
  for (double radius : pack.Radius)
  {
    figures.MeanRadius += radius / figures.Spheres;
    figures.MeanSquareRadius += radius * radius / figures.Spheres;
  }
  figures.LargestRadius = pack.LargestRadius();
  return figures;
}

// The spheres are spread over the blocks anew in every run
double Seconds(const ruc::SpherePack& pack, const ruc::VoxelGrid& grid,
  const ruc::LabelSettings& settings, const ruc::LabelArrays& arrays)
{
  ruc::Communicator serial;
  const auto begin = std::chrono::steady_clock::now();
  const ruc::VoxelBlock block = { { 0, 0, 0 }, grid.Dimensions };
  const ruc::LabelImage image(grid, block, ruc::SpheresOfBlock(pack, Block, grid, block, 0, serial),
    pack.NumberOfModes(), settings);
  const int steps = ruc::StepsOfLabels(grid, pack.LargestRadius());
  for (int step = 0; step < steps; ++step)
  {
    image.Fill(step, steps, arrays);
  }
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void Measure(
  const char* what, double most, const ruc::SpherePack& pack, const ruc::LabelSettings& settings)
{
  const ruc::VoxelGrid grid = ruc::MakeVoxelGrid(Block, 0.0, { 513, 457, 280 });
  const std::size_t voxels = static_cast<std::size_t>(grid.Voxels());
  std::vector<std::uint8_t> phase(settings.Phases ? voxels : 0);
  std::vector<std::int32_t> id(settings.ParticleIds ? voxels : 0);
  std::vector<float> fractions(settings.Fractions ? voxels : 0);
  const ruc::LabelArrays arrays = { settings.Phases ? phase.data() : nullptr,
    settings.ParticleIds ? id.data() : nullptr, { fractions.data() } };
  std::vector<double> seconds;
  for (int run = 0; run < Runs; ++run)
  {
    seconds.push_back(Seconds(pack, grid, settings, arrays));
  }
  std::nth_element(seconds.begin(), seconds.begin() + Runs / 2, seconds.end());
  const double median = seconds[Runs / 2];
  std::printf("%-62s %5.2f s, at most %g; estimated over measured %.1f\n", what, median, most,
    ruc::EstimateLabels(FiguresOf(pack), grid, settings).Seconds / median);
}
}

int main()
{
  const ruc::SpherePack pack = ReadPack();
  ruc::LabelSettings settings;
  Measure("65.6 million voxels: phases", 1.0, pack, settings);
  settings.Phases = false;
  settings.ParticleIds = true;
  Measure("65.6 million voxels: particle ids", 1.0, pack, settings);
  settings.ParticleIds = false;
  settings.Fractions = true;
  Measure("65.6 million voxels: exact volume fractions", 6.0, pack, settings);
  settings.Method = ruc::FractionMethod::Supersampled;
  Measure("65.6 million voxels: 4 x 4 x 4 samples a voxel", 4.0, pack, settings);
}
