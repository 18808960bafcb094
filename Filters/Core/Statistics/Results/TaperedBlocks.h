// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Vector3.h"
#include "ruc/Window/Window.h"

#include <array>
#include <cstddef>
#include <vector>

namespace ruc
{
/**
 * A window in blocks that pass over into each other, for the standard error of what is a sum over
 * the window. Along each axis the weight of a block falls linearly from 1 at its middle to 0 at the
 * middle of the next; at a face of the window it stays 1. At every place the weights add up to 1.
 * Blocks with hard faces would see how spheres that exclude each other are cut by these, which the
 * window as a whole does not.
 *
 * The axes are those of a box, or for a cylinder its own axis, which is the last, and two across.
 * Weights are constant in each of the small cells of a grid, four to an edge of a block.
 */
class TaperedBlocks
{
public:
  /** Weights of a cell are whole multiples of 1 / WholeWeight. */
  static constexpr int WholeWeight = 512;
  /** The fewest blocks that tell of a scatter. */
  static constexpr int Fewest = 8;

  /**
   * Makes about so many blocks, which are as near to cubes as can be, with edges of at least
   * `leastEdge`. Throws std::invalid_argument, with the name of the property that asks for blocks,
   * where there is no room for `Fewest` of them.
   */
  TaperedBlocks(const Window& window, int about, double leastEdge, const char* property);

  int Count() const { return this->Divisions[0] * this->Divisions[1] * this->Divisions[2]; }
  int Cells() const { return CellsOfEdge * CellsOfEdge * CellsOfEdge * this->Count(); }
  /** The number of blocks along an axis. */
  int CountAlong(int axis) const { return this->Divisions[axis]; }
  int CellsAlong(int axis) const { return CellsOfEdge * this->Divisions[axis]; }
  bool IsPeriodic(int axis) const { return this->Frame.Periodic[axis]; }
  double EdgeAlong(int axis) const { return this->Frame.Size[axis]; }
  /** Which blocks, in number (i NumberAlong(1) + j) NumberAlong(2) + k, and cells likewise. */
  std::array<int, 3> PlaceOfBlock(int block) const { return Place(block, this->Divisions, 1); }
  std::array<int, 3> PlaceOfCell(int cell) const
  {
    return Place(cell, this->Divisions, CellsOfEdge);
  }

  /** The cell of a point in the window, from 0 on. */
  int CellOf(const Vector3& point) const;
  /** The middle of a cell along the axes, from 0 to their edges. */
  Vector3 MiddleOf(int cell) const;
  /** Whether the middle of a cell lies in the window. */
  bool IsInside(int cell) const { return this->Inside[cell]; }

  /** The weight along one axis that a block has in a cell, in eighths. */
  int WeightAlong(int axis, int block, int cell) const;

  /** Calls visit(block, weight) for the at most eight blocks that have a weight in a cell. */
  template <class Visit>
  void ForEachBlock(int cell, Visit&& visit) const
  {
    const std::array<int, 3> at = this->PlaceOfCell(cell);
    const Parts parts[3] = { this->PartsOf(0, at[0]), this->PartsOf(1, at[1]),
      this->PartsOf(2, at[2]) };
    for (int x = 0; x < parts[0].Number; ++x)
    {
      for (int y = 0; y < parts[1].Number; ++y)
      {
        for (int z = 0; z < parts[2].Number; ++z)
        {
          visit((parts[0].Block[x] * this->Divisions[1] + parts[1].Block[y]) * this->Divisions[2] +
              parts[2].Block[z],
            parts[0].Weight[x] * parts[1].Weight[y] * parts[2].Weight[z]);
        }
      }
    }
  }

  /**
   * Blocks in groups, and the sum of the squared differences from the means of the groups that is
   * expected of noise without correlation, of variance 1 in every cell.
   */
  struct Groups
  {
    std::vector<int> Of; // the group of each block
    std::vector<int> Sizes;
    double ExpectedSquares = 0.0;
  };
  Groups MakeGroups(std::vector<int> of) const;

  /** Returns the sum of the squared differences of the blocks' values from their group's mean. */
  static double SquaresWithin(const Groups& groups, const std::vector<double>& values);

  /**
   * Returns the variance of the sum over the window, of which each block has its weighted part.
   * What a part is expected to be is the mean over the blocks that are mirror images of it, or
   * translations along a periodic axis.
   */
  double VarianceOfSum(const std::vector<double>& parts) const;

  /** The group of a block among its mirror images along all axes but `except`. */
  int MirrorGroup(int block, int except = -1) const;

  /** The number of cells with their middle in the window. */
  int CellsInside() const { return this->NumberInside; }

private:
  static constexpr int CellsOfEdge = 4;
  struct Parts
  {
    int Number;
    int Block[2], Weight[2];
  };
  Parts PartsOf(int axis, int cell) const;
  static std::array<int, 3> Place(int index, const std::array<int, 3>& divisions, int factor)
  {
    const int ny = divisions[1] * factor, nz = divisions[2] * factor;
    return { index / (ny * nz), index / nz % ny, index % nz };
  }

  Window Observed;
  Window Frame;                // the window, or what a cylinder fits into, along the axes
  std::array<Vector3, 3> Axes; // and their directions
  Vector3 Corner{};
  std::array<int, 3> Divisions{};
  std::vector<char> Inside;
  int NumberInside = 0;
  Groups Mirrors;
};
}
