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
constexpr double BytesOfRound = 8e6;

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

// Replaces lines that were transformed as real and imaginary part of one, by the spectra of both at
// frequency k: `a` of the real parts, `b` of the imaginary ones
struct TwoSpectra
{
  double RealA[Lanes], ImaginaryA[Lanes], RealB[Lanes], ImaginaryB[Lanes];
};
void Separate(const Lines& lines, int size, int k, TwoSpectra& two)
{
  const std::size_t here = std::size_t(k) * Lanes;
  const std::size_t there = std::size_t(k == 0 ? 0 : size - k) * Lanes;
  const double* real = lines.Real.data();
  const double* imaginary = lines.Imaginary.data();
  for (int l = 0; l < Lanes; ++l)
  {
    const double a = real[here + l], b = imaginary[here + l];
    const double c = real[there + l], d = imaginary[there + l];
    two.RealA[l] = 0.5 * (a + c);
    two.ImaginaryA[l] = 0.5 * (b - d);
    two.RealB[l] = 0.5 * (b + d);
    two.ImaginaryB[l] = 0.5 * (c - a);
  }
}

// Sets a frequency of lines, and that which is its mirror image, to those of pairs of rows, which
// lie Lanes apart: a row a is added as it is, and its partner b as i b; both have conjugate halves
void JoinRows(
  const double* real, const double* imaginary, int rows, int k, int mirrored, Lines& lines)
{
  double* here = lines.Real.data() + std::size_t(k) * Lanes;
  double* hereToo = lines.Imaginary.data() + std::size_t(k) * Lanes;
  double* there = lines.Real.data() + std::size_t(mirrored) * Lanes;
  double* thereToo = lines.Imaginary.data() + std::size_t(mirrored) * Lanes;
  for (int n = 0; n < Lanes; ++n)
  {
    const std::size_t first = std::size_t(2 * n) * Lanes, second = first + Lanes;
    const bool hasFirst = 2 * n < rows, hasSecond = 2 * n + 1 < rows;
    const double a = hasFirst ? real[first] : 0.0, b = hasFirst ? imaginary[first] : 0.0;
    const double c = hasSecond ? real[second] : 0.0, d = hasSecond ? imaginary[second] : 0.0;
    there[n] = a + d;
    thereToo[n] = c - b;
    here[n] = a - d;
    hereToo[n] = b + c;
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
  , Units{ (std::int64_t(this->BlocksX()) * size[1] + 1) / 2, ranks.Size() }
{
}

std::size_t FourierTransform::SpectrumSize() const
{
  return static_cast<std::size_t>(this->Units.Largest()) * UnitColumns * 2 * this->Size[2];
}

void FourierTransform::TransformPlane(
  int z, const std::function<void(int, int, double*)>& fill, Plane& plane) const
{
  plane.Real.assign(this->ColumnsOfPlane(), 0.0);
  plane.Imaginary.assign(this->ColumnsOfPlane(), 0.0);
  std::vector<double> line(this->Filled[0]);
  Lines alongX(this->AlongX);
  const std::size_t ofBlock = std::size_t(this->Size[1]) * Lanes;
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
    for (int block = 0; block < this->BlocksX(); ++block)
    {
      TwoSpectra two[Lanes];
      const int frequencies = std::min(Lanes, this->HalfX() - block * Lanes);
      for (int k = 0; k < frequencies; ++k)
      {
        Separate(alongX, this->Size[0], block * Lanes + k, two[k]);
      }
      for (int n = 0; n < count; ++n)
      {
        const std::size_t place = block * ofBlock + std::size_t(first + n) * Lanes;
        for (int k = 0; k < frequencies; ++k)
        {
          plane.Real[place + k] = n % 2 == 0 ? two[k].RealA[n / 2] : two[k].RealB[n / 2];
          plane.Imaginary[place + k] =
            n % 2 == 0 ? two[k].ImaginaryA[n / 2] : two[k].ImaginaryB[n / 2];
        }
      }
    }
  }
  std::vector<double> work(this->AlongY.WorkSize());
  for (int block = 0; block < this->BlocksX(); ++block)
  {
    this->AlongY.Forward(
      plane.Real.data() + block * ofBlock, plane.Imaginary.data() + block * ofBlock, work.data());
  }
}

void FourierTransform::Forward(
  const std::function<void(int, int, double*)>& fill, Spectrum& spectrum, Communicator& ranks) const
{
  const std::size_t own = this->NumberOfColumns(this->Rank);
  spectrum.assign(own * 2 * this->Size[2], 0.0);
  const std::int64_t planesOfRound = std::max<std::int64_t>(
    1, static_cast<std::int64_t>(BytesOfRound / (16.0 * this->ColumnsOfPlane())));
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
    for (std::int64_t n = 0; n < planesOf(this->Rank); ++n)
    {
      Plane plane;
      this->TransformPlane(firstPlane + static_cast<int>(n), fill, plane);
      for (int rank = 0; rank < ranks.Size(); ++rank)
      {
        const std::size_t first = this->FirstColumn(rank), count = this->NumberOfColumns(rank);
        double* to = outgoing[rank].data() + n * 2 * count;
        std::copy_n(plane.Real.data() + first, count, to);
        std::copy_n(plane.Imaginary.data() + first, count, to + count);
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
  planes.reserve(lags.Ranks);
  for (int rank = 0; rank < lags.Ranks; ++rank)
  {
    planes.emplace_back(lags.Size(rank) * 2 * own);
  }
#pragma omp parallel
  {
    Lines lines(this->AlongZ);
#pragma omp for
    for (std::int64_t unit = 0; unit < this->Units.Size(this->Rank); ++unit)
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
          // The inverse transform of a real line is conjugate to the transform
          TwoSpectra two;
          Separate(lines, this->Size[2], static_cast<int>(z), two);
          for (int lane = 0; lane < Lanes; ++lane)
          {
            real[lane] = two.RealA[lane];
            imaginary[lane] = -two.ImaginaryA[lane];
            real[Lanes + lane] = two.RealB[lane];
            imaginary[Lanes + lane] = -two.ImaginaryB[lane];
          }
        }
      }
    }
  }
  return planes;
}

