// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Packs that are written and read again have the same bits
#include "FormatFiles.h"

#include "ruc/Base/ParseDouble.h"

#include <clocale>

namespace
{
using ruc::FramePack;
using ruc::Window;

// Spheres in a box, with numbers that take all digits and some that are at the ends of their range
FramePack RandomPack(std::size_t count, const Window& box)
{
  oracle::Uniform random(11);
  FramePack pack;
  for (std::size_t n = 0; n < count; ++n)
  {
    pack.Pack.X.push_back(box.Origin[0] + box.Size[0] * random(0, 1));
    pack.Pack.Y.push_back(box.Origin[1] + box.Size[1] * random(0, 1));
    pack.Pack.Z.push_back(box.Origin[2] + box.Size[2] * random(0, 1));
    pack.Pack.Radius.push_back(std::pow(10.0, random(-8, -2)));
    pack.Pack.Id.push_back(static_cast<std::int64_t>(3 * n + 7));
    pack.Type.push_back(1 + static_cast<int>(n % 5));
  }
  pack.Pack.Id.back() = std::int64_t(1) << 52;
  pack.Pack.X[0] = box.Origin[0];
  pack.Box = box;
  return pack;
}

Window Cube(bool periodic)
{
  return Window::MakeBox(
    { 0, 0, 0 }, { 1.0 / 3.0, 0.7, 12345.678901234567 }, { periodic, periodic, periodic });
}

formats::Opened Reopen(const ruc::WrittenPack& written)
{
  ruc::ReadSettings settings;
  settings.Beside = [info = written.Info](const std::string& name)
  { return name == ".nfo" ? info : std::string(); };
  return formats::OpenText(written.Bytes, settings);
}

ruc::WrittenPack Write(const char* extension, const FramePack& pack, double density = 1.0)
{
  ruc::WriteSettings settings;
  settings.Density = density;
  return ruc::WritePack(ruc::FormatOfExtension(extension), pack, settings);
}

void ExpectSameSpheres(const ruc::SpherePack& got, const ruc::SpherePack& expected)
{
  EXPECT_EQ(got.X, expected.X);
  EXPECT_EQ(got.Y, expected.Y);
  EXPECT_EQ(got.Z, expected.Z);
  EXPECT_EQ(got.Radius, expected.Radius);
}

const char* const Extensions[] = { "dump", "data", "extxyz", "csv", "xyzd", "yade" };
}

TEST(WrittenPacks, AreReadAgainWithTheSameBits)
{
  const FramePack pack = RandomPack(500, Cube(true));
  const char* const formats[] = { "LAMMPS dump", "LAMMPS data", "extended XYZ", "table",
    "Baranau xyzd", "YADE text" };
  for (std::size_t n = 0; n < std::size(Extensions); ++n)
  {
    SCOPED_TRACE(Extensions[n]);
    const std::string extension = Extensions[n];
    const FramePack again = Reopen(Write(Extensions[n], pack)).Pack();
    EXPECT_EQ(again.Format, formats[n]);
    ExpectSameSpheres(again.Pack, pack.Pack);
    if (extension != "xyzd")
    {
      EXPECT_EQ(again.Pack.Id, pack.Pack.Id);
      EXPECT_EQ(again.Type, pack.Type);
    }
    EXPECT_EQ(again.Box.has_value(), extension != "csv" && extension != "yade");
    if (again.Box && extension != "data") // which does not tell what is periodic
    {
      EXPECT_TRUE(again.BoxIsWindow);
      EXPECT_EQ(*again.Box, *pack.Box);
    }
    else if (again.Box)
    {
      EXPECT_EQ(again.Box->Size, pack.Box->Size);
    }
  }
}

TEST(WrittenPacks, ABoxThatBeginsElsewhereIsKept)
{
  const Window box = Window::MakeBox({ -0.5, 2, 0.25 }, { 1, 4, 8 }, { true, false, true });
  const FramePack pack = RandomPack(50, box);
  for (const char* extension : { "dump", "extxyz" })
  {
    const FramePack again = Reopen(Write(extension, pack)).Pack();
    ExpectSameSpheres(again.Pack, pack.Pack);
    EXPECT_EQ(*again.Box, box);
    EXPECT_FALSE(again.BoxIsWindow);
  }
  const Window cylinder = Window::MakeCylinder({ 0, 0, 0 }, { 0, 0, 1 }, 10, 20);
  FramePack inCylinder = RandomPack(50, box);
  inCylinder.Box = cylinder;
  EXPECT_EQ(*Reopen(Write("dump", inCylinder)).Pack().Box, cylinder.GetBounds());
}

TEST(WrittenPacks, WithoutABoxItIsThatOfTheSpheres)
{
  FramePack pack = RandomPack(50, Cube(true));
  pack.Box.reset();
  pack.Pack.X[7] = 2.0;
  pack.Pack.Radius[7] = 0.5;
  const Window box = *Reopen(Write("dump", pack)).Pack().Box;
  EXPECT_EQ(box.Origin[0] + box.Size[0], 2.5);
  EXPECT_FALSE(box.IsPeriodic());
  EXPECT_FALSE(Reopen(Write("extxyz", pack)).Pack().Box);
  EXPECT_SAYS(Write("xyzd", pack), "periodic along all axes is required, got none");
  pack.Box = Cube(false);
  EXPECT_SAYS(Write("xyzd", pack), "periodic along all axes is required, got a box window");
}

