// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMRUCChartSeriesDomain.h"

#include "vtkSMRUCChartRepresentationProxy.h"

#include <vtkObjectFactory.h>
#include <vtkPVXMLElement.h>
#include <vtkSMProperty.h>

#include <regex>

vtkStandardNewMacro(vtkSMRUCChartSeriesDomain);

int vtkSMRUCChartSeriesDomain::ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element)
{
  this->Hint = element->GetAttributeOrEmpty("hint");
  this->Match = element->GetAttributeOrEmpty("match");
  return this->Superclass::ReadXMLAttributes(property, element);
}

std::vector<std::string> vtkSMRUCChartSeriesDomain::GetDefaultValue(const char* series)
{
  auto chart = vtkSMRUCChartRepresentationProxy::SafeDownCast(this->GetProperty()->GetParent());
  vtkPVXMLElement* hint = chart ? chart->FindChartHint() : nullptr;
  const char* pattern = hint ? hint->GetAttribute(this->Hint.c_str()) : nullptr;
  if (pattern && std::regex_search(series, std::regex(pattern)))
  {
    return { this->Match };
  }
  return this->Superclass::GetDefaultValue(series);
}
