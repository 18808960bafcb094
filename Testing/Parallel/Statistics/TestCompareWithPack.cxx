// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Reports are the same on any number of ranks, and say what is wrong with packs and cells
#include "Equality.h"
#include "Refusals.h"

#include "vtkRUCCompareWithPack.h"

#include "vtkMultiBlockDataSet.h"
#include "vtkTable.h"

using Compare = vtkRUCCompareWithPack;

namespace
{
vtkSmartPointer<Compare> MakeReport(const std::function<bool(std::size_t)>& isMine, int cells)
{
  auto filter = vtkSmartPointer<Compare>::New();
  filter->SetNumberOfLags(30);
  filter->SetBlocks(27);
  filter->AddInputDataObject(0, MakePolyData(FewSizes(), Edge, true, isMine));
  for (int n = 0; n < cells; ++n)
  {
    ruc::SpherePack other = FewSizes();
    for (double& x : other.X)
    {
      x = x + 0.1 * n < Edge ? x + 0.1 * n : x + 0.1 * n - Edge;
    }
    filter->AddInputDataObject(1, MakePolyData(other, Edge, true, isMine));
  }
  return filter;
}

std::string TextOf(vtkDataObject* data, const char* name)
{
  vtkAbstractArray* field = data->GetFieldData()->GetAbstractArray(name);
  return field ? field->GetVariantValue(0).ToString() : "";
}
}

TEST(CompareWithPack, TheSameOnRanks)
{
  for (int cells : { 1, 2 })
  {
    const auto alone = MakeReport([](std::size_t) { return true; }, cells);
    alone->SetController(nullptr);
    alone->Update();
    for (const Spread& spread : Spreads())
    {
      SCOPED_TRACE(spread.Name);
      const auto together = MakeReport(spread.IsMine, cells);
      together->Update();
      ExpectSameOutput(together->GetOutputDataObject(0), alone->GetOutputDataObject(0));
    }
    if (cells == 1) // the pack itself
    {
      EXPECT_EQ(TextOf(alone->GetOutputDataObject(0), "LargestZ"), "0");
    }
  }
}

TEST(CompareWithPack, BlocksAreCells)
{
  const auto filter = MakeReport(IsMine, 0);
  vtkNew<vtkMultiBlockDataSet> cells;
  for (int n = 0; n < 3; ++n)
  {
    // As Unit Cell Reconstruction leaves them: whole on the first rank
    cells->SetBlock(n,
      Rank() == 0 ? MakePolyData(FewSizes(), Edge, true, [](std::size_t) { return true; })
                  : nullptr);
  }
  filter->AddInputDataObject(1, cells);
  filter->Update();
  EXPECT_EQ(TextOf(filter->GetOutputDataObject(0), "NumberOfCells"), "3");
}

TEST(CompareWithPackRefusals, NoCell)
{
  const auto filter = MakeReport(IsMine, 0);
  const Errors errors(filter);
  filter->Update();
  ExpectRefusal(filter, errors, { "Compare With Pack", "Cell requires one or more cells" });
}

TEST(CompareWithPackRefusals, OtherModes)
{
  const auto filter = MakeReport(IsMine, 0);
  ruc::SpherePack one = FewSizes();
  one.Mode.assign(one.Size(), 1);
  filter->AddInputDataObject(1, MakePolyData(one, Edge, true, IsMine));
  const Errors errors(filter);
  filter->Update();
  ExpectRefusal(filter, errors, { "Compare With Pack", "Cell requires the modes of the input, 3" });
}

TEST(CompareWithPackRefusals, NumberOfBlocks)
{
  for (int blocks : { 0, 7, 1001 })
  {
    const auto filter = MakeReport(IsMine, 1);
    filter->SetBlocks(blocks);
    const Errors errors(filter);
    filter->Update();
    ExpectRefusal(filter, errors, { "Blocks requires a number from 8 to 1000" });
  }
}

TEST(CompareWithPackRefusals, Lags)
{
  const auto filter = MakeReport(IsMine, 1);
  filter->SetMaximumLag(5.0 * Edge);
  const Errors errors(filter);
  filter->Update();
  ExpectRefusal(filter, errors, { "MaximumLag requires" });
}
