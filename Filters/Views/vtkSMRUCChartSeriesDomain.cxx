// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMRUCChartSeriesDomain.h"

#include "OutputHint.h"

#include <vtkObjectFactory.h>
#include <vtkPVXMLElement.h>
#include <vtkSMProperty.h>

#include <vtksys/RegularExpression.hxx>

vtkStandardNewMacro(vtkSMRUCChartSeriesDomain);

namespace
{
// The colours of Okabe and Ito, which also people who do not see red and green apart can tell
const std::vector<std::vector<std::string>> Colors = { { "0", "0.45", "0.7" },
  { "0.84", "0.37", "0" }, { "0", "0.62", "0.45" }, { "0.8", "0.47", "0.65" },
  { "0.9", "0.62", "0" }, { "0.34", "0.71", "0.91" }, { "0", "0", "0" } };
}

int vtkSMRUCChartSeriesDomain::ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element)
{
  for (unsigned int n = 0; n < element->GetNumberOfNestedElements(); ++n)
  {
    vtkPVXMLElement* match = element->GetNestedElement(n);
    if (match->GetName() == std::string("Match"))
    {
      this->Values.emplace_back(
        match->GetAttributeOrEmpty("hint"), match->GetAttributeOrEmpty("value"));
    }
  }
  return this->Superclass::ReadXMLAttributes(property, element);
}

std::vector<std::string> vtkSMRUCChartSeriesDomain::GetDefaultValue(const char* series)
{
  if (this->DefaultMode == COLOR && this->Matches("show", series))
  {
    return Colors[this->ColorsTaken++ % Colors.size()];
  }
  for (const auto& [hint, value] : this->Values)
  {
    if (this->Matches(hint, series))
    {
      return { value };
    }
  }
  return this->Superclass::GetDefaultValue(series);
}

bool vtkSMRUCChartSeriesDomain::Matches(const std::string& hint, const char* series)
{
  vtkPVXMLElement* element = OutputHint::Find(this->GetProperty()->GetParent());
  const char* pattern = element ? element->GetAttribute(hint.c_str()) : nullptr;
  vtksys::RegularExpression expression; // throws nothing, unlike std::regex
  return pattern && series && expression.compile(pattern) && expression.find(series);
}
