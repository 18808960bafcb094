// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "NeighbourTables.h"

#include "PackData.h"
#include "ruc/Base/Text.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <cmath>
#include <string>

namespace
{
constexpr double Isostatic = 6.0; // contacts of a sphere without friction

// Adds an array with a value for every member of a list
template <class Array, class Members, class Value>
void AddArray(vtkDataSetAttributes* data, const char* name, const Members& members, Value&& value)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->Allocate(static_cast<vtkIdType>(members.size()));
  for (const auto& member : members)
  {
    array->InsertNextValue(value(member));
  }
  data->AddArray(array);
}

// Adds a column of values and one of their errors
template <class Members, class Figure>
void AddFigures(vtkTable* table, const std::string& name, const Members& members, Figure&& figure)
{
  std::vector<double> values, errors;
  for (const auto& member : members)
  {
    const ruc::ValueWithError found = figure(member);
    values.push_back(found.Value);
    errors.push_back(found.Error);
  }
  PackData::AddColumn(table, name, values);
  PackData::AddColumn(table, name + "_error", errors);
}
}

void NeighbourTables::FillPack(
  const ruc::SpherePack& own, const ruc::NeighbourStatistics& found, vtkPolyData* output)
{
  using Sphere = ruc::NeighbourStatistics::Sphere;
  PackData::FillPolyData(own, output);
  vtkPointData* data = output->GetPointData();
  // Their places in the share are no numbers of the spheres
  data->RemoveArray("Id");
  const std::vector<Sphere>& spheres = found.Spheres;
  AddArray<vtkIntArray>(
    data, "CoordinationNumber", spheres, [](const Sphere& s) { return s.Contacts; });
  AddArray<vtkDoubleArray>(
    data, "NearestGap", spheres, [](const Sphere& s) { return s.NearestGap; });
  AddArray<vtkDoubleArray>(
    data, "LocalFraction", spheres, [](const Sphere& s) { return s.LocalFraction; });
  AddArray<vtkIntArray>(data, "Rattler", spheres, [](const Sphere& s) { return s.Rattler; });
  AddArray<vtkDoubleArray>(data, "Q4", spheres, [](const Sphere& s) { return s.Q4; });
  AddArray<vtkDoubleArray>(data, "Q6", spheres, [](const Sphere& s) { return s.Q6; });
  AddArray<vtkIntArray>(data, "NumberOfFaces", spheres, [](const Sphere& s) { return s.Faces; });
  AddArray<vtkIntArray>(data, "Whole", spheres,
    [](const Sphere& s) { return s.Counts && !std::isnan(s.LocalFraction); });
  data->SetActiveScalars("CoordinationNumber"); // views colour by it
}

void NeighbourTables::FillContacts(const ruc::NeighbourStatistics& found, vtkPolyData* output)
{
  using Contact = ruc::NeighbourStatistics::Contact;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (const Contact& contact : found.Contacts)
  {
    const vtkIdType ends[2] = { points->InsertNextPoint(contact.From.data()),
      points->InsertNextPoint(contact.To.data()) };
    lines->InsertNextCell(2, ends);
  }
  output->SetPoints(points);
  output->SetLines(lines);
  vtkCellData* data = output->GetCellData();
  AddArray<vtkDoubleArray>(data, "Gap", found.Contacts, [](const Contact& c) { return c.Gap; });
  AddArray<vtkIntArray>(data, "Mode1", found.Contacts, [](const Contact& c) { return c.FromMode; });
  AddArray<vtkIntArray>(data, "Mode2", found.Contacts, [](const Contact& c) { return c.ToMode; });
  data->SetActiveScalars("Gap"); // views colour by it
}

void NeighbourTables::FillGaps(const ruc::NeighbourStatistics& found, vtkTable* table)
{
  const auto same = [](const ruc::ValueWithError& value) { return value; };
  PackData::AddColumn(table, "x", found.Gap);
  AddFigures(table, "N", found.Neighbours.back().back(), same);
  // The last row and column are those of all modes
  const std::size_t modes = found.Neighbours.size() - 1;
  for (std::size_t r = 0; r < modes; ++r)
  {
    for (std::size_t s = 0; s < modes; ++s)
    {
      AddFigures(table, ruc::Text("N_", r + 1, "_", s + 1), found.Neighbours[r][s], same);
    }
  }
}

void NeighbourTables::FillMeans(const ruc::NeighbourStatistics& found, vtkTable* table)
{
  using Means = ruc::NeighbourStatistics::Means;
  const std::vector<Means>& rows = found.OfModes;
  std::vector<std::string> modes;
  std::vector<long long> centres;
  for (const Means& means : rows)
  {
    modes.push_back(modes.size() + 1 < rows.size() ? std::to_string(modes.size() + 1) : "all");
    centres.push_back(static_cast<long long>(means.Counted));
  }
  PackData::AddColumn(table, "Mode", modes);
  PackData::AddColumn(table, "NumberOfCentres", centres);
  const std::pair<const char*, ruc::ValueWithError Means::*> columns[] = { { "CoordinationNumber",
                                                                             &Means::Contacts },
    { "NearestGap", &Means::NearestGap }, { "LocalFraction", &Means::LocalFraction },
    { "NumberOfFaces", &Means::Faces }, { "Q4", &Means::Q4 }, { "Q6", &Means::Q6 },
    { "Rattlers", &Means::Rattlers }, { "CoordinationWithoutRattlers", &Means::HeldContacts } };
  for (const auto& [name, figure] : columns)
  {
    AddFigures(table, name, rows, [figure = figure](const Means& means) { return means.*figure; });
  }
  AddFigures(table, "ExcessCoordination", rows,
    [](const Means& means) {
      return ruc::ValueWithError{ means.HeldContacts.Value - Isostatic, means.HeldContacts.Error };
    });
  const char* const axes[] = { "xx", "yy", "zz", "yz", "xz", "xy" };
  for (int n = 0; n < 6; ++n)
  {
    AddFigures(table, std::string("Fabric_") + axes[n], rows,
      [n](const Means& means) { return means.Fabric[n]; });
  }
}
