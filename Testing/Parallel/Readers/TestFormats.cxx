// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Files of other programs through the reader, on all ranks: one pack in every format equals its
// truth, frames are time steps, and what is bad is refused without taking memory
#include "Refusals.h"

#include "vtkRUCParticleModes.h"
#include "vtkRUCSpherePackReader.h"

#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <sstream>

namespace
{
using Pipeline = vtkStreamingDemandDrivenPipeline;

std::string DataFile(const std::string& name)
{
  return std::string(RUC_TEST_DATA "/formats/") + name;
}

std::string TextOf(const std::string& name)
{
  std::ifstream file(name, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), {});
}

// Makes the data of a rank as ParaView asks for them
void UpdateAt(vtkAlgorithm* algorithm, double time)
{
  algorithm->UpdateInformation();
  algorithm->UpdateTimeStep(time, Rank(), NumberOfRanks());
}

std::vector<double> TimesOf(vtkAlgorithm* algorithm)
{
  algorithm->UpdateInformation();
  vtkInformation* info = algorithm->GetOutputInformation(0);
  const double* times = info->Get(Pipeline::TIME_STEPS());
  return std::vector<double>(times, times + info->Length(Pipeline::TIME_STEPS()));
}

struct Sphere
{
  double Centre[3], Radius;
};

std::vector<Sphere> Truth()
{
  std::vector<Sphere> spheres;
  std::ifstream file(DataFile("same_pack/truth.csv"));
  std::string row;
  for (std::getline(file, row); std::getline(file, row);)
  {
    std::replace(row.begin(), row.end(), ',', ' ');
    Sphere s;
    int id = 0, type = 0;
    std::istringstream(row) >> id >> type >> s.Centre[0] >> s.Centre[1] >> s.Centre[2] >> s.Radius;
    spheres.push_back(s);
  }
  return spheres;
}

// Whether a sphere of the data, moved by `shift`, is that of the truth but for whole edges
bool IsThere(
  vtkPolyData* data, vtkIdType i, const Sphere& truth, const double* shift, double digits)
{
  const double edges[3] = { 10, 12, 14 };
  bool there =
    std::abs(data->GetPointData()->GetArray("Radius")->GetTuple1(i) - truth.Radius) <= digits;
  for (int q = 0; q < 3; ++q)
  {
    const double d = std::abs(data->GetPoint(i)[q] - shift[q] - truth.Centre[q]);
    there = there && std::min(d, std::abs(d - edges[q])) <= digits;
  }
  return there;
}

void ExpectTruth(vtkPolyData* data, const double* shift, double digits)
{
  ASSERT_EQ(data->GetNumberOfPoints(), Rank() == 0 ? 500 : 0);
  if (Rank() != 0)
  {
    return;
  }
  for (const Sphere& sphere : Truth())
  {
    bool found = false;
    for (vtkIdType i = 0; i < 500 && !found; ++i)
    {
      found = IsThere(data, i, sphere, shift, digits);
    }
    ASSERT_TRUE(found) << sphere.Centre[0] << " " << sphere.Centre[1] << " " << sphere.Centre[2];
  }
  vtkDataArray* id = data->GetPointData()->GetArray("Id");
  for (vtkIdType i = 1; i < 500; ++i)
  {
    ASSERT_LT(id->GetTuple1(i - 1), id->GetTuple1(i));
  }
}
}

