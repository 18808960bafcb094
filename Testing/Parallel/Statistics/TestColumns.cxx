// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Tables have the columns that mean something, and may have many of them
#include "PackData.h"
#include "Packs.h"
#include "Ranks.h"

#include "vtkRUCOnePointProbability.h"
#include "vtkRUCThreePointProbability.h"
#include "vtkRUCTwoPointProbability.h"

#include "vtkTable.h"

#include <gtest/gtest.h>

#include <ctime>
#include <string>
#include <vector>

namespace
{
std::vector<std::string> ColumnsOf(vtkTable* table)
{
  std::vector<std::string> names;
  for (vtkIdType c = 0; c < table->GetNumberOfColumns(); ++c)
  {
    names.push_back(table->GetColumnName(c));
  }
  return names;
}

template <class Filter>
std::vector<std::string> ColumnsOf(int port, const std::function<void(Filter*)>& configure)
{
  vtkNew<Filter> filter;
  filter->SetInputData(MakePolyData(FewSizes(), Edge, true, IsMine));
  configure(filter);
  filter->Update();
  return ColumnsOf(vtkTable::SafeDownCast(filter->GetOutputDataObject(port)));
}
using Names = std::vector<std::string>;
}

TEST(Columns, FractionsHaveAnErrorWhereItIsKnown)
{
  using OnePoint = vtkRUCOnePointProbability;
  EXPECT_EQ(ColumnsOf<OnePoint>(0, [](OnePoint*) {}), (Names{ "Phase", "VolumeFraction" }));
  for (int method : { OnePoint::CHORD_SAMPLING, OnePoint::TEMPLATE_SAMPLING })
  {
    EXPECT_EQ(ColumnsOf<OnePoint>(0,
                [&](OnePoint* f)
                {
                  f->SetMethod(method);
                  f->SetNumberOfLines(200);
                  f->SetNumberOfThrows(200);
                }),
      (Names{ "Phase", "VolumeFraction", "VolumeFraction_error" }));
  }
}

TEST(Columns, ChecksLeaveOutWhatIsZeroByConstruction)
{
  using TwoPoint = vtkRUCTwoPointProbability;
  const auto columns = [](int method)
  {
    return ColumnsOf<TwoPoint>(TwoPoint::CHECKS,
      [&](TwoPoint* f)
      {
        f->SetMethod(method);
        f->SetNumberOfLags(8);
        f->SetNumberOfLines(200);
        f->SetNumberOfThrows(200);
      });
  };
  EXPECT_EQ(columns(TwoPoint::EXACT_PAIR_SUM),
    (Names{ "Pair", "Limit", "ErrorAtZero", "ErrorAtInfinity", "SaturationLength" }));
  const Names sampled = { "Pair", "Limit", "ErrorAtInfinity", "Asymmetry", "SaturationLength" };
  EXPECT_EQ(columns(TwoPoint::CHORD_SAMPLING), sampled);
  EXPECT_EQ(columns(TwoPoint::TEMPLATE_SAMPLING), sampled);
}

TEST(Columns, ThreePointChecksHaveAnErrorWhereItIsAskedFor)
{
  using ThreePoint = vtkRUCThreePointProbability;
  const auto columns = [](bool errors)
  {
    return ColumnsOf<ThreePoint>(ThreePoint::CHECKS,
      [&](ThreePoint* f)
      {
        f->SetNumberOfLags(8);
        f->SetNumberOfDirections(4);
        f->SetNumberOfThrows(20);
        f->SetStandardErrors(errors);
      });
  };
  EXPECT_EQ(columns(false), (Names{ "Triple", "Place", "Limit", "Difference" }));
  EXPECT_EQ(columns(true), (Names{ "Triple", "Place", "Limit", "Difference", "StandardError" }));
}

// Voxels whose value is not a number, as resampling leaves them, are outside
TEST(Columns, FractionsOfAMaskWithNumbersInPart)
{
  const auto fractions = [](double outside)
  {
    vtkNew<vtkRUCOnePointProbability> filter;
    filter->SetInputData(MakePolyData(FewSizes(), Edge, false, IsMine));
    filter->SetMethod(vtkRUCOnePointProbability::CHORD_SAMPLING);
    filter->SetNumberOfLines(2000);
    const auto mask = MakeMask(Edge, Rank(), NumberOfRanks());
    vtkNew<vtkDoubleArray> values;
    values->DeepCopy(mask->GetPointData()->GetArray("label"));
    values->SetName("value");
    for (vtkIdType n = 0; n < values->GetNumberOfValues(); ++n)
    {
      values->SetValue(n, values->GetValue(n) == 0.0 ? outside : values->GetValue(n));
    }
    mask->GetPointData()->RemoveArray("label");
    mask->GetPointData()->AddArray(values);
    filter->SetInputDataObject(1, mask);
    filter->Update();
    std::vector<double> found;
    vtkTable* table = vtkTable::SafeDownCast(filter->GetOutputDataObject(0));
    for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
    {
      found.push_back(table->GetValueByName(row, "VolumeFraction").ToDouble());
    }
    return found;
  };
  const std::vector<double> expected = fractions(0.0);
  EXPECT_EQ(expected.size(), Rank() == 0 ? 4u : 0u);
  EXPECT_EQ(fractions(std::nan("")), expected);
}

// 282 modes have that many pairs of phases. VTK's own way looks through all the columns for every
// one that is added, here for some minutes.
TEST(Columns, ManyTakeNoLongerEach)
{
  constexpr int number = 40000;
  vtkNew<vtkTable> table;
  const std::clock_t start = std::clock();
  for (int n = 0; n < number; ++n)
  {
    PackData::AddColumn(table, "column " + std::to_string(n), std::vector<double>{ 1.0 * n });
  }
  EXPECT_LT(double(std::clock() - start) / CLOCKS_PER_SEC, 10.0);
  ASSERT_EQ(table->GetNumberOfColumns(), number);
  for (int n : { 0, 1, 2, 3, 4, 1023, 1024, 1025, number - 1 })
  {
    const std::string name = "column " + std::to_string(n);
    EXPECT_EQ(table->GetColumnName(n), name);
    ASSERT_NE(table->GetColumnByName(name.c_str()), nullptr);
    EXPECT_EQ(table->GetValueByName(0, name.c_str()).ToDouble(), n);
  }
}
