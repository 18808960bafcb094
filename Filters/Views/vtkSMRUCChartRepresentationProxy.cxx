// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMRUCChartRepresentationProxy.h"

#include "OutputHint.h"

#include <vtkObjectFactory.h>
#include <vtkPVXMLElement.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMViewProxy.h>

#include <string>

vtkStandardNewMacro(vtkSMRUCChartRepresentationProxy);

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
  if (vtkPVXMLElement* hint = OutputHint::Find(this))
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
  for (const auto& [axis, property] : axes)
  {
    const std::string title = OutputHint::Title(this, hint, axis);
    vtkSMPropertyHelper(view, property.c_str()).Set(title.c_str());
  }
  int logarithmic = 0;
  if (hint->GetScalarAttribute("log_left", &logarithmic))
  {
    vtkSMPropertyHelper(view, "LeftAxisLogScale").Set(logarithmic);
  }
}
