// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * How well spheres are found in grey images, and how fast: the bead block with so many voxels in a
 * mean diameter, and a pack of spheres that touch; their exact shares of voxels, a blur of a voxel,
 * and noise in shares of the contrast. Errors are those of whole spheres of half the mean diameter
 * and more, over what is possible (Cramer and Rao). `--paper` finds those of the paper's image, 513
 * x 457 x 280 voxels, alone; `--watershed` those that a watershed finds. One thread.
 */
#include "ExamplePack.h"
#include "EnclosedPacks.h"
#include "Images/Fit/GreyScenes.h"
#include "ruc/Images/Fit/FindSpheres.h"
#include "ruc/Images/Watershed/CutParticles.h"

#include <chrono>
#include <cstdio>
#include <cstring>
#include <map>

namespace
{
using oracle::GreyScene;
using ruc::Ball;
using ruc::FittedBall;

// The middle of the bead block, with about so many spheres
GreyScene Beads(double voxelsOfDiameter, double spheres, double noise)
{
  const ruc::SpherePack pack = ReadPack();
  const ruc::Vector3& box = Block.Size;
  double diameter = 0.0;
  for (double radius : pack.Radius)
  {
    diameter += 2.0 * radius / static_cast<double>(pack.Size());
  }
  const double edge = diameter / voxelsOfDiameter;
  const double share = std::min(1.0, std::cbrt(spheres / static_cast<double>(pack.Size())));
  GreyScene scene;
  scene.Noise = noise;
  for (int q = 0; q < 3; ++q)
  {
    scene.Dimensions[q] = static_cast<int>(box[q] * share / edge);
  }
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    Ball ball = { pack.Centre(i), pack.Radius[i] / edge };
    for (int q = 0; q < 3; ++q)
    {
      ball.Centre[q] = (ball.Centre[q] - 0.5 * box[q] * (1.0 - share)) / edge;
    }
    scene.Balls.push_back(ball);
  }
  return scene;
}

// Spheres that touch, and overlap by 0.04 % of their diameters in the mean
GreyScene Touching(double voxelsOfDiameter, int spheres, double noise)
{
  const std::vector<double> radii = oracle::LognormalRadii(spheres, 0.2, 3);
  double volume = 0.0, diameter = 0.0;
  for (double radius : radii)
  {
    volume += 4.0 / 3.0 * oracle::Pi * radius * radius * radius;
    diameter += 2.0 * radius / spheres;
  }
  const double edge = std::cbrt(volume / 0.54), voxel = diameter / voxelsOfDiameter;
  const ruc::SpherePack pack = oracle::PackBetweenWalls(
    radii, ruc::Window::MakeBox({ 0, 0, 0 }, { edge, edge, edge }, {}), 5, 1500);
  GreyScene scene;
  scene.Noise = noise;
  scene.Dimensions.fill(static_cast<int>(edge / voxel));
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    scene.Balls.push_back({ { pack.X[i] / voxel, pack.Y[i] / voxel, pack.Z[i] / voxel },
      0.999 * pack.Radius[i] / voxel });
  }
  return scene;
}

class Nearest
{
public:
  explicit Nearest(const std::vector<FittedBall>& balls)
    : Balls(balls)
  {
    for (std::size_t n = 0; n < balls.size(); ++n)
    {
      this->Cells[CellOf(balls[n].At.Centre, { 0, 0, 0 })].push_back(n);
    }
  }
  // The place of the ball with the centre nearest to that of another, or -1 beyond half its radius
  long Find(const Ball& ball) const
  {
    long found = -1;
    double least = 0.5 * ball.Radius;
    for (int k = 0; k < 27; ++k)
    {
      const auto cell =
        this->Cells.find(CellOf(ball.Centre, { k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1 }));
      for (std::size_t m = 0; cell != this->Cells.end() && m < cell->second.size(); ++m)
      {
        const std::size_t n = cell->second[m];
        const ruc::Vector3& c = this->Balls[n].At.Centre;
        const double away =
          std::hypot(c[0] - ball.Centre[0], c[1] - ball.Centre[1], c[2] - ball.Centre[2]);
        if (away < least)
        {
          least = away;
          found = static_cast<long>(n);
        }
      }
    }
    return found;
  }

private:
  using Cell = std::array<int, 3>;
  static Cell CellOf(const ruc::Vector3& p, const Cell& step)
  {
    Cell cell;
    for (int q = 0; q < 3; ++q)
    {
      cell[q] = static_cast<int>(std::floor(p[q] / 12.0)) + step[q];
    }
    return cell;
  }
  const std::vector<FittedBall>& Balls;
  std::map<Cell, std::vector<std::size_t>> Cells;
};

