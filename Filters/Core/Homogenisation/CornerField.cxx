// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Homogenisation/CornerField.h"

#include "ruc/Base/VectorClones.h"

#include <algorithm>

namespace ruc
{
namespace
{
constexpr int Lanes = 8;
}

CornerField::CornerField(const CellSlab& slab, int components)
  : Size(slab.PlaneSize())
  , Values(components)
{
  for (std::vector<float>& of : this->Values)
  {
    of.assign(slab.OwnPlanes() > 0 ? this->Size * (slab.OwnPlanes() + 2) : 0, 0.0f);
  }
}

void CornerField::Fill(float value)
{
  for (std::vector<float>& of : this->Values)
  {
    std::fill(of.begin(), of.end(), value);
  }
}

void CornerField::UpdateHalo(const CellSlab& slab, Communicator& ranks)
{
  const int count = static_cast<int>(slab.Planes.Count), last = slab.OwnPlanes();
  if (ranks.Size() == 1)
  {
    for (int c = 0; c < this->Components(); ++c)
    {
      std::copy_n(this->Plane(c, last), this->Size, this->Plane(c, 0));
      std::copy_n(this->Plane(c, 1), this->Size, this->Plane(c, last + 1));
    }
    return;
  }
  // To every rank, first the plane below it and then that above, where this rank owns them
  std::vector<std::vector<float>> outgoing(ranks.Size());
  for (int rank = 0; rank < ranks.Size(); ++rank)
  {
    if (slab.Planes.Size(rank) == 0)
    {
      continue;
    }
    const int below = static_cast<int>(slab.Planes.Begin(rank) - 1 + count) % count;
    const int above = static_cast<int>(slab.Planes.End(rank)) % count;
    for (int plane : { below, above })
    {
      for (int c = 0; c < this->Components() && plane >= slab.Begin && plane < slab.End; ++c)
      {
        const float* from = this->Plane(c, plane - slab.Begin + 1);
        outgoing[rank].insert(outgoing[rank].end(), from, from + this->Size);
      }
    }
  }
  const std::vector<std::vector<float>> incoming = ranks.AllToAll(std::move(outgoing));
  std::vector<std::size_t> taken(ranks.Size(), 0);
  for (int side = 0; side < 2 && last > 0; ++side)
  {
    const int plane = side == 0 ? (slab.Begin - 1 + count) % count : slab.End % count;
    int owner = 0;
    while (plane >= slab.Planes.End(owner))
    {
      ++owner;
    }
    for (int c = 0; c < this->Components(); ++c, taken[owner] += this->Size)
    {
      std::copy_n(incoming[owner].data() + taken[owner], this->Size,
        this->Plane(c, side == 0 ? 0 : last + 1));
    }
  }
}

double SumInOrder(const std::vector<double>& own, Communicator& ranks)
{
  double sum = 0.0;
  for (double value : ranks.Concatenate(own))
  {
    sum += value;
  }
  return sum;
}

RUC_VECTOR_CLONES double DotOfPlane(const float* a, const float* b, std::size_t count)
{
  double lanes[Lanes] = {};
  std::size_t x = 0;
  for (; x + Lanes <= count; x += Lanes)
  {
    for (int l = 0; l < Lanes; ++l)
    {
      lanes[l] += static_cast<double>(a[x + l]) * static_cast<double>(b[x + l]);
    }
  }
  double sum = 0.0;
  for (; x < count; ++x)
  {
    sum += static_cast<double>(a[x]) * static_cast<double>(b[x]);
  }
  for (double lane : lanes)
  {
    sum += lane;
  }
  return sum;
}
}
