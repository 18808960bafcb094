// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Points with arrays of any names and types become packs, the same on any number of ranks
#include "Equality.h"
#include "Refusals.h"

#include "RankCommunicator.h"
#include "vtkRUCPointsToSpherePack.h"

#include "vtkFloatArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <numeric>

using Points = vtkRUCPointsToSpherePack;

namespace
{
class PointsEquality : public EveryPack
{
};
INSTANTIATE_EVERY_PACK(PointsEquality);

// The name of this filter in messages
const std::string Name = "Points To Sphere Pack";

template <class Array>
void AddArray(
  vtkPointSet* points, const char* name, const std::function<double(vtkIdType)>& valueOf)
{
  vtkNew<Array> array;
  array->SetName(name);
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    array->InsertNextValue(valueOf(i));
  }
  points->GetPointData()->AddArray(array);
}

// Puts an array of the pack under another name, times a factor
void Rename(vtkPointSet* points, const char* from, const char* to, double factor = 1.0)
{
  if (vtkDataArray* array = points->GetPointData()->GetArray(from))
  {
    AddArray<vtkDoubleArray>(points, to, [&](vtkIdType i) { return factor * array->GetTuple1(i); });
    points->GetPointData()->RemoveArray(from);
  }
}

vtkSmartPointer<vtkPolyData> Pack(const std::function<bool(std::size_t)>& isMine = IsMine)
{
  return MakePolyData(FewSizes(), Edge, true, isMine);
}

vtkSmartPointer<vtkPolyData> WithoutRadii()
{
  const auto data = Pack();
  data->GetPointData()->RemoveArray("Radius");
  return data;
}

// What a filter makes of its input
struct Made
{
  explicit Made(vtkDataObject* input, const std::function<void(Points*)>& configure = {})
  {
    if (configure)
    {
      configure(this->Filter);
    }
    this->Filter->SetInputDataObject(0, input);
    this->Filter->Update();
    EXPECT_TRUE(this->Error.Texts.empty()) << this->Error.Texts.front();
  }
  vtkPolyData* Output() { return vtkPolyData::SafeDownCast(this->Filter->GetOutputDataObject(0)); }
  // The values of all ranks, in the order of the ranks
  std::vector<double> All(const char* array)
  {
    std::vector<double> own;
    vtkDataArray* values = this->Output()->GetPointData()->GetArray(array);
    for (vtkIdType i = 0; values && i < values->GetNumberOfTuples(); ++i)
    {
      own.push_back(values->GetTuple1(i));
    }
    return RankCommunicator(vtkMultiProcessController::GetGlobalController()).Concatenate(own);
  }

  vtkNew<Points> Filter;
  Errors Error{ this->Filter };
  Warnings Warning{ this->Filter };
};

double Sum(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0);
}

void ExpectWarning(const Made& run, const std::vector<std::string>& parts)
{
  ASSERT_EQ(run.Warning.Texts.size(), Rank() == 0 ? 1u : 0u);
  for (const std::string& text : run.Warning.Texts)
  {
    ExpectParts(text, parts);
  }
}
}

TEST_P(PointsEquality, SpheresAreThoseOfOneRank)
{
  // The spheres of these points, in an order of their own
  const auto spheresOf = [](vtkPolyData* data)
  {
    std::vector<std::array<double, 4>> spheres;
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    {
      const double* p = data->GetPoint(i);
      spheres.push_back(
        { p[0], p[1], p[2], data->GetPointData()->GetArray("Radius")->GetTuple1(i) });
    }
    return spheres;
  };
  std::vector<std::array<double, 4>> expected = spheresOf(this->Whole());
  std::sort(expected.begin(), expected.end());
  RankCommunicator ranks(vtkMultiProcessController::GetGlobalController());
  for (const Spread& spread : Spreads())
  {
    SCOPED_TRACE(spread.Name);
    const auto piece = MakePolyData(this->Pack(), Edge, this->IsPeriodic(), spread.IsMine);
    Rename(piece, "Radius", "D", 2.0);
    Made made(piece);
    EXPECT_EQ(made.Output()->GetNumberOfPoints(), piece->GetNumberOfPoints());
    std::vector<std::array<double, 4>> spheres = ranks.Concatenate(spheresOf(made.Output()));
    std::sort(spheres.begin(), spheres.end());
    EXPECT_EQ(spheres, expected);
    const std::vector<double> ids = made.All("Id");
    for (std::size_t n = 0; n < ids.size(); ++n)
    {
      EXPECT_EQ(ids[n], static_cast<double>(n));
    }
  }
}

