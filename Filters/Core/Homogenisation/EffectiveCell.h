// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Estimate.h"
#include "ruc/Homogenisation/CellSolver.h"
#include "ruc/Homogenisation/ConductivityVoxels.h"
#include "ruc/Homogenisation/EffectiveBounds.h"
#include "ruc/Images/Fit/VoxelSlab.h"

#include <string>
#include <vector>

namespace ruc
{
/** What property of a cell is solved for. */
enum class CellProperty
{
  Conductivity,
  Elasticity
};
constexpr int CountOf(CellProperty)
{
  return 2;
}

/** The materials of a pack: of the matrix, and of each of the materials of its spheres. */
struct CellMaterials
{
  CellProperty Property = CellProperty::Conductivity;
  double MatrixConductivity = 1.0;
  std::vector<double> Conductivities;
  ElasticModuli Matrix{ 1.0, 1.0 };
  std::vector<ElasticModuli> Moduli;
  std::vector<int> OfMode; // the material, from 0, of modes 1…N_p

  /**
   * The greatest of the spheres' conductivities or moduli over the matrix's, or the inverse of the
   * least where that is greater.
   */
  double Contrast() const;
  /**
   * The rule that has the least error: Laminate for stiffnesses and below the contrast 30, else
   * Harmonic for spheres that conduct well and Arithmetic for those that do not.
   */
  InterfaceRule AutomaticRule() const;
};

/** The greatest contrast that fields of single precision resolve. */
constexpr double MostContrast = 1e5;

/**
 * Makes materials from values of the modes, of which there are as many or one for all. Modes of
 * equal values are one material.
 *
 * Throws std::invalid_argument for another number of values, for a conductivity that is not finite
 * and >= 0 (> 0 of the matrix), for moduli that are not finite and > 0, for Poisson's ratios that
 * are not > -1 and < 0.5, and for a contrast above MostContrast, unless it is of spheres that do
 * not conduct.
 */
CellMaterials MakeConductors(double matrix, const std::vector<double>& ofModes, int modes);
CellMaterials MakeElastic(double matrixYoung, double matrixPoisson,
  const std::vector<double>& youngOfModes, const std::vector<double>& poissonOfModes, int modes);

/**
 * The cell of a box with `resolution` voxels along its shortest edge, and about as many to the
 * length along the others. Numbers of voxels are the next that have no prime factor above 7, for
 * which transforms are fast. Throws std::invalid_argument for fewer than 2, or more than 4096.
 */
CellGrid MakeCellGrid(const Window& box, int resolution, bool mirrored);

/** The fields of a case, of the voxels of the cell, this rank's own planes. */
struct CellFields
{
  /** The case, from 0; a number < 0 leaves out all but the fractions. */
  int Case = -1;
  VoxelSlab<float> VolumeFraction;
  /** The mean of a voxel's eight corners, with the uniform gradient from the cell's lower corner
   * on.
   */
  std::vector<VoxelSlab<float>> Unknown;
  std::vector<VoxelSlab<float>> Flux; // against the gradient: k grad T, or the stress
};

/** The share of the cell's voxels that is in spheres, and what the cell answers. */
struct SolvedCell
{
  double Fraction = 0.0;
  EffectiveTensor Tensor;
};

/**
 * Solves a cell of a pack, of which each rank has a piece with modes: spheres of `piece`, and their
 * images across the window's periodic faces, fill the voxels of `cell`. `fields` may be null.
 * Equal, bit by bit, for any number of ranks and threads. Collective.
 */
SolvedCell SolveCell(const SpherePack& piece, const Window& window, const CellGrid& cell,
  const CellMaterials& materials, InterfaceRule rule, const SolverSettings& settings,
  Communicator& ranks, const CellSolver::Progress& progress = {}, CellFields* fields = nullptr);

/**
 * Finds the share of the cell's voxels that is in spheres without solving anything, and the field
 * of shares where `fields` is not null. Collective.
 */
double FindFraction(const SpherePack& piece, const Window& window, const CellGrid& cell,
  const CellMaterials& materials, Communicator& ranks, CellFields* fields);

/** What SolveCell takes. */
Estimate EstimateCell(
  const CellGrid& cell, const CellMaterials& materials, InterfaceRule rule, bool withFields);
}
