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

// Y_lm in a direction, and their gradients but for the part along it
struct DirectionHarmonics
{
  DirectionHarmonics(const Vector3& u, int degree, bool withGradients);

  double Y[MostHarmonics];
  double Along[3][MostHarmonics];
};

// For the gradients see Turn in LocalForces.cxx
DirectionHarmonics::DirectionHarmonics(const Vector3& u, int degree, bool withGradients)
{
  double real[HarmonicCount(GreatestDegree)], imaginary[HarmonicCount(GreatestDegree)];
  FindHarmonics<double>(degree + (withGradients ? 1 : 0), u[0], u[1], u[2], 1.0, real, imaginary);
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
      const double before = m > 0 ? real[down] : -real[up];
      const double imaginaryBefore = m > 0 ? imaginary[down] : imaginary[up];
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

// The two loops over shells and harmonics. `sums` and `lambda` begin with the neighbour's class.
RUC_VECTOR_CLONES
void AddCaps(const ShellMultipoles::Neighbour& neighbour, double radius, const double* distances,
  int shells, int degree, const double* y, double* sums)
{
  for (int n = 0; n < shells; n += NumberOfLanes)
  {
    if (neighbour.Distance - neighbour.Radius >= radius + distances[n + NumberOfLanes - 1])
    {
      continue; // it reaches none of these shells
    }
    Lanes block;
    Load(distances + n, block);
    const Caps caps(block, radius, neighbour, degree);
    for (int l = 0; l <= degree; ++l)
    {
      for (int k = 2 * HarmonicPlace(l, 0); k < 2 * HarmonicPlace(l + 1, 0); ++k)
      {
        Lanes sum;
        Load(sums + k * shells + n, sum);
        sum += (caps.Of[l] * y[k] + Rounder) - Rounder;
        Store(sum, sums + k * shells + n);
      }
    }
  }
}

// Along the neighbour's direction, and along x, y and z
RUC_VECTOR_CLONES
void FindPull(const ShellMultipoles::Neighbour& neighbour, double radius, const double* distances,
  int shells, int degree, const DirectionHarmonics& harmonics, const double* lambda, double* pull)
{
  Lanes away = {}, across[3] = {};
  for (int n = 0; n < shells; n += NumberOfLanes)
  {
    if (neighbour.Distance - neighbour.Radius >= radius + distances[n + NumberOfLanes - 1])
    {
      continue; // it reaches none of these shells
    }
    Lanes block;
    Load(distances + n, block);
    const Caps caps(block, radius, neighbour, degree);
    for (int l = 0; l <= degree; ++l)
    {
      Lanes value = {}, turned[3] = {};
      for (int k = 2 * HarmonicPlace(l, 0); k < 2 * HarmonicPlace(l + 1, 0); ++k)
      {
        Lanes factor;
        Load(lambda + k * shells + n, factor);
        value += factor * harmonics.Y[k];
        turned[0] += factor * harmonics.Along[0][k];
        turned[1] += factor * harmonics.Along[1][k];
        turned[2] += factor * harmonics.Along[2][k];
      }
      away += value * caps.Legendre[l] * caps.Slope;
      for (int axis = 0; axis < 3; ++axis)
      {
        across[axis] += turned[axis] * caps.Of[l];
      }
    }
  }
  pull[0] = -2.0 * Pi * Sum(away); // dC_l/dx = -2 pi P_l
  for (int axis = 0; axis < 3; ++axis)
  {
    pull[1 + axis] = Sum(across[axis]);
  }
}

// Adds f times the products of two rows of numbers to a table of them
RUC_VECTOR_CLONES
void AddProducts(const double* a, const double* b, int rows, int shells, double* table)
{
  for (int row = 0; row < rows; ++row)
  {
    const double factor = a[row];
    for (int n = 0; n < shells; n += NumberOfLanes)
    {
      Lanes sum, other;
      Load(table + row * shells + n, sum);
      Load(b + n, other);
      sum += factor * other;
      Store(sum, table + row * shells + n);
    }
  }
}

// Adds to a row the rows of a table, each times a number
RUC_VECTOR_CLONES
void AddRows(const double* numbers, const double* table, int rows, int shells, double* sums)
{
  for (int n = 0; n < shells; n += NumberOfLanes)
  {
    Lanes sum;
    Load(sums + n, sum);
    for (int row = 0; row < rows; ++row)
    {
      Lanes other;
      Load(table + row * shells + n, other);
      sum += numbers[row] * other;
    }
    Store(sum, sums + n);
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
  for (const Neighbour& neighbour : around)
  {
    if (neighbour.Distance - neighbour.Radius < radius + this->Padded.back())
    {
      const DirectionHarmonics harmonics(neighbour.Direction, this->Settings.Degree, false);
      AddCaps(neighbour, radius, this->Padded.data(), this->Shells, this->Settings.Degree,
        harmonics.Y, sums + this->PlaceOfHarmonic(neighbour.Class, 0));
    }
  }
}

void ShellMultipoles::FindForces(
  double radius, const std::vector<Neighbour>& around, const double* lambda, double* forces) const
{
  for (const Neighbour& neighbour : around)
  {
    double pull[4] = { 0.0, 0.0, 0.0, 0.0 };
    if (neighbour.Distance - neighbour.Radius < radius + this->Padded.back())
    {
      const DirectionHarmonics harmonics(neighbour.Direction, this->Settings.Degree, true);
      FindPull(neighbour, radius, this->Padded.data(), this->Shells, this->Settings.Degree,
        harmonics, lambda + this->PlaceOfHarmonic(neighbour.Class, 0), pull);
    }
    const Vector3 across = { pull[1], pull[2], pull[3] }, &u = neighbour.Direction;
    const double along = Dot(across, u);
    for (int axis = 0; axis < 3; ++axis)
    {
      *forces++ = pull[0] * u[axis] + (across[axis] - along * u[axis]) / neighbour.Distance;
    }
  }
}

void ShellMultipoles::FindProducts(const double* sums, double* products) const
{
  const int shells = static_cast<int>(this->Settings.Distances.size());
  std::vector<double> table(std::size_t(shells) * this->Shells);
  for (int s = 0; s < this->Settings.Classes; ++s)
  {
    for (int q = s; q < this->Settings.Classes; ++q)
    {
      for (int l = 0; l <= this->Settings.Degree; ++l)
      {
        std::fill(table.begin(), table.end(), 0.0);
        for (int k = 2 * HarmonicPlace(l, 0); k < 2 * HarmonicPlace(l + 1, 0); ++k)
        {
          AddProducts(sums + this->PlaceOfHarmonic(s, k), sums + this->PlaceOfHarmonic(q, k),
            shells, this->Shells, table.data());
        }
        for (int n1 = 0; n1 < shells; ++n1)
        {
          for (int n2 = 0; n2 < shells; ++n2)
          {
            *products++ = FactorOf(l) * table[std::size_t(n1) * this->Shells + n2];
          }
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

std::vector<double> ShellMultipoles::MakeFactors(const double* mu) const
{
  const int classes = this->Settings.Classes, degree = this->Settings.Degree;
  const int shells = static_cast<int>(this->Settings.Distances.size());
  std::vector<double> factors(this->PlaceOfFactor(classes, 0, 0, 0), 0.0);
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
      for (int k = 2 * HarmonicPlace(l, 0); k < 2 * HarmonicPlace(l + 1, 0); ++k)
      {
        for (int q = 0; q < this->Settings.Classes; ++q)
        {
          AddRows(sums + this->PlaceOfHarmonic(q, k), factors + this->PlaceOfFactor(s, q, l, 0),
            shells, this->Shells, lambda + this->PlaceOfHarmonic(s, k));
        }
      }
    }
  }
}
}
