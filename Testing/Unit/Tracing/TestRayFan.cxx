// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Tracing/RayFan.h"

#include "Oracles.h"

#include <map>
#include <tuple>

namespace
{
using oracle::Mean;
using ruc::CellList;
using ruc::FanTracer;
using ruc::RayDirections;
using ruc::RayFan;
using ruc::RayHit;
using ruc::SamplingRegion;
using ruc::SpherePack;
using ruc::Vector3;
using ruc::Window;

double Dot(const Vector3& a, const Vector3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

using Hit = std::tuple<int, double, double, int>; // ray, in, out, mode

std::vector<Hit> Sorted(const std::vector<RayHit>& hits)
{
  std::vector<Hit> sorted;
  for (const RayHit& hit : hits)
  {
    sorted.emplace_back(hit.Ray, hit.Sphere.In, hit.Sphere.Out, hit.Sphere.Mode);
  }
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

// Every sphere and every image near the rays, by the quadratic equation
std::vector<Hit> BruteForce(const SpherePack& pack, const Window& box, const RayFan& fan,
  const RayDirections& rays, double length)
{
  std::vector<Hit> hits;
  std::array<int, 3> last{};
  for (int q = 0; q < 3; ++q)
  {
    last[q] =
      box.Periodic[q] ? static_cast<int>((length + pack.LargestRadius()) / box.Size[q]) + 2 : 0;
  }
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    for (int nx = -last[0]; nx <= last[0]; ++nx)
    {
      for (int ny = -last[1]; ny <= last[1]; ++ny)
      {
        for (int nz = -last[2]; nz <= last[2]; ++nz)
        {
          const Vector3 from = { fan.Centre[0] - pack.X[i] - nx * box.Size[0],
            fan.Centre[1] - pack.Y[i] - ny * box.Size[1],
            fan.Centre[2] - pack.Z[i] - nz * box.Size[2] };
          const double r = pack.Radius[i], square = Dot(from, from);
          if (square > (length + r) * (length + r))
          {
            continue;
          }
          for (int ray = 0; ray < rays.Size(); ++ray)
          {
            const double b = Dot(from, rays.Of(fan, ray));
            const double quarter = b * b - square + r * r;
            const double root = std::sqrt(std::max(quarter, 0.0));
            if (quarter > 0.0 && root - b > 0.0 && -b - root < length)
            {
              hits.emplace_back(ray, -b - root, root - b, pack.Mode[i] - 1);
            }
          }
        }
      }
    }
  }
  std::sort(hits.begin(), hits.end());
  return hits;
}

const RayFan AlongTheAxes = { { 0.5, 2.5, 3.1 }, { 1, 0, 0 }, { 0, 0, -1 }, { 0, 1, 0 } };

// Random fans, and one along the axes of the box
std::vector<RayFan> FansIn(const Window& box, int number)
{
  const SamplingRegion region(box, 0.0);
  std::vector<RayFan> fans = { AlongTheAxes };
  for (int q = 0; q < 3; ++q)
  {
    fans[0].Centre[q] = box.Origin[q] + 0.3 * box.Size[q];
  }
  for (int n = 1; n < number; ++n)
  {
    fans.push_back(RayFan::Random(region, 6, n));
  }
  return fans;
}

constexpr std::array<bool, 3> Periodicities[] = { { false, false, false }, { true, true, true },
  { true, false, true }, { false, false, true } };

const Window Unit = Window::MakeBox({ 0, 0, 0 }, { 1, 1, 1 }, { false, false, false });

}

TEST(RayFan, IsOrthonormalAndRightHanded)
{
  const SamplingRegion region(Unit, 0.0);
  for (std::uint32_t n = 0; n < 2000; ++n)
  {
    const RayFan fan = RayFan::Random(region, 3, n);
    EXPECT_TRUE(region.Contains(fan.Centre));
    const Vector3 axes[] = { fan.U, fan.V, fan.Normal };
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        // Some ten roundings of numbers up to 1
        EXPECT_NEAR(Dot(axes[i], axes[j]), i == j, 2e-15);
      }
      EXPECT_NEAR(fan.U[(i + 1) % 3] * fan.V[(i + 2) % 3] - fan.U[(i + 2) % 3] * fan.V[(i + 1) % 3],
        fan.Normal[i], 2e-15);
    }
  }
}

