// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/**
 * @file
 * What the tests compare with: integrals by quadrature, pairs by brute force over images, random
 * packs. Nothing here uses the core's own formulas or its cell list.
 */

#include "ruc/Packing/OverlapRemoval.h"
#include "ruc/Particles/SpherePack.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace oracle
{
constexpr double Pi = 3.14159265358979323846;

/**
 * What a std::invalid_argument says, or a text that no message contains when nothing or something
 * else is thrown.
 */
template <class Function>
std::string MessageOf(Function&& function)
{
  try
  {
    function();
  }
  catch (const std::invalid_argument& e)
  {
    return e.what();
  }
  catch (...)
  {
    return "<another exception>";
  }
  return "<no exception>";
}

/** Expects `call` to throw std::invalid_argument with `part` in its message. */
#define EXPECT_SAYS(call, part)                                                                    \
  do                                                                                               \
  {                                                                                                \
    const std::string said_by_call = oracle::MessageOf([&]() { call; });                           \
    EXPECT_NE(said_by_call.find(part), std::string::npos)                                          \
      << "message: " << said_by_call << "\nwanted: " << (part);                                    \
  } while (false)

/** Uniform random numbers. */
class Uniform
{
public:
  explicit Uniform(std::uint64_t seed)
    : Generator(seed)
  {
  }
  /** A number in [low, high). */
  double operator()(double low = 0.0, double high = 1.0)
  {
    return low + (high - low) * ((this->Generator() >> 11) * 0x1p-53);
  }

  ruc::Vector3 Direction()
  {
    const double z = (*this)(-1.0, 1.0);
    const double phi = (*this)(0.0, 2.0 * Pi);
    const double s = std::sqrt(1.0 - z * z);
    return { s * std::cos(phi), s * std::sin(phi), z };
  }

private:
  std::mt19937_64 Generator;
};

/**
 * Double-exponential quadrature, which also suits integrands with a root or a kink at an end of the
 * interval.
 */
template <class Function>
double Integrate(double from, double to, Function&& f)
{
  if (!(to > from))
  {
    return 0.0;
  }
  constexpr double step = 1.0 / 16.0;
  double sum = 0.0;
  for (int n = -56; n <= 56; ++n)
  {
    const double t = n * step;
    const double u = 0.5 * Pi * std::sinh(t);
    const double weight = 0.5 * Pi * std::cosh(t) / (std::cosh(u) * std::cosh(u));
    sum += weight * f(0.5 * (from + to) + 0.5 * (to - from) * std::tanh(u));
  }
  return 0.5 * (to - from) * step * sum;
}

/** The same over an interval cut at those of `kinks` that lie in it. */
template <class Function>
double Integrate(double from, double to, std::vector<double> kinks, Function&& f)
{
  kinks.push_back(from);
  kinks.push_back(to);
  std::sort(kinks.begin(), kinks.end());
  double sum = 0.0;
  for (std::size_t n = 1; n < kinks.size(); ++n)
  {
    sum += Integrate(std::clamp(kinks[n - 1], from, to), std::clamp(kinks[n], from, to), f);
  }
  return sum;
}

/**
 * The volume shared by two spheres: the area of the lesser of the two coaxial discs, integrated
 * along the line of centres. It is a polynomial of degree 2 between its kinks, for which Simpson's
 * rule is exact.
 */
inline double LensVolume(double a, double b, double t)
{
  const double from = std::max(-a, t - b), to = std::min(a, t + b);
  if (!(to > from))
  {
    return 0.0;
  }
  const double crossing = t > 0.0 ? std::clamp(0.5 * (t * t + a * a - b * b) / t, from, to) : from;
  const auto area = [&](double z)
  { return Pi * std::max(std::min(a * a - z * z, b * b - (z - t) * (z - t)), 0.0); };
  const auto simpson = [&](double low, double high)
  { return (high - low) / 6.0 * (area(low) + 4.0 * area(0.5 * (low + high)) + area(high)); };
  return simpson(from, crossing) + simpson(crossing, to);
}

/**
 * The volume of the union of three spheres of radius a at the corners of a triangle with sides r1
 * and r2 and the angle theta between them. Over a point of the triangle's plane at a distance rho
 * from the nearest corner the union has the height 2 sqrt(a^2 - rho^2). So every sphere loses what
 * lies beyond the bisectors towards the other corners: in a direction in which a bisector is rho
 * away, 2/3 (a^2 - rho^2)^(3/2). The integral over directions, with rho = h / cos(phi), is
 * elementary.
 */
inline double UnionOfThree(double a, double r1, double r2, double theta)
{
  const double sphere = 4.0 / 3.0 * Pi * a * a * a;
  const auto lost = [&](double h, double end)
  {
    if (h >= a)
    {
      return 0.0;
    }
    const double reach = std::sqrt(a * a - h * h), last = std::acos(h / a);
    const auto primitive = [&](double phi)
    {
      const double s = std::clamp(h * std::tan(phi) / reach, -1.0, 1.0);
      const double root = std::sqrt(1.0 - s * s);
      return a * a * a * std::atan2(a * s, h * root) - a * a * h * std::asin(s) -
        0.5 * h * reach * reach * (s * root + std::asin(s));
    };
    return 2.0 / 3.0 * (primitive(std::clamp(end, -last, last)) - primitive(-last));
  };
  const double corners[3][2] = { { 0.0, 0.0 }, { r1, 0.0 },
    { r2 * std::cos(theta), r2 * std::sin(theta) } };
  double sum = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    double x[2], y[2], h[2];
    for (int n = 0; n < 2; ++n)
    {
      const int j = (i + 1 + n) % 3;
      x[n] = corners[j][0] - corners[i][0];
      y[n] = corners[j][1] - corners[i][1];
      h[n] = 0.5 * std::hypot(x[n], y[n]);
    }
    for (int n = 0; n < 2; ++n)
    {
      if (h[n] == 0.0)
      {
        return 2.0 * sphere - LensVolume(a, a, 2.0 * h[1 - n]); // two corners coincide
      }
    }
    // From the direction of a corner, towards the other one, up to where the bisectors cross
    const double angle = std::atan2(std::abs(x[0] * y[1] - x[1] * y[0]), x[0] * x[1] + y[0] * y[1]);
    sum += sphere;
    for (int n = 0; n < 2; ++n)
    {
      sum -= lost(h[n], std::atan2(h[1 - n] - h[n] * std::cos(angle), h[n] * std::sin(angle)));
    }
  }
  return sum;
}

