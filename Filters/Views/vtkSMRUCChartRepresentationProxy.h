// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCViewsModule.h"

#include <vtkSMChartRepresentationProxy.h>

/**
 * A table as a line chart that opens with what its filter says of it, in its hints:
 *
 *     <Representation view="XYChartView" type="RUCChart" port="0" x="r" show="^S_m_m$"
 *       bottom="Lag r" bottom_unit="%" left="Probability S_rs"/>
 *
 * `x` is the column for the axis at the bottom, r where it is left out. `show`, `right_series`,
 * `points` and `dashed` are regular expressions for columns: those that are drawn; those drawn by
 * the axis on the right instead of the left; those drawn as points instead of a line; and those
 * drawn as dashed lines (vtkSMRUCChartSeriesDomain). `bottom`, `left` and `right` are titles of the
 * axes (OutputHint::Title). `log_left="1"` makes the axis on the left logarithmic.
 *
 * Titles and scale belong to the view. It gets them when it first shows the table, and only where
 * none of its axes has a title yet, so that what a user writes or a state file holds stays.
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
  void TitleAxes(vtkSMProxy* view, vtkPVXMLElement* hint);

  bool Opened = false;

  vtkSMRUCChartRepresentationProxy(const vtkSMRUCChartRepresentationProxy&) = delete;
  void operator=(const vtkSMRUCChartRepresentationProxy&) = delete;
};
