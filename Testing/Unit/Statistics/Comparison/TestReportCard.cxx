// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Reports of cells that are known to be like their pack, and of those that are known not to be.

#include "ruc/Statistics/Comparison/ReportCard.h"

#include "HardPack.h"
#include "Oracles.h"
#include "ThreadRanks.h"
#include "ruc/Statistics/Comparison/GapCounts.h"

#include <gtest/gtest.h>

namespace
{
using ruc::PackDescriptors;
using ruc::Window;

PackDescriptors Measure(const ruc::SpherePack& pack, const Window& box, bool isCell)
{
  ruc::Communicator alone;
  const ruc::PackShare share = ruc::SharePack(pack, box);
  return ruc::MeasureDescriptors(share, { { 0.2, 25 }, 1.65, 27 }, isCell, alone);
}

const HardPack& ThePack()
{
  static const HardPack made(300, 300, 0.4);
  return made;
}

const PackDescriptors& OfThePack()
{
  static const PackDescriptors found = Measure(ThePack().Pack, ThePack().Box, false);
  return found;
}

std::vector<bool> Nothing()
{
  return std::vector<bool>(ruc::CountOf(ruc::DescriptorKind{}), false);
}

double ZOf(const ruc::ReportCard& card, const std::string& name)
{
  for (const ruc::ReportRow& row : card.Rows)
  {
    if (row.Name == name)
    {
      return row.Z;
    }
  }
  ADD_FAILURE() << "no row " << name;
  return 0.0;
}

// The same spheres in the same box on a lattice of rock salt, and five empty sites
ruc::SpherePack OnLattice()
{
  const HardPack& made = ThePack();
  ruc::SpherePack pack;
  int left[] = { 300, 300 };
  for (int n = 0; n < 10 * 8 * 8; ++n)
  {
    const int at[] = { n % 10, n / 10 % 8, n / 80 };
    const int mode = (at[0] + at[1] + at[2]) % 2;
    if (left[mode]-- > 0)
    {
      pack.X.push_back((at[0] + 0.5) / 10 * made.Box.Size[0]);
      pack.Y.push_back((at[1] + 0.5) / 8 * made.Box.Size[1]);
      pack.Z.push_back((at[2] + 0.5) / 8 * made.Box.Size[2]);
      pack.Radius.push_back(mode == 0 ? 1.0 : 0.6);
      pack.Mode.push_back(mode + 1);
    }
  }
  return pack;
}
}

TEST(ReportCard, APackIsLikeItself)
{
  const PackDescriptors asCell = Measure(ThePack().Pack, ThePack().Box, true);
  const ruc::ReportCard card = ruc::MakeReportCard({ OfThePack() }, { asCell }, Nothing());
  EXPECT_GE(card.Rows.size(), 20u);
  for (const ruc::ReportRow& row : card.Rows)
  {
    EXPECT_EQ(row.Z, 0.0) << row.Name;
    EXPECT_GT(row.PackError, 0.0) << row.Name;
  }
  EXPECT_EQ(card.Within(), static_cast<int>(card.Rows.size()));
  EXPECT_EQ(card.Verdict().find("; not in"), std::string::npos) << card.Verdict();
}

TEST(ReportCard, ALatticeDiffersInPlacesAlone)
{
  const PackDescriptors lattice = Measure(OnLattice(), ThePack().Box, true);
  const ruc::ReportCard card = ruc::MakeReportCard({ OfThePack() }, { lattice }, Nothing());
  for (const char* name : { "c_1", "c_2", "c_m", "Surface" })
  {
    EXPECT_LT(std::abs(ZOf(card, name)), 1e-6) << name;
  }
  for (const char* name : { "Neighbours 2 %", "Q6" })
  {
    EXPECT_GT(std::abs(ZOf(card, name)), 4.0) << name;
  }
  EXPECT_NE(card.Verdict().find("; not in: "), std::string::npos) << card.Verdict();
}

TEST(ReportCard, APackOfLessVolumeDiffersInFractions)
{
  const HardPack other(300, 300, 0.3);
  const ruc::ReportCard card =
    ruc::MakeReportCard({ OfThePack() }, { Measure(other.Pack, other.Box, true) }, Nothing());
  for (const char* name : { "c_m", "Surface", "Pore mean", "Neighbours 10 %" })
  {
    EXPECT_GT(std::abs(ZOf(card, name)), 4.0) << name;
  }
}

// Another pack of the same process, and its size, is within the errors of both in nearly all rows
TEST(ReportCard, AnotherPieceIsLikeThePack)
{
  const HardPack large(1600, 1600, 0.4);
  std::vector<PackDescriptors> halves;
  for (int half = 0; half < 2; ++half)
  {
    ruc::Vector3 origin = large.Box.Origin, size = large.Box.Size;
    size[0] *= 0.5;
    origin[0] += half * size[0];
    const Window window = Window::MakeBox(origin, size, { false, false, false });
    ruc::SpherePack part;
    for (std::size_t i = 0; i < large.Pack.Size(); ++i)
    {
      if (window.Contains(large.Pack.Centre(i)))
      {
        part.Append(large.Pack, i);
      }
    }
    halves.push_back(Measure(part, window, half == 1));
  }
  const ruc::ReportCard card = ruc::MakeReportCard({ halves[0] }, { halves[1] }, Nothing());
  // The scatter of a piece of the pack's size comes on top of the pack's own error
  for (const ruc::ReportRow& row : card.Rows)
  {
    EXPECT_LT(std::abs(row.Z), 4.0 * std::sqrt(2.0)) << row.Name;
  }
}

