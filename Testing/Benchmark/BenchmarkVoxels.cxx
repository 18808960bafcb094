// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Times the Fourier transform of images, in nanoseconds a voxel: there, and back to a quarter of
 * the lags; and the statistics of the bead block in the paper's image size, 513 x 457 x 280 voxels
 * of ten phases, with as many spectra as 4000 MB hold and with all. One thread, medians.
 */
#include "ExamplePack.h"
#include "ruc/Images/FourierTransform.h"
#include "ruc/Images/LabelImage.h"
#include "ruc/Statistics/Voxels/ImageCorrelation.h"
#include "ruc/Statistics/Voxels/RunLengths.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <vector>

namespace
{
double MedianSeconds(int runs, const std::function<void()>& work)
{
  std::vector<double> seconds;
  for (int run = 0; run < runs; ++run)
  {
    const auto begin = std::chrono::steady_clock::now();
    work();
    seconds.push_back(
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  std::nth_element(seconds.begin(), seconds.begin() + runs / 2, seconds.end());
  return seconds[runs / 2];
}

void MeasureTransform(int edge)
{
  ruc::Communicator serial;
  const ruc::FourierTransform transform({ edge, edge, edge }, { edge, edge, edge }, serial);
  ruc::FourierTransform::Spectrum spectrum;
  const double voxels = 1e-9 * edge * edge * edge;
  const double forward = MedianSeconds(7,
    [&]()
    {
      transform.Forward(
        [&](int y, int z, double* line)
        {
          for (int x = 0; x < edge; ++x)
          {
            line[x] = (x ^ y ^ z) & 1;
          }
        },
        spectrum, serial);
    });
  const double back = MedianSeconds(7,
    [&]()
    {
      transform.Correlate(spectrum, spectrum, { edge / 4, edge / 4, edge / 4 }, serial,
        [](int, const std::vector<double>&) {});
    });
  std::printf("Fourier transform of %d^3 %39.1f ns a voxel, back to a quarter of the lags %.1f\n",
    edge, forward / voxels, back / voxels);
}

ruc::PhaseSlab LabelBeads(int& phases)
{
  const ruc::SpherePack pack = ReadPack();
  const ruc::VoxelGrid grid = ruc::MakeVoxelGrid(Block, 0.0, { 513, 457, 280 });
  ruc::Communicator serial;
  ruc::PhaseBlock image;
  image.Block.Count = grid.Dimensions;
  image.Phases.resize(image.Block.Voxels());
  const int modes = pack.NumberOfModes();
  ruc::LabelImage(
    grid, image.Block, ruc::SpheresOfBlock(pack, Block, grid, image.Block, 0, serial), modes, {})
    .Fill(0, 1, { image.Phases.data(), nullptr, {} });
  for (std::uint8_t& phase : image.Phases)
  {
    phase = static_cast<std::uint8_t>(phase == 0 ? modes : phase - 1);
  }
  phases = modes + 1;
  return ruc::SpreadPhases(image, grid.Dimensions, 2, serial);
}

void MeasureStatistics(const ruc::PhaseSlab& image, int phases, double megabytes)
{
  ruc::Communicator serial;
  ruc::ImageSettings settings = { phases, { false, false, false },
    ruc::FindImageLags(image.Dimensions, { 2.8175, 2.8175, 2.8175 }, 0.0, 0), {}, 2 };
  const ruc::ImageWork work(image.Dimensions, settings, 1);
  settings.Spectra = work.SpectraWithin(megabytes);
  const double seconds = MedianSeconds(3, [&]() { ruc::CorrelateImage(image, settings, serial); });
  const ruc::Estimate estimate = work.ForSpectra(settings.Spectra);
  std::printf("S_rs of %d phases, 513 x 457 x 280 voxels, %2d spectra %13.1f s, at most 60; "
              "estimated over measured %.1f, %.0f MB\n",
    phases, settings.Spectra, seconds, estimate.Seconds / seconds, estimate.MegabytesOfRank);
}
}

int main()
{
  for (int edge : { 96, 128, 192 })
  {
    MeasureTransform(edge);
  }
  int phases = 0;
  const ruc::PhaseSlab image = LabelBeads(phases);
  MeasureStatistics(image, phases, 4000.0);
  MeasureStatistics(image, phases, 1e6);
  ruc::Communicator serial;
  std::printf("chords and lineal path of this image %37.1f s\n",
    MedianSeconds(3,
      [&]() {
        ruc::CountRuns(image, phases, { false, false, false }, serial);
      }));
}