TEST(PointsToSpherePack, RadiiAreFoundByTheirNames)
{
  const double sum = 600 * 0.5; // of the radii 0.4, 0.5 and 0.6
  const struct
  {
    const char* Name;
    double Factor;
    const char* Source;
  } cases[] = { { "Radius", 1.0, "Radii of the array 'Radius'" },
    { "radius", 1.0, "Radii of the array 'radius'" },
    { "RADII", 1.0, "Radii of the array 'RADII'" },
    { "r [mm]", 1.0, "Radii of the array 'r [mm]'" },
    { "Diameter", 2.0, "Diameters of the array 'Diameter'" },
    { "d", 2.0, "Diameters of the array 'd'" } };
  for (const auto& [name, factor, source] : cases)
  {
    SCOPED_TRACE(name);
    const auto data = Pack();
    Rename(data, "Radius", "kept");
    Rename(data, "kept", name, factor);
    Made run(data);
    EXPECT_NEAR(Sum(run.All("Radius")), sum, 1e-9);
    vtkAbstractArray* told = run.Output()->GetFieldData()->GetAbstractArray("RadiusSource");
    EXPECT_EQ(told->GetVariantValue(0).ToString(), source);
    EXPECT_TRUE(run.Warning.Texts.empty());
  }
}

TEST(PointsToSpherePack, ARadiusGoesBeforeADiameterAndAChosenArrayBeforeBoth)
{
  const auto data = Pack();
  AddArray<vtkFloatArray>(data, "diameter", [](vtkIdType) { return 0.25; });
  AddArray<vtkFloatArray>(data, "size", [](vtkIdType) { return 0.125; });
  Made byName(data);
  EXPECT_NEAR(Sum(byName.All("Radius")), 300.0, 1e-9);
  Made diameter(data, [](Points* f) { f->SetRadiusArray("diameter"); });
  EXPECT_EQ(diameter.All("Radius"), std::vector<double>(600, 0.125));
  Made chosen(data, [](Points* f) { f->SetRadiusArray("size"); });
  EXPECT_EQ(chosen.All("Radius"), std::vector<double>(600, 0.125));
  Made halved(data,
    [](Points* f)
    {
      f->SetRadiusArray("size");
      f->SetRadiusIsDiameter(true);
    });
  EXPECT_EQ(halved.All("Radius"), std::vector<double>(600, 0.0625));
}

TEST(PointsToSpherePack, RadiiOfProperties)
{
  const auto data = WithoutRadii();
  Rename(data, "Mode", "type");
  Made uniform(data, [](Points* f) { f->SetUniformRadius(0.125); });
  EXPECT_EQ(uniform.All("Radius"), std::vector<double>(600, 0.125));
  const auto byType = [](Points* f)
  {
    f->SetRadiusByType("1=0.25; 3=0.5");
    f->SetUniformRadius(0.125);
  };
  Made run(data, byType);
  const std::vector<double> types = run.All("Type"), radii = run.All("Radius");
  ASSERT_EQ(radii.size(), 600u);
  for (std::size_t i = 0; i < radii.size(); ++i)
  {
    EXPECT_EQ(radii[i], types[i] == 1 ? 0.25 : types[i] == 3 ? 0.5 : 0.125);
  }
  Made unused(Pack(), byType);
  ExpectWarning(unused, { "UniformRadius and RadiusByType are not used", "'Radius'" });
  EXPECT_NEAR(Sum(unused.All("Radius")), 300.0, 1e-9);
}

TEST(PointsToSpherePack, TypesThatAreNamesAreNumberedTogether)
{
  // A rank has spheres of one name alone, but for one rank
  const auto data = WithoutRadii();
  vtkNew<vtkStringArray> names;
  names->SetName("Species");
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    names->InsertNextValue(Rank() > 0 || (NumberOfRanks() == 1 && i % 2 > 0) ? "glass" : "steel");
  }
  if (data->GetNumberOfPoints() > 0)
  {
    data->GetPointData()->AddArray(names);
  }
  Made run(data, [](Points* f) { f->SetRadiusByType("steel=0.25, glass=0.5"); });
  const std::vector<double> types = run.All("Type"), radii = run.All("Radius");
  ASSERT_EQ(radii.size(), 600u);
  for (std::size_t i = 0; i < radii.size(); ++i)
  {
    EXPECT_EQ(radii[i], types[i] == 1 ? 0.5 : 0.25); // glass is the first
  }
  vtkAbstractArray* told = run.Output()->GetFieldData()->GetAbstractArray("TypeNames");
  ASSERT_EQ(told->GetNumberOfValues(), 2);
  EXPECT_EQ(told->GetVariantValue(0).ToString(), "glass");
  EXPECT_EQ(told->GetVariantValue(1).ToString(), "steel");
}

