// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Vector3.h"
#include "ruc/Images/Fit/VoxelSlab.h"

#include <array>
#include <vector>

namespace ruc
{
/** A sphere in an image: lengths are in mean edges of a voxel, from the lower corner of voxel 0. */
struct Ball
{
  Vector3 Centre{};
  double Radius = 0.0;

  bool operator==(const Ball& other) const
  {
    return this->Centre == other.Centre && this->Radius == other.Radius;
  }
  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Centre, self.Radius);
  }
};

/**
 * The grey values of an image of spheres: Matrix + Contrast sum B_i(x), where B_i is a ball blurred
 * by a Gaussian of deviation `Blur`, and Contrast is what particles have more than the matrix.
 */
struct GreyModel
{
  double Matrix = 0.0, Contrast = 1.0, Blur = 1.0;
  Vector3 Edges = { 1.0, 1.0, 1.0 }; // of a voxel, in their mean

  bool operator==(const GreyModel& other) const
  {
    return this->Matrix == other.Matrix && this->Contrast == other.Contrast &&
      this->Blur == other.Blur && this->Edges == other.Edges;
  }
};

/** Beyond so many blurs outside its surface a ball is not seen. */
constexpr double ReachOfBlur = 4.5;

/** Sums over the voxels around a ball, with g the residual and J_q = Contrast dB/dp_q, where p is
 * the centre's coordinates and the radius. */
struct BallSums
{
  std::array<double, 10> Normal{};  // J J^T: xx xy xz xr yy yz yr zz zr rr
  std::array<double, 4> Gradient{}; // J g
  double BlurSquare = 0.0;          // (Contrast dB/dBlur)^2
  double BlurGradient = 0.0;        // Contrast dB/dBlur g
  double Square = 0.0;              // B^2
  double Product = 0.0;             // B g
  double Weights = 0.0;             // w = (Blur dB/dR)^2, which is seen around the surface
  double WeightedSquares = 0.0;     // w g^2
};

/**
 * The model of a ball, with r the distance from the centre and t = (R - r) / Blur, is
 *
 *     B = Phi(t) - Blur phi(t) / r,    dB/dR = R phi(t) / (r Blur),
 *     dB/dr = phi(t) (Blur / r^2 - R / (r Blur)),  dB/dBlur = -phi(t) (t / Blur + (1 + t^2) / r),
 *
 * in which the far side of the ball is neglected (R > 2 Blur). What is found depends on the ball
 * and the voxels alone, and is found in single precision, which is some 1e-6 of the contrast.
 */
class BlurredBalls
{
public:
  explicit BlurredBalls(const GreyModel& model)
    : Model(model)
  {
  }

  /** Adds the ball, `times` as bright, to a plane of an image. */
  void Add(const Ball& ball, double times, int plane, VoxelSlab<float>& image) const;

  /** Sums up over all voxels around the ball that the slab has. Its values are followed by
   * `ValuesAfter` more, which may be any. */
  BallSums Sum(const Ball& ball, const VoxelSlab<float>& residual) const;
  static constexpr int ValuesAfter = 8;

private:
  /** Returns the voxels, first to last - 1, within a distance of a centre along an axis. */
  std::pair<int, int> Reached(double centre, double reach, int q, int first, int last) const;
  template <class Use>
  void ForEachRow(const Ball& ball, int plane, const VoxelSlab<float>& image, Use&& use) const;

  GreyModel Model;
};
}