// How far a centre is within an image
double DepthOf(const GreyScene& scene, const ruc::Vector3& centre)
{
  double depth = 1e9;
  for (int q = 0; q < 3; ++q)
  {
    depth = std::min({ depth, centre[q], scene.Dimensions[q] - centre[q] });
  }
  return depth;
}

void Report(
  const char* name, const GreyScene& scene, const ruc::FoundSpheres& found, double seconds)
{
  const Nearest nearest(found.Balls);
  double mean = 0.0, radii = 0.0, centres = 0.0, bias = 0.0, pull = 0.0, volume = 0.0, truth = 0.0;
  double share = 0.0;
  int here[2] = {}, missing[2] = {}, whole = 0;
  for (const Ball& ball : scene.Balls)
  {
    mean += 2.0 * ball.Radius / static_cast<double>(scene.Balls.size());
  }
  std::vector<bool> known(found.Balls.size(), false);
  for (const Ball& ball : scene.Balls)
  {
    const long n = nearest.Find(ball);
    if (n >= 0)
    {
      known[n] = true;
    }
    // Centres within half a voxel of the border may be found on its other side
    const double depth = DepthOf(scene, ball.Centre), diameter = 2.0 * ball.Radius;
    if (depth < 0.5 || diameter < 4.0)
    {
      continue;
    }
    ++here[diameter < 5.0];
    missing[diameter < 5.0] += n < 0 ? 1 : 0;
    if (n < 0 || depth < ball.Radius + 4.0 || diameter < std::max(5.0, 0.5 * mean))
    {
      continue;
    }
    const FittedBall& fit = found.Balls[n];
    const double blur = std::sqrt(1.0 + 1.0 / 12.0);
    const double bound = std::max(scene.Noise, 1e-3) *
      std::sqrt(2.0 * std::sqrt(oracle::Pi) * blur / (4.0 * oracle::Pi)) / ball.Radius;
    const double error = fit.At.Radius - ball.Radius;
    double away = 0.0;
    for (int q = 0; q < 3; ++q)
    {
      away += std::pow(fit.At.Centre[q] - ball.Centre[q], 2) / 3.0;
    }
    ++whole;
    radii += std::pow(error / bound, 2);
    centres += away / (3.0 * bound * bound);
    pull += std::pow(error / fit.RadiusError, 2);
    share += std::pow(error / ball.Radius, 2);
    bias += error / ball.Radius;
    volume += std::pow(fit.At.Radius, 3);
    truth += std::pow(ball.Radius, 3);
  }
  int wrong = 0;
  for (std::size_t n = 0; n < known.size(); ++n)
  {
    wrong += !known[n] && DepthOf(scene, found.Balls[n].At.Centre) > 0.5 ? 1 : 0;
  }
  const double voxels = 1e-6 * scene.Dimensions[0] * scene.Dimensions[1] * scene.Dimensions[2];
  std::printf(
    "%-26s missing %d of %d, %d of %d from 4 to 5 voxels; false %d; over the bound: radius "
    "%.3f, centre %.3f, over its error %.3f; radius rms %.3f %%, bias %.4f %%, volume "
    "%.4f %%; %.2f s a million voxels\n",
    name, missing[0], here[0], missing[1], here[1], wrong, std::sqrt(radii / whole),
    std::sqrt(centres / whole), std::sqrt(pull / whole), 100.0 * std::sqrt(share / whole),
    100.0 * bias / whole, 100.0 * (volume / truth - 1.0), seconds / voxels);
  std::fflush(stdout);
}

