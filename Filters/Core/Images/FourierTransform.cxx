// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Images/FourierTransform.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace ruc
{
namespace
{
constexpr int Lanes = LineTransform::Lanes;

// Planes are exchanged in rounds of about this many bytes on every rank, which bounds the messages
constexpr double BytesOfRound = 64e6;

// What a thread needs to transform lines of one length
struct Lines
{
  explicit Lines(const LineTransform& transform)
    : Real(std::size_t(transform.Size()) * Lanes)
    , Imaginary(Real.size())
    , Work(transform.WorkSize())
  {
  }
  std::vector<double> Real, Imaginary, Work;
};

// The spectra of two real lines that were transformed as real and imaginary part of one
struct TwoSpectra
{
  double RealA, ImaginaryA, RealB, ImaginaryB;
};
TwoSpectra Separate(const Lines& lines, int size, int k, int lane)
{
  const std::size_t here = std::size_t(k) * Lanes + lane;
  const std::size_t there = std::size_t(k == 0 ? 0 : size - k) * Lanes + lane;
  const double a = lines.Real[here], b = lines.Imaginary[here];
  const double c = lines.Real[there], d = lines.Imaginary[there];
  return { 0.5 * (a + c), 0.5 * (b - d), 0.5 * (b + d), 0.5 * (c - a) };
}

// Calls use(lane, column) for the columns of a block of lanes that exist
template <class Use>
void ForLanes(int first, int columns, Use&& use)
{
  for (int lane = 0; lane < std::min(Lanes, columns - first); ++lane)
  {
    use(lane, first + lane);
  }
}
}

FourierTransform::FourierTransform(
  const std::array<int, 3>& size, const std::array<int, 3>& filled, const Communicator& ranks)
  : Size(size)
  , Filled(filled)
  , AlongX(size[0])
  , AlongY(size[1])
  , AlongZ(size[2])
  , Rank(ranks.Rank())
  , Planes{ filled[2], ranks.Size() }
  , Units{ static_cast<std::int64_t>((this->Columns() + UnitColumns - 1) / UnitColumns),
    ranks.Size() }
{
}

std::size_t FourierTransform::SpectrumSize() const
{
  return static_cast<std::size_t>(this->Units.Largest()) * UnitColumns * 2 * this->Size[2];
}

void FourierTransform::TransformPlane(int z, const std::function<void(int, int, double*)>& fill,
  std::vector<double>& real, std::vector<double>& imaginary) const
{
  const int half = this->HalfX();
  real.assign(this->Columns(), 0.0);
  imaginary.assign(this->Columns(), 0.0);
  std::vector<double> line(this->Filled[0]);
  Lines alongX(this->AlongX), alongY(this->AlongY);
  // Lines are taken in pairs, which are the same for any number of ranks
  for (int first = 0; first < this->Filled[1]; first += 2 * Lanes)
  {
    std::fill(alongX.Real.begin(), alongX.Real.end(), 0.0);
    std::fill(alongX.Imaginary.begin(), alongX.Imaginary.end(), 0.0);
    const int count = std::min(2 * Lanes, this->Filled[1] - first);
    for (int n = 0; n < count; ++n)
    {
      fill(first + n, z, line.data());
      double* to = (n % 2 == 0 ? alongX.Real : alongX.Imaginary).data() + n / 2;
      for (int x = 0; x < this->Filled[0]; ++x)
      {
        to[std::size_t(x) * Lanes] = line[x];
      }
    }
    this->AlongX.Forward(alongX.Real.data(), alongX.Imaginary.data(), alongX.Work.data());
    for (int n = 0; n < count; n += 2)
    {
      double* realA = real.data() + std::size_t(first + n) * half;
      double* imaginaryA = imaginary.data() + std::size_t(first + n) * half;
      for (int k = 0; k < half; ++k)
      {
        const TwoSpectra two = Separate(alongX, this->Size[0], k, n / 2);
        realA[k] = two.RealA;
        imaginaryA[k] = two.ImaginaryA;
        if (n + 1 < count)
        {
          realA[half + k] = two.RealB;
          imaginaryA[half + k] = two.ImaginaryB;
        }
      }
    }
  }
  for (int first = 0; first < half; first += Lanes)
  {
    std::fill(alongY.Real.begin(), alongY.Real.end(), 0.0);
    std::fill(alongY.Imaginary.begin(), alongY.Imaginary.end(), 0.0);
    for (int y = 0; y < this->Filled[1]; ++y)
    {
      ForLanes(first, half,
        [&](int lane, int x)
        {
          alongY.Real[std::size_t(y) * Lanes + lane] = real[std::size_t(y) * half + x];
          alongY.Imaginary[std::size_t(y) * Lanes + lane] = imaginary[std::size_t(y) * half + x];
        });
    }
    this->AlongY.Forward(alongY.Real.data(), alongY.Imaginary.data(), alongY.Work.data());
    for (int y = 0; y < this->Size[1]; ++y)
    {
      ForLanes(first, half,
        [&](int lane, int x)
        {
          real[std::size_t(y) * half + x] = alongY.Real[std::size_t(y) * Lanes + lane];
          imaginary[std::size_t(y) * half + x] = alongY.Imaginary[std::size_t(y) * Lanes + lane];
        });
    }
  }
}

FourierTransform::Spectrum FourierTransform::Forward(
  const std::function<void(int, int, double*)>& fill, Communicator& ranks) const
{
  const std::size_t own = this->NumberOfColumns(this->Rank);
  Spectrum spectrum(own * 2 * this->Size[2], 0.0);
  const std::int64_t planesOfRound =
    std::max<std::int64_t>(1, static_cast<std::int64_t>(BytesOfRound / (16.0 * this->Columns())));
  for (std::int64_t begun = 0; begun < this->Planes.Largest(); begun += planesOfRound)
  {
    const auto planesOf = [&](int rank)
    { return std::clamp<std::int64_t>(this->Planes.Size(rank) - begun, 0, planesOfRound); };
    std::vector<std::vector<double>> outgoing(ranks.Size());
    for (int rank = 0; rank < ranks.Size(); ++rank)
    {
      outgoing[rank].resize(planesOf(this->Rank) * 2 * this->NumberOfColumns(rank));
    }
    const int firstPlane = static_cast<int>(this->Planes.Begin(this->Rank) + begun);
#pragma omp parallel for schedule(dynamic)
    for (std::int64_t plane = 0; plane < planesOf(this->Rank); ++plane)
    {
      std::vector<double> real, imaginary;
      this->TransformPlane(firstPlane + static_cast<int>(plane), fill, real, imaginary);
      for (std::size_t rank = 0; rank < outgoing.size(); ++rank)
      {
        const std::size_t first = this->FirstColumn(rank), count = this->NumberOfColumns(rank);
        const std::size_t present = std::min(count, real.size() - std::min(first, real.size()));
        double* to = outgoing[rank].data() + plane * 2 * count;
        std::copy_n(real.data() + first, present, to);
        std::copy_n(imaginary.data() + first, present, to + count);
      }
    }
    const std::vector<std::vector<double>> incoming = ranks.AllToAll(std::move(outgoing));
    for (int rank = 0; rank < ranks.Size(); ++rank)
    {
      const std::int64_t first = this->Planes.Begin(rank) + begun;
#pragma omp parallel for
      for (std::int64_t block = 0; block < static_cast<std::int64_t>(own / Lanes); ++block)
      {
        double* to = spectrum.data() + block * 2 * Lanes * this->Size[2];
        for (std::int64_t plane = 0; plane < planesOf(rank); ++plane)
        {
          const double* from = incoming[rank].data() + plane * 2 * own + block * Lanes;
          std::copy_n(from, Lanes, to + (first + plane) * Lanes);
          std::copy_n(from + own, Lanes, to + (this->Size[2] + first + plane) * Lanes);
        }
      }
    }
  }
  this->TransformColumns(spectrum);
  return spectrum;
}

void FourierTransform::TransformColumns(Spectrum& spectrum) const
{
  const std::size_t numbers = std::size_t(this->Size[2]) * Lanes;
  const auto blocks = static_cast<std::int64_t>(spectrum.size() / (2 * numbers));
#pragma omp parallel
  {
    std::vector<double> work(this->AlongZ.WorkSize());
#pragma omp for
    for (std::int64_t block = 0; block < blocks; ++block)
    {
      double* real = spectrum.data() + block * 2 * numbers;
      this->AlongZ.Forward(real, real + numbers, work.data());
    }
  }
}

std::vector<std::vector<double>> FourierTransform::ProductPlanes(
  const Spectrum& a, const Spectrum& b, const Slabs& lags) const
{
  const std::size_t own = this->NumberOfColumns(this->Rank);
  const std::size_t numbers = std::size_t(this->Size[2]) * Lanes;
  std::vector<std::vector<double>> planes;
  for (int rank = 0; rank < lags.Ranks; ++rank)
  {
    planes.emplace_back(lags.Size(rank) * 2 * own);
  }
#pragma omp parallel
  {
    Lines lines(this->AlongZ);
#pragma omp for
    for (std::int64_t unit = 0; unit < static_cast<std::int64_t>(own / UnitColumns); ++unit)
    {
      // The symmetrised product is real. Two blocks are transformed as real and imaginary part.
      for (int part = 0; part < 2; ++part)
      {
        const std::size_t begin = (2 * unit + part) * 2 * numbers;
        const double* first = a.data() + begin;
        const double* second = b.data() + begin;
        double* product = (part == 0 ? lines.Real : lines.Imaginary).data();
        for (std::size_t n = 0; n < numbers; ++n)
        {
          product[n] = first[n] * second[n] + first[numbers + n] * second[numbers + n];
        }
      }
      this->AlongZ.Forward(lines.Real.data(), lines.Imaginary.data(), lines.Work.data());
      for (int rank = 0; rank < lags.Ranks; ++rank)
      {
        for (std::int64_t z = lags.Begin(rank); z < lags.End(rank); ++z)
        {
          double* real =
            planes[rank].data() + (z - lags.Begin(rank)) * 2 * own + unit * UnitColumns;
          double* imaginary = real + own;
          for (int lane = 0; lane < Lanes; ++lane)
          {
            // The inverse transform of a real line is conjugate to the transform
            const TwoSpectra two = Separate(lines, this->Size[2], static_cast<int>(z), lane);
            real[lane] = two.RealA;
            imaginary[lane] = -two.ImaginaryA;
            real[Lanes + lane] = two.RealB;
            imaginary[Lanes + lane] = -two.ImaginaryB;
          }
        }
      }
    }
  }
  return planes;
}

void FourierTransform::InvertPlane(std::vector<double>& real, std::vector<double>& imaginary,
  const std::array<int, 3>& last, std::vector<double>& values) const
{
  const int half = this->HalfX(), rows = 2 * last[1] + 1, row = 2 * last[0] + 1;
  Lines alongX(this->AlongX), alongY(this->AlongY);
  const auto wrapped = [](int lag, int size) { return lag < 0 ? lag + size : lag; };
  // The rows of the lags along y, with the frequencies along x
  std::vector<double> rowsReal(std::size_t(rows) * half), rowsImaginary(rowsReal.size());
  for (int first = 0; first < half; first += Lanes)
  {
    for (int y = 0; y < this->Size[1]; ++y)
    {
      ForLanes(first, half,
        [&](int lane, int x)
        {
          alongY.Real[std::size_t(y) * Lanes + lane] = real[std::size_t(y) * half + x];
          alongY.Imaginary[std::size_t(y) * Lanes + lane] = imaginary[std::size_t(y) * half + x];
        });
    }
    this->AlongY.Forward(alongY.Imaginary.data(), alongY.Real.data(), alongY.Work.data());
    for (int n = 0; n < rows; ++n)
    {
      const std::size_t y = wrapped(n - last[1], this->Size[1]);
      ForLanes(first, half,
        [&](int lane, int x)
        {
          rowsReal[std::size_t(n) * half + x] = alongY.Real[y * Lanes + lane];
          rowsImaginary[std::size_t(n) * half + x] = alongY.Imaginary[y * Lanes + lane];
        });
    }
  }
  values.resize(std::size_t(rows) * row);
  for (int first = 0; first < rows; first += 2 * Lanes)
  {
    const int count = std::min(2 * Lanes, rows - first);
    std::fill(alongX.Real.begin(), alongX.Real.end(), 0.0);
    std::fill(alongX.Imaginary.begin(), alongX.Imaginary.end(), 0.0);
    for (int n = 0; n < count; ++n)
    {
      const double* fromReal = rowsReal.data() + std::size_t(first + n) * half;
      const double* fromImaginary = rowsImaginary.data() + std::size_t(first + n) * half;
      // A row a is added as it is, and its partner b as i b; both have conjugate halves
      for (int k = 0; k < this->Size[0]; ++k)
      {
        const bool mirrored = k >= half;
        const int from = mirrored ? this->Size[0] - k : k;
        const double x = fromReal[from], y = mirrored ? -fromImaginary[from] : fromImaginary[from];
        const std::size_t place = std::size_t(k) * Lanes + n / 2;
        alongX.Real[place] += n % 2 == 0 ? x : -y;
        alongX.Imaginary[place] += n % 2 == 0 ? y : x;
      }
    }
    this->AlongX.Forward(alongX.Imaginary.data(), alongX.Real.data(), alongX.Work.data());
    for (int n = 0; n < count; ++n)
    {
      const double* from = (n % 2 == 0 ? alongX.Real : alongX.Imaginary).data() + n / 2;
      for (int x = -last[0]; x <= last[0]; ++x)
      {
        values[std::size_t(first + n) * row + x + last[0]] =
          from[std::size_t(wrapped(x, this->Size[0])) * Lanes];
      }
    }
  }
  const double factor = 2.0 / (static_cast<double>(this->Size[0]) * this->Size[1] * this->Size[2]);
  for (double& value : values)
  {
    value *= factor;
  }
}

void FourierTransform::Correlate(const Spectrum& a, const Spectrum& b,
  const std::array<int, 3>& last, Communicator& ranks,
  const std::function<void(int z, const std::vector<double>& values)>& visit) const
{
  const Slabs lags = { last[2] + 1, ranks.Size() };
  const std::vector<std::vector<double>> incoming = ranks.AllToAll(this->ProductPlanes(a, b, lags));
  const std::int64_t begin = lags.Begin(this->Rank), end = lags.End(this->Rank);
#pragma omp parallel for schedule(dynamic)
  for (std::int64_t z = begin; z < end; ++z)
  {
    std::vector<double> real, imaginary, values;
    for (int rank = 0; rank < ranks.Size(); ++rank)
    {
      const std::size_t count = this->NumberOfColumns(rank);
      const double* from = incoming[rank].data() + (z - begin) * 2 * count;
      real.insert(real.end(), from, from + count);
      imaginary.insert(imaginary.end(), from + count, from + 2 * count);
    }
    this->InvertPlane(real, imaginary, last, values);
#pragma omp critical(ruc_fourier_visit)
    visit(static_cast<int>(z), values);
  }
}
}