TEST(WrittenPacks, NumbersAndTypesForLammpsBeginWithOne)
{
  FramePack pack = RandomPack(4, Cube(true));
  pack.Pack.Id = { -1, 0, 5, 7 };
  pack.Type = { 0, 3, 0, 1 };
  for (const char* extension : { "dump", "data" })
  {
    const FramePack again = Reopen(Write(extension, pack)).Pack();
    EXPECT_EQ(again.Pack.Id, (std::vector<std::int64_t>{ 1, 2, 7, 9 }));
    EXPECT_EQ(again.Type, (std::vector<int>{ 1, 4, 1, 2 }));
  }
  EXPECT_NE(Write("data", pack).Bytes.find("\n4 atom types\n"), std::string::npos);
  pack.Type.clear();
  EXPECT_EQ(Reopen(Write("dump", pack)).Pack().Type, std::vector<int>(4, 1));
}

TEST(WrittenPacks, FramesFollowOneAnother)
{
  FramePack first = RandomPack(20, Cube(true)), second = RandomPack(30, Cube(true));
  for (double time : { 4.0, 0.1 })
  {
    first.Time = 0.0625;
    second.Time = time + 0.0625 * (time < 1.0);
    for (const char* extension : { "dump", "extxyz" })
    {
      EXPECT_TRUE(ruc::FormatOfExtension(extension).Writer.HoldsFrames);
      ruc::WrittenPack both = Write(extension, first);
      both.Bytes += Write(extension, second).Bytes;
      formats::Opened file = Reopen(both);
      ExpectSameSpheres(file.Pack(0).Pack, first.Pack);
      ExpectSameSpheres(file.Pack(1).Pack, second.Pack);
      EXPECT_EQ(file.Pack(1).Time, second.Time) << extension;
    }
  }
}

TEST(WrittenPacks, FramesOfTimesThatAreNoStepsAreCounted)
{
  FramePack pack = RandomPack(3, Cube(true));
  pack.Time = 0.5;
  ruc::WriteSettings settings;
  settings.Frame = 7;
  const std::string text = ruc::WritePack(ruc::FormatOfExtension("dump"), pack, settings).Bytes;
  EXPECT_EQ(text.rfind("ITEM: TIME\n0.5\nITEM: TIMESTEP\n7\n", 0), 0u) << text;
}

TEST(WrittenPacks, WhatFormatsTellBesides)
{
  FramePack pack = RandomPack(3, Cube(true));
  pack.LengthUnit = "µm";
  EXPECT_NE(Write("data", pack, 2650).Bytes.find("\n7 1 "), std::string::npos);
  EXPECT_NE(Write("data", pack, 2650).Bytes.find(" 2650 "), std::string::npos);
  EXPECT_EQ(Reopen(Write("data", pack)).Pack().LengthUnit, "µm");
  for (const char* extension : Extensions) // what is said to be held is read again
  {
    const ruc::WrittenPack written = Write(extension, pack);
    EXPECT_EQ(Reopen(written).Pack().LengthUnit, written.HoldLengthUnit ? "µm" : "") << extension;
  }
  pack.LengthUnit = "Å"; // of two styles
  EXPECT_EQ(Reopen(Write("data", pack)).Pack().LengthUnit, "");
  pack.Pack.Mode = { 3, 1, 2 };
  EXPECT_EQ(Reopen(Write("spheres", pack)).Pack().Pack.Mode, pack.Pack.Mode);
}

TEST(WrittenPacks, Refusals)
{
  const FramePack pack = RandomPack(3, Cube(true));
  EXPECT_EQ(&ruc::FormatOfExtension("DUMP"), &ruc::FormatOfExtension("lammpstrj"));
  EXPECT_SAYS(ruc::FormatOfExtension("gsd"), "dump");
  EXPECT_SAYS(ruc::FormatOfExtension(""), "is required, got ''");
  for (const char* extension : Extensions)
  {
    EXPECT_SAYS(Write(extension, FramePack()), ruc::NoSpheres);
    EXPECT_SAYS(Write(extension, pack, 0.0), "Density requires a finite number > 0, got 0");
  }
}

TEST(WrittenPacks, NumbersAreReadWithTheSameBits)
{
  oracle::Uniform random(3);
  for (int n = 0; n < 20000; ++n)
  {
    const double value = n == 0 ? 0.1
      : n == 1                  ? 4.9e-324
                                : std::ldexp(random(-1, 1), n % 2000 - 1000);
    std::string text, byStream;
    ruc::AppendNumber(text, value);
    ruc::AppendNumberByStream(byStream, value);
    double read = 0.0;
    ASSERT_TRUE(ruc::ParseDouble(text, read)) << text;
    ASSERT_EQ(read, value) << text;
    ASSERT_EQ(text, byStream);
  }
}

TEST(WrittenPacks, NumbersHavePointsInEveryCountry)
{
  const std::string before = std::setlocale(LC_NUMERIC, nullptr);
  const bool comma = std::setlocale(LC_NUMERIC, "de_DE.UTF-8") != nullptr;
  std::string text;
  ruc::AppendNumber(text, 0.5);
  std::setlocale(LC_NUMERIC, before.c_str());
  EXPECT_EQ(text, "0.5") << (comma ? "with commas" : "");
}