/** The volume common to the same three spheres. */
inline double CommonToThree(double a, double r1, double r2, double theta)
{
  const double r3 = std::sqrt(std::max(r1 * r1 + r2 * r2 - 2.0 * r1 * r2 * std::cos(theta), 0.0));
  return UnionOfThree(a, r1, r2, theta) - 4.0 * Pi * a * a * a + LensVolume(a, a, r1) +
    LensVolume(a, a, r2) + LensVolume(a, a, r3);
}

/**
 * The mean of the lens volume over all directions of the lag: 1/2 integral over mu of V(sqrt(d^2 +
 * r^2 - 2 d r mu)).
 */
inline double AveragedLens(double a, double b, double r, double d)
{
  if (r == 0.0 || d == 0.0)
  {
    return LensVolume(a, b, r + d);
  }
  std::vector<double> kinks;
  for (double t : { a + b, std::abs(a - b) })
  {
    kinks.push_back((d * d + r * r - t * t) / (2.0 * d * r));
  }
  return 0.5 *
    Integrate(-1.0, 1.0, kinks,
      [&](double mu)
      { return LensVolume(a, b, std::sqrt(std::max(d * d + r * r - 2.0 * d * r * mu, 0.0))); });
}

/**
 * A bound of the error of g_ab(r; d) when it is interpolated by cubic Hermite polynomials on knots
 * H apart, of which the contact a + b is one. A jump J of the third derivative inside an interval
 * makes an error of at most J H^3 / 192, a fourth derivative M one of M H^4 / 384. h_ab = 2 d r g
 * jumps by 2 pi a b where t = d - r or d + r equals a + b or |a - b|, and for equal radii by 4 pi a
 * b at t = 0; in between its fourth derivative is at most 4 pi max(a, b). The bound is twice that,
 * for the factor 1 / d and for two jumps in one interval. A jump at a distance r from a knot makes
 * an error of at most 0.074 J r^2 H: for r < H / 4, where the jumps at the contact a + b are so
 * near to its knot, the error falls with r.
 */
