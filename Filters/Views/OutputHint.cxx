// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OutputHint.h"

#include <vtkDataObject.h>
#include <vtkPVArrayInformation.h>
#include <vtkPVDataInformation.h>
#include <vtkPVXMLElement.h>
#include <vtkSMSourceProxy.h>
#include <vtkSMUncheckedPropertyHelper.h>

#include <cstddef>

OutputHint::Output OutputHint::OutputOf(vtkSMProxy* representation)
{
  // Unchecked values count, as in ParaView's domains
  vtkSMUncheckedPropertyHelper input(representation, "Input");
  return { vtkSMSourceProxy::SafeDownCast(input.GetAsProxy()),
    static_cast<int>(input.GetOutputPort()) };
}

vtkPVXMLElement* OutputHint::Find(vtkSMProxy* representation)
{
  const Output output = OutputOf(representation);
  vtkPVXMLElement* hints = output.Source ? output.Source->GetHints() : nullptr;
  for (unsigned int n = 0; hints && n < hints->GetNumberOfNestedElements(); ++n)
  {
    vtkPVXMLElement* hint = hints->GetNestedElement(n);
    int port = -1;
    if (hint->GetAttributeOrEmpty("type") == std::string(representation->GetXMLName()) &&
      hint->GetScalarAttribute("port", &port) && port == output.Port)
    {
      return hint;
    }
  }
  return nullptr;
}

std::string OutputHint::Title(
  vtkSMProxy* representation, vtkPVXMLElement* hint, const std::string& axis)
{
  const Output output = OutputOf(representation);
  vtkPVArrayInformation* unit = output.Source->GetDataInformation(output.Port)
                                  ->GetArrayInformation("LengthUnit", vtkDataObject::FIELD);
  const std::string title = hint->GetAttributeOrEmpty(axis.c_str());
  std::string brackets = hint->GetAttributeOrEmpty((axis + "_unit").c_str());
  const std::size_t place = brackets.find('%');
  if (place == std::string::npos)
  {
    return title;
  }
  const std::string text =
    unit && unit->GetNumberOfStringValues() > 0 ? unit->GetStringValue(0) : "";
  return text.empty() ? title : title + " (" + brackets.replace(place, 1, text) + ")";
}
