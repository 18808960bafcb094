// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// The source makes one pack on any number of ranks, and says on each what is wrong
#include "Equality.h"
#include "Refusals.h"

#include "vtkRUCSpherePackSource.h"

#include "vtkFieldData.h"
#include "vtkTable.h"

#include <limits>

using Source = vtkRUCSpherePackSource;

namespace
{
using Configure = std::function<void(Source*)>;

void ExpectSamePack(const Configure& configure)
{
  vtkNew<Source> together, alone;
  alone->SetController(nullptr);
  configure(together);
  configure(alone);
  together->Update();
  alone->Update();
  auto* pack = vtkPolyData::SafeDownCast(together->GetOutputDataObject(0));
  auto* expected = vtkPolyData::SafeDownCast(alone->GetOutputDataObject(0));
  ASSERT_GT(expected->GetNumberOfPoints(), 0);
  ExpectSamePieces(pack, expected);
  if (Rank() == 0)
  {
    ExpectSameOutput(pack, expected);
    ExpectSameOutput(together->GetOutputDataObject(1), alone->GetOutputDataObject(1));
  }
  else
  {
    EXPECT_EQ(pack->GetNumberOfPoints(), 0);
  }
}

void ExpectRefused(const std::string& part, const Configure& configure)
{
  vtkNew<Source> source;
  Errors errors(source);
  configure(source);
  source->Update();
  ExpectRefusal(source, errors, { part });
}
}

TEST(SpherePackSource, SoftAndEvents)
{
  ExpectSamePack([](Source* source) { source->SetNumberOfSpheres(100); });
  ExpectSamePack(
    [](Source* source)
    {
      source->SetNumberOfSpheres(150);
      source->SetFraction(0.4);
      source->SetWalls(1, 0, 0);
      source->SetEquilibrationTime(5.0);
    });
}

TEST(SpherePackSource, SizesOfEveryLaw)
{
  for (int law : { Source::CLASSES, Source::LOG_NORMAL, Source::GAUSSIAN })
  {
    ExpectSamePack(
      [&](Source* source)
      {
        source->SetNumberOfSpheres(120);
        source->SetFraction(0.62);
        source->SetSizes(law);
        source->SetDiameter(0, 2.0);
        source->SetDiameter(1, 1.0);
        source->SetShare(0, 50.0);
        source->SetShare(1, 50.0);
      });
  }
}

TEST(SpherePackSource, WhatCannotBe)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  ExpectRefused("NumberOfSpheres requires", [](Source* source) { source->SetNumberOfSpheres(1); });
  ExpectRefused("NumberOfSpheres requires", [](Source* source) { source->SetNumberOfSpheres(3); });
  for (double fraction : { 0.0, -1.0, 1.0, nan })
  {
    ExpectRefused("Fraction requires", [&](Source* source) { source->SetFraction(fraction); });
  }
  ExpectRefused("(about 0.64", [](Source* source) { source->SetFraction(0.7); });
  ExpectRefused("Seed requires", [](Source* source) { source->SetSeed(-1); });
  ExpectRefused("Sizes requires", [](Source* source) { source->SetSizes(7); });
  ExpectRefused("Protocol requires", [](Source* source) { source->SetProtocol(7); });
  ExpectRefused("Exchange requires", [](Source* source) { source->SetExchange(7); });
  ExpectRefused("Shares requires", [](Source* source) { source->SetSizes(Source::CLASSES); });
  ExpectRefused("MeanDiameter requires", [&](Source* source) { source->SetMeanDiameter(nan); });
  ExpectRefused("MemoryLimit",
    [](Source* source)
    {
      source->SetNumberOfSpheres(10000000);
      source->SetMemoryLimit(100.0);
    });
  // Too quick a growth to get so far
  ExpectRefused("below Fraction 0.65",
    [](Source* source)
    {
      source->SetFraction(0.65);
      source->SetRate(0.5);
      source->SetNumberOfSpheres(200);
    });
}
