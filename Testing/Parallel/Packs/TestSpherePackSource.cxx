// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// The source makes one pack on any number of ranks, and says on each what is wrong
#include "Equality.h"
#include "Ranks.h"
#include "Refusals.h"
#include "ruc/Base/Text.h"

#include "vtkRUCSpherePackSource.h"

#include "vtkCallbackCommand.h"
#include "vtkFieldData.h"
#include "vtkTable.h"

#include <chrono>
#include <cstdio>
#include <fstream>
#include <limits>
#include <thread>

using Source = vtkRUCSpherePackSource;

namespace
{
void Barrier()
{
  vtkMultiProcessController::GetGlobalController()->Barrier();
}

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

TEST(SpherePackSource, SizesOfAFile)
{
  const std::string name = ruc::Text("sizes-", NumberOfRanks(), ".csv");
  for (const char* text : { "diameter\n1\n1.5\n2\n1.2\n", "1;0\n1.5;40\n2;100\n" })
  {
    if (Rank() == 0)
    {
      std::ofstream(name) << text;
    }
    Barrier();
    ExpectSamePack(
      [&](Source* source)
      {
        source->SetNumberOfSpheres(120);
        source->SetFraction(0.62);
        source->SetSizes(Source::FILE_OF_SIZES);
        source->SetFileName(name);
      });
    Barrier();
  }
  if (Rank() == 0)
  {
    std::remove(name.c_str());
  }
}

TEST(SpherePackSource, FilesThatCannotBe)
{
  const auto refused = [](const std::string& name, const std::string& part)
  {
    ExpectRefused(part,
      [&](Source* source)
      {
        source->SetSizes(Source::FILE_OF_SIZES);
        source->SetFileName(name);
      });
  };
  refused("", "FileName requires a file of sizes, got none");
  refused("no-such-file.csv", "FileName 'no-such-file.csv': a file that can be opened");
  refused(".", "a regular file is required");
  const std::string name = ruc::Text("no-sizes-", NumberOfRanks(), ".csv");
  const std::pair<const char*, const char*> texts[] = { { "", "got none" },
    { "1\n-2\n", "Line 2: a length above 0" }, { "1\n1,5\n", "a decimal point" },
    { "1 0\n2 60\n3 50\n", "Line 3: a passing" } };
  for (const auto& [text, part] : texts)
  {
    Barrier();
    if (Rank() == 0)
    {
      std::ofstream(name) << text;
    }
    Barrier();
    refused(name, part);
  }
  Barrier();
  if (Rank() == 0)
  {
    std::remove(name.c_str());
  }
}

TEST(SpherePackSource, StoppedBeforeThereIsAPackItGoesOn)
{
  const std::string name = ruc::Text("pushed_", NumberOfRanks(), ".state");
  const auto make = [&](const std::string& checkpoint, int stopAt, const std::string& refusal)
  {
    vtkNew<Source> source;
    source->SetNumberOfSpheres(500);
    source->SetFraction(0.6);
    source->SetProtocol(Source::SOFT);
    source->SetCheckpointFile(checkpoint);
    // Each event takes a while, so that the next is not left out
    struct Stop
    {
      int Calls = 0, At = 0;
    } stop{ 0, stopAt };
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(&stop);
    command->SetCallback(
      [](vtkObject* caller, unsigned long, void* data, void*)
      {
        auto& of = *static_cast<Stop*>(data);
        auto* running = static_cast<vtkAlgorithm*>(caller);
        if (Rank() == 0 && of.At > 0 && running->GetProgressText())
        {
          running->SetAbortExecute(++of.Calls == of.At);
          std::this_thread::sleep_for(std::chrono::milliseconds(110));
        }
      });
    source->AddObserver(vtkCommand::ProgressEvent, command);
    const Errors errors(source);
    source->Update();
    if (refusal.empty())
    {
      EXPECT_TRUE(errors.Texts.empty());
    }
    else
    {
      ExpectRefusal(source, errors, { refusal });
    }
    return vtkSmartPointer<vtkDataObject>(source->GetOutputDataObject(0));
  };
  const vtkSmartPointer<vtkDataObject> whole = make("", 0, "");
  for (int run = 0; run < 2; ++run)
  {
    make(name, 3, "Stopped before there was a pack. The next run goes on from there.");
  }
  const vtkSmartPointer<vtkDataObject> resumed = make(name, 0, "");
  if (Rank() == 0)
  {
    EXPECT_EQ(vtkPolyData::SafeDownCast(resumed)->GetNumberOfPoints(), 500);
    ExpectSameOutput(resumed, whole);
    std::remove(name.c_str());
  }
  Barrier();
  make("", 1, "Stopped before there was a pack.");
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
