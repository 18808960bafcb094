// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCViewsModule.h"

#include <vtkOpenGLPointGaussianMapper.h>
#include <vtkTimeStamp.h>

class vtkBoundingBox;
class vtkDataObject;
class vtkShaderProperty;

/**
 * Draws points as true spheres: every pixel of a sphere has the depth, normal and light of its
 * surface, so that spheres cut each other and anything else where they do in space, in parallel
 * and in perspective projection. The superclass draws flat discs that face the camera and takes
 * its bounds from the centres, to which pictures of several ranks are then cropped.
 *
 * The actor must have the replacements of `PrepareShaders`, the mapper `SplatShaderCode` from
 * `GetShading`, a `TriangleScale` and a `ScaleFactor` of 1, and no `ScaleFunction`.
 */
class RUCVIEWS_EXPORT vtkRUCSphereMapper : public vtkOpenGLPointGaussianMapper
{
public:
  static vtkRUCSphereMapper* New();
  vtkTypeMacro(vtkRUCSphereMapper, vtkOpenGLPointGaussianMapper);

  /** Makes an actor's shaders those of spheres. */
  void PrepareShaders(vtkShaderProperty* shaders);

  /**
   * Sets the factor by which the radii are multiplied, > 0. Default: 1. It stands for the
   * superclass's `ScaleFactor`, which reaches the shaders differently in different versions of VTK.
   */
  void SetSphereScale(vtkShaderProperty* shaders, double scale);

  /** The colours of a sphere's surface, lit as ParaView's light kit lights surfaces by default. */
  static const char* GetShading();

  /**
   * Adds the spheres of point sets, or of composites of them, to the box. Their radii are
   * `ScaleArray` (1 where there is none) times the scale of the spheres.
   */
  void AddSpheres(vtkDataObject* data, vtkBoundingBox& box);

protected:
  vtkRUCSphereMapper() = default;
  ~vtkRUCSphereMapper() override = default;

  void ComputeBounds() override;

private:
  vtkRUCSphereMapper(const vtkRUCSphereMapper&) = delete;
  void operator=(const vtkRUCSphereMapper&) = delete;

  double SphereScale = 1.0;
  vtkTimeStamp BoundsTime;
};
