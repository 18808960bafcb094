// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/TwoPointProbability.h"

#include "FixedPoint.h"
#include "Geometry/CellList.h"
#include "Geometry/SphereOverlap.h"
#include "Statistics/OnePointProbability.h"
#include "Statistics/PairHistogram.h"
#include "Statistics/PairLoops.h"
#include "Text.h"
#include "VectorClones.h"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ruc
{
TwoPointProbability::TwoPointProbability(int modes, const LagGrid& lags)
  : Modes(modes)
  , Lags(lags)
  , Fractions(modes + 1, 0.0)
  , Values((modes + 1) * (modes + 2) / 2, std::vector<double>(lags.Count + 1, 0.0))
{
}

int TwoPointProbability::PairOf(int r, int s) const
{
  const int low = std::min(r, s);
  return low * this->Phases() - low * (low - 1) / 2 + std::max(r, s) - low;
}

void TwoPointProbability::CompleteMatrix()
{
  const int m = this->Modes;
  double particles = 0.0;
  for (int r = 0; r < m; ++r)
  {
    particles += this->Fractions[r];
  }
  this->Fractions[m] = 1.0 - particles;
  std::vector<double>& matrix = this->S(m, m);
  matrix.assign(this->Lags.Count + 1, 1.0 - 2.0 * particles);
  for (int r = 0; r < m; ++r)
  {
    std::vector<double>& mixed = this->S(r, m);
    mixed.assign(this->Lags.Count + 1, this->Fractions[r]);
    for (int s = 0; s < m; ++s)
    {
      const std::vector<double>& pair = this->S(r, s);
      for (int k = 0; k <= this->Lags.Count; ++k)
      {
        mixed[k] -= pair[k];
        matrix[k] += pair[k];
      }
    }
  }
}

std::string TwoPointProbability::PhaseName(int phase) const
{
  return phase == this->Modes ? "m" : std::to_string(phase + 1);
}

double DiscreteNorm(const std::vector<double>& values)
{
  double sum = 0.0;
  for (std::size_t k = 1; k < values.size(); ++k)
  {
    sum += values[k] * values[k];
  }
  return std::sqrt(sum);
}

double TwoPointDifference(const TwoPointProbability& a, const TwoPointProbability& b)
{
  double total = 0.0;
  std::vector<double> difference(a.Lags.Count + 1);
  for (int r = 0; r < a.Phases(); ++r)
  {
    for (int s = r; s < a.Phases(); ++s)
    {
      std::transform(
        a.S(r, s).begin(), a.S(r, s).end(), b.S(r, s).begin(), difference.begin(), std::minus<>());
      total += (r == s ? 1.0 : 2.0) * DiscreteNorm(difference);
    }
  }
  return total;
}

namespace
{
constexpr std::size_t ChunkOfCentres = 64;
// With more types than this, or a histogram larger than fits a cache, tables for all pairs of types
// no longer pay
constexpr std::size_t MostTypes = 256;
constexpr double LargestHistogram = 1 << 21;

// A lower bound of the set covariance over all displacements of a length up to `reach`. The cube
// root of the set covariance of a convex window is concave, so its least value over a polytope is
// at a corner; this one holds the ball: no component above reach, no two together above sqrt(2)
// reach, no three above sqrt(3) reach.
double LeastSetCovariance(const Window& window, double reach)
{
  const double steps[3] = { reach, (std::sqrt(2.0) - 1.0) * reach,
    (std::sqrt(3.0) - std::sqrt(2.0)) * reach };
  double least = window.Volume();
  if (window.GetShape() == Window::Shape::Cylinder)
  {
    const Vector3& a = window.Axis;
    // a direction across the axis
    Vector3 b = std::abs(a[0]) < 0.5 ? Vector3{ 0.0, a[2], -a[1] } : Vector3{ a[1], -a[0], 0.0 };
    const double length = std::hypot(b[0], b[1], b[2]);
    for (int along : { 0, 1 })
    {
      const double x = steps[along], y = steps[1 - along] / length;
      least = std::min(
        least, window.SetCovariance(x * a[0] + y * b[0], x * a[1] + y * b[1], x * a[2] + y * b[2]));
    }
    return least;
  }
  int order[3] = { 0, 1, 2 };
  do
  {
    least =
      std::min(least, window.SetCovariance(steps[order[0]], steps[order[1]], steps[order[2]]));
  } while (std::next_permutation(order, order + 3));
  return least;
}

// Every type of sphere that occurs, once and in order
std::vector<SphereType> FindTypes(const SpherePack& pack)
{
  std::vector<SphereType> types;
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    types.push_back({ pack.Mode[i], pack.Radius[i] });
  }
  std::sort(types.begin(), types.end());
  types.erase(std::unique(types.begin(), types.end()), types.end());
  return types;
}
}

