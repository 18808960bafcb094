// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Homogenisation/CornerOperator.h"

#include "ruc/Base/VectorClones.h"

#include <omp.h>

#include <algorithm>

namespace ruc
{
namespace
{
// Rows of the four edges of voxels along x
struct Edges
{
  const float *Near, *Up, *Back, *Far; // (y, z), (y + 1, z), (y, z + 1), (y + 1, z + 1)
};

// The derivatives of a row of voxels; `work` has room for three rows and a number more in each
RUC_VECTOR_CLONES void GradientRow(const Edges& edges, int count, const float* weight,
  const float* uniform, float* work, float* const* gradient)
{
  float* sum = work;
  float* alongY = work + count + 1;
  float* alongZ = work + 2 * (count + 1);
  for (int x = 0; x < count; ++x)
  {
    const float near = edges.Near[x] + edges.Far[x], mixed = edges.Up[x] + edges.Back[x];
    const float across = edges.Far[x] - edges.Near[x], turned = edges.Up[x] - edges.Back[x];
    sum[x] = near + mixed;
    alongY[x] = across + turned;
    alongZ[x] = across - turned;
  }
  sum[count] = sum[0];
  alongY[count] = alongY[0];
  alongZ[count] = alongZ[0];
  for (int x = 0; x < count; ++x)
  {
    gradient[0][x] = weight[0] * (sum[x + 1] - sum[x]) + uniform[0];
    gradient[1][x] = weight[1] * (alongY[x] + alongY[x + 1]) + uniform[1];
    gradient[2][x] = weight[2] * (alongZ[x] + alongZ[x + 1]) + uniform[2];
  }
}

// The transpose: fluxes along x, y, z of the four rows of voxels around a row of corners
struct Around
{
  const float* Flux[3][4]; // of the voxels (y - 1, z - 1), (y, z - 1), (y - 1, z), (y, z)
};
RUC_VECTOR_CLONES void DivergenceRow(
  const Around& around, int count, const float* weight, float* work, float* result)
{
  float* alongX = work + 1;
  float* rest = work + count + 2;
  for (int x = 0; x < count; ++x)
  {
    const auto sum = [&](int d, float up, float back, float far)
    {
      return around.Flux[d][0][x] + up * around.Flux[d][1][x] + back * around.Flux[d][2][x] +
        far * around.Flux[d][3][x];
    };
    alongX[x] = weight[0] * sum(0, 1.0f, 1.0f, 1.0f);
    rest[x] = weight[1] * sum(1, -1.0f, 1.0f, -1.0f) + weight[2] * sum(2, 1.0f, -1.0f, -1.0f);
  }
  alongX[-1] = alongX[count - 1];
  rest[-1] = rest[count - 1];
  for (int x = 0; x < count; ++x)
  {
    result[x] = (alongX[x - 1] - alongX[x]) + (rest[x - 1] + rest[x]);
  }
}
}

int FluxOf(int components, int c, int d)
{
  constexpr int stresses[3][3] = { { 0, 5, 4 }, { 5, 1, 3 }, { 4, 3, 2 } };
  return components == 1 ? d : stresses[c][d];
}

struct CornerOperator::Room
{
  Room(int components, int fluxes, std::size_t plane, int row)
    : Work(3 * (row + 2))
    , Gradients(std::size_t(3) * components * row)
    , Fluxes(2 * fluxes * plane)
    , FluxCount(fluxes)
    , Plane(plane)
  {
  }
  float* Flux(int n, int component)
  {
    return this->Fluxes.data() + ((n % 2) * this->FluxCount + component) * this->Plane;
  }
  std::vector<float> Work, Gradients, Fluxes;
  int FluxCount;
  std::size_t Plane;
};

CornerOperator::CornerOperator(const CellSlab& slab, const VoxelLaw& law)
  : Slab(slab)
  , Law(law)
{
  for (int q = 0; q < 3; ++q)
  {
    this->Weight[q] = static_cast<float>(0.25 / slab.Source.Spacing[q]);
  }
}

void CornerOperator::FindFlux(
  const CornerField& u, const MacroGradient& uniform, int n, Room& room) const
{
  const int nx = this->Slab.Dimensions()[0], ny = this->Slab.Dimensions()[1];
  const int components = u.Components();
  float* gradients[MostGradients];
  float constant[MostGradients];
  for (int g = 0; g < 3 * components; ++g)
  {
    gradients[g] = room.Gradients.data() + std::size_t(g) * nx;
    constant[g] = static_cast<float>(uniform[g]);
  }
  for (int y = 0; y < ny; ++y)
  {
    const std::size_t row = std::size_t(y) * nx, next = std::size_t((y + 1) % ny) * nx;
    for (int c = 0; c < components; ++c)
    {
      const float* below = u.Plane(c, n);
      const float* above = u.Plane(c, n + 1);
      GradientRow({ below + row, below + next, above + row, above + next }, nx, this->Weight.data(),
        constant + 3 * c, room.Work.data(), gradients + 3 * c);
    }
    float* flux[MostFluxes];
    for (int f = 0; f < room.FluxCount; ++f)
    {
      flux[f] = room.Flux(n, f) + row;
    }
    this->Law.Flux(n * room.Plane + row, nx, gradients, flux);
  }
}

void CornerOperator::Collect(int n, CornerField& result, Room& room) const
{
  const int nx = this->Slab.Dimensions()[0], ny = this->Slab.Dimensions()[1];
  for (int c = 0; c < result.Components(); ++c)
  {
    for (int y = 0; y < ny; ++y)
    {
      const std::size_t row = std::size_t(y) * nx, former = std::size_t((y + ny - 1) % ny) * nx;
      Around around;
      for (int d = 0; d < 3; ++d)
      {
        const int f = FluxOf(result.Components(), c, d);
        const float* below = room.Flux(n - 1, f);
        const float* above = room.Flux(n, f);
        around.Flux[d][0] = below + former;
        around.Flux[d][1] = below + row;
        around.Flux[d][2] = above + former;
        around.Flux[d][3] = above + row;
      }
      DivergenceRow(around, nx, this->Weight.data(), room.Work.data(), result.Plane(c, n) + row);
    }
  }
}

void CornerOperator::Apply(const CornerField& u, const MacroGradient& uniform, CornerField& result,
  const TakeFlux& take) const
{
  const int planes = this->Slab.OwnPlanes();
#pragma omp parallel
  {
    const int thread = omp_get_thread_num(), threads = omp_get_num_threads();
    const int begin = 1 + planes * thread / threads, end = 1 + planes * (thread + 1) / threads;
    Room room(u.Components(), this->Law.FluxComponents(), this->Slab.PlaneSize(),
      this->Slab.Dimensions()[0]);
    if (begin < end)
    {
      this->FindFlux(u, uniform, begin - 1, room);
    }
    for (int n = begin; n < end; ++n)
    {
      this->FindFlux(u, uniform, n, room);
      if (take)
      {
        const float* flux[MostFluxes];
        for (int f = 0; f < room.FluxCount; ++f)
        {
          flux[f] = room.Flux(n, f);
        }
        take(this->Slab.PlaneOf(n), flux);
      }
      this->Collect(n, result, room);
    }
  }
}
}
