// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCPointsToSpherePack.h"

#include "PackData.h"
#include "PackEstimate.h"
#include "PackInput.h"
#include "PackPoints.h"
#include "RankCommunicator.h"
#include "ruc/Base/Estimate.h"
#include "ruc/Base/Require.h"
#include "ruc/Formats/FramePack.h"
#include "ruc/Formats/TableColumns.h"
#include "ruc/Particles/FoundWindow.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

vtkStandardNewMacro(vtkRUCPointsToSpherePack);

namespace
{
using ruc::RowColumns;

constexpr const char* KnownNames =
  "an array named radius, radii, rad, r, diameter, diameters, diam or d";

// The names of the arrays, which are empty where an array cannot have the role
std::vector<std::string> NamesFor(vtkPointSet* input, RowColumns::Role role)
{
  std::vector<std::string> names;
  vtkPointData* arrays = input->GetPointData();
  for (int n = 0; n < arrays->GetNumberOfArrays(); ++n)
  {
    vtkAbstractArray* array = arrays->GetAbstractArray(n);
    const bool fits = array->GetName() && array->GetNumberOfComponents() == 1 &&
      (array->IsA("vtkDataArray") || role == RowColumns::Type);
    names.push_back(fits ? array->GetName() : "");
  }
  return names;
}

// The name of the array that stands for a role by its name, or an empty text
std::string FindName(vtkPointSet* input, RowColumns::Role role)
{
  const std::vector<std::string> names = NamesFor(input, role);
  const int place = ruc::FindColumn(names, role);
  return place < 0 ? "" : names[static_cast<std::size_t>(place)];
}

bool IsByName(const std::string& given)
{
  return given.empty() || given == vtkRUCPointsToSpherePack::FindByName;
}

bool IsWhole(double value, double most)
{
  return value == std::floor(value) && std::abs(value) <= most;
}

vtkStringArray* FindTexts(vtkPointSet* points, const std::string& name)
{
  auto* texts =
    vtkStringArray::SafeDownCast(points->GetPointData()->GetAbstractArray(name.c_str()));
  return texts && texts->GetNumberOfComponents() == 1 &&
      texts->GetNumberOfTuples() >= points->GetNumberOfPoints()
    ? texts
    : nullptr;
}

// Numbers the names that the array has on any rank, from 1. Returns none where types are numbers.
// Collective
std::map<std::string, int> NumberNames(
  vtkPointSet* points, const std::string& array, RankCommunicator& ranks)
{
  std::map<std::string, int> names;
  if (vtkStringArray* texts = FindTexts(points, array))
  {
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      names[texts->GetValue(i)] = 0;
    }
  }
  std::vector<std::string> own;
  for (const auto& [name, number] : names)
  {
    own.push_back(name);
  }
  for (const std::string& name : ranks.Concatenate(own))
  {
    names[name] = 0;
  }
  int next = 1;
  for (auto& [name, number] : names)
  {
    number = next++;
  }
  return names;
}

int ReadType(double value, const std::string& array)
{
  ruc::Require(IsWhole(value, std::numeric_limits<int>::max()), ("Array '" + array + "'").c_str(),
    "whole numbers or names of types", value);
  return static_cast<int>(value);
}

// Adds Type. Returns the names of types that are names. Collective
std::vector<std::string> AddTypes(
  const std::string& array, vtkPolyData* points, RankCommunicator& ranks)
{
  if (array.empty())
  {
    return {};
  }
  const std::map<std::string, int> names = NumberNames(points, array, ranks);
  ranks.Agree(
    [&]()
    {
      if (points->GetNumberOfPoints() == 0)
      {
        return;
      }
      vtkStringArray* texts = names.empty() ? nullptr : FindTexts(points, array);
      vtkDataArray* numbers = texts ? nullptr : PackData::RequireArray(points, array.c_str());
      vtkNew<vtkIntArray> types;
      types->SetName("Type");
      types->SetNumberOfValues(points->GetNumberOfPoints());
      for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
      {
        types->SetValue(
          i, texts ? names.at(texts->GetValue(i)) : ReadType(numbers->GetTuple1(i), array));
      }
      points->GetPointData()->AddArray(types);
      points->GetPointData()->SetActiveScalars("Type"); // views colour by it
    });
  std::vector<std::string> list;
  for (const auto& [name, number] : names)
  {
    list.push_back(name);
  }
  return list;
}
}

