// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/ThirdOrder/ShellMultipoles.h"

#include "ruc/Base/FixedPoint.h"
#include "ruc/Base/VectorClones.h"
#include "ruc/Statistics/ThirdOrder/LaneFactors.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace ruc
{
namespace
{
constexpr int MostHarmonics = 2 * HarmonicCount(HighestOfShells);
constexpr double Rounder = FixedPointRounder / 1099511627776.0; // to 2^-40

[[gnu::always_inline]] inline void Load(const double* from, Lanes& to)
{
  std::memcpy(&to, from, sizeof(to));
}

[[gnu::always_inline]] inline void Store(const Lanes& from, double* to)
{
  std::memcpy(to, &from, sizeof(from));
}

double Sum(const Lanes& lanes)
{
  double sum = 0.0;
  for (int k = 0; k < NumberOfLanes; ++k)
  {
    sum += lanes[k];
  }
  return sum;
}

// The square roots of the weights of the harmonics, which make them Y_lm
struct RootWeights
{
  RootWeights()
  {
    for (int l = 0; l <= HighestOfShells; ++l)
    {
      for (int m = 0; m <= l; ++m)
      {
        this->Of[HarmonicPlace(l, m)] = std::sqrt(HarmonicWeight(l, m));
      }
    }
  }
  double Of[HarmonicCount(HighestOfShells)];
};
const RootWeights Roots;

// Some neighbours side by side. Lanes without one repeat the last.
struct Group
{
  const ShellMultipoles::Neighbour* First;
  int Count;
};

// Y_lm in the directions of a group, and their gradients but for the part along them
struct DirectionHarmonics
{
  [[gnu::always_inline]] inline DirectionHarmonics(
    const Group& group, int degree, bool withGradients);

  Lanes Y[MostHarmonics];
  Lanes Along[3][MostHarmonics];
};

// For the gradients see Turn in LocalForces.cxx
inline DirectionHarmonics::DirectionHarmonics(const Group& group, int degree, bool withGradients)
{
  Lanes u[3];
  for (int lane = 0; lane < NumberOfLanes; ++lane)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      u[axis][lane] = group.First[std::min(lane, group.Count - 1)].Direction[axis];
    }
  }
  Lanes real[HarmonicCount(GreatestDegree)], imaginary[HarmonicCount(GreatestDegree)];
  FindHarmonics<Lanes>(
    degree + (withGradients ? 1 : 0), u[0], u[1], u[2], Lanes{} + 1.0, real, imaginary);
  for (int l = 0; l <= degree; ++l)
  {
    for (int m = 0; m <= l; ++m)
    {
      const int n = HarmonicPlace(l, m);
      const double root = Roots.Of[n];
      this->Y[2 * n] = root * real[n];
      this->Y[2 * n + 1] = root * imaginary[n];
      if (!withGradients)
      {
        continue;
      }
      const int up = HarmonicPlace(l + 1, m + 1), same = up - 1, down = up - 2;
      const Lanes before = m > 0 ? real[down] : -real[up];
      const Lanes imaginaryBefore = m > 0 ? imaginary[down] : imaginary[up];
      this->Along[0][2 * n] = 0.5 * root * (before - real[up]);
      this->Along[0][2 * n + 1] = 0.5 * root * (imaginaryBefore - imaginary[up]);
      this->Along[1][2 * n] = -0.5 * root * (imaginaryBefore + imaginary[up]);
      this->Along[1][2 * n + 1] = 0.5 * root * (before + real[up]);
      this->Along[2][2 * n] = -root * real[same];
      this->Along[2][2 * n + 1] = -root * imaginary[same];
    }
  }
}

// The caps that a neighbour cuts from a block of shells
struct Caps
{
  [[gnu::always_inline]] inline Caps(
    const Lanes& distances, double radius, const ShellMultipoles::Neighbour& neighbour, int degree);

  Lanes Legendre[HighestOfShells + 2], Cosine, Slope; // P_l(x), x, and dx/dd
  Lanes Of[HighestOfShells + 1];                      // C_l(x)
};

