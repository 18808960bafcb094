// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Cells are the same on any number of ranks and threads
#include "Equality.h"

#include "vtkRUCUnitCellReconstruction.h"

#include <omp.h>

using Cell = vtkRUCUnitCellReconstruction;

namespace
{
class CellEquality : public EveryPack
{
};
INSTANTIATE_EVERY_PACK(CellEquality);

void SmallCell(Cell* f)
{
  f->SetNumberOfLags(40);
  f->SetNumberOfParticles(60);
  f->SetMaximumIterations(120);
  f->SetContactWeight(0.0); // but for the cases that are about it
  f->SetPoreWeight(0.0);
}

// Three cells, in as many groups of ranks as there are. One case is enough, as the pack plays
// little part in it.
class MethodEquality : public EveryPack
{
protected:
  void ExpectSameCells(int method)
  {
    ExpectSame<Cell>(
      [=](auto* f)
      {
        f->SetMethod(method);
        f->SetNumberOfCells(3);
        f->SetNumberOfLags(20);
        f->SetNumberOfParticles(40);
        f->SetMaximumIterations(20);
        f->SetMaximumGenerations(4);
        f->SetPopulation(7);
        f->SetMatingPool(5);
        f->SetHybridPopulation(5);
        f->SetHybridMatingPool(3);
        f->SetRefinementSteps(4);
      });
  }
};
INSTANTIATE_TEST_SUITE_P(FewSizesPeriodic, MethodEquality, testing::Values(std::tuple(true, true)));
}

TEST_P(CellEquality, OneCell)
{
  ExpectSame<Cell>(SmallCell);
}

TEST_P(CellEquality, WithNearNeighboursAndPores)
{
  ExpectSame<Cell>(
    [](Cell* f)
    {
      SmallCell(f);
      f->SetMaximumIterations(20);
      f->SetContactWeight(1.0);
      f->SetPoreWeight(1.0);
    });
}

TEST_P(CellEquality, ToThePackError)
{
  ExpectSame<Cell>(
    [](Cell* f)
    {
      SmallCell(f);
      f->SetStopAtPackError(true);
    });
}

// A search that goes on tells where it would have ended
TEST(PackError, EndsWhereTheOtherSearchWasWithin)
{
  const auto whole = MakePolyData(FewSizes(), Edge, true, [](std::size_t) { return true; });
  const auto number = [](Cell* cell, const char* name)
  {
    vtkFieldData* fields = cell->GetOutputDataObject(0)->GetFieldData();
    return fields->GetAbstractArray(name)->GetVariantValue(0).ToDouble();
  };
  vtkNew<Cell> ends, goesOn;
  for (const auto& cell : { ends.Get(), goesOn.Get() })
  {
    cell->SetController(nullptr);
    SmallCell(cell);
    cell->SetStopAtPackError(cell == ends.Get());
    cell->SetInputData(whole);
    cell->Update();
    EXPECT_GE(number(cell, "PackErrorIteration"), 1.0);
    EXPECT_LE(number(cell, "Objective"), number(cell, "ObjectiveFloor"));
  }
  EXPECT_EQ(number(ends, "ObjectiveFloor"), number(goesOn, "ObjectiveFloor"));
  EXPECT_LT(number(ends, "Iterations"), number(goesOn, "Iterations"));
  EXPECT_GE(number(ends, "Iterations"), number(goesOn, "PackErrorIteration"));
}

TEST_P(MethodEquality, Gradient)
{
  this->ExpectSameCells(0);
}

TEST_P(MethodEquality, AnnealedPopulation)
{
  this->ExpectSameCells(1);
}

TEST_P(MethodEquality, Hybrid)
{
  this->ExpectSameCells(2);
}

// The other packs leave too few spheres inside
TEST_P(MethodEquality, WithSpectrumAndThirdOrder)
{
  ExpectSame<Cell>(
    [](Cell* f)
    {
      SmallCell(f);
      f->SetMaximumIterations(20);
      f->SetSpectrumWeight(1.0);
      f->SetThirdOrderWeight(1.0);
      f->SetThirdOrderDistance(0, 0.2);
      f->SetThirdOrderDistance(1, 0.7);
      f->SetThirdOrderClasses(1);
      f->SetThirdOrderDegree(3);
    });
}

TEST(ThreadEquality, OneCell)
{
  const int threadsBefore = omp_get_max_threads();
  const auto whole = MakePolyData(FewSizes(), Edge, true, [](std::size_t) { return true; });
  std::vector<double> first;
  for (int threads : { 1, 2, 3 })
  {
    omp_set_num_threads(threads);
    vtkNew<Cell> cell;
    cell->SetController(nullptr);
    SmallCell(cell);
    cell->SetInputData(whole);
    cell->Update();
    const std::vector<double> numbers = Numbers(cell->GetOutputDataObject(0));
    first = first.empty() ? numbers : first;
    EXPECT_EQ(numbers, first) << threads << " threads";
  }
  omp_set_num_threads(threadsBefore);
}