void FourierTransform::InvertColumns(Spectrum& spectrum) const
{
  const std::size_t numbers = std::size_t(this->Size[2]) * Lanes;
#pragma omp parallel
  {
    std::vector<double> work(this->AlongZ.WorkSize());
#pragma omp for
    for (std::int64_t block = 0; block < this->NumberOfBlocks(); ++block)
    {
      double* real = spectrum.data() + block * 2 * numbers;
      this->AlongZ.Forward(real + numbers, real, work.data());
    }
  }
}

void FourierTransform::InvertAll(Plane& plane, std::vector<double>& values) const
{
  const std::size_t ofBlock = std::size_t(this->Size[1]) * Lanes;
  std::vector<double> work(this->AlongY.WorkSize());
  for (int block = 0; block < this->BlocksX(); ++block)
  {
    this->AlongY.Forward(
      plane.Imaginary.data() + block * ofBlock, plane.Real.data() + block * ofBlock, work.data());
  }
  Lines lines(this->AlongX);
  values.resize(std::size_t(this->Filled[0]) * this->Filled[1]);
  const double factor = 1.0 / (static_cast<double>(this->Size[0]) * this->Size[1] * this->Size[2]);
  for (int first = 0; first < this->Filled[1]; first += 2 * Lanes)
  {
    const int count = std::min(2 * Lanes, this->Filled[1] - first);
    for (int k = 0; k < this->HalfX(); ++k)
    {
      const std::size_t from = k / Lanes * ofBlock + std::size_t(first) * Lanes + k % Lanes;
      JoinRows(plane.Real.data() + from, plane.Imaginary.data() + from, count, k,
        k == 0 ? 0 : this->Size[0] - k, lines);
    }
    this->AlongX.Forward(lines.Imaginary.data(), lines.Real.data(), lines.Work.data());
    for (int n = 0; n < count; ++n)
    {
      const double* from = (n % 2 == 0 ? lines.Real : lines.Imaginary).data() + n / 2;
      double* row = values.data() + std::size_t(first + n) * this->Filled[0];
      for (int x = 0; x < this->Filled[0]; ++x)
      {
        row[x] = factor * from[std::size_t(x) * Lanes];
      }
    }
  }
}

