// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Tracing/LineBundle.h"

#include "Oracles.h"
#include "ruc/Tracing/SamplingRegion.h"

#include <tuple>

namespace
{
using ruc::LineBundle;
using ruc::SamplingRegion;
using ruc::SphereHit;
using ruc::SpherePack;
using ruc::Vector3;
using ruc::Window;

bool Before(const SphereHit& a, const SphereHit& b)
{
  return std::tie(a.In, a.Out, a.Mode) < std::tie(b.In, b.Out, b.Mode);
}

// Every sphere and every image up to `last` edges away, by the quadratic equation
std::vector<SphereHit> BruteForce(const SpherePack& pack, const Window& box, const Vector3& start,
  const Vector3& direction, double begin, double end, int last)
{
  std::vector<SphereHit> hits;
  int images[3];
  for (int q = 0; q < 3; ++q)
  {
    images[q] = box.Periodic[q] ? last : 0;
  }
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    for (int nx = -images[0]; nx <= images[0]; ++nx)
    {
      for (int ny = -images[1]; ny <= images[1]; ++ny)
      {
        for (int nz = -images[2]; nz <= images[2]; ++nz)
        {
          const double x = start[0] - pack.X[i] - nx * box.Size[0];
          const double y = start[1] - pack.Y[i] - ny * box.Size[1];
          const double z = start[2] - pack.Z[i] - nz * box.Size[2];
          const double b = x * direction[0] + y * direction[1] + z * direction[2];
          const double c = x * x + y * y + z * z - pack.Radius[i] * pack.Radius[i];
          const double root = std::sqrt(std::max(b * b - c, 0.0));
          if (b * b > c && root - b > begin && -b - root < end)
          {
            hits.push_back({ -b - root, root - b, pack.Mode[i] - 1 });
          }
        }
      }
    }
  }
  std::sort(hits.begin(), hits.end(), Before);
  return hits;
}

void ExpectSameHits(std::vector<SphereHit> found, const std::vector<SphereHit>& expected)
{
  std::sort(found.begin(), found.end(), Before);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t n = 0; n < found.size(); ++n)
  {
    // The root for a grazing line loses half of the digits
    EXPECT_NEAR(found[n].In, expected[n].In, 1e-6);
    EXPECT_NEAR(found[n].Out, expected[n].Out, 1e-6);
    EXPECT_EQ(found[n].Mode, expected[n].Mode);
  }
}
}

TEST(LineBundle, FindsTheSpheresOnItsLines)
{
  for (const std::array<bool, 3>& periodic :
    { std::array<bool, 3>{ false, false, false }, { true, false, false }, { true, true, false } })
  {
    for (const oracle::PackInBox& c : oracle::HardPacks(periodic))
    {
      const SamplingRegion region(c.Box, 0.0);
      for (std::uint32_t n = 0; n < 20; ++n)
      {
        const LineBundle bundle = n == 0
          ? region.ParallelLinesAlong({ 0, 1, 0 }, 0, 1, n, 12.0, 1.0)
          : region.ParallelLines(1, n, 12.0, 1.0);
        std::vector<std::vector<SphereHit>> hits(bundle.Lines.size());
        bundle.FindHits(c.Pack, hits);
        for (std::size_t k = 0; k < hits.size(); ++k)
        {
          const ruc::SampleLine& line = bundle.Lines[k];
          ExpectSameHits(hits[k],
            BruteForce(c.Pack, c.Box, line.Start, bundle.Direction, line.Inside.front().Begin,
              line.Inside.back().End, 1));
        }
      }
    }
  }
}

TEST(LineBundle, FindsEveryImageOnALongPeriodicLineOnce)
{
  for (const oracle::PackInBox& c : oracle::HardPacks({ true, true, true }))
  {
    const SamplingRegion region(c.Box, 0.0);
    const double shortest = *std::min_element(c.Box.Size.begin(), c.Box.Size.end());
    const double lag = 3.0 * shortest;
    // The longest line over the shortest edge, and the images at its ends
    const int images = static_cast<int>(region.LongestLine(lag) / shortest) + 2;
    for (std::uint32_t n = 0; n < 8; ++n)
    {
      const LineBundle bundle = n == 0 ? region.ParallelLinesAlong({ 0, 0, -1 }, 0, 1, n, 5.0, lag)
                                       : region.ParallelLines(2, n, 5.0, lag);
      std::vector<std::vector<SphereHit>> hits(bundle.Lines.size());
      bundle.FindHits(c.Pack, hits);
      for (std::size_t k = 0; k < hits.size(); ++k)
      {
        ExpectSameHits(hits[k],
          BruteForce(c.Pack, c.Box, bundle.Lines[k].Start, bundle.Direction, 0.0,
            bundle.Lines[k].Inside[0].End, std::min(images, 12)));
      }
      if (images > 12)
      {
        break; // the plate takes long by brute force
      }
    }
  }
}

TEST(LineBundle, SharesOfAPackAddUpBitByBit)
{
  for (const oracle::PackInBox& c : oracle::HardPacks({ true, true, true }))
  {
    const SamplingRegion region(c.Box, 0.0);
    const LineBundle bundle = region.ParallelLines(3, 1, 40.0, 2.0);
    std::vector<std::vector<SphereHit>> whole(bundle.Lines.size()), parts(bundle.Lines.size());
    bundle.FindHits(c.Pack, whole);
    for (std::size_t share = 0; share < 3; ++share)
    {
      SpherePack part;
      for (std::size_t i = share; i < c.Pack.Size(); i += 3)
      {
        part.Append(c.Pack, i);
      }
      bundle.FindHits(part, parts);
    }
    for (std::size_t k = 0; k < whole.size(); ++k)
    {
      std::sort(whole[k].begin(), whole[k].end(), Before);
      std::sort(parts[k].begin(), parts[k].end(), Before);
      ASSERT_EQ(whole[k].size(), parts[k].size());
      for (std::size_t n = 0; n < whole[k].size(); ++n)
      {
        EXPECT_EQ(whole[k][n].In, parts[k][n].In);
        EXPECT_EQ(whole[k][n].Out, parts[k][n].Out);
        EXPECT_EQ(whole[k][n].Mode, parts[k][n].Mode);
      }
    }
  }
}
