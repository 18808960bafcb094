// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/ThirdOrder/LocalMultipoles.h"

#include "ruc/Base/FixedPoint.h"
#include "ruc/Base/Vector3.h"
#include "ruc/Base/VectorClones.h"
#include "ruc/Statistics/ThirdOrder/LaneFactors.h"

#include <algorithm>
#include <cmath>

namespace ruc
{
namespace
{
constexpr int Steps = 2048; // of the table of Ewald's factors
constexpr int UnitBits = -38;
}

LocalMultipoles::Neighbours::Neighbours(const MultipoleSettings& settings)
  : Near2(settings.NearCutOff() * settings.NearCutOff())
  , Near(settings.Sources)
  , Far(settings.Sources)
{
}

void LocalMultipoles::Neighbours::Start(double radius)
{
  this->Count = 0;
  this->Inverse = 1.0 / radius;
  for (std::vector<List>* lists : { &this->Near, &this->Far })
  {
    for (List& list : *lists)
    {
      list.X.clear();
      list.Y.clear();
      list.Z.clear();
      list.Radius.clear();
      list.Order.clear();
    }
  }
}

void LocalMultipoles::Neighbours::Add(
  double dx, double dy, double dz, double d2, double radius, int source)
{
  List& list = (d2 < this->Near2 ? this->Near : this->Far)[source];
  list.X.push_back(dx * this->Inverse);
  list.Y.push_back(dy * this->Inverse);
  list.Z.push_back(dz * this->Inverse);
  list.Radius.push_back(radius * this->Inverse);
  list.Order.push_back(this->Count++);
}

// What the sums of one centre and one source need
struct LocalMultipoles::Kernel
{
  int Degree;
  bool WithFourth;
  double CutOff, NearCutOff; // in radii of the centre
  const Knot* Factors;       // null without Ewald's sum
  const double* Rounders;
  Lanes* Sums; // of q and, from Fourth on, of A
  std::size_t Fourth;