TEST(Formats, OnePackInEach)
{
  const struct
  {
    const char* File;
    std::size_t Steps;
    double Digits, Shift[3];
    bool Window; // whether the box is periodic along all axes
  } files[] = {
    { "lammps_frames.dump", 3, 1e-12, {}, true },
    { "lammps_scaled.dump", 1, 1e-8, {}, true },
    { "lammps_unwrapped.dump", 1, 1e-8, {}, true },
    { "lammps_scaled_unwrapped.dump", 1, 1e-8, {}, true },
    { "lammps_custom.dump.gz", 1, 1e-12, {}, true },
    { "lammps_write.data", 0, 1e-12, {}, false },
    { "ase.extxyz", 2, 1e-8, { 1, -2, -0.5 }, true },
    { "ovito_origin.xyz", 0, 1e-12, {}, false },
    { "hoomd.gsd", 3, 2e-6, { -4, -8, -7.5 }, true },
    { "packing.xyzd", 0, 1e-12, { 1, -2, -0.5 }, true },
    { "packlsd_species.dat", 0, 1e-12, { 1, -2, -0.5 }, true },
    { "packlsd_poly.dat", 0, 1e-12, { 1, -2, -0.5 }, true },
    { "mercury.data", 2, 1e-12, {}, false },
    { "esys.geo", 0, 1e-12, {}, true },
    { "comment_header.csv", 0, 1e-12, {}, false },
    { "truth.csv", 0, 1e-12, {}, false },
    { "yade_matid.txt", 0, 1e-4, {}, false },
    { "yade_attrs.txt", 0, 1e-4, {}, false },
  };
  for (const auto& file : files)
  {
    SCOPED_TRACE(file.File);
    const std::string name = DataFile(std::string("same_pack/") + file.File);
    EXPECT_EQ(vtkRUCSpherePackReader::CanReadFile(name.c_str()), 1);
    vtkNew<vtkRUCSpherePackReader> reader;
    const Errors errors(reader);
    reader->SetFileName(name.c_str());
    EXPECT_EQ(TimesOf(reader).size(), file.Steps);
    UpdateAt(reader, 0.0);
    EXPECT_TRUE(errors.Texts.empty());
    ExpectTruth(reader->GetOutput(), file.Shift, file.Digits);
    vtkFieldData* fields = reader->GetOutput()->GetFieldData();
    EXPECT_EQ(fields->GetArray("BoxSize") != nullptr, Rank() == 0);
    vtkAbstractArray* source = fields->GetAbstractArray("WindowSource");
    EXPECT_EQ(
      source && source->GetVariantValue(0).ToString() == "File", file.Window && Rank() == 0);
  }
}

TEST(Formats, FramesAreTimeSteps)
{
  vtkNew<vtkRUCSpherePackReader> reader;
  reader->SetFileName(DataFile("same_pack/lammps_frames.dump").c_str());
  EXPECT_EQ(TimesOf(reader), (std::vector<double>{ 0, 0.001, 0.002 }));
  const struct
  {
    double Asked, Given, Shift[3];
  } steps[] = { { 0.002, 0.002, { 0.25, 0.5, 0 } }, { 0.0015, 0.001, { 0.25, 0, 0 } },
    { -1, 0, {} }, { 7, 0.002, { 0.25, 0.5, 0 } } };
  for (const auto& step : steps)
  {
    UpdateAt(reader, step.Asked);
    ExpectTruth(reader->GetOutput(), step.Shift, 1e-12);
    if (Rank() == 0)
    {
      vtkPolyData* output = reader->GetOutput();
      EXPECT_EQ(output->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), step.Given);
      EXPECT_EQ(output->GetFieldData()->GetArray("TimeValue")->GetTuple1(0), step.Given);
      EXPECT_EQ(
        output->GetFieldData()->GetAbstractArray("LengthUnit")->GetVariantValue(0).ToString(), "m");
      EXPECT_EQ(output->GetPointData()->GetArray("Type")->GetRange()[1], 3.0);
    }
  }
  if (Rank() == 0)
  {
    ExpectParts(reader->GetSummary(),
      { "LAMMPS dump, frame 3 of 3 at time 0.002: 500 spheres of diameter 0.6 to 1.2 m",
        "periodic box 10 x 12 x 14 by the file, fraction 0.0741218 of the window." });
  }
}

namespace
{
struct Counter
{
  void Count() { ++this->Number; }
  int Number = 0;
};
}

TEST(Formats, AFrameIsReadOnceWhoeverAsks)
{
  vtkNew<vtkRUCSpherePackReader> reader;
  Counter runs;
  reader->AddObserver(vtkCommand::StartEvent, &runs, &Counter::Count);
  reader->SetFileName(DataFile("same_pack/lammps_frames.dump").c_str());
  reader->UpdateInformation();
  // The filters of this plugin ask for no ghosts, ParaView for a level of them
  reader->UpdateTimeStep(0.001, Rank(), NumberOfRanks(), 0);
  reader->UpdateTimeStep(0.001, Rank(), NumberOfRanks(), 1);
  EXPECT_EQ(runs.Number, Rank() == 0 ? 1 : 0) << "rank 0 alone reads";
}

