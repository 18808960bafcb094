// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCViewsModule.h"

#include <vtkSMRepresentationProxy.h>

/**
 * What makes packs look right at once, as part of every geometry representation.
 *
 * The colour map of an integer array `Mode` has one colour a mode, in the order of the modes, which
 * is that of the sizes, with the modes' numbers as labels: where ParaView has just made the map,
 * and for modes that come later. A map that somebody has changed stays as it is.
 *
 * ParaView colours new data by their active array but not those that were empty when first shown,
 * such as the surfaces of Periodic Replicas before Clip To Box; they are coloured by mode when they
 * come. Where these surfaces are visible, the view does not draw the filter's whole spheres, of
 * which they would be the inside.
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
  void ColourLateData();
  void HideWholeSpheres(vtkSMProxy* view);

  bool WasEmpty = false;
  bool CutShown = false;
};
