// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/PairSums/ExactPairSum.h"

#include "ruc/Base/FixedPointSums.h"
#include "ruc/Base/Text.h"
#include "ruc/Base/Vector3.h"
#include "ruc/Base/VectorClones.h"
#include "ruc/Particles/PairNeighbourhood.h"
#include "ruc/Particles/SphereOverlap.h"
#include "ruc/Statistics/PairSums/PairHistogram.h"
#include "ruc/Statistics/PairSums/PairLoops.h"
#include "ruc/Statistics/Results/LagLimit.h"
#include "ruc/Statistics/Results/OnePointProbability.h"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

namespace ruc
{
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

// Every type of sphere that occurs on any rank, once and in order; more than MostTypes where there
// are more, but not all of them
std::vector<SphereType> FindTypes(const SpherePack& own, Communicator& ranks)
{
  std::set<SphereType> types;
  for (std::size_t i = 0; i < own.Size() && types.size() <= MostTypes; ++i)
  {
    types.insert({ own.Mode[i], own.Radius[i] });
  }
  std::vector<double> numbers;
  for (const SphereType& type : types)
  {
    numbers.insert(numbers.end(), { double(type.Mode), type.Radius });
  }
  for (const std::vector<double>& others :
    ranks.Exchange(std::vector<std::vector<double>>(ranks.Size(), numbers)))
  {
    for (std::size_t n = 0; n < others.size(); n += 2)
    {
      types.insert({ static_cast<int>(others[n]), others[n + 1] });
    }
  }
  return { types.begin(), types.end() };
}
}

// What the tabulated and the direct sum share
class ExactPairSum::Method
{
public:
  Method(const PackShare& share, const LagGrid& lags, double cutoff, Communicator& ranks)
    : Totals(share)
    , Lags(lags)
    , Pairs(share, cutoff, ranks)
  {
    const Window& window = share.Observed;
    const double heaviest =
      window.IsFullyPeriodic() ? 1.0 : window.Volume() / LeastSetCovariance(window, cutoff);
    this->Scale = std::ldexp(1.0, FixedPointSums::TermBits - 2 - std::ilogb(heaviest));
    // So many centres' pairs are added before the sums look whether they have to carry
    const std::int64_t neighbours = std::max<std::int64_t>(this->Pairs.MostNeighbours() + 1, 1);
    ranks.ThrowIfAny(neighbours <= FixedPointSums::MostTerms
        ? ""
        : Text("MaximumLag requires fewer than ", FixedPointSums::MostTerms,
            " spheres around one, got a MaximumLag of ", lags.Maximum(), "."));
    this->Step = static_cast<std::size_t>(
      std::clamp<std::int64_t>(FixedPointSums::MostTerms / neighbours, 1, ChunkOfCentres));
    this->TermsOfStep = neighbours * static_cast<std::int64_t>(this->Step);
  }
  virtual ~Method() = default;

  // Numbers summed in fixed point
  virtual std::size_t SumsSize() const = 0;
  // Whole numbers summed beside them
  virtual std::size_t CountsSize() const { return 0; }
  // Adds the pairs of own centres
  virtual void Add(
    std::size_t begin, std::size_t end, std::int64_t* sums, std::int64_t* counts) const = 0;
  // S_rs x V of the particles
  virtual void AddResult(
    const double* sums, const std::int64_t* counts, TwoPointProbability& result) const = 0;

  TwoPointProbability Result(const std::vector<std::int64_t>& sums) const
  {
    TwoPointProbability result(this->Totals.NumberOfModes(), this->Lags);
    const double volume = this->Totals.Observed.Volume();
    result.Fractions = OnePointProbability(this->Totals);
    std::vector<double> values(this->SumsSize());
    for (std::size_t n = 0; n < values.size(); ++n)
    {
      values[n] = WideValue(&sums[2 * n]) / this->Scale;
    }
    this->AddResult(values.data(), sums.data() + 2 * values.size(), result);
    for (std::vector<double>& s : result.Values)
    {
      for (double& value : s)
      {
        value /= volume;
      }
    }
    result.CompleteMatrix();
    return result;
  }

  PackTotals Totals;
  LagGrid Lags;
  PairNeighbourhood Pairs;
  double Scale; // twice the weight of a pair is at most 2^TermBits
  std::size_t Step;
  std::int64_t TermsOfStep;
};

// Few types: a histogram of the distances for every pair of types
class ExactPairSum::Tabulated : public ExactPairSum::Method
{
public:
  Tabulated(const PackShare& share, const LagGrid& lags, const std::vector<SphereType>& types,
    Communicator& ranks)
    : Method(share, lags, lags.Maximum() + 2.0 * share.LargestRadius, ranks)
    , Types(types)
    , Histogram(types, lags)
  {
    for (const PairNeighbourhood::Part& part : this->Pairs.Parts)
    {
      std::vector<std::int32_t> typeOfPlace;
      for (std::uint32_t i : part.Cells.Index)
      {
        const SphereType type = { part.Pack.Mode[i], part.Pack.Radius[i] };
        typeOfPlace.push_back(static_cast<std::int32_t>(
          std::lower_bound(types.begin(), types.end(), type) - types.begin()));
      }
      this->TypeOfPlace.push_back(std::move(typeOfPlace));
    }
  }

