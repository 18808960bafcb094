// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Homogenisation/CornerOperator.h"
#include "ruc/Homogenisation/FourierPreconditioner.h"

#include <array>
#include <functional>
#include <vector>

namespace ruc
{
/** When a solution of a cell is good enough. */
struct SolverSettings
{
  /**
   * The search ends where its last four steps together lowered the energy by less than this share
   * of it: > 0 and < 1.
   */
  double Tolerance = 1e-4;
  int MaximumIterations = 500; // of each case, >= 1
};

/** Throws std::invalid_argument for settings out of range. */
void ValidateSolver(const SolverSettings& settings);

/** How far a case is. */
struct SolverStep
{
  int Case, Iteration;
  double Energy; // twice the energy density: the property in this direction, from above
};

/** How a search ended. */
enum class SolverEnd
{
  Tolerance,
  MaximumIterations,
  Stopped
};

/** What a cell answers to every uniform gradient. */
struct EffectiveTensor
{
  int Size = 0; // 3 for a conductivity, 6 for a stiffness
  std::array<std::array<double, MostFluxes>, MostFluxes> Value{};
  /** How much the last four steps of each case changed its own entry. */
  std::array<double, MostFluxes> IterationError{};
  std::array<int, MostFluxes> Iterations{};
  SolverEnd EndedBy = SolverEnd::Tolerance; // the worst of the cases
  std::vector<SolverStep> Steps;
};

/**
 * Solves D^T C (E + D u) = 0 for the uniform gradients E of a cell by preconditioned conjugate
 * gradients, and so finds its effective tensor, whose entry a b is the mean of (E_a + D u_a) C (E_b
 * + D u_b): an error of the fields enters it as its square. Fields are of single precision, sums of
 * double precision in a fixed order, so that the result is equal, bit by bit, for any number of
 * ranks and threads.
 */
class CellSolver
{
public:
  /** Both must live as long as the solver. */
  CellSolver(const CellSlab& slab, const VoxelLaw& law, Communicator& ranks);

  /** Called on every rank after each step; false on any rank ends the search. */
  using Progress = std::function<bool(const SolverStep&)>;
  /** Called where a case is solved, with the solution, whose halo is up to date. */
  using Solved = std::function<void(int of, const CornerField& u, const CornerOperator& equations)>;

  /** Solves all cases, 3 or 6. Collective. */
  EffectiveTensor Solve(
    const SolverSettings& settings, const Progress& progress = {}, const Solved& solved = {});

  /** The uniform gradient of a case; stresses are over engineering shears. */
  static MacroGradient GradientOf(int components, int of);

private:
  void SolveCase(int of, const SolverSettings& settings, const Progress& progress,
    EffectiveTensor& tensor, CornerField& u);
  // The mean flux of E + D u; leaves D^T C (E + D u) in the residual
  std::array<double, MostFluxes> MeanFlux(const MacroGradient& uniform, const CornerField& u);
  double Dot(const CornerField& a, const CornerField& b);

  const CellSlab& Slab;
  Communicator& Ranks;
  int Components, Fluxes;
  double Corners;
  CornerOperator Equations;
  FourierPreconditioner Preconditioner;
  CornerField Residual, Direction, Image;
};

/** The megabytes that a solver takes for each voxel of a cell, its voxels' law not counted. */
double BytesOfSolver(int components);
}
