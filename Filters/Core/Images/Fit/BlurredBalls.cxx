// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Images/Fit/BlurredBalls.h"

#include "ruc/Base/VectorClones.h"

#include <cmath>
#include <cstring>

namespace ruc
{
namespace
{
constexpr int Lanes = 8;
constexpr float Cut = 5.5f;           // blurs from the surface beyond which a ball is 0 or 1
constexpr float LeastDistance = 0.5f; // the centre itself has no direction
constexpr float Beyond = 1e4f;        // a distance at which no ball is seen

// A row of voxels around a ball
struct BallRow
{
  int Count = 0;       // of its voxels in the image
  float First = 0.0f;  // from the centre to the first voxel, along x
  float Edge = 1.0f;   // of voxels along x
  float Square = 0.0f; // of the distance across
  float Radius = 1.0f, Blur = 1.0f, Contrast = 1.0f;
};

// Eight voxels side by side: the compiler makes vector instructions of what is done with them, and
// the result is the same for all of these
using Lane = float __attribute__((vector_size(Lanes * sizeof(float))));

// The model at eight voxels
struct BallLanes
{
  Lane Inverse; // of the distance from the centre
  Lane T, Density, Value;
};

inline __attribute__((always_inline)) void Evaluate(
  const BallRow& row, const Lane& step, BallLanes& at)
{
  Lane r = step * step + row.Square;
  for (int l = 0; l < Lanes; ++l)
  {
    r[l] = std::sqrt(r[l]);
  }
  r = r > LeastDistance ? r : Lane{} + LeastDistance;
  at.Inverse = 1.0f / r;
  Lane t = (row.Radius - r) * (1.0f / row.Blur);
  t = t > Cut ? Lane{} + Cut : t;
  t = t < -Cut ? Lane{} - Cut : t;
  // exp(-t^2 / 2) to 2e-6 as the 32nd power of a polynomial, and Phi by Abramowitz and
  // Stegun 7.1.26
  const Lane z = t * t * (1.0f / 64.0f);
  Lane e =
    1.0f - z * (1.0f - z * (0.5f - z * (1.0f / 6.0f - z * (1.0f / 24.0f - z * (1.0f / 120.0f)))));
  e *= e;
  e *= e;
  e *= e;
  e *= e;
  e *= e;
  const Lane size = t > 0.0f ? t : -t;
  const Lane k = 1.0f / (1.0f + 0.23164189f * size);
  const Lane tail = 0.5f * e * k *
    (0.254829592f +
      k * (-0.284496736f + k * (1.421413741f + k * (-1.453152027f + k * 1.061405429f))));
  at.T = t;
  at.Density = e * 0.39894228f;
  at.Value = (t > 0.0f ? 1.0f - tail : tail) - row.Blur * at.Inverse * at.Density;
}

inline __attribute__((always_inline)) void FindSteps(const BallRow& row, int begin, Lane& step)
{
  constexpr Lane counts = { 0.0f, 1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f, 7.0f };
  const Lane place = counts + static_cast<float>(begin);
  step = place < static_cast<float>(row.Count) ? place * row.Edge + row.First : Lane{} + Beyond;
}

RUC_VECTOR_CLONES
void AddBallRow(const BallRow& row, float* image)
{
  for (int begin = 0; begin < row.Count; begin += Lanes)
  {
    Lane step;
    BallLanes at;
    FindSteps(row, begin, step);
    Evaluate(row, step, at);
    at.Value *= row.Contrast;
    if (begin + Lanes <= row.Count)
    {
      Lane values;
      std::memcpy(&values, image + begin, sizeof values);
      values += at.Value;
      std::memcpy(image + begin, &values, sizeof values);
      continue;
    }
    for (int l = 0; begin + l < row.Count; ++l)
    {
      image[begin + l] += at.Value[l];
    }
  }
}

// Sums that eight voxels at a time are added to
struct LaneSums
{
  std::array<Lane, 10> Normal{};
  std::array<Lane, 4> Gradient{};
  Lane BlurSquare{}, BlurGradient{}, Square{}, Product{}, Weights{}, WeightedSquares{};
};

// Adds a row that lies dy and dz from the centre. There are values to read after its end
RUC_VECTOR_CLONES
void SumRow(const BallRow& row, float dy, float dz, const float* residual, LaneSums& sums)
{
  const float scale = 1.0f / row.Blur, c = row.Contrast;
  for (int begin = 0; begin < row.Count; begin += Lanes)
  {
    Lane d, g;
    BallLanes at;
    FindSteps(row, begin, d);
    Evaluate(row, d, at);
    std::memcpy(&g, residual + begin, sizeof g);
    g = d < Beyond ? g : Lane{};
    const Lane &i = at.Inverse, &p = at.Density, &t = at.T, &b = at.Value;
    const Lane jr = c * row.Radius * scale * p * i;
    const Lane k = (jr - c * row.Blur * p * i * i) * i;
    const Lane jx = k * d, jy = k * dy, jz = k * dz;
    const Lane s = -c * p * (t * scale + (1.0f + t * t) * i);
    const Lane w = p * p;
    sums.Normal[0] += jx * jx;
    sums.Normal[1] += jx * jy;
    sums.Normal[2] += jx * jz;
    sums.Normal[3] += jx * jr;
    sums.Normal[4] += jy * jy;
    sums.Normal[5] += jy * jz;
    sums.Normal[6] += jy * jr;
    sums.Normal[7] += jz * jz;
    sums.Normal[8] += jz * jr;
    sums.Normal[9] += jr * jr;
    sums.Gradient[0] += jx * g;
    sums.Gradient[1] += jy * g;
    sums.Gradient[2] += jz * g;
    sums.Gradient[3] += jr * g;
    sums.BlurSquare += s * s;
    sums.BlurGradient += s * g;
    sums.Square += b * b;
    sums.Product += b * g;
    sums.Weights += w;
    sums.WeightedSquares += w * g * g;
  }
}

double Total(const Lane& l)
{
  return ((double(l[0]) + l[4]) + (double(l[1]) + l[5])) +
    ((double(l[2]) + l[6]) + (double(l[3]) + l[7]));
}

BallSums Total(const LaneSums& lanes)
{
  const auto total = [](const Lane& lane) { return Total(lane); };
  BallSums sums;
  std::transform(lanes.Normal.begin(), lanes.Normal.end(), sums.Normal.begin(), total);
  std::transform(lanes.Gradient.begin(), lanes.Gradient.end(), sums.Gradient.begin(), total);
  sums.BlurSquare = Total(lanes.BlurSquare);
  sums.BlurGradient = Total(lanes.BlurGradient);
  sums.Square = Total(lanes.Square);
  sums.Product = Total(lanes.Product);
  sums.Weights = Total(lanes.Weights);
  sums.WeightedSquares = Total(lanes.WeightedSquares);
  return sums;
}
}

std::pair<int, int> BlurredBalls::Reached(
  double centre, double reach, int q, int first, int last) const
{
  const double edge = this->Model.Edges[q];
  return { std::max(first, static_cast<int>(std::ceil((centre - reach) / edge - 0.5))),
    std::min(last, static_cast<int>(std::floor((centre + reach) / edge - 0.5)) + 1) };
}

// Calls use(row, x, y, dy) for the rows of a plane in reach of a ball
template <class Use>
void BlurredBalls::ForEachRow(
  const Ball& ball, int plane, const VoxelSlab<float>& image, Use&& use) const
{
  const double reach = ball.Radius + ReachOfBlur * this->Model.Blur;
  const Vector3& edges = this->Model.Edges;
  const double dz = (plane + 0.5) * edges[2] - ball.Centre[2];
  const double across = reach * reach - dz * dz;
  if (across <= 0.0)
  {
    return;
  }
  BallRow row;
  row.Edge = static_cast<float>(edges[0]);
  row.Radius = static_cast<float>(ball.Radius);
  row.Blur = static_cast<float>(this->Model.Blur);
  row.Contrast = static_cast<float>(this->Model.Contrast);
  const auto [firstRow, lastRow] =
    this->Reached(ball.Centre[1], std::sqrt(across), 1, 0, image.Dimensions[1]);
  for (int y = firstRow; y < lastRow; ++y)
  {
    const double dy = (y + 0.5) * edges[1] - ball.Centre[1];
    const double half = std::sqrt(std::max(0.0, across - dy * dy));
    const auto [first, last] = this->Reached(ball.Centre[0], half, 0, 0, image.Dimensions[0]);
    if (first < last)
    {
      row.Count = last - first;
      row.First = static_cast<float>((first + 0.5) * edges[0] - ball.Centre[0]);
      row.Square = static_cast<float>(dy * dy + dz * dz);
      use(row, first, y, dy, dz);
    }
  }
}

void BlurredBalls::Add(const Ball& ball, double times, int plane, VoxelSlab<float>& image) const
{
  this->ForEachRow(ball, plane, image,
    [&](BallRow& row, int x, int y, double, double)
    {
      row.Contrast = static_cast<float>(times * this->Model.Contrast);
      AddBallRow(row, image.Row(y, plane) + x);
    });
}

BallSums BlurredBalls::Sum(const Ball& ball, const VoxelSlab<float>& residual) const
{
  LaneSums sums;
  const double reach = ball.Radius + ReachOfBlur * this->Model.Blur;
  const auto [first, last] = this->Reached(ball.Centre[2], reach, 2, residual.First, residual.Last);
  for (int z = first; z < last; ++z)
  {
    this->ForEachRow(ball, z, residual,
      [&](const BallRow& row, int x, int y, double dy, double dz) {
        SumRow(row, static_cast<float>(dy), static_cast<float>(dz), residual.Row(y, z) + x, sums);
      });
  }
  return Total(sums);
}
}
