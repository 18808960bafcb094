// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Ranks.h"
#include "VoxelImages.h"

#include "vtkRUCParticlesFromImage.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

using Particles = vtkRUCParticlesFromImage;

/** The image of six balls, two of them cut by its border, that the tests of particles look at. */
namespace ParticleImages
{
constexpr int Size[3] = { 41, 29, 36 };
constexpr double VoxelEdge = 0.5; // of a voxel
constexpr double Origin[3] = { 1.0, 2.0, 3.0 };

struct Sphere
{
  double X, Y, Z, Radius; // in voxels; the last two are cut
};
inline const Sphere Spheres[] = { { 10.2, 11.0, 10.1, 6.5 }, { 28.3, 12.1, 11.5, 5.2 },
  { 12.0, 14.9, 26.3, 7.0 }, { 19.8, 17.0, 13.0, 3.9 }, { 38.5, 14.0, 24.0, 6.0 },
  { 27.0, 20.0, 34.0, 6.8 } };
constexpr int NumberOfSpheres = 6;

inline double BlurredBall(const Sphere& ball, int x, int y, int z)
{
  constexpr double blur = 1.05;
  const double r = std::max(0.1, std::hypot(x + 0.5 - ball.X, y + 0.5 - ball.Y, z + 0.5 - ball.Z));
  const double t = (ball.Radius - r) / blur;
  return 0.5 * std::erfc(-t / std::sqrt(2.0)) -
    blur / r * std::exp(-0.5 * t * t) / std::sqrt(2.0 * 3.14159265358979324);
}

// Between 500 in the matrix and 900, with even noise of a deviation of a tenth of that
inline double GreyAt(int x, int y, int z)
{
  double value = 500.0;
  for (const Sphere& ball : Spheres)
  {
    value += 400.0 * BlurredBall(ball, x, y, z);
  }
  std::uint32_t hash = 73856093u * x ^ 19349663u * y ^ 83492791u * z;
  hash = (hash ^ (hash >> 15)) * 2246822519u;
  hash = (hash ^ (hash >> 13)) * 3266489917u;
  const double even = ((hash ^ (hash >> 16)) & 0xffff) / 65536.0 - 0.5;
  return std::rint(value + 40.0 * std::sqrt(12.0) * even);
}

inline double LabelAt(int x, int y, int z)
{
  for (int n = 0; n < NumberOfSpheres; ++n)
  {
    const Sphere& ball = Spheres[n];
    if (std::hypot(x + 0.5 - ball.X, y + 0.5 - ball.Y, z + 0.5 - ball.Z) < ball.Radius)
    {
      return 10.0 * (n + 1);
    }
  }
  return 0.0;
}

inline const Form Forms[] = { { "integers on cells", false, VTK_UNSIGNED_SHORT },
  { "floats on points", true, VTK_FLOAT } };

inline vtkSmartPointer<vtkImageData> MakeImage(
  const Form& form, int axis, int begin, int end, const Value& value, const char* name = "Grey")
{
  return VoxelImage{ { Size[0], Size[1], Size[2] }, VoxelEdge, name }.Make(
    form, axis, begin, end, value);
}

inline vtkSmartPointer<vtkImageData> Piece(
  const Form& form, int axis, const Value& value = GreyAt, const char* name = "Grey")
{
  const int ranks = NumberOfRanks(), n = Size[axis];
  return MakeImage(form, axis, n * Rank() / ranks, n * (Rank() + 1) / ranks, value, name);
}
}
