// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PackData.h"

#include "RankCommunicator.h"
#include "Text.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkLongLongArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace PackData
{
namespace
{
using ruc::Text;

// x, y, z, radius, mode, id
constexpr int NumbersPerSphere = 6;

std::vector<double> LocalSpheres(vtkPointSet* input, bool withModes)
{
  const vtkIdType count = input ? input->GetNumberOfPoints() : 0;
  std::vector<double> numbers(count * NumbersPerSphere, 0.0);
  if (count == 0)
  {
    return numbers;
  }
  vtkDataArray* radius = RequireArray(input, "Radius");
  vtkDataArray* mode = withModes ? RequireArray(input, "Mode") : nullptr;
  vtkDataArray* id = input->GetPointData()->GetArray("Id");
  for (vtkIdType i = 0; i < count; ++i)
  {
    double* sphere = &numbers[i * NumbersPerSphere];
    input->GetPoint(i, sphere);
    sphere[3] = radius->GetTuple1(i);
    sphere[4] = mode ? mode->GetTuple1(i) : 0.0;
    sphere[5] = id && id->GetNumberOfComponents() == 1 ? id->GetTuple1(i) : -1.0;
    if (!(sphere[4] == std::floor(sphere[4]) && std::abs(sphere[4]) <= 2147483647.0))
    {
      throw std::invalid_argument(
        Text("Array 'Mode' requires whole numbers, got ", sphere[4], "."));
    }
  }
  return numbers;
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

ruc::Window BoundsOfCentres(const ruc::SpherePack& pack)
{
  const std::vector<double>* axes[3] = { &pack.X, &pack.Y, &pack.Z };
  ruc::Vector3 origin, size;
  for (int q = 0; q < 3; ++q)
  {
    const auto [low, high] = std::minmax_element(axes[q]->begin(), axes[q]->end());
    origin[q] = *low;
    size[q] = *high - *low;
    if (!(size[q] > 0.0))
    {
      throw std::invalid_argument(Text("A window is required (BoxSize, or CylinderRadius and "
                                       "CylinderHeight): the pack brings none, "
                                       "and the bounds of its centres have no volume."));
    }
  }
  return ruc::Window::MakeBox(origin, size, { false, false, false });
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

ruc::SpherePack GatherPack(vtkPointSet* input, bool withModes, RankCommunicator& ranks)
{
  std::vector<double> numbers;
  std::string error;
  try
  {
    numbers = LocalSpheres(input, withModes);
  }
  catch (const std::invalid_argument& e)
  {
    error = e.what();
  }
  ranks.ThrowIfAny(error);
  if (ranks.Size() > 1)
  {
    vtkMultiProcessController* controller = ranks.GetController();
    const vtkIdType own = static_cast<vtkIdType>(numbers.size());
    std::vector<vtkIdType> lengths(ranks.Size());
    controller->AllGather(&own, lengths.data(), 1);
    std::vector<vtkIdType> offsets(ranks.Size(), 0);
    std::partial_sum(lengths.begin(), lengths.end() - 1, offsets.begin() + 1);
    std::vector<double> all(offsets.back() + lengths.back());
    controller->AllGatherV(numbers.data(), all.data(), own, lengths.data(), offsets.data());
    numbers.swap(all);
  }
  ruc::SpherePack pack;
  const std::size_t count = numbers.size() / NumbersPerSphere;
  for (std::vector<double>* axis : { &pack.X, &pack.Y, &pack.Z, &pack.Radius })
  {
    axis->resize(count);
  }
  pack.Mode.resize(withModes ? count : 0);
  pack.Id.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const double* sphere = &numbers[i * NumbersPerSphere];
    pack.X[i] = sphere[0];
    pack.Y[i] = sphere[1];
    pack.Z[i] = sphere[2];
    pack.Radius[i] = sphere[3];
    pack.Id[i] = static_cast<std::int64_t>(sphere[5]);
    if (withModes)
    {
      pack.Mode[i] = static_cast<int>(sphere[4]);
    }
  }
  // The numbers must be comparable before they can be sorted, and sorted before equal centres can
  // be found.
  const bool comparable =
    std::none_of(numbers.begin(), numbers.end(), [](double v) { return std::isnan(v); });
  if (comparable)
  {
    ruc::SortCanonically(pack);
  }
  if (std::find(pack.Id.begin(), pack.Id.end(), -1) != pack.Id.end())
  {
    std::iota(pack.Id.begin(), pack.Id.end(), 0);
  }
  ruc::ValidatePack(pack, withModes);
  return pack;
}

ObservedPack GatherObservedPack(
  vtkPointSet* input, const WindowProperties& properties, bool withModes, RankCommunicator& ranks)
{
  ObservedPack observed;
  observed.Pack = GatherPack(input, withModes, ranks);

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
  // The numbers of the lowest rank whose piece brings a window
  std::string text(window[0] != 0.0 ? WindowNumbers * sizeof(double) : 0, '\0');
  std::copy_n(reinterpret_cast<const char*>(window.data()), text.size(), text.begin());
  text = ranks.FirstText(text);
  if (!text.empty())
  {
    std::copy_n(text.data(), text.size(), reinterpret_cast<char*>(window.data()));
    observed.Observed = MakeWindow(window);
    observed.WindowSource = "Input";
  }
  else if (properties.HasBox() || properties.HasCylinder())
  {
    observed.Observed = MakeWindow(properties);
    observed.WindowSource = "Properties";
  }
  else
  {
    observed.Observed = BoundsOfCentres(observed.Pack);
    observed.WindowSource = "Bounds of the centres";
  }
  vtkAbstractArray* unit = input ? input->GetFieldData()->GetAbstractArray("LengthUnit") : nullptr;
  observed.LengthUnit = ranks.FirstText(
    unit && unit->GetNumberOfValues() > 0 ? unit->GetVariantValue(0).ToString() : "");
  if (properties.Crop)
  {
    observed.Pack = ruc::CropToWindow(observed.Pack, observed.Observed);
    if (observed.Pack.Empty())
    {
      throw std::invalid_argument(Text(
        "The ", observed.Observed.Describe(), " requires at least one centre inside, got none."));
    }
    ruc::ValidatePack(observed.Pack, withModes);
  }
  ruc::ValidateWindow(observed.Pack, observed.Observed);
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
  }
  output->GetPointData()->AddArray(id);
}

void AddColumn(vtkTable* table, const std::string& name, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> array;
  Fill(array.Get(), name, values);
  table->AddColumn(array);
}

void AddColumn(vtkTable* table, const std::string& name, const std::vector<long long>& values)
{
  vtkNew<vtkLongLongArray> array;
  Fill(array.Get(), name, values);
  table->AddColumn(array);
}

void AddColumn(vtkTable* table, const std::string& name, const std::vector<std::string>& values)
{
  vtkNew<vtkStringArray> array;
  Fill(array.Get(), name, values);
  table->AddColumn(array);
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

void AddOrigin(vtkDataObject* data, const ObservedPack& pack)
{
  AddField(data, "WindowSource", pack.WindowSource);
  AddField(data, "LengthUnit", pack.LengthUnit);
  AddField(data, "PluginVersion", std::string(RUC_VERSION));
}

void AddPackSummary(vtkDataObject* data, const ObservedPack& pack,
  const std::vector<double>& fractions, double overlapPercent)
{
  AddWindow(data, pack.Observed);
  AddOrigin(data, pack);
  AddField(
    data, "NumberOfSpheres", std::vector<long long>{ static_cast<long long>(pack.Pack.Size()) });
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
