// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Window/Window.h"

#include "Oracles.h"

#include <limits>

using ruc::Window;

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

// Share of a bounding box's random points that lie in the window together with their displaced copy
void ExpectSampledCovariance(
  const Window& window, const ruc::Vector3& low, const ruc::Vector3& high, const ruc::Vector3& d)
{
  oracle::Uniform random(11);
  constexpr int samples = 200000;
  int hits = 0;
  for (int n = 0; n < samples; ++n)
  {
    const ruc::Vector3 p = { random(low[0], high[0]), random(low[1], high[1]),
      random(low[2], high[2]) };
    hits += window.Contains(p) && window.Contains({ p[0] + d[0], p[1] + d[1], p[2] + d[2] });
  }
  const double volume = (high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2]);
  const double share = window.SetCovariance(d[0], d[1], d[2]) / volume;
  // The standard error is binomial; 4.5 of them, and one hit where the share is 0
  EXPECT_NEAR(
    double(hits) / samples, share, 4.5 * std::sqrt(share * (1.0 - share) / samples) + 0.5 / samples)
    << d[0] << " " << d[1] << " " << d[2];
}

// An independent test of a point against a cylinder: cross product with the axis
bool InCylinder(const ruc::Vector3& p, const ruc::Vector3& base, const ruc::Vector3& axis,
  double radius, double height)
{
  const double length = std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
  const ruc::Vector3 v = { p[0] - base[0], p[1] - base[1], p[2] - base[2] };
  const double along = (v[0] * axis[0] + v[1] * axis[1] + v[2] * axis[2]) / length;
  const double cx = v[1] * axis[2] - v[2] * axis[1], cy = v[2] * axis[0] - v[0] * axis[2],
               cz = v[0] * axis[1] - v[1] * axis[0];
  return along >= 0.0 && along <= height &&
    std::sqrt(cx * cx + cy * cy + cz * cz) / length <= radius;
}
}

TEST(Window, BoxSetCovarianceAgreesWithRandomPoints)
{
  const Window box =
    Window::MakeBox({ -1.0, 2.0, 0.5 }, { 4.0, 2.0, 3.0 }, { false, false, false });
  for (const ruc::Vector3& d : { ruc::Vector3{ 0, 0, 0 }, { 1.0, -0.5, 0.7 }, { -2.5, 0.1, -2.0 },
         { 0.0, 2.5, 0.0 }, { 3.9, 0, 0 } })
  {
    ExpectSampledCovariance(box, { -1.5, 1.5, 0.0 }, { 3.5, 4.5, 4.0 }, d);
  }
}

TEST(Window, PeriodicAxesLoseNoVolume)
{
  const Window box = Window::MakeBox({ 0, 0, 0 }, { 4.0, 2.0, 3.0 }, { true, false, true });
  EXPECT_DOUBLE_EQ(box.SetCovariance(17.0, 0.5, -9.0), 4.0 * 1.5 * 3.0);
  EXPECT_EQ(box.SetCovariance(0.0, -2.0, 0.0), 0.0);
}

TEST(Window, CylinderSetCovarianceAgreesWithRandomPoints)
{
  for (const ruc::Vector3& axis :
    { ruc::Vector3{ 0, 0, 1 }, { 0, 0, -2 }, { 1, 2, -2 }, { 5, 0, 0 }, { 0.3, 0.1, 0.9 } })
  {
    const Window cylinder = Window::MakeCylinder({ 0.2, -0.3, 0.1 }, axis, 1.3, 2.0);
    const double length = std::hypot(axis[0], axis[1], axis[2]);
    const ruc::Vector3 middle = { 0.2 + axis[0] / length, -0.3 + axis[1] / length,
      0.1 + axis[2] / length };
    const double half = 1.75; // > half the diagonal sqrt(1.3^2 + 1^2)
    for (const ruc::Vector3& d : { ruc::Vector3{ 0, 0, 0 }, { 0.3, 0.4, 0.5 }, { -1.1, 0.2, 0.6 },
           { 0.0, 0.0, 1.9 }, { 2.7, 0, 0 } })
    {
      ExpectSampledCovariance(cylinder, { middle[0] - half, middle[1] - half, middle[2] - half },
        { middle[0] + half, middle[1] + half, middle[2] + half }, d);
    }
  }
}