namespace
{
PackDescriptors WithZeta(double zeta, double matrix)
{
  PackDescriptors of;
  of.Sums = ruc::TwoPointProbability(1, { 1.0, 2 });
  of.Sums.S(1, 1)[1] = matrix;
  of.Values.push_back({ "zeta", ruc::DescriptorKind::ThirdOrder, { zeta, 0.5 } });
  return of;
}
}

TEST(ReportCard, SeveralPacksTellTheirScatter)
{
  const PackDescriptors a = WithZeta(1.0, 0.5), b = WithZeta(3.0, 0.7), cell = WithZeta(5.0, 0.9);
  std::vector<bool> fitted = Nothing();
  fitted[static_cast<int>(ruc::DescriptorKind::ThirdOrder)] = true;
  const ruc::ReportCard card = ruc::MakeReportCard({ a, b }, { cell, cell }, fitted);
  ASSERT_EQ(card.Rows.size(), 3u);
  // The mean of 1 and 3 is 2 +- sqrt(2) / sqrt(2); both cells are 5
  EXPECT_EQ(card.Rows[2].Pack, 2.0);
  EXPECT_NEAR(card.Rows[2].PackError, 1.0, 1e-15);
  EXPECT_EQ(card.Rows[2].CellDeviation, 0.0);
  EXPECT_NEAR(card.Rows[2].Z, 3.0, 1e-14);
  EXPECT_TRUE(card.Rows[2].Fitted);
  // S_m_m of the packs is 0.6 +- 0.1, of the cells 0.9
  EXPECT_NEAR(card.Floor, 0.1, 1e-15);
  EXPECT_NEAR(ZOf(card, "S_m_m"), 3.0, 1e-13);
  EXPECT_EQ(card.Verdict(),
    "Representative within the pack's own error in 0 of 3 descriptors; not in: S_rs (Z +3.0), "
    "S_m_m (Z +3.0), zeta (Z +3.0).");
}

TEST(ReportCard, WhatCannotBeMeasuredIsLeftOut)
{
  ruc::SpherePack one;
  one.X = one.Y = one.Z = { 5.0 };
  one.Radius = { 1.0 };
  one.Mode = { 1 };
  ruc::Communicator alone;
  const Window box = Window::MakeBox({ 0, 0, 0 }, { 10, 10, 10 }, { false, false, false });
  const ruc::PackShare share = ruc::SharePack(one, box);
  const PackDescriptors found =
    ruc::MeasureDescriptors(share, { { 0.2, 20 }, 2.0, 27 }, false, alone);
  for (const ruc::Descriptor& of : found.Values)
  {
    EXPECT_TRUE(std::isfinite(of.Value.Value)) << of.Name;
  }
  EXPECT_FALSE(found.LeftOut.empty()); // no sphere is a cut-off from every face
  // Here every sphere lies within the margin of a face
  const Window flat = Window::MakeBox({ 0, 0, 3.5 }, { 20, 20, 3.0 }, { false, false, false });
  const PackDescriptors inFlat =
    ruc::MeasureDescriptors(ruc::SharePack(one, flat), { { 0.1, 8 }, 2.0, 27 }, true, alone);
  for (const ruc::Descriptor& of : inFlat.Values)
  {
    EXPECT_NE(of.Name, "Nearest gap");
  }
}

TEST(ReportCard, TheSameOnRanks)
{
  const HardPack& made = ThePack();
  oracle::ThreadRanks::Run(3,
    [&](ruc::Communicator& ranks)
    {
      ruc::SpherePack own;
      for (std::size_t i = ranks.Rank(); i < made.Pack.Size(); i += 3)
      {
        own.Append(made.Pack, i);
      }
      const PackDescriptors found = ruc::MeasureDescriptors(
        ruc::SharePack(own, made.Box, true, ranks), { { 0.2, 25 }, 1.65, 27 }, false, ranks);
      ASSERT_EQ(found.Values.size(), OfThePack().Values.size());
      for (std::size_t n = 0; n < found.Values.size(); ++n)
      {
        EXPECT_EQ(found.Values[n].Value.Value, OfThePack().Values[n].Value.Value)
          << found.Values[n].Name;
        EXPECT_EQ(found.Values[n].Value.Error, OfThePack().Values[n].Value.Error)
          << found.Values[n].Name;
      }
    });
}

TEST(GapCounts, AllPairs)
{
  const HardPack made(60, 90, 0.4, false);
  const std::vector<double> gaps = { 0.05, 0.3 };
  ruc::Communicator alone;
  const std::vector<ruc::ValueWithError> counts =
    ruc::CountGaps(ruc::SharePack(made.Pack, made.Box), gaps, 0, alone);
  const ruc::SpherePack& pack = made.Pack;
  double sums[2] = {};
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    for (std::size_t j = 0; j < pack.Size(); ++j)
    {
      double d2 = 0.0, weight = 1.0;
      for (int q = 0; q < 3; ++q)
      {
        const double d = pack.Centre(i)[q] - pack.Centre(j)[q];
        d2 += d * d;
        weight *= made.Box.Size[q] / (made.Box.Size[q] - std::abs(d));
      }
      const double gap = std::sqrt(d2) / (pack.Radius[i] + pack.Radius[j]) - 1.0;
      for (int n = 0; n < 2; ++n)
      {
        sums[n] += i != j && gap <= gaps[n] ? weight / pack.Size() : 0.0;
      }
    }
  }
  for (int n = 0; n < 2; ++n)
  {
    EXPECT_NEAR(counts[n].Value, sums[n], 1e-6); // weights are rounded to 2^-24
    EXPECT_TRUE(std::isnan(counts[n].Error));
  }
}
