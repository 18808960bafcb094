// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/SphereGrid.h"

#include "Oracles.h"

#include <tuple>

namespace
{
using ruc::SphereGrid;
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
    // The root of a grazing line loses half of the digits
    EXPECT_NEAR(found[n].In, expected[n].In, 1e-6);
    EXPECT_NEAR(found[n].Out, expected[n].Out, 1e-6);
    EXPECT_EQ(found[n].Mode, expected[n].Mode);
  }
}

Vector3 PointIn(const Window& box, oracle::Uniform& random)
{
  Vector3 point;
  for (int q = 0; q < 3; ++q)
  {
    point[q] = random(box.Origin[q], box.Origin[q] + box.Size[q]);
  }
  return point;
}

struct Case
{
  SpherePack Pack;
  Window Box;
};

// Sizes of a ratio of 20; a box hardly larger than the largest sphere; one flat as a plate
std::vector<Case> Cases(const std::array<bool, 3>& periodic)
{
  const Window wide = Window::MakeBox({ -1, 2, 3 }, { 4.0, 5.0, 6.0 }, periodic);
  const Window tight = Window::MakeBox({ 0, 0, 0 }, { 2.01, 2.2, 2.1 }, periodic);
  const Window plate = Window::MakeBox({ 0, 0, 0 }, { 20.0, 20.0, 0.5 }, periodic);
  return { { oracle::RandomPack({ 3, 30, 300 }, { 1.0, 0.2, 0.05 }, wide, 1), wide },
    { oracle::RandomPack({ 2, 20 }, { 1.0, 0.05 }, tight, 2), tight },
    { oracle::RandomPack({ 200 }, { 0.2 }, plate, 3), plate },
    { oracle::RandomPack({ 1 }, { 0.7 }, wide, 4), wide }, { SpherePack(), wide } };
}
}

TEST(SphereGrid, FindsTheSpheresOnALineInTheBox)
{
  oracle::Uniform random(5);
  std::vector<SphereHit> hits;
  for (const std::array<bool, 3>& periodic :
    { std::array<bool, 3>{ false, false, false }, { true, false, false }, { true, true, false } })
  {
    for (const Case& c : Cases(periodic))
    {
      const SphereGrid grid(c.Pack, c.Box);
      for (int n = 0; n < 150; ++n)
      {
        // Between two points of the box, so it lies in the box; begins before the part asked for
        const Vector3 a = PointIn(c.Box, random), b = PointIn(c.Box, random);
        Vector3 d = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
        if (n % 5 == 0)
        {
          d = { 0, b[1] - a[1], 0 };
        }
        const double length = std::hypot(d[0], d[1], d[2]);
        d = { d[0] / length, d[1] / length, d[2] / length };
        const Vector3 start = { a[0] - 2.0 * d[0], a[1] - 2.0 * d[1], a[2] - 2.0 * d[2] };
        hits.clear();
        grid.Trace(start, d, 2.0, 2.0 + length, hits);
        ExpectSameHits(hits, BruteForce(c.Pack, c.Box, start, d, 2.0, 2.0 + length, 1));
      }
    }
  }
}

TEST(SphereGrid, FindsEveryImageOnALongPeriodicLineOnce)
{
  oracle::Uniform random(6);
  std::vector<SphereHit> hits;
  const std::vector<Case> cases = Cases({ true, true, true });
  for (const Case& c : { cases[0], cases[1], cases[3], cases[4] })
  {
    const SphereGrid grid(c.Pack, c.Box);
    for (int n = 0; n < 60; ++n)
    {
      const Vector3 start = n == 0 ? c.Box.Origin : PointIn(c.Box, random);
      Vector3 d = random.Direction();
      if (n % 6 == 0)
      {
        d = { 0, 0, 0 };
        d[n / 6 % 3] = n % 4 ? 1 : -1;
      }
      const double length = random(0.0, 12.0);
      hits.clear();
      grid.Trace(start, d, 0.0, length, hits);
      ExpectSameHits(hits, BruteForce(c.Pack, c.Box, start, d, 0.0, length, 8));
    }
  }
}

TEST(SphereGrid, FindsTheLowestModeAtAPoint)
{
  oracle::Uniform random(7);
  for (const std::array<bool, 3>& periodic :
    { std::array<bool, 3>{ false, false, false }, { true, true, true } })
  {
    for (const Case& c : Cases(periodic))
    {
      if (c.Box.IsFullyPeriodic() && c.Box.Size[2] < 1.0)
      {
        continue; // the plate, with edges shorter than allowed for the images
      }
      const SphereGrid grid(c.Pack, c.Box);
      for (int n = 0; n < 1000; ++n)
      {
        const Vector3 p = PointIn(c.Box, random);
        int lowest = 99;
        for (std::size_t i = 0; i < c.Pack.Size(); ++i)
        {
          double distance2 = 0.0;
          for (int q = 0; q < 3; ++q)
          {
            double d = p[q] - c.Pack.Centre(i)[q];
            d -= c.Box.Periodic[q] ? c.Box.Size[q] * std::round(d / c.Box.Size[q]) : 0.0;
            distance2 += d * d;
          }
          if (distance2 < c.Pack.Radius[i] * c.Pack.Radius[i])
          {
            lowest = std::min(lowest, c.Pack.Mode[i] - 1);
          }
        }
        EXPECT_EQ(grid.LowestModeAt(p, 99), lowest);
      }
    }
  }
}

TEST(SphereGrid, SharesOfAPackAddUpBitByBit)
{
  oracle::Uniform random(8);
  for (const std::array<bool, 3>& periodic :
    { std::array<bool, 3>{ true, true, true }, { false, true, false } })
  {
    const Case c = Cases(periodic)[0];
    SpherePack shares[3];
    for (std::size_t i = 0; i < c.Pack.Size(); ++i)
    {
      shares[i % 7 == 0].Append(c.Pack, i);
    }
    const SphereGrid whole(c.Pack, c.Box), a(shares[0], c.Box), b(shares[1], c.Box),
      none(shares[2], c.Box);
    for (int n = 0; n < 200; ++n)
    {
      const Vector3 start = PointIn(c.Box, random), d = random.Direction();
      double length = 9.0;
      for (int q = 0; q < 3; ++q)
      {
        const double to = c.Box.Origin[q] + (d[q] > 0.0 ? c.Box.Size[q] : 0.0);
        length = c.Box.IsFullyPeriodic() ? length : std::min(length, (to - start[q]) / d[q]);
      }
      std::vector<SphereHit> all, parts;
      whole.Trace(start, d, 0.0, length, all);
      a.Trace(start, d, 0.0, length, parts);
      b.Trace(start, d, 0.0, length, parts);
      none.Trace(start, d, 0.0, length, parts);
      std::sort(all.begin(), all.end(), Before);
      std::sort(parts.begin(), parts.end(), Before);
      ASSERT_EQ(all.size(), parts.size());
      for (std::size_t h = 0; h < all.size(); ++h)
      {
        EXPECT_EQ(all[h].In, parts[h].In);
        EXPECT_EQ(all[h].Out, parts[h].Out);
        EXPECT_EQ(all[h].Mode, parts[h].Mode);
      }
      EXPECT_EQ(
        whole.LowestModeAt(start, 9), std::min(a.LowestModeAt(start, 9), b.LowestModeAt(start, 9)));
    }
  }
}
