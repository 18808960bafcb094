// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Settings and masks that Three-Point Probability refuses or warns of
#include "Refusals.h"

#include "vtkRUCThreePointProbability.h"

#include <algorithm>
#include <limits>

using ThreePoint = vtkRUCThreePointProbability;

namespace
{
// How often Three-Point Probability says that it knows no zeta
std::size_t WordsOnZeta(int throws, int directions)
{
  vtkNew<ThreePoint> filter;
  filter->SetInputData(MakePolyData(FewSizes(), Edge, true, IsMine));
  filter->SetNumberOfLags(8);
  filter->SetNumberOfThrows(throws);
  filter->SetNumberOfDirections(directions);
  const Warnings warnings(filter);
  filter->Update();
  return std::count_if(warnings.Texts.begin(), warnings.Texts.end(),
    [](const std::string& text) { return text.find("zeta and eta are not known") != text.npos; });
}

void ExpectRefused(const std::vector<std::string>& parts,
  const std::function<void(ThreePoint*)>& spoil, bool periodic = true)
{
  std::vector<std::string> all = parts;
  all.push_back("Three-Point Probability");
  // Few throws and lags, so that the good pack takes no time
  RefusesSettings<ThreePoint>(all, spoil, periodic,
    [](ThreePoint* f)
    {
      f->SetNumberOfThrows(20);
      f->SetNumberOfLags(8);
      f->SetNumberOfDirections(4);
    });
}

void GiveMask(ThreePoint* f)
{
  f->SetInputDataObject(1, MakeMask(Edge, Rank(), NumberOfRanks()));
}
}

TEST(ThreePointRefusals, TriplesThatAreNone)
{
  for (const char* phases : { "", "1", "1 2", "1 2 3 m", "0 1 1", "4 m m", "1 m x", "1,1,1", ";",
         "1 1 1;; m m m", "1 1 1; 1 2", "all m", "-1 1 1", "1.5 1 1" })
  {
    SCOPED_TRACE(phases);
    ExpectRefused({ "Phases requires", "got" }, [=](ThreePoint* f) { f->SetPhases(phases); });
  }
}

TEST(ThreePointRefusals, NoThrows)
{
  ExpectRefused({ "NumberOfThrows requires a number from 1", "got 0" },
    [](ThreePoint* f) { f->SetNumberOfThrows(0); });
}

TEST(ThreePointRefusals, NumberOfDirectionsOutOfRange)
{
  for (int directions : { 1, 0, -4, 513 })
  {
    SCOPED_TRACE(directions);
    ExpectRefused(
      { "NumberOfDirections requires a number from 2 to 512", "got " + std::to_string(directions) },
      [=](ThreePoint* f) { f->SetNumberOfDirections(directions); });
  }
}

TEST(ThreePointRefusals, NumberOfLagsOutOfRange)
{
  for (int lags : { 0, -5, 2000000000 })
  {
    SCOPED_TRACE(lags);
    ExpectRefused({ "NumberOfLags requires", "got " + std::to_string(lags) },
      [=](ThreePoint* f) { f->SetNumberOfLags(lags); });
  }
  ExpectRefused({ "NumberOfLags requires a number from 1 to 20000" },
    [](ThreePoint* f) { f->SetNumberOfLags(20001); });
}

TEST(ThreePointRefusals, MaximumLagOutOfRange)
{
  ExpectRefused({ "MaximumLag requires", "got -1" }, [](ThreePoint* f) { f->SetMaximumLag(-1.0); });
  ExpectRefused(
    { "MaximumLag requires 0 < MaximumLag <= 5.3", "got 5.5" },
    [](ThreePoint* f) { f->SetMaximumLag(5.5); }, false);
  ExpectRefused({ "MaximumLag requires 0 < MaximumLag <= 48", "got 48.5" },
    [](ThreePoint* f) { f->SetMaximumLag(48.5); });
}

TEST(ThreePointRefusals, Seed)
{
  ExpectRefused({ "Seed requires", "got -1" }, [](ThreePoint* f) { f->SetSeed(-1); });
}

TEST(ThreePointRefusals, MarginOutOfRange)
{
  ExpectRefused(
    { "WindowMargin requires", "got -2" }, [](ThreePoint* f) { f->SetWindowMargin(-2.0); }, false);
}

TEST(ThreePointRefusals, TooLittleMemory)
{
  for (double limit : { 0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), 0.01 })
  {
    SCOPED_TRACE(limit);
    ExpectRefused(
      { "MemoryLimit requires at least", "MB on every rank for 40 triples of phases", "100 lags" },
      [=](ThreePoint* f)
      {
        f->SetPhases("all");
        f->SetNumberOfLags(100);
        f->SetMemoryLimit(limit);
      });
  }
}

TEST(ThreePointRefusals, MaskOfAPeriodicPack)
{
  ExpectRefused({ "Mask requires a pack that is not periodic" }, GiveMask);
}

TEST(ThreePointRefusals, MaskThatMissesThePack)
{
  ExpectRefused(
    { "Mask requires at least one centre of the pack inside" },
    [](ThreePoint* f)
    {
      GiveMask(f);
      vtkImageData::SafeDownCast(f->GetInputDataObject(1, 0))->SetOrigin(100.0, 0.0, 0.0);
    },
    false);
}

// One point is in a phase or is not, so that c (1 - c) is 0
TEST(ThreePointRefusals, Multipoles)
{
  ExpectRefused({ "MultipoleClasses requires", "got 5" },
    [](ThreePoint* f)
    {
      f->SetMultipoles(true);
      f->SetMultipoleClasses(5);
    });
  ExpectRefused({ "MultipoleDistances requires distances > 0 that ascend", "got 0 after 0.5" },
    [](ThreePoint* f)
    {
      f->SetMultipoles(true);
      f->SetMultipoleDistance(0, 0.5);
      f->SetMultipoleDistance(2, 0.7);
    });
  ExpectRefused(
    { "Multipoles requires a pack without a mask" },
    [](ThreePoint* f)
    {
      f->SetMultipoles(true);
      GiveMask(f);
    },
    false);
}

TEST(ThreePointRefusals, ParametersThatAreNotKnownAreTold)
{
  EXPECT_EQ(WordsOnZeta(1, 8), Rank() == 0 ? 1u : 0u);
  EXPECT_EQ(WordsOnZeta(100, 5), Rank() == 0 ? 1u : 0u);
  EXPECT_EQ(WordsOnZeta(100, 8), 0u);
}
