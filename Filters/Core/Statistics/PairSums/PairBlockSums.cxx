// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/PairSums/PairBlockSums.h"

#include "ruc/Base/FixedPoint.h"
#include "ruc/Base/VectorClones.h"
#include "ruc/Particles/PairNeighbourhood.h"
#include "ruc/Particles/SphereOverlap.h"

#include <cstdint>
#include <functional>

namespace ruc
{
namespace
{
constexpr int MostSteps = 400;
constexpr double MostOverlap = 8.0;
constexpr int Rings = 4;
}

PairSteps::PairSteps(const PackShare& share, const LagGrid& lags)
  : Modes(share.NumberOfModes())
  , Near(std::min(NearLagOfErrors * share.MeanDiameter(), lags.Maximum()))
{
  for (int r = 0; r < this->Modes; ++r)
  {
    this->Volume.push_back(share.Volume[r] / static_cast<double>(share.Count[r]));
    this->Radius.push_back(std::cbrt(this->Volume.back() / SphereVolume(1.0)));
  }
  this->Begin.push_back(0);
  for (int r = 0; r < this->Modes; ++r)
  {
    for (int s = r; s < this->Modes; ++s)
    {
      const double a = this->Radius[r], b = this->Radius[s];
      const double reach = this->Near + a + b;
      const double step = std::max(StepOfErrors * std::min(a, b), reach / MostSteps);
      this->Reach.push_back(reach);
      this->Step.push_back(step);
      this->Begin.push_back(this->Begin.back() + static_cast<int>(std::ceil(reach / step)));
    }
  }
  for (int r = 0; r < this->Modes; ++r)
  {
    for (int s = 0; s < this->Modes; ++s)
    {
      const int pair = this->PairOf(r, s);
      const double b = this->Radius[s], reach = this->Reach[pair];
      this->Rows.push_back({ reach * reach, 1.0 / this->Step[pair], 1.0 / (b * b * b),
        this->Begin[pair], this->Begin[pair + 1] - 1 });
    }
  }
}

namespace
{
// The largest power of two by which numbers up to `most` may be scaled, such that `terms` of them
// stay below 2^61 with the weights of blocks, and one of them below 2^50
double ScaleOf(double most, double terms, double weights)
{
  const int room = 60 - std::ilogb(most * terms * weights);
  return std::ldexp(1.0, std::min(room, 49 - std::ilogb(most)));
}

RUC_VECTOR_CLONES
void AddWeighted(const std::int64_t* of, std::int64_t weight, std::size_t size, std::int64_t* to)
{
  for (std::size_t n = 0; n < size; ++n)
  {
    to[n] += weight * of[n];
  }
}

class BlockCount
{
public:
  BlockCount(const PackShare& share, const PairSteps& steps, const TaperedBlocks& blocks,
    Communicator& ranks)
    : Share(share)
    , Steps(steps)
    , Blocks(blocks)
    , Around(share, steps.LargestReach(), ranks)
  {
    const Window& window = share.Observed;
    const double heaviest = window.IsFullyPeriodic()
      ? 1.0
      : window.Volume() / window.LeastSetCovariance(steps.LargestReach());
    double least = 0.0;
    for (std::size_t i = 0; i < share.Own.Size(); ++i)
    {
      least = std::min(least, -this->SharesOf(share.Own.Radius[i], share.Own.Mode[i]));
    }
    ranks.Minimum(&least, 1);
    const double spheres = static_cast<double>(share.NumberOfSpheres), most = -least;
    // The spheres around one fill at most a ball; no pack overlaps by as much as MostOverlap
    const double ball = (steps.LargestReach() + share.LargestRadius) /
      *std::min_element(steps.Radius.begin(), steps.Radius.end());
    const double around = std::min(spheres * most, MostOverlap * ball * ball * ball);
    this->PairScale =
      ScaleOf(heaviest * most * most, spheres * around / most, TaperedBlocks::WholeWeight);
    this->VolumeScale = ScaleOf(most, spheres, 1.0);
  }

  BlockSums Sum(Communicator& ranks) const
  {
    const std::vector<std::vector<std::size_t>> ofCells = this->SortByCell();
    const std::size_t size = this->Steps.Size();
    std::vector<std::int64_t> pairs(this->Blocks.Count() * size, 0);
    const int cells = this->Blocks.Cells();
#pragma omp parallel
    {
      std::vector<std::int64_t> own(pairs.size(), 0), ofCell(size);
#pragma omp for schedule(dynamic)
      for (int cell = 0; cell < cells; ++cell)
      {
        if (ofCells[cell].empty())
        {
          continue;
        }
        std::fill(ofCell.begin(), ofCell.end(), 0);
        for (std::size_t i : ofCells[cell])
        {
          this->CountAround(i, ofCell.data());
        }
        this->Blocks.ForEachBlock(cell,
          [&](int block, int weight)
          { AddWeighted(ofCell.data(), weight, size, &own[block * size]); });
      }
#pragma omp critical
      std::transform(own.begin(), own.end(), pairs.begin(), pairs.begin(), std::plus<>());
    }
    ranks.Sum(pairs.data(), pairs.size());
    BlockSums sums = this->SumSpheres(ranks);
    for (std::int64_t pair : pairs)
    {
      sums.Pairs.push_back(
        static_cast<double>(pair) / (this->PairScale * TaperedBlocks::WholeWeight));
    }
    return sums;
  }

private:
  double SharesOf(double radius, int mode) const
  {
    return SphereVolume(radius) / this->Steps.Volume[mode - 1];
  }
  Vector3 CentreOf(std::size_t i) const
  {
    return { this->Share.Own.X[i], this->Share.Own.Y[i], this->Share.Own.Z[i] };
  }