int vtkRUCPointsToSpherePack::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPolyData");
  return 1;
}

vtkRUCPointsToSpherePack::Arrays vtkRUCPointsToSpherePack::FindArrays(
  vtkPointSet* input, RankCommunicator& ranks) const
{
  const auto find = [&](const std::string& given, RowColumns::Role role)
  { return IsByName(given) ? ranks.FirstText(input ? FindName(input, role) : "") : given; };
  Arrays arrays;
  arrays.Id = find(this->IdArray, RowColumns::Id);
  arrays.Type = find(this->TypeArray, RowColumns::Type);
  arrays.Radius = find(this->RadiusArray, RowColumns::Radius);
  if (arrays.Radius.empty())
  {
    arrays.Radius = find(FindByName, RowColumns::Diameter);
  }
  arrays.Diameters =
    this->RadiusIsDiameter || ruc::FindColumn({ arrays.Radius }, RowColumns::Diameter) == 0;
  return arrays;
}

void vtkRUCPointsToSpherePack::WarnOfOthers(
  vtkPointSet* input, const Arrays& arrays, RankCommunicator& ranks)
{
  std::string told = PackInput::TellTaken(this->GetInputDataObject(0, 0));
  const auto tell = [&](const std::string& given, RowColumns::Role role, const char* chooser)
  {
    const std::string of =
      input && IsByName(given) ? ruc::TellTaken(NamesFor(input, role), role, chooser) : "";
    told += (told.empty() || of.empty() ? "" : " ") + of;
  };
  tell(this->RadiusArray,
    ruc::FindColumn({ arrays.Radius }, RowColumns::Radius) == 0 ? RowColumns::Radius
                                                                : RowColumns::Diameter,
    "RadiusArray");
  tell(this->IdArray, RowColumns::Id, "IdArray");
  tell(this->TypeArray, RowColumns::Type, "TypeArray");
  told = ranks.FirstText(told);
  if (ranks.Rank() == 0 && !told.empty())
  {
    vtkWarningMacro(<< told);
  }
}

vtkSmartPointer<vtkPolyData> vtkRUCPointsToSpherePack::ScalePoints(
  vtkPointSet* input, RankCommunicator& ranks) const
{
  auto scaled = vtkSmartPointer<vtkPolyData>::New();
  ranks.Agree(
    [&]()
    {
      if (!input)
      {
        return;
      }
      vtkNew<vtkPoints> points;
      points->SetDataTypeToDouble();
      points->SetNumberOfPoints(input->GetNumberOfPoints());
      for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
      {
        double p[3];
        input->GetPoint(i, p);
        points->SetPoint(i, this->Scale * p[0], this->Scale * p[1], this->Scale * p[2]);
      }
      scaled->SetPoints(points);
      scaled->GetPointData()->PassData(input->GetPointData());
      scaled->GetFieldData()->PassData(input->GetFieldData());
      const std::optional<ruc::Window> window = PackData::FindWindowHere(input, {});
      if (window && this->Scale != 1.0)
      {
        PackData::AddWindow(scaled, window->Scaled(this->Scale));
      }
      if (!this->LengthUnit.empty() || this->Scale != 1.0)
      {
        PackData::AddField(scaled, "LengthUnit", this->LengthUnit);
      }
    });
  return scaled;
}

