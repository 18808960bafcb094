// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Texts that the Sphere Pack Reader refuses, and the filter behind it
#include "Refusals.h"

#include "vtkRUCParticleModes.h"
#include "vtkRUCSpherePackReader.h"

#include <sys/stat.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
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
  reader->SetController(nullptr); // rank 0 alone
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
  // The cause was told once
  EXPECT_TRUE(IsEmpty(modes));
  EXPECT_TRUE(following.Texts.empty());
  ExpectParts(RefusalOf(modes->GetOutputDataObject(1)), { "Sphere Pack Reader", fileName });
}
}

TEST(TextRefusals, MissingColumn)
{
  RefusesText("x,y,radius\n1,2,3\n", { "Line 1", "'z' is required" });
}

TEST(TextRefusals, MissingRadius)
{
  RefusesText("x,y,z,size\n1,2,3,4\n", { "requires radii: a column 'radius' or 'diameter'" });
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
  RefusesText("x,y,z,radius\n1,2,3,-4\n", { "Line 2", "'radius'", ">= 0", "'-4'" });
  RefusesText("1 2 3 nan\n", { "Line 1", "finite", "'nan'" });
}

TEST(TextRefusals, LongLine)
{
  RefusesText(
    "x,y,z,radius\n1,2,3,4\n" + std::string(10 * 1024 * 1024, '1') + "\n", { "Line 3", "65536" });
}

TEST(TextRefusals, NotUtf8)
{
  RefusesText("x,y,z,radius\n1,2,3,4\n1,2,\xb5,4\n", { "Line 3", "UTF-8", "181" });
}

TEST(TextRefusals, PeriodicBoxTooSmall)
{
  RefusesText("x,y,z,radius\n1,2,3,0.5\n", { "BoxSize", "sphere 0 at (1, 2, 3)" },
    [](vtkRUCSpherePackReader* r) { r->SetBoxSize(2.0, 2.0, 2.0); });
}

// Names that lead to no file of a size that can be read, on rank 0 alone
namespace
{
void RefusesFile(const std::string& name, const std::string& part)
{
  vtkNew<vtkRUCSpherePackReader> reader;
  const Errors errors(reader);
  reader->SetController(nullptr); // rank 0 alone
  reader->SetFileName(name.c_str());
  if (Rank() == 0)
  {
    reader->Update();
    ExpectRefusal(reader, errors, { "Sphere Pack Reader", name, part });
  }
}

std::string FileName(const char* what)
{
  return what + std::to_string(NumberOfRanks());
}
}

TEST(FileRefusals, Folder)
{
  RefusesFile("/", "a regular file is required, got a folder");
  EXPECT_FALSE(vtkRUCSpherePackReader::CanReadFile("/"));
}

TEST(FileRefusals, NoFile)
{
  RefusesFile("no such file.csv", "can be opened is required, got: No such file");
}

TEST(FileRefusals, Device)
{
  RefusesFile("/dev/zero", "a regular file is required, got a device");
}

TEST(FileRefusals, Pipe)
{
  const std::string name = FileName("pipe_np");
  if (Rank() == 0)
  {
    ASSERT_EQ(mkfifo(name.c_str(), 0600), 0);
    EXPECT_FALSE(vtkRUCSpherePackReader::CanReadFile(name.c_str()));
  }
  RefusesFile(name, "a regular file is required, got a pipe");
  std::remove(Rank() == 0 ? name.c_str() : "");
}

TEST(FileRefusals, LargerThanMemory)
{
  const std::string name = FileName("huge_np");
  if (Rank() == 0)
  {
    std::ofstream(name).put('x');
    std::filesystem::resize_file(name, std::uintmax_t(1) << 42); // it takes no blocks on the disk
  }
  RefusesFile(name, "got bytes that are no text and have the sign of none");
  std::remove(Rank() == 0 ? name.c_str() : "");
}

TEST(FileRefusals, ReadError)
{
  // The file is regular, but no byte of it can be read: it is the memory at address 0 of this
  // process
  RefusesFile("/proc/self/mem", "can be read to its end is required, got: Input/output error");
}