// What the tabulated and the direct sum share
class ExactPairSum::Method
{
public:
  Method(const SpherePack& pack, const Window& window, const LagGrid& lags,
    std::vector<SphereType> types)
    : Pack(pack)
    , Observed(window)
    , Lags(lags)
    , Types(std::move(types))
  {
    WrapIntoBox(this->Pack, window);
  }
  virtual ~Method() = default;

  virtual std::size_t SumsSize() const = 0;
  virtual void AddChunk(std::size_t begin, std::size_t end, std::int64_t* sums) const = 0;
  // S_rs x V of the pairs i != j
  virtual void AddPairs(
    const std::vector<std::int64_t>& sums, TwoPointProbability& result) const = 0;

  void MakeCells(double cutoff)
  {
    this->Cells = std::make_unique<CellList>(this->Pack, this->Observed, cutoff);
    this->HeaviestPair = this->Observed.IsFullyPeriodic()
      ? 1.0
      : this->Observed.Volume() / LeastSetCovariance(this->Observed, cutoff);
  }

  TwoPointProbability Result(const std::vector<std::int64_t>& sums) const
  {
    TwoPointProbability result(this->Pack.NumberOfModes(), this->Lags);
    result.Fractions = OnePointProbability(this->Pack, this->Observed);
    this->AddPairs(sums, result);
    // The sphere with itself
    std::vector<std::size_t> spheres(this->Types.size(), 0);
    for (std::size_t i = 0; i < this->Pack.Size(); ++i)
    {
      ++spheres[this->TypeOf(i)];
    }
    for (std::size_t t = 0; t < this->Types.size(); ++t)
    {
      const SphereType& type = this->Types[t];
      std::vector<double>& s = result.S(type.Mode - 1, type.Mode - 1);
      for (int k = 0; k <= this->Lags.Count && k * this->Lags.Spacing < 2.0 * type.Radius; ++k)
      {
        s[k] += spheres[t] * LensVolume(type.Radius, type.Radius, k * this->Lags.Spacing);
      }
    }
    for (std::vector<double>& values : result.Values)
    {
      for (double& value : values)
      {
        value /= this->Observed.Volume();
      }
    }
    result.CompleteMatrix();
    return result;
  }

  std::size_t TypeOf(std::size_t i) const
  {
    const SphereType type = { this->Pack.Mode[i], this->Pack.Radius[i] };
    return std::lower_bound(this->Types.begin(), this->Types.end(), type) - this->Types.begin();
  }

  SpherePack Pack;
  Window Observed;
  LagGrid Lags;
  std::vector<SphereType> Types;
  std::unique_ptr<CellList> Cells;
  double HeaviestPair = 1.0; // V / gamma
};

// Few types: a histogram of the distances for every pair of types
class ExactPairSum::Tabulated : public ExactPairSum::Method
{
public:
  Tabulated(const SpherePack& pack, const Window& window, const LagGrid& lags,
    std::vector<SphereType> types)
    : Method(pack, window, lags, std::move(types))
    , Histogram(this->Types, lags)
  {
    this->MakeCells(this->Histogram.GetCutoff());
    this->Scale = PairHistogram::FixedPointScale(
      pack.Size(), this->Cells->MostNeighbours(), this->HeaviestPair);
    for (std::uint32_t i : this->Cells->Index)
    {
      this->TypeOfPlace.push_back(static_cast<std::int32_t>(this->TypeOf(i)));
    }
  }

  std::size_t SumsSize() const override { return this->Histogram.Size(); }

  void AddChunk(std::size_t begin, std::size_t end, std::int64_t* sums) const override
  {
    CountPairs(this->Histogram, *this->Cells, this->TypeOfPlace, this->Observed, this->Scale, begin,
      end, sums);
  }

