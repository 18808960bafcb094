// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/ThirdOrder/MultipoleSums.h"

#include "ruc/Base/FixedPoint.h"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ruc
{
namespace
{
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

int Place(double share, int count)
{
  return std::clamp(static_cast<int>(share * count), 0, count - 1);
}
}

std::size_t PlaceOfTriple(int phases, int q, int r, int s)
{
  const int low = std::min(r, s), high = std::max(r, s);
  const std::size_t pairs = static_cast<std::size_t>(phases) * (phases + 1) / 2;
  return q * pairs + low * phases - low * (low - 1) / 2 + high - low;
}

CentreRegion::CentreRegion(
  const Window& observed, double margin, const ThirdOrderSettings& settings)
  : Region(observed.Shrunk(margin))
  , Bounds(Region.GetBounds())
  , NumberOfSlabs(settings.Slabs)
{
  const double width = std::cbrt(this->Bounds.Volume() / settings.Blocks);
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Divisions[axis] =
      std::max(static_cast<int>(std::lround(this->Bounds.Size[axis] / width)), 1);
  }
}

int CentreRegion::NumberOfBlocks() const
{
  return this->Divisions[0] * this->Divisions[1] * this->Divisions[2];
}

int CentreRegion::BlockOf(const Vector3& centre) const
{
  int block = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double share = (centre[axis] - this->Bounds.Origin[axis]) / this->Bounds.Size[axis];
    block = block * this->Divisions[axis] + Place(share, this->Divisions[axis]);
  }
  return block;
}

// The place along an axis, or along that of a cylinder from its base on
double CentreRegion::Along(const Vector3& centre, int axis) const
{
  const Vector3& base = this->Region.Base;
  return this->NumberOfAxes() == 3
    ? centre[axis]
    : Dot({ centre[0] - base[0], centre[1] - base[1], centre[2] - base[2] }, this->Region.Axis);
}

double CentreRegion::Low(int axis) const
{
  return this->NumberOfAxes() == 3 ? this->Bounds.Origin[axis] : 0.0;
}

double CentreRegion::Length(int axis) const
{
  return this->NumberOfAxes() == 3 ? this->Bounds.Size[axis] : this->Region.Height;
}

int CentreRegion::SlabOf(const Vector3& centre, int axis) const
{
  return Place(
    (this->Along(centre, axis) - this->Low(axis)) / this->Length(axis), this->NumberOfSlabs);
}

ThirdOrderOfSpheres::Slab CentreRegion::MakeSlab(int axis, int n) const
{
  const double low = this->Low(axis), step = this->Length(axis) / this->NumberOfSlabs;
  return { this->NumberOfAxes() == 3 ? axis : 3, low + n * step, low + (n + 1) * step, 0,
    NotANumber, { NotANumber, NotANumber } };
}

SumLayout::SumLayout(int sources, int degrees, const CentreRegion& region)
  : Triples(NumberOfTriples(sources))
  , Degrees(degrees)
  , BlockSize(1 + Degrees + 2 * Triples)
  , Blocks(region.NumberOfBlocks())
  , Slabs(static_cast<std::size_t>(region.NumberOfAxes()) * region.GetSlabs())
{
}

// A centre weighs 1 at most, and the mean of F : F in it is some thousand at most
class MultipoleSums::FixedPoint
{
public:
  explicit FixedPoint(std::size_t size)
    : Limbs(2 * size, 0)
  {
  }
  static std::int64_t Of(double value)
  {
    return RoundToFixedPoint(std::clamp(value, -Most, Most) * Scale);
  }
  void Add(std::size_t place, double value) { AddWide(Of(value), &this->Limbs[2 * place]); }
  std::vector<std::int64_t> Limbs;

  static constexpr double Most = 4096.0;
  static constexpr double Scale = 274877906944.0; // 2^38
};

MultipoleSums::MultipoleSums(const PackShare& share, const std::vector<int>& source,
  const MultipoleSettings& settings, const CentreRegion& region, const SumLayout& layout,
  Communicator& ranks)
  : Field(share.Own.Size(), NotANumber)
  , Share(share)
  , Source(source)
  , Region(region)
  , Layout(layout)
  , Multipoles(settings)
  , Products(Multipoles)
  , Around(share, settings.CutOff, ranks)
  , Weight(1.0 / std::pow(share.LargestRadius, 3))
{
  for (std::size_t i = 0; i < this->Around.Size(); ++i)
  {
    if (region.GetRegion().Contains(share.Own.Centre(this->Around.PlaceOf(i))))
    {
      this->Centres.push_back(i);
    }
  }
  if (settings.Alpha > 0.0)
  {
    this->Ewald.emplace(share, source, settings, ranks);
  }
}

