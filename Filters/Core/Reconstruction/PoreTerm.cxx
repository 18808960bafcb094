// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/PoreTerm.h"

#include "ruc/Base/FixedPoint.h"

#include <algorithm>
#include <cmath>

namespace ruc
{
namespace
{
constexpr double PointsOfSpacing = 5.4; // along an axis, in the mean spacing of the centres
constexpr int MostPointsAlong = 256;

// Sums of up to 2^24 numbers of at most 1 in magnitude
constexpr double Scale = 274877906944.0; // 2^38

int PointsAlong(double spheres)
{
  return static_cast<int>(std::clamp(
    std::round(PointsOfSpacing * std::cbrt(spheres)), 8.0, static_cast<double>(MostPointsAlong)));
}

// For each threshold the number below u, as a distance above several of them counts for each
std::size_t ThresholdsBelow(const HingeSums& sums, double u)
{
  return std::lower_bound(sums.Threshold.begin(), sums.Threshold.end(), u) - sums.Threshold.begin();
}
}

PoreTerm::PoreTerm(
  const CellContents& contents, const NeighbourSums& sums, Communicator& communicator)
  : Contents(contents)
  , Sums(sums)
  , Ranks(communicator)
{
  const int points = PointsAlong(contents.NumberOfSpheres());
  const double spacing = contents.Edge / points;
  this->Lattice.Spacing = { spacing, spacing, spacing };
  this->Lattice.Count = { points, points, points };
  this->Lattice.Periodic = { true, true, true };
  this->FirstPlane =
    static_cast<int>(std::int64_t(points) * this->Ranks.Rank() / this->Ranks.Size());
  this->LastPlane =
    static_cast<int>(std::int64_t(points) * (this->Ranks.Rank() + 1) / this->Ranks.Size());
  this->MoveLattice(0);
}

void PoreTerm::MoveLattice(int n)
{
  // Additive recurrence of the plastic number: its places fill the cube evenly
  constexpr double steps[] = { 0.8191725133961645, 0.6710436067037893, 0.5497004779019703 };
  for (int q = 0; q < 3; ++q)
  {
    this->Lattice.Origin[q] = std::fmod(n * steps[q], 1.0) * this->Lattice.Spacing[q];
  }
}

double PoreTerm::Evaluate(const double* centres, double factor, double* gradient)
{
  const SpherePack pack = this->Contents.MakePack(centres);
  const SurfaceDistances found = FindSurfaceDistances(
    pack, this->Lattice, this->Sums.LargestPore, this->FirstPlane, this->LastPlane);
  std::vector<double> slopes;
  const double misfit = FindMisfit(this->Sums.Pores, this->FindValues(found), slopes);
  if (gradient)
  {
    this->AddGradient(pack, found, slopes, factor, gradient);
  }
  return misfit;
}

std::vector<double> PoreTerm::FindValues(const SurfaceDistances& found)
{
  const HingeSums& pores = this->Sums.Pores;
  const std::size_t thresholds = pores.Size();
  const double most = this->Sums.LargestPore;
  // The number, and the sum, of the distances between two thresholds
  std::vector<std::int64_t> sums(2 * (thresholds + 1), 0);
  for (float distance : found.Distance)
  {
    if (distance > 0.0f)
    {
      const std::size_t n = ThresholdsBelow(pores, distance);
      ++sums[2 * n];
      sums[2 * n + 1] += RoundToFixedPoint(distance / most * Scale);
    }
  }
  this->Ranks.Sum(sums.data(), sums.size());
  const double points = double(this->Lattice.PlaneSize()) * this->Lattice.Count[0];
  const double matrix = (1.0 - this->Contents.Fraction()) * points;
  std::vector<double> values(thresholds, 0.0);
  double count = 0.0, sum = 0.0;
  for (std::size_t j = thresholds; j-- > 0;)
  {
    count += sums[2 * (j + 1)];
    sum += sums[2 * (j + 1) + 1] / Scale * most;
    values[j] = (sum - count * pores.Threshold[j]) / matrix;
  }
  return values;
}

void PoreTerm::AddGradient(const SpherePack& pack, const SurfaceDistances& found,
  const std::vector<double>& slopes, double factor, double* gradient)
{
  const HingeSums& pores = this->Sums.Pores;
  // The derivative by a distance that lies above j thresholds
  std::vector<double> pull(slopes.size() + 1, 0.0);
  double steepest = 0.0;
  for (std::size_t j = 0; j < slopes.size(); ++j)
  {
    pull[j + 1] = pull[j] + slopes[j];
    steepest = std::max(steepest, std::abs(pull[j + 1]));
  }
  if (steepest == 0.0)
  {
    return;
  }
  std::vector<std::int64_t> forces(3 * pack.Size(), 0);
  std::size_t n = 0;
  for (int i = this->FirstPlane; i < this->LastPlane; ++i)
  {
    for (int j = 0; j < this->Lattice.Count[1]; ++j)
    {
      for (int k = 0; k < this->Lattice.Count[2]; ++k, ++n)
      {
        const std::int32_t s = found.Sphere[n];
        const float distance = found.Distance[n];
        const double slope =
          s < 0 || distance <= 0.0f ? 0.0 : pull[ThresholdsBelow(pores, distance)] / steepest;
        if (slope != 0.0)
        {
          const Vector3 point = this->Lattice.PointAt(i, j, k);
          const Vector3 centre = pack.Centre(s);
          const double length = distance + pack.Radius[s];
          for (int q = 0; q < 3; ++q)
          {
            double along = point[q] - centre[q];
            along -= this->Contents.Edge * std::nearbyint(along / this->Contents.Edge);
            // Rounding of the distance may take it a little above 1
            forces[3 * s + q] -=
              RoundToFixedPoint(slope * std::clamp(along / length, -1.0, 1.0) * Scale);
          }
        }
      }
    }
  }
  this->Ranks.Sum(forces.data(), forces.size());
  const double points = double(this->Lattice.PlaneSize()) * this->Lattice.Count[0];
  const double matrix = (1.0 - this->Contents.Fraction()) * points;
  for (std::size_t n3 = 0; n3 < forces.size(); ++n3)
  {
    gradient[n3] += factor * steepest / matrix * (forces[n3] / Scale);
  }
}

Estimate EstimatePoreTerm(double spheres)
{
  const double points = std::pow(PointsAlong(spheres), 3.0);
  constexpr double secondsOfPoint = 5e-8, bytesOfPoint = 8.0;
  return { points * secondsOfPoint, points * bytesOfPoint / BytesOfMegabyte, 0.0 };
}
}