  void Add(const Neighbours::List& list, int degree);
  [[gnu::always_inline]] inline void AddLanes(
    const Lanes& x, const Lanes& y, const Lanes& z, const Lanes& radius, int degree);
  [[gnu::always_inline]] inline void FindFactors(
    const Lanes& ratio, Lanes& second, Lanes& fourth) const;
  [[gnu::always_inline]] inline void Accumulate(
    int l, const Lanes& weight, const Lanes* real, const Lanes* imaginary, Lanes* sums) const;
};

// Ewald's factors of q_2m and of the second term of A_4m, by cubic Hermite interpolation
inline void LocalMultipoles::Kernel::FindFactors(
  const Lanes& ratio, Lanes& second, Lanes& fourth) const
{
  const Lanes place = ratio * ratio * Steps;
  for (int k = 0; k < NumberOfLanes; ++k)
  {
    const int step = std::min(static_cast<int>(place[k]), Steps - 1);
    const double t = place[k] - step;
    const Knot &low = this->Factors[step], &high = this->Factors[step + 1];
    const double up = t * t * (3.0 - 2.0 * t), down = 1.0 - up;
    const double lowSlope = t * (1.0 - t) * (1.0 - t), highSlope = -t * t * (1.0 - t);
    second[k] = (down * low[0] + up * high[0]) + (lowSlope * low[1] + highSlope * high[1]);
    fourth[k] = (down * low[2] + up * high[2]) + (lowSlope * low[3] + highSlope * high[3]);
  }
}

// Adds terms of a degree, each rounded by adding and subtracting a large number
inline void LocalMultipoles::Kernel::Accumulate(
  int l, const Lanes& weight, const Lanes* real, const Lanes* imaginary, Lanes* sums) const
{
  for (int n = HarmonicPlace(l, 0); n <= HarmonicPlace(l, l); ++n)
  {
    const Lanes rounder = Lanes{} + this->Rounders[n];
    sums[2 * n] += (weight * real[n] + rounder) - rounder;
    sums[2 * n + 1] += (weight * imaginary[n] + rounder) - rounder;
  }
}

inline void LocalMultipoles::Kernel::AddLanes(
  const Lanes& x, const Lanes& y, const Lanes& z, const Lanes& radius, int degree)
{
  const Lanes square = x * x + y * y + z * z;
  Lanes r;
  for (int k = 0; k < NumberOfLanes; ++k)
  {
    r[k] = std::sqrt(square[k]);
  }
  Lanes real[HarmonicCount(GreatestDegree)], imaginary[HarmonicCount(GreatestDegree)];
  FindHarmonics<Lanes>(degree, x, y, z, 1.0 / r, real, imaginary);
  Lanes low, high;
  FindSmoothEnd(r * (1.0 / this->CutOff), low);
  FindSmoothEnd(r * (1.0 / this->NearCutOff), high);
  Lanes second = low, fourth = low;
  if (this->Factors)
  {
    this->FindFactors(r * (1.0 / this->CutOff), second, fourth);
  }
  const Lanes cube = radius * radius * radius, fifth = cube * radius * radius * 0.2;
  const Lanes moment = cube * square;
  for (int l = LowestDegree; l <= degree; ++l)
  {
    const Lanes& factor = l == 2 ? second : l <= HighestOfFar ? low : high;
    this->Accumulate(l, cube * factor, real, imaginary, this->Sums);
    if (this->WithFourth && l >= 4)
    {
      const Lanes weight =
        fifth * factor - moment * (l == 4 ? fourth : factor) * (1.0 / (2.0 * l - 1.0));
      this->Accumulate(l, weight, real, imaginary, this->Sums + this->Fourth);
    }
  }
}

RUC_VECTOR_CLONES
void LocalMultipoles::Kernel::Add(const Neighbours::List& list, int degree)
{
  const std::size_t size = list.X.size();
  for (std::size_t from = 0; from < size; from += NumberOfLanes)
  {
    Lanes x, y, z, radius;
    LoadLanes(list, from, x, y, z, radius);
    this->AddLanes(x, y, z, radius, degree);
  }
}

LocalMultipoles::LocalMultipoles(const MultipoleSettings& settings)
  : Settings(settings)
{
  for (int l = 0; l <= settings.Degree; ++l)
  {
    for (int m = 0; m <= l; ++m)
    {
      const int exponent = std::ilogb(1.0 / std::sqrt(HarmonicWeight(l, m)));
      this->Rounders.push_back(std::ldexp(FixedPointRounder, UnitBits + exponent));
    }
  }
  if (settings.Alpha == 0.0)
  {
    return;
  }
  // With y = alpha r and B_n r^(2n+1) = b_n: b_0 = erfc y, b_n = (2n - 1) b_(n-1) + (2 y^2)^n
  // e^(-y^2) / (y sqrt pi). The factors are b_2 / 3 and b_3 / 15.
  const double x = settings.Alpha * settings.CutOff;
  for (int n = 0; n <= Steps; ++n)
  {
    const double y = x * std::sqrt(double(n) / Steps), y2 = y * y;
    const double e = std::exp(-y2) / std::sqrt(Pi);
    const double b2 = 3.0 * (std::erfc(y) + 2.0 * y * e) + 4.0 * y2 * y * e;
    const double b3 = 5.0 * b2 + 8.0 * y2 * y2 * y * e;
    this->Factors.push_back({ b2 / 3.0, -4.0 / 3.0 * x * x * y2 * y * e / Steps, b3 / 15.0,
      -8.0 / 15.0 * x * x * y2 * y2 * y * e / Steps });
  }
}

void LocalMultipoles::Sum(const Neighbours& around, double* sums) const
{
  const std::size_t kinds = this->SizeOfSource();
  Lanes lanes[4 * HarmonicCount(GreatestDegree)];
  Kernel kernel = { this->Settings.Degree, this->Settings.WithFourth,
    this->Settings.CutOff * around.Inverse, this->Settings.NearCutOff() * around.Inverse,
    this->Factors.empty() ? nullptr : this->Factors.data(), this->Rounders.data(), lanes,
    this->Count() };
  for (int source = 0; source < this->Settings.Sources; ++source)
  {
    std::fill(lanes, lanes + kinds, Lanes{});
    kernel.Add(around.Near[source], this->Settings.Degree);
    kernel.Add(around.Far[source], std::min(HighestOfFar, this->Settings.Degree));
    for (std::size_t n = 0; n < kinds; ++n)
    {
      double sum = 0.0;
      for (int k = 0; k < NumberOfLanes; ++k)
      {
        sum += lanes[n][k];
      }
      sums[source * kinds + n] = sum;
    }
  }
}
}
