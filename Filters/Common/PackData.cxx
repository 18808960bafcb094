// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PackData.h"

#include "RankCommunicator.h"
#include "ruc/Base/Text.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkLongLongArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace PackData
{
namespace
{
using ruc::Text;

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
  vtkDataArray* id = input->GetPointData()->GetArray("Id");
  for (std::vector<double>* numbers : { &pack.X, &pack.Y, &pack.Z, &pack.Radius })
  {
    numbers->resize(count);
  }
  pack.Mode.resize(withModes ? count : 0);
  pack.Id.resize(id && id->GetNumberOfComponents() == 1 ? count : 0);
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

// The window in the field data, as numbers: what it is (0 none, 1 box, 2 cylinder) and its
// parameters
constexpr int WindowNumbers = 10;

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

std::vector<double> LocalWindow(vtkPointSet* input)
{
  vtkFieldData* fields = input ? input->GetFieldData() : nullptr;
  std::vector<double> window(WindowNumbers, 0.0);
  if (ReadField(fields, "BoxSize", 3, &window[4]))
  {
    window[0] = 1.0;
    ReadField(fields, "BoxOrigin", 3, &window[1]);
    ReadField(fields, "BoxPeriodic", 3, &window[7]);
  }
  else if (ReadField(fields, "CylinderRadius", 1, &window[7]))
  {
    window[0] = 2.0;
    window[6] = 1.0;
    ReadField(fields, "CylinderBase", 3, &window[1]);
    ReadField(fields, "CylinderAxis", 3, &window[4]);
    if (!ReadField(fields, "CylinderHeight", 1, &window[8]))
    {
      throw std::invalid_argument(
        "Field data 'CylinderHeight' is required beside 'CylinderRadius', got none.");
    }
  }
  return window;
}

ruc::Window MakeWindow(const std::vector<double>& w)
{
  if (w[0] == 2.0)
  {
    return ruc::Window::MakeCylinder({ w[1], w[2], w[3] }, { w[4], w[5], w[6] }, w[7], w[8]);
  }
  return ruc::Window::MakeBox(
    { w[1], w[2], w[3] }, { w[4], w[5], w[6] }, { w[7] != 0.0, w[8] != 0.0, w[9] != 0.0 });
}

ruc::Window MakeWindow(const WindowProperties& p)
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
  double bounds[6]; // the least of every axis, and minus the greatest
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

template <class Array, class Value>
void Fill(Array* array, const std::string& name, const std::vector<Value>& values)
{
  array->SetName(name.c_str());
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    array->SetValue(static_cast<vtkIdType>(i), values[i]);
  }
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

std::optional<ruc::Window> FindWindowHere(vtkPointSet* input, const WindowProperties& properties)
{
  const std::vector<double> window = LocalWindow(input);
  if (window[0] != 0.0)
  {
    return MakeWindow(window);
  }
  if (properties.HasBox() || properties.HasCylinder())
  {
    return MakeWindow(properties);
  }
  return {};
}

std::string FindLengthUnit(vtkDataObject* data, RankCommunicator& ranks)
{
  vtkAbstractArray* unit = data ? data->GetFieldData()->GetAbstractArray("LengthUnit") : nullptr;
  return ranks.FirstText(
    unit && unit->GetNumberOfValues() > 0 ? unit->GetVariantValue(0).ToString() : "");
}

vtkDataArray* RequireArray(vtkPointSet* input, const char* name)
{
  vtkAbstractArray* any = input->GetPointData()->GetAbstractArray(name);
  if (!any)
  {
    std::string names;
    for (int a = 0; a < input->GetPointData()->GetNumberOfArrays(); ++a)
    {
      const char* other = input->GetPointData()->GetArrayName(a);
      names += Text(names.empty() ? "'" : ", '", other ? other : "", "'");
    }
    throw std::invalid_argument(Text("A point array '", name, "' is required, got ",
      names.empty() ? "no point arrays" : names,
      name == std::string("Mode") ? "; Particle Modes makes it." : "."));
  }
  vtkDataArray* array = vtkDataArray::SafeDownCast(any);
  if (!array || any->GetNumberOfComponents() != 1)
  {
    throw std::invalid_argument(Text("Array '", name, "' requires numbers of one component, got ",
      any->GetDataTypeAsString(), " of ", any->GetNumberOfComponents(), " component(s)."));
  }
  return array;
}

bool HasArray(vtkPointSet* input, const char* name, RankCommunicator& ranks)
{
  std::int64_t owners = input && input->GetPointData()->HasArray(name) ? 1 : 0;
  ranks.Sum(&owners, 1);
  return owners > 0;
}

namespace
{
// The window of the lowest rank whose piece brings one, else the properties', else the bounds
void FindOrigin(vtkPointSet* input, const WindowProperties& properties,
  const ruc::SpherePack& piece, RankCommunicator& ranks, PackOrigin& origin)
{
  std::vector<double> window(WindowNumbers, 0.0);
  std::string error;
  try
  {
    window = LocalWindow(input);
  }
  catch (const std::invalid_argument& e)
  {
    error = e.what();
  }
  ranks.ThrowIfAny(error);
  std::string text(window[0] != 0.0 ? WindowNumbers * sizeof(double) : 0, '\0');
  std::copy_n(reinterpret_cast<const char*>(window.data()), text.size(), text.begin());
  text = ranks.FirstText(text);
  if (!text.empty())
  {
    std::copy_n(text.data(), text.size(), reinterpret_cast<char*>(window.data()));
    origin.Observed = MakeWindow(window);
    origin.WindowSource = "Input";
  }
  else if (properties.HasBox() || properties.HasCylinder())
  {
    origin.Observed = MakeWindow(properties);
    origin.WindowSource = "Properties";
  }
  else
  {
    origin.Observed = BoundsOfCentres(piece, ranks);
    origin.WindowSource = "Bounds of the centres";
  }
  origin.LengthUnit = FindLengthUnit(input, ranks);
}

std::int64_t CountSpheres(const ruc::SpherePack& piece, RankCommunicator& ranks)
{
  std::int64_t count = static_cast<std::int64_t>(piece.Size());
  ranks.Sum(&count, 1);
  return count;
}
}

PackPiece FindPiece(
  vtkPointSet* input, const WindowProperties& properties, bool withModes, RankCommunicator& ranks)
{
  PackPiece found;
  ruc::SpherePack& piece = found.Piece;
  std::string error;
  try
  {
    piece = ReadPack(input, withModes);
  }
  catch (const std::invalid_argument& e)
  {
    error = e.what();
  }
  ranks.ThrowIfAny(error);
  found.NumberOfSpheres = CountSpheres(piece, ranks);
  if (found.NumberOfSpheres == 0)
  {
    throw std::invalid_argument(ruc::NoSpheres);
  }
  ranks.ThrowIfAny(ruc::FindFaultySphere(piece, withModes, found.NumberOfSpheres));
  FindOrigin(input, properties, piece, ranks, found);
  if (properties.Crop)
  {
    piece = ruc::CropToWindow(piece, found.Observed);
    found.NumberOfSpheres = CountSpheres(piece, ranks);
    if (found.NumberOfSpheres == 0)
    {
      throw std::invalid_argument(
        Text("The ", found.Observed.Describe(), " requires at least one centre inside, got none."));
    }
  }
  std::int64_t outside = 0;
  const std::string example = ruc::FindOutside(piece, found.Observed, outside);
  ranks.Sum(&outside, 1);
  ranks.ThrowIfAny(example.empty()
      ? example
      : ruc::OutsideMessage(found.Observed, outside, found.NumberOfSpheres, example));
  return found;
}

SharedPack FindShare(
  vtkPointSet* input, const WindowProperties& properties, bool withModes, RankCommunicator& ranks)
{
  PackPiece found = FindPiece(input, properties, withModes, ranks);
  SharedPack shared;
  static_cast<PackOrigin&>(shared) = found;
  shared.Share = ruc::SharePack(std::move(found.Piece), found.Observed, withModes, ranks);
  return shared;
}

ObservedPack GatherPack(
  vtkPointSet* input, const WindowProperties& properties, bool withModes, RankCommunicator& ranks)
{
  constexpr std::size_t numbersPerSphere = 6; // x, y, z, radius, mode, id
  const PackPiece found = FindPiece(input, properties, withModes, ranks);
  const ruc::SpherePack& piece = found.Piece;
  std::vector<double> numbers;
  for (std::size_t i = 0; i < piece.Size(); ++i)
  {
    numbers.insert(numbers.end(),
      { piece.X[i], piece.Y[i], piece.Z[i], piece.Radius[i], withModes ? piece.Mode[i] : 0.0,
        piece.Id.empty() ? -1.0 : piece.Id[i] });
  }
  ObservedPack observed;
  static_cast<PackOrigin&>(observed) = found;
  ruc::SpherePack& pack = observed.Pack;
  for (const std::vector<double>& of : ranks.AllGather(numbers))
  {
    for (std::size_t n = 0; n < of.size(); n += numbersPerSphere)
    {
      pack.X.push_back(of[n]);
      pack.Y.push_back(of[n + 1]);
      pack.Z.push_back(of[n + 2]);
      pack.Radius.push_back(of[n + 3]);
      if (withModes)
      {
        pack.Mode.push_back(static_cast<int>(of[n + 4]));
      }
      pack.Id.push_back(static_cast<std::int64_t>(of[n + 5]));
    }
  }
  ruc::SortCanonically(pack);
  if (std::find(pack.Id.begin(), pack.Id.end(), -1) != pack.Id.end())
  {
    std::iota(pack.Id.begin(), pack.Id.end(), 0);
  }
  ruc::ValidatePack(pack, withModes);
  ruc::ValidateWindow(pack, observed.Observed);
  return observed;
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
  Fill(radius.Get(), "Radius", pack.Radius);
  output->GetPointData()->AddArray(radius);
  if (!pack.Mode.empty())
  {
    vtkNew<vtkIntArray> mode;
    Fill(mode.Get(), "Mode", pack.Mode);
    output->GetPointData()->AddArray(mode);
    output->GetPointData()->SetActiveScalars("Mode"); // which views colour by
  }
  output->GetPointData()->AddArray(id);
}

void AddColumn(vtkTable* table, vtkAbstractArray* column)
{
  vtkDataSetAttributes* row = table->GetRowData();
  const int columns = row->GetNumberOfArrays();
  if ((columns & (columns - 1)) == 0)
  {
    row->AllocateArrays(2 * columns + 1);
  }
  // Without a name, by which VTK looks through all the columns that there are
  const std::string name = column->GetName();
  column->SetName(nullptr);
  row->AddArray(column);
  column->SetName(name.c_str());
}

void AddColumn(vtkTable* table, const std::string& name, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> array;
  Fill(array.Get(), name, values);
  AddColumn(table, array);
}

void AddColumn(vtkTable* table, const std::string& name, const std::vector<long long>& values)
{
  vtkNew<vtkLongLongArray> array;
  Fill(array.Get(), name, values);
  AddColumn(table, array);
}

void AddColumn(vtkTable* table, const std::string& name, const std::vector<std::string>& values)
{
  vtkNew<vtkStringArray> array;
  Fill(array.Get(), name, values);
  AddColumn(table, array);
}

void AddField(vtkDataObject* data, const char* name, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> array;
  Fill(array.Get(), name, values);
  data->GetFieldData()->AddArray(array);
}

void AddField(vtkDataObject* data, const char* name, const std::vector<long long>& values)
{
  vtkNew<vtkLongLongArray> array;
  Fill(array.Get(), name, values);
  data->GetFieldData()->AddArray(array);
}

void AddField(vtkDataObject* data, const char* name, const std::string& text)
{
  vtkNew<vtkStringArray> array;
  Fill(array.Get(), name, std::vector<std::string>{ text });
  data->GetFieldData()->AddArray(array);
}

void AddWindow(vtkDataObject* data, const ruc::Window& window)
{
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

void AddOrigin(vtkDataObject* data, const PackOrigin& origin)
{
  AddField(data, "WindowSource", origin.WindowSource);
  AddField(data, "LengthUnit", origin.LengthUnit);
  AddField(data, "PluginVersion", std::string(RUC_VERSION));
}

void AddPackSummary(vtkDataObject* data, const PackOrigin& origin, std::int64_t spheres,
  const std::vector<double>& fractions, double overlapPercent)
{
  AddWindow(data, origin.Observed);
  AddOrigin(data, origin);
  AddField(data, "NumberOfSpheres", std::vector<long long>{ static_cast<long long>(spheres) });
  AddField(data, "VolumeFractions", fractions);
  AddField(data, "OverlapPercent", std::vector<double>{ overlapPercent });
}

std::string OverlapWarning(double percent)
{
  return Text(": the spheres overlap by ", percent,
    " % of their volume, which counts twice; above ", TolerableOverlap,
    " % the result is no longer exact.");
}

void AddLags(vtkTable* table, const ruc::LagGrid& lags)
{
  std::vector<double> r(lags.Count + 1);
  for (int k = 0; k <= lags.Count; ++k)
  {
    r[k] = k * lags.Spacing;
  }
  AddColumn(table, "r", r);
}

std::string PairName(const ruc::TwoPointProbability& probability, int r, int s)
{
  return "S_" + probability.PhaseName(r) + "_" + probability.PhaseName(s);
}
}
