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
#include <vtkSMUncheckedPropertyHelper.h>
#include <vtkSMViewProxy.h>

#include <cstddef>
#include <string>

vtkStandardNewMacro(vtkSMRUCChartRepresentationProxy);

namespace
{
// The output that the representation shows
struct Output
{
  vtkSMSourceProxy* Source;
  int Port;

  explicit Output(vtkSMProxy* representation)
  {
    // Not yet checked values, as the domains of the superclass have it
    vtkSMUncheckedPropertyHelper input(representation, "Input");
    this->Source = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
    this->Port = static_cast<int>(input.GetOutputPort());
  }
};

std::string FindLengthUnit(const Output& output)
{
  vtkPVArrayInformation* unit = output.Source->GetDataInformation(output.Port)
                                  ->GetArrayInformation("LengthUnit", vtkDataObject::FIELD);
  return unit && unit->GetNumberOfStringValues() > 0 ? unit->GetStringValue(0) : "";
}

// "Lag r (µm)" of "Lag r", "%" and "µm"
std::string Title(const char* text, std::string brackets, const std::string& unit)
{
  const std::size_t place = brackets.find('%');
  return place == std::string::npos || unit.empty()
    ? text
    : text + (" (" + brackets.replace(place, 1, unit) + ")");
}
}

vtkPVXMLElement* vtkSMRUCChartRepresentationProxy::FindChartHint()
{
  const Output output(this);
  vtkPVXMLElement* hints = output.Source ? output.Source->GetHints() : nullptr;
  for (unsigned int n = 0; hints && n < hints->GetNumberOfNestedElements(); ++n)
  {
    vtkPVXMLElement* hint = hints->GetNestedElement(n);
    int port = -1;
    if (hint->GetAttributeOrEmpty("type") == std::string(this->GetXMLName()) &&
      hint->GetScalarAttribute("port", &port) && port == output.Port)
    {
      return hint;
    }
  }
  return nullptr;
}

int vtkSMRUCChartRepresentationProxy::LoadXMLState(
  vtkPVXMLElement* element, vtkSMProxyLocator* locator)
{
  this->Opened = true;
  return this->Superclass::LoadXMLState(element, locator);
}

void vtkSMRUCChartRepresentationProxy::AddConsumer(vtkSMProperty* property, vtkSMProxy* consumer)
{
  this->Superclass::AddConsumer(property, consumer);
  if (this->Opened || !vtkSMViewProxy::SafeDownCast(consumer))
  {
    return;
  }
  this->Opened = true;
  if (vtkPVXMLElement* hint = this->FindChartHint())
  {
    if (const char* column = hint->GetAttribute("x"))
    {
      vtkSMPropertyHelper(this, "XArrayName").Set(column);
      this->UpdateVTKObjects();
    }
    this->TitleAxes(consumer, hint);
  }
}

void vtkSMRUCChartRepresentationProxy::TitleAxes(vtkSMProxy* view, vtkPVXMLElement* hint)
{
  const std::string axes[3][2] = { { "bottom", "BottomAxisTitle" }, { "left", "LeftAxisTitle" },
    { "right", "RightAxisTitle" } };
  for (const auto& [axis, property] : axes)
  {
    if (!view->GetProperty(property.c_str()) ||
      *vtkSMPropertyHelper(view, property.c_str()).GetAsString())
    {
      return;
    }
  }
  const std::string unit = FindLengthUnit(Output(this));
  for (const auto& [axis, property] : axes)
  {
    if (const char* text = hint->GetAttribute(axis.c_str()))
    {
      const std::string title =
        Title(text, hint->GetAttributeOrEmpty((axis + "_unit").c_str()), unit);
      vtkSMPropertyHelper(view, property.c_str()).Set(title.c_str());
    }
  }
  int logarithmic = 0;
  if (hint->GetScalarAttribute("log_left", &logarithmic))
  {
    vtkSMPropertyHelper(view, "LeftAxisLogScale").Set(logarithmic);
  }
}