std::vector<double> MultipoleSums::Sum(
  Communicator& ranks, const std::function<void(double)>& progress)
{
  std::vector<std::int64_t> total(2 * this->Layout.Size(), 0);
  constexpr int block = ThirdOrderEwald::Block;
  const std::int64_t blocks = (this->Centres.size() + block - 1) / block;
#pragma omp parallel
  {
    FixedPoint own(this->Layout.Size());
    LocalMultipoles::Neighbours around(this->Multipoles.GetSettings());
    std::vector<double> sums(block * this->Multipoles.Size());
#pragma omp for schedule(dynamic) nowait
    for (std::int64_t b = 0; b < blocks; ++b)
    {
      const std::size_t begin = b * block;
      this->AddBlock(begin, std::min(begin + block, this->Centres.size()), around, sums, own);
      if (progress && omp_get_thread_num() == 0)
      {
        progress(double(b) / blocks);
      }
    }
#pragma omp critical
    std::transform(own.Limbs.begin(), own.Limbs.end(), total.begin(), total.begin(), std::plus<>());
  }
  ranks.Sum(total.data(), total.size());
  std::vector<double> values(this->Layout.Size());
  for (std::size_t n = 0; n < values.size(); ++n)
  {
    values[n] = WideValue(&total[2 * n]) / FixedPoint::Scale;
  }
  return values;
}

void MultipoleSums::AddBlock(std::size_t begin, std::size_t end,
  LocalMultipoles::Neighbours& around, std::vector<double>& sums, FixedPoint& own)
{
  const int count = static_cast<int>(end - begin);
  std::vector<std::size_t> places(count);
  std::vector<Rests> rests(count);
  for (int n = 0; n < count; ++n)
  {
    places[n] = this->Around.PlaceOf(this->Centres[begin + n]);
    rests[n] = this->Gather(this->Centres[begin + n], around);
    this->Multipoles.Sum(around, &sums[n * this->Multipoles.Size()]);
  }
  if (this->Ewald)
  {
    this->Ewald->Add(places.data(), count, this->Multipoles, sums.data());
  }
  for (int n = 0; n < count; ++n)
  {
    this->AddCentre(places[n], &sums[n * this->Multipoles.Size()], rests[n], own);
  }
}

// Collects the spheres around a centre, and the rests of those that are near
MultipoleSums::Rests MultipoleSums::Gather(std::size_t i, LocalMultipoles::Neighbours& around) const
{
  const MultipoleSettings& settings = this->Multipoles.GetSettings();
  const double radius = this->Share.Own.Radius[this->Around.PlaceOf(i)];
  Rests rests(settings.Sources, { 0, 0 });
  around.Start(radius);
  this->Around.ForEachAround(i,
    [&](const PairNeighbourhood::Part& part, std::size_t j, double dx, double dy, double dz,
      double d2)
    {
      const double other = part.Pack.Radius[j];
      const int source = settings.Sources > 1 ? part.Pack.Mode[j] - 1 : 0;
      around.Add(dx, dy, dz, d2, other, source);
      const double touching = radius + other;
      if (d2 > 9.0 * touching * touching)
      {
        return; // Its rest is none, and not to look for it is quicker
      }
      const MultipoleRest rest = FindMultipoleRest(
        radius * radius / d2, other / radius, settings.Degree, settings.WithFourth);
      rests[source][0] += FixedPoint::Of(rest.Second);
      rests[source][1] += FixedPoint::Of(rest.Fourth);
    });
  return rests;
}

void MultipoleSums::AddCentre(
  std::size_t place, const double* sums, const Rests& rests, FixedPoint& own)
{
  const SumLayout& layout = this->Layout;
  const int sources = this->Multipoles.GetSettings().Sources, q = this->Source[place];
  const double weight = this->Weight * std::pow(this->Share.Own.Radius[place], 3);
  const Vector3 centre = this->Share.Own.Centre(place);
  const std::size_t number = this->Region.BlockOf(centre), block = number * layout.BlockSize;
  std::vector<double> spectrum(layout.Degrees);
  double field = 0.0;
  for (int s = 0; s < sources; ++s)
  {
    for (int t = s; t < sources; ++t)
    {
      this->Products.Second(sums, s, t, spectrum.data());
      spectrum.back() = s == t ? rests[s][0] / FixedPoint::Scale : 0.0;
      const double fourth =
        this->Products.Fourth(sums, s, t) + (s == t ? rests[s][1] / FixedPoint::Scale : 0.0);
      const double second = std::accumulate(spectrum.begin(), spectrum.end(), 0.0);
      const double times = s == t ? 1.0 : 2.0; // of the pair among ordered ones
      const std::size_t triple = PlaceOfTriple(sources, q, s, t);
      field += times * second;
      own.Add(block + layout.Second() + triple, weight * second);
      own.Add(block + layout.Fourth() + triple, weight * fourth);
      for (std::size_t n = 0; n < layout.Degrees; ++n)
      {
        own.Add(block + layout.Spectrum() + n, weight * times * spectrum[n]);
        own.Add(layout.TripleSpectrum(triple) + n, weight * spectrum[n]);
      }
    }
  }
  own.Add(block + layout.Weight(), weight);
  for (int axis = 0; axis < this->Region.NumberOfAxes(); ++axis)
  {
    const std::size_t slab = axis * this->Region.GetSlabs() + this->Region.SlabOf(centre, axis);
    own.Add(layout.Slab(slab, number), weight);
    own.Add(layout.Slab(slab, number) + 1, weight * field);
    own.Add(layout.Slab(slab, number) + 2, 1.0);
  }
  this->Field[place] = field;
}
}
