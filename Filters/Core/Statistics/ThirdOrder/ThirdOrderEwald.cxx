// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/ThirdOrder/ThirdOrderEwald.h"

#include "ruc/Base/FixedPoint.h"
#include "ruc/Base/VectorClones.h"
#include "ruc/Statistics/ThirdOrder/LaneFactors.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ruc
{
namespace
{
constexpr int Width = ThirdOrderEwald::Block;
static_assert(Width == NumberOfLanes);

double Cube(double a)
{
  return a * a * a;
}

// The cubes of the radii of a block; lanes without a sphere have 0
std::array<double, Width> CubesOf(const PackShare& share, const std::size_t* block, int count)
{
  std::array<double, Width> cubes{};
  for (int lane = 0; lane < count; ++lane)
  {
    cubes[lane] = Cube(share.Own.Radius[block[lane]]);
  }
  return cubes;
}

struct Complex
{
  Lanes Real, Imaginary;

  // Always inlined, so that it is compiled for the caller's instruction set
  [[gnu::always_inline]] inline Complex Times(const Complex& other) const
  {
    return { this->Real * other.Real - this->Imaginary * other.Imaginary,
      this->Real * other.Imaginary + this->Imaginary * other.Real };
  }
};

// e^(i k x) of a block of spheres for all numbers of waves along the edges, from -most to most
class Tables
{
public:
  Tables(
    const PackShare& share, const std::size_t* spheres, int count, const std::array<int, 3>& most)
    : Most(most)
  {
    const SpherePack& pack = share.Own;
    const std::vector<double>* coordinates[3] = { &pack.X, &pack.Y, &pack.Z };
    for (int axis = 0; axis < 3; ++axis)
    {
      std::vector<Complex>& table = this->Of[axis];
      table.resize(2 * most[axis] + 1);
      for (int lane = 0; lane < Width; ++lane)
      {
        const double x = (*coordinates[axis])[spheres[std::min(lane, count - 1)]];
        const double angle =
          2.0 * Pi * (x - share.Observed.Origin[axis]) / share.Observed.Size[axis];
        for (int n = 0; n <= most[axis]; ++n)
        {
          Complex &up = table[most[axis] + n], &down = table[most[axis] - n];
          up.Real[lane] = down.Real[lane] = std::cos(n * angle);
          up.Imaginary[lane] = std::sin(n * angle);
          down.Imaginary[lane] = -up.Imaginary[lane];
        }
      }
    }
  }
  [[gnu::always_inline]] inline const Complex& At(int axis, int n) const
  {
    return this->Of[axis][this->Most[axis] + n];
  }

private:
  std::array<int, 3> Most;
  std::vector<Complex> Of[3];
};

// Calls visit(n, e) for every wave n with e^(i k x) of the block
template <class Visit>
[[gnu::always_inline]] inline void ForEachWave(
  const std::vector<ThirdOrderEwald::Row>& rows, const Tables& tables, Visit&& visit)
{
  for (const ThirdOrderEwald::Row& row : rows)
  {
    const Complex xy = tables.At(0, row.Places[0]).Times(tables.At(1, row.Places[1]));
    for (std::size_t n = row.Begin; n < row.End; ++n)
    {
      visit(n, xy.Times(tables.At(2, row.Places[2] + static_cast<int>(n - row.Begin))));
    }
  }
}

// Adds a^3 e^(i k x) of a block to the sums of all waves, each term rounded
RUC_VECTOR_CLONES
void AddStructure(const std::vector<ThirdOrderEwald::Row>& rows, const Tables& tables,
  const double* cubes, double rounding, Complex* sums)
{
  Lanes cube;
  std::copy(cubes, cubes + Width, reinterpret_cast<double*>(&cube));
  const Lanes rounder = Lanes{} + rounding;
  ForEachWave(
    rows, tables, [&](std::size_t n, const Complex& e) __attribute__((always_inline)) {
      sums[n].Real += (cube * e.Real + rounder) - rounder;
      sums[n].Imaginary += (cube * e.Imaginary + rounder) - rounder;
    });
}

// Adds the far part of one source
RUC_VECTOR_CLONES
void AddFar(const std::vector<ThirdOrderEwald::Row>& rows, const ThirdOrderEwald::Wave* waves,
  const double* structure, const Tables& tables, bool withFourth, Lanes* second, Lanes* fourth)
{
  ForEachWave(
    rows, tables, [&](std::size_t n, const Complex& e) __attribute__((always_inline)) {
      const Lanes part = e.Real * structure[2 * n] + e.Imaginary * structure[2 * n + 1];
      for (int m = 0; m < 5; ++m)
      {
        second[m] += waves[n].Second[m] * part;
      }
      if (withFourth)
      {
        for (int m = 0; m < 9; ++m)
        {
          fourth[m] += waves[n].Fourth[m] * part;
        }
      }
    });
}

// lambda of q_2m of a block for one source
struct Lambdas
{
  Lanes Of[5];
};

// sum over m of lambda_m times the factor of a wave
[[gnu::always_inline]] inline void FindTurned(
  const ThirdOrderEwald::Wave& wave, const Lambdas& lambda, Lanes& turned)
{
  turned = lambda.Of[0] * wave.Second[0];
  for (int m = 1; m < 5; ++m)
  {
    turned += lambda.Of[m] * wave.Second[m];
  }
}

// Adds lambda e^(i k x) of a block to the sums of all waves, each term rounded
RUC_VECTOR_CLONES
void AddTurned(const std::vector<ThirdOrderEwald::Row>& rows, const ThirdOrderEwald::Wave* waves,
  const Tables& tables, const Lambdas& lambda, double rounding, Complex* sums)
{
  const Lanes rounder = Lanes{} + rounding;
  ForEachWave(
    rows, tables, [&](std::size_t n, const Complex& e) __attribute__((always_inline)) {
      Lanes turned;
      FindTurned(waves[n], lambda, turned);
      sums[n].Real += (turned * e.Real + rounder) - rounder;
      sums[n].Imaginary += (turned * e.Imaginary + rounder) - rounder;
    });
}

// Adds the forces on a block through its own phases e^(-i k x), as centres of one source
RUC_VECTOR_CLONES
void AddForcesOnCentres(const std::vector<ThirdOrderEwald::Row>& rows,
  const ThirdOrderEwald::Wave* waves, const Tables& tables, const Lambdas& lambda,
  const double* structure, Lanes* forces)
{
  ForEachWave(
    rows, tables, [&](std::size_t n, const Complex& e) __attribute__((always_inline)) {
      Lanes turned;
      FindTurned(waves[n], lambda, turned);
      turned *= e.Real * structure[2 * n + 1] - e.Imaginary * structure[2 * n];
      for (int axis = 0; axis < 3; ++axis)
      {
        forces[axis] += turned * waves[n].K[axis];
      }
    });
}

// Adds the forces on a block through its part in S(k); `turned` are the sums of AddTurned
RUC_VECTOR_CLONES
void AddForcesOnSources(const std::vector<ThirdOrderEwald::Row>& rows,
  const ThirdOrderEwald::Wave* waves, const Tables& tables, const double* cubes,
  const double* turned, Lanes* forces)
{
  Lanes cube;
  std::copy(cubes, cubes + Width, reinterpret_cast<double*>(&cube));
  ForEachWave(
    rows, tables, [&](std::size_t n, const Complex& e) __attribute__((always_inline)) {
      const Lanes force = cube * (e.Real * turned[2 * n + 1] - e.Imaginary * turned[2 * n]);
      for (int axis = 0; axis < 3; ++axis)
      {
        forces[axis] += force * waves[n].K[axis];
      }
    });
}
}

ThirdOrderEwald::ThirdOrderEwald(const PackShare& share, const std::vector<int>& source,
  const MultipoleSettings& settings, Communicator& ranks)
  : Share(share)
  , Sources(settings.Sources)
  , Spheres(settings.Sources)
  , WithFourth(settings.WithFourth)
{
  for (std::size_t i = 0; i < source.size(); ++i)
  {
    this->Spheres[source[i]].push_back(i);
  }
  this->FindWaves(settings);
  const double cubes =
    std::accumulate(share.Volume.begin(), share.Volume.end(), 0.0) * 3.0 / (4.0 * Pi);
  this->Structure = this->SumWaves(this->Spheres, std::ilogb(cubes) + 1 - 50, ranks,
    [&](int, const std::size_t* block, int count, const auto& tables, double rounding, auto* sums)
    { AddStructure(this->Rows, tables, CubesOf(share, block, count).data(), rounding, sums); });
}

double ThirdOrderEwald::NumberOfWaves(const Window& box, const MultipoleSettings& settings)
{
  const double most = 2.0 * settings.Alpha * settings.Alpha * settings.CutOff;
  return 0.5 * 4.0 / 3.0 * Pi * most * most * most * box.Volume() / std::pow(2.0 * Pi, 3);
}

void ThirdOrderEwald::FindWaves(const MultipoleSettings& settings)
{
  const double most = 2.0 * settings.Alpha * settings.Alpha * settings.CutOff;
  Vector3 unit;
  for (int axis = 0; axis < 3; ++axis)
  {
    unit[axis] = 2.0 * Pi / this->Share.Observed.Size[axis];
    this->Most[axis] = static_cast<int>(most / unit[axis]);
  }
  for (int u = 0; u <= this->Most[0]; ++u)
  {
    for (int v = u > 0 ? -this->Most[1] : 0; v <= this->Most[1]; ++v)
    {
      const std::size_t begin = this->Waves.size();
      int first = 0;
      for (int w = u > 0 || v > 0 ? -this->Most[2] : 1; w <= this->Most[2]; ++w)
      {
        const Vector3 k = { u * unit[0], v * unit[1], w * unit[2] };
        const double k2 = Dot(k, k);
        if (k2 <= most * most)
        {
          first = this->Waves.size() == begin ? w : first;
          this->AddWave(k, k2, settings.Alpha);
        }
      }
      if (this->Waves.size() > begin)
      {
        this->Rows.push_back({ { u, v, first }, begin, this->Waves.size() });
      }
    }
  }
}

void ThirdOrderEwald::AddWave(const Vector3& k, double k2, double alpha)
{
  double real[HarmonicCount(4)], imaginary[HarmonicCount(4)];
  const double length = std::sqrt(k2);
  FindHarmonics<double>(4, k[0] / length, k[1] / length, k[2] / length, 1.0, real, imaginary);
  const double x = k2 / (4.0 * alpha * alpha), volume = this->Share.Observed.Volume();
  // Twice, for the wave -k is left out
  const double second = -8.0 * Pi / (3.0 * volume) * std::exp(-x);
  const double fourth = -16.0 * Pi / (105.0 * volume) * std::exp(-x) * (1.0 + x);
  const auto part = [&](int degree, int n)
  {
    const double* const parts = n % 2 == 0 && n > 0 ? imaginary : real;
    return parts[HarmonicPlace(degree, (n + 1) / 2)];
  };
  Wave& wave = this->Waves.emplace_back();
  wave.K = k;
  for (int n = 0; n < 5; ++n)
  {
    wave.Second[n] = second * part(2, n);
  }
  for (int n = 0; n < 9; ++n)
  {
    wave.Fourth[n] = fourth * part(4, n);
  }
}

template <class AddBlock>
std::vector<double> ThirdOrderEwald::SumWaves(const std::vector<std::vector<std::size_t>>& spheres,
  int unit, Communicator& ranks, AddBlock&& add) const
{
  const std::size_t waves = this->Waves.size();
  std::vector<std::int64_t> sums(2 * waves * this->Sources, 0);
  for (int s = 0; s < this->Sources; ++s)
  {
    const std::int64_t blocks = (spheres[s].size() + Block - 1) / Block;
#pragma omp parallel
    {
      std::vector<Complex> own(waves, Complex{});
#pragma omp for schedule(dynamic) nowait
      for (std::int64_t b = 0; b < blocks; ++b)
      {
        const std::size_t* block = &spheres[s][b * Block];
        const int count =
          static_cast<int>(std::min<std::size_t>(Block, spheres[s].size() - b * Block));
        add(s, block, count, Tables(this->Share, block, count, this->Most),
          std::ldexp(FixedPointRounder, unit), own.data());
      }
#pragma omp critical
      for (std::size_t n = 0; n < waves; ++n)
      {
        for (int lane = 0; lane < Block; ++lane)
        {
          std::int64_t* sum = &sums[2 * (s * waves + n)];
          sum[0] += static_cast<std::int64_t>(std::ldexp(own[n].Real[lane], -unit));
          sum[1] += static_cast<std::int64_t>(std::ldexp(own[n].Imaginary[lane], -unit));
        }
      }
    }
  }
  ranks.Sum(sums.data(), sums.size());
  std::vector<double> values(sums.size());
  std::transform(sums.begin(), sums.end(), values.begin(),
    [&](std::int64_t sum) { return std::ldexp(static_cast<double>(sum), unit); });
  return values;
}

void ThirdOrderEwald::Add(
  const std::size_t* centres, int count, const LocalMultipoles& multipoles, double* sums) const
{
  const Tables tables(this->Share, centres, count, this->Most);
  for (int s = 0; s < this->Sources; ++s)
  {
    Lanes second[5] = {}, fourth[9] = {};
    AddFar(this->Rows, this->Waves.data(), &this->Structure[2 * s * this->Waves.size()], tables,
      this->WithFourth, second, fourth);
    for (int lane = 0; lane < count; ++lane)
    {
      double* own = sums + lane * multipoles.Size() + s * multipoles.SizeOfSource();
      const auto add = [&](int degree, const Lanes* far, double* to)
      {
        // The imaginary part of m = 0 has no number
        to[2 * HarmonicPlace(degree, 0)] += far[0][lane];
        for (int n = 1; n <= 2 * degree; ++n)
        {
          to[2 * HarmonicPlace(degree, 0) + n + 1] += far[n][lane];
        }
      };
      add(2, second, own);
      if (this->WithFourth)
      {
        add(4, fourth, own + multipoles.Count());
      }
    }
  }
}

void ThirdOrderEwald::AddForces(const std::vector<double>& lambda,
  const LocalMultipoles& multipoles, std::vector<double>& forces, Communicator& ranks) const
{
  const auto find = [&](int s, const std::size_t* block, int count)
  {
    Lambdas of = {};
    for (int lane = 0; lane < count; ++lane)
    {
      const double* own = &lambda[block[lane] * multipoles.Size() + s * multipoles.SizeOfSource()] +
        2 * HarmonicPlace(2, 0);
      for (int n = 0; n < 5; ++n)
      {
        // The imaginary part of m = 0 has no number
        of.Of[n][lane] = own[n > 0 ? n + 1 : 0];
      }
    }
    return of;
  };
  // No sum is larger than that of all spheres
  double largest = 0.0, factor = 0.0;
  for (double value : lambda)
  {
    largest = std::max(largest, std::abs(value));
  }
  for (const Wave& wave : this->Waves)
  {
    for (double value : wave.Second)
    {
      factor = std::max(factor, std::abs(value));
    }
  }
  largest = -largest;
  ranks.Minimum(&largest, 1);
  const double most = -largest * factor * 5.0 * static_cast<double>(this->Share.NumberOfSpheres);
  if (most == 0.0)
  {
    return;
  }
  std::vector<std::size_t> all(this->Share.Own.Size());
  std::iota(all.begin(), all.end(), 0);
  const std::vector<double> turned = this->SumWaves(
    std::vector<std::vector<std::size_t>>(this->Sources, all), std::ilogb(most) + 1 - 50, ranks,
    [&](int s, const std::size_t* block, int count, const auto& tables, double rounding, auto* sums)
    { AddTurned(this->Rows, this->Waves.data(), tables, find(s, block, count), rounding, sums); });
  for (int own = 0; own < this->Sources; ++own)
  {
    const std::vector<std::size_t>& spheres = this->Spheres[own];
    const std::int64_t blocks = (spheres.size() + Block - 1) / Block;
#pragma omp parallel for schedule(dynamic)
    for (std::int64_t b = 0; b < blocks; ++b)
    {
      const std::size_t* block = &spheres[b * Block];
      const int count = static_cast<int>(std::min<std::size_t>(Block, spheres.size() - b * Block));
      const Tables tables(this->Share, block, count, this->Most);
      Lanes found[3] = {};
      for (int s = 0; s < this->Sources; ++s)
      {
        AddForcesOnCentres(this->Rows, this->Waves.data(), tables, find(s, block, count),
          &this->Structure[2 * s * this->Waves.size()], found);
      }
      AddForcesOnSources(this->Rows, this->Waves.data(), tables,
        CubesOf(this->Share, block, count).data(), &turned[2 * own * this->Waves.size()], found);
      for (int lane = 0; lane < count; ++lane)
      {
        for (int axis = 0; axis < 3; ++axis)
        {
          forces[3 * block[lane] + axis] += found[axis][lane];
        }
      }
    }
  }
}
}