  std::size_t SumsSize() const override { return this->Histogram.Size(); }
  std::size_t CountsSize() const override { return this->Types.size(); }

  void Add(
    std::size_t begin, std::size_t end, std::int64_t* sums, std::int64_t* counts) const override
  {
    CountPairs(this->Histogram, this->Pairs, this->TypeOfPlace, this->Totals.Observed, this->Scale,
      begin, end, sums);
    for (std::size_t i = begin; i < end; ++i)
    {
      ++counts[this->TypeOfPlace.front()[i]];
    }
  }

  void AddResult(
    const double* sums, const std::int64_t* counts, TwoPointProbability& result) const override
  {
    for (int c = 0; c < this->Histogram.NumberOfClasses(); ++c)
    {
      const PairKernel& kernel = this->Histogram.Kernel(c);
      const int r = this->Histogram.LowerType(c).Mode - 1;
      const int s = this->Histogram.HigherType(c).Mode - 1;
      // Within a mode both orders of a pair count.
      const double factor = r == s ? 2.0 : 1.0;
      std::vector<double> weights(kernel.Size());
      std::transform(sums + this->Histogram.Begin(c), sums + this->Histogram.Begin(c + 1),
        weights.begin(), [&](double sum) { return factor * sum; });
      kernel.AddOverlap(weights.data(), result.S(r, s).data());
    }
    // The sphere with itself
    for (std::size_t t = 0; t < this->Types.size(); ++t)
    {
      const SphereType& type = this->Types[t];
      std::vector<double>& s = result.S(type.Mode - 1, type.Mode - 1);
      for (int k = 0; k <= this->Lags.Count && k * this->Lags.Spacing < 2.0 * type.Radius; ++k)
      {
        s[k] += counts[t] * LensVolume(type.Radius, type.Radius, k * this->Lags.Spacing);
      }
    }
  }

private:
  std::vector<SphereType> Types;
  PairHistogram Histogram;
  std::vector<std::vector<std::int32_t>> TypeOfPlace; // of every part
};

namespace
{
// Adds factor x g_ab(r_k; d), k = 1…K, to integers; inverse[k] = 1 / (2 r_k)
RUC_VECTOR_CLONES
void AddOverlap(double a, double b, double d, double factor, const LagGrid& lags,
  const double* inverse, std::int64_t* sums)
{
  const double contact = a + b;
  const double difference = std::abs(a - b);
  const double product = 4.0 * a * b;
  const auto moment = [&](double t)
  {
    const double u = std::max(contact - t, 0.0);
    const double v = std::max(difference - t, 0.0);
    return u * u * u * (product - contact * u + 0.2 * u * u) +
      v * v * v * (product + difference * v - 0.2 * v * v);
  };
  const double scaled = factor / d * Pi / 12.0;
  // 2 d r g = h(d - r) - h(d + r), the latter only for overlapping spheres
  const int last = std::min(lags.Count, static_cast<int>((d + contact) / lags.Spacing));
  if (d < contact)
  {
    for (int k = 1; k <= last; ++k)
    {
      const double r = k * lags.Spacing;
      sums[k] += RoundToFixedPoint(scaled * inverse[k] * (moment(std::abs(d - r)) - moment(d + r)));
    }
    return;
  }
  const int first = std::max(1, static_cast<int>(std::ceil((d - contact) / lags.Spacing)));
  for (int k = first; k <= last; ++k)
  {
    sums[k] += RoundToFixedPoint(scaled * inverse[k] * moment(std::abs(d - k * lags.Spacing)));
  }
}
}

// Many types: the closed form for every pair and lag
class ExactPairSum::Direct : public ExactPairSum::Method
{
public:
  Direct(const PackShare& share, const LagGrid& lags, Communicator& ranks)
    : Method(share, lags, lags.Maximum() + 2.0 * share.LargestRadius, ranks)
    , Numbering(share.NumberOfModes(), lags)
    , Unit(SphereVolume(share.LargestRadius))
  {
    for (int k = 0; k <= lags.Count; ++k)
    {
      this->Inverse.push_back(k > 0 ? 0.5 / (k * lags.Spacing) : 0.0);
    }
  }

  std::size_t SumsSize() const override
  {
    return this->Numbering.Values.size() * (this->Lags.Count + 1);
  }