TEST(Window, ContainsIsTheDefinition)
{
  const ruc::Vector3 base = { 1, 2, 3 }, axis = { 1, -2, 0.5 };
  const Window cylinder = Window::MakeCylinder(base, axis, 1.5, 4.0);
  oracle::Uniform random(3);
  int inside = 0;
  for (int n = 0; n < 20000; ++n)
  {
    const ruc::Vector3 p = { random(-2, 6), random(-4, 5), random(0, 7) };
    EXPECT_EQ(cylinder.Contains(p), InCylinder(p, base, axis, 1.5, 4.0));
    inside += cylinder.Contains(p);
  }
  EXPECT_GT(inside, 100);

  const Window box = Window::MakeBox({ 0, 0, 0 }, { 1, 1, 1 }, { true, false, false });
  EXPECT_TRUE(box.Contains({ 0, 0, 0 }));
  EXPECT_TRUE(box.Contains({ 1, 1, 1 }));
  EXPECT_TRUE(box.Contains({ 1.0 + 5e-10, 0.5, 0.5 })); // a rounding error beyond a periodic face
  EXPECT_TRUE(box.Contains({ -5e-10, 0.5, 0.5 }));
  EXPECT_FALSE(box.Contains({ 1.0 + 5e-9, 0.5, 0.5 }));
  EXPECT_FALSE(box.Contains({ 0.5, 1.0 + 5e-10, 0.5 }));
  EXPECT_FALSE(box.Contains({ 0.5, 0.5, -5e-10 }));
  EXPECT_FALSE(box.Contains({ NaN, 0.5, 0.5 }));
}

TEST(Window, ReachKeepsTheSetCovariancePositive)
{
  oracle::Uniform random(5);
  const Window windows[] = { Window::MakeBox({ 0, 0, 0 }, { 4, 2, 3 }, { false, false, false }),
    Window::MakeBox({ 0, 0, 0 }, { 4, 2, 3 }, { false, true, false }),
    Window::MakeCylinder({ 0, 0, 0 }, { 1, 1, 0 }, 1.0, 5.0),
    Window::MakeCylinder({ 0, 0, 0 }, { 1, 1, 3 }, 4.0, 1.5) };
  const double reaches[] = { 2.0, 3.0, 2.0, 1.5 };
  for (int w = 0; w < 4; ++w)
  {
    EXPECT_DOUBLE_EQ(windows[w].Reach(), reaches[w]);
    for (int n = 0; n < 5000; ++n)
    {
      const ruc::Vector3 u = random.Direction();
      const double r = 0.9999 * windows[w].Reach();
      EXPECT_GT(windows[w].SetCovariance(r * u[0], r * u[1], r * u[2]), 0.0);
    }
  }
  EXPECT_TRUE(std::isinf(oracle::PeriodicCube(1.0).Reach()));
}

TEST(Window, VolumeAndEdges)
{
  const Window box = Window::MakeBox({ 1, 1, 1 }, { 4, 2, 3 }, { false, true, false });
  EXPECT_DOUBLE_EQ(box.Volume(), 24.0);
  EXPECT_DOUBLE_EQ(box.ShortestEdge(), 2.0);
  EXPECT_TRUE(box.IsPeriodic());
  EXPECT_FALSE(box.IsFullyPeriodic());
  const Window cylinder = Window::MakeCylinder({ 0, 0, 0 }, { 0, 3, 4 }, 2.0, 5.0);
  EXPECT_DOUBLE_EQ(cylinder.Volume(), oracle::Pi * 20.0);
  EXPECT_DOUBLE_EQ(cylinder.ShortestEdge(), 4.0);
  EXPECT_DOUBLE_EQ(cylinder.Axis[1], 0.6);
  EXPECT_DOUBLE_EQ(cylinder.Axis[2], 0.8);
  EXPECT_FALSE(cylinder.IsPeriodic());
}

