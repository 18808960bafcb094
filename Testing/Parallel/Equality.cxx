// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Equality.h"

#include "RankCommunicator.h"

#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkIdList.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointSet.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>

namespace
{
void Append(std::vector<double>& numbers, vtkFieldData* fields)
{
  for (int a = 0; fields && a < fields->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = fields->GetArray(a);
    if (array && array->GetName() && array->GetName() == std::string("EstimatedMemory"))
    {
      continue;
    }
    for (vtkIdType v = 0; array && v < array->GetNumberOfValues(); ++v)
    {
      numbers.push_back(array->GetComponent(
        v / array->GetNumberOfComponents(), v % array->GetNumberOfComponents()));
    }
  }
}

// Expects that the values of a slab at all its points or cells are those of the whole image
void ExpectSameVoxels(vtkImageData* slab, vtkImageData* whole, int association)
{
  const bool cells = association == vtkDataObject::CELL;
  const int* extent = slab->GetExtent();
  const auto placeIn = [&](vtkImageData* image, int i, int j, int k)
  {
    int place[3] = { i, j, k };
    return cells ? image->ComputeCellId(place) : image->ComputePointId(place);
  };
  vtkFieldData* values = whole->GetAttributesAsFieldData(association);
  for (int a = 0; a < values->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* expected = values->GetArray(a);
    vtkDataArray* got = slab->GetAttributesAsFieldData(association)->GetArray(expected->GetName());
    ASSERT_TRUE(got || slab->GetNumberOfElements(association) == 0) << expected->GetName();
    for (int k = extent[4]; k <= extent[5] - cells; ++k)
    {
      for (int j = extent[2]; j <= extent[3] - cells; ++j)
      {
        for (int i = extent[0]; i <= extent[1] - cells; ++i)
        {
          for (int c = 0; c < expected->GetNumberOfComponents(); ++c)
          {
            EXPECT_EQ(got->GetComponent(placeIn(slab, i, j, k), c),
              expected->GetComponent(placeIn(whole, i, j, k), c))
              << expected->GetName();
          }
        }
      }
    }
  }
}

void ExpectSameSlab(vtkImageData* slab, vtkImageData* whole)
{
  std::vector<double> got, expected;
  Append(got, slab->GetFieldData());
  Append(expected, whole->GetFieldData());
  EXPECT_TRUE(Same(got, expected)) << "field data";
  for (int association : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    ExpectSameVoxels(slab, whole, association);
  }
}
}

std::vector<double> Numbers(vtkDataObject* data)
{
  std::vector<double> numbers;
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data))
  {
    for (unsigned int n = 0; n < blocks->GetNumberOfBlocks(); ++n)
    {
      const std::vector<double> more = Numbers(blocks->GetBlock(n));
      numbers.insert(numbers.end(), more.begin(), more.end());
    }
  }
  else if (auto* points = vtkPointSet::SafeDownCast(data))
  {
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      numbers.insert(numbers.end(), points->GetPoint(i), points->GetPoint(i) + 3);
    }
    Append(numbers, points->GetPointData());
    vtkNew<vtkIdList> corners;
    for (vtkIdType cell = 0; cell < points->GetNumberOfCells(); ++cell)
    {
      points->GetCellPoints(cell, corners);
      numbers.insert(numbers.end(), corners->begin(), corners->end());
    }
    Append(numbers, points->GetCellData());
  }
  else
  {
    Append(numbers, vtkTable::SafeDownCast(data)->GetRowData());
  }
  Append(numbers, data->GetFieldData());
  return numbers;
}

bool Same(const std::vector<double>& a, const std::vector<double>& b)
{
  return a.size() == b.size() &&
    std::equal(a.begin(), a.end(), b.begin(),
      [](double x, double y) { return x == y || (x != x && y != y); });
}

bool IsEmpty(vtkDataObject* data)
{
  return data->GetNumberOfElements(vtkDataObject::POINT) +
    data->GetNumberOfElements(vtkDataObject::ROW) ==
    0;
}

void ExpectSameOutput(vtkDataObject* got, vtkDataObject* expected)
{
  if (auto* image = vtkImageData::SafeDownCast(got))
  {
    ExpectSameSlab(image, vtkImageData::SafeDownCast(expected));
  }
  else if (Rank() == 0)
  {
    EXPECT_TRUE(Same(Numbers(got), Numbers(expected)));
  }
  else
  {
    EXPECT_TRUE(IsEmpty(got)) << "it is on rank 0 alone";
  }
}

void ExpectSamePieces(vtkDataObject* got, vtkDataObject* expected)
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  const vtkIdType own = got->GetNumberOfElements(vtkDataObject::POINT);
  std::vector<vtkIdType> counts(NumberOfRanks());
  controller->AllGather(&own, counts.data(), 1);
  vtkIdType first = 0;
  for (int rank = 0; rank < Rank(); ++rank)
  {
    first += counts[rank];
  }
  auto* points = vtkPolyData::SafeDownCast(got);
  auto* all = vtkPolyData::SafeDownCast(expected);
  for (vtkIdType i = 0; i < own; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(points->GetPoint(i)[axis], all->GetPoint(first + i)[axis]) << first + i;
    }
    EXPECT_EQ(points->GetPointData()->GetArray("Radius")->GetTuple1(i),
      all->GetPointData()->GetArray("Radius")->GetTuple1(first + i))
      << first + i;
  }
  vtkIdType total = 0;
  controller->AllReduce(&own, &total, 1, vtkCommunicator::SUM_OP);
  EXPECT_EQ(total, all->GetNumberOfPoints());
}

vtkSmartPointer<vtkPolyData> EveryPack::Whole()
{
  return MakePolyData(Pack(), Edge, IsPeriodic(), [](std::size_t) { return true; });
}

std::vector<Spread> Spreads()
{
  const std::size_t rank = Rank(), ranks = NumberOfRanks();
  return {
    { "all on the last rank", [=](std::size_t) { return rank == ranks - 1; } },
    { "in turn", IsMine },
    { "backwards, rank 0 empty where there are others",
      [=](std::size_t i)
      { return ranks == 1 || (rank > 0 && (i % (ranks - 1)) + 1 == ranks - rank); } },
  };
}

std::vector<std::vector<double>> SortedRows(
  std::vector<double> own, std::size_t width, bool onAllRanks)
{
  if (onAllRanks)
  {
    own = RankCommunicator(vtkMultiProcessController::GetGlobalController()).Concatenate(own);
  }
  std::replace_if(
    own.begin(), own.end(), [](double value) { return std::isnan(value); }, -1.0);
  std::vector<std::vector<double>> rows;
  for (auto row = own.begin(); row != own.end(); row += static_cast<std::ptrdiff_t>(width))
  {
    rows.emplace_back(row, row + static_cast<std::ptrdiff_t>(width));
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}
