// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCViewsModule.h"

#include <vtkSMChartRepresentationProxy.h>

/**
 * A table as a line chart that titles its view.
 *
 * When the representation is shown for the first time, in a view without titles of axes, the view
 * gets those of the element `Chart` in the hints of the proxy: `bottom`, `left` and `right`. Where
 * the table has a `LengthUnit` among its field data, `bottom_unit`, `left_unit` or `right_unit`, in
 * which % stands for it, follows in brackets: "Lag r (µm)". `log_left="1"` makes the axis on the
 * left logarithmic. What a user writes, or a state file holds, is never changed.
 */
class RUCVIEWS_EXPORT vtkSMRUCChartRepresentationProxy : public vtkSMChartRepresentationProxy
{
public:
  static vtkSMRUCChartRepresentationProxy* New();
  vtkTypeMacro(vtkSMRUCChartRepresentationProxy, vtkSMChartRepresentationProxy);

  int LoadXMLState(vtkPVXMLElement* element, vtkSMProxyLocator* locator) override;

protected:
  vtkSMRUCChartRepresentationProxy() = default;
  ~vtkSMRUCChartRepresentationProxy() override = default;

  /** The view that shows the representation is a consumer of it. */
  void AddConsumer(vtkSMProperty* property, vtkSMProxy* consumer) override;

private:
  void TitleAxes(vtkSMProxy* view);

  bool Titled = false;

  vtkSMRUCChartRepresentationProxy(const vtkSMRUCChartRepresentationProxy&) = delete;
  void operator=(const vtkSMRUCChartRepresentationProxy&) = delete;
};