void FourierTransform::Inverse(Spectrum& spectrum,
  const std::function<void(int, const double*)>& take, Communicator& ranks) const
{
  this->InvertColumns(spectrum);
  const std::size_t own = this->NumberOfColumns(this->Rank);
  const std::int64_t planesOfRound = std::max<std::int64_t>(
    1, static_cast<std::int64_t>(BytesOfRound / (16.0 * this->ColumnsOfPlane())));
  for (std::int64_t begun = 0; begun < this->Planes.Largest(); begun += planesOfRound)
  {
    const auto planesOf = [&](int rank)
    { return std::clamp<std::int64_t>(this->Planes.Size(rank) - begun, 0, planesOfRound); };
    std::vector<std::vector<double>> outgoing(ranks.Size());
    for (int rank = 0; rank < ranks.Size(); ++rank)
    {
      outgoing[rank].resize(planesOf(rank) * 2 * own);
      const std::int64_t first = this->Planes.Begin(rank) + begun;
#pragma omp parallel for
      for (std::int64_t block = 0; block < static_cast<std::int64_t>(own / Lanes); ++block)
      {
        const double* from = spectrum.data() + block * 2 * Lanes * this->Size[2];
        for (std::int64_t plane = 0; plane < planesOf(rank); ++plane)
        {
          double* to = outgoing[rank].data() + plane * 2 * own + block * Lanes;
          std::copy_n(from + (first + plane) * Lanes, Lanes, to);
          std::copy_n(from + (this->Size[2] + first + plane) * Lanes, Lanes, to + own);
        }
      }
    }
    const std::vector<std::vector<double>> incoming = ranks.AllToAll(std::move(outgoing));
    const int firstPlane = static_cast<int>(this->Planes.Begin(this->Rank) + begun);
#pragma omp parallel for schedule(dynamic)
    for (std::int64_t n = 0; n < planesOf(this->Rank); ++n)
    {
      Plane plane;
      std::vector<double> values;
      plane.Real.resize(this->ColumnsOfPlane());
      plane.Imaginary.resize(this->ColumnsOfPlane());
      for (int rank = 0; rank < ranks.Size(); ++rank)
      {
        const std::size_t count = this->NumberOfColumns(rank);
        const double* from = incoming[rank].data() + n * 2 * count;
        std::copy_n(from, count, plane.Real.data() + this->FirstColumn(rank));
        std::copy_n(from + count, count, plane.Imaginary.data() + this->FirstColumn(rank));
      }
      this->InvertAll(plane, values);
      take(firstPlane + static_cast<int>(n), values.data());
    }
  }
}

void FourierTransform::InvertPlane(
  Plane& plane, const std::array<int, 3>& last, std::vector<double>& values) const
{
  const int half = this->HalfX(), rows = 2 * last[1] + 1, row = 2 * last[0] + 1;
  const auto wrapped = [](int lag, int size) { return lag < 0 ? lag + size : lag; };
  const std::size_t ofBlock = std::size_t(this->Size[1]) * Lanes;
  std::vector<double> work(this->AlongY.WorkSize());
  for (int block = 0; block < this->BlocksX(); ++block)
  {
    this->AlongY.Forward(
      plane.Imaginary.data() + block * ofBlock, plane.Real.data() + block * ofBlock, work.data());
  }
  Lines alongX(this->AlongX);
  values.resize(std::size_t(rows) * row);
  for (int first = 0; first < rows; first += 2 * Lanes)
  {
    const int count = std::min(2 * Lanes, rows - first);
    std::fill(alongX.Real.begin(), alongX.Real.end(), 0.0);
    std::fill(alongX.Imaginary.begin(), alongX.Imaginary.end(), 0.0);
    for (int n = 0; n < count; ++n)
    {
      const std::size_t y = wrapped(first + n - last[1], this->Size[1]);
      const double* fromReal = plane.Real.data() + y * Lanes;
      const double* fromImaginary = plane.Imaginary.data() + y * Lanes;
      // A row a is added as it is, and its partner b as i b; both have conjugate halves
      for (int k = 0; k < this->Size[0]; ++k)
      {
        const bool mirrored = k >= half;
        const int frequency = mirrored ? this->Size[0] - k : k;
        const std::size_t from = frequency / Lanes * ofBlock + frequency % Lanes;
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
    Plane plane;
    std::vector<double> values;
    for (int rank = 0; rank < ranks.Size(); ++rank)
    {
      const std::size_t count = this->NumberOfColumns(rank);
      const double* from = incoming[rank].data() + (z - begin) * 2 * count;
      plane.Real.insert(plane.Real.end(), from, from + count);
      plane.Imaginary.insert(plane.Imaginary.end(), from + count, from + 2 * count);
    }
    this->InvertPlane(plane, last, values);
#pragma omp critical(ruc_fourier_visit)
    visit(static_cast<int>(z), values);
  }
}
}
