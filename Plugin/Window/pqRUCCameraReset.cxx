// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqRUCCameraReset.h"

#include <pqApplicationCore.h>
#include <pqDataRepresentation.h>
#include <pqPipelineSource.h>
#include <pqPropertiesPanel.h>
#include <pqRenderView.h>
#include <pqView.h>
#include <vtkPVXMLElement.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMSourceProxy.h>

#include <QApplication>

#include <cstring>
#include <vector>

namespace
{
bool IsOurs(vtkSMProxy* proxy)
{
  if (std::strcmp(proxy->GetXMLName(), "SpherePackReader") == 0) // it is in no menu
  {
    return true;
  }
  vtkPVXMLElement* hints = proxy->GetHints();
  vtkPVXMLElement* menu = hints ? hints->FindNestedElementByName("ShowInMenu") : nullptr;
  const char* category = menu ? menu->GetAttribute("category") : nullptr;
  return category && std::strcmp(category, "Representative Unit Cell") == 0;
}

bool IsAlone(pqPipelineSource* source, pqView* view)
{
  for (pqRepresentation* representation : view->getRepresentations())
  {
    auto* data = qobject_cast<pqDataRepresentation*>(representation);
    if (data && data->isVisible() && data->getInput() != source)
    {
      return false;
    }
  }
  return true;
}

bool ShowsSpheres(pqPipelineSource* source, pqView* view)
{
  for (pqDataRepresentation* representation : source->getRepresentations(view))
  {
    vtkSMProperty* type = representation->getProxy()->GetProperty("Representation");
    if (representation->isVisible() && type &&
      std::strcmp(vtkSMPropertyHelper(type).GetAsString(), "Spheres") == 0)
    {
      return true;
    }
  }
  return false;
}

// Whether the camera looks along z, as it does until somebody turns it
bool IsUnturned(vtkSMProxy* view)
{
  const std::vector<double> position = vtkSMPropertyHelper(view, "CameraPosition").GetDoubleArray();
  const std::vector<double> focus = vtkSMPropertyHelper(view, "CameraFocalPoint").GetDoubleArray();
  const std::vector<double> up = vtkSMPropertyHelper(view, "CameraViewUp").GetDoubleArray();
  return position[0] == focus[0] && position[1] == focus[1] && up[1] == 1.0;
}
}

pqRUCCameraReset::pqRUCCameraReset(QObject* parent)
  : QObject(parent)
{
}

void pqRUCCameraReset::onStartup()
{
  // The plugin may be loaded by hand, or before there is a window
  this->connectPanels();
  QObject::connect(pqApplicationCore::instance(), &pqApplicationCore::clientEnvironmentDone, this,
    &pqRUCCameraReset::connectPanels);
}

void pqRUCCameraReset::connectPanels()
{
  for (QWidget* widget : QApplication::allWidgets())
  {
    if (auto* panel = qobject_cast<pqPropertiesPanel*>(widget))
    {
      QObject::connect(panel, QOverload<pqProxy*>::of(&pqPropertiesPanel::applied), this,
        &pqRUCCameraReset::onApplied, Qt::UniqueConnection);
    }
  }
}

void pqRUCCameraReset::onApplied(pqProxy* proxy)
{
  auto* source = qobject_cast<pqPipelineSource*>(proxy);
  if (!source || this->Seen.contains(proxy->getProxy()->GetGlobalID()) ||
    !IsOurs(proxy->getProxy()))
  {
    return;
  }
  this->Seen.insert(proxy->getProxy()->GetGlobalID());
  for (pqView* view : source->getViews())
  {
    auto* rendered = qobject_cast<pqRenderView*>(view);
    if (!rendered || !IsAlone(source, view))
    {
      continue;
    }
    view->resetDisplay();
    if (ShowsSpheres(source, view) && IsUnturned(view->getProxy()))
    {
      // From above a corner
      rendered->resetViewDirection(0.44, 0.79, -0.42, 0.0, 0.0, 1.0);
    }
  }
}
