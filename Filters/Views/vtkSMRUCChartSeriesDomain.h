// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCViewsModule.h"

#include <vtkSMChartSeriesSelectionDomain.h>

#include <string>

/**
 * What a chart does at first with a series, of which a table may have hundreds.
 *
 * Attributes of the domain, beside those of its superclass with `default_mode="value"`: `hint`, the
 * name of an attribute of vtkSMRUCChartRepresentationProxy::FindChartHint(), which is a regular
 * expression that is searched in the name of the series; `match`, the value of series in which it
 * is found. The others have `default_value`. Series that come up later, because the filter ran
 * again, are treated alike, and what the user has chosen stays.
 */
class RUCVIEWS_EXPORT vtkSMRUCChartSeriesDomain : public vtkSMChartSeriesSelectionDomain
{
public:
  static vtkSMRUCChartSeriesDomain* New();
  vtkTypeMacro(vtkSMRUCChartSeriesDomain, vtkSMChartSeriesSelectionDomain);

protected:
  vtkSMRUCChartSeriesDomain() = default;
  ~vtkSMRUCChartSeriesDomain() override = default;

  int ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element) override;
  std::vector<std::string> GetDefaultValue(const char* series) override;

private:
  std::string Hint;
  std::string Match;

  vtkSMRUCChartSeriesDomain(const vtkSMRUCChartSeriesDomain&) = delete;
  void operator=(const vtkSMRUCChartSeriesDomain&) = delete;
};
