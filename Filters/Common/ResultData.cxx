// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ResultData.h"

#include "ruc/Base/Text.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkLongLongArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

namespace PackData
{
namespace
{
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

void AddColumn(vtkTable* table, vtkAbstractArray* column)
{
  vtkDataSetAttributes* row = table->GetRowData();
  const int columns = row->GetNumberOfArrays();
  if ((columns & (columns - 1)) == 0)
  {
    row->AllocateArrays(2 * columns + 1);
  }
  // The column goes in without its name, since VTK looks through all columns for a name
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
  AddField(data, name, std::vector<std::string>{ text });
}

void AddField(vtkDataObject* data, const char* name, const std::vector<std::string>& texts)
{
  vtkNew<vtkStringArray> array;
  Fill(array.Get(), name, texts);
  data->GetFieldData()->AddArray(array);
}

void AddOrigin(vtkDataObject* data, const PackOrigin& origin)
{
  AddField(data, "WindowSource", origin.WindowSource);
  AddField(data, "LengthUnit", origin.LengthUnit);
  AddField(data, "PluginVersion", std::string(RUC_VERSION));
}

void AddKnownWindow(vtkDataObject* data, const PackOrigin& origin)
{
  if (origin.WindowSource != "Bounds of the centres")
  {
    AddWindow(data, origin.Observed);
  }
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