TEST(RayFan, DependsOnSeedAndSampleAlone)
{
  const SamplingRegion region(Unit, 0.0), other(oracle::PeriodicCube(1.0), 0.0);
  const RayFan fan = RayFan::Random(region, 3, 5);
  EXPECT_EQ(fan.U, RayFan::Random(region, 3, 5).U);
  EXPECT_EQ(fan.U, RayFan::Random(other, 3, 5).U);
  EXPECT_EQ(fan.Centre, RayFan::Random(other, 3, 5).Centre);
  EXPECT_NE(fan.U, RayFan::Random(region, 3, 6).U);
  EXPECT_NE(fan.U, RayFan::Random(region, 4, 5).U);
  EXPECT_NE(fan.Centre, RayFan::Random(region, 3, 6).Centre);
}

TEST(RayFan, OrientationsAreIsotropic)
{
  // Moments of a uniformly distributed rotation (U, V, Normal): <e_i> = 0, <e_i e_j> = delta_ij /
  // 3, <e_i^4> = 1/5, <u_i v_j> = 0, <u_i^2 v_i^2> = 1/15, <u_i^2 v_j^2> = 2/15 and, by det = 1,
  // <u_i v_j n_k> = epsilon_ijk / 6. With some 60 comparisons 4.5 standard errors.
  const SamplingRegion region(Unit, 0.0);
  constexpr int number = 40000;
  std::map<std::tuple<int, int, int, int>, std::pair<Mean, double>> moments;
  for (std::uint32_t n = 0; n < number; ++n)
  {
    const RayFan fan = RayFan::Random(region, 11, n);
    const Vector3 axes[] = { fan.U, fan.V, fan.Normal };
    const auto add = [&](int kind, int a, int i, int j, double value, double expected)
    {
      auto& moment = moments[{ kind, a, i, j }];
      moment.first.Add(value);
      moment.second = expected;
    };
    for (int a = 0; a < 3; ++a)
    {
      const Vector3 &e = axes[a], &f = axes[(a + 1) % 3];
      for (int i = 0; i < 3; ++i)
      {
        add(0, a, i, 0, e[i], 0.0);
        add(1, a, i, 0, e[i] * e[i], 1.0 / 3.0);
        add(2, a, i, 0, e[i] * e[(i + 1) % 3], 0.0);
        add(3, a, i, 0, std::pow(e[i], 4), 0.2);
        for (int j = 0; j < 3; ++j)
        {
          add(4, a, i, j, e[i] * f[j], 0.0);
          add(5, a, i, j, e[i] * e[i] * f[j] * f[j], i == j ? 1.0 / 15.0 : 2.0 / 15.0);
        }
      }
    }
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      add(6, 0, i, 0, fan.U[i] * fan.V[j] * fan.Normal[k], 1.0 / 6.0);
      add(6, 1, i, 0, fan.U[i] * fan.V[k] * fan.Normal[j], -1.0 / 6.0);
    }
  }
  for (const auto& [name, moment] : moments)
  {
    EXPECT_NEAR(moment.first.Value(), moment.second, 4.5 * moment.first.Error())
      << std::get<0>(name) << " " << std::get<1>(name) << " " << std::get<2>(name) << " "
      << std::get<3>(name);
  }
}

TEST(RayDirections, AreEvenlyAroundTheCircle)
{
  for (int number : { 1, 2, 3, 8, 20, 97 })
  {
    const RayDirections rays(number);
    ASSERT_EQ(rays.Size(), number);
    EXPECT_EQ(rays.Of(AlongTheAxes, 0), AlongTheAxes.U);
    for (int i = 0; i < number; ++i)
    {
      EXPECT_NEAR(Dot(rays.Of(AlongTheAxes, i), AlongTheAxes.Normal), 0.0, 1e-15);
      for (int j = 0; j < number; ++j)
      {
        const double turn = 2.0 * oracle::Pi * (j - i) / number;
        EXPECT_NEAR(Dot(rays.Of(AlongTheAxes, i), rays.Of(AlongTheAxes, j)), std::cos(turn), 4e-15);
      }
      const Vector3 next = rays.Of(AlongTheAxes, (i + 1) % number);
      // The rays turn from U to V
      EXPECT_NEAR(Dot(next, AlongTheAxes.V), std::sin(2.0 * oracle::Pi * (i + 1) / number), 4e-15);
    }
  }
}

