// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Window/Window.h"

namespace ruc
{
/** How a box of a pack becomes a periodic cell. */
enum class CellBoundary
{
  Automatic, // Periodic where the box is, and no part of it is wanted; else Mirrored
  Periodic,  // the box is periodic as it is
  Mirrored   // mirror images in x, y and z make any box periodic
};
constexpr int CountOf(CellBoundary)
{
  return 3;
}

/** The box that is solved, and whether its mirror images are part of the cell. */
struct CellBox
{
  Window Box;
  bool Mirrored;
};

/**
 * Finds the box. A `size` of 0 0 0 stands for all of a periodic box, and else for the window
 * without a layer as thick as the largest radius along faces that are not periodic, where spheres
 * with centres outside are lacking; of a cylinder a box must be given.
 *
 * Throws std::invalid_argument for a box with faces that are not all periodic where Periodic is
 * wanted, for sizes that are not all 0 or all > 0, and for a box that reaches into that layer.
 */
CellBox FindCellBox(const Window& observed, double largestRadius, CellBoundary boundary,
  const Vector3& origin, const Vector3& size);
}