TEST(Window, BadInputIsNamed)
{
  const std::array<bool, 3> none = { false, false, false };
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_SAYS(Window::MakeBox({ NaN, 0, 0 }, { 1, 1, 1 }, none), "BoxOrigin");
  EXPECT_SAYS(Window::MakeBox({ 0, inf, 0 }, { 1, 1, 1 }, none), "BoxOrigin");
  EXPECT_SAYS(Window::MakeBox({ 0, 0, 0 }, { 1, 0, 1 }, none),
    "BoxSize requires three finite edges > 0, got 1 0 1.");
  EXPECT_SAYS(Window::MakeBox({ 0, 0, 0 }, { 1, 1, -1 }, none), "BoxSize");
  EXPECT_SAYS(Window::MakeBox({ 0, 0, 0 }, { NaN, 1, 1 }, none), "BoxSize");
  EXPECT_SAYS(Window::MakeBox({ 0, 0, 0 }, { inf, 1, 1 }, none), "BoxSize");
  EXPECT_SAYS(Window::MakeCylinder({ 0, NaN, 0 }, { 0, 0, 1 }, 1, 1), "CylinderBase");
  EXPECT_SAYS(Window::MakeCylinder({ 0, 0, 0 }, { 0, 0, 0 }, 1, 1), "CylinderAxis");
  EXPECT_SAYS(Window::MakeCylinder({ 0, 0, 0 }, { 0, 0, NaN }, 1, 1), "CylinderAxis");
  EXPECT_SAYS(Window::MakeCylinder({ 0, 0, 0 }, { 0, 0, 1 }, 0, 1),
    "CylinderRadius requires a finite number > 0, got 0.");
  EXPECT_SAYS(Window::MakeCylinder({ 0, 0, 0 }, { 0, 0, 1 }, inf, 1), "CylinderRadius");
  EXPECT_SAYS(Window::MakeCylinder({ 0, 0, 0 }, { 0, 0, 1 }, 1, -2), "CylinderHeight");
  EXPECT_SAYS(Window::MakeCylinder({ 0, 0, 0 }, { 0, 0, 1 }, 1, NaN), "CylinderHeight");
}

TEST(Window, LengthsWhoseVolumesAreNoNumbersAreRefused)
{
  const std::array<bool, 3> none = { false, false, false };
  for (double bad : { 1e-150, 9e-51, 1.1e50, 1e150 })
  {
    EXPECT_SAYS(Window::MakeBox({ 0, 0, 0 }, { 1, bad, 1 }, none),
      "BoxSize requires a length from 1e-50 to 1e+50, got ");
    EXPECT_SAYS(Window::MakeCylinder({ 0, 0, 0 }, { 0, 0, 1 }, bad, 1),
      "CylinderRadius requires a length from 1e-50 to 1e+50");
    EXPECT_SAYS(Window::MakeCylinder({ 0, 0, 0 }, { 0, 0, 1 }, 1, bad),
      "CylinderHeight requires a length from 1e-50 to 1e+50");
  }
  EXPECT_SAYS(Window::MakeBox({ 0, -1e60, 0 }, { 1, 1, 1 }, none),
    "BoxOrigin requires three numbers of at most 1e+50");
  EXPECT_SAYS(Window::MakeCylinder({ 1e60, 0, 0 }, { 0, 0, 1 }, 1, 1),
    "CylinderBase requires three numbers of at most 1e+50");
  for (double edge : { ruc::LeastLength, ruc::GreatestLength })
  {
    const double volume = Window::MakeBox({ 0, 0, 0 }, { edge, edge, edge }, none).Volume();
    EXPECT_TRUE(std::isnormal(volume * volume) && std::isnormal(1.0 / (volume * volume)));
  }
}
