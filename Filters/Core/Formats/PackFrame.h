// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Vector3.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ruc
{
/**
 * A box as files tell it. From its origin go the edges (lx, 0, 0), (xy, ly, 0) and (xz, yz, lz),
 * with the tilts xy, xz, yz of LAMMPS, which are mostly 0.
 */
struct FrameBox
{
  Vector3 Origin{};
  Vector3 Edges{}; // lx, ly, lz
  Vector3 Tilts{}; // xy, xz, yz
  std::array<bool, 3> Periodic{};
  /** Whether the file tells `Periodic`. Several formats leave it to their programs. */
  bool PeriodicityKnown = false;

  bool IsTilted() const { return this->Tilts != Vector3{}; }
};

/**
 * The spheres of one frame as a file has them, in its order and unit. What a file does not tell is
 * empty. Every array that is not empty has one entry for each sphere.
 */
struct PackFrame
{
  std::vector<double> X, Y, Z, Radius;
  std::vector<std::int64_t> Id;
  /** Numbers are as in the file. Names are numbered from 1 in the order of the alphabet. */
  std::vector<int> Type;
  std::vector<std::string> TypeNames; // if types are names
  /** Classes of size, which only tables of this project tell. */
  std::vector<int> Mode;
  std::optional<FrameBox> Box;
  std::string LengthUnit;
  std::optional<double> Time;
  std::optional<std::int64_t> Step;
  std::string Format;
  std::vector<std::string> Warnings;

  std::size_t Size() const { return this->X.size(); }
};

/** A cell, given by its origin and its three edges in any direction. */
struct FrameCell
{
  Vector3 Origin{};
  std::array<Vector3, 3> Edges{};

  static FrameCell FromBounds(const Vector3& low, const Vector3& high);
  /** Returns the cell of a box. */
  static FrameCell FromBox(const FrameBox& box);
};

/**
 * Sets the box of a frame to a cell. If the first edge does not point along x, or the second points
 * out of the plane of x and y, cell and centres are turned about the cell's origin until they do
 * not, with a warning. An edge that then points down its axis is replaced by its opposite, which
 * spans the same cell from another corner.
 *
 * Throws std::invalid_argument unless all numbers are finite and the edges span a volume.
 */
void SetBox(PackFrame& frame, const FrameCell& cell, const std::array<bool, 3>& periodic,
  bool periodicityKnown);

/** Turns centres that are fractions of the edges of a cell into coordinates. */
void PlaceFractions(PackFrame& frame, const FrameCell& cell);
}
