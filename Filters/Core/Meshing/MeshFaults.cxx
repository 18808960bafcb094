// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Base/Text.h"
#include "ruc/Meshing/PeriodicMesh.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace ruc
{
namespace
{
constexpr double TolerableVolume = 1e-12; // of the box

using Face = std::array<int, 3>;

Face Sorted(Face face)
{
  std::sort(face.begin(), face.end());
  return face;
}

// Each face as often as it appears in a tetrahedron, in order
std::vector<Face> AllFaces(const PeriodicMesh& mesh)
{
  std::vector<Face> faces;
  faces.reserve(4 * mesh.Cells.size());
  for (const Tetrahedron& c : mesh.Cells)
  {
    faces.push_back(Sorted({ c[1], c[2], c[3] }));
    faces.push_back(Sorted({ c[0], c[2], c[3] }));
    faces.push_back(Sorted({ c[0], c[1], c[3] }));
    faces.push_back(Sorted({ c[0], c[1], c[2] }));
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

std::string FaultOfPoints(const PeriodicMesh& mesh)
{
  for (std::size_t n = 0; n < mesh.Points.size(); ++n)
  {
    const int base = mesh.PeriodicOf[n];
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool isLow = mesh.Boundary[n] >> (2 * axis) & 1;
      const bool isHigh = mesh.Boundary[n] >> (2 * axis + 1) & 1;
      const double place = mesh.Points[n][axis], ofBase = mesh.Points[base][axis];
      const bool isGood = isHigh ? place == mesh.Edge[axis] && ofBase == 0.0
        : isLow                  ? place == 0.0 && ofBase == 0.0
                                 : place > 0.0 && place < mesh.Edge[axis] && ofBase == place;
      if (!isGood)
      {
        return Text("point ", n, " lies at ", place, " along axis ", axis, ", its copy ", base,
          " at ", ofBase);
      }
    }
  }
  return {};
}

// The faces of one side of the box, by the points that they are copies of
std::vector<Face> FacesOfSide(
  const PeriodicMesh& mesh, const std::vector<Face>& open, std::uint8_t side)
{
  std::vector<Face> faces;
  for (const Face& face : open)
  {
    if (mesh.Boundary[face[0]] & mesh.Boundary[face[1]] & mesh.Boundary[face[2]] & side)
    {
      faces.push_back(
        Sorted({ mesh.PeriodicOf[face[0]], mesh.PeriodicOf[face[1]], mesh.PeriodicOf[face[2]] }));
    }
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

std::string FaultOfFaces(const PeriodicMesh& mesh)
{
  const std::vector<Face> faces = AllFaces(mesh);
  std::vector<Face> open;
  for (std::size_t n = 0; n < faces.size();)
  {
    std::size_t end = n + 1;
    while (end < faces.size() && faces[end] == faces[n])
    {
      ++end;
    }
    if (end - n > 2)
    {
      return Text(
        "face ", faces[n][0], " ", faces[n][1], " ", faces[n][2], " has ", end - n, " tetrahedra");
    }
    if (end - n == 1)
    {
      open.push_back(faces[n]);
    }
    n = end;
  }
  std::size_t onBox = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto low = static_cast<std::uint8_t>(1u << (2 * axis));
    const std::vector<Face> faceOfLow = FacesOfSide(mesh, open, low);
    if (faceOfLow != FacesOfSide(mesh, open, static_cast<std::uint8_t>(2 * low)))
    {
      return Text("the triangles on both faces across axis ", axis, " differ");
    }
    onBox += 2 * faceOfLow.size();
  }
  return onBox == open.size() ? std::string()
                              : Text(open.size() - onBox, " faces inside have one tetrahedron");
}
}

std::string FindFault(const PeriodicMesh& mesh)
{
  double volume = 0.0;
  for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    const double own = mesh.VolumeOf(cell);
    if (!(own > 0.0))
    {
      return Text("tetrahedron ", cell, " has the volume ", own);
    }
    volume += own;
  }
  std::string fault = FaultOfPoints(mesh);
  fault = fault.empty() ? FaultOfFaces(mesh) : fault;
  const double box = mesh.Edge[0] * mesh.Edge[1] * mesh.Edge[2];
  if (fault.empty() && std::abs(volume - box) > TolerableVolume * box)
  {
    return Text("the volumes add to ", volume, ", not to ", box);
  }
  return fault;
}
}
