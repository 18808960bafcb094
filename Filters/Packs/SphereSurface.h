// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Window/Window.h"

class vtkPolyData;

/** Surfaces of spheres in a periodic box. */
namespace SphereSurface
{
/** How the facets around a sphere of radius 1 compare with it. */
struct Facets
{
  /** The distance of their corners from the centre, > 1, with which they hold the sphere's volume:
   * 1.0096 for a resolution of 24. Facets of spheres in contact reach a little into each other. */
  double Radius;
  /** By how much their volume and area exceed the sphere's, in percent of it. The volume is the
   * same but for rounding, the area then always larger. */
  double VolumeErrorPercent, AreaErrorPercent;
};

/** Of spheres with `resolution` facets around. */
Facets Measure(int resolution);

/** The surface of a sphere with `resolution` facets around it and corners at `radius`, closed where
 * a periodic face of the box cuts it: triangles, on a cut around its middle. Empty where no facet
 * is inside. */
void Fill(const ruc::Vector3& centre, double radius, const ruc::Window& box, int resolution,
  vtkPolyData* surface);
}