inline Caps::Caps(
  const Lanes& distances, double radius, const ShellMultipoles::Neighbour& neighbour, int degree)
{
  const double d = neighbour.Distance, b = neighbour.Radius;
  const Lanes zero = {}, one = zero + 1.0;
  const Lanes rho = distances + radius;
  const Lanes raw = (d * d + rho * rho - b * b) / (2.0 * d * rho);
  const Lanes low = raw < -one ? -one : raw;
  this->Cosine = low > one ? one : low;
  this->Slope = this->Cosine == raw ? 1.0 / rho - raw / d : zero;
  this->Legendre[0] = one;
  this->Legendre[1] = this->Cosine;
  for (int l = 1; l <= degree; ++l)
  {
    const double next = (2.0 * l + 1.0) / (l + 1.0), before = l / (l + 1.0);
    this->Legendre[l + 1] =
      next * this->Cosine * this->Legendre[l] - before * this->Legendre[l - 1];
  }
  this->Of[0] = 2.0 * Pi * (one - this->Cosine);
  for (int l = 1; l <= degree; ++l)
  {
    this->Of[l] = (this->Legendre[l - 1] - this->Legendre[l + 1]) * (2.0 * Pi / (2.0 * l + 1.0));
  }
}

// The shells around a centre, and where its multipoles stand
struct Surround
{
  double Radius;
  const double* Distances;
  int Shells, Degree;
  std::size_t SizeOfClass;

  // Whether a neighbour cuts any shell of the block that begins with the n-th
  [[gnu::always_inline]] inline bool IsCut(const ShellMultipoles::Neighbour& neighbour, int n) const
  {
    const double b = neighbour.Radius, d = neighbour.Distance;
    return d - b < this->Radius + this->Distances[n + NumberOfLanes - 1] &&
      d + b > this->Radius + this->Distances[n];
  }
};

// The loops over neighbours, shells and harmonics
RUC_VECTOR_CLONES
void AddCaps(const Group& group, const Surround& around, double* sums)
{
  const int shells = around.Shells, degree = around.Degree;
  const DirectionHarmonics harmonics(group, degree, false);
  for (int j = 0; j < group.Count; ++j)
  {
    const ShellMultipoles::Neighbour& neighbour = group.First[j];
    double* const own = sums + neighbour.Class * around.SizeOfClass;
    for (int n = 0; n < shells; n += NumberOfLanes)
    {
      if (!around.IsCut(neighbour, n))
      {
        continue;
      }
      Lanes block;
      Load(around.Distances + n, block);
      const Caps caps(block, around.Radius, neighbour, degree);
      double* target = own + n;
      for (int l = 0; l <= degree; ++l)
      {
        for (int k = 2 * HarmonicPlace(l, 0); k < 2 * HarmonicPlace(l + 1, 0); ++k)
        {
          Lanes sum;
          Load(target, sum);
          sum += (caps.Of[l] * harmonics.Y[k][j] + Rounder) - Rounder;
          Store(sum, target);
          target += shells;
        }
      }
    }
  }
}

// Of every neighbour along its direction, and along x, y and z
RUC_VECTOR_CLONES
void FindPulls(const Group& group, const Surround& around, const double* lambda, double* pulls)
{
  const int shells = around.Shells, degree = around.Degree;
  const DirectionHarmonics harmonics(group, degree, true);
  for (int j = 0; j < group.Count; ++j)
  {
    const ShellMultipoles::Neighbour& neighbour = group.First[j];
    const double* const own = lambda + neighbour.Class * around.SizeOfClass;
    Lanes away = {}, across[3] = {};
    for (int n = 0; n < shells; n += NumberOfLanes)
    {
      if (!around.IsCut(neighbour, n))
      {
        continue;
      }
      Lanes block;
      Load(around.Distances + n, block);
      const Caps caps(block, around.Radius, neighbour, degree);
      const double* source = own + n;
      for (int l = 0; l <= degree; ++l)
      {
        Lanes value = {}, turned[3] = {};
        for (int k = 2 * HarmonicPlace(l, 0); k < 2 * HarmonicPlace(l + 1, 0); ++k)
        {
          Lanes factor;
          Load(source, factor);
          source += shells;
          value += factor * harmonics.Y[k][j];
          turned[0] += factor * harmonics.Along[0][k][j];
          turned[1] += factor * harmonics.Along[1][k][j];
          turned[2] += factor * harmonics.Along[2][k][j];
        }
        away += value * caps.Legendre[l] * caps.Slope;
        for (int axis = 0; axis < 3; ++axis)
        {
          across[axis] += turned[axis] * caps.Of[l];
        }
      }
    }
    pulls[4 * j] = -2.0 * Pi * Sum(away); // dC_l/dx = -2 pi P_l
    for (int axis = 0; axis < 3; ++axis)
    {
      pulls[4 * j + 1 + axis] = Sum(across[axis]);
    }
  }
}

