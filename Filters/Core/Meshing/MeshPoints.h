// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Meshing/PeriodicMesh.h"

#include <array>
#include <map>
#include <utility>
#include <vector>

namespace ruc
{
/** The points of a mesh with all copies on faces of the box, and the parts that they belong to. */
class MeshPoints
{
public:
  /** A part of a sphere in the box: the copy of the sphere displaced by `Image` edges. */
  struct Part
  {
    int Sphere = -1;
    std::array<int, 3> Image{};
    std::vector<int> OnSurface, Inside; // points of the mesh
  };

  /** Makes all copies of the points, and the parts. */
  MeshPoints(const MeshCell& cell, const std::vector<CellPoint>& points);

  /**
   * Adds a point in the middle of each part, and of each of its flat faces, that has none inside:
   * points on a sphere alone have no tessellation of their own.
   */
  void AddMiddles();

  const std::vector<Part>& Parts() const { return this->AllParts; }
  /** The part on whose surface or in which a point lies, -1 in the matrix. */
  int PartOf(int point) const { return this->Owner[point]; }
  bool IsInside(int point) const { return this->Inner[point]; }

  /** Moves points, copies and parts into a mesh. */
  void Fill(PeriodicMesh& mesh) const;
  const std::vector<Vector3>& Places() const { return this->Place; }

private:
  int PartFor(int sphere, const std::array<int, 3>& image);
  // Adds one copy of a point, at the high planes of `high`
  int AddCopy(const CellPoint& point, const std::array<bool, 3>& high, int base);
  void AddAllCopies(const CellPoint& point);
  // The points of a part on a low plane, where there are three or more and none inside
  std::vector<int> OpenDisc(const Part& part, int axis) const;

  MeshCell Cell;
  std::vector<Part> AllParts;
  std::map<std::pair<int, std::array<int, 3>>, int> PartNumbers;
  std::vector<Vector3> Place;
  std::vector<std::uint8_t> Boundary;
  std::vector<int> PeriodicOf, Owner;
  std::vector<bool> Inner;
};
}