TEST(FanTracer, FindsWhatBruteForceFinds)
{
  std::size_t found = 0;
  for (const std::array<bool, 3>& periodic : Periodicities)
  {
    for (const oracle::PackInBox& c : oracle::HardPacks(periodic))
    {
      const double shortest = *std::min_element(c.Box.Size.begin(), c.Box.Size.end());
      // Shorter and longer than the box, and one ray as well as many
      for (const auto& [number, length] :
        { std::pair(1, 2.6), std::pair(7, 0.3), std::pair(20, 1.3) })
      {
        const RayDirections rays(number);
        const FanTracer tracer(c.Pack, c.Box, rays, length * shortest);
        for (const RayFan& fan : FansIn(c.Box, 60))
        {
          std::vector<RayHit> hits;
          tracer.FindHits(fan, hits);
          const std::vector<Hit> sorted = Sorted(hits);
          const std::vector<Hit> expected = BruteForce(c.Pack, c.Box, fan, rays, length * shortest);
          ASSERT_EQ(sorted.size(), expected.size());
          found += sorted.size();
          for (std::size_t n = 0; n < sorted.size(); ++n)
          {
            const auto [ray, in, out, mode] = sorted[n];
            EXPECT_EQ(ray, std::get<0>(expected[n]));
            // The root for a grazing ray loses half of the digits
            EXPECT_NEAR(in, std::get<1>(expected[n]), 1e-6);
            EXPECT_NEAR(out, std::get<2>(expected[n]), 1e-6);
            EXPECT_EQ(mode, std::get<3>(expected[n]));
          }
        }
      }
    }
  }
  EXPECT_GT(found, 10000u);
}

TEST(FanTracer, SpheresByThemselvesGiveTheSameHits)
{
  // In and Out depend on sphere and ray alone: the whole pack and all spheres one by one, each with
  // a search of its own, give `==` sets. Of the largest pack every fifth sphere is enough.
  const RayDirections rays(11);
  for (const std::array<bool, 3>& periodic : Periodicities)
  {
    for (const oracle::PackInBox& c : oracle::HardPacks(periodic))
    {
      SpherePack pack;
      for (std::size_t i = 0; i<c.Pack.Size(); i += c.Pack.Size()> 100 ? 5 : 1)
      {
        pack.Append(c.Pack, i);
      }
      const double length = 1.4 * *std::min_element(c.Box.Size.begin(), c.Box.Size.end());
      const std::vector<RayFan> fans = FansIn(c.Box, 8);
      std::vector<std::vector<RayHit>> whole(fans.size()), single(fans.size());
      const FanTracer tracer(pack, c.Box, rays, length);
      for (std::size_t i = 0; i < pack.Size(); ++i)
      {
        SpherePack sphere;
        sphere.Append(pack, i);
        const FanTracer one(sphere, c.Box, rays, length);
        for (std::size_t n = 0; n < fans.size(); ++n)
        {
          one.FindHits(fans[n], single[n]);
        }
      }
      for (std::size_t n = 0; n < fans.size(); ++n)
      {
        tracer.FindHits(fans[n], whole[n]);
        EXPECT_EQ(Sorted(whole[n]), Sorted(single[n]));
      }
    }
  }
}

