// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Images/Watershed/CutParticles.h"

#include "ruc/Base/Require.h"
#include "ruc/Base/Text.h"
#include "ruc/Images/Fit/DistanceMap.h"
#include "ruc/Images/Watershed/Basins.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace ruc
{
namespace
{
double MarginOf(const std::vector<ParticleShape>& shapes)
{
  double margin = 0.0;
  for (const ParticleShape& shape : shapes)
  {
    margin = shape.BorderFaces == 0 ? std::max(margin, shape.Reach) : margin;
  }
  return margin;
}

// Why a particle is not kept
std::optional<DropReason> ReasonOf(const ParticleShape& shape, const ParticleSearch& search,
  const std::array<int, 3>& dimensions, double margin)
{
  if (2.0 * shape.EqualVolumeRadius() < search.LeastDiameter)
  {
    return DropReason::Small;
  }
  bool whole = !search.WholeOnly || shape.BorderFaces == 0;
  for (int q = 0; q < 3 && search.WholeOnly; ++q)
  {
    whole = whole && shape.Centre[q] >= margin &&
      shape.Centre[q] <= dimensions[q] * search.Edges[q] - margin;
  }
  return whole ? std::nullopt : std::optional(DropReason::NearBorder);
}

void Keep(std::vector<ParticleShape> shapes, const ParticleSearch& search, CutParticles& cut)
{
  cut.Margin = search.WholeOnly ? MarginOf(shapes) : 0.0;
  std::vector<std::int32_t> numbers(shapes.size() + 1, 0);
  for (std::size_t n = 0; n < shapes.size(); ++n)
  {
    if (const auto reason = ReasonOf(shapes[n], search, cut.Number.Dimensions, cut.Margin))
    {
      cut.Others.push_back({ shapes[n], *reason });
      numbers[n + 1] = CutParticles::NotKept;
      continue;
    }
    cut.Shapes.push_back(shapes[n]);
    cut.Labels.push_back(static_cast<std::int32_t>(n) + 1);
    numbers[n + 1] = static_cast<std::int32_t>(cut.Shapes.size());
  }
  for (std::int32_t& number : cut.Number.Values)
  {
    number = numbers[number];
  }
}
}

CutParticles CutImage(VoxelSlab<float> image, const ParticleSearch& search, Communicator& ranks,
  const std::function<bool(double, const std::string&)>& progress)
{
  CutParticles cut;
  const auto goOn = [&](double done, const char* what)
  {
    cut.Stopped = !ranks.All(!progress || progress(done, what));
    return !cut.Stopped;
  };
  if (!goOn(0.0, "finding the two phases"))
  {
    return cut;
  }
  static_cast<TwoPhases&>(cut) = FindPhases(image, search, ranks);
  if (!goOn(0.1, "finding distances"))
  {
    return cut;
  }
  if (cut.Smoothing > 0)
  {
    image = Smoothed(std::move(image), cut.Smoothing, ranks);
    if (!search.Threshold)
    {
      // Noise makes Otsu's threshold too low or too high
      cut.Threshold = FindGreyLevels(image, ranks).Threshold;
    }
  }
  VoxelSlab<std::uint8_t> above =
    FindAbove(std::exchange(image, {}), static_cast<float>(cut.Threshold));
  VoxelSlab<std::int32_t> distances = SquaredDistances(std::move(above), ranks);
  if (!goOn(0.3, "flooding"))
  {
    return cut;
  }
  Basins basins = FindBasins(std::move(distances), search.MarkerHeight, ranks);
  if (!goOn(0.8, "measuring particles"))
  {
    return cut;
  }
  cut.Number = std::move(basins.Number);
  Keep(MeasureShapes(cut.Number, basins.Count, search.Edges, ranks), search, cut);
  if (cut.Shapes.empty() && (cut.Others.empty() || !search.WholeOnly))
  {
    throw std::invalid_argument(Text("found no particle of a diameter of ", search.LeastDiameter,
      " voxels or more above the grey value ", cut.Threshold, "; are particles dark?"));
  }
  return cut;
}

CutParticles TakeLabels(VoxelSlab<std::int32_t> labels, std::int32_t count,
  const ParticleSearch& search, Communicator& ranks)
{
  Require(count > 0, "ImageArray", "labels above 0", "none");
  CutParticles cut;
  cut.Number = std::move(labels);
  Keep(MeasureShapes(cut.Number, count, search.Edges, ranks), search, cut);
  return cut;
}

Estimate EstimateCut(const std::array<int, 3>& dimensions, int ranks)
{
  constexpr double secondsOfVoxel = 2.5e-7, bytesOfVoxel = 16.0;
  constexpr int halo = 3;
  return { secondsOfVoxel * MostVoxels(dimensions, 0, 1),
    bytesOfVoxel * MostVoxels(dimensions, halo, ranks) / BytesOfMegabyte, 0.0 };
}
}
