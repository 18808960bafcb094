// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCViewsModule.h"

#include <vtkPointGaussianRepresentation.h>

/**
 * Draws points as spheres of their true radius.
 */
class RUCVIEWS_EXPORT vtkRUCSpheresRepresentation : public vtkPointGaussianRepresentation
{
public:
  static vtkRUCSpheresRepresentation* New();
  vtkTypeMacro(vtkRUCSpheresRepresentation, vtkPointGaussianRepresentation);

protected:
  vtkRUCSpheresRepresentation() = default;
  ~vtkRUCSpheresRepresentation() override = default;

private:
  vtkRUCSpheresRepresentation(const vtkRUCSpheresRepresentation&) = delete;
  void operator=(const vtkRUCSpheresRepresentation&) = delete;
};