TEST(FanTracer, AppendsAndKeepsTheWholeSphere)
{
  // A sphere around the centre of the fan, one that begins on the rays and ends beyond them, one
  // behind, and one that is only touched
  SpherePack pack;
  const auto add = [&](double x, double z, double radius)
  {
    pack.X.push_back(x);
    pack.Y.push_back(0.5);
    pack.Z.push_back(z);
    pack.Radius.push_back(radius);
    pack.Mode.push_back(static_cast<int>(pack.Mode.size()) + 1);
  };
  add(0.25, 0.5, 0.25);
  add(1.0, 0.5, 0.25);
  add(-0.5, 0.5, 0.25);
  add(0.5, 0.625, 0.125);
  const RayDirections rays(1);
  const FanTracer tracer(pack, Unit, rays, 0.875);
  std::vector<RayHit> hits = { { 7, { 1.0, 2.0, 3 } } };
  tracer.FindHits({ { 0.125, 0.5, 0.5 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, hits);
  const std::vector<Hit> expected = { { 0, -0.125, 0.375, 0 }, { 0, 0.625, 1.125, 1 },
    { 7, 1.0, 2.0, 3 } };
  EXPECT_EQ(Sorted(hits), expected); // numbers without rounding
}

TEST(FanTracer, FindsATinySphereFarAway)
{
  // The cells of one sphere are narrow: the ray is more of them long than an int holds
  SpherePack pack;
  pack.Append({ { 0.5 }, { 0.5 }, { 0.5 }, { 1e-5 }, { 1 }, {} }, 0);
  const RayDirections rays(2);
  for (const bool periodic : { false, true })
  {
    const Window box = Window::MakeBox({ 0, 0, 0 }, { 1, 1, 1 }, { periodic, periodic, periodic });
    std::vector<RayHit> hits;
    FanTracer(pack, box, rays, 1.75)
      .FindHits({ { 0.25, 0.5, 0.5 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, hits);
    // To the right the sphere and an image, to the left an image
    ASSERT_EQ(hits.size(), periodic ? 4u : 1u);
    for (const RayHit& hit : hits)
    {
      const double middle = 0.5 * (hit.Sphere.In + hit.Sphere.Out);
      EXPECT_NEAR(std::fmod(middle + (hit.Ray == 0 ? 0.25 : 0.75), 1.0), 0.5, 1e-15);
      EXPECT_NEAR(hit.Sphere.Out - hit.Sphere.In, 2e-5, 1e-15);
    }
  }
}

TEST(CellList, FindsEveryCentreNearADisc)
{
  oracle::Uniform random(9);
  std::vector<Vector3> normals = { { 1, 0, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 1e-12, 0, 1 },
    { 0, 1, 1e-10 }, { 1, 1e-14, 0 }, { std::sqrt(0.5), 0, -std::sqrt(0.5) } };
  while (normals.size() < 40)
  {
    normals.push_back(random.Direction());
  }
  std::size_t near = 0;
  for (const oracle::PackInBox& c : oracle::HardPacks({ false, false, false }))
  {
    for (double cutoff : { 0.02, 0.3, 2.0 })
    {
      const CellList cells(c.Pack, c.Box, cutoff);
      for (std::size_t n = 0; n < normals.size(); ++n)
      {
        const Vector3& normal = normals[n];
        // Inside, on the face and far beyond; discs from a point to wider than the box
        Vector3 middle = c.Box.Origin;
        for (int q = 0; q < 3; ++q)
        {
          middle[q] += n % 4 == 0 ? 0.0 : random(-0.5, 1.5) * c.Box.Size[q];
        }
        const double radius = std::array{ 0.0, 0.5, 3.0, 40.0 }[n % 4];
        const double reach = std::array{ 0.05, 0.4, 1.5 }[n % 3];
        std::vector<int> visits(c.Pack.Size(), 0);
        cells.ForEachNearDisc(middle, normal, radius, reach,
          [&](std::size_t begin, std::size_t end)
          {
            ASSERT_LT(begin, end);
            ASSERT_LE(end, visits.size());
            for (; begin < end; ++begin)
            {
              ++visits[cells.Index[begin]];
            }
          });
        for (std::size_t i = 0; i < c.Pack.Size(); ++i)
        {
          const Vector3 p = { c.Pack.X[i] - middle[0], c.Pack.Y[i] - middle[1],
            c.Pack.Z[i] - middle[2] };
          const double height = Dot(p, normal);
          const double lateral = std::sqrt(std::max(Dot(p, p) - height * height, 0.0));
          const bool isNear = std::hypot(height, std::max(lateral - radius, 0.0)) < reach;
          near += isNear;
          // A centre visited twice would be counted twice
          EXPECT_LE(visits[i], 1);
          EXPECT_TRUE(visits[i] == 1 || !isNear) << n << " " << i << " " << cutoff;
        }
      }
    }
  }
  EXPECT_GT(near, 1000u);
}

TEST(CellList, PassesOverMostCentresFarFromADisc)
{
  // A disc across the box reaches a tenth of it up and down; rows of cells are 0.5 cbrt(4 / 4000)
  // wide at least, 0.1, so what is visited lies within 0.1 + 0.1 and, tilted, 0.1 sqrt(3) more
  const SpherePack pack = oracle::RandomPack({ 4000 }, { 0.05 }, Unit, 3);
  const CellList cells(pack, Unit, 0.1);
  for (const Vector3& normal : { Vector3{ 0, 0, 1 }, { 0, 1, 0 }, { 1, 0, 0 }, { 0.6, 0, 0.8 } })
  {
    std::size_t visited = 0;
    cells.ForEachNearDisc({ 0.5, 0.5, 0.5 }, normal, 1.0, 0.1,
      [&](std::size_t begin, std::size_t end) { visited += end - begin; });
    EXPECT_GT(visited, 700u);
    EXPECT_LT(visited, 2400u);
  }
}
