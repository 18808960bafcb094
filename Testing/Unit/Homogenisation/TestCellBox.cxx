// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Homogenisation/CellBox.h"

#include <gtest/gtest.h>

#include <stdexcept>

using namespace ruc;

namespace
{
const Vector3 None = { 0, 0, 0 };
const Window Periodic = Window::MakeBox({ 1, 2, 3 }, { 10, 11, 12 }, { true, true, true });
const Window Block = Window::MakeBox({ 1, 2, 3 }, { 10, 11, 12 }, { false, true, false });
}

TEST(CellBox, IsAllOfAPeriodicBox)
{
  for (CellBoundary boundary : { CellBoundary::Automatic, CellBoundary::Periodic })
  {
    const CellBox box = FindCellBox(Periodic, 1.0, boundary, None, None);
    EXPECT_EQ(box.Box, Periodic);
    EXPECT_FALSE(box.Mirrored);
  }
  EXPECT_TRUE(FindCellBox(Periodic, 1.0, CellBoundary::Mirrored, None, None).Mirrored);
}

TEST(CellBox, KeepsAwayFromWhereSpheresAreLacking)
{
  const CellBox box = FindCellBox(Block, 0.5, CellBoundary::Automatic, None, None);
  EXPECT_TRUE(box.Mirrored);
  EXPECT_EQ(box.Box, Window::MakeBox({ 1.5, 2, 3.5 }, { 9, 11, 11 }, { false, false, false }));
  const CellBox part =
    FindCellBox(Block, 0.5, CellBoundary::Automatic, { 1.5, 2, 3.5 }, { 2, 3, 4 });
  EXPECT_EQ(part.Box, Window::MakeBox({ 1.5, 2, 3.5 }, { 2, 3, 4 }, { false, false, false }));
  EXPECT_THROW(FindCellBox(Block, 0.5, CellBoundary::Automatic, { 1.4, 2, 3.5 }, { 2, 3, 4 }),
    std::invalid_argument);
  EXPECT_THROW(FindCellBox(Block, 0.5, CellBoundary::Automatic, { 1.5, 2, 3.5 }, { 9.1, 3, 4 }),
    std::invalid_argument);
}

TEST(CellBox, OfACylinderIsGiven)
{
  const Window cylinder = Window::MakeCylinder({ 0, 0, 0 }, { 0, 0, 1 }, 5, 10);
  EXPECT_THROW(
    FindCellBox(cylinder, 0.5, CellBoundary::Automatic, None, None), std::invalid_argument);
  EXPECT_TRUE(
    FindCellBox(cylinder, 0.5, CellBoundary::Automatic, { -3, -3, 0.5 }, { 6, 6, 9 }).Mirrored);
  EXPECT_THROW(
    FindCellBox(cylinder, 0.5, CellBoundary::Automatic, { -3.3, -3.3, 0.5 }, { 6.6, 6.6, 9 }),
    std::invalid_argument);
}

TEST(CellBox, RefusesWhatMakesNone)
{
  EXPECT_THROW(FindCellBox(Block, 0.5, CellBoundary::Periodic, None, None), std::invalid_argument);
  EXPECT_THROW(FindCellBox(Periodic, 0.5, CellBoundary::Periodic, { 2, 3, 4 }, { 1, 1, 1 }),
    std::invalid_argument);
  EXPECT_THROW(FindCellBox(Periodic, 0.5, CellBoundary::Automatic, { 2, 3, 4 }, { 1, 0, 1 }),
    std::invalid_argument);
  EXPECT_THROW(FindCellBox(Block, 6.0, CellBoundary::Automatic, None, None), std::invalid_argument);
}
