// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Images/Fit/BlurredBalls.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace ruc
{
/** A ball that was fitted to an image. */
struct FittedBall
{
  Ball At;
  /** Its place among the first balls that were added; -1 for those that came later. */
  std::int64_t Start = -1;
  /** What the ball has more than the matrix, over the contrast of the model; near 1 for a particle.
   */
  double Contrast = 1.0;
  /** The contrast over its standard error. */
  double Signal = 0.0;
  /** The deviation of the image from the model around the surface. */
  double Residual = 0.0;
  /** Standard errors: of the centre, in the mean of its coordinates, and of the radius. */
  double CenterError = 0.0, RadiusError = 0.0;
  double Step = 1.0; // how far the last step went, in the parameter that changed most
  // The last step of Gauss and Newton, and how much of it was gone
  std::array<double, 4> Last{};
  double Factor = 1.0;
  // What the ball tells of the blur: the sums of BallSums
  double BlurSquare = 0.0, BlurGradient = 0.0;

  /** Whether the last step was above 0.001 voxels and a twentieth of the standard errors. */
  bool Moves() const;

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.At, self.Start, self.Contrast, self.Signal, self.Residual,
      self.CenterError, self.RadiusError, self.Step, self.Last, self.Factor, self.BlurSquare,
      self.BlurGradient);
  }
};

/** Returns where the balls are. */
std::vector<Ball> BallsOf(const std::vector<FittedBall>& fitted);

/**
 * Fits balls to a grey image by least squares: the image is that of GreyModel, and all noise is
 * independent from voxel to voxel.
 *
 * In a sweep the model is taken from the image, and each ball goes a step of Gauss and Newton in
 * its four parameters, of 0.5 voxels at the most, all from the same residual. Where only few voxels
 * belong to two balls at once this comes to the joint minimum within some ten sweeps. Matrix and
 * Contrast follow from voxels that hardly depend on any surface, those in which the sum of B is
 * nearest to 0 or 1, a hundredth of all at least; Blur follows from all surfaces. A ball that does
 * not move any more (FittedBall::Moves) stays for the rest of a run.
 *
 * The ranks hold the planes of the image around their own. All know all balls; that rank fits a
 * ball in whose planes its centre lies. Whatever is summed over voxels of several ranks are
 * integers, and whatever is summed over balls is added up in their order. So the fit is equal, bit
 * by bit, for any number of ranks and threads. Methods that take part in that are collective.
 */
class SphereFit
{
public:
  /** `image` has no halo. With `fixed` the model's numbers stay as they are. */
  SphereFit(
    VoxelSlab<float> image, const GreyModel& model, bool fixed, double noise, Communicator& ranks);

  /** Adds balls after those that there are. */
  void Add(const std::vector<Ball>& balls);
  /** Keeps the balls for which `keep` holds, in their order. All ranks must agree. */
  void Keep(const std::function<bool(const FittedBall&)>& keep);
  /** No radius becomes larger. */
  void LimitRadius(double largest) { this->LargestRadius = largest; }

  /**
   * Does sweeps until not more than a share `mostMoving` of the balls moves any more, but not more
   * than `most`. Before each `goOn` is asked, which may say no; it is the same on all ranks.
   * Returns whether it never did.
   */
  bool Run(int most, double mostMoving, const std::function<bool()>& goOn);

  /** Returns what is left of the image when all balls are taken from it, with a halo. */
  VoxelSlab<float> FindResidual(int halo);

  const std::vector<FittedBall>& GetBalls() const { return this->Balls; }
  const GreyModel& GetModel() const { return this->Model; }
  int GetSweeps() const { return this->Sweeps; }
  /** Gives the image back, without halo. */
  VoxelSlab<float> TakeImage();

private:
  /** Sums over voxels of plain matrix and of plain particle. */
  struct PlainSums
  {
    std::int64_t Count[2] = {}, Residual[2] = {};
  };
  bool Owns(const FittedBall& ball) const;
  double Reach(const Ball& ball) const { return ball.Radius + ReachOfBlur * this->Model.Blur; }
  /** Holds as many planes as the balls of this rank reach. */
  void Widen();
  /** Sets the residual to what is left of the image, where anything has changed. */
  void Render();
  struct Change
  {
    Ball Of;
    double Times;
  };
  /** Adds balls to the residual, which with `all` is the image before. */
  void Apply(const std::vector<Change>& changes, bool all);
  /** Sums it up where there is plain matrix or particle. */
  PlainSums SumPlain() const;
  void ChooseShare();
  void SumPlane(int z, double share, PlainSums& sums) const;
  void MoveGreys(const PlainSums& sums);
  void MoveBalls();
  FittedBall Moved(const FittedBall& ball, const BallSums& sums) const;

  VoxelSlab<float> Image, Residual;
  GreyModel Model, ShownModel;
  std::vector<Ball> Shown; // what the residual is without; none where it is not known
  bool Fixed;
  double Noise;
  Communicator& Ranks;
  Slabs Planes;
  std::vector<FittedBall> Balls;
  double LargestRadius;
  double Share = 0.0; // of a ball that plain matrix may have at most
  /** Of a plain voxel, over the contrast; at first there may be anything in the way. */
  double MostResidual = 0.5;
  int Halo = 0, Sweeps = 0;
};
}
