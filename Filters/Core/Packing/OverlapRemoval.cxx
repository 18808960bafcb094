// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Packing/OverlapRemoval.h"

#include "ruc/Base/Random.h"
#include "ruc/Packing/Minimise.h"
#include "ruc/Particles/Contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ruc
{
bool RemoveOverlap(
  SpherePack& pack, const Window& box, std::uint32_t seed, const std::function<bool()>& carryOn)
{
  WrapIntoBox(pack, box);
  // Enlarged contacts end the search at a point where the true ones are free; near jamming there is
  // room for less
  constexpr double Enlargements[] = { 1e-4, 1e-5, 1e-6, 1e-4, 1e-5, 1e-6, 1e-5, 1e-6, 1e-5, 1e-6 };
  constexpr int MaximumIterations = 4000;
  const double smallest =
    pack.Empty() ? 0.0 : *std::min_element(pack.Radius.begin(), pack.Radius.end());
  bool stopped = false;
  std::uint32_t attempt = 0;
  for (double enlargement : Enlargements)
  {
    if (MeasureOverlap(pack, box).IsNone())
    {
      return true;
    }
    if (stopped)
    {
      return false;
    }
    if (attempt >= 3) // jammed: shake
    {
      for (std::size_t i = 0; i < pack.Size(); ++i)
      {
        const std::array<double, 3> u = UniformTriple(seed, RandomStream::Shaking, i, attempt);
        pack.X[i] += smallest * (u[0] - 0.5);
        pack.Y[i] += smallest * (u[1] - 0.5);
        pack.Z[i] += smallest * (u[2] - 0.5);
      }
      WrapIntoBox(pack, box);
    }
    ++attempt;

    std::vector<double> centres = CentresOf(pack);
    const double reach = 1.0 + enlargement;
    bool free = false;
    const auto evaluate = [&](const double* x, double* gradient)
    {
      SetCentres(pack, box, x);
      std::fill_n(gradient, centres.size(), 0.0);
      double energy = 0.0;
      free = true;
      ForEachContact(pack, box, reach,
        [&](std::size_t i, std::size_t j, double dx, double dy, double dz, double d)
        {
          const double contact = pack.Radius[i] + pack.Radius[j];
          const double overlap = reach * contact - d;
          free = free && d >= contact;
          energy += overlap * overlap;
          const double pull = 2.0 * overlap / std::max(d, std::numeric_limits<double>::min());
          const double difference[3] = { dx, dy, dz };
          for (int q = 0; q < 3; ++q)
          {
            gradient[3 * i + q] += pull * difference[q];
            gradient[3 * j + q] -= pull * difference[q];
          }
        });
      return energy;
    };
    MinimiserSettings settings;
    settings.MaximumIterations = MaximumIterations;
    Minimise(centres, settings, evaluate,
      [&](const double*, double, int iteration)
      {
        stopped = iteration % 10 == 0 && !carryOn();
        return !free && !stopped;
      });
    SetCentres(pack, box, centres.data());
  }
  return MeasureOverlap(pack, box).IsNone();
}
}