inline double HermiteError(double a, double b, double r, double d, double knots)
{
  const double s = a + b, q = std::abs(a - b);
  const double quotient =
    1.0 / (2.0 * std::max(r, 0.25 * knots) * std::max(d - knots, 0.25 * knots));
  double bound = 0.0;
  for (double t : { std::abs(d - r), d + r })
  {
    if (std::abs(t - s) < knots)
    {
      bound += 2.0 * Pi * a * b * std::pow(knots, 3) / 192.0 * std::min(4.0 * r / knots, 1.0);
    }
    if (std::abs(t - q) < knots)
    {
      bound += (q < knots ? 4.0 : 2.0) * Pi * a * b * std::pow(knots, 3) / 192.0;
    }
    if (t < s + knots)
    {
      bound += 4.0 * Pi * std::max(a, b) * std::pow(knots, 4) / 384.0;
    }
  }
  return 2.0 * bound * quotient;
}

/**
 * Calls visit(i, j, image, d) once for every unordered pair of a centre i and the image of a centre
 * j, `image` whole edges away, that are closer than the cut-off; i <= j, and image > 0
 * lexicographically for i = j.
 */
template <class Visit>
void ForEachPair(const ruc::SpherePack& pack, const ruc::Window& box, double cutoff, Visit&& visit)
{
  std::array<int, 3> last;
  for (int q = 0; q < 3; ++q)
  {
    last[q] = box.Periodic[q] ? static_cast<int>(std::ceil(cutoff / box.Size[q])) + 1 : 0;
  }
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    for (std::size_t j = i; j < pack.Size(); ++j)
    {
      for (int nx = -last[0]; nx <= last[0]; ++nx)
      {
        for (int ny = -last[1]; ny <= last[1]; ++ny)
        {
          for (int nz = -last[2]; nz <= last[2]; ++nz)
          {
            const std::array<int, 3> image = { nx, ny, nz };
            if (i == j && !(image > std::array<int, 3>{ 0, 0, 0 }))
            {
              continue;
            }
            const double dx = pack.X[j] + nx * box.Size[0] - pack.X[i];
            const double dy = pack.Y[j] + ny * box.Size[1] - pack.Y[i];
            const double dz = pack.Z[j] + nz * box.Size[2] - pack.Z[i];
            const double d = std::sqrt(dx * dx + dy * dy + dz * dz);
            if (d < cutoff)
            {
              visit(i, j, image, d);
            }
          }
        }
      }
    }
  }
}

/**
 * The least d - (a + b)(1 - 1e-12) over all pairs and images. The plugin promises that it is not
 * negative.
 */
inline double LeastGap(const ruc::SpherePack& pack, const ruc::Window& box)
{
  double least = 1e300;
  ForEachPair(pack, box, 2.1 * pack.LargestRadius(),
    [&](std::size_t i, std::size_t j, const std::array<int, 3>&, double d)
    { least = std::min(least, d - (pack.Radius[i] + pack.Radius[j]) * (1.0 - 1e-12)); });
  return least;
}

/** Edge of a cube that these spheres fill to a fraction. */
inline double EdgeFor(
  const std::vector<int>& counts, const std::vector<double>& radii, double fraction)
{
  double volume = 0.0;
  for (std::size_t m = 0; m < counts.size(); ++m)
  {
    volume += counts[m] * 4.0 / 3.0 * Pi * std::pow(radii[m], 3);
  }
  return std::cbrt(volume / fraction);
}

