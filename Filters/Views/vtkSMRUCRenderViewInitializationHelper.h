// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCViewsModule.h"

#include <vtkSMProxyInitializationHelper.h>

/**
 * Makes a 3D view the active one when a filter is created whose first output belongs into one.
 *
 * ParaView 5.11 shows the result of a filter in the active view or not at all. After a table has
 * opened as a chart, that is the chart: a cell would have no view, and its convergence would be
 * drawn over the functions of its pack. The helper does nothing where the active view is a 3D view.
 * Else it takes the 3D view that shows the input of the filter, or the first one.
 */
class RUCVIEWS_EXPORT vtkSMRUCRenderViewInitializationHelper : public vtkSMProxyInitializationHelper
{
public:
  static vtkSMRUCRenderViewInitializationHelper* New();
  vtkTypeMacro(vtkSMRUCRenderViewInitializationHelper, vtkSMProxyInitializationHelper);

  void PostInitializeProxy(vtkSMProxy* filter, vtkPVXMLElement* hint, vtkMTimeType time) override;

protected:
  vtkSMRUCRenderViewInitializationHelper() = default;
  ~vtkSMRUCRenderViewInitializationHelper() override = default;

private:
  vtkSMRUCRenderViewInitializationHelper(const vtkSMRUCRenderViewInitializationHelper&) = delete;
  void operator=(const vtkSMRUCRenderViewInitializationHelper&) = delete;
};