void vtkRUCPointsToSpherePack::AddRadii(const Arrays& arrays,
  const std::vector<std::string>& typeNames, vtkPolyData* points, RankCommunicator& ranks)
{
  ruc::PackSettings settings;
  settings.UniformRadius = this->UniformRadius;
  settings.RadiusByType = this->RadiusByType;
  const bool given = this->UniformRadius != 0.0 || !this->RadiusByType.empty();
  const vtkIdType count = points->GetNumberOfPoints();
  const std::string found = // on a rank that has points
    ranks.FirstText(count > 0 ? PackData::ListArrays(points->GetPointData()) : "");
  if (arrays.Radius.empty() && !given && !found.empty())
  {
    throw std::invalid_argument(ruc::Text("Radii are required: ", KnownNames,
      ", or RadiusArray, UniformRadius or RadiusByType, got ", found, "."));
  }
  vtkNew<vtkDoubleArray> radius;
  radius->SetName("Radius");
  radius->SetNumberOfValues(count);
  std::int64_t withoutSize = 0;
  ranks.Agree(
    [&]()
    {
      std::vector<int> types;
      if (vtkDataArray* array = points->GetPointData()->GetArray("Type");
          array && !arrays.Type.empty())
      {
        for (vtkIdType i = 0; i < count; ++i)
        {
          types.push_back(static_cast<int>(array->GetTuple1(i)));
        }
      }
      const std::vector<double> made =
        ruc::MakeRadii(arrays.Radius.empty() ? count : 0, types, typeNames, settings);
      vtkDataArray* values = arrays.Radius.empty() || count == 0
        ? nullptr
        : PackData::RequireArray(points, arrays.Radius.c_str());
      const double factor = this->Scale * (arrays.Diameters ? 0.5 : 1.0);
      for (vtkIdType i = 0; i < count; ++i)
      {
        const double r = values ? factor * values->GetTuple1(i) : made[i];
        radius->SetValue(i, r);
        withoutSize += r >= 0.0 && r < ruc::LeastLength;
      }
    });
  points->GetPointData()->AddArray(radius);
  ranks.Sum(&withoutSize, 1);
  if (ranks.Rank() == 0 && withoutSize > 0)
  {
    vtkWarningMacro(<< withoutSize << " points of radius 0 are left out.");
  }
  if (ranks.Rank() == 0 && given && !arrays.Radius.empty())
  {
    vtkWarningMacro(<< "UniformRadius and RadiusByType are not used, since the array '"
                    << arrays.Radius << "' has radii.");
  }
}

void vtkRUCPointsToSpherePack::AddIds(
  const Arrays& arrays, vtkPolyData* points, RankCommunicator& ranks)
{
  constexpr double most = 9007199254740992.0; // up to which a double holds every whole number
  const vtkIdType count = points->GetNumberOfPoints();
  vtkDataArray* given = nullptr;
  std::string fault;
  ranks.Agree(
    [&]()
    {
      given = arrays.Id.empty() || count == 0 ? nullptr
                                              : PackData::RequireArray(points, arrays.Id.c_str());
      for (vtkIdType i = 0; given && fault.empty() && i < count; ++i)
      {
        const double id = given->GetTuple1(i);
        fault = IsWhole(id, most)
          ? ""
          : ruc::Text("Array '", arrays.Id, "' requires whole numbers as ids, got ", id);
      }
    });
  fault = ranks.FirstText(fault);
  if (!fault.empty() && this->IdArray == arrays.Id)
  {
    throw std::invalid_argument(fault + ".");
  }
  if (!fault.empty() && ranks.Rank() == 0)
  {
    vtkWarningMacro(<< fault << "; the places of the points are taken instead.");
  }
  vtkIdType first = 0; // of this rank
  const std::vector<std::int64_t> counts = ranks.AllGather(static_cast<std::int64_t>(count));
  for (int rank = 0; rank < ranks.Rank(); ++rank)
  {
    first += static_cast<vtkIdType>(counts[rank]);
  }
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("Id");
  ids->SetNumberOfValues(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    ids->SetValue(
      i, given && fault.empty() ? static_cast<vtkIdType>(given->GetTuple1(i)) : first + i);
  }
  points->GetPointData()->AddArray(ids);
}

void vtkRUCPointsToSpherePack::AddFoundWindow(vtkPolyData* points, RankCommunicator& ranks)
{
  const ruc::WindowChoices choices{ this->WindowErosion, this->FaceKinds };
  ruc::CheckChoices(choices);
  const PackData::WindowProperties properties = this->GetWindowProperties();
  bool known = true;
  ranks.Agree([&]() { known = PackData::FindWindowHere(points, properties).has_value(); });
  known = !ranks.All(!known);
  if (!this->FindWindow || known)
  {
    const std::string unused = ruc::TellUnused(choices, known);
    if (ranks.Rank() == 0 && !unused.empty())
    {
      vtkWarningMacro(<< unused);
    }
    return;
  }
  ruc::SpherePack piece;
  vtkDataArray* radius = points->GetPointData()->GetArray("Radius");
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    const double r = radius->GetTuple1(i);
    if (r >= 0.0 && r < ruc::LeastLength)
    {
      continue; // it is left out
    }
    double centre[3];
    points->GetPoint(i, centre);
    piece.X.push_back(centre[0]);
    piece.Y.push_back(centre[1]);
    piece.Z.push_back(centre[2]);
    piece.Radius.push_back(r);
  }
  const ruc::FoundWindow window = ruc::FindWindow(piece, std::nullopt, choices, ranks);
  PackData::AddFoundWindow(points, window);
  if (ranks.Rank() == 0 && window.Observed)
  {
    vtkLog(INFO, << this->GetLabel() << ": " << window.Observed->Describe() << " by its faces ("
                 << window.Faces << "), " << window.Outside << " spheres outside do not count.");
  }
  for (std::size_t n = 0; ranks.Rank() == 0 && n < window.Warnings.size(); ++n)
  {
    vtkWarningMacro(<< window.Warnings[n]);
  }
}

