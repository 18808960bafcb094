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
  const auto refuses = [](const std::string& part, const std::string& got,
                         const std::function<void(Voids*)>& spoil, bool periodic = true)
  {
    RefusesSettings<Voids>(
      { Name, part, got }, spoil, periodic, [](Voids* f) { f->SetSpacing(0.4); });
  };
  refuses("Spacing requires Spacing >= 0", "got -1", [](Voids* f) { f->SetSpacing(-1.0); });
  refuses("MemoryLimit", "4000", [](Voids* f) { f->SetSpacing(1e-4); });
  refuses("MaximumDistance requires less than the periodic edge", "got 12",
    [](Voids* f) { f->SetMaximumDistance(12.0); });
  refuses("NumberOfDistances requires", "got 0", [](Voids* f) { f->SetNumberOfDistances(0); });
  refuses("Blocks requires", "got 1.", [](Voids* f) { f->SetBlocks(1); });
  refuses(
    "room for a margin of", "12 x 12 x 12", [](Voids* f) { f->SetMaximumDistance(8.0); }, false);
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