// The grey values, in which the blur brings what lies beyond the border
std::vector<float> ValuesOf(const GreyScene& scene)
{
  constexpr int margin = 6;
  GreyScene wide = scene;
  for (Ball& ball : wide.Balls)
  {
    for (double& q : ball.Centre)
    {
      q += margin;
    }
  }
  for (int& voxels : wide.Dimensions)
  {
    voxels += 2 * margin;
  }
  const std::vector<float> all = oracle::GreysOf(wide);
  std::vector<float> values;
  for (int z = 0; z < scene.Dimensions[2]; ++z)
  {
    for (int y = 0; y < scene.Dimensions[1]; ++y)
    {
      const auto row = all.begin() + margin +
        static_cast<std::ptrdiff_t>(wide.Dimensions[0]) *
          (y + margin + static_cast<std::ptrdiff_t>(wide.Dimensions[1]) * (z + margin));
      values.insert(values.end(), row, row + scene.Dimensions[0]);
    }
  }
  return values;
}

// What a watershed finds in place of a fit
void MeasureCut(const char* name, const GreyScene& scene)
{
  ruc::Communicator serial;
  ruc::VoxelSlab<float> image = { scene.Dimensions, 0, scene.Dimensions[2], ValuesOf(scene) };
  const auto begin = std::chrono::steady_clock::now();
  const ruc::CutParticles cut = ruc::CutImage(std::move(image), {}, serial);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  ruc::FoundSpheres found;
  for (const ruc::ParticleShape& shape : cut.Shapes)
  {
    ruc::FittedBall& ball = found.Balls.emplace_back();
    ball.At = { shape.Centre, shape.EqualVolumeRadius() };
    ball.RadiusError = 1.0; // it tells none
  }
  Report(name, scene, found, seconds.count());
}

void Measure(const char* name, const GreyScene& scene)
{
  ruc::Communicator serial;
  ruc::VoxelSlab<float> image = { scene.Dimensions, 0, scene.Dimensions[2], ValuesOf(scene) };
  const auto begin = std::chrono::steady_clock::now();
  const ruc::FoundSpheres found = ruc::FindSpheres(image, {}, {}, serial);
  Report(name, scene, found,
    std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
}
}

int main(int count, char* arguments[])
{
  const auto asks = [&](const char* option)
  { return count > 1 && std::strcmp(arguments[1], option) == 0; };
  if (asks("--paper"))
  {
    Measure("paper's image", Beads(15.6, 1e9, 0.1));
    return 0;
  }
  if (asks("--watershed"))
  {
    MeasureCut("watershed, 15.6", Beads(15.6, 4500, 0.1));
    MeasureCut("watershed, 20", Beads(20.0, 4500, 0.1));
    MeasureCut("watershed, touching, 20", Touching(20.0, 1000, 0.1));
    MeasureCut("watershed, touching, 10", Touching(10.0, 2000, 0.1));
    MeasureCut("watershed, paper's image", Beads(15.6, 1e9, 0.1));
    return 0;
  }
  Measure("8 voxels a diameter", Beads(8.0, 4500, 0.1));
  Measure("10", Beads(10.0, 4500, 0.1));
  Measure("15.6", Beads(15.6, 4500, 0.1));
  Measure("20", Beads(20.0, 4500, 0.1));
  Measure("30", Beads(30.0, 500, 0.1));
  Measure("20, noise 0", Beads(20.0, 1000, 0.0));
  Measure("20, noise 30 %", Beads(20.0, 1000, 0.3));
  Measure("20, noise 50 %", Beads(20.0, 1000, 0.5));
  Measure("touching, 20", Touching(20.0, 1000, 0.1));
  Measure("touching, 10", Touching(10.0, 2000, 0.1));
  return 0;
}
