// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Packing/Deposition.h"

#include "ruc/Base/Random.h"
#include "ruc/Base/Require.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace ruc
{
namespace
{
constexpr int MaximumDraws = 10000;
constexpr int DrawsBetweenQuestions = 1000;

// The spheres that are already in the cube, in a periodic grid whose cells are no shorter than the
// longest distance at which two of them matter
class Deposit
{
public:
  Deposit(double edge, double reach)
    : Edge(edge)
    , Cells(std::clamp(static_cast<int>(edge / reach), 1, 64))
    , Spheres(std::size_t(this->Cells) * this->Cells * this->Cells)
  {
  }

  void Put(const std::array<double, 3>& centre, double radius)
  {
    this
      ->Spheres[this->CellAt(
        this->CellOf(centre[0]), this->CellOf(centre[1]), this->CellOf(centre[2]))]
      .push_back({ centre, radius });
  }

  // The largest (a + b - d) / (a + b) of a sphere at a place with those in the cube, or any value
  // above `bound` where the largest is above it
  double DegreeAt(const std::array<double, 3>& centre, double radius, double bound) const
  {
    double degree = 0.0;
    // With two cells along an axis, each is the other's neighbour on both sides, but the nearest
    // image must be met once
    const int first = this->Cells < 3 ? 0 : -1;
    const int last = this->Cells < 3 ? this->Cells - 1 : 1;
    const int cell[3] = { this->CellOf(centre[0]), this->CellOf(centre[1]),
      this->CellOf(centre[2]) };
    for (int kz = first; kz <= last; ++kz)
    {
      for (int ky = first; ky <= last; ++ky)
      {
        for (int kx = first; kx <= last; ++kx)
        {
          for (const Sphere& other :
            this->Spheres[this->CellAt(cell[0] + kx, cell[1] + ky, cell[2] + kz)])
          {
            const double contact = radius + other.Radius;
            double d2 = 0.0;
            for (int q = 0; q < 3; ++q)
            {
              const double difference = std::abs(centre[q] - other.Centre[q]);
              const double nearest = std::min(difference, this->Edge - difference);
              d2 += nearest * nearest;
            }
            if (d2 < contact * contact)
            {
              degree = std::max(degree, (contact - std::sqrt(d2)) / contact);
              if (degree > bound)
              {
                return degree;
              }
            }
          }
        }
      }
    }
    return degree;
  }

private:
  struct Sphere
  {
    std::array<double, 3> Centre;
    double Radius;
  };

  int CellOf(double c) const
  {
    return std::min(static_cast<int>(c / this->Edge * this->Cells), this->Cells - 1);
  }
  std::size_t CellAt(int cx, int cy, int cz) const
  {
    const auto wrap = [&](int c) { return std::size_t((c + this->Cells) % this->Cells); };
    return (wrap(cz) * this->Cells + wrap(cy)) * this->Cells + wrap(cx);
  }

  double Edge;
  int Cells;
  std::vector<std::vector<Sphere>> Spheres;
};
}

BallisticDeposition DepositBallistically(const std::vector<double>& radii, double edge,
  std::uint32_t seed, std::uint32_t number, double degree, const std::function<bool()>& carryOn)
{
  Require(degree >= 0.0 && degree <= 1.0, "DepositionDegree", "0 <= DepositionDegree <= 1", degree);
  std::vector<std::size_t> order(radii.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(
    order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return radii[i] > radii[j]; });

  Deposit deposit(edge, 2.0 * radii[order.front()]);
  BallisticDeposition result;
  result.Centres.resize(3 * radii.size());
  std::uint32_t draw = 0;
  for (std::size_t i : order)
  {
    std::array<double, 3> place{};
    double reached = std::numeric_limits<double>::infinity();
    for (int n = 0; n < MaximumDraws && reached > degree; ++n)
    {
      if ((draw + 1) % DrawsBetweenQuestions == 0 && !carryOn())
      {
        return {};
      }
      std::array<double, 3> centre =
        UniformTriple(seed, RandomStream::Deposition, std::uint64_t(number) << 32 | draw++);
      for (double& c : centre)
      {
        c *= edge;
      }
      const double found = deposit.DegreeAt(centre, radii[i], std::min(reached, 1.0));
      if (found < reached)
      {
        reached = found;
        place = centre;
      }
    }
    deposit.Put(place, radii[i]);
    std::copy(place.begin(), place.end(), &result.Centres[3 * i]);
    result.Degree = std::max(result.Degree, reached);
  }
  return result;
}
}
