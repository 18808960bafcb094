// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMRUCSpheresRepresentationProxy.h"

#include "OutputHint.h"

#include <vtkClientServerStream.h>
#include <vtkDataObject.h>
#include <vtkObjectFactory.h>
#include <vtkPVArrayInformation.h>
#include <vtkPVDataInformation.h>
#include <vtkPVXMLElement.h>
#include <vtkSMPVRepresentationProxy.h>
#include <vtkSMProperty.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMSourceProxy.h>
#include <vtkSMViewProxy.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string>

vtkStandardNewMacro(vtkSMRUCSpheresRepresentationProxy);

namespace
{
vtkPVDataInformation* DataShown(vtkSMProxy* representation)
{
  const OutputHint::Output output = OutputHint::OutputOf(representation);
  return output.Source ? output.Source->GetDataInformation(output.Port) : nullptr;
}

// The largest mode of the data, or 0 where they have no modes
int NumberOfModes(vtkPVDataInformation* data)
{
  vtkPVArrayInformation* modes =
    data ? data->GetArrayInformation("Mode", vtkDataObject::POINT) : nullptr;
  constexpr int mostColours = 256;
  if (!modes || modes->GetDataType() == VTK_FLOAT || modes->GetDataType() == VTK_DOUBLE ||
    modes->GetNumberOfComponents() != 1)
  {
    return 0;
  }
  const double* range = modes->GetComponentRange(0);
  return range[0] >= 1.0 && range[1] <= mostColours ? static_cast<int>(range[1]) : 0;
}

// How many modes have a label, or -1 where there are other labels
int NumberOfLabels(vtkSMProxy* map)
{
  vtkSMPropertyHelper annotations(map, "Annotations");
  const int labels = annotations.GetNumberOfElements() / 2;
  for (int mode = 1; mode <= labels; ++mode)
  {
    const std::string label = std::to_string(mode);
    if (annotations.GetAsString(2 * mode - 2) != label ||
      annotations.GetAsString(2 * mode - 1) != label)
    {
      return -1;
    }
  }
  return labels;
}

// From the smallest mode to the largest; they are told apart with any colour vision
constexpr std::array<std::array<int, 3>, 9> Colours = { { { 0x33, 0x22, 0x88 },
  { 0x00, 0x77, 0xbb }, { 0x33, 0xbb, 0xee }, { 0x44, 0xaa, 0x99 }, { 0x11, 0x77, 0x33 },
  { 0x99, 0x99, 0x33 }, { 0xdd, 0xaa, 0x33 }, { 0xee, 0x77, 0x33 }, { 0xbb, 0x33, 0x44 } } };
constexpr double ColourOfOne = 6.0; // the place of the colour where there is one mode

// A channel of the colour of a mode, between those of the list
double ColourOf(int mode, int modes, int channel)
{
  const double place = modes > 1 ? (Colours.size() - 1.0) * (mode - 1) / (modes - 1) : ColourOfOne;
  const std::size_t lower = std::min(static_cast<std::size_t>(place), Colours.size() - 2);
  const double share = place - static_cast<double>(lower);
  return ((1.0 - share) * Colours[lower][channel] + share * Colours[lower + 1][channel]) / 255.0;
}

void SetLabels(vtkSMProxy* map, int modes)
{
  vtkSMPropertyHelper annotations(map, "Annotations");
  vtkSMPropertyHelper colours(map, "IndexedColors");
  annotations.SetNumberOfElements(2 * modes);
  colours.SetNumberOfElements(3 * modes);
  for (int mode = 1; mode <= modes; ++mode)
  {
    const std::string label = std::to_string(mode);
    annotations.Set(2 * mode - 2, label.c_str());
    annotations.Set(2 * mode - 1, label.c_str());
    for (int channel = 0; channel < 3; ++channel)
    {
      colours.Set(3 * (mode - 1) + channel, ColourOf(mode, modes, channel));
    }
  }
  vtkSMPropertyHelper(map, "IndexedLookup").Set(1);
  map->UpdateVTKObjects();
}
}

void vtkSMRUCSpheresRepresentationProxy::SetPropertyModifiedFlag(const char* name, int flag)
{
  this->Superclass::SetPropertyModifiedFlag(name, flag);
  if (flag && std::strcmp(name, "LookupTable") == 0)
  {
    this->SetModeColours();
  }
}

void vtkSMRUCSpheresRepresentationProxy::ViewUpdated(vtkSMProxy* view)
{
  this->Superclass::ViewUpdated(view);
  this->ColourLateData();
  this->SetModeColours();
  this->HideWholeSpheres(view);
}

void vtkSMRUCSpheresRepresentationProxy::ColourLateData()
{
  vtkPVDataInformation* data = DataShown(this);
  const bool isEmpty = data && data->GetNumberOfPoints() == 0;
  auto* whole = vtkSMPVRepresentationProxy::SafeDownCast(this->GetTrueParentProxy());
  if (this->WasEmpty && !isEmpty && NumberOfModes(data) > 0 && whole &&
    !whole->GetUsingScalarColoring())
  {
    whole->SetScalarColoring("Mode", vtkDataObject::POINT);
  }
  this->WasEmpty = isEmpty;
}

void vtkSMRUCSpheresRepresentationProxy::HideWholeSpheres(vtkSMProxy* view)
{
  vtkPVXMLElement* hint = OutputHint::Find(this);
  vtkSMSourceProxy* source = OutputHint::OutputOf(this).Source;
  auto* shownIn = vtkSMViewProxy::SafeDownCast(view);
  bool cutShown = false;
  int port = -1;
  if (hint && shownIn && hint->GetScalarAttribute("replaced_by", &port))
  {
    vtkSMProxy* surfaces = shownIn->FindRepresentation(source, port);
    cutShown = surfaces && vtkSMPropertyHelper(surfaces, "Visibility").GetAsInt() &&
      source->GetDataInformation(port)->GetNumberOfPoints() > 0;
  }
  if (cutShown != this->CutShown)
  {
    this->CutShown = cutShown;
    vtkClientServerStream stream;
    stream << vtkClientServerStream::Invoke << VTKOBJECT(this) << "SetCutShown"
           << static_cast<int>(cutShown) << vtkClientServerStream::End;
    this->ExecuteStream(stream);
  }
}

void vtkSMRUCSpheresRepresentationProxy::SetModeColours()
{
  const char* array = vtkSMPropertyHelper(this, "ColorArrayName").GetInputArrayNameToProcess();
  vtkSMProxy* map = vtkSMPropertyHelper(this, "LookupTable").GetAsProxy();
  if (!map || !array || std::strcmp(array, "Mode") != 0)
  {
    return;
  }
  const int modes = NumberOfModes(DataShown(this));
  const int labels = NumberOfLabels(map);
  const bool isNew = labels == 0 && map->GetProperty("RGBPoints")->IsValueDefault() &&
    map->GetProperty("IndexedLookup")->IsValueDefault();
  const bool hasMore = labels > 0 && vtkSMPropertyHelper(map, "IndexedLookup").GetAsInt() == 1;
  if (modes > std::max(labels, 0) && (isNew || hasMore))
  {
    SetLabels(map, modes);
  }
}
