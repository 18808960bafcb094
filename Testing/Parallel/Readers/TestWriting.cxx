// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Packs are written from any number of ranks, and read back by Sphere Pack Reader with the same
// bits
#include "Refusals.h"

#include "vtkRUCSpherePackReader.h"
#include "vtkRUCSpherePackWriter.h"

#include "vtkMultiBlockDataSet.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

namespace
{
const std::string Name = "Sphere Pack Writer";

// A file of this test alone
std::string FileOf(const std::string& what)
{
  return "written_np" + std::to_string(NumberOfRanks()) + what;
}

void AddIds(vtkPolyData* data, const std::function<vtkIdType(vtkIdType)>& idOf)
{
  vtkNew<vtkIntArray> id;
  id->SetName("Id");
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    id->InsertNextValue(static_cast<int>(idOf(i)));
  }
  data->GetPointData()->AddArray(id);
}

// The pack, dealt out in turn, with ids from 1
vtkSmartPointer<vtkPolyData> Pack()
{
  const auto data = MakePolyData(FewSizes(), Edge, true, IsMine);
  AddIds(data, [](vtkIdType i) { return 1 + i * NumberOfRanks() + Rank(); });
  return data;
}

struct Writing
{
  explicit Writing(vtkDataObject* input, const std::string& fileName)
  {
    this->Writer->SetInputDataObject(0, input);
    this->Writer->SetFileName(fileName.c_str());
  }
  bool Write() { return this->Writer->Write() == 1; }

  vtkNew<vtkRUCSpherePackWriter> Writer;
  Errors Error{ this->Writer };
};

void Write(vtkDataObject* input, const std::string& fileName)
{
  Writing writing(input, fileName);
  EXPECT_TRUE(writing.Write());
  EXPECT_TRUE(writing.Error.Texts.empty()) << writing.Error.Texts.front();
}

std::string BytesOf(const std::string& name)
{
  std::ifstream file(name, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), {} };
}

void Remove(const std::string& name)
{
  if (Rank() == 0)
  {
    std::remove(name.c_str());
  }
}

// One error, on rank 0; no file is left, but for what was there
void RefusesToWrite(vtkDataObject* input, const std::string& fileName,
  const std::vector<std::string>& parts,
  const std::function<void(vtkRUCSpherePackWriter*)>& set = {})
{
  Writing writing(input, fileName);
  if (set)
  {
    set(writing.Writer);
  }
  EXPECT_FALSE(writing.Write());
  ASSERT_EQ(writing.Error.Texts.size(), Rank() == 0 ? 1u : 0u);
  for (const std::string& text : writing.Error.Texts)
  {
    ExpectParts(text, parts);
    ExpectParts(text, { Name });
    EXPECT_EQ(text.find("(0x"), std::string::npos) << text;
  }
}

void ExpectPack(vtkPolyData* read, bool withIds)
{
  const ruc::SpherePack& pack = FewSizes();
  ASSERT_EQ(read->GetNumberOfPoints(), static_cast<vtkIdType>(pack.Size()));
  for (vtkIdType i = 0; i < read->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(read->GetPoint(i)[0], pack.X[i]);
    EXPECT_EQ(read->GetPoint(i)[1], pack.Y[i]);
    EXPECT_EQ(read->GetPoint(i)[2], pack.Z[i]);
    EXPECT_EQ(read->GetPointData()->GetArray("Radius")->GetTuple1(i), pack.Radius[i]);
    if (withIds)
    {
      EXPECT_EQ(read->GetPointData()->GetArray("Id")->GetTuple1(i), 1.0 + i);
      EXPECT_EQ(read->GetPointData()->GetArray("Type")->GetTuple1(i), pack.Mode[i]);
    }
  }
}
}

TEST(Writing, IsReadBackWithTheSameBits)
{
  for (const std::string extension : { "dump", "data", "extxyz", "csv", "xyzd", "yade" })
  {
    SCOPED_TRACE(extension);
    const std::string name = FileOf("." + extension);
    Write(Pack(), name);
    if (Rank() == 0)
    {
      vtkNew<vtkRUCSpherePackReader> reader;
      const Errors errors(reader);
      const Warnings warnings(reader);
      reader->SetController(nullptr);
      reader->SetFindWindow(false); // what a file does not tell is not looked for
      reader->SetFileName(name.c_str());
      reader->Update();
      EXPECT_TRUE(errors.Texts.empty() && warnings.Texts.empty());
      ExpectPack(reader->GetOutput(), extension != "xyzd");
      if (extension == "dump" || extension == "extxyz" || extension == "xyzd")
      {
        EXPECT_EQ(reader->GetOutput()->GetFieldData()->GetArray("BoxSize")->GetTuple1(2), Edge);
        EXPECT_EQ(reader->GetOutput()->GetFieldData()->GetArray("BoxPeriodic")->GetTuple1(2), 1.0);
      }
    }
    Remove(name);
  }
  Remove(FileOf(".nfo"));
}

