// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCViewsModule.h"

#include <vtkSMPVRepresentationProxy.h>

/**
 * An image over lags, S_rs(x) or S_rsq(r1, r2, theta), that opens with titled axes and in sight.
 *
 * When a view first shows the image, the axes of the data have the titles `x`, `y` and `z` of
 * OutputHint::Title, and the slice is the one in the middle: z = 0 of S_rs(x) and a right angle of
 * S_rsq. In a new view, and in one in which something else is seen, such as the pack, the camera
 * looks straight down on the image in parallel projection, since lags are another space. A view
 * with nothing but a camera of its own, as scripts and Python states make it, keeps that. What a
 * user changes, or a state file holds, stays.
 */
class RUCVIEWS_EXPORT vtkSMRUCMapRepresentationProxy : public vtkSMPVRepresentationProxy
{
public:
  static vtkSMRUCMapRepresentationProxy* New();
  vtkTypeMacro(vtkSMRUCMapRepresentationProxy, vtkSMPVRepresentationProxy);

  int LoadXMLState(vtkPVXMLElement* element, vtkSMProxyLocator* locator) override;

protected:
  vtkSMRUCMapRepresentationProxy() = default;
  ~vtkSMRUCMapRepresentationProxy() override = default;

  /** The view that shows the representation is a consumer of it. */
  void AddConsumer(vtkSMProperty* property, vtkSMProxy* consumer) override;

private:
  void Open(vtkSMProxy* view, vtkPVXMLElement* hint);
  bool IsCameraFree(vtkSMProxy* view);

  bool Opened = false;

  vtkSMRUCMapRepresentationProxy(const vtkSMRUCMapRepresentationProxy&) = delete;
  void operator=(const vtkSMRUCMapRepresentationProxy&) = delete;
};
