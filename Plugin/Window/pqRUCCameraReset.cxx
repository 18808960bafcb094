// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqRUCCameraReset.h"

#include <pqApplicationCore.h>
#include <pqDataRepresentation.h>
#include <pqPipelineSource.h>
#include <pqPropertiesPanel.h>
#include <pqView.h>
#include <vtkPVXMLElement.h>
#include <vtkSMSourceProxy.h>

#include <QApplication>

#include <cstring>

namespace
{
bool IsOurs(vtkSMProxy* proxy)
{
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
    if (view->getViewType() == "RenderView" && IsAlone(source, view))
    {
      view->resetDisplay();
    }
  }
}
