// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Tables and images that Compare Probabilities refuses
#include "Refusals.h"

#include "vtkRUCCompareProbabilities.h"

#include "vtkStringArray.h"
#include "vtkTable.h"

#include <iomanip>
#include <limits>
#include <sstream>
#include <string>

namespace
{
using Data = vtkSmartPointer<vtkDataObject>;

// A table of S_rs as Two-Point Probability gives it, on rank 0
vtkSmartPointer<vtkTable> MakeTable(int modes, int lags, double spacing)
{
  auto table = vtkSmartPointer<vtkTable>::New();
  if (Rank() > 0)
  {
    return table;
  }
  const auto add = [&](const std::string& name, double scale)
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name.c_str());
    for (int k = 0; k <= lags; ++k)
    {
      column->InsertNextValue(scale * k);
    }
    table->AddColumn(column);
  };
  const auto phase = [=](int p) { return p == modes ? std::string("m") : std::to_string(p + 1); };
  add("r", spacing);
  for (int r = 0; r <= modes; ++r)
  {
    for (int s = r; s <= modes; ++s)
    {
      add("S_" + phase(r) + "_" + phase(s), 0.01 * (r + s + 1));
    }
  }
  return table;
}

// An image as Three-Point Probability gives it; the slab of this rank
vtkSmartPointer<vtkImageData> MakeImage(int lags, double spacing, const std::string& name)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  const int rank = Rank(), ranks = NumberOfRanks();
  image->SetExtent(0, lags, 0, lags, 4 * rank / ranks, 4 * (rank + 1) / ranks);
  image->SetSpacing(spacing, spacing, 45.0);
  vtkNew<vtkDoubleArray> values;
  values->SetName(name.c_str());
  values->SetNumberOfValues(image->GetNumberOfPoints());
  values->Fill(0.25);
  image->GetPointData()->AddArray(values);
  return image;
}

// The input is not compared with the cells; after that the good data are compared with themselves
void RefusesComparison(const std::vector<std::string>& parts, vtkDataObject* input,
  const std::vector<Data>& cells, vtkDataObject* good)
{
  vtkNew<vtkRUCCompareProbabilities> filter;
  const Errors errors(filter);
  filter->SetInputDataObject(0, input);
  for (vtkDataObject* cell : cells)
  {
    filter->AddInputDataObject(1, cell);
  }
  filter->Update();
  std::vector<std::string> all = parts;
  all.push_back("Compare Probabilities");
  ExpectRefusal(filter, errors, all);

  filter->RemoveAllCellConnections();
  filter->SetInputDataObject(0, good);
  filter->AddInputDataObject(1, good);
  filter->Update();
  if (Rank() == 0)
  {
    EXPECT_EQ(errors.Texts.size(), 1u) << "a good cell is taken";
    EXPECT_FALSE(IsEmpty(filter)) << "a good cell gives a result";
  }
}

// The spoiled table as the cell, as the second cell and as the pack's
void RefusesTable(
  const std::vector<std::string>& parts, const std::function<void(vtkTable*)>& spoil)
{
  const auto table = MakeTable(2, 10, 0.5), bad = MakeTable(2, 10, 0.5);
  if (Rank() == 0)
  {
    spoil(bad);
  }
  std::vector<std::string> ofCell = parts, ofInput = parts;
  ofCell.push_back("Cell requires");
  ofInput.push_back("Input requires");
  RefusesComparison(ofCell, table, { Data(bad) }, table);
  RefusesComparison(ofCell, table, { Data(table), Data(bad) }, table);
  RefusesComparison(ofInput, bad, { Data(table) }, table);
}

void RefusesCells(const std::vector<std::string>& parts, const std::vector<Data>& cells)
{
  const auto table = MakeTable(2, 10, 0.5);
  RefusesComparison(parts, table, cells, table);
}

void RefusesImages(const std::vector<std::string>& parts, const std::vector<Data>& cells)
{
  const auto image = MakeImage(6, 0.5, "S_1_1_1");
  RefusesComparison(parts, image, cells, image);
}
}

TEST(TableRefusals, MissingColumn)
{
  RefusesTable({ "S_1_1, S_1_2, … S_m_m", "'S_2_m'" },
    [](vtkTable* t)
    {
      t->RemoveColumnByName("S_2_m");
      vtkNew<vtkDoubleArray> other; // as many columns
      other->SetName("other");
      other->SetNumberOfValues(t->GetNumberOfRows());
      other->Fill(0.0);
      t->AddColumn(other);
    });
}

TEST(TableRefusals, MissingColumns)
{
  RefusesTable({ "6 unordered pairs", "got 5 columns" },
    [](vtkTable* t)
    {
      t->RemoveColumnByName("S_2_m");
      t->RemoveColumnByName("S_m_m");
    });
}