  // An overlap is at most the largest sphere's volume, the unit of these sums.
  void Add(std::size_t begin, std::size_t end, std::int64_t* sums, std::int64_t*) const override
  {
    const SpherePack& own = this->Pairs.Parts.front().Pack;
    const Window& window = this->Totals.Observed;
    const double scale = this->Scale / this->Unit;
    for (std::size_t place = begin; place < end; ++place)
    {
      const std::size_t i = this->Pairs.Own().Index[place];
      const double radius = own.Radius[i];
      std::int64_t* self = this->SumsOf(own.Mode[i], own.Mode[i], sums);
      for (int k = 0; k <= this->Lags.Count && k * this->Lags.Spacing < 2.0 * radius; ++k)
      {
        self[k] += RoundToFixedPoint(scale * LensVolume(radius, radius, k * this->Lags.Spacing));
      }
    }
    this->Pairs.ForEachPair(begin, end,
      [&](std::size_t i, const PairNeighbourhood::Part& part, std::size_t j, double dx, double dy,
        double dz, double d2)
      {
        const double d = std::sqrt(d2);
        const double a = own.Radius[i], b = part.Pack.Radius[j];
        if (d >= this->Lags.Maximum() + a + b)
        {
          return;
        }
        // Within a mode both orders of a pair count.
        const double orders = own.Mode[i] == part.Pack.Mode[j] ? 2.0 : 1.0;
        const double factor = scale * orders *
          (window.IsFullyPeriodic() ? 1.0 : window.Volume() / window.SetCovariance(dx, dy, dz));
        // The spheres in one order, whichever rank meets them: rounding is not symmetric
        const double lesser = std::min(a, b), greater = std::max(a, b);
        std::int64_t* pair = this->SumsOf(own.Mode[i], part.Pack.Mode[j], sums);
        pair[0] += RoundToFixedPoint(factor * LensVolume(lesser, greater, d));
        AddOverlap(lesser, greater, d, factor, this->Lags, this->Inverse.data(), pair);
      });
  }

  void AddResult(
    const double* sums, const std::int64_t*, TwoPointProbability& result) const override
  {
    const std::size_t stride = this->Lags.Count + 1;
    for (std::size_t n = 0; n < this->SumsSize(); ++n)
    {
      result.Values[n / stride][n % stride] += sums[n] * this->Unit;
    }
  }

private:
  std::int64_t* SumsOf(int modeA, int modeB, std::int64_t* sums) const
  {
    return sums + this->Numbering.PairOf(modeA - 1, modeB - 1) * (this->Lags.Count + 1);
  }

  TwoPointProbability Numbering;
  double Unit;
  std::vector<double> Inverse;
};

ExactPairSum::ExactPairSum(const PackShare& share, const LagGrid& lags, Communicator& ranks)
{
  CheckNumberOfLags(share.NumberOfModes(), lags);
  LagLimit::ForPairSum(share.Observed, share.LargestRadius).Check(lags.Maximum());
  const std::vector<SphereType> types = FindTypes(share.Own, ranks);
  if (types.size() <= MostTypes && PairHistogram::EstimateSize(types, lags) <= LargestHistogram)
  {
    this->Sum = std::make_unique<Tabulated>(share, lags, types, ranks);
  }
  else
  {
    this->Sum = std::make_unique<Direct>(share, lags, ranks);
  }
}

namespace
{
Communicator& Serial()
{
  static Communicator serial;
  return serial;
}
}

ExactPairSum::ExactPairSum(const SpherePack& pack, const Window& window, const LagGrid& lags)
  : ExactPairSum(SharePack(pack, window), lags, Serial())
{
}

ExactPairSum::~ExactPairSum() = default;

std::size_t ExactPairSum::NumberOfChunks() const
{
  return (this->Sum->Pairs.Size() + ChunkOfCentres - 1) / ChunkOfCentres;
}

std::size_t ExactPairSum::SumsSize() const
{
  return 2 * this->Sum->SumsSize() + this->Sum->CountsSize();
}

void ExactPairSum::AddChunks(std::size_t first, std::size_t stride, std::int64_t* sums,
  const std::function<void(double)>& progress) const
{
  const std::int64_t chunks = static_cast<std::int64_t>(this->NumberOfChunks());
  const std::size_t centres = this->Sum->Pairs.Size();
#pragma omp parallel
  {
    FixedPointSums own(this->Sum->SumsSize());
    std::vector<std::int64_t> counts(this->Sum->CountsSize(), 0);
#pragma omp for schedule(dynamic) nowait
    for (std::int64_t chunk = static_cast<std::int64_t>(first); chunk < chunks;
         chunk += static_cast<std::int64_t>(stride))
    {
      const std::size_t end = std::min((chunk + 1) * ChunkOfCentres, centres);
      for (std::size_t i = chunk * ChunkOfCentres; i < end; i += this->Sum->Step)
      {
        this->Sum->Add(
          i, std::min(i + this->Sum->Step, end), own.Take(this->Sum->TermsOfStep), counts.data());
      }
      if (progress && omp_get_thread_num() == 0)
      {
        progress(double(chunk) / chunks);
      }
    }
    const std::vector<std::int64_t>& wide = own.Finish();
#pragma omp critical
    {
      std::transform(wide.begin(), wide.end(), sums, sums, std::plus<>());
      std::transform(
        counts.begin(), counts.end(), sums + wide.size(), sums + wide.size(), std::plus<>());
    }
  }
}

TwoPointProbability ExactPairSum::Result(const std::vector<std::int64_t>& sums) const
{
  return this->Sum->Result(sums);
}
}
