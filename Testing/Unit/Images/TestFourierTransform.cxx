// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Images/FourierTransform.h"

#include "ThreadRanks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <random>
#include <vector>

namespace
{
using Triple = std::array<int, 3>;
using ruc::FourierTransform;
constexpr int Lanes = ruc::LineTransform::Lanes;
const double Pi = std::acos(-1.0);

// A real image, 0 outside of what is filled
struct Image
{
  Image(const Triple& filled, unsigned seed)
    : Filled(filled)
  {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    this->Values.resize(std::size_t(filled[0]) * filled[1] * filled[2]);
    for (double& value : this->Values)
    {
      value = uniform(engine);
    }
  }
  double At(int x, int y, int z) const
  {
    return x < this->Filled[0] && y < this->Filled[1] && z < this->Filled[2]
      ? this->Values[(std::size_t(z) * this->Filled[1] + y) * this->Filled[0] + x]
      : 0.0;
  }
  FourierTransform::Spectrum Transform(
    const FourierTransform& transform, ruc::Communicator& ranks) const
  {
    FourierTransform::Spectrum spectrum;
    transform.Forward(
      [&](int y, int z, double* line)
      {
        for (int x = 0; x < this->Filled[0]; ++x)
        {
          line[x] = this->At(x, y, z);
        }
      },
      spectrum, ranks);
    return spectrum;
  }
  Triple Filled;
  std::vector<double> Values;
};

struct Case
{
  Triple Size, Filled, Last;
};
// Odd, prime and one-voxel edges, full and with zeros after them
const Case Cases[] = { { { 8, 6, 5 }, { 8, 6, 5 }, { 4, 3, 2 } },
  { { 12, 10, 9 }, { 7, 5, 6 }, { 5, 5, 3 } }, { { 1, 1, 1 }, { 1, 1, 1 }, { 0, 0, 0 } },
  { { 1, 7, 17 }, { 1, 7, 17 }, { 0, 2, 8 } }, { { 19, 1, 3 }, { 19, 1, 3 }, { 9, 0, 1 } },
  { { 40, 2, 1 }, { 33, 2, 1 }, { 7, 1, 0 } } };

std::complex<double> Sum(const Image& image, const Triple& size, const Triple& k)
{
  std::complex<double> sum = 0.0;
  for (int z = 0; z < image.Filled[2]; ++z)
  {
    for (int y = 0; y < image.Filled[1]; ++y)
    {
      for (int x = 0; x < image.Filled[0]; ++x)
      {
        sum += image.At(x, y, z) *
          std::polar(1.0,
            -2.0 * Pi *
              (double(k[0]) * x / size[0] + double(k[1]) * y / size[1] +
                double(k[2]) * z / size[2]));
      }
    }
  }
  return sum;
}

// The spectrum of all ranks, in the order of the columns: a rank has whole units of columns
std::vector<double> Spectrum(const Case& of, int size)
{
  std::vector<double> whole;
  oracle::ThreadRanks::Run(size,
    [&](ruc::Communicator& ranks)
    {
      const FourierTransform transform(of.Size, of.Filled, ranks);
      const std::vector<double> all =
        ranks.Concatenate(Image(of.Filled, 1).Transform(transform, ranks));
      if (ranks.Rank() == 0)
      {
        whole = all;
      }
    });
  return whole;
}

// The correlation of all ranks, by planes
std::vector<double> Correlation(const Case& of, int size)
{
  std::vector<double> whole;
  oracle::ThreadRanks::Run(size,
    [&](ruc::Communicator& ranks)
    {
      const FourierTransform transform(of.Size, of.Filled, ranks);
      const ruc::Slabs lags = { of.Last[2] + 1, size };
      std::vector<std::vector<double>> planes(lags.Size(ranks.Rank()));
      transform.Correlate(Image(of.Filled, 1).Transform(transform, ranks),
        Image(of.Filled, 2).Transform(transform, ranks), of.Last, ranks,
        [&](int z, const std::vector<double>& values)
        { planes[z - lags.Begin(ranks.Rank())] = values; });
      const std::vector<std::vector<double>> all = ranks.Concatenate(planes);
      for (std::size_t z = 0; ranks.Rank() == 0 && z < all.size(); ++z)
      {
        whole.insert(whole.end(), all[z].begin(), all[z].end());
      }
    });
  return whole;
}
}

