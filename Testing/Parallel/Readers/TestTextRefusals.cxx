// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Texts that the Sphere Pack Reader refuses, and the filter behind it
#include "Refusals.h"

#include "vtkRUCParticleModes.h"
#include "vtkRUCSpherePackReader.h"

#include <cstdio>
#include <fstream>

namespace
{
void RefusesText(const std::string& text, const std::vector<std::string>& parts,
  const std::function<void(vtkRUCSpherePackReader*)>& configure = {})
{
  const std::string fileName = "bad_input_np" + std::to_string(NumberOfRanks()) + ".csv";
  if (Rank() == 0)
  {
    std::ofstream(fileName, std::ios::binary) << text;
  }
  vtkNew<vtkRUCSpherePackReader> reader;
  const Errors errors(reader);
  reader->SetFileName(fileName.c_str());
  if (configure)
  {
    configure(reader);
  }
  // What reads nothing on the other ranks is the rank 0 of a serial reader; then the chain behind
  // it on all ranks
  vtkNew<vtkPolyData> nothing;
  vtkNew<vtkRUCParticleModes> modes;
  const Errors following(modes);
  if (Rank() == 0)
  {
    reader->Update();
    modes->SetInputData(reader->GetOutput());
  }
  else
  {
    modes->SetInputData(nothing);
  }
  modes->Update();
  if (Rank() == 0)
  {
    std::vector<std::string> all = parts;
    all.push_back("Sphere Pack Reader");
    all.push_back(fileName);
    ExpectRefusal(reader, errors, all);
    std::remove(fileName.c_str());
  }
  ExpectRefusal(modes, following, { "Particle Modes", "at least one sphere" });
}
}

TEST(TextRefusals, MissingColumn)
{
  RefusesText("x,y,radius\n1,2,3\n", { "Line 1", "'z' is required" });
}

TEST(TextRefusals, MissingRadius)
{
  RefusesText("x,y,z,size\n1,2,3,4\n", { "Line 1", "'radius' or 'diameter' is required" });
}

TEST(TextRefusals, TextInANumber)
{
  RefusesText("x,y,z,radius\n1,2,3,4\n1,2,3x,4\n", { "Line 3", "'z'", "'3x'" });
}

TEST(TextRefusals, ShortRow)
{
  RefusesText("x,y,z,radius\n1,2,3,4\n\n1,2,3\n", { "Line 4", "4 fields are required", "got 3" });
}

TEST(TextRefusals, NoSpheres)
{
  RefusesText("", { "At least one line with a sphere" });
  RefusesText("x,y,z,radius\n", { "At least one line with a sphere" });
}

TEST(TextRefusals, RadiusOutOfRange)
{
  RefusesText("x,y,z,radius\n1,2,3,-4\n", { "Line 2", "'radius'", "> 0", "'-4'" });
  RefusesText("1 2 3 nan\n", { "Line 1", "finite", "'nan'" });
}

TEST(TextRefusals, LongLine)
{
  RefusesText("x,y,z,radius\n1,2,3,4\n" + std::string(10 * 1024 * 1024, '1') + "\n",
    { "Line 3", "65536", "10485760" });
}

TEST(TextRefusals, NotUtf8)
{
  RefusesText("x,y,z,radius\n1,2,3,4\n1,2,\xb5,4\n", { "Line 3", "UTF-8", "181" });
}

TEST(TextRefusals, PeriodicBoxTooSmall)
{
  RefusesText("x,y,z,radius\n1,2,3,0.5\n", { "BoxSize", "Line 2" },
    [](vtkRUCSpherePackReader* r) { r->SetBoxSize(2.0, 2.0, 2.0); });
}
