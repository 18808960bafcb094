// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Images/LineTransform.h"

#include "ruc/Base/Require.h"
#include "ruc/Base/Vector3.h"
#include "ruc/Base/VectorClones.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace ruc
{
namespace
{
constexpr int Lanes = LineTransform::Lanes;
constexpr int LargestFactor = 13;

// Numbers of all lanes in a row, apart in real and imaginary parts
struct Source
{
  const double* Real;
  const double* Imaginary;
};
struct Target
{
  double* Real;
  double* Imaginary;
};

// The butterflies must become part of the function that is compiled for several instruction sets
#define RUC_INLINE inline __attribute__((always_inline))

// Writes one number, turned by a twiddle factor
RUC_INLINE void Store(
  const Target& to, std::ptrdiff_t place, double real, double imaginary, double cosine, double sine)
{
  to.Real[place] = real * cosine - imaginary * sine;
  to.Imaginary[place] = real * sine + imaginary * cosine;
}

RUC_INLINE void Butterfly2(const Source& from, std::ptrdiff_t in, const Target& to,
  std::ptrdiff_t out, const double* cosine, const double* sine)
{
  for (int l = 0; l < Lanes; ++l)
  {
    const double a = from.Real[l], b = from.Imaginary[l];
    const double c = from.Real[in + l], d = from.Imaginary[in + l];
    to.Real[l] = a + c;
    to.Imaginary[l] = b + d;
    Store(to, out + l, a - c, b - d, cosine[1], sine[1]);
  }
}

RUC_INLINE void Butterfly3(const Source& from, std::ptrdiff_t in, const Target& to,
  std::ptrdiff_t out, const double* cosine, const double* sine)
{
  const double half = 0.5 * std::sqrt(3.0);
  for (int l = 0; l < Lanes; ++l)
  {
    const double a = from.Real[l], b = from.Imaginary[l];
    const double c = from.Real[in + l], d = from.Imaginary[in + l];
    const double e = from.Real[2 * in + l], f = from.Imaginary[2 * in + l];
    const double sumReal = c + e, sumImaginary = d + f;
    const double real = a - 0.5 * sumReal, imaginary = b - 0.5 * sumImaginary;
    const double turnedReal = half * (d - f), turnedImaginary = half * (e - c);
    to.Real[l] = a + sumReal;
    to.Imaginary[l] = b + sumImaginary;
    Store(to, out + l, real + turnedReal, imaginary + turnedImaginary, cosine[1], sine[1]);
    Store(to, 2 * out + l, real - turnedReal, imaginary - turnedImaginary, cosine[2], sine[2]);
  }
}

RUC_INLINE void Butterfly4(const Source& from, std::ptrdiff_t in, const Target& to,
  std::ptrdiff_t out, const double* cosine, const double* sine)
{
  for (int l = 0; l < Lanes; ++l)
  {
    const double a = from.Real[l], b = from.Imaginary[l];
    const double c = from.Real[in + l], d = from.Imaginary[in + l];
    const double e = from.Real[2 * in + l], f = from.Imaginary[2 * in + l];
    const double g = from.Real[3 * in + l], h = from.Imaginary[3 * in + l];
    const double evenReal = a + e, evenImaginary = b + f;
    const double apartReal = a - e, apartImaginary = b - f;
    const double oddReal = c + g, oddImaginary = d + h;
    const double turnedReal = d - h, turnedImaginary = g - c;
    to.Real[l] = evenReal + oddReal;
    to.Imaginary[l] = evenImaginary + oddImaginary;
    Store(
      to, out + l, apartReal + turnedReal, apartImaginary + turnedImaginary, cosine[1], sine[1]);
    Store(to, 2 * out + l, evenReal - oddReal, evenImaginary - oddImaginary, cosine[2], sine[2]);
    Store(to, 3 * out + l, apartReal - turnedReal, apartImaginary - turnedImaginary, cosine[3],
      sine[3]);
  }
}

RUC_INLINE void Butterfly5(const Source& from, std::ptrdiff_t in, const Target& to,
  std::ptrdiff_t out, const double* cosine, const double* sine, const double* rootCosine,
  const double* rootSine)
{
  const double c1 = rootCosine[1], c2 = rootCosine[2], s1 = -rootSine[1], s2 = -rootSine[2];
  for (int l = 0; l < Lanes; ++l)
  {
    const double a = from.Real[l], b = from.Imaginary[l];
    const double x1 = from.Real[in + l], y1 = from.Imaginary[in + l];
    const double x2 = from.Real[2 * in + l], y2 = from.Imaginary[2 * in + l];
    const double x3 = from.Real[3 * in + l], y3 = from.Imaginary[3 * in + l];
    const double x4 = from.Real[4 * in + l], y4 = from.Imaginary[4 * in + l];
    const double outerX = x1 + x4, outerY = y1 + y4, innerX = x2 + x3, innerY = y2 + y3;
    const double outerU = x1 - x4, outerV = y1 - y4, innerU = x2 - x3, innerV = y2 - y3;
    const double real1 = a + c1 * outerX + c2 * innerX, imaginary1 = b + c1 * outerY + c2 * innerY;
    const double real2 = a + c2 * outerX + c1 * innerX, imaginary2 = b + c2 * outerY + c1 * innerY;
    const double u1 = s1 * outerV + s2 * innerV, v1 = -(s1 * outerU + s2 * innerU);
    const double u2 = s2 * outerV - s1 * innerV, v2 = -(s2 * outerU - s1 * innerU);
    to.Real[l] = a + outerX + innerX;
    to.Imaginary[l] = b + outerY + innerY;
    Store(to, out + l, real1 + u1, imaginary1 + v1, cosine[1], sine[1]);
    Store(to, 2 * out + l, real2 + u2, imaginary2 + v2, cosine[2], sine[2]);
    Store(to, 3 * out + l, real2 - u2, imaginary2 - v2, cosine[3], sine[3]);
    Store(to, 4 * out + l, real1 - u1, imaginary1 - v1, cosine[4], sine[4]);
  }
}

// An odd factor p of any size, by pairs of the numbers k and p - k: their sums go with cosines and
// their differences with sines, for the results r and p - r together
RUC_INLINE void ButterflyOdd(const Source& from, std::ptrdiff_t in, const Target& to,
  std::ptrdiff_t out, const double* cosine, const double* sine, const LineTransform::Stage& stage)
{
  constexpr int most = LargestFactor / 2;
  const int factor = stage.Factor, pairs = factor / 2;
  double sumReal[most][Lanes], sumImaginary[most][Lanes];
  double apartReal[most][Lanes], apartImaginary[most][Lanes];
  double firstReal[Lanes], firstImaginary[Lanes];
  for (int l = 0; l < Lanes; ++l)
  {
    firstReal[l] = from.Real[l];
    firstImaginary[l] = from.Imaginary[l];
  }
  for (int k = 0; k < pairs; ++k)
  {
    const std::ptrdiff_t a = (k + 1) * in, b = (factor - 1 - k) * in;
    for (int l = 0; l < Lanes; ++l)
    {
      sumReal[k][l] = from.Real[a + l] + from.Real[b + l];
      sumImaginary[k][l] = from.Imaginary[a + l] + from.Imaginary[b + l];
      apartReal[k][l] = from.Real[a + l] - from.Real[b + l];
      apartImaginary[k][l] = from.Imaginary[a + l] - from.Imaginary[b + l];
      firstReal[l] += sumReal[k][l];
      firstImaginary[l] += sumImaginary[k][l];
    }
  }
  for (int r = 1; r <= pairs; ++r)
  {
    double real[Lanes], imaginary[Lanes], turnedReal[Lanes] = {}, turnedImaginary[Lanes] = {};
    for (int l = 0; l < Lanes; ++l)
    {
      real[l] = from.Real[l];
      imaginary[l] = from.Imaginary[l];
    }
    for (int k = 0; k < pairs; ++k)
    {
      const int turn = (k + 1) * r % factor;
      const double c = stage.RootCosine[turn], s = stage.RootSine[turn];
      for (int l = 0; l < Lanes; ++l)
      {
        real[l] += c * sumReal[k][l];
        imaginary[l] += c * sumImaginary[k][l];
        turnedReal[l] -= s * apartImaginary[k][l];
        turnedImaginary[l] += s * apartReal[k][l];
      }
    }
    for (int l = 0; l < Lanes; ++l)
    {
      Store(to, r * out + l, real[l] + turnedReal[l], imaginary[l] + turnedImaginary[l], cosine[r],
        sine[r]);
      const int other = factor - r;
      Store(to, other * out + l, real[l] - turnedReal[l], imaginary[l] - turnedImaginary[l],
        cosine[other], sine[other]);
    }
  }
  for (int l = 0; l < Lanes; ++l)
  {
    to.Real[l] = firstReal[l];
    to.Imaginary[l] = firstImaginary[l];
  }
}

RUC_VECTOR_CLONES void Run(const LineTransform::Stage& stage, const double* __restrict sourceReal,
  const double* __restrict sourceImaginary, double* __restrict targetReal,
  double* __restrict targetImaginary)
{
  const std::ptrdiff_t stride = std::ptrdiff_t(stage.Stride) * Lanes;
  const std::ptrdiff_t in = stride * stage.Count;
  const int factor = stage.Factor;
  for (int j = 0; j < stage.Count; ++j)
  {
    const double* cosine = stage.Cosine.data() + std::size_t(j) * factor;
    const double* sine = stage.Sine.data() + std::size_t(j) * factor;
    for (int q = 0; q < stage.Stride; ++q)
    {
      const std::ptrdiff_t begin = j * stride + q * Lanes;
      const std::ptrdiff_t end = factor * j * stride + q * Lanes;
      const Source from = { sourceReal + begin, sourceImaginary + begin };
      const Target to = { targetReal + end, targetImaginary + end };
      switch (factor)
      {
        case 2:
          Butterfly2(from, in, to, stride, cosine, sine);
          break;
        case 3:
          Butterfly3(from, in, to, stride, cosine, sine);
          break;
        case 4:
          Butterfly4(from, in, to, stride, cosine, sine);
          break;
        case 5:
          Butterfly5(
            from, in, to, stride, cosine, sine, stage.RootCosine.data(), stage.RootSine.data());
          break;
        default:
          ButterflyOdd(from, in, to, stride, cosine, sine, stage);
      }
    }
  }
}

// exp(-2 pi i turns / whole)
void SetTurn(std::int64_t turns, std::int64_t whole, double& cosine, double& sine)
{
  const double angle = 2.0 * Pi * static_cast<double>(turns % whole) / static_cast<double>(whole);
  cosine = std::cos(angle);
  sine = -std::sin(angle);
}

// The factors of a length, or none where one of them is too large
std::vector<int> FindFactors(int length)
{
  std::vector<int> factors;
  for (int factor : { 4, 2, 3, 5, 7, 11, LargestFactor })
  {
    for (; length % factor == 0; length /= factor)
    {
      factors.push_back(factor);
    }
  }
  return length == 1 ? factors : std::vector<int>();
}

LineTransform::Stage MakeStage(int factor, int count, int stride)
{
  LineTransform::Stage stage = { factor, count, stride, {}, {}, {}, {} };
  stage.Cosine.resize(std::size_t(count) * factor);
  stage.Sine.resize(stage.Cosine.size());
  for (int j = 0; j < count; ++j)
  {
    for (int r = 0; r < factor; ++r)
    {
      const std::size_t place = std::size_t(j) * factor + r;
      SetTurn(
        std::int64_t(j) * r, std::int64_t(count) * factor, stage.Cosine[place], stage.Sine[place]);
    }
  }
  stage.RootCosine.resize(factor);
  stage.RootSine.resize(factor);
  for (int r = 0; r < factor; ++r)
  {
    SetTurn(r, factor, stage.RootCosine[r], stage.RootSine[r]);
  }
  return stage;
}
}

int LineTransform::FastLength(int least)
{
  for (int length = std::max(least, 1);; ++length)
  {
    int rest = length;
    for (int factor : { 2, 3, 5, 7 })
    {
      for (; rest % factor == 0; rest /= factor)
      {
      }
    }
    if (rest == 1)
    {
      return length;
    }
  }
}

LineTransform::LineTransform(int size)
  : Length(size)
{
  Require(size >= 1, "The length of a transform", "a number >= 1", size);
  const std::vector<int> factors = FindFactors(size);
  int rest = size;
  for (int factor : factors)
  {
    rest /= factor;
    this->Stages.push_back(MakeStage(factor, rest, size / (rest * factor)));
  }
  if (!factors.empty() || size == 1)
  {
    return;
  }
  const int longer = FastLength(2 * size - 1);
  this->Longer = std::make_unique<LineTransform>(longer);
  this->ChirpCosine.resize(size);
  this->ChirpSine.resize(size);
  std::vector<double> real(std::size_t(longer) * Lanes, 0.0), imaginary(real);
  for (int j = 0; j < size; ++j)
  {
    SetTurn(std::int64_t(j) * j, 2 * std::int64_t(size), this->ChirpCosine[j], this->ChirpSine[j]);
    for (int place : { j, (longer - j) % longer })
    {
      real[std::size_t(place) * Lanes] = this->ChirpCosine[j] / longer;
      imaginary[std::size_t(place) * Lanes] = -this->ChirpSine[j] / longer;
    }
  }
  std::vector<double> work(this->Longer->WorkSize());
  this->Longer->Forward(real.data(), imaginary.data(), work.data());
  for (int k = 0; k < longer; ++k)
  {
    this->KernelReal.push_back(real[std::size_t(k) * Lanes]);
    this->KernelImaginary.push_back(imaginary[std::size_t(k) * Lanes]);
  }
}

std::size_t LineTransform::WorkSize() const
{
  const std::size_t numbers = std::size_t(2) * Lanes * this->Length;
  return this->Longer ? std::size_t(2) * Lanes * this->Longer->Length + this->Longer->WorkSize()
                      : numbers;
}

void LineTransform::Forward(double* real, double* imaginary, double* work) const
{
  if (this->Longer)
  {
    this->Convolve(real, imaginary, work);
    return;
  }
  const std::size_t numbers = std::size_t(this->Length) * Lanes;
  Target here = { real, imaginary }, there = { work, work + numbers };
  for (const Stage& stage : this->Stages)
  {
    Run(stage, here.Real, here.Imaginary, there.Real, there.Imaginary);
    std::swap(here, there);
  }
  if (here.Real != real)
  {
    std::copy_n(here.Real, numbers, real);
    std::copy_n(here.Imaginary, numbers, imaginary);
  }
}

void LineTransform::Convolve(double* real, double* imaginary, double* work) const
{
  const std::size_t longer = std::size_t(this->Longer->Length) * Lanes;
  double* a = work;
  double* b = work + longer;
  std::fill_n(work, 2 * longer, 0.0);
  const auto turn = [](double x, double y, double cosine, double sine, double& u, double& v)
  {
    u = x * cosine - y * sine;
    v = x * sine + y * cosine;
  };
  for (std::size_t n = 0; n < std::size_t(this->Length) * Lanes; ++n)
  {
    turn(
      real[n], imaginary[n], this->ChirpCosine[n / Lanes], this->ChirpSine[n / Lanes], a[n], b[n]);
  }
  this->Longer->Forward(a, b, work + 2 * longer);
  for (std::size_t n = 0; n < longer; ++n)
  {
    turn(a[n], b[n], this->KernelReal[n / Lanes], this->KernelImaginary[n / Lanes], a[n], b[n]);
  }
  this->Longer->Forward(b, a, work + 2 * longer);
  for (std::size_t n = 0; n < std::size_t(this->Length) * Lanes; ++n)
  {
    turn(
      a[n], b[n], this->ChirpCosine[n / Lanes], this->ChirpSine[n / Lanes], real[n], imaginary[n]);
  }
}
}