TEST(Formats, FramesWarnOnce)
{
  const std::string name = "tilted_np" + std::to_string(NumberOfRanks()) + ".dump";
  if (Rank() == 0)
  {
    std::ofstream file(name, std::ios::binary);
    for (int step = 0; step < 3; ++step)
    {
      file << "ITEM: TIMESTEP\n"
           << step
           << "\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS xy xz yz pp pp pp\n0 12 2\n0 10 0\n0 "
              "10 0\n"
              "ITEM: ATOMS id type x y z radius\n1 1 1 2 3 1\n2 1 4 5 6 1\n";
    }
  }
  vtkNew<vtkRUCSpherePackReader> reader;
  const Warnings warnings(reader);
  reader->SetFileName(name.c_str());
  for (int step = 0; step < 3; ++step)
  {
    UpdateAt(reader, step);
  }
  ASSERT_EQ(warnings.Texts.size(), Rank() == 0 ? 1u : 0u);
  if (Rank() == 0)
  {
    ExpectParts(warnings.Texts[0], { "The tilted cell is taken as the brick of its edges" });
    std::remove(name.c_str());
  }
}

TEST(Formats, PropertiesWithoutUseAreTold)
{
  const auto warned = [](const std::function<void(vtkRUCSpherePackReader*)>& set)
  {
    vtkNew<vtkRUCSpherePackReader> reader;
    reader->SetFileName(DataFile("same_pack/lammps_frames.dump").c_str());
    set(reader);
    const Warnings warnings(reader);
    UpdateAt(reader, 0.0);
    std::string all;
    for (const std::string& text : warnings.Texts)
    {
      all += text;
    }
    return all;
  };
  const std::vector<std::pair<std::string, std::function<void(vtkRUCSpherePackReader*)>>> cases = {
    { "", [](vtkRUCSpherePackReader*) {} },
    { "are for tables", [](vtkRUCSpherePackReader* r) { r->SetRadiusIsDiameter(true); } },
    { "are for tables", [](vtkRUCSpherePackReader* r) { r->SetColumns("id,x,y,z,r"); } },
    { "FaceKinds and WindowErosion are not used",
      [](vtkRUCSpherePackReader* r) { r->SetFaceKinds("all=wall"); } },
    { "no length is converted", [](vtkRUCSpherePackReader* r) { r->SetLengthUnit("mm"); } },
  };
  for (const auto& [words, set] : cases)
  {
    const std::string all = warned(set);
    EXPECT_EQ(all.empty(), words.empty() || Rank() != 0) << all;
    EXPECT_TRUE(all.empty() || all.find(words) != std::string::npos) << all;
  }
}

TEST(Formats, AFileThatGrowsIsScannedAgain)
{
  const std::string name = "growing_np" + std::to_string(NumberOfRanks()) + ".dump";
  const auto frame = [](int step)
  {
    return "ITEM: TIMESTEP\n" + std::to_string(step) +
      "\nITEM: NUMBER OF ATOMS\n2\nITEM: ATOMS id type x y z radius\n1 1 " + std::to_string(step) +
      " 2 3 0.5\n2 1 4 5 6 0.5\n";
  };
  const auto write = [&](int frames)
  {
    std::ofstream file(name, std::ios::binary);
    for (int n = 0; n < frames; ++n)
    {
      file << frame(10 * n);
    }
  };
  if (Rank() == 0)
  {
    write(2);
  }
  vtkNew<vtkRUCSpherePackReader> reader;
  reader->SetFileName(name.c_str());
  EXPECT_EQ(TimesOf(reader), (std::vector<double>{ 0, 10 }));
  if (Rank() == 0)
  {
    write(3);
  }
  reader->Modified();
  EXPECT_EQ(TimesOf(reader), (std::vector<double>{ 0, 10, 20 }));
  UpdateAt(reader, 20);
  if (Rank() == 0)
  {
    EXPECT_EQ(reader->GetOutput()->GetPoint(0)[0], 20.0);
    std::remove(name.c_str());
  }
}