TEST(Writing, IsTheSameHoweverThePackIsSpread)
{
  const std::string name = FileOf(".dump");
  std::vector<std::string> files;
  const std::vector<std::function<bool(std::size_t)>> spreads = { IsMine,
    [](std::size_t) { return Rank() == NumberOfRanks() - 1; },
    [](std::size_t i) { return int(i / 7) % NumberOfRanks() == Rank(); } };
  for (const auto& isMine : spreads)
  {
    const auto data = MakePolyData(FewSizes(), Edge, true, isMine); // without ids
    Write(data, name);
    files.push_back(Rank() == 0 ? BytesOf(name) : "");
  }
  EXPECT_EQ(files[0].empty(), Rank() > 0);
  EXPECT_EQ(files[1], files[0]);
  EXPECT_EQ(files[2], files[0]);
  // Ids that repeat are no names: the spheres are numbered in the same order
  const auto data = Pack();
  AddIds(data, [](vtkIdType) { return 3; });
  Write(data, name);
  EXPECT_EQ(Rank() == 0 ? BytesOf(name) : "", files[0]);
  Remove(name);
}

TEST(Writing, LeavesGhostsOut)
{
  const auto data = Pack();
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName("vtkGhostType");
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    ghosts->InsertNextValue(i == 0 ? 1 : 0);
  }
  data->GetPointData()->AddArray(ghosts);
  const std::string name = FileOf("_ghosts.extxyz");
  Write(data, name);
  if (Rank() == 0)
  {
    EXPECT_EQ(std::stoi(BytesOf(name)), 600 - NumberOfRanks());
  }
  Remove(name);
}

// The box is then that of the spheres, as without a window
TEST(Writing, AWindowThatWasFoundIsNoBox)
{
  const auto bare = MakePolyData(FewSizes(), Edge, false, IsMine);
  AddIds(bare, [](vtkIdType i) { return 1 + i * NumberOfRanks() + Rank(); });
  const auto found = MakePolyData(FewSizes(), 0.5 * Edge, false, IsMine);
  AddIds(found, [](vtkIdType i) { return 1 + i * NumberOfRanks() + Rank(); });
  vtkNew<vtkStringArray> source;
  source->SetName("WindowSource");
  source->InsertNextValue("Cut faces");
  found->GetFieldData()->AddArray(source);
  bare->GetFieldData()->Initialize();
  const std::string with = FileOf("_found.dump"), without = FileOf("_none.dump");
  Write(found, with);
  Write(bare, without);
  if (Rank() == 0)
  {
    EXPECT_TRUE(BytesOf(with) == BytesOf(without));
  }
  Remove(with);
  Remove(without);
}

TEST(Writing, CellsAreFrames)
{
  vtkNew<vtkMultiBlockDataSet> cells;
  cells->SetNumberOfBlocks(3); // as Unit Cell Reconstruction hands them out, on rank 0
  for (unsigned int n = 0; Rank() == 0 && n < 3; ++n)
  {
    const double edge = Edge + n;
    const auto cell = MakePolyData(FewSizes(), edge, true, [](std::size_t) { return true; });
    AddIds(cell, [](vtkIdType i) { return i; });
    vtkNew<vtkIntArray> number;
    number->SetName("Cell");
    number->InsertNextValue(static_cast<int>(n) + 1);
    cell->GetFieldData()->AddArray(number);
    cells->SetBlock(n, cell);
  }
  for (const std::string extension : { "dump", "extxyz" })
  {
    const std::string name = FileOf("_cells." + extension);
    Write(cells, name);
    if (Rank() == 0)
    {
      vtkNew<vtkRUCSpherePackReader> reader;
      const Errors errors(reader);
      reader->SetController(nullptr);
      reader->SetFileName(name.c_str());
      for (int n = 0; n < 3; ++n)
      {
        reader->UpdateTimeStep(n);
        ExpectPack(reader->GetOutput(), false);
        EXPECT_EQ(reader->GetOutput()->GetFieldData()->GetArray("BoxSize")->GetTuple1(0), Edge + n);
      }
      EXPECT_TRUE(errors.Texts.empty());
    }
    Remove(name);
  }
  RefusesToWrite(cells, FileOf("_cells.data"), { "LAMMPS data holds one pack, got 3" });
}