/** A mean and its standard error. */
struct Mean
{
  double Sum = 0.0, Squares = 0.0, Count = 0.0;

  void Add(double value)
  {
    this->Sum += value;
    this->Squares += value * value;
    this->Count += 1.0;
  }
  double Value() const { return this->Sum / this->Count; }
  double Error() const
  {
    return std::sqrt((this->Squares / this->Count - this->Value() * this->Value()) / this->Count);
  }
};

inline ruc::Window PeriodicCube(double edge)
{
  return ruc::Window::MakeBox({ 0.0, 0.0, 0.0 }, { edge, edge, edge }, { true, true, true });
}

/** Makes `counts[m]` spheres of radius `radii[m]` and mode m + 1 at random places of a box. */
inline ruc::SpherePack RandomPack(const std::vector<int>& counts, const std::vector<double>& radii,
  const ruc::Window& box, std::uint64_t seed)
{
  Uniform random(seed);
  ruc::SpherePack pack;
  for (std::size_t m = 0; m < counts.size(); ++m)
  {
    for (int n = 0; n < counts[m]; ++n)
    {
      pack.X.push_back(random(box.Origin[0], box.Origin[0] + box.Size[0]));
      pack.Y.push_back(random(box.Origin[1], box.Origin[1] + box.Size[1]));
      pack.Z.push_back(random(box.Origin[2], box.Origin[2] + box.Size[2]));
      pack.Radius.push_back(radii[m]);
      pack.Mode.push_back(static_cast<int>(m) + 1);
    }
  }
  return pack;
}

/** The same without overlap, in canonical order. */
inline ruc::SpherePack RelaxedPack(const std::vector<int>& counts, const std::vector<double>& radii,
  const ruc::Window& box, std::uint64_t seed)
{
  ruc::SpherePack pack = RandomPack(counts, radii, box, seed);
  EXPECT_TRUE(ruc::RemoveOverlap(pack, box, 1, []() { return true; }));
  ruc::SortCanonically(pack);
  return pack;
}

struct PackInBox
{
  ruc::SpherePack Pack;
  ruc::Window Box;
};

/**
 * Packs that are hard to search: with sizes of a ratio of 20; in a box hardly larger than the
 * largest sphere; in one as flat as a plate; of one sphere; of none. They may overlap.
 */
inline std::vector<PackInBox> HardPacks(const std::array<bool, 3>& periodic)
{
  const ruc::Window wide = ruc::Window::MakeBox({ -1, 2, 3 }, { 4.0, 5.0, 6.0 }, periodic);
  const ruc::Window tight = ruc::Window::MakeBox({ 0, 0, 0 }, { 2.01, 2.2, 2.1 }, periodic);
  const ruc::Window plate = ruc::Window::MakeBox({ 0, 0, 0 }, { 20.0, 20.0, 0.5 }, periodic);
  return { { RandomPack({ 3, 30, 300 }, { 1.0, 0.2, 0.05 }, wide, 1), wide },
    { RandomPack({ 2, 20 }, { 1.0, 0.05 }, tight, 2), tight },
    { RandomPack({ 200 }, { 0.2 }, plate, 3), plate },
    { RandomPack({ 1 }, { 0.7 }, wide, 4), wide }, { ruc::SpherePack(), wide } };
}

/** A pack in a periodic cube with the 26 images around it. */
inline ruc::SpherePack WithImages(const ruc::SpherePack& cell, double edge)
{
  ruc::SpherePack pack;
  for (std::size_t i = 0; i < cell.Size(); ++i)
  {
    for (int n = 0; n < 27; ++n)
    {
      pack.Append(cell, i);
      pack.X.back() += edge * (n % 3 - 1);
      pack.Y.back() += edge * (n / 3 % 3 - 1);
      pack.Z.back() += edge * (n / 9 - 1);
    }
  }
  return pack;
}
}
