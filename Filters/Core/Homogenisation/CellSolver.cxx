// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Homogenisation/CellSolver.h"

#include "ruc/Base/Require.h"

#include <algorithm>
#include <numeric>

namespace ruc
{
namespace
{
constexpr int WatchedSteps = 4;

// a += factor b in the own planes
void AddTimes(CornerField& a, double factor, const CornerField& b, const CellSlab& slab)
{
  const auto share = static_cast<float>(factor);
  for (int c = 0; c < a.Components(); ++c)
  {
#pragma omp parallel for
    for (int n = 1; n <= slab.OwnPlanes(); ++n)
    {
      float* to = a.Plane(c, n);
      const float* from = b.Plane(c, n);
      for (std::size_t x = 0; x < slab.PlaneSize(); ++x)
      {
        to[x] += share * from[x];
      }
    }
  }
}
}

void ValidateSolver(const SolverSettings& settings)
{
  Require(settings.Tolerance > 0.0 && settings.Tolerance < 1.0, "Tolerance", "a number > 0 and < 1",
    settings.Tolerance);
  Require(settings.MaximumIterations >= 1, "MaximumIterations", "a number >= 1",
    settings.MaximumIterations);
}

CellSolver::CellSolver(const CellSlab& slab, const VoxelLaw& law, Communicator& ranks)
  : Slab(slab)
  , Ranks(ranks)
  , Components(law.Components())
  , Fluxes(law.FluxComponents())
  , Corners(static_cast<double>(slab.PlaneSize()) * slab.Planes.Count)
  , Equations(slab, law)
  , Preconditioner(slab, law.Reference(), law.Components(), ranks)
  , Residual(slab, law.Components())
  , Direction(slab, law.Components())
  , Image(slab, law.Components())
{
}

MacroGradient CellSolver::GradientOf(int components, int of)
{
  MacroGradient uniform{};
  for (int c = 0; c < components; ++c)
  {
    for (int d = 0; d < 3; ++d)
    {
      // Of a shear both derivatives have a half
      uniform[3 * c + d] = FluxOf(components, c, d) != of ? 0.0
        : components > 1 && c != d                        ? 0.5
                                                          : 1.0;
    }
  }
  return uniform;
}

double CellSolver::Dot(const CornerField& a, const CornerField& b)
{
  std::vector<double> planes(this->Slab.OwnPlanes());
#pragma omp parallel for
  for (int n = 0; n < this->Slab.OwnPlanes(); ++n)
  {
    for (int c = 0; c < this->Components; ++c)
    {
      planes[n] += DotOfPlane(a.Plane(c, n + 1), b.Plane(c, n + 1), this->Slab.PlaneSize());
    }
  }
  return SumInOrder(planes, this->Ranks);
}

std::array<double, MostFluxes> CellSolver::MeanFlux(
  const MacroGradient& uniform, const CornerField& u)
{
  std::array<std::vector<double>, MostFluxes> planes;
  for (std::vector<double>& of : planes)
  {
    of.resize(this->Slab.OwnPlanes());
  }
  const std::vector<float> ones(this->Slab.PlaneSize(), 1.0f);
  this->Equations.Apply(u, uniform, this->Residual,
    [&](int z, const float* const* flux)
    {
      for (int f = 0; f < this->Fluxes; ++f)
      {
        planes[f][z - this->Slab.Begin] = DotOfPlane(flux[f], ones.data(), ones.size());
      }
    });
  std::array<double, MostFluxes> mean{};
  for (int f = 0; f < this->Fluxes; ++f)
  {
    mean[f] = SumInOrder(planes[f], this->Ranks) / this->Corners;
  }
  return mean;
}

void CellSolver::SolveCase(int of, const SolverSettings& settings, const Progress& progress,
  EffectiveTensor& tensor, CornerField& u)
{
  double energy = this->MeanFlux(GradientOf(this->Components, of), u)[of];
  // The residual is what is wanted less what there is
  AddTimes(this->Residual, -2.0, this->Residual, this->Slab);
  std::vector<double> falls;
  double former = 0.0, recent = energy;
  SolverEnd end = SolverEnd::MaximumIterations;
  for (int step = 1; step <= settings.MaximumIterations; ++step)
  {
    const double product =
      this->Preconditioner.Step(this->Residual, former, this->Direction, this->Ranks);
    this->Direction.UpdateHalo(this->Slab, this->Ranks);
    this->Equations.Apply(this->Direction, {}, this->Image);
    const double curvature = this->Dot(this->Direction, this->Image);
    former = product;
    // Nothing is left to do in a uniform cell
    const double length = curvature > 0.0 ? product / curvature : 0.0;
    AddTimes(u, length, this->Direction, this->Slab);
    AddTimes(this->Residual, -length, this->Image, this->Slab);
    falls.push_back(length * product / this->Corners);
    energy -= falls.back();
    const std::size_t watched = std::min<std::size_t>(WatchedSteps, falls.size());
    recent = std::accumulate(falls.end() - watched, falls.end(), 0.0);
    tensor.Steps.push_back({ of, step, energy });
    tensor.Iterations[of] = step;
    const bool goOn = this->Ranks.All(!progress || progress(tensor.Steps.back()));
    if (falls.back() <= 0.0 || (watched == WatchedSteps && recent < settings.Tolerance * energy))
    {
      end = SolverEnd::Tolerance;
      break;
    }
    if (!goOn)
    {
      end = SolverEnd::Stopped;
      break;
    }
  }
  tensor.IterationError[of] = recent;
  tensor.EndedBy = std::max(tensor.EndedBy, end);
}

EffectiveTensor CellSolver::Solve(
  const SolverSettings& settings, const Progress& progress, const Solved& solved)
{
  ValidateSolver(settings);
  EffectiveTensor tensor;
  tensor.Size = this->Fluxes;
  std::vector<CornerField> solutions;
  for (int of = 0; of < tensor.Size; ++of)
  {
    CornerField& u = solutions.emplace_back(this->Slab, this->Components);
    if (tensor.EndedBy != SolverEnd::Stopped)
    {
      this->SolveCase(of, settings, progress, tensor, u);
    }
    u.UpdateHalo(this->Slab, this->Ranks);
    const std::array<double, MostFluxes> mean = this->MeanFlux(GradientOf(this->Components, of), u);
    for (int a = 0; a <= of; ++a)
    {
      tensor.Value[a][of] = mean[a] + this->Dot(solutions[a], this->Residual) / this->Corners;
      tensor.Value[of][a] = tensor.Value[a][of];
    }
    if (solved)
    {
      solved(of, u, this->Equations);
    }
  }
  return tensor;
}

double BytesOfSolver(int components)
{
  // Residual, direction, image; the solutions of all cases; a spectrum of double precision
  const int fields = 3 + (components == 1 ? 3 : 6);
  return components * (4.0 * fields + 8.0);
}
}
