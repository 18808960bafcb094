// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Packing/PackOrder.h"

#include "ruc/Particles/Contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace ruc
{
namespace
{
constexpr double NeighbourReach = 1.2;
constexpr int Degree = 6, FewestOfHeld = 4;

// For each sphere how many walls it touches
std::vector<int> CountWalls(const SpherePack& pack, const Window& box, double tolerance)
{
  std::vector<int> walls(pack.Size(), 0);
  for (int q = 0; q < 3; ++q)
  {
    for (std::size_t i = 0; i < pack.Size() && !box.Periodic[q]; ++i)
    {
      const double low = pack.Centre(i)[q] - box.Origin[q];
      for (double distance : { low, box.Size[q] - low })
      {
        walls[i] += distance < (1.0 + tolerance) * pack.Radius[i] ? 1 : 0;
      }
    }
  }
  return walls;
}

// Takes rattlers away until none is left, and tells the rest
void MeasureContacts(
  const std::vector<std::vector<std::size_t>>& near, std::vector<int> contacts, PackOrder& order)
{
  std::vector<std::size_t> loose;
  std::vector<char> gone(near.size(), 0);
  const auto look = [&](std::size_t i)
  {
    if (!gone[i] && contacts[i] < FewestOfHeld)
    {
      gone[i] = 1;
      loose.push_back(i);
    }
  };
  for (std::size_t i = 0; i < near.size(); ++i)
  {
    look(i);
  }
  for (std::size_t n = 0; n < loose.size(); ++n)
  {
    for (std::size_t j : near[loose[n]])
    {
      --contacts[j];
      look(j);
    }
  }
  std::int64_t total = 0;
  for (std::size_t i = 0; i < near.size(); ++i)
  {
    total += gone[i] ? 0 : contacts[i];
  }
  const std::size_t held = near.size() - loose.size();
  order.RattlerPercent = 100.0 * loose.size() / near.size();
  order.CoordinationNumber = held > 0 ? static_cast<double>(total) / held : 0.0;
}
}

bool PackOrder::IsCrystalline() const
{
  // Of N pairs in random directions Q6^2 is 1 / N on average
  const double pairs = static_cast<double>(this->Neighbours);
  return this->Q6 > MostQ6 && this->Q6 * this->Q6 * pairs > 16.0;
}

PackOrder MeasureOrder(const SpherePack& pack, const Window& box, double tolerance)
{
  PackOrder order;
  if (pack.Empty())
  {
    return order;
  }
  std::vector<int> contacts = CountWalls(pack, box, tolerance);
  std::vector<std::vector<std::size_t>> near(pack.Size());
  std::array<double, 2 * Degree + 1> sums{}; // m = 0, and the real and imaginary parts of others
  std::int64_t& bonds = order.Neighbours;
  ForEachContact(pack, box, std::max(NeighbourReach, 1.0 + tolerance),
    [&](std::size_t i, std::size_t j, double dx, double dy, double dz, double d)
    {
      const double contact = pack.Radius[i] + pack.Radius[j];
      if (d < (1.0 + tolerance) * contact)
      {
        near[i].push_back(j);
        near[j].push_back(i);
        ++contacts[i];
        ++contacts[j];
      }
      if (d < NeighbourReach * contact)
      {
        ++bonds;
        const double theta = std::acos(std::clamp(dz / d, -1.0, 1.0)), phi = std::atan2(dy, dx);
        sums[0] += std::sph_legendre(Degree, 0, theta);
        for (int m = 1; m <= Degree; ++m)
        {
          const double y = std::sph_legendre(Degree, m, theta);
          sums[2 * m - 1] += y * std::cos(m * phi);
          sums[2 * m] += y * std::sin(m * phi);
        }
      }
    });
  MeasureContacts(near, std::move(contacts), order);
  double squares = sums[0] * sums[0];
  for (std::size_t n = 1; n < sums.size(); ++n)
  {
    squares += 2.0 * sums[n] * sums[n]; // of m and -m
  }
  order.Q6 = bonds > 0 ? std::sqrt(4.0 * Pi / (2 * Degree + 1) * squares) / bonds : 0.0;
  return order;
}
}