void vtkRUCPointsToSpherePack::Execute(
  vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks)
{
  ruc::Require(
    this->Scale > 0.0 && std::isfinite(this->Scale), "Scale", "a finite number > 0", this->Scale);
  const Arrays arrays = this->FindArrays(input, ranks);
  this->WarnOfOthers(input, arrays, ranks);
  const vtkSmartPointer<vtkPolyData> points = this->ScalePoints(input, ranks);
  const std::vector<std::string> typeNames = AddTypes(arrays.Type, points, ranks);
  this->AddRadii(arrays, typeNames, points, ranks);
  this->AddIds(arrays, points, ranks);
  this->AddFoundWindow(points, ranks);
  const PackData::PackPiece pack = this->FindPiece(points, false, ranks, 3.0 * ruc::LeastLength);

  vtkPolyData* output = vtkPolyData::GetData(outputs);
  if (points->GetNumberOfPoints() > 0)
  {
    vtkDataArray* radius = points->GetPointData()->GetArray("Radius");
    PackPoints::Copy(
      points, pack.Piece, this->GetCropToWindow(),
      [&](vtkIdType i) { return radius->GetTuple1(i) >= ruc::LeastLength; }, output);
  }
  output->GetFieldData()->PassData(points->GetFieldData());
  if (!typeNames.empty())
  {
    PackData::AddField(output, "TypeNames", typeNames);
  }
  PackData::AddField(output, "RadiusSource",
    !arrays.Radius.empty()
      ? ruc::Text(arrays.Diameters ? "Diameters" : "Radii", " of the array '", arrays.Radius, "'")
      : this->RadiusByType.empty() ? std::string("UniformRadius")
                                   : std::string("RadiusByType"));
  PackData::AddField(output, "NumberOfSpheres",
    std::vector<long long>{ static_cast<long long>(pack.Piece.NumberOfSpheres()) });
  PackData::AddOrigin(output, pack);
  PackData::AddKnownWindow(output, pack);
}

std::optional<ruc::Estimate> vtkRUCPointsToSpherePack::MakeEstimate()
{
  constexpr double secondsPerPoint = 1e-6, bytesPerPoint = 300.0; // with some arrays of their own
  const RankCommunicator ranks(this->GetController());
  const std::optional<double> points =
    PackEstimate::FindSpheres(PackInput::FindHere(this->GetInputDataObject(0, 0), true),
      static_cast<double>(this->GetKnownSpheres()), ranks.Size());
  return points ? std::optional(ruc::Estimate{ *points * secondsPerPoint, 0.0,
                    *points * bytesPerPoint / ruc::BytesOfMegabyte, {} })
                : std::nullopt;
}

void vtkRUCPointsToSpherePack::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RadiusArray: " << this->RadiusArray << "\n";
  os << indent << "RadiusIsDiameter: " << this->RadiusIsDiameter << "\n";
  os << indent << "UniformRadius: " << this->UniformRadius << "\n";
  os << indent << "RadiusByType: " << this->RadiusByType << "\n";
  os << indent << "IdArray: " << this->IdArray << "\n";
  os << indent << "TypeArray: " << this->TypeArray << "\n";
  os << indent << "Scale: " << this->Scale << "\n";
  os << indent << "LengthUnit: " << this->LengthUnit << "\n";
  os << indent << "FindWindow: " << this->FindWindow << "\n";
  os << indent << "WindowErosion: " << this->WindowErosion << "\n";
  os << indent << "FaceKinds: " << this->FaceKinds << "\n";
}
