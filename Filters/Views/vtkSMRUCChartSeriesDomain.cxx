// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMRUCChartSeriesDomain.h"

#include <vtkObjectFactory.h>
#include <vtkPVXMLElement.h>
#include <vtkSMProperty.h>
#include <vtkSMProxy.h>

#include <regex>

vtkStandardNewMacro(vtkSMRUCChartSeriesDomain);

std::vector<std::string> vtkSMRUCChartSeriesDomain::GetDefaultValue(const char* series)
{
  vtkPVXMLElement* hints = this->GetProperty()->GetParent()->GetHints();
  vtkPVXMLElement* chart = hints ? hints->FindNestedElementByName("Chart") : nullptr;
  const char* pattern = chart
    ? chart->GetAttribute(this->DefaultMode == VISIBILITY ? "show" : "right_series")
    : nullptr;
  return { pattern && std::regex_search(series, std::regex(pattern)) ? "1" : "0" };
}