TEST(FourierTransform, IsTheSumOfItsDefinition)
{
  for (const Case& of : Cases)
  {
    const Image image(of.Filled, 1);
    const std::vector<double> spectrum = Spectrum(of, 1);
    const int half = of.Size[0] / 2 + 1;
    for (int column = 0; column < half * of.Size[1]; ++column)
    {
      const int x = column % half, y = column / half;
      for (int z = 0; z < of.Size[2]; ++z)
      {
        const std::complex<double> expected = Sum(image, of.Size, { x, y, z });
        const std::size_t block = y + std::size_t(x / Lanes) * of.Size[1];
        const std::size_t place = (block * 2 * of.Size[2] + z) * Lanes + x % Lanes;
        ASSERT_NEAR(spectrum[place], expected.real(), 1e-12) << column << ' ' << z;
        ASSERT_NEAR(spectrum[place + Lanes * of.Size[2]], expected.imag(), 1e-12)
          << column << ' ' << z;
      }
    }
  }
}

TEST(FourierTransform, CorrelatesAsDirectSumsDo)
{
  for (const Case& of : Cases)
  {
    const Image a(of.Filled, 1), b(of.Filled, 2);
    const std::vector<double> found = Correlation(of, 1);
    const auto direct = [&](const Triple& lag)
    {
      double sum = 0.0;
      for (int z = 0; z < of.Size[2]; ++z)
      {
        for (int y = 0; y < of.Size[1]; ++y)
        {
          for (int x = 0; x < of.Size[0]; ++x)
          {
            const auto moved = [&](int place, int q)
            { return (place + lag[q] + of.Size[q]) % of.Size[q]; };
            sum += a.At(x, y, z) * b.At(moved(x, 0), moved(y, 1), moved(z, 2));
          }
        }
      }
      return sum;
    };
    std::size_t place = 0;
    for (int z = 0; z <= of.Last[2]; ++z)
    {
      for (int y = -of.Last[1]; y <= of.Last[1]; ++y)
      {
        for (int x = -of.Last[0]; x <= of.Last[0]; ++x)
        {
          ASSERT_NEAR(found[place++], direct({ x, y, z }) + direct({ -x, -y, -z }), 1e-12)
            << x << ' ' << y << ' ' << z;
        }
      }
    }
    EXPECT_EQ(place, found.size());
  }
}

TEST(FourierTransform, InverseGivesTheImageOnAnyNumberOfRanks)
{
  for (const Case& of : Cases)
  {
    const Image image(of.Filled, 3);
    std::vector<double> alone;
    for (int size : { 1, 2, 3, 7 })
    {
      oracle::ThreadRanks::Run(size,
        [&](ruc::Communicator& ranks)
        {
          const FourierTransform transform(of.Size, of.Filled, ranks);
          FourierTransform::Spectrum spectrum = image.Transform(transform, ranks);
          const std::size_t plane = std::size_t(of.Filled[0]) * of.Filled[1];
          const std::int64_t begin = transform.GetPlanes().Begin(ranks.Rank());
          std::vector<double> own(transform.GetPlanes().Size(ranks.Rank()) * plane);
          transform.Inverse(
            spectrum,
            [&](int z, const double* values)
            { std::copy_n(values, plane, own.data() + (z - begin) * plane); },
            ranks);
          const std::vector<double> all = ranks.Concatenate(own);
          ASSERT_EQ(all.size(), image.Values.size());
          for (std::size_t n = 0; n < all.size(); ++n)
          {
            ASSERT_NEAR(all[n], image.Values[n], 1e-14 * of.Size[0] * of.Size[1] * of.Size[2]);
          }
          if (ranks.Rank() == 0)
          {
            alone = size == 1 ? all : alone;
            EXPECT_EQ(all, alone) << size;
          }
        });
    }
  }
}

TEST(FourierTransform, KnowsTheFrequenciesOfItsBlocks)
{
  const Case& of = Cases[5];
  oracle::ThreadRanks::Run(2,
    [&](ruc::Communicator& ranks)
    {
      const FourierTransform transform(of.Size, of.Filled, ranks);
      const Image image(of.Filled, 1);
      const FourierTransform::Spectrum spectrum = image.Transform(transform, ranks);
      for (std::int64_t block = 0; block < transform.NumberOfBlocks(); ++block)
      {
        const auto [x, y] = transform.FrequenciesOf(block);
        for (int lane = 0; lane < Lanes && x + lane < transform.HalfX(); ++lane)
        {
          const std::size_t place = block * 2 * of.Size[2] * Lanes + lane;
          ASSERT_NEAR(spectrum[place], Sum(image, of.Size, { x + lane, y, 0 }).real(), 1e-12);
        }
      }
    });
}

TEST(FourierTransform, IsEqualForAnyNumberOfRanks)
{
  for (const Case& of : Cases)
  {
    const std::vector<double> spectrum = Spectrum(of, 1), correlation = Correlation(of, 1);
    for (int ranks : { 2, 3, 4, 7 }) // more ranks than planes among them
    {
      EXPECT_EQ(Spectrum(of, ranks), spectrum) << ranks;
      EXPECT_EQ(Correlation(of, ranks), correlation) << ranks;
    }
  }
}
