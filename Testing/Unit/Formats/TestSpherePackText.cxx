// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Formats/SpherePackText.h"

#include "Oracles.h"

namespace
{
using ruc::SpherePackText;
using ruc::SpherePackTextSettings;

SpherePackText Parse(std::string_view text, const SpherePackTextSettings& settings = {})
{
  return ruc::ParseSpherePack(text, settings);
}

// Two spheres, (1, 2, 3) radius 0.5 and (-4, 5.5, 60) radius 0.25
void ExpectTheTwo(std::string_view text, const SpherePackTextSettings& settings = {})
{
  SCOPED_TRACE(std::string(text));
  SpherePackText table;
  ASSERT_NO_THROW(table = Parse(text, settings));
  EXPECT_EQ(table.Pack.X, (std::vector<double>{ 1, -4 }));
  EXPECT_EQ(table.Pack.Y, (std::vector<double>{ 2, 5.5 }));
  EXPECT_EQ(table.Pack.Z, (std::vector<double>{ 3, 60 }));
  EXPECT_EQ(table.Pack.Radius, (std::vector<double>{ 0.5, 0.25 }));
  EXPECT_EQ(table.Line.size(), 2u);
}
}

TEST(SpherePackText, Separators)
{
  ExpectTheTwo("1,2,3,0.5\n-4,5.5,60,0.25\n");
  ExpectTheTwo("1;2;3;0.5\n-4;5.5;60;0.25\n");
  ExpectTheTwo("1\t2\t3\t0.5\n-4\t5.5\t60\t0.25\n");
  ExpectTheTwo("1 2 3 0.5\n-4 5.5 60 0.25\n");
  ExpectTheTwo("   1   2 3  0.5  \n -4  5.5    60 0.25");
  ExpectTheTwo("1, 2, 3, 0.5\n-4 ,5.5 , 60,\t0.25\n");
  ExpectTheTwo("1,2,3,0.5,\n-4,5.5,60,0.25,\n");      // a separator at the end of the line
  ExpectTheTwo("+1,2e0,3.,.5\n-4.0,55e-1,6E1,+0.25"); // forms of numbers, no newline at the end
}

TEST(SpherePackText, LineEndsMarksCommentsAndQuotes)
{
  ExpectTheTwo("1,2,3,0.5\r\n-4,5.5,60,0.25\r\n");
  ExpectTheTwo("\xEF\xBB\xBF"
               "1,2,3,0.5\n-4,5.5,60,0.25\n");
  ExpectTheTwo("\xEF\xBB\xBFx,y,z,radius\r\n1,2,3,0.5\r\n-4,5.5,60,0.25\r\n");
  ExpectTheTwo("# a comment; with, separators\n\n  \n1,2,3,0.5\n  # another\n\n-4,5.5,60,0.25\n\n");
  ExpectTheTwo("\"x\",\"y\",\"z\",\"radius\"\n\"1\",\"2\",\"3\",\"0.5\"\n-4,5.5,60,0.25\n");
  ExpectTheTwo("x,y,z,radius,Gr\xC3\xB6\xC3\x9F"
               "e\n1,2,3,0.5,1\n-4,5.5,60,0.25,1\n"); // UTF-8 is welcome
}

TEST(SpherePackText, ColumnsByName)
{
  ExpectTheTwo("radius,z,y,x\n0.5,3,2,1\n0.25,60,5.5,-4\n");
  ExpectTheTwo("X Y Z R\n1 2 3 0.5\n-4 5.5 60 0.25\n");
  ExpectTheTwo("Points:0,Points:1,Points:2,Rad\n1,2,3,0.5\n-4,5.5,60,0.25\n");
  ExpectTheTwo("extra;Points_0;Points_1;Points_2;RADIUS\n9;1;2;3;0.5\n8;-4;5.5;60;0.25\n");
  ExpectTheTwo("x,y,z,Diameter\n1,2,3,1\n-4,5.5,60,0.5\n");
  ExpectTheTwo("x,y,z,d\n1,2,3,1\n-4,5.5,60,0.5\n");
  ExpectTheTwo("x,y,z,diam\n1,2,3,1\n-4,5.5,60,0.5\n");
  ExpectTheTwo("x,y,z,diameter,radius\n1,2,3,77,0.5\n-4,5.5,60,77,0.25\n"); // the radius goes first
  ExpectTheTwo("1 2 3 0.5 77\n-4 5.5 60 0.25 77\n"); // further columns without a header
}

TEST(SpherePackText, ModeAndIdAreReadWhereTheyAre)
{
  const SpherePackText table =
    Parse("Mode,ID,x,y,z,r\n2,9007199254740992,1,2,3,0.5\n1,-7,-4,5.5,60,0.25\n");
  EXPECT_EQ(table.Pack.Mode, (std::vector<int>{ 2, 1 }));
  EXPECT_EQ(table.Pack.Id, (std::vector<std::int64_t>{ 9007199254740992, -7 }));
  EXPECT_TRUE(Parse("1,2,3,0.5\n").Pack.Mode.empty());
  EXPECT_TRUE(Parse("1,2,3,0.5\n").Pack.Id.empty());
}

