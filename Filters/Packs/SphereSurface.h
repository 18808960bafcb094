// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Window/Window.h"

class vtkPolyData;

/** Surfaces of spheres in a periodic box. */
namespace SphereSurface
{
/** The surface of a sphere with `resolution` facets around it, closed where a periodic face of the
 * box cuts it: triangles, on a cut around its middle. Empty where no facet is inside. */
void Fill(const ruc::Vector3& centre, double radius, const ruc::Window& box, int resolution,
  vtkPolyData* surface);
}