  // The sorted places of the own centres in each cell
  std::vector<std::vector<std::size_t>> SortByCell() const
  {
    std::vector<std::vector<std::size_t>> ofCells(this->Blocks.Cells());
    for (std::size_t place = 0; place < this->Around.Size(); ++place)
    {
      ofCells[this->Blocks.CellOf(this->CentreOf(this->Around.PlaceOf(place)))].push_back(place);
    }
    return ofCells;
  }

  void CountAround(std::size_t place, std::int64_t* counts) const
  {
    const std::size_t i = this->Around.PlaceOf(place);
    const int r = this->Share.Own.Mode[i];
    const double own = this->SharesOf(this->Share.Own.Radius[i], r) * this->PairScale;
    const PairSteps::Row* row = this->Steps.RowOf(r - 1);
    const Window& window = this->Share.Observed;
    const bool isBox = window.GetShape() == Window::Shape::Box;
    const double loss[3] = { window.Periodic[0] ? 0.0 : 1.0, window.Periodic[1] ? 0.0 : 1.0,
      window.Periodic[2] ? 0.0 : 1.0 };
    const double volume = window.Volume();
    this->Around.ForEachAround(place,
      [&](const PairNeighbourhood::Part& part, std::size_t j, double dx, double dy, double dz,
        double d2)
      {
        const int s = part.Pack.Mode[j];
        const PairSteps::Row& steps = row[s - 1];
        if (d2 < steps.SquaredReach)
        {
          const double radius = part.Pack.Radius[j];
          const double covariance = isBox ? (window.Size[0] - loss[0] * std::abs(dx)) *
              (window.Size[1] - loss[1] * std::abs(dy)) * (window.Size[2] - loss[2] * std::abs(dz))
                                          : window.SetCovariance(dx, dy, dz);
          const double share = own * (radius * radius * radius) * steps.InverseCube;
          const int step = static_cast<int>(std::sqrt(d2) * steps.InverseStep);
          counts[std::min(steps.Begin + step, steps.Last)] +=
            RoundToFixedPoint(share * (volume / covariance));
        }
      });
  }

  BlockSums SumSpheres(Communicator& ranks) const
  {
    const std::size_t modes = this->Steps.Modes;
    const double largest = 4.0 * Pi * this->Share.LargestRadius * this->Share.LargestRadius;
    std::vector<std::int64_t> volumes(this->Blocks.Cells() * modes, 0);
    std::vector<std::int64_t> surface(this->Blocks.Cells(), 0);
    for (std::size_t i = 0; i < this->Share.Own.Size(); ++i)
    {
      const int cell = this->Blocks.CellOf(this->CentreOf(i)), mode = this->Share.Own.Mode[i];
      const double radius = this->Share.Own.Radius[i];
      volumes[cell * modes + mode - 1] +=
        RoundToFixedPoint(this->VolumeScale * this->SharesOf(radius, mode));
      surface[cell] += RoundToFixedPoint(
        std::ldexp(radius * radius / (this->Share.LargestRadius * this->Share.LargestRadius), 30));
    }
    ranks.Sum(volumes.data(), volumes.size());
    ranks.Sum(surface.data(), surface.size());
    BlockSums sums;
    sums.Rings = this->SumRings(ranks);
    for (std::size_t n = 0; n < volumes.size(); ++n)
    {
      sums.Volumes.push_back(
        static_cast<double>(volumes[n]) / this->VolumeScale * this->Steps.Volume[n % modes]);
    }
    for (std::int64_t sum : surface)
    {
      sums.Surface.push_back(std::ldexp(static_cast<double>(sum), -30) * largest);
    }
    return sums;
  }

  std::vector<double> SumRings(Communicator& ranks) const
  {
    const Window& window = this->Share.Observed;
    std::vector<double> volumes;
    if (window.GetShape() == Window::Shape::Cylinder)
    {
      std::int64_t sums[Rings] = {};
      const double unit = SphereVolume(this->Share.LargestRadius);
      for (std::size_t i = 0; i < this->Share.Own.Size(); ++i)
      {
        const Vector3 centre = this->CentreOf(i);
        double along = 0.0, squared = 0.0;
        for (int q = 0; q < 3; ++q)
        {
          along += (centre[q] - window.Base[q]) * window.Axis[q];
          squared += (centre[q] - window.Base[q]) * (centre[q] - window.Base[q]);
        }
        const double share = (squared - along * along) / (window.Radius * window.Radius);
        sums[std::clamp(static_cast<int>(share * Rings), 0, Rings - 1)] +=
          RoundToFixedPoint(std::ldexp(SphereVolume(this->Share.Own.Radius[i]) / unit, 30));
      }
      ranks.Sum(sums, Rings);
      for (std::int64_t sum : sums)
      {
        volumes.push_back(std::ldexp(static_cast<double>(sum), -30) * unit);
      }
    }
    return volumes;
  }

  const PackShare& Share;
  const PairSteps& Steps;
  const TaperedBlocks& Blocks;
  Surroundings Around;
  double PairScale = 1.0, VolumeScale = 1.0;
};
}

BlockSums SumBlocks(
  const PackShare& share, const PairSteps& steps, const TaperedBlocks& blocks, Communicator& ranks)
{
  return BlockCount(share, steps, blocks, ranks).Sum(ranks);
}
}