TEST(WritingRefusals, Input)
{
  const std::string name = FileOf("_bad.dump");
  const auto noRadius = Pack();
  noRadius->GetPointData()->RemoveArray("Radius");
  RefusesToWrite(noRadius, name, { "'Radius' is required", "Points To Sphere Pack makes it" });
  // Only the last rank has it
  for (double bad : { std::numeric_limits<double>::quiet_NaN(), 0.0, -1.0 })
  {
    const auto data = Pack();
    if (Rank() == NumberOfRanks() - 1)
    {
      data->GetPointData()->GetArray("Radius")->SetTuple1(2, bad);
    }
    RefusesToWrite(data, name, { "'Radius' requires finite values > 0, got " });
  }
  const auto shorter = Pack();
  vtkNew<vtkDoubleArray> radius;
  radius->SetName("Radius");
  radius->InsertNextValue(1.0);
  shorter->GetPointData()->AddArray(radius);
  RefusesToWrite(shorter, name, { "'Radius' requires a value for each of", "got 1" });
  vtkNew<vtkPolyData> nothing;
  RefusesToWrite(nothing, name, { "requires at least one sphere" });
  const auto halves = Pack();
  vtkNew<vtkDoubleArray> types;
  types->SetName("Mode");
  for (vtkIdType i = 0; i < halves->GetNumberOfPoints(); ++i)
  {
    types->InsertNextValue(1.5);
  }
  halves->GetPointData()->AddArray(types);
  RefusesToWrite(halves, name, { "'Mode' requires whole numbers, got 1.5" });
  const auto refused = Pack();
  refused->Initialize();
  vtkNew<vtkStringArray> why;
  why->SetName("Refusal");
  why->InsertNextValue("Some Filter: no");
  refused->GetFieldData()->AddArray(why);
  RefusesToWrite(refused, name, { "nothing is written", "Some Filter: no" });
  EXPECT_FALSE(std::filesystem::exists(name));
}

TEST(WritingRefusals, Settings)
{
  RefusesToWrite(Pack(), FileOf(".gsd"), { "one of the extensions dump", "got 'gsd'" });
  RefusesToWrite(Pack(), "a.b/written", { "is required, got ''" });
  RefusesToWrite(Pack(), FileOf(".data"), { "Density requires a finite number > 0, got -1" },
    [](vtkRUCSpherePackWriter* writer) { writer->SetDensity(-1.0); });
  const auto open = Pack();
  open->GetFieldData()->Initialize();
  RefusesToWrite(open, FileOf(".xyzd"), { "periodic along all axes is required, got none" });
}

TEST(WritingRefusals, PlacesThatCannotBeWritten)
{
  RefusesToWrite(Pack(), "no such folder/a.dump",
    { "FileName requires a file that can be written", "No such file or directory" });
  const std::string folder = FileOf("_folder.dump");
  if (Rank() == 0)
  {
    std::filesystem::create_directory(folder);
  }
  RefusesToWrite(Pack(), folder, { "a regular file or a free name is required, got a folder" });
  const std::string pipe = FileOf("_pipe.dump");
  if (Rank() == 0)
  {
    mkfifo(pipe.c_str(), 0600);
  }
  RefusesToWrite(Pack(), pipe, { "a regular file or a free name is required, got a device" });
  if (Rank() == 0)
  {
    std::filesystem::remove(folder);
    std::filesystem::remove(pipe);
  }
}

// A full disk, and a link in the way, leave the old file as it is
TEST(WritingRefusals, AnOldFileRemains)
{
  const std::string name = FileOf("_old.dump"), other = FileOf("_other");
  const std::string fresh = name + ".new-" + std::to_string(getpid()) + "-0";
  if (Rank() == 0)
  {
    std::ofstream(name) << "old";
    std::ofstream(other) << "of somebody else";
  }
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, SIG_IGN);
  if (Rank() == 0)
  {
    const rlimit small{ 10000, before.rlim_max };
    setrlimit(RLIMIT_FSIZE, &small);
  }
  RefusesToWrite(
    Pack(), name, { "FileName requires a file that can be written", "File too large" });
  setrlimit(RLIMIT_FSIZE, &before);
  if (Rank() == 0)
  {
    EXPECT_EQ(BytesOf(name), "old");
    EXPECT_FALSE(std::filesystem::exists(fresh));
    std::filesystem::create_symlink(other, fresh);
  }
  Write(Pack(), name);
  if (Rank() == 0)
  {
    EXPECT_EQ(BytesOf(other), "of somebody else");
    EXPECT_EQ(BytesOf(name).substr(0, 5), "ITEM:");
    std::filesystem::remove(fresh);
    std::filesystem::remove(other);
  }
  Remove(name);
}
