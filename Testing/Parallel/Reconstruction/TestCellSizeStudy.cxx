// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// A study of cell sizes is the same on any number of ranks, and refuses what it cannot do
#include "Equality.h"
#include "Refusals.h"

#include "vtkRUCCellSizeStudy.h"

using Study = vtkRUCCellSizeStudy;

namespace
{
// One case is enough, as the pack plays little part in it
class StudyEquality : public EveryPack
{
};
INSTANTIATE_TEST_SUITE_P(FewSizesPeriodic, StudyEquality, testing::Values(std::tuple(true, true)));

void SmallStudy(Study* f)
{
  f->ClearSizes();
  f->SetSize(0, 30);
  f->SetSize(1, 40);
  f->SetNumberOfCells(2);
  f->SetNumberOfLags(20);
  f->SetMaximumIterations(10);
  f->SetBlocks(27);
}
}

TEST_P(StudyEquality, TwoSizes)
{
  ExpectSame<Study>(SmallStudy);
}

TEST(CellSizeStudyRefusals, Settings)
{
  const auto refuses = [](const char* what, const std::function<void(Study*)>& spoil) {
    RefusesSettings<Study>({ "Cell Size Study", what }, spoil, true, SmallStudy);
  };
  refuses("Sizes requires one or more numbers", [](Study* f) { f->ClearSizes(); });
  refuses("Sizes requires", [](Study* f) { f->SetSize(1, 0); });
  refuses("NumberOfCells requires", [](Study* f) { f->SetNumberOfCells(0); });
  refuses("Blocks requires", [](Study* f) { f->SetBlocks(3); });
  refuses("Seed requires", [](Study* f) { f->SetSeed(-1); });
  refuses("ContactWeight requires", [](Study* f) { f->SetContactWeight(-1.0); });
  refuses("MaximumLag requires", [](Study* f) { f->SetMaximumLag(5.0 * Edge); });
}