TEST(Formats, WhatTheUserSays)
{
  const auto read = [](const char* file, const std::function<void(vtkRUCSpherePackReader*)>& set)
  {
    auto reader = vtkSmartPointer<vtkRUCSpherePackReader>::New();
    reader->SetFileName(DataFile(std::string("same_pack/") + file).c_str());
    set(reader);
    UpdateAt(reader, 0.0);
    return reader;
  };
  const double none[3] = {}, corner[3] = { 1, -2, -0.5 };
  auto reader = read("no_header_id_first.txt", [](auto* r) { r->SetColumns("id,x,y,z,r"); });
  ExpectTruth(reader->GetOutput(), none, 1e-12);
  reader =
    read("lammps_atom_no_radius.dump", [](auto* r) { r->SetRadiusByType("1=0.3;2=0.42;3=0.6"); });
  ExpectTruth(reader->GetOutput(), none, 1e-5);
  reader = read("mercury.data", [](auto* r) { r->SetBoxPeriodic(1, 1, 1); });
  ExpectTruth(reader->GetOutput(), none, 1e-12);
  if (Rank() == 0)
  {
    EXPECT_EQ(reader->GetOutput()->GetFieldData()->GetArray("BoxSize")->GetTuple1(0), 10.0);
  }
  reader = read("packing.xyzd", [](auto* r) { r->SetFormat("Baranau xyzd"); });
  ExpectTruth(reader->GetOutput(), corner, 1e-12);
  reader = read("lammps_scaled.dump",
    [](auto* r)
    {
      r->SetScale(1000.0);
      r->SetUniformRadius(77.0);
    });
  if (Rank() == 0)
  {
    vtkPolyData* scaled = reader->GetOutput();
    EXPECT_EQ(scaled->GetFieldData()->GetArray("BoxSize")->GetComponent(0, 0), 10000.0);
    EXPECT_EQ(scaled->GetPointData()->GetArray("Radius")->GetRange()[1], 600.0) << "the file's";
  }
}

TEST(Formats, BadFilesAreRefused)
{
  const struct
  {
    const char *File, *Why;
  } files[] = {
    { "truncated.dump", "500 rows are required, got " },
    { "1e12_atoms.dump", "1000000000000 rows are stated, the file has room for " },
    { "duplicate_id.dump", " stands in rows " },
    { "nan.dump", "requires a finite number, got 'nan'" },
    { "zero_radius.dump", "requires a number > 0, got '0'" },
    { "mixed_coordinates.dump", "positions of one kind are required" },
    { "decimal_comma.csv", "requires a decimal point, got '5,3716'" },
    { "container_sphere.xyz", "Row 21 holds all others: a container?" },
    { "bomb.dump.gz", "a line of at most 65536 bytes is required" },
    { "big_endian.xyzd", "Little-endian numbers are required" },
    { "odd_size.xyzd", "Little-endian numbers are required" },
  };
  rusage before{}, after{};
  getrusage(RUSAGE_SELF, &before);
  for (const auto& file : files)
  {
    SCOPED_TRACE(file.File);
    const std::string name = DataFile(std::string("bad/") + file.File);
    const std::string bytes = TextOf(name);
    vtkNew<vtkRUCSpherePackReader> reader;
    const Errors errors(reader);
    reader->SetFileName(name.c_str());
    vtkNew<vtkRUCParticleModes> modes;
    const Errors following(modes);
    modes->SetInputConnection(reader->GetOutputPort());
    UpdateAt(modes, 0.0);
    EXPECT_TRUE(IsEmpty(modes));
    EXPECT_TRUE(following.Texts.empty());
    ASSERT_EQ(errors.Texts.size(), Rank() == 0 ? 1u : 0u);
    if (Rank() == 0)
    {
      ExpectParts(errors.Texts[0], { "Sphere Pack Reader", file.File, file.Why });
    }
    ExpectParts(RefusalOf(modes->GetOutputDataObject(0)), { file.Why });
    EXPECT_EQ(TextOf(name), bytes);
  }
  getrusage(RUSAGE_SELF, &after);
#ifndef __SANITIZE_ADDRESS__ // which keeps what was freed
  EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 64 * 1024) << "kB";
#endif
}

TEST(Formats, FilesOfNoFormat)
{
  vtkNew<vtkRUCSpherePackReader> reader;
  const Errors errors(reader);
  reader->SetFileName(DataFile("same_pack/diameter.vtk").c_str());
  reader->SetFormat("LAMMPS");
  UpdateAt(reader, 0.0);
  EXPECT_EQ(errors.Texts.size(), Rank() == 0 ? 1u : 0u);
  if (Rank() == 0)
  {
    ExpectParts(
      errors.Texts[0], { "Format requires Automatic, HOOMD GSD, LAMMPS dump", "'LAMMPS'" });
  }
  const std::string name = "no_format_np" + std::to_string(NumberOfRanks());
  if (Rank() == 0)
  {
    for (const std::string bytes : { "", "some words, and more\n",
           "\x7f"
           "ELF",
           "\x1f\x8b" })
    {
      std::ofstream(name, std::ios::binary) << bytes;
      EXPECT_EQ(vtkRUCSpherePackReader::CanReadFile(name.c_str()), 0) << bytes;
    }
    std::remove(name.c_str());
  }
}