TEST(SpherePackText, ColumnsThatNobodyNeedsBlockNothing)
{
  for (const std::string field : { "1.5", "3000000000", "bead", "", "nan" })
  {
    const SpherePackText table =
      Parse("x,y,z,r,mode,id\n1,2,3,1,1,7\n4,5,6,1," + field + ",8\n7,8,9,1,2,9\n");
    EXPECT_EQ(table.Pack.Size(), 3u);
    EXPECT_TRUE(table.Pack.Mode.empty());
    EXPECT_EQ(table.Pack.Id, (std::vector<std::int64_t>{ 7, 8, 9 }));
    ASSERT_EQ(table.LeftOut.size(), 1u);
    EXPECT_EQ(table.LeftOut[0],
      "column 5 ('mode') is left out: whole numbers are required, got '" + field + "' in line 3.");
  }
  for (const std::string field : { "1e17", "a", "6ba7b810-9dad-11d1-80b4-00c04fd430c8" })
  {
    const SpherePackText table = Parse("x,y,z,r,id,mode\n1,2,3,1," + field + ",4\n");
    EXPECT_TRUE(table.Pack.Id.empty());
    EXPECT_EQ(table.Pack.Mode, std::vector<int>{ 4 });
    EXPECT_EQ(table.LeftOut.size(), 1u);
  }
  EXPECT_TRUE(Parse("x,y,z,r,id,mode\n1,2,3,1,5,4\n").LeftOut.empty());
}

TEST(SpherePackText, RadiiOfZeroArePoints)
{
  EXPECT_EQ(Parse("1,2,3,0\n4,5,6,0.5\n").Pack.Radius, (std::vector<double>{ 0, 0.5 }));
  SpherePackTextSettings settings;
  settings.Scale = 1e-200;
  EXPECT_SAYS(
    Parse("1,2,3,0\n4,5,6,1e-200\n", settings), "Line 2: coordinates of at most 1e+50 and");
}

TEST(SpherePackText, Settings)
{
  SpherePackTextSettings byNumber;
  byNumber.RadiusColumn = "5";
  ExpectTheTwo("1,2,3,77,0.5\n-4,5.5,60,77,0.25\n", byNumber);
  ExpectTheTwo("x,y,z,r,size\n1,2,3,77,0.5\n-4,5.5,60,77,0.25\n", byNumber);
  SpherePackTextSettings byName;
  byName.RadiusColumn = "Size";
  ExpectTheTwo("x,y,z,r,SIZE\n1,2,3,77,0.5\n-4,5.5,60,77,0.25\n", byName);
  SpherePackTextSettings diameter;
  diameter.RadiusIsDiameter = true;
  ExpectTheTwo("1,2,3,1\n-4,5.5,60,0.5\n", diameter);
  ExpectTheTwo("x,y,z,radius\n1,2,3,1\n-4,5.5,60,0.5\n", diameter);
  ExpectTheTwo("x,y,z,diameter\n1,2,3,1\n-4,5.5,60,0.5\n", diameter); // halved once
  SpherePackTextSettings scale;
  scale.Scale = 0.5;
  ExpectTheTwo("2,4,6,1\n-8,11,120,0.5\n", scale);
  SpherePackTextSettings skip;
  skip.SkipLines = 2;
  ExpectTheTwo("ITEM: \xFF\nanything at all\n1,2,3,0.5\n-4,5.5,60,0.25\n", skip);
  EXPECT_EQ(Parse("a\nb\n1,2,3,0.5\n", skip).Line, (std::vector<std::size_t>{ 3 }));
  skip.SkipLines = -3;
  ExpectTheTwo("1,2,3,0.5\n-4,5.5,60,0.25\n", skip);
}

TEST(SpherePackText, BadSettings)
{
  SpherePackTextSettings settings;
  for (double bad : { 0.0, -1.0, std::nan(""), HUGE_VAL })
  {
    settings.Scale = bad;
    EXPECT_SAYS(Parse("1,2,3,1\n", settings), "Scale requires a finite number > 0");
  }
  settings.Scale = 1.0;
  settings.RadiusColumn = "5";
  EXPECT_SAYS(Parse("1,2,3,1\n", settings), "RadiusColumn requires a column from 1 to 4, got 5.");
  settings.RadiusColumn = "0";
  EXPECT_SAYS(Parse("1,2,3,1\n", settings), "RadiusColumn requires a column from 1 to 4, got 0.");
  settings.RadiusColumn = "size";
  EXPECT_SAYS(Parse("1,2,3,1\n", settings), "a text without header");
  EXPECT_SAYS(Parse("x,y,z,r\n1,2,3,1\n", settings),
    "RadiusColumn requires a column 'size', got the columns 'x', 'y', 'z', 'r'");
}

