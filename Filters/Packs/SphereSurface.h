// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Window/Window.h"

class vtkPolyData;

/** Surfaces of spheres in a periodic box. */
namespace SphereSurface
{
/** The facets around a sphere of radius 1, compared with it. */
struct Facets
{
  /**
   * The distance of the facets' corners from the centre, > 1, with which they hold the sphere's
   * volume; 1.0096 for a resolution of 24. The facets of spheres in contact reach a little into
   * each other.
   */
  double Radius;
  /**
   * By how much the volume and the area of the facets exceed the sphere's, in percent of it. The
   * volume is the same up to rounding; the area is always larger.
   */
  double VolumeErrorPercent, AreaErrorPercent;
};

/** Measures the facets of a sphere with `resolution` facets around it. */
Facets Measure(int resolution);

/**
 * Makes the surface of a sphere with `resolution` facets around it and corners at `radius`, closed
 * where a periodic face of the box cuts it. It is made of triangles; those of a cut meet in its
 * middle. It is empty if no facet is inside the box.
 */
void Fill(const ruc::Vector3& centre, double radius, const ruc::Window& box, int resolution,
  vtkPolyData* surface);
}
