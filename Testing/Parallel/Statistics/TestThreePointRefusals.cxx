// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Settings and masks that Three-Point Probability refuses
#include "Refusals.h"

#include "vtkRUCThreePointProbability.h"

#include <limits>

using ThreePoint = vtkRUCThreePointProbability;

namespace
{
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