TEST(SpherePackText, MissingColumns)
{
  EXPECT_SAYS(Parse("x,y,radius\n1,2,3\n"),
    "Line 1: a column 'z' is required, got the columns 'x', 'y', 'radius'");
  EXPECT_SAYS(Parse("\n# c\na,y,z,radius\n1,2,3,4\n"), "Line 3: a column 'x' is required");
  EXPECT_SAYS(
    Parse("x,y,z,size\n1,2,3,4\n"), "Line 1: a column 'radius' or 'diameter' is required");
  EXPECT_SAYS(Parse("1,2,3\n"), "Line 1: the columns x, y, z and radius are required, got 3");
  EXPECT_SAYS(Parse("1\n"), "Line 1: the columns x, y, z and radius are required, got 1");
}

TEST(SpherePackText, BadRows)
{
  EXPECT_SAYS(Parse("1,2,3,1\n1,2,abc,1\n"), "Line 2: column 3 requires a number, got 'abc'");
  EXPECT_SAYS(
    Parse("x,y,z,r\n\n1,2,3,1\n1,2,3,1x\n"), "Line 4: column 4 ('r') requires a number, got '1x'");
  EXPECT_SAYS(Parse("1,2,3,1\n1,2,,1\n"), "Line 2: column 3 requires a number, got ''");
  EXPECT_SAYS(
    Parse("1,2,3,1\n1,2,3\n"), "Line 2: 4 fields are required as in the first line, got 3");
  EXPECT_SAYS(
    Parse("1,2,3,1\r\n1,2,3,1,5\r\n"), "Line 2: 4 fields are required as in the first line, got 5");
  EXPECT_SAYS(Parse("1 2 3 1\n1,2,3,1\n"), "Line 2: 4 fields are required");
  EXPECT_SAYS(Parse("1,2,3,1\n1,0x10,3,1\n"), "Line 2: column 2 requires a number, got '0x10'");
  for (const char* bad : { "nan", "inf", "-inf", "NaN", "Infinity" })
  {
    EXPECT_SAYS(Parse(std::string("1,2,3,1\n1,") + bad + ",3,1\n"),
      "Line 2: column 2 requires a finite number");
    EXPECT_SAYS(Parse(std::string("1,2,3,1\n1,2,3,") + bad + "\n"),
      "Line 2: column 4 requires a finite number");
  }
  EXPECT_SAYS(Parse("1,2,3,1\n1,2,3,1e999\n"), "Line 2: column 4");
  EXPECT_SAYS(
    Parse("x,y,z,r\n1,2,3,-0.5\n"), "Line 2: column 4 ('r') requires a number >= 0, got '-0.5'");
  EXPECT_SAYS(Parse("1,2,3,1\n" + std::string(60, 'q') + ",2,3,1\n"),
    "'" + std::string(40, 'q') + "…'"); // a long field is cut
}

TEST(SpherePackText, NoSpheres)
{
  for (const char* empty :
    { "", "\n", "\n\n# only a comment\n", "x,y,z,radius\n", "\xEF\xBB\xBF", "   " })
  {
    EXPECT_SAYS(Parse(empty), "At least one line with a sphere is required");
  }
  SpherePackTextSettings skip;
  skip.SkipLines = 10;
  EXPECT_SAYS(Parse("1,2,3,1\n", skip), "At least one line with a sphere is required");
}

TEST(SpherePackText, NotText)
{
  EXPECT_SAYS(Parse("1,2,3,1\n" + std::string(10000000, '1')),
    "Line 2: a line of at most 65536 bytes is required, got 10000000");
  EXPECT_SAYS(
    Parse("1,2,3,1\n1,2,3,\xFF\n"), "Line 2: UTF-8 text is required, got the byte 255 at place 7");
  EXPECT_SAYS(Parse("1,2,3,1\n\xC3,2,3,1\n"),
    "Line 2: UTF-8 text is required, got the byte 195 at place 1"); // cut short
  EXPECT_SAYS(Parse("1,2,3,1\n1,2,3,\xE2\x82\n"), "Line 2: UTF-8"); // ends within a character
  EXPECT_SAYS(Parse("1,2,3,1\n\xC0\x80,2,3,1\n"), "Line 2: UTF-8"); // an overlong NUL
  EXPECT_SAYS(Parse(std::string("1,2,3,1\n1,2\0,3,1\n", 17)),
    "Line 2: UTF-8 text is required, got the byte 0 at place 4");
  EXPECT_SAYS(Parse("# \xFE\n1,2,3,1\n"), "Line 1: UTF-8"); // in a comment as well
}

TEST(SpherePackText, AppendTakesTheLineAlong)
{
  const SpherePackText table = Parse("x,y,z,r,id\n1,2,3,1,5\n4,5,6,2,6\n");
  SpherePackText other;
  other.Append(table, 1);
  EXPECT_EQ(other.Line, (std::vector<std::size_t>{ 3 }));
  EXPECT_EQ(other.Pack.Centre(0), (ruc::Vector3{ 4, 5, 6 }));
  EXPECT_EQ(other.Pack.Id, (std::vector<std::int64_t>{ 6 }));
}
