// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PackWindow.h"

#include "RankCommunicator.h"
#include "ResultData.h"
#include "ruc/Base/Text.h"
#include "ruc/Particles/FoundWindow.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace PackData
{
namespace
{
constexpr std::array<const char*, 7> WindowFields = { "BoxOrigin", "BoxSize", "BoxPeriodic",
  "CylinderBase", "CylinderAxis", "CylinderRadius", "CylinderHeight" };

using ruc::Text;

bool ReadField(vtkFieldData* fields, const char* name, int count, double* values)
{
  vtkDataArray* array = fields ? fields->GetArray(name) : nullptr;
  if (!array)
  {
    return false;
  }
  if (array->GetNumberOfValues() != count)
  {
    throw std::invalid_argument(Text("Field data '", name, "' requires ", count, " number(s), got ",
      array->GetNumberOfValues(), "."));
  }
  for (int i = 0; i < count; ++i)
  {
    values[i] = array->GetVariantValue(i).ToDouble();
  }
  return true;
}

std::optional<ruc::Window> WindowOfFields(vtkFieldData* fields)
{
  ruc::Vector3 place{};
  if (ruc::Vector3 size{}; ReadField(fields, "BoxSize", 3, size.data()))
  {
    ruc::Vector3 periodic{};
    ReadField(fields, "BoxOrigin", 3, place.data());
    ReadField(fields, "BoxPeriodic", 3, periodic.data());
    return ruc::Window::MakeBox(
      place, size, { periodic[0] != 0.0, periodic[1] != 0.0, periodic[2] != 0.0 });
  }
  if (double radius = 0.0; ReadField(fields, "CylinderRadius", 1, &radius))
  {
    ruc::Vector3 axis = { 0.0, 0.0, 1.0 };
    double height = 0.0;
    ReadField(fields, "CylinderBase", 3, place.data());
    ReadField(fields, "CylinderAxis", 3, axis.data());
    if (!ReadField(fields, "CylinderHeight", 1, &height))
    {
      throw std::invalid_argument(
        "Field data 'CylinderHeight' is required beside 'CylinderRadius', got none.");
    }
    return ruc::Window::MakeCylinder(place, axis, radius, height);
  }
  return {};
}

std::string ReadText(vtkDataObject* data, const char* name)
{
  vtkAbstractArray* text = data ? data->GetFieldData()->GetAbstractArray(name) : nullptr;
  return text && text->GetNumberOfValues() > 0 ? text->GetVariantValue(0).ToString() : "";
}

std::optional<ruc::Window> WindowOfFields(vtkPointSet* input)
{
  return input ? WindowOfFields(input->GetFieldData()) : std::nullopt;
}

ruc::Window WindowOfProperties(const WindowProperties& p)
{
  if (p.HasBox() && p.HasCylinder())
  {
    throw std::invalid_argument(
      "Either BoxSize or CylinderRadius and CylinderHeight is required, got both.");
  }
  if (p.HasCylinder())
  {
    return ruc::Window::MakeCylinder({ p.CylinderBase[0], p.CylinderBase[1], p.CylinderBase[2] },
      { p.CylinderAxis[0], p.CylinderAxis[1], p.CylinderAxis[2] }, p.CylinderRadius,
      p.CylinderHeight);
  }
  return ruc::Window::MakeBox({ p.BoxOrigin[0], p.BoxOrigin[1], p.BoxOrigin[2] },
    { p.BoxSize[0], p.BoxSize[1], p.BoxSize[2] },
    { p.BoxPeriodic[0] != 0, p.BoxPeriodic[1] != 0, p.BoxPeriodic[2] != 0 });
}

ruc::Window BoundsOfCentres(const ruc::SpherePack& piece, RankCommunicator& ranks)
{
  const std::vector<double>* axes[3] = { &piece.X, &piece.Y, &piece.Z };
  double bounds[6]; // the least coordinates along every axis, and minus the greatest
  std::fill_n(bounds, 6, std::numeric_limits<double>::infinity());
  for (int q = 0; q < 3; ++q)
  {
    for (double c : *axes[q])
    {
      bounds[q] = std::min(bounds[q], c);
      bounds[3 + q] = std::min(bounds[3 + q], -c);
    }
  }
  ranks.Minimum(bounds, 6);
  ruc::Vector3 size;
  for (int q = 0; q < 3; ++q)
  {
    size[q] = -bounds[3 + q] - bounds[q];
    while (bounds[q] + size[q] < -bounds[3 + q]) // rounding would leave the last centre outside
    {
      size[q] = std::nextafter(size[q], std::numeric_limits<double>::infinity());
    }
  }
  if (!(size[0] > 0.0 && size[1] > 0.0 && size[2] > 0.0))
  {
    throw std::invalid_argument("A window is required (BoxSize, or CylinderRadius and "
                                "CylinderHeight): the pack brings none, "
                                "and the bounds of its centres have no volume.");
  }
  return ruc::Window::MakeBox({ bounds[0], bounds[1], bounds[2] }, size, { false, false, false });
}
}

namespace
{
// Warns of the bounds taken as window. The outermost of n independent centres are about a fraction
// (n - 1) / (n + 1) of each edge apart
std::string NoWindowWarning(const ruc::Window& bounds, double spheres)
{
  const double edge = (spheres + 1.0) / (spheres - 1.0);
  return Text("no window is known (field data, BoxSize, or CylinderRadius and CylinderHeight): the "
              "bounds of the centres are taken, of volume ",
    bounds.Volume(), "; with ", spheres, " spheres fractions are about ",
    100.0 * (edge * edge * edge - 1.0), " % too high.");
}
}

bool WindowProperties::HasBox() const
{
  return this->BoxSize[0] != 0.0 || this->BoxSize[1] != 0.0 || this->BoxSize[2] != 0.0;
}

bool WindowProperties::HasCylinder() const
{
  return this->CylinderRadius != 0.0 || this->CylinderHeight != 0.0;
}

bool WindowProperties::HasAny() const
{
  return this->HasBox() || this->HasCylinder();
}

namespace
{
// Whether a window that was found gives way to what the filter has
bool GivesWay(const WindowProperties& properties)
{
  return properties.HasAny() || properties.Masked;
}
}

std::optional<ruc::Window> FindWindowHere(vtkPointSet* input, const WindowProperties& properties)
{
  const std::optional<ruc::Window> window = WindowOfFields(input);
  if (window && !(GivesWay(properties) && ruc::IsFoundSource(ReadText(input, "WindowSource"))))
  {
    return window;
  }
  return properties.HasAny() ? std::optional(WindowOfProperties(properties)) : std::nullopt;
}

bool TakesFoundWindow(
  vtkPointSet* input, const WindowProperties& properties, RankCommunicator& ranks)
{
  return ruc::IsFoundSource(ranks.FirstText(ReadText(input, "WindowSource"))) &&
    !GivesWay(properties);
}

std::optional<ruc::Window> FindOwnWindow(vtkPointSet* input, RankCommunicator& ranks)
{
  std::vector<ruc::Window> own;
  ranks.Agree(
    [&]()
    {
      if (const std::optional<ruc::Window> window = WindowOfFields(input))
      {
        own.push_back(*window);
      }
    });
  const std::vector<ruc::Window> windows = ranks.Concatenate(own);
  for (const ruc::Window& window : windows)
  {
    if (!(window == windows.front()))
    {
      throw std::invalid_argument(Text("One window is required on all ranks, got a ",
        windows.front().Describe(), " and another ", window.Describe(), "."));
    }
  }
  return windows.empty() ? std::nullopt : std::optional(windows.front());
}

PackOrigin FindOrigin(vtkPointSet* input, const WindowProperties& properties,
  const ruc::SpherePack& piece, RankCommunicator& ranks)
{
  PackOrigin origin;
  const std::optional<ruc::Window> window = FindOwnWindow(input, ranks);
  const std::string source = ranks.FirstText(ReadText(input, "WindowSource"));
  const bool found = window && ruc::IsFoundSource(source);
  if (window && !(found && GivesWay(properties)))
  {
    origin.Observed = *window;
    origin.WindowSource = found ? source : "Input";
    if (properties.HasAny() && !(WindowOfProperties(properties) == origin.Observed))
    {
      origin.Warnings.push_back(
        Text("the window of the properties is not used, since the pack has one of its own, the ",
          origin.Observed.Describe(), ". To take another, read the pack without a window."));
    }
  }
  else if (properties.HasAny())
  {
    origin.Observed = WindowOfProperties(properties);
    origin.WindowSource = "Properties";
  }
  else
  {
    origin.Observed = BoundsOfCentres(piece, ranks);
    origin.WindowSource = "Bounds of the centres";
    std::int64_t spheres = static_cast<std::int64_t>(piece.Size());
    ranks.Sum(&spheres, 1);
    origin.Warnings.push_back(NoWindowWarning(origin.Observed, static_cast<double>(spheres)));
  }
  origin.LengthUnit = FindLengthUnit(input, ranks);
  return origin;
}

std::string FindLengthUnit(vtkDataObject* data, RankCommunicator& ranks)
{
  return ranks.FirstText(ReadText(data, "LengthUnit"));
}

void AddWindow(vtkDataObject* data, const ruc::Window& window)
{
  for (const char* name : WindowFields) // of a window of another shape
  {
    data->GetFieldData()->RemoveArray(name);
  }
  if (window.GetShape() == ruc::Window::Shape::Cylinder)
  {
    AddField(
      data, "CylinderBase", std::vector<double>{ window.Base[0], window.Base[1], window.Base[2] });
    AddField(
      data, "CylinderAxis", std::vector<double>{ window.Axis[0], window.Axis[1], window.Axis[2] });
    AddField(data, "CylinderRadius", std::vector<double>{ window.Radius });
    AddField(data, "CylinderHeight", std::vector<double>{ window.Height });
  }
  else
  {
    AddField(data, "BoxOrigin",
      std::vector<double>{ window.Origin[0], window.Origin[1], window.Origin[2] });
    AddField(
      data, "BoxSize", std::vector<double>{ window.Size[0], window.Size[1], window.Size[2] });
    AddField(data, "BoxPeriodic",
      std::vector<long long>{ window.Periodic[0], window.Periodic[1], window.Periodic[2] });
  }
}

void AddFoundWindow(vtkDataObject* data, const ruc::FoundWindow& found)
{
  if (found.Observed)
  {
    AddWindow(data, *found.Observed);
    AddField(data, "WindowSource", found.Source);
  }
  if (!found.Faces.empty())
  {
    AddField(data, "FaceKinds", found.Faces);
    AddField(data, "WindowErosion", std::vector<double>{ found.Erosion });
  }
}

bool IsOfWholePack(const std::string& field)
{
  return field == "LengthUnit" ||
    std::find(WindowFields.begin(), WindowFields.end(), field) != WindowFields.end();
}
}
