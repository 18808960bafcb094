// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/NearPairs.h"

#include "ruc/Particles/Contacts.h"

#include <algorithm>

namespace ruc
{
namespace
{
// A sphere may go this part of its radius before the list is made anew
constexpr double Room = 0.1;
}

NearPairs::NearPairs(const SpherePack& spheres, const Window& box, double reach)
  : Spheres(spheres)
  , Box(box)
  , Reach(reach)
{
}

bool NearPairs::IsStale(const double* centres) const
{
  bool stale = this->ListedAt.empty();
  for (std::size_t i = 0; i < this->Spheres.Size() && !stale; ++i)
  {
    double gone2 = 0.0;
    for (int q = 0; q < 3; ++q)
    {
      const double gone = centres[3 * i + q] - this->ListedAt[3 * i + q];
      gone2 += gone * gone;
    }
    const double most = Room * this->Spheres.Radius[i];
    stale = !(gone2 <= most * most);
  }
  return stale;
}

void NearPairs::MakeList(const double* centres)
{
  this->ListedAt.assign(centres, centres + 3 * this->Spheres.Size());
  SetCentres(this->Spheres, this->Box, centres);
  this->Listed.clear();
  ForEachContact(this->Spheres, this->Box, this->Reach + Room,
    [&](std::size_t i, std::size_t j, double, double, double, double)
    {
      if (i != j)
      {
        this->Listed.emplace_back(std::min(i, j), std::max(i, j));
      }
    });
  std::sort(this->Listed.begin(), this->Listed.end());
  this->Listed.erase(std::unique(this->Listed.begin(), this->Listed.end()), this->Listed.end());
}

const std::vector<NearPairs::Pair>& NearPairs::Find(const double* centres)
{
  if (this->IsStale(centres))
  {
    this->MakeList(centres);
  }
  this->Near.clear();
  for (const auto& [i, j] : this->Listed)
  {
    Pair pair{ i, j, {}, 0.0, this->Spheres.Radius[i] + this->Spheres.Radius[j] };
    for (int q = 0; q < 3; ++q)
    {
      const double d = centres[3 * j + q] - centres[3 * i + q];
      pair.Along[q] = d - this->Box.Size[q] * std::nearbyint(d / this->Box.Size[q]);
    }
    const double reach = this->Reach * pair.Contact;
    const double d2 = Dot(pair.Along, pair.Along);
    if (d2 < reach * reach)
    {
      pair.Distance = std::sqrt(d2);
      this->Near.push_back(pair);
    }
  }
  return this->Near;
}
}
