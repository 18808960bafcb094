// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCViewsModule.h"

#include <vtkSMRepresentationProxy.h>

/**
 * What makes packs look right at once, as part of every geometry representation.
 *
 * The colour map of an integer array `Mode` has one colour for each mode, in the order of the
 * modes, which is that of the sizes, with the modes' numbers as labels. This holds where ParaView
 * has just made the map, and for modes that come later. A map that somebody has changed stays as it
 * is.
 *
 * ParaView colours new data by their active array, but not data that were empty when first shown,
 * such as surfaces that a filter makes on demand. These are coloured by mode when they come.
 *
 * A filter may have an output of spheres and another of surfaces that stand for the same spheres,
 * cut at a box. It says so in its hints, with the ports of the spheres and of the surfaces:
 *
 *     <Output type="RUCSpheresRepresentation" port="0" replaced_by="2"/>
 *
 * A view that shows the surfaces then does not draw the whole spheres, which would cover the cut.
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
