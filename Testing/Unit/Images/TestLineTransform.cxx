// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Images/LineTransform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <random>
#include <stdexcept>
#include <vector>

namespace
{
using ruc::LineTransform;
constexpr int Lanes = LineTransform::Lanes;
const long double Pi = std::acos(-1.0L);

struct Lines
{
  explicit Lines(int size)
    : Real(size * Lanes)
    , Imaginary(size * Lanes)
  {
    std::mt19937 engine(size);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (std::size_t n = 0; n < this->Real.size(); ++n)
    {
      this->Real[n] = uniform(engine);
      this->Imaginary[n] = uniform(engine);
    }
  }
  std::vector<double> Real, Imaginary;
};

void Forward(
  const LineTransform& transform, std::vector<double>& real, std::vector<double>& imaginary)
{
  std::vector<double> work(transform.WorkSize());
  transform.Forward(real.data(), imaginary.data(), work.data());
}

// The definition, in extended precision
std::complex<long double> Sum(const Lines& lines, int size, int lane, int k)
{
  std::complex<long double> sum = 0.0L;
  for (int j = 0; j < size; ++j)
  {
    const long double angle =
      -2.0L * Pi * static_cast<long double>(static_cast<long>(j) * k % size) / size;
    sum +=
      std::complex<long double>(lines.Real[j * Lanes + lane], lines.Imaginary[j * Lanes + lane]) *
      std::complex<long double>(std::cos(angle), std::sin(angle));
  }
  return sum;
}
}

TEST(LineTransform, IsTheSumOfItsDefinition)
{
  // Every factor, their mixtures, primes up to the largest factor and beyond, and their multiples
  for (int size : { 1, 2, 3, 4, 5, 6, 7, 8, 9, 11, 12, 13, 15, 16, 17, 20, 22, 25, 26, 27, 30, 34,
         49, 60, 91, 64, 97, 98, 120, 121, 128, 169, 257, 280, 360 })
  {
    const Lines given(size);
    Lines found = given;
    Forward(LineTransform(size), found.Real, found.Imaginary);
    // Rounding grows as the logarithm of the length, on a sum of about sqrt(n)
    const double tolerance = 4e-16 * std::sqrt(size) * (6.0 + 3.0 * std::log2(size));
    for (int lane : { 0, 3, Lanes - 1 })
    {
      for (int k = 0; k < size; ++k)
      {
        const std::complex<long double> expected = Sum(given, size, lane, k);
        ASSERT_NEAR(found.Real[k * Lanes + lane], static_cast<double>(expected.real()), tolerance)
          << size << ' ' << k;
        ASSERT_NEAR(
          found.Imaginary[k * Lanes + lane], static_cast<double>(expected.imag()), tolerance)
          << size << ' ' << k;
      }
    }
  }
}

TEST(LineTransform, TheExchangeOfPartsIsTheInverse)
{
  for (int size : { 1, 2, 45, 64, 210, 457, 513, 600 })
  {
    const LineTransform transform(size);
    const Lines given(size);
    Lines found = given;
    Forward(transform, found.Real, found.Imaginary);
    Forward(transform, found.Imaginary, found.Real);
    for (std::size_t n = 0; n < given.Real.size(); ++n)
    {
      ASSERT_NEAR(found.Real[n] / size, given.Real[n], 4e-15) << size;
      ASSERT_NEAR(found.Imaginary[n] / size, given.Imaginary[n], 4e-15) << size;
    }
  }
}

TEST(LineTransform, ALaneDoesNotSeeTheOthers)
{
  for (int size : { 3, 28, 60, 96, 137 })
  {
    const LineTransform transform(size);
    Lines one(size), other(size);
    for (std::size_t n = 0; n < one.Real.size(); ++n)
    {
      if (n % Lanes != 2)
      {
        other.Real[n] = 1e3 * one.Imaginary[n];
      }
    }
    // The same line in another lane
    for (int j = 0; j < size; ++j)
    {
      other.Real[j * Lanes + 5] = one.Real[j * Lanes + 2];
      other.Imaginary[j * Lanes + 5] = one.Imaginary[j * Lanes + 2];
    }
    Forward(transform, one.Real, one.Imaginary);
    Forward(transform, other.Real, other.Imaginary);
    for (int k = 0; k < size; ++k)
    {
      ASSERT_EQ(one.Real[k * Lanes + 2], other.Real[k * Lanes + 2]);
      ASSERT_EQ(one.Real[k * Lanes + 2], other.Real[k * Lanes + 5]);
      ASSERT_EQ(one.Imaginary[k * Lanes + 2], other.Imaginary[k * Lanes + 5]);
    }
  }
}

TEST(LineTransform, FastLengthsHaveNoFactorAboveSeven)
{
  EXPECT_EQ(LineTransform::FastLength(1), 1);
  EXPECT_EQ(LineTransform::FastLength(11), 12);
  EXPECT_EQ(LineTransform::FastLength(583), 588);
  EXPECT_EQ(LineTransform::FastLength(527), 540);
  EXPECT_EQ(LineTransform::FastLength(350), 350);
  EXPECT_THROW(LineTransform(0), std::invalid_argument);
}
