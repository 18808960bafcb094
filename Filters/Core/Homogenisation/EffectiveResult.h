// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Homogenisation/EffectiveCell.h"
#include "ruc/Statistics/ThirdOrder/ThirdOrderOfSpheres.h"

#include <string>
#include <vector>

namespace ruc
{
/**
 * Bounds of the conductivity, or of the bulk and the shear modulus, of a pack. `fractions` are
 * those of the modes 1…N_p and of the matrix. `third` is null, or the third order of the pack by
 * mode (ByMode) where there are several materials, else of all spheres. Of several materials the
 * shear modulus has no bounds of third order, nor has the conductivity where one does not conduct.
 */
std::vector<PropertyBounds> BoundPack(const CellMaterials& materials,
  const std::vector<double>& fractions, const ThirdOrderOfSpheres* third);

/** A cell that was solved. */
struct CellRun
{
  int Resolution = 0;
  InterfaceRule Rule = InterfaceRule::Laminate;
  double Edge = 0.0; // of a voxel
  SolvedCell Cell;
};

/** A property of a cell, as several runs have it. */
struct CellQuantity
{
  std::string Name;
  double Value, DiscretisationError, IterationError;
};

/**
 * The properties of a cell: k_xx, k_yy, k_zz, k_yz, k_xz, k_xy and their mean k; or C_11 to C_66
 * with engineering shears, and K and G, the moduli of the isotropic stiffness that is nearest
 * (Voigt's means).
 *
 * A value is the mean over the rules at the finest grid. The discretisation error is the greatest
 * distance from it of a rule's value there and, where a rule was solved on two grids, of the
 * straight line through both at voxels of no size. It is NaN for one run alone, and no bound. The
 * iteration error is the greatest of what the last four steps of the runs on the finest grid
 * changed.
 */
std::vector<CellQuantity> CombineRuns(CellProperty property, const std::vector<CellRun>& runs);

/**
 * Thermal expansion of a cell of two materials, alpha_xx to alpha_xy (engineering shears), from its
 * stiffness by Levin's relation: alpha_i = alpha_1 + (alpha_2 - alpha_1) / (1 / K_2 - 1 / K_1) (3
 * sum of S_ij over j <= 3 - 1 / K_1), of which the shears have no alpha_1 and no 1 / K_1 (V. M.
 * Levin, Mechanics of Solids 2, 58, 1967). NaN where K_1 = K_2.
 */
std::array<double, MostFluxes> ExpansionOf(const EffectiveTensor& stiffness,
  const ElasticModuli& matrix, const ElasticModuli& spheres, double ofMatrix, double ofSpheres);
}
