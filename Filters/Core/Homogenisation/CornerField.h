// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Homogenisation/CellSlab.h"

#include <cstddef>
#include <vector>

namespace ruc
{
/**
 * Numbers at the corners of the voxels of a CellSlab, with one plane more on either side, which
 * belong to other ranks. Plane n of a component is that of the cell's plane Begin - 1 + n.
 */
class CornerField
{
public:
  CornerField(const CellSlab& slab, int components);

  int Components() const { return static_cast<int>(this->Values.size()); }
  float* Plane(int component, int n) { return this->Values[component].data() + n * this->Size; }
  const float* Plane(int component, int n) const
  {
    return this->Values[component].data() + n * this->Size;
  }
  void Fill(float value);

  /** Sets the two planes more to those of the ranks that own them. Collective. */
  void UpdateHalo(const CellSlab& slab, Communicator& ranks);

private:
  std::size_t Size; // of a plane
  std::vector<std::vector<float>> Values;
};

/**
 * Adds up numbers of the planes of a cell, of which each rank has those of its own planes, in the
 * order of the planes. So the sum is equal, bit by bit, on every rank and for any number of ranks.
 * Collective.
 */
double SumInOrder(const std::vector<double>& own, Communicator& ranks);

/** Returns the sum over the corners of a plane of a[x] b[x], in double precision. */
double DotOfPlane(const float* a, const float* b, std::size_t count);
}
