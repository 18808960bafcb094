// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMRUCChartRepresentationProxy.h"

#include <vtkDataObject.h>
#include <vtkObjectFactory.h>
#include <vtkPVArrayInformation.h>
#include <vtkPVDataInformation.h>
#include <vtkPVXMLElement.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMSourceProxy.h>
#include <vtkSMViewProxy.h>

#include <string>

vtkStandardNewMacro(vtkSMRUCChartRepresentationProxy);

namespace
{
std::string FindLengthUnit(vtkSMProxy* representation)
{
  vtkSMPropertyHelper input(representation, "Input");
  auto source = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
  vtkPVArrayInformation* unit = source ? source->GetDataInformation(input.GetOutputPort())
                                           ->GetArrayInformation("LengthUnit", vtkDataObject::FIELD)
                                       : nullptr;
  return unit && unit->GetNumberOfStringValues() > 0 ? unit->GetStringValue(0) : "";
}

// "Lag r (µm)" of "Lag r", "%" and "µm"
std::string Title(const char* text, const char* pattern, const std::string& unit)
{
  std::string title = text;
  if (pattern && !unit.empty())
  {
    std::string brackets = pattern;
    brackets.replace(brackets.find('%'), 1, unit);
    title += " (" + brackets + ")";
  }
  return title;
}
}

int vtkSMRUCChartRepresentationProxy::LoadXMLState(
  vtkPVXMLElement* element, vtkSMProxyLocator* locator)
{
  this->Titled = true;
  return this->Superclass::LoadXMLState(element, locator);
}

void vtkSMRUCChartRepresentationProxy::AddConsumer(vtkSMProperty* property, vtkSMProxy* consumer)
{
  this->Superclass::AddConsumer(property, consumer);
  if (!this->Titled && vtkSMViewProxy::SafeDownCast(consumer))
  {
    this->Titled = true;
    this->TitleAxes(consumer);
  }
}

void vtkSMRUCChartRepresentationProxy::TitleAxes(vtkSMProxy* view)
{
  vtkPVXMLElement* chart =
    this->GetHints() ? this->GetHints()->FindNestedElementByName("Chart") : nullptr;
  const std::string axes[3][2] = { { "bottom", "BottomAxisTitle" }, { "left", "LeftAxisTitle" },
    { "right", "RightAxisTitle" } };
  for (const auto& [axis, property] : axes)
  {
    // Of a kind of view that has no axes, or has titles
    if (!chart || !view->GetProperty(property.c_str()) ||
      *vtkSMPropertyHelper(view, property.c_str()).GetAsString())
    {
      return;
    }
  }
  const std::string unit = FindLengthUnit(this);
  for (const auto& [axis, property] : axes)
  {
    if (const char* text = chart->GetAttribute(axis.c_str()))
    {
      const std::string title = Title(text, chart->GetAttribute((axis + "_unit").c_str()), unit);
      vtkSMPropertyHelper(view, property.c_str()).Set(title.c_str());
    }
  }
  int logarithmic = 0;
  if (chart->GetScalarAttribute("log_left", &logarithmic))
  {
    vtkSMPropertyHelper(view, "LeftAxisLogScale").Set(logarithmic);
  }
}
