// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Values in place of others, headers, and numbers as bytes
#include "ruc/Images/RawImage.h"

#include "Oracles.h"

#include <cstdint>

namespace
{
ruc::RawImage Image(ruc::RawHeader header)
{
  ruc::RawImage image;
  image.Header = header;
  image.Grid = { { 3, 4, 5 }, { -1.0, 0.1, 2.0 }, { 1.0, 0.5, 0.25 } };
  image.Name = "Particle Id";
  image.Signed = true;
  image.BytesOfNumber = 4;
  return image;
}
}

TEST(ValueMap, TheFirstRangeCountsAndOthersStay)
{
  const ruc::ValueMap map(" 0=1; 1 - 9=0;5=7; -3--1=-2 ;0.5=2.5;; 1e2-2e2=-1e-3;");
  EXPECT_FALSE(map.IsEmpty());
  const double pairs[][2] = { { 0, 1 }, { 1, 0 }, { 5, 0 }, { 9, 0 }, { 9.1, 9.1 }, { -1, -2 },
    { -3, -2 }, { -3.5, -3.5 }, { 0.5, 2.5 }, { 150, -1e-3 }, { 99, 99 } };
  for (const auto& pair : pairs)
  {
    EXPECT_EQ(map.Map(pair[0]), pair[1]) << pair[0];
  }
  EXPECT_TRUE(ruc::ValueMap("").IsEmpty());
  EXPECT_TRUE(ruc::ValueMap(" ; ").IsEmpty());
  EXPECT_EQ(ruc::ValueMap("").Map(3.0), 3.0);
}

TEST(ValueMap, RefusesOtherTexts)
{
  for (const char* bad : { "0", "0=", "=1", "a=1", "0=b", "1-=2", "9-1=0", "0=1=2", "nan=1",
         "1=inf", "0,1=2", "1-2-3=4", "0=1 2=3" })
  {
    SCOPED_TRACE(bad);
    EXPECT_SAYS(ruc::ValueMap{ bad }, "Values requires values and others in their place");
  }
}

TEST(ValueMap, ValuesAreOfTheTypeOfTheImage)
{
  const ruc::ValueMap map("0=200");
  EXPECT_NO_THROW(map.RequireHeld<std::uint8_t>("unsigned char"));
  EXPECT_NO_THROW(map.RequireHeld<float>("float"));
  EXPECT_SAYS(map.RequireHeld<std::int8_t>("char"),
    "Values requires numbers of the type of the image, which is char, got 200.");
  EXPECT_SAYS(ruc::ValueMap("0=-1").RequireHeld<std::uint16_t>("unsigned short"), "got -1");
  EXPECT_SAYS(ruc::ValueMap("0=0.5").RequireHeld<int>("int"), "got 0.5");
  EXPECT_SAYS(ruc::ValueMap("0=1e300").RequireHeld<std::int64_t>("long long"), "got 1e+300");
}

TEST(RawImage, MetaImageTellsTheCentreOfTheFirstVoxel)
{
  ruc::RawImage image = Image(ruc::RawHeader::MetaImage);
  EXPECT_EQ(ruc::WriteHeader(image),
    "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
    "CompressedData = False\nTransformMatrix = 1 0 0 0 1 0 0 0 1\n"
    "Offset = -0.5 0.34999999999999998 2.125\nElementSpacing = 1 0.5 0.25\nDimSize = 3 4 5\n"
    "ElementType = MET_INT\nElementDataFile = LOCAL\n");
  image.BigEndian = true;
  image.DataFile = "image.raw";
  image.Integer = false;
  image.BytesOfNumber = 8;
  const std::string text = ruc::WriteHeader(image);
  EXPECT_NE(text.find("MSB = True"), std::string::npos);
  EXPECT_NE(text.find("MET_DOUBLE\nElementDataFile = image.raw\n"), std::string::npos);
}

// Line by line as the user guide of AMITEX_FFTP has them
TEST(RawImage, AmitexHasTenLines)
{
  const ruc::RawImage image = Image(ruc::RawHeader::AmitexVtk);
  EXPECT_EQ(ruc::WriteHeader(image),
    "# vtk DataFile Version 4.5\nParticle_Id\nBINARY\nDATASET STRUCTURED_POINTS\n"
    "DIMENSIONS    4   5   6\nORIGIN    -1   0.10000000000000001   2\nSPACING    1   0.5   0.25\n"
    "CELL_DATA   60\nSCALARS Particle_Id int\nLOOKUP_TABLE default\n");
  EXPECT_TRUE(image.IsBigEndian());
}

TEST(RawImage, TypesHaveTheirNames)
{
  const char* meta[] = { "MET_CHAR", "MET_SHORT", "MET_INT", "MET_LONG_LONG" };
  const char* vtk[] = { "char", "short", "int", "long" };
  for (int n = 0; n < 4; ++n)
  {
    ruc::RawImage image = Image(ruc::RawHeader::MetaImage);
    image.BytesOfNumber = std::size_t(1) << n;
    EXPECT_NE(ruc::WriteHeader(image).find(std::string("= ") + meta[n] + "\n"), std::string::npos);
    image.Signed = false;
    image.Header = ruc::RawHeader::AmitexVtk;
    EXPECT_NE(
      ruc::WriteHeader(image).find(std::string(" unsigned_") + vtk[n] + "\n"), std::string::npos);
  }
  EXPECT_EQ(ruc::WriteHeader(Image(ruc::RawHeader::None)), "");
}

TEST(RawImage, NumbersAreMappedAndTurned)
{
  const std::int16_t numbers[] = { 0, 1, 258 };
  std::string plain = "x", turned;
  ruc::AppendNumbers(numbers, 3, ruc::ValueMap("0=513"), ruc::IsBigEndianHere(), plain);
  ruc::AppendNumbers(numbers, 3, ruc::ValueMap("0=513"), !ruc::IsBigEndianHere(), turned);
  EXPECT_EQ(plain, std::string("x\x01\x02\x01\x00\x02\x01", 7));
  EXPECT_EQ(turned, std::string("\x02\x01\x00\x01\x01\x02", 6));
}
