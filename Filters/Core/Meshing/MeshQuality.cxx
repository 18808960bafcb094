// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Meshing/MeshQuality.h"

#include <algorithm>
#include <cmath>

namespace ruc
{
namespace
{
constexpr double Small = 5.0, Large = 170.0, Flat = 175.0;

// The corners of the face opposite to each corner, with the normal out of the tetrahedron
constexpr int FaceOf[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };

Vector3 Minus(const Vector3& a, const Vector3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

struct KeyedFace
{
  std::array<int, 3> Key{};
  std::int64_t Place = 0; // 4 times the tetrahedron, and the corner opposite
};
}

std::array<double, 6> DihedralAngles(
  const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  const Vector3* corners[4] = { &a, &b, &c, &d };
  Vector3 normal[4];
  for (int k = 0; k < 4; ++k)
  {
    const auto& face = FaceOf[k];
    const Vector3& origin = *corners[face[0]];
    normal[k] = Cross(Minus(*corners[face[1]], origin), Minus(*corners[face[2]], origin));
  }
  std::array<double, 6> angles{};
  int n = 0;
  for (int k = 0; k < 4; ++k)
  {
    for (int l = k + 1; l < 4; ++l)
    {
      // The arc tangent keeps its digits near 0 and 180 degrees
      const double sine = Length(Cross(normal[k], normal[l])), cosine = -Dot(normal[k], normal[l]);
      angles[n++] = 180.0 / Pi * std::atan2(sine, cosine);
    }
  }
  return angles;
}

std::array<MeshQuality, 2> MeasureQuality(const PeriodicMesh& mesh)
{
  std::array<MeshQuality, 2> quality;
  for (std::size_t n = 0; n < mesh.Cells.size(); ++n)
  {
    const Tetrahedron& cell = mesh.Cells[n];
    const std::array<double, 6> angles = DihedralAngles(
      mesh.Points[cell[0]], mesh.Points[cell[1]], mesh.Points[cell[2]], mesh.Points[cell[3]]);
    MeshQuality& of = quality[mesh.Particle[n] >= 0];
    ++of.Cells;
    of.Volume += mesh.VolumeOf(n);
    for (const double angle : angles)
    {
      const int bin = static_cast<int>(angle / 180.0 * MeshQuality::Bins);
      ++of.Angles[std::min(bin, MeshQuality::Bins - 1)];
    }
    const auto [least, largest] = std::minmax_element(angles.begin(), angles.end());
    of.LeastAngle = std::min(of.LeastAngle, *least);
    of.LargestAngle = std::max(of.LargestAngle, *largest);
    of.Below5 += *least < Small;
    of.Above170 += *largest > Large;
    of.Above175 += *largest > Flat;
  }
  return quality;
}

std::vector<SurfaceTriangle> FindSurfaces(const PeriodicMesh& mesh)
{
  std::vector<KeyedFace> faces;
  faces.reserve(4 * mesh.Cells.size());
  for (std::size_t n = 0; n < mesh.Cells.size(); ++n)
  {
    for (int k = 0; k < 4; ++k)
    {
      const auto& face = FaceOf[k];
      KeyedFace keyed{ { mesh.Cells[n][face[0]], mesh.Cells[n][face[1]], mesh.Cells[n][face[2]] },
        static_cast<std::int64_t>(4 * n + k) };
      std::sort(keyed.Key.begin(), keyed.Key.end());
      faces.push_back(keyed);
    }
  }
  std::sort(faces.begin(), faces.end(),
    [](const KeyedFace& a, const KeyedFace& b)
    { return std::tie(a.Key, a.Place) < std::tie(b.Key, b.Place); });
  std::vector<std::int64_t> places;
  for (std::size_t n = 0; n + 1 < faces.size(); ++n)
  {
    const KeyedFace &a = faces[n], &b = faces[n + 1];
    const int ofA = mesh.Particle[a.Place / 4], ofB = mesh.Particle[b.Place / 4];
    if (a.Key == b.Key && ofA != ofB)
    {
      places.push_back(ofA >= 0 ? a.Place : b.Place);
    }
  }
  std::sort(places.begin(), places.end());
  std::vector<SurfaceTriangle> triangles;
  for (const std::int64_t place : places)
  {
    const Tetrahedron& cell = mesh.Cells[place / 4];
    const auto& face = FaceOf[place % 4];
    triangles.push_back(
      { { cell[face[0]], cell[face[1]], cell[face[2]] }, mesh.Particle[place / 4] });
  }
  return triangles;
}
}