// Some rows at a time stay in registers. Shells come in blocks of lanes, which are whole numbers of
// them.
constexpr int RowsAtATime = 4;
static_assert(NumberOfLanes % RowsAtATime == 0);

// Puts the sums over k of a[k][n1] b[k][n2] into table[n1][n2]
RUC_VECTOR_CLONES
void FindTable(const double* a, const double* b, int count, int rows, int shells, double* table)
{
  for (int row = 0; row < rows; row += RowsAtATime)
  {
    for (int n = 0; n < shells; n += NumberOfLanes)
    {
      Lanes sums[RowsAtATime] = {};
      for (int k = 0; k < count; ++k)
      {
        Lanes other;
        Load(b + k * shells + n, other);
        for (int r = 0; r < RowsAtATime; ++r)
        {
          sums[r] += a[k * shells + row + r] * other;
        }
      }
      for (int r = 0; r < RowsAtATime; ++r)
      {
        Store(sums[r], table + (row + r) * shells + n);
      }
    }
  }
}

RUC_VECTOR_CLONES
void Scale(const double* from, double factor, int count, double* to)
{
  for (int n = 0; n < count; ++n)
  {
    to[n] = factor * from[n];
  }
}

// Adds to sums[k][n1] the sums over n2 of numbers[k][n2] table[n2][n1]; count is even
RUC_VECTOR_CLONES
void AddRows(
  const double* numbers, const double* table, int count, int rows, int shells, double* sums)
{
  for (int k = 0; k < count; k += 2)
  {
    const double *first = numbers + k * shells, *second = first + shells;
    for (int n = 0; n < shells; n += NumberOfLanes)
    {
      Lanes sum, next;
      Load(sums + k * shells + n, sum);
      Load(sums + (k + 1) * shells + n, next);
      for (int row = 0; row < rows; ++row)
      {
        Lanes other;
        Load(table + row * shells + n, other);
        sum += first[row] * other;
        next += second[row] * other;
      }
      Store(sum, sums + k * shells + n);
      Store(next, sums + (k + 1) * shells + n);
    }
  }
}

constexpr double FactorOf(int l)
{
  return (2.0 * l + 1.0) / (16.0 * Pi * Pi);
}
}

ShellMultipoles::ShellMultipoles(const ShellSettings& settings)
  : Settings(settings)
  , Shells((static_cast<int>(settings.Distances.size()) + NumberOfLanes - 1) / NumberOfLanes *
      NumberOfLanes)
  , Harmonics(2 * HarmonicCount(settings.Degree))
  , Padded(settings.Distances)
{
  this->Padded.resize(this->Shells, settings.Distances.back());
}

std::size_t ShellMultipoles::PlaceOfHarmonic(int s, int harmonic) const
{
  return (std::size_t(s) * this->Harmonics + harmonic) * this->Shells;
}

std::size_t ShellMultipoles::Size() const
{
  return this->PlaceOfHarmonic(this->Settings.Classes, 0);
}

void ShellMultipoles::Sum(double radius, const std::vector<Neighbour>& around, double* sums) const
{
  std::fill(sums, sums + this->Size(), 0.0);
  const Surround shells = { radius, this->Padded.data(), this->Shells, this->Settings.Degree,
    this->PlaceOfHarmonic(1, 0) };
  for (std::size_t n = 0; n < around.size(); n += NumberOfLanes)
  {
    const int count = static_cast<int>(std::min<std::size_t>(NumberOfLanes, around.size() - n));
    AddCaps({ &around[n], count }, shells, sums);
  }
}

