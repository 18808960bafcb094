// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Images/Fit/GreyLevels.h"

#include "ruc/Base/Text.h"
#include "ruc/Base/VectorClones.h"

#include <cmath>
#include <stdexcept>

namespace ruc
{
namespace
{
constexpr int Classes = 4096;
constexpr int MostCloser = 4; // times that a histogram leaves out what is odd
using Counts = std::vector<std::int64_t>;

// Adds the counts of find(row, y, z, counts) of all rows, threads and ranks
template <class Find>
Counts CountRows(const VoxelSlab<float>& image, Communicator& ranks, Find&& find)
{
  Counts counts(Classes + 1, 0);
#pragma omp parallel
  {
    Counts own(Classes + 1, 0);
#pragma omp for schedule(static) nowait
    for (int z = image.First; z < image.Last; ++z)
    {
      for (int y = 0; y < image.Dimensions[1]; ++y)
      {
        find(image.Row(y, z), own);
      }
    }
#pragma omp critical
    std::transform(own.begin(), own.end(), counts.begin(), counts.begin(), std::plus<>());
  }
  ranks.Sum(counts.data(), counts.size());
  return counts;
}

// The class of a value; values beyond the ends count as the ends
int ClassOf(double value, double low, double scale)
{
  return static_cast<int>(std::clamp((value - low) * scale, 0.0, Classes - 1.0));
}

// The class below which a share of all counts lies
int Quantile(const Counts& counts, double share)
{
  double total = 0.0, below = 0.0;
  for (int k = 0; k < Classes; ++k)
  {
    total += static_cast<double>(counts[k]);
  }
  int k = 0;
  for (; k < Classes - 1; ++k)
  {
    below += static_cast<double>(counts[k]);
    if (below > share * total)
    {
      break;
    }
  }
  return k;
}

Counts Histogram(const VoxelSlab<float>& image, double low, double high, Communicator& ranks)
{
  const double scale = Classes / (high - low);
  return CountRows(image, ranks,
    [&](const float* row, Counts& counts)
    {
      for (int x = 0; x < image.Dimensions[0]; ++x)
      {
        ++counts[ClassOf(row[x], low, scale)];
      }
    });
}

// Sets threshold and means from a histogram
void Separate(const Counts& counts, double low, double high, GreyLevels& levels)
{
  double total = 0.0, moment = 0.0;
  for (int k = 0; k < Classes; ++k)
  {
    total += static_cast<double>(counts[k]);
    moment += (k + 0.5) * static_cast<double>(counts[k]);
  }
  const double width = (high - low) / Classes;
  double below = 0.0, momentBelow = 0.0, best = -1.0;
  int from = 0, to = 0;
  for (int k = 0; k < Classes - 1; ++k)
  {
    below += static_cast<double>(counts[k]);
    momentBelow += (k + 0.5) * static_cast<double>(counts[k]);
    if (below == 0.0 || below == total)
    {
      continue;
    }
    const double mean = momentBelow / below, other = (moment - momentBelow) / (total - below);
    const double between = below * (total - below) * (other - mean) * (other - mean);
    if (between > best)
    {
      best = between;
      from = k;
    }
    to = between == best ? k : to; // classes without voxels in between
  }
  levels.Threshold = low + width * (0.5 * (from + to) + 1.0);
  const Counts::const_iterator middle = counts.begin() + from + 1;
  Counts lower(counts.begin(), middle), upper(Classes, 0);
  lower.resize(Classes, 0);
  std::copy(middle, counts.end() - 1, upper.begin() + from + 1);
  levels.Below = low + width * (Quantile(lower, 0.5) + 0.5);
  levels.Above = low + width * (Quantile(upper, 0.5) + 0.5);
}

double FindNoise(const VoxelSlab<float>& image, double low, double high, Communicator& ranks)
{
  const double norm = std::sqrt(70.0); // of the differences of white noise
  const double scale = Classes / (high - low);
  const Counts counts = CountRows(image, ranks,
    [&](const float* row, Counts& own)
    {
      for (int x = 2; x + 2 < image.Dimensions[0]; ++x)
      {
        const double difference =
          (row[x - 2] + row[x + 2]) - 4.0 * (double(row[x - 1]) + row[x + 1]) + 6.0 * row[x];
        ++own[ClassOf(std::abs(difference) / norm, 0.0, scale)];
      }
    });
  const int median = Quantile(counts, 0.5);
  // Half of a normal distribution lies within 0.6745 deviations
  return median == 0 ? 0.0 : (median + 0.5) / scale / 0.6745;
}

RUC_VECTOR_CLONES
void Mean121(const float* before, const float* after, int count, float* values)
{
  for (int n = 0; n < count; ++n)
  {
    values[n] = 0.25f * (before[n] + after[n]) + 0.5f * values[n];
  }
}

// Smooths `count` rows of a plane, or planes of a slab, that lie `stride` apart
void SmoothRows(float* values, int count, std::size_t stride, int width)
{
  std::vector<float> before(values, values + width), present(width);
  for (int n = 0; n < count; ++n, values += stride)
  {
    std::copy_n(values, width, present.begin());
    Mean121(before.data(), n + 1 < count ? values + stride : present.data(), width, values);
    before.swap(present);
  }
}
}

GreyLevels FindGreyLevels(const VoxelSlab<float>& image, Communicator& ranks)
{
  constexpr double odd = 1e-4; // of the voxels on either side may be odd
  double ends[2] = { std::numeric_limits<double>::infinity(),
    std::numeric_limits<double>::infinity() };
  for (float value : image.Values)
  {
    ends[0] = std::min<double>(ends[0], value);
    ends[1] = std::min<double>(ends[1], -value);
  }
  ranks.Minimum(ends, 2);
  GreyLevels levels;
  levels.Low = ends[0];
  levels.High = -ends[1];
  if (!(levels.Low < levels.High))
  {
    throw std::invalid_argument(
      Text("requires an image of two phases, got one grey only, ", levels.Low, "."));
  }
  std::int64_t others = std::count_if(image.Values.begin(), image.Values.end(),
    [&](float value) { return value != levels.Low && value != levels.High; });
  ranks.Sum(&others, 1);
  levels.TwoValues = others == 0;

  double low = levels.Low, high = levels.High;
  Counts counts = Histogram(image, low, high, ranks);
  for (int closer = 0; closer < MostCloser && !levels.TwoValues; ++closer)
  {
    const int first = Quantile(counts, odd), last = Quantile(counts, 1.0 - odd);
    if (2 * (last - first + 1) > Classes)
    {
      break;
    }
    const double width = (high - low) / Classes;
    high = low + width * (last + 1);
    low += width * first;
    counts = Histogram(image, low, high, ranks);
  }
  Separate(counts, low, high, levels);
  levels.Noise = levels.TwoValues ? 0.0 : FindNoise(image, low, high, ranks);
  return levels;
}

int SmoothingFor(double noise)
{
  // What is left of white noise after so many times: (1 4 6 4 1) and so on, along three axes
  constexpr double left[] = { 1.0, 0.2296, 0.1430, 0.1071 };
  int times = 0;
  while (times < 3 && noise * left[times] >= 0.12)
  {
    ++times;
  }
  return times;
}

void Smooth(VoxelSlab<float>& image)
{
  const int width = image.Dimensions[0], height = image.Dimensions[1];
  const int planes = image.Last - image.First;
#pragma omp parallel
  {
    std::vector<float> row(width + 2);
#pragma omp for schedule(static)
    for (int z = image.First; z < image.Last; ++z)
    {
      for (int y = 0; y < height; ++y)
      {
        float* values = image.Row(y, z);
        std::copy_n(values, width, row.begin() + 1);
        row.front() = values[0];
        row.back() = values[width - 1];
        Mean121(row.data(), row.data() + 2, width, values);
      }
      SmoothRows(image.Row(0, z), height, width, width);
    }
#pragma omp for schedule(static)
    for (int y = 0; y < height; ++y)
    {
      if (planes > 0)
      {
        SmoothRows(image.Row(y, image.First), planes, image.PlaneSize(), width);
      }
    }
  }
}
}