TEST(TableRefusals, NoLags)
{
  RefusesTable({ "got none 'r'" }, [](vtkTable* t) { t->RemoveColumnByName("r"); });
}

TEST(TableRefusals, TooFewRows)
{
  RefusesTable({ "a table with rows, got none" }, [](vtkTable* t) { t->Initialize(); });
  RefusesTable({ "at least two rows", "got 1" }, [](vtkTable* t) { t->SetNumberOfRows(1); });
}

TEST(TableRefusals, NotANumber)
{
  RefusesTable({ "finite numbers, got nan in column S_1_2, row 3" },
    [](vtkTable* t)
    { t->SetValueByName(3, "S_1_2", vtkVariant(std::numeric_limits<double>::quiet_NaN())); });
}

TEST(TableRefusals, UnevenLags)
{
  RefusesTable({ "lags 0, dr, 2 dr", "in row 4, where 2 is due" },
    [](vtkTable* t) { t->SetValueByName(4, "r", vtkVariant(2.1)); });
}

// A number of `digits` digits, as a program writes it, which neither lags nor steps of a table are
// exactly
TEST(TableRefusals, RoundedLags)
{
  for (const int lags : { 10, 277, 2000 })
  {
    const auto exact = MakeTable(2, lags, 200.0 / lags / 1.0007);
    for (const int digits : { 4, 5, 6, 17 })
    {
      const auto rounded = vtkSmartPointer<vtkTable>::New();
      rounded->DeepCopy(exact);
      for (vtkIdType k = 0; k < rounded->GetNumberOfRows(); ++k)
      {
        std::ostringstream text;
        text << std::setprecision(digits) << rounded->GetValueByName(k, "r").ToDouble();
        rounded->SetValueByName(k, "r", vtkVariant(std::stod(text.str())));
      }
      vtkNew<vtkRUCCompareProbabilities> filter;
      const Errors errors(filter);
      filter->SetInputDataObject(0, rounded);
      filter->AddInputDataObject(1, exact);
      filter->Update();
      if (digits == 4)
      {
        ExpectRefusal(filter, errors, { "lags 0, dr, 2 dr" });
      }
      else if (Rank() == 0)
      {
        EXPECT_TRUE(errors.Texts.empty()) << lags << " lags, " << digits << " digits";
        EXPECT_FALSE(IsEmpty(filter));
      }
    }
  }
}

TEST(TableRefusals, Text)
{
  RefusesTable({ "of numbers, got none 'S_m_m'" },
    [](vtkTable* t)
    {
      t->RemoveColumnByName("S_m_m");
      vtkNew<vtkStringArray> text;
      text->SetName("S_m_m");
      text->SetNumberOfValues(t->GetNumberOfRows());
      t->AddColumn(text);
    });
}

TEST(CellTableRefusals, OtherLags)
{
  RefusesCells(
    { "the lags of the input, 10 steps to 5", "got 11 to 5.5" }, { Data(MakeTable(2, 11, 0.5)) });
  RefusesCells(
    { "the lags of the input, 10 steps to 5", "got 10 to 6" }, { Data(MakeTable(2, 10, 0.6)) });
}

TEST(CellTableRefusals, OtherModes)
{
  RefusesCells({ "the modes of the input, 2, got 3" },
    { Data(MakeTable(2, 10, 0.5)), Data(MakeTable(3, 10, 0.5)) });
}

TEST(CellTableRefusals, ImageAgainstTable)
{
  RefusesCells({ "a table, got an image" }, { Data(MakeImage(6, 0.5, "S_1_1_1")) });
}

TEST(CellImageRefusals, TableAgainstImage)
{
  RefusesImages({ "an image, got a table" }, { Data(MakeTable(2, 10, 0.5)) });
}

TEST(CellImageRefusals, TwoImages)
{
  const Data image = MakeImage(6, 0.5, "S_1_1_1");
  RefusesImages({ "one image, got 2" }, { image, image });
}

TEST(CellImageRefusals, OtherSizeOrSpacing)
{
  RefusesImages(
    { "an image of the input's size", "NumberOfLags" }, { Data(MakeImage(7, 0.5, "S_1_1_1")) });
  RefusesImages({ "the spacing of the input, 0.5, got 0.6", "MaximumLag" },
    { Data(MakeImage(6, 0.6, "S_1_1_1")) });
}

TEST(CellImageRefusals, OtherArray)
{
  RefusesImages(
    { "an array of the input's names, got none" }, { Data(MakeImage(6, 0.5, "S_m_m_m")) });
}
