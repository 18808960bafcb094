// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMRUCRenderViewInitializationHelper.h"

#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMProxyIterator.h>
#include <vtkSMProxySelectionModel.h>
#include <vtkSMRenderViewProxy.h>
#include <vtkSMRepresentationProxy.h>
#include <vtkSMSessionProxyManager.h>
#include <vtkSMSourceProxy.h>

vtkStandardNewMacro(vtkSMRUCRenderViewInitializationHelper);

void vtkSMRUCRenderViewInitializationHelper::PostInitializeProxy(
  vtkSMProxy* filter, vtkPVXMLElement*, vtkMTimeType)
{
  vtkSMSessionProxyManager* proxies = filter->GetSessionProxyManager();
  vtkSMProxySelectionModel* active = proxies->GetSelectionModel("ActiveView");
  if (!active || !active->GetCurrentProxy() ||
    vtkSMRenderViewProxy::SafeDownCast(active->GetCurrentProxy()))
  {
    return;
  }
  const vtkSMPropertyHelper input(filter, "Input", true);
  auto* source =
    input.GetNumberOfElements() > 0 ? vtkSMSourceProxy::SafeDownCast(input.GetAsProxy()) : nullptr;
  vtkSMRenderViewProxy* found = nullptr;
  vtkNew<vtkSMProxyIterator> views;
  views->SetSessionProxyManager(proxies);
  for (views->Begin("views"); !views->IsAtEnd(); views->Next())
  {
    auto view = vtkSMRenderViewProxy::SafeDownCast(views->GetProxy());
    const bool showsInput =
      view && source && view->FindRepresentation(source, input.GetOutputPort());
    if (view && (!found || showsInput))
    {
      found = view;
    }
    if (showsInput)
    {
      break;
    }
  }
  if (found)
  {
    active->SetCurrentProxy(found, vtkSMProxySelectionModel::CLEAR_AND_SELECT);
  }
}