void ShellMultipoles::FindForces(
  double radius, const std::vector<Neighbour>& around, const double* lambda, double* forces) const
{
  const Surround shells = { radius, this->Padded.data(), this->Shells, this->Settings.Degree,
    this->PlaceOfHarmonic(1, 0) };
  for (std::size_t n = 0; n < around.size(); n += NumberOfLanes)
  {
    double pulls[4 * NumberOfLanes];
    const int count = static_cast<int>(std::min<std::size_t>(NumberOfLanes, around.size() - n));
    FindPulls({ &around[n], count }, shells, lambda, pulls);
    for (int j = 0; j < count; ++j)
    {
      const double* const pull = &pulls[4 * j];
      const Vector3 across = { pull[1], pull[2], pull[3] }, &u = around[n + j].Direction;
      const double along = Dot(across, u);
      for (int axis = 0; axis < 3; ++axis)
      {
        *forces++ = pull[0] * u[axis] + (across[axis] - along * u[axis]) / around[n + j].Distance;
      }
    }
  }
}

void ShellMultipoles::FindProducts(const double* sums, double* products) const
{
  const int shells = static_cast<int>(this->Settings.Distances.size());
  AlignedNumbers table(std::size_t(this->Shells) * this->Shells);
  for (int s = 0; s < this->Settings.Classes; ++s)
  {
    for (int q = s; q < this->Settings.Classes; ++q)
    {
      for (int l = 0; l <= this->Settings.Degree; ++l)
      {
        const int first = 2 * HarmonicPlace(l, 0), count = 2 * (l + 1);
        FindTable(sums + this->PlaceOfHarmonic(s, first), sums + this->PlaceOfHarmonic(q, first),
          count, shells, this->Shells, table.data());
        for (int n1 = 0; n1 < shells; ++n1, products += shells)
        {
          Scale(&table[std::size_t(n1) * this->Shells], FactorOf(l), shells, products);
        }
      }
    }
  }
}

std::size_t ShellMultipoles::PlaceOfFactor(int s, int q, int l, int n2) const
{
  const std::size_t pair = std::size_t(s) * this->Settings.Classes + q;
  return ((pair * (this->Settings.Degree + 1) + l) * this->Settings.Distances.size() + n2) *
    this->Shells;
}

AlignedNumbers ShellMultipoles::MakeFactors(const double* mu) const
{
  const int classes = this->Settings.Classes, degree = this->Settings.Degree;
  const int shells = static_cast<int>(this->Settings.Distances.size());
  AlignedNumbers factors(this->PlaceOfFactor(classes, 0, 0, 0), 0.0);
  for (int s = 0; s < classes; ++s)
  {
    for (int q = s; q < classes; ++q)
    {
      for (int l = 0; l <= degree; ++l)
      {
        for (int n1 = 0; n1 < shells; ++n1)
        {
          for (int n2 = 0; n2 < shells; ++n2)
          {
            const double factor = FactorOf(l) * mu[this->Settings.PlaceOf(s, q, l, n1, n2)];
            factors[this->PlaceOfFactor(s, q, l, n2) + n1] += factor;
            factors[this->PlaceOfFactor(q, s, l, n1) + n2] += factor;
          }
        }
      }
    }
  }
  return factors;
}

void ShellMultipoles::FindGradient(const double* sums, const double* factors, double* lambda) const
{
  std::fill(lambda, lambda + this->Size(), 0.0);
  const int shells = static_cast<int>(this->Settings.Distances.size());
  for (int s = 0; s < this->Settings.Classes; ++s)
  {
    for (int l = 0; l <= this->Settings.Degree; ++l)
    {
      const int first = 2 * HarmonicPlace(l, 0), count = 2 * (l + 1);
      for (int q = 0; q < this->Settings.Classes; ++q)
      {
        AddRows(sums + this->PlaceOfHarmonic(q, first), factors + this->PlaceOfFactor(s, q, l, 0),
          count, shells, this->Shells, lambda + this->PlaceOfHarmonic(s, first));
      }
    }
  }
}
}
