// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCViewsModule.h"

#include <vtkSMChartSeriesSelectionDomain.h>

/**
 * The series of a chart, of which a table may have hundreds: which of them are drawn at first, and
 * by which axis.
 *
 * Attributes of the element `Chart` in the hints of the representation decide, regular expressions
 * that are searched in the names of the columns: `show`, the series that are visible;
 * `right_series`, those drawn by the axis on the right, not on the left. Series that come up later,
 * because the filter ran again, are treated alike, and what the user has chosen stays.
 */
class RUCVIEWS_EXPORT vtkSMRUCChartSeriesDomain : public vtkSMChartSeriesSelectionDomain
{
public:
  static vtkSMRUCChartSeriesDomain* New();
  vtkTypeMacro(vtkSMRUCChartSeriesDomain, vtkSMChartSeriesSelectionDomain);

protected:
  vtkSMRUCChartSeriesDomain() = default;
  ~vtkSMRUCChartSeriesDomain() override = default;

  /** "1" or "0": visibility or, in the mode of a value, the corner of the axes. */
  std::vector<std::string> GetDefaultValue(const char* series) override;

private:
  vtkSMRUCChartSeriesDomain(const vtkSMRUCChartSeriesDomain&) = delete;
  void operator=(const vtkSMRUCChartSeriesDomain&) = delete;
};