TEST(PointsToSpherePack, IdsAreThoseOfAnArrayOrPlaces)
{
  std::vector<double> places(600);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    places[i] = static_cast<double>(i);
  }
  EXPECT_EQ(Made(Pack()).All("Id"), places);
  const auto data = Pack();
  AddArray<vtkDoubleArray>(data, "ID", [](vtkIdType i) { return 1000.0 * Rank() - 7.0 * i; });
  Made given(data);
  EXPECT_EQ(given.All("Id"), given.All("ID"));
  const auto halves = Pack();
  AddArray<vtkDoubleArray>(halves, "id",
    [](vtkIdType i) { return i == 5 && Rank() == NumberOfRanks() - 1 ? 0.5 : 1.0 * i; });
  Made run(halves);
  EXPECT_EQ(run.All("Id"), places);
  ExpectWarning(run, { "'id' requires whole numbers as ids, got 0.5", "places" });
}

TEST(PointsToSpherePack, ScaleAppliesToTheWindowOfTheInput)
{
  const auto data = Pack();
  vtkNew<vtkStringArray> unit;
  unit->SetName("LengthUnit");
  unit->InsertNextValue("mm");
  data->GetFieldData()->AddArray(unit);
  Made run(data, [](Points* f) { f->SetScale(1000.0); });
  EXPECT_NEAR(Sum(run.All("Radius")), 300000.0, 1e-6);
  Made uniform(WithoutRadii(),
    [](Points* f)
    {
      f->SetScale(1000.0);
      f->SetUniformRadius(250.0); // in the unit after scaling, as for files
    });
  EXPECT_EQ(uniform.All("Radius"), std::vector<double>(600, 250.0));
  vtkFieldData* fields = run.Output()->GetFieldData();
  if (run.Output()->GetNumberOfPoints() > 0)
  {
    EXPECT_EQ(fields->GetArray("BoxSize")->GetTuple1(0), 1000.0 * Edge);
    EXPECT_EQ(fields->GetAbstractArray("LengthUnit")->GetVariantValue(0).ToString(), "");
  }
  EXPECT_TRUE(run.Warning.Texts.empty());
}

TEST(PointsToSpherePack, AWindowOfThePropertiesIsHandedOn)
{
  const auto data = Pack();
  data->GetFieldData()->Initialize();
  Made run(data,
    [](Points* f)
    {
      f->SetBoxSize(Edge, Edge, Edge);
      f->SetBoxPeriodic(1, 1, 0);
      f->SetLengthUnit("mm");
    });
  vtkFieldData* fields = run.Output()->GetFieldData();
  EXPECT_EQ(fields->GetArray("BoxSize")->GetTuple1(1), 0.0 + Edge);
  EXPECT_EQ(fields->GetArray("NumberOfSpheres")->GetTuple1(0), 600.0);
  EXPECT_EQ(fields->GetAbstractArray("LengthUnit")->GetVariantValue(0).ToString(), "mm");
  EXPECT_TRUE(run.Warning.Texts.empty());
  // The bounds of the centres are no window unless they are found to be one
  Made none(data, [](Points* f) { f->SetFindWindow(false); });
  EXPECT_EQ(none.Output()->GetFieldData()->GetArray("BoxSize"), nullptr);
}

TEST(PointsToSpherePack, CentresOutsideAreMovedOrLeftOut)
{
  const auto data = Pack();
  if (data->GetNumberOfPoints() > 0)
  {
    double p[3];
    data->GetPoint(0, p);
    data->GetPoints()->SetPoint(0, p[0] - Edge, p[1], p[2]);
  }
  Made run(data);
  ExpectWarning(run, { "centres lay outside the periodic box", "were moved into it" });
  EXPECT_EQ(run.All("Id").size(), 600u);
  data->GetFieldData()->Initialize();
  Made cropped(data,
    [](Points* f)
    {
      f->SetBoxSize(Edge, Edge, Edge);
      f->SetCropToWindow(true);
    });
  EXPECT_EQ(cropped.All("Id").size(), 600u - NumberOfRanks());
}

TEST(PointsToSpherePack, PointsOfRadiusZeroAreLeftOut)
{
  const auto data = Pack();
  if (Rank() == NumberOfRanks() - 1)
  {
    data->GetPointData()->GetArray("Radius")->SetTuple1(3, 0.0);
    data->GetPoints()->SetPoint(3, 1e60, 0.0, 0.0); // its place does not matter
  }
  Made run(data);
  ExpectWarning(run, { "1 points of radius 0 are left out" });
  EXPECT_EQ(run.All("Radius").size(), 599u);
}