  void AddPairs(const std::vector<std::int64_t>& sums, TwoPointProbability& result) const override
  {
    for (int c = 0; c < this->Histogram.NumberOfClasses(); ++c)
    {
      const PairKernel& kernel = this->Histogram.Kernel(c);
      const int r = this->Histogram.LowerType(c).Mode - 1;
      const int s = this->Histogram.HigherType(c).Mode - 1;
      // Within a mode both orders of a pair count.
      const double factor = (r == s ? 2.0 : 1.0) / this->Scale;
      std::vector<double> weights(kernel.Size());
      std::transform(sums.begin() + this->Histogram.Begin(c),
        sums.begin() + this->Histogram.Begin(c + 1), weights.begin(),
        [&](std::int64_t sum) { return factor * sum; });
      kernel.AddOverlap(weights.data(), result.S(r, s).data());
    }
  }

private:
  PairHistogram Histogram;
  std::vector<std::int32_t> TypeOfPlace;
  double Scale;
};

namespace
{
// Adds factor x h_ab(d - r_k) or, for overlapping spheres, factor x [h_ab(d - r_k) - h_ab(d +
// r_k)], k = 1…K
RUC_VECTOR_CLONES
void AddOverlapMoments(
  double a, double b, double d, double factor, const LagGrid& lags, double* sums)
{
  const double contact = a + b;
  const double difference = std::abs(a - b);
  const double product = 4.0 * a * b;
  const auto add = [&](double sign, double centre)
  {
    const int from = std::max(1, static_cast<int>(std::ceil((centre - contact) / lags.Spacing)));
    const int to = std::min(lags.Count, static_cast<int>((centre + contact) / lags.Spacing));
    for (int k = from; k <= to; ++k)
    {
      const double t = std::abs(k * lags.Spacing - centre);
      const double u = std::max(contact - t, 0.0);
      const double v = std::max(difference - t, 0.0);
      sums[k] += sign *
        (u * u * u * (product - contact * u + 0.2 * u * u) +
          v * v * v * (product + difference * v - 0.2 * v * v));
    }
  };
  const double scaled = factor * 3.14159265358979323846 / 12.0;
  add(scaled, d);
  if (d < contact)
  {
    add(-scaled, -d);
  }
}
}

// Many types: the closed form for every pair and lag
class ExactPairSum::Direct : public ExactPairSum::Method
{
public:
  Direct(const SpherePack& pack, const Window& window, const LagGrid& lags,
    std::vector<SphereType> types)
    : Method(pack, window, lags, std::move(types))
    , Pairs(pack.NumberOfModes(), lags)
  {
    this->MakeCells(lags.Maximum() + 2.0 * pack.LargestRadius());
    // A chunk adds one number for each pair of phases and lag: in units of the largest sphere's
    // volume, which no overlap exceeds, at most twice the weight of all its pairs.
    const std::int64_t chunks = static_cast<std::int64_t>(pack.Size() / ChunkOfCentres) + 1;
    this->Unit = SphereVolume(pack.LargestRadius());
    this->Scale = PairHistogram::FixedPointScale(
      chunks, 1, 2.0 * ChunkOfCentres * this->Cells->MostNeighbours() * this->HeaviestPair);
  }

  std::size_t SumsSize() const override
  {
    return this->Pairs.Values.size() * (this->Lags.Count + 1);
  }

  void AddChunk(std::size_t begin, std::size_t end, std::int64_t* sums) const override
  {
    const CellList& cells = *this->Cells;
    const std::size_t stride = this->Lags.Count + 1;
    std::vector<double> moments(this->SumsSize(), 0.0); // sum of 2 r g, and of g at r = 0
    std::vector<CellList::Range> ranges;
    for (std::size_t i = begin; i < end; ++i)
    {
      const std::size_t first = cells.Index[i];
      cells.FindRanges(i, ranges);
      for (const CellList::Range& range : ranges)
      {
        for (std::size_t j = range.Begin; j < range.End; ++j)
        {
          const double dx = cells.X[j] - range.X, dy = cells.Y[j] - range.Y,
                       dz = cells.Z[j] - range.Z;
          const double d = std::sqrt(dx * dx + dy * dy + dz * dz);
          const std::size_t second = cells.Index[j];
          const double a = this->Pack.Radius[first], b = this->Pack.Radius[second];
          if (d >= this->Lags.Maximum() + a + b)
          {
            continue;
          }
          const double weight = this->Observed.IsFullyPeriodic()
            ? 1.0
            : this->Observed.Volume() / this->Observed.SetCovariance(dx, dy, dz);
          const int r = this->Pack.Mode[first] - 1, s = this->Pack.Mode[second] - 1;
          const double factor = (r == s ? 2.0 : 1.0) * weight;
          double* pairMoments = &moments[this->Pairs.PairOf(r, s) * stride];
          AddOverlapMoments(a, b, d, factor / d, this->Lags, pairMoments);
          pairMoments[0] += factor * LensVolume(a, b, d);
        }
      }
    }
    for (std::size_t n = 0; n < moments.size(); ++n)
    {
      const std::size_t k = n % stride;
      const double value = k == 0 ? moments[n] : moments[n] / (2.0 * k * this->Lags.Spacing);
      sums[n] += RoundToFixedPoint(value / this->Unit * this->Scale);
    }
  }

