// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Voxels/RunLengths.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ruc
{
namespace
{
RunCounts MakeCounts(int phases, int length)
{
  RunCounts counts;
  counts.Runs.assign(phases, std::vector<std::int64_t>(length + 1, 0));
  counts.Chords = counts.Runs;
  counts.Inside.assign(length + 1, 0);
  counts.Endless.assign(phases, 0);
  counts.Starts.assign(phases, 0);
  return counts;
}

// Calls each(begin, end) for the longest ranges of a line in which same(n, n + 1) holds
template <class Same, class Each>
void ForRanges(int length, Same&& same, Each&& each)
{
  for (int begin = 0, end = 0; begin < length; begin = end)
  {
    for (end = begin + 1; end < length && same(end - 1, end); ++end)
    {
    }
    each(begin, end);
  }
}

// Adds the runs of a line. A periodic one is turned so that it begins where a run does.
void AddLine(std::vector<std::uint8_t>& line, bool periodic, RunCounts& counts)
{
  const int length = static_cast<int>(line.size());
  bool joined = periodic; // whether the end and the beginning of the line are neighbours
  if (periodic)
  {
    const auto change = std::adjacent_find(line.begin(), line.end(), std::not_equal_to<>());
    if (change == line.end())
    {
      if (line[0] != OutsideMask)
      {
        counts.Endless[line[0]] += length;
        counts.EndlessInside += length;
      }
      return;
    }
    // Voxels outside come first where there are any, so that no run inside goes over the end
    const auto outside = std::find(line.begin(), line.end(), OutsideMask);
    joined = outside == line.end();
    std::rotate(line.begin(), joined ? change + 1 : outside, line.end());
    if (joined)
    {
      counts.EndlessInside += length;
    }
  }
  const auto at = [&](int n) {
    return n >= 0 && n < length ? line[n] : joined ? line[(n + length) % length] : OutsideMask;
  };
  ForRanges(
    length, [&](int a, int b) { return line[a] == line[b]; },
    [&](int begin, int end)
    {
      const std::uint8_t phase = line[begin];
      if (phase == OutsideMask)
      {
        return;
      }
      const bool starts = at(begin - 1) != OutsideMask, ends = at(end) != OutsideMask;
      ++counts.Runs[phase][end - begin];
      counts.Starts[phase] += starts;
      counts.Starts[phase] += ends;
      counts.Chords[phase][end - begin] += starts && ends;
    });
  if (!joined)
  {
    ForRanges(
      length, [&](int a, int b) { return (line[a] == OutsideMask) == (line[b] == OutsideMask); },
      [&](int begin, int end)
      { counts.Inside[end - begin] += line[begin] == OutsideMask ? 0 : 1; });
  }
}

void Sum(std::vector<std::int64_t>& values, Communicator& ranks)
{
  ranks.Sum(values.data(), values.size());
}

// Lines along x, or along the axis of the rows of a slab
RunCounts CountLines(
  const PhaseSlab& image, int axis, int phases, bool periodic, Communicator& ranks)
{
  RunCounts counts = MakeCounts(phases, image.Dimensions[axis]);
  std::vector<std::uint8_t> line;
  for (int plane = image.Begin(); plane < image.End(); ++plane)
  {
    const int lines = axis == 0 ? image.Rows() : image.Dimensions[0];
    for (int n = 0; n < lines; ++n)
    {
      line.clear();
      if (axis == 0)
      {
        line.assign(image.Row(plane, n), image.Row(plane, n) + image.Dimensions[0]);
      }
      for (int row = 0; axis != 0 && row < image.Rows(); ++row)
      {
        line.push_back(image.Row(plane, row)[n]);
      }
      AddLine(line, periodic, counts);
    }
  }
  for (int phase = 0; phase < phases; ++phase)
  {
    Sum(counts.Runs[phase], ranks);
    Sum(counts.Chords[phase], ranks);
  }
  Sum(counts.Inside, ranks);
  Sum(counts.Endless, ranks);
  Sum(counts.Starts, ranks);
  ranks.Sum(&counts.EndlessInside, 1);
  return counts;
}

// For every j the number of places at which j + `more` voxels in a row lie in one of the runs
std::vector<double> Places(const std::vector<std::int64_t>& runs, std::int64_t endless, int more)
{
  std::vector<double> places(runs.size(), 0.0);
  for (std::size_t j = 0; j < runs.size(); ++j)
  {
    std::int64_t sum = endless;
    for (std::size_t n = j + more; n < runs.size(); ++n)
    {
      sum += runs[n] * static_cast<std::int64_t>(n - j - more + 1);
    }
    places[j] = static_cast<double>(sum);
  }
  return places;
}

// The value between the lengths in voxels, 0 beyond the last
double At(const std::vector<double>& values, double length)
{
  const auto n = static_cast<std::size_t>(length);
  const double b = length - static_cast<double>(n);
  const auto value = [&](std::size_t place) { return place < values.size() ? values[place] : 0.0; };
  return (1.0 - b) * value(n) + (b > 0.0 ? b * value(n + 1) : 0.0);
}
}

std::array<RunCounts, 3> CountRuns(
  const PhaseSlab& image, int phases, const std::array<bool, 3>& periodic, Communicator& ranks)
{
  std::array<RunCounts, 3> counts = { CountLines(image, 0, phases, periodic[0], ranks),
    CountLines(image, 1, phases, periodic[1], ranks), {} };
  counts[2] = CountLines(CutAcross(image, 1, ranks), 2, phases, periodic[2], ranks);
  return counts;
}

ChordLengths ChordsOfRuns(const std::array<RunCounts, 3>& runs, const Vector3& spacing, double edge,
  int count, const std::vector<double>& fractions, const std::vector<double>& surface)
{
  const int phases = static_cast<int>(fractions.size());
  ChordLengths chords;
  chords.Lags = { edge, count };
  for (int r = 0; r < phases; ++r)
  {
    std::vector<double> density(count + 1, 0.0), path(count + 1, 0.0);
    std::vector<double> room(count + 1, 0.0), all(count + 1, 0.0);
    double starts = 0.0, length = 0.0;
    for (int q = 0; q < 3; ++q)
    {
      const double step = edge / spacing[q]; // a lag, in voxels
      const std::vector<double> own = Places(runs[q].Runs[r], runs[q].Endless[r], 1);
      const std::vector<double> inside = Places(runs[q].Inside, runs[q].EndlessInside, 1);
      // A chord takes one voxel more at both ends
      const std::vector<double> ofChords = Places(runs[q].Inside, runs[q].EndlessInside, 2);
      const std::vector<double> found(runs[q].Chords[r].begin(), runs[q].Chords[r].end());
      for (int k = 0; k <= count; ++k)
      {
        path[k] += At(own, k * step);
        all[k] += At(inside, k * step);
        density[k] += At(found, k * step) / spacing[q];
        room[k] += At(ofChords, k * step) * spacing[q];
      }
      starts += 0.5 * static_cast<double>(runs[q].Starts[r]);
      length += (inside.size() > 1 ? inside[1] : 0.0) * spacing[q];
    }
    for (int k = 0; k <= count; ++k)
    {
      path[k] /= all[k];
      density[k] /= room[k] * (starts / length);
    }
    chords.Density.push_back(std::move(density));
    chords.LinealPath.push_back(std::move(path));
    chords.MeanChord.push_back(4.0 * fractions[r] / surface[r]);
  }
  return chords;
}
}
