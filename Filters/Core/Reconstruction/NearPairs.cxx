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

bool HaveGone(const double* centres, const std::vector<double>& listedAt,
  const std::vector<double>& radius, double share)
{
  for (std::size_t i = 0; i < radius.size(); ++i)
  {
    double gone2 = 0.0;
    for (int q = 0; q < 3; ++q)
    {
      const double gone = centres[3 * i + q] - listedAt[3 * i + q];
      gone2 += gone * gone;
    }
    const double most = share * radius[i];
    if (gone2 > most * most)
    {
      return true;
    }
  }
  return false;
}

NearPairs::NearPairs(const SpherePack& spheres, const Window& box, double reach)
  : Spheres(spheres)
  , Box(box)
  , Reach(reach)
{
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
  if (this->ListedAt.empty() || HaveGone(centres, this->ListedAt, this->Spheres.Radius, Room))
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