TEST(PointsToSpherePack, BlocksAndGhostsOfOtherNames)
{
  const auto first = Pack(), ghosts = Pack();
  Rename(first, "Radius", "radius");
  Rename(ghosts, "Radius", "radius");
  AddArray<vtkUnsignedCharArray>(ghosts, "vtkGhostType", [](vtkIdType) { return 1.0; });
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, first);
  blocks->SetBlock(1, ghosts);
  Made run(blocks);
  EXPECT_EQ(run.All("Radius").size(), 600u);
  EXPECT_FALSE(run.Output()->GetPointData()->HasArray("vtkGhostType"));
}

TEST(PointsToSpherePack, ATableIsTakenByItsColumns)
{
  // It is whole on rank 0, as ParaView's reader of tables hands it out
  vtkNew<vtkTable> table;
  const auto all = Pack([](std::size_t) { return true; });
  const auto add = [&](const char* name, const std::function<double(vtkIdType)>& valueOf)
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name);
    for (vtkIdType i = 0; i < all->GetNumberOfPoints(); ++i)
    {
      column->InsertNextValue(valueOf(i));
    }
    table->AddColumn(column);
  };
  if (Rank() == 0)
  {
    const char* const names[3] = { "X [mm]", "Y [mm]", "Z [mm]" };
    for (int axis = 0; axis < 3; ++axis)
    {
      add(names[axis], [&](vtkIdType i) { return all->GetPoint(i)[axis]; });
    }
    add("Diameter",
      [&](vtkIdType i) { return 2.0 * all->GetPointData()->GetArray("Radius")->GetTuple1(i); });
  }
  const auto inBox = [](Points* f) { f->SetBoxSize(Edge, Edge, Edge); };
  Made run(table, inBox);
  EXPECT_NEAR(Sum(run.All("Radius")), 300.0, 1e-9);
  for (vtkIdType i = 0; Rank() == 0 && i < all->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(run.Output()->GetPoint(i)[2], all->GetPoint(i)[2]);
  }
  EXPECT_EQ(
    run.Output()->GetFieldData()->GetAbstractArray("LengthUnit")->GetVariantValue(0).ToString(),
    "mm");
  EXPECT_TRUE(run.Warning.Texts.empty());

  const auto refuses = [](vtkTable* other, const std::vector<std::string>& parts)
  {
    vtkNew<Points> filter;
    const Errors errors(filter);
    filter->SetInputDataObject(0, other);
    filter->Update();
    ExpectRefusal(filter, errors, parts);
  };
  vtkNew<vtkTable> nowhere, commas;
  if (Rank() == 0)
  {
    nowhere->AddColumn(table->GetColumn(0));
    nowhere->AddColumn(table->GetColumn(3));
    commas->ShallowCopy(table);
    vtkNew<vtkStringArray> y;
    y->SetName("y");
    y->SetNumberOfValues(table->GetNumberOfRows());
    y->SetValue(0, "7");
    y->SetValue(1, "1,5");
    commas->RemoveColumn(1);
    commas->AddColumn(y);
  }
  refuses(nowhere,
    { Name, "Columns x, y and z are required, got 'X [mm]', 'Diameter'", "Table To Points" });
  refuses(commas, { Name, "Column 'y' requires numbers", "got text such as '1,5'" });

  // Columns that may be the same are told, of which the first or the surer name is taken
  if (Rank() == 0)
  {
    add("center_y", [](vtkIdType) { return 1.0; });
    add("d", [](vtkIdType) { return 1.0; });
    add("type", [](vtkIdType) { return 1.0; });
    add("species", [](vtkIdType) { return 2.0; });
  }
  Made twice(table, inBox);
  ExpectWarning(twice,
    { "'Y [mm]' is taken and 'center_y' is not: Table To Points chooses. ",
      "'Diameter' is taken and 'd' is not: RadiusArray chooses. ",
      "'type' is taken and 'species' is not: TypeArray chooses." });
  EXPECT_EQ(twice.All("Radius"), run.All("Radius"));
  // Of what was chosen nothing is told
  Made chosen(table,
    [&](Points* f)
    {
      inBox(f);
      f->SetRadiusArray("Diameter");
      f->SetTypeArray("species");
    });
  ExpectWarning(chosen, { "'Y [mm]' is taken and 'center_y' is not: Table To Points chooses." });
  EXPECT_EQ(chosen.Warning.Texts.empty() ? 0u : chosen.Warning.Texts[0].find("Diameter"),
    Rank() == 0 ? std::string::npos : 0u);
  EXPECT_EQ(Sum(chosen.All("Type")), 1200.0);
}