  void AddPairs(const std::vector<std::int64_t>& sums, TwoPointProbability& result) const override
  {
    const std::size_t stride = this->Lags.Count + 1;
    for (std::size_t n = 0; n < sums.size(); ++n)
    {
      result.Values[n / stride][n % stride] += sums[n] / this->Scale * this->Unit;
    }
  }

private:
  TwoPointProbability Pairs; // for its numbering of pairs
  double Unit;
  double Scale;
};

ExactPairSum::ExactPairSum(const SpherePack& pack, const Window& window, const LagGrid& lags)
{
  if (lags.Count < 1 || lags.Count > MostLags)
  {
    throw std::invalid_argument(
      Text("NumberOfLags requires 1 <= NumberOfLags <= ", MostLags, ", got ", lags.Count, "."));
  }
  constexpr double mostNumbers = 5e7; // of all functions, 400 MB
  const double pairs = 0.5 * (pack.NumberOfModes() + 1.0) * (pack.NumberOfModes() + 2.0);
  if (pairs * (lags.Count + 1.0) > mostNumbers)
  {
    throw std::invalid_argument(
      Text("NumberOfLags requires at most ", static_cast<int>(mostNumbers / pairs), " lags for ",
        pack.NumberOfModes(), " modes, got ", lags.Count, "."));
  }
  const double largest = LargestLag(pack, window);
  if (!(largest > 0.0))
  {
    throw std::invalid_argument(
      Text("The window requires edges longer than the largest sphere's diameter, ",
        2.0 * pack.LargestRadius(), ", got a ", window.Describe(), "."));
  }
  if (!(lags.Maximum() > 0.0 && lags.Maximum() <= largest * (1.0 + 1e-12)))
  {
    throw std::invalid_argument(Text("MaximumLag requires 0 < MaximumLag <= ", largest,
      " for this ", window.Describe(), " and spheres of up to ", 2.0 * pack.LargestRadius(),
      " diameter, got ", lags.Maximum(), "."));
  }
  std::vector<SphereType> types = FindTypes(pack);
  if (types.size() <= MostTypes && PairHistogram::EstimateSize(types, lags) <= LargestHistogram)
  {
    this->Sum = std::make_unique<Tabulated>(pack, window, lags, std::move(types));
  }
  else
  {
    this->Sum = std::make_unique<Direct>(pack, window, lags, std::move(types));
  }
}

ExactPairSum::~ExactPairSum() = default;

double ExactPairSum::LargestLag(const SpherePack& pack, const Window& window)
{
  return window.IsFullyPeriodic() ? 4.0 * window.ShortestEdge()
                                  : (window.Reach() - 2.0 * pack.LargestRadius()) * 0.999;
}

std::size_t ExactPairSum::NumberOfChunks() const
{
  return (this->Sum->Cells->Size() + ChunkOfCentres - 1) / ChunkOfCentres;
}

std::size_t ExactPairSum::SumsSize() const
{
  return this->Sum->SumsSize();
}

void ExactPairSum::AddChunks(std::size_t first, std::size_t stride, std::int64_t* sums,
  const std::function<void(double)>& progress) const
{
  const std::int64_t chunks = static_cast<std::int64_t>(this->NumberOfChunks());
  const std::size_t centres = this->Sum->Cells->Size();
#pragma omp parallel
  {
    std::vector<std::int64_t> own(this->SumsSize(), 0);
#pragma omp for schedule(dynamic) nowait
    for (std::int64_t chunk = static_cast<std::int64_t>(first); chunk < chunks;
         chunk += static_cast<std::int64_t>(stride))
    {
      this->Sum->AddChunk(
        chunk * ChunkOfCentres, std::min((chunk + 1) * ChunkOfCentres, centres), own.data());
      if (progress && omp_get_thread_num() == 0)
      {
        progress(double(chunk) / chunks);
      }
    }
#pragma omp critical
    std::transform(own.begin(), own.end(), sums, sums, std::plus<>());
  }
}

TwoPointProbability ExactPairSum::Result(const std::vector<std::int64_t>& sums) const
{
  return this->Sum->Result(sums);
}
}
