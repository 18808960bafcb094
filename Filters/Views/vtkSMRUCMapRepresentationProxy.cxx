// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMRUCMapRepresentationProxy.h"

#include "OutputHint.h"

#include <vtkBoundingBox.h>
#include <vtkObjectFactory.h>
#include <vtkPVDataInformation.h>
#include <vtkPVXMLElement.h>
#include <vtkSMProperty.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMRenderViewProxy.h>
#include <vtkSMSourceProxy.h>

#include <algorithm>
#include <cctype>
#include <string>

vtkStandardNewMacro(vtkSMRUCMapRepresentationProxy);

int vtkSMRUCMapRepresentationProxy::LoadXMLState(
  vtkPVXMLElement* element, vtkSMProxyLocator* locator)
{
  this->Opened = true;
  return this->Superclass::LoadXMLState(element, locator);
}

void vtkSMRUCMapRepresentationProxy::AddConsumer(vtkSMProperty* property, vtkSMProxy* consumer)
{
  this->Superclass::AddConsumer(property, consumer);
  vtkPVXMLElement* hint = nullptr;
  if (!this->Opened && vtkSMRenderViewProxy::SafeDownCast(consumer) &&
    (hint = OutputHint::Find(this)))
  {
    this->Opened = true;
    this->Open(consumer, hint);
  }
}

void vtkSMRUCMapRepresentationProxy::Open(vtkSMProxy* view, vtkPVXMLElement* hint)
{
  const OutputHint::Output output = OutputHint::OutputOf(this);
  vtkPVDataInformation* data = output.Source->GetDataInformation(output.Port);
  const vtkBoundingBox bounds(data->GetBounds());
  if (!bounds.IsValid())
  {
    return;
  }
  vtkSMPropertyHelper(this, "Slice").Set((data->GetExtent()[5] - data->GetExtent()[4]) / 2);
  this->UpdateVTKObjects();

  const double edge = std::max(bounds.GetLength(0), bounds.GetLength(1));
  if (vtkSMProxy* grid = vtkSMPropertyHelper(this, "DataAxesGrid").GetAsProxy())
  {
    vtkSMPropertyHelper(grid, "GridAxesVisibility").Set(1);
    for (const std::string axis : { "x", "y", "z" })
    {
      const std::string title = OutputHint::Title(this, hint, axis);
      const std::string property = static_cast<char>(std::toupper(axis[0])) + std::string("Title");
      vtkSMPropertyHelper(grid, property.c_str()).Set(title.c_str());
    }
    // Degrees of S_rsq would dwarf lags of a few units wherever the camera is reset
    if (bounds.GetLength(2) > 2.0 * edge)
    {
      double frame[6];
      bounds.GetBounds(frame);
      frame[4] = frame[5] = 0.5 * (frame[4] + frame[5]);
      vtkSMPropertyHelper(grid, "CustomBounds").Set(frame, 6);
      vtkSMPropertyHelper(grid, "UseCustomBounds").Set(1);
    }
    grid->UpdateVTKObjects();
  }

  if (!this->IsCameraFree(view))
  {
    return;
  }
  double center[3];
  bounds.GetCenter(center);
  const double position[3] = { center[0], center[1], center[2] + 3.0 * bounds.GetMaxLength() };
  const double up[3] = { 0.0, 1.0, 0.0 };
  vtkSMPropertyHelper(view, "CameraFocalPoint").Set(center, 3);
  vtkSMPropertyHelper(view, "CameraPosition").Set(position, 3);
  vtkSMPropertyHelper(view, "CameraViewUp").Set(up, 3);
  // In perspective the axes lie behind the slice
  vtkSMPropertyHelper(view, "CameraParallelProjection").Set(1);
  vtkSMPropertyHelper(view, "CameraParallelScale").Set(0.75 * edge);
}

bool vtkSMRUCMapRepresentationProxy::IsCameraFree(vtkSMProxy* view)
{
  vtkSMPropertyHelper others(view, "Representations");
  for (unsigned int n = 0; n < others.GetNumberOfElements(); ++n)
  {
    vtkSMProxy* other = others.GetAsProxy(n);
    if (other != this && vtkSMPropertyHelper(other, "Visibility", true).GetAsInt())
    {
      return true;
    }
  }
  return view->GetProperty("CameraPosition")->IsValueDefault();
}
