// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PackData.h"

#include "RankCommunicator.h"
#include "ruc/Base/Text.h"
#include "ruc/Formats/Fields.h"
#include "ruc/Particles/FilledShare.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace PackData
{
namespace
{
using ruc::Text;

// Null where there is none of one component, as for a text that nobody needs
vtkDataArray* FindNumbers(vtkPointSet* input, const char* name)
{
  return FindArray(input->GetPointData(), name, 0);
}

// Leaves out points that have no size (FindPiece)
void LeavePointsOut(ruc::SpherePack& pack, double leastDiameter)
{
  const auto isPoint = [&](double radius)
  { return radius >= 0.0 && radius < ruc::LeastLength && 2.0 * radius < leastDiameter; };
  if (std::any_of(pack.Radius.begin(), pack.Radius.end(), isPoint))
  {
    ruc::SpherePack spheres;
    for (std::size_t i = 0; i < pack.Size(); ++i)
    {
      if (!isPoint(pack.Radius[i]))
      {
        spheres.Append(pack, i);
      }
    }
    pack = std::move(spheres);
  }
}

ruc::SpherePack ReadPack(vtkPointSet* input, bool withModes)
{
  const vtkIdType count = input ? input->GetNumberOfPoints() : 0;
  ruc::SpherePack pack;
  if (count == 0)
  {
    return pack;
  }
  vtkDataArray* radius = RequireArray(input, "Radius");
  vtkDataArray* mode = withModes ? RequireArray(input, "Mode") : nullptr;
  vtkDataArray* id = FindNumbers(input, "Id") ? RequireArray(input, "Id") : nullptr;
  for (std::vector<double>* numbers : { &pack.X, &pack.Y, &pack.Z, &pack.Radius })
  {
    numbers->resize(count);
  }
  pack.Mode.resize(withModes ? count : 0);
  pack.Id.resize(id ? count : 0);
  for (vtkIdType i = 0; i < count; ++i)
  {
    double centre[3];
    input->GetPoint(i, centre);
    pack.X[i] = centre[0];
    pack.Y[i] = centre[1];
    pack.Z[i] = centre[2];
    pack.Radius[i] = radius->GetTuple1(i);
    if (!pack.Id.empty())
    {
      pack.Id[i] = static_cast<std::int64_t>(id->GetTuple1(i));
    }
    if (withModes)
    {
      const double m = mode->GetTuple1(i);
      if (!(m == std::floor(m) && std::abs(m) <= 2147483647.0))
      {
        throw std::invalid_argument(Text("Array 'Mode' requires whole numbers, got ", m, "."));
      }
      pack.Mode[i] = static_cast<int>(m);
    }
  }
  return pack;
}
}

vtkDataArray* FindArray(vtkFieldData* arrays, const char* name, vtkIdType count)
{
  vtkDataArray* array = arrays->GetArray(name);
  return array && array->GetNumberOfComponents() == 1 && array->GetNumberOfTuples() >= count
    ? array
    : nullptr;
}

std::string DescribeArray(vtkAbstractArray* array)
{
  auto* numbers = vtkDataArray::SafeDownCast(array);
  if (numbers)
  {
    return Text(numbers->GetDataTypeAsString(), " of ", numbers->GetNumberOfComponents(),
      numbers->GetNumberOfComponents() == 1 ? " component" : " components");
  }
  // One field that is no number makes text of a column, and it is the one to be told
  std::string example = array->GetNumberOfValues() > 0 ? array->GetVariantValue(0).ToString() : "";
  for (vtkIdType n = 0; n < array->GetNumberOfValues(); ++n)
  {
    bool isNumber = false;
    array->GetVariantValue(n).ToDouble(&isNumber);
    if (!isNumber)
    {
      example = array->GetVariantValue(n).ToString();
      break;
    }
  }
  return "text such as " + ruc::Quote(example);
}

std::string ListArrays(vtkFieldData* arrays)
{
  std::string names;
  for (int a = 0; a < arrays->GetNumberOfArrays(); ++a)
  {
    const char* name = arrays->GetArrayName(a);
    names += Text(names.empty() ? "'" : ", '", name ? name : "",
      vtkDataArray::SafeDownCast(arrays->GetAbstractArray(a)) ? "'" : "' (text)");
  }
  return names.empty() ? "no arrays" : names;
}

vtkDataArray* RequireArray(vtkPointSet* input, const char* name)
{
  vtkAbstractArray* any = input->GetPointData()->GetAbstractArray(name);
  if (!any)
  {
    throw std::invalid_argument(
      Text("A point array '", name, "' is required, got ", ListArrays(input->GetPointData()),
        name == std::string("Mode")       ? "; Particle Modes makes it."
          : name == std::string("Radius") ? "; Points To Sphere Pack makes it."
                                          : "."));
  }
  vtkDataArray* array = vtkDataArray::SafeDownCast(any);
  if (!array || any->GetNumberOfComponents() != 1)
  {
    throw std::invalid_argument(
      Text("Array '", name, "' requires numbers of one component, got ", DescribeArray(any), "."));
  }
  if (array->GetNumberOfTuples() < input->GetNumberOfPoints())
  {
    throw std::invalid_argument(Text("Array '", name, "' requires a value for each of ",
      input->GetNumberOfPoints(), " points, got ", array->GetNumberOfTuples(), "."));
  }
  return array;
}

bool HasArray(vtkPointSet* input, const char* name, RankCommunicator& ranks)
{
  std::int64_t owners = input && FindNumbers(input, name) ? 1 : 0;
  ranks.Sum(&owners, 1);
  return owners > 0;
}

namespace
{
void WarnOfPlaces(
  const ruc::CheckedPiece& piece, RankCommunicator& ranks, std::vector<std::string>& warnings)
{
  const ruc::Window& window = piece.Observed();
  if (piece.NumberMoved() > 0)
  {
    warnings.push_back(Text(piece.NumberMoved(), " of ", piece.NumberOfSpheres(),
      " centres lay outside the ", window.Describe(), " and were moved into it by whole edges."));
  }
  if (const double share = ruc::FindFilledShare(piece.Spheres(), window, ranks); share < 1.0)
  {
    warnings.push_back(Text("the centres fill only a volume of about ", share * window.Volume(),
      " of the window's ", window.Volume(),
      ", and fractions are too low by as much. Was a part cut out of the pack? Its window must be "
      "that of the part."));
  }
}
}

PackPiece FindPiece(vtkPointSet* input, const WindowProperties& properties, bool withModes,
  RankCommunicator& ranks, double leastDiameter)
{
  ruc::SpherePack spheres;
  ranks.Agree([&]() { spheres = ReadPack(input, withModes); });
  LeavePointsOut(spheres, leastDiameter);
  const bool crop = properties.Crop || TakesFoundWindow(input, properties, ranks);
  PackOrigin origin;
  ruc::CheckedPiece piece(
    std::move(spheres), withModes,
    [&](const ruc::SpherePack& own)
    {
      origin = FindOrigin(input, properties, own, ranks);
      return origin.Observed;
    },
    crop, ranks);
  WarnOfPlaces(piece, ranks, origin.Warnings);
  return { origin, std::move(piece) };
}

SharedPack FindShare(
  vtkPointSet* input, const WindowProperties& properties, bool withModes, RankCommunicator& ranks)
{
  PackPiece found = FindPiece(input, properties, withModes, ranks);
  return { found, ruc::SharePack(std::move(found.Piece), ranks) };
}

ObservedPack GatherPack(
  vtkPointSet* input, const WindowProperties& properties, bool withModes, RankCommunicator& ranks)
{
  PackPiece found = FindPiece(input, properties, withModes, ranks);
  return { found, ruc::GatherPack(std::move(found.Piece), ranks) };
}

void FillPolyData(const ruc::SpherePack& pack, vtkPolyData* output)
{
  const vtkIdType count = static_cast<vtkIdType>(pack.Size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkIdTypeArray> id;
  id->SetName("Id");
  id->SetNumberOfValues(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    points->SetPoint(i, pack.X[i], pack.Y[i], pack.Z[i]);
    vertices->InsertNextCell(1, &i);
    id->SetValue(i, pack.Id.empty() ? i : static_cast<vtkIdType>(pack.Id[i]));
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
  vtkNew<vtkDoubleArray> radius;
  radius->SetName("Radius");
  radius->SetNumberOfValues(count);
  std::copy(pack.Radius.begin(), pack.Radius.end(), radius->GetPointer(0));
  output->GetPointData()->AddArray(radius);
  if (!pack.Mode.empty())
  {
    vtkNew<vtkIntArray> mode;
    mode->SetName("Mode");
    mode->SetNumberOfValues(count);
    std::copy(pack.Mode.begin(), pack.Mode.end(), mode->GetPointer(0));
    output->GetPointData()->AddArray(mode);
    output->GetPointData()->SetActiveScalars("Mode"); // views colour by it
  }
  output->GetPointData()->AddArray(id);
}
}
