// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCViewsModule.h"

#include <vtkSMChartSeriesSelectionDomain.h>

#include <string>
#include <utility>
#include <vector>

/**
 * What a chart does at first with a series, of which a table may have hundreds.
 *
 * In a domain with `default_mode="value"`, elements `Match` say what it does: `hint` is the name of
 * an attribute of OutputHint::Find(), a regular expression that is searched in the name of the
 * series, and `value` is the value where it is found. The first `Match` that is found counts; the
 * other series have `default_value`. With `default_mode="color"` the series that match the hint
 * `show` have colours that can be told apart, and the others those of the superclass. Series that
 * come up later, because the filter ran again, are treated alike, and what the user has chosen
 * stays.
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
  bool Matches(const std::string& hint, const char* series);

  // The names of hints, and the values of what matches them
  std::vector<std::pair<std::string, std::string>> Values;
  int ColorsTaken = 0;

  vtkSMRUCChartSeriesDomain(const vtkSMRUCChartSeriesDomain&) = delete;
  void operator=(const vtkSMRUCChartSeriesDomain&) = delete;
};
