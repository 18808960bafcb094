// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Neighbours are the same on any number of ranks; what is refused and what is told
#include "Equality.h"
#include "Refusals.h"

#include "vtkRUCNeighbourStatistics.h"

#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkTable.h"

using Neighbours = vtkRUCNeighbourStatistics;

namespace
{
const std::string Name = "Neighbour Statistics";

class NeighbourEquality : public EveryPack
{
};
INSTANTIATE_EVERY_PACK(NeighbourEquality);

void AppendArrays(
  std::vector<double>& row, vtkDataSetAttributes* data, std::vector<const char*> names, vtkIdType i)
{
  for (const char* name : names)
  {
    row.push_back(data->GetArray(name)->GetTuple1(i));
  }
}

// The spheres, or contacts, of all ranks
std::vector<std::vector<double>> RowsOf(Neighbours* filter, int port, bool onAllRanks)
{
  auto* data = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(port));
  std::vector<double> own;
  const auto appendPoint = [&](vtkIdType i)
  { own.insert(own.end(), data->GetPoint(i), data->GetPoint(i) + 3); };
  for (vtkIdType i = 0; port == Neighbours::PACK && i < data->GetNumberOfPoints(); ++i)
  {
    appendPoint(i);
    AppendArrays(own, data->GetPointData(),
      { "Radius", "Mode", "CoordinationNumber", "NearestGap", "LocalFraction", "Q4", "Q6",
        "NumberOfFaces", "Rattler", "Whole" },
      i);
  }
  vtkNew<vtkIdList> ends;
  for (vtkIdType i = 0; port == Neighbours::CONTACTS && i < data->GetNumberOfCells(); ++i)
  {
    data->GetCellPoints(i, ends);
    appendPoint(ends->GetId(0));
    appendPoint(ends->GetId(1));
    AppendArrays(own, data->GetCellData(), { "Gap", "Mode1", "Mode2" }, i);
  }
  return SortedRows(own, port == Neighbours::PACK ? 13 : 9, onAllRanks);
}

void ExpectSameNeighbours(const std::function<void(Neighbours*)>& configure, bool withMask = false)
{
  vtkNew<Neighbours> alone;
  configure(alone);
  alone->SetController(nullptr);
  alone->SetInputData(EveryPack::Whole());
  if (withMask)
  {
    alone->SetInputDataObject(1, MakeMask(Edge, 0, 1));
  }
  alone->Update();
  for (const Spread& spread : Spreads())
  {
    SCOPED_TRACE(spread.Name);
    vtkNew<Neighbours> together;
    configure(together);
    together->SetInputData(
      MakePolyData(EveryPack::Pack(), Edge, EveryPack::IsPeriodic(), spread.IsMine));
    if (withMask)
    {
      together->SetInputDataObject(1, MakeMask(Edge, Rank(), NumberOfRanks()));
    }
    together->Update();
    for (int port : { Neighbours::PACK, Neighbours::CONTACTS })
    {
      EXPECT_FALSE(IsEmpty(alone->GetOutputDataObject(port)));
      EXPECT_EQ(RowsOf(together, port, true), RowsOf(alone, port, false));
    }
    for (int port : { Neighbours::GAPS, Neighbours::MEANS })
    {
      EXPECT_FALSE(IsEmpty(alone->GetOutputDataObject(port)));
      ExpectSameOutput(together->GetOutputDataObject(port), alone->GetOutputDataObject(port));
    }
  }
}
}

TEST_P(NeighbourEquality, Contacts)
{
  ExpectSameNeighbours(
    [](Neighbours* f)
    {
      f->SetContactTolerance(0.3);
      f->SetMaximumGap(0.5);
    });
}

TEST_P(NeighbourEquality, WithinAMask)
{
  if (!EveryPack::IsPeriodic())
  {
    ExpectSameNeighbours(
      [](Neighbours* f)
      {
        f->SetContactTolerance(0.2);
        f->SetWindowMargin(2.0);
      },
      true);
  }
}

TEST(NeighbourRefusals, SettingsOutOfRange)
{
  RefusesSettings<Neighbours>(
    { Name, "ContactTolerance <= 0.2", "got 0.21" }, [](auto* f) { f->SetContactTolerance(0.21); });
  RefusesSettings<Neighbours>(
    { Name, "0 < MaximumGap <= 2", "got 0" }, [](auto* f) { f->SetMaximumGap(0.0); });
  RefusesSettings<Neighbours>(
    { Name, "NumberOfGaps requires", "got 0" }, [](auto* f) { f->SetNumberOfGaps(0); });
  RefusesSettings<Neighbours>(
    { Name, "Blocks requires", "got 1." }, [](auto* f) { f->SetBlocks(1); });
  RefusesSettings<Neighbours>(
    { Name, "WindowMargin requires", "got -2" }, [](auto* f) { f->SetWindowMargin(-2.0); }, false);
}

TEST(NeighbourRefusals, NoSphereCounts)
{
  const auto spoil = [](ruc::SpherePack& pack)
  {
    const ruc::SpherePack all = std::exchange(pack, {});
    for (std::size_t i = 0; i < all.Size(); ++i)
    {
      if (all.X[i] < 3.0)
      {
        pack.Append(all, i);
      }
    }
  };
  Refuses<Neighbours>({ Name, "a sphere at least WindowMargin, 4, from every face", "got none" },
    { spoil, {}, {} }, false, [](auto* f) { f->SetWindowMargin(4.0); });
}

TEST(NeighbourRefusals, CellsThatAreNotKnownAreTold)
{
  vtkNew<Neighbours> filter;
  filter->SetInputData(MakePolyData(FewSizes(), Edge, false, IsMine));
  filter->SetWindowMargin(1.0);
  const Warnings warnings(filter);
  filter->Update();
  EXPECT_EQ(warnings.Texts.size(), Rank() == 0 ? 1u : 0u);
  for (const std::string& text : warnings.Texts)
  {
    ExpectParts(text, { "have no cell that is known", "larger WindowMargin" });
  }
}
