// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Void distances are the same on any number of ranks; what is refused and what is told
#include "Equality.h"
#include "Refusals.h"

#include "vtkRUCVoidDistances.h"

#include "vtkTable.h"

using Voids = vtkRUCVoidDistances;

namespace
{
const std::string Name = "Void Distances";

class VoidEquality : public EveryPack
{
};
INSTANTIATE_EVERY_PACK(VoidEquality);
}

TEST_P(VoidEquality, Lattice)
{
  ExpectSame<Voids>([](Voids* f) { f->SetSpacing(0.3); });
}

TEST_P(VoidEquality, WithinAMask)
{
  if (!EveryPack::IsPeriodic())
  {
    ExpectSame<Voids>(
      [](Voids* f)
      {
        f->SetSpacing(0.3);
        f->SetWindowMargin(1.0);
      },
      {}, {}, true);
  }
}

TEST(VoidRefusals, SettingsOutOfRange)
{
  RefusesSettings<Voids>(
    { Name, "Spacing requires Spacing >= 0", "got -1" }, [](auto* f) { f->SetSpacing(-1.0); });
  RefusesSettings<Voids>({ Name, "Spacing requires a lattice of at most 1e+09 points" },
    [](auto* f) { f->SetSpacing(1e-4); });
  RefusesSettings<Voids>({ Name, "MaximumDistance requires less than the periodic edge", "got 12" },
    [](auto* f) { f->SetMaximumDistance(12.0); });
  RefusesSettings<Voids>(
    { Name, "NumberOfDistances requires", "got 0" }, [](auto* f) { f->SetNumberOfDistances(0); });
  RefusesSettings<Voids>({ Name, "Blocks requires", "got 1." }, [](auto* f) { f->SetBlocks(1); });
  RefusesSettings<Voids>(
    { Name, "room for a margin of" }, [](auto* f) { f->SetMaximumDistance(8.0); }, false);
}

TEST(VoidRefusals, PointsBeyondTheMaximumDistanceAreTold)
{
  vtkNew<Voids> filter;
  filter->SetInputData(MakePolyData(FewSizes(), Edge, true, IsMine));
  filter->SetSpacing(0.3);
  filter->SetMaximumDistance(0.2);
  const Warnings warnings(filter);
  filter->Update();
  EXPECT_EQ(warnings.Texts.size(), Rank() == 0 ? 1u : 0u);
  for (const std::string& text : warnings.Texts)
  {
    ExpectParts(text, { "% of the matrix is MaximumDistance, 0.2", "counts as that far" });
  }
}
