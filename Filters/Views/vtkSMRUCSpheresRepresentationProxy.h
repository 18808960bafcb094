// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCViewsModule.h"

#include <vtkSMRepresentationProxy.h>

/**
 * Gives the colour map of an integer array `Mode` one colour a mode, in the order of the modes,
 * which is that of the sizes, with the modes' numbers as labels.
 *
 * It does so where ParaView has just made the map, and takes in modes that come later; a map that
 * somebody has changed stays as it is. ParaView colours new data by their active array but not
 * those that were empty when first shown, such as the surfaces of Periodic Replicas before Clip To
 * Box; this proxy colours them by mode when they come. It is part of every geometry representation,
 * so that surfaces with that array have these colours too.
 */
class RUCVIEWS_EXPORT vtkSMRUCSpheresRepresentationProxy : public vtkSMRepresentationProxy
{
public:
  static vtkSMRUCSpheresRepresentationProxy* New();
  vtkTypeMacro(vtkSMRUCSpheresRepresentationProxy, vtkSMRepresentationProxy);

  void ViewUpdated(vtkSMProxy* view) override;

protected:
  vtkSMRUCSpheresRepresentationProxy() = default;
  ~vtkSMRUCSpheresRepresentationProxy() override = default;

  void SetPropertyModifiedFlag(const char* name, int flag) override;

private:
  vtkSMRUCSpheresRepresentationProxy(const vtkSMRUCSpheresRepresentationProxy&) = delete;
  void operator=(const vtkSMRUCSpheresRepresentationProxy&) = delete;

  void SetModeColours();

  bool WasEmpty = false;
};
