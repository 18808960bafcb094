// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Tables as people have them: two spheres, (1, 2, 3) of radius 0.5 and (-4, 5.5, 60) of radius
// 0.25, in many ways of writing them; and what is refused, for its own reason.
#include "FormatFiles.h"
#include "ruc/Formats/TableColumns.h"

namespace
{
using formats::OpenText;
using ruc::PackFrame;
using ruc::ReadSettings;

PackFrame Parse(std::string_view text, const ReadSettings& settings = {})
{
  return OpenText(text, settings).Frame();
}

void ExpectTheTwo(std::string_view text, const ReadSettings& settings = {})
{
  SCOPED_TRACE(std::string(text));
  PackFrame frame;
  ASSERT_NO_THROW(frame = Parse(text, settings));
  EXPECT_EQ(frame.Format, "table");
  EXPECT_EQ(frame.X, (std::vector<double>{ 1, -4 }));
  EXPECT_EQ(frame.Y, (std::vector<double>{ 2, 5.5 }));
  EXPECT_EQ(frame.Z, (std::vector<double>{ 3, 60 }));
  EXPECT_EQ(frame.Radius, (std::vector<double>{ 0.5, 0.25 }));
}

ReadSettings Columns(const char* columns)
{
  ReadSettings settings;
  settings.Columns = columns;
  return settings;
}

ReadSettings RadiusColumn(const char* column, bool diameter = false)
{
  ReadSettings settings;
  settings.RadiusColumn = column;
  settings.RadiusIsDiameter = diameter;
  return settings;
}
}

TEST(Tables, Separators)
{
  for (const char* text : { "1,2,3,0.5\n-4,5.5,60,0.25\n", "1;2;3;0.5\n-4;5.5;60;0.25\n",
         "1\t2\t3\t0.5\n-4\t5.5\t60\t0.25\n", "  1   2 3  0.5  \n -4  5.5    60 0.25",
         "1, 2, 3, 0.5\n-4 ,5.5 , 60,\t0.25\n", "1\t2 3 0.5\n-4\t5.5 60 0.25\n",
         "x y z radius\n1\t2\t3\t0.5\n-4\t5.5\t60\t0.25\n",
         "sep=;\nx;y;z;r\n1;2;3;0.5\n-4;5.5;60;0.25\n", "1,2,3,0.5,\n-4,5.5,60,0.25,\n",
         "x,y,z,r,\n1,2,3,0.5,\n-4,5.5,60,0.25,\n",
         "x,y,z,radius\n1,2,3,0.5\n,,,\n-4,5.5,60,0.25\n,,,\n" })
  {
    ExpectTheTwo(text);
  }
}

TEST(Tables, EndsOfLinesMarksAndComments)
{
  for (const char* text :
    { "1,2,3,0.5\r\n-4,5.5,60,0.25\r\n", "x,y,z,r\r1,2,3,0.5\r-4,5.5,60,0.25\r",
      "\xEF\xBB\xBFx,y,z,radius\r\n1,2,3,0.5\r\n-4,5.5,60,0.25\r\n",
      "# a comment; with, separators\n\n  \n1,2,3,0.5\n  # another\n\n-4,5.5,60,0.25\n\n",
      "x,y,z,radius\n1,2,3,0.5 # the first\n-4,5.5,60,0.25\n",
      "// made today\n1 2 3 0.5\n-4 5.5 60 0.25\n" })
  {
    ExpectTheTwo(text);
  }
}

TEST(Tables, NumbersAndQuotes)
{
  for (const char* text : { "+1,2e0,3.,.5\n-4.0,55e-1,6E1,+0.25",
         "x y z radius\n1.0D+00 2.0d0 3.0D+00 5.0D-01\n-4D0 0.55D1 6D1 25D-2\n",
         "1.0D+00 2.0d0 3.0D+00 5.0D-01\n-4D0 0.55D1 6D1 25D-2\n",
         "\"x\",\"y\",\"z\",\"radius\",\"name\"\n1,2,3,0.5,\"bead, red\"\n-4,5.5,60,0.25,\"b\"\n",
         "\"x\";\"y\";\"z\";\"r\"\n\"1\";\"2\";\"3\";\"0.5\"\n-4;5.5;60;0.25\n" })
  {
    ExpectTheTwo(text);
  }
  EXPECT_EQ(Parse("4.9e-324 0 0 1\n").X[0], 4.9e-324); // a subnormal number
}

TEST(Tables, Names)
{
  for (const char* text :
    { "radius,z,y,x\n0.5,3,2,1\n0.25,60,5.5,-4\n", "X Y Z R\n1 2 3 0.5\n-4 5.5 60 0.25\n",
      "Points:0,Points:1,Points:2,Rad\n1,2,3,0.5\n-4,5.5,60,0.25\n",
      "e;Points_0;Points_1;Points_2;RADII\n9;1;2;3;0.5\n8;-4;5.5;60;0.25\n",
      "pos_x,pos_y,pos_z,radius\n1,2,3,0.5\n-4,5.5,60,0.25\n",
      "CenterX,CenterY,CenterZ,Radius\n1,2,3,0.5\n-4,5.5,60,0.25\n",
      "Position X,Position Y,Position Z,Radius\n1,2,3,0.5\n-4,5.5,60,0.25\n",
      "x,y,z,Diameter\n1,2,3,1\n-4,5.5,60,0.5\n", "x,y,z,d\n1,2,3,1\n-4,5.5,60,0.5\n",
      "x,y,z,diam,r\n1,2,3,1,0.5\n-4,5.5,60,0.5,0.25\n",
      "r,x,y,z,Radius\n7,1,2,3,0.5\n8,-4,5.5,60,0.25\n", "# x y z r\n1 2 3 0.5\n-4 5.5 60 0.25\n",
      "# id,x,y,z,r\n7,1,2,3,0.5\n8,-4,5.5,60,0.25\n", "% x y z d\n1 2 3 1\n-4 5.5 60 0.5\n",
      "# made by John Smith\n1 2 3 0.5\n-4 5.5 60 0.25\n", // four words, but no names
      "# x y z r\n# of a pack\n1 2 3 0.5\n-4 5.5 60 0.25\n",
      ",x,y,z,radius\n0,1,2,3,0.5\n1,-4,5.5,60,0.25\n",
      "\tx\ty\tz\tradius\n0\t1\t2\t3\t0.5\n1\t-4\t5.5\t60\t0.25\n",
      "\"x\" \"y\" \"z\" \"radius\"\n\"1\" 1 2 3 0.5\n\"2\" -4 5.5 60 0.25\n",
      "x,y,z,radius,comment\n1,2,3,0.5,\n-4,5.5,60,0.25,ok\n",
      "x\ty\tz\tradius\tcomment\n1\t2\t3\t0.5\t\n-4\t5.5\t60\t0.25\tok\n" })
  {
    ExpectTheTwo(text);
  }
}

TEST(Tables, Units)
{
  for (const char* text : { "x [mm],y [mm],z [mm],radius [mm]\n1,2,3,0.5\n-4,5.5,60,0.25\n",
         "x (mm);y (mm);z (mm);r (mm)\n1;2;3;0.5\n-4;5.5;60;0.25\n",
         "x,y,z,radius\nmm,mm,mm,mm\n1,2,3,0.5\n-4,5.5,60,0.25\n",
         "x [mm],y,z,radius\n1,2,3,0.5\n-4,5.5,60,0.25\n" })
  {
    ExpectTheTwo(text);
    EXPECT_EQ(Parse(text).LengthUnit, "mm") << text;
  }
  for (const char* micro : { "um", "µm", "μm" })
  {
    const std::string unit(micro);
    EXPECT_EQ(Parse("x [" + unit + "],y [µm],z [um],r [µm]\n1,2,3,4\n").LengthUnit, "µm");
  }
  EXPECT_SAYS(Parse("X [mm],Y [mm],Z [mm],Diameter [um]\n1,2,3,4\n"),
    "Line 1: X is in mm, Diameter in um: one unit is required.");
}

TEST(Tables, IdsTypesAndModes)
{
  const PackFrame frame =
    Parse("Mode,ID,x,y,z,r,matId\n2,9007199254740992,1,2,3,0.5,1\n1,-7,-4,5.5,60,0.25,3\n");
  EXPECT_EQ(frame.Mode, (std::vector<int>{ 2, 1 }));
  EXPECT_EQ(frame.Id, (std::vector<std::int64_t>{ 9007199254740992, -7 }));
  EXPECT_EQ(frame.Type, (std::vector<int>{ 1, 3 }));
  const PackFrame names =
    Parse("id,x,y,z,radius,mode,type\nb1,1,2,3,0.5,glass,steel\nb2,-4,5.5,60,0.25,1,glass\n");
  EXPECT_TRUE(names.Id.empty());
  EXPECT_TRUE(names.Mode.empty());
  EXPECT_EQ(names.Warnings,
    (std::vector<std::string>{
      "column 6 ('mode') is left out: whole numbers are required, got 'glass' in line 2.",
      "column 1 ('id') is left out: whole numbers are required, got 'b1' in line 2." }));
  EXPECT_EQ(names.Type, (std::vector<int>{ 2, 1 }));
  EXPECT_EQ(names.TypeNames, (std::vector<std::string>{ "glass", "steel" }));
}

TEST(Tables, ColumnsThatNobodyNeedsBlockNothing)
{
  for (const std::string field : { "1.5", "3000000000", "bead", "", "nan" })
  {
    const PackFrame frame =
      Parse("x,y,z,r,mode,id\n1,2,3,1,1,7\n4,5,6,1," + field + ",8\n7,8,9,1,2,9\n");
    EXPECT_EQ(frame.Size(), 3u);
    EXPECT_TRUE(frame.Mode.empty());
    EXPECT_EQ(frame.Id, (std::vector<std::int64_t>{ 7, 8, 9 }));
    EXPECT_EQ(frame.Warnings.size(), 1u);
  }
  for (const std::string field : { "1e17", "a", "6ba7b810-9dad-11d1-80b4-00c04fd430c8" })
  {
    const PackFrame frame = Parse("x,y,z,r,id,mode\n1,2,3,1," + field + ",4\n");
    EXPECT_TRUE(frame.Id.empty());
    EXPECT_EQ(frame.Mode, std::vector<int>{ 4 });
  }
}

TEST(Tables, Settings)
{
  ExpectTheTwo("7 1 2 3 0.5\n8 -4 5.5 60 0.25\n", Columns("id,x,y,z,r"));
  ExpectTheTwo("7 1 2 3 0.5 a\n8 -4 5.5 60 0.25 b\n", Columns("-,x,y,z,r,-"));
  ExpectTheTwo("a b c e\n1 2 3 1\n-4 5.5 60 0.5\n", Columns("x,y,z,d"));
  ExpectTheTwo("x,y,z,r,SIZE\n1,2,3,77,0.5\n-4,5.5,60,77,0.25\n", RadiusColumn("Size"));
  ExpectTheTwo("x,y,z,r,s\n1,2,3,77,0.5\n-4,5.5,60,77,0.25\n", RadiusColumn("5"));
  ExpectTheTwo("x,y,z,Diameter\n1,2,3,1\n-4,5.5,60,0.5\n", RadiusColumn("Diameter"));
  ExpectTheTwo("x,y,z,Diameter\n1,2,3,1\n-4,5.5,60,0.5\n", RadiusColumn("4", true)); // halved once
  ExpectTheTwo("1,2,3,1\n-4,5.5,60,0.5\n", RadiusColumn("", true));
  ReadSettings skip;
  skip.SkipLines = 2;
  ExpectTheTwo("a\xFF\nanything at all\n1,2,3,0.5\n-4,5.5,60,0.25\n", skip);
  EXPECT_SAYS(Parse("1 2 3 4\n", Columns("x,y,z")),
    "Columns requires a name for each of 4 columns, got 3: x,y,z.");
  EXPECT_SAYS(Parse("1 2 3 4\n", Columns("x,y,r,-")), "a column 'z' is required");
  EXPECT_SAYS(Parse("1 2 3 4\n", RadiusColumn("5")), "RadiusColumn requires a column from 1 to 4");
  EXPECT_SAYS(Parse("x y z r\n1 2 3 4\n", RadiusColumn("s")),
    "RadiusColumn requires a column 's', got the columns 'x', 'y', 'z', 'r'");
  EXPECT_SAYS(Parse("1 2 3 4\n", RadiusColumn("0")), "RadiusColumn requires a column from 1 to 4");
  EXPECT_SAYS(Parse("1 2 3 4\n", RadiusColumn("s")), "got a table without names");
  skip.SkipLines = -3;
  EXPECT_SAYS(Parse("1,2,3,0.5\n", skip), "SkipLines requires a number >= 0, got -3");
}

TEST(Tables, ColumnsThatAreNotGuessed)
{
  EXPECT_SAYS(Parse("1 2 3 4 5\n"), "Line 1: 5 columns without names: set Columns");
  EXPECT_SAYS(Parse("x,y,radius\n1,2,3\n"),
    "a column 'z' is required, got the columns 'x', 'y', 'radius': set Columns");
  for (const char* numbered :
    { "1 1.5 2.5 3.5\n2 4.5 5.5 6.5\n3 8 8 8\n", "3 1.5 2.5 3.5\n1 4.5 5.5 6.5\n2 8 8 8\n",
      "0 1.5 2.5 1\n1 4.5 5.5 1\n2 8 8 1\n", "17 1.5 2.5 3.5\n21 4.5 5.5 6.5\n40 8 8 8\n" })
  {
    EXPECT_SAYS(Parse(numbered), "The first column counts the rows: set Columns");
  }
  EXPECT_EQ(Parse("1 1.5 2.5 3.5\n2 4.5 5.5 6.5\n3 8 8 8\n", Columns("id,x,y,z")).Id.size(), 3u);
  for (const char* lattice :
    { "2 2 2 0.5\n4 2 2 0.5\n6 2 2 0.5\n", "4 .5 .5 .5\n2 .5 .5 .5\n6 .5 .5 .5\n" })
  {
    EXPECT_EQ(Parse(lattice).Size(), 3u) << lattice;
  }
  const PackFrame bare = Parse("1.5 2.5 3.5\n4.5 5.5 6.5\n");
  EXPECT_EQ(bare.Size(), 2u);
  EXPECT_TRUE(bare.Radius.empty());
}

TEST(Tables, TwoColumnsForOneRole)
{
  for (const char* twice : { "x,y,z,r,X\n1,2,3,0.5,9\n", "# x y z radius x\n1 2 3 0.5 9\n" })
  {
    EXPECT_SAYS(Parse(twice), "one column 'x' is required, got columns 1 and 5: set Columns");
  }
  EXPECT_SAYS(Parse("1 2 3 4\n", Columns("x,y,z,z")), "one column 'z' is required, got columns 3");
  const PackFrame frame = Parse("r,x,y,z,Radius\n7,1,2,3,0.5\n8,-4,5.5,60,0.25\n");
  EXPECT_EQ(frame.Warnings,
    std::vector<std::string>{
      "Column 5, 'radius', is taken and column 1, 'r', is not: RadiusColumn chooses." });
  EXPECT_TRUE(Parse("r,x,y,z,Radius\n7,1,2,3,0.5\n", RadiusColumn("r")).Warnings.empty());
  EXPECT_TRUE(Parse("r,x,y,z,r\n7,1,2,3,0.5\n", RadiusColumn("5")).Warnings.empty());
  EXPECT_EQ(Parse("x,pos_x,y,z\n1,7,2,3\n").Warnings,
    std::vector<std::string>{
      "Column 1, 'x', is taken and column 2, 'pos_x', is not: Columns chooses." });
}

TEST(Tables, WhatIsTakenOfNamesForOneRole)
{
  using Role = ruc::RowColumns;
  const std::vector<std::string> names = { "r", "X [mm]", "pos_x", "Points:0", "y", "Radius", "" };
  EXPECT_EQ(ruc::TellTaken(names, Role::X, "This"),
    "'X [mm]' is taken and 'pos_x', 'Points:0' are not: This chooses.");
  EXPECT_EQ(
    ruc::TellTaken(names, Role::Radius, "That"), "'Radius' is taken and 'r' is not: That chooses.");
  EXPECT_EQ(
    ruc::TellTaken({ "Y", "y" }, Role::Y, "This"), "'Y' is taken and 'y' is not: This chooses.");
  EXPECT_EQ(ruc::TellTaken(names, Role::Y, "This"), "");
  EXPECT_EQ(ruc::TellTaken(names, Role::Z, "This"), "");
}

TEST(Tables, BadRows)
{
  EXPECT_SAYS(Parse("1,2,3,1\n1,2,abc,1\n"), "Line 2: column 3 requires a number, got 'abc'");
  EXPECT_SAYS(
    Parse("x,y,z,r\n\n1,2,3,1\n1,2,3,1x\n"), "Line 4: column 4 ('r') requires a number, got '1x'");
  EXPECT_SAYS(Parse("1,2,3,1\n1,2,,1\n"), "Line 2: column 3 requires a number, got ''");
  EXPECT_SAYS(Parse("1,2,3,1\n1,2,3\n"), "Line 2: 4 fields are required, got 3");
  EXPECT_SAYS(Parse("1,2,3,1\n1,2,3,1,5\n"), "Line 2: 4 fields are required, got 5");
  EXPECT_SAYS(Parse("1,2,3,1\n1,nan,3,1\n"), "column 2 requires a finite number, got 'nan'");
  EXPECT_SAYS(
    Parse("1,2,3,1\n1,1e999,3,1\n"), "column 2 requires a number from 4.9e-324 to 1.8e308");
  EXPECT_SAYS(Parse("x,y,z,r\n1e-330,2,3,1\n"), "requires a number from 4.9e-324 to 1.8e308");
  EXPECT_SAYS(
    Parse("1,2,3,1\n1,2,3,-0.5\n"), "Line 2: column 4 requires a number >= 0, got '-0.5'");
  EXPECT_SAYS(Parse("1 2 3 1\n1,2,3,1\n"), "Line 2: 4 fields are required");
  EXPECT_SAYS(Parse("1,2,3,1\n1,0x10,3,1\n"), "Line 2: column 2 requires a number, got '0x10'");
  EXPECT_SAYS(Parse("1,2,3,1\n1,2,3,1e999\n"), "Line 2: column 4");
  for (const char* bad : { "nan", "inf", "-inf", "NaN", "Infinity" })
  {
    EXPECT_SAYS(Parse(std::string("1,2,3,1\n1,2,3,") + bad + "\n"),
      "Line 2: column 4 requires a finite number");
  }
  EXPECT_SAYS(Parse("1,2,3,1\n" + std::string(60, 'q') + ",2,3,1\n"),
    "'" + std::string(40, 'q') + "…'"); // a long field is cut
  EXPECT_SAYS(Parse("x,y,z,r,d\n1,2,3,1,1\n"), "radius and diameter are required to agree");
  for (const char* comma :
    { "x;y;z;r\n1,5;2,5;3,5;0,5\n", "1,5;2,5;3,5;0,5\n", "x y z r\n1,5 2 3 1\n" })
  {
    EXPECT_SAYS(Parse(comma), "requires a decimal point, got '1,5'");
  }
  EXPECT_SAYS(Parse("x,y,z,r\n\"1,234.5\",2,3,1\n"),
    "requires a number without marks between thousands, got '1,234.5'");
  EXPECT_SAYS(
    Parse("1,2,3,1\n" + std::string(70000, '1')), "Line 2: a line of at most 65536 bytes");
}

TEST(Tables, NotText)
{
  EXPECT_SAYS(
    Parse(std::string("\xFF\xFEx\0,\0y\0\n\0", 10)), "got UTF-16: save the table as UTF-8");
  EXPECT_SAYS(Parse("x [\xB5m],y,z,r\n1,2,3,4\n"),
    "Line 1: UTF-8 text is required, got the byte 181 at place 4, as in Latin-1");
  EXPECT_SAYS(Parse("1,2,3,1\n1,2,3,\xC0\x80\n"), "Line 2: UTF-8");
  EXPECT_SAYS(Parse(std::string("\x7F"
                                "ELF\0\0\0\0",
                8)),
    "got bytes that are no text and have the sign of none");
  EXPECT_SAYS(Parse(std::string("1,2,3,1\n1,2\0,3,1\n", 17)),
    "Line 2: UTF-8 text is required, got the byte 0 at place 4");
  EXPECT_SAYS(Parse("1,2,3,1\n1,2,3,\xE2\x82\n"), "Line 2: UTF-8"); // ends within a character
  EXPECT_SAYS(Parse("# \xFE\n1,2,3,1\n"), "Line 1: UTF-8");         // in a comment as well
  EXPECT_SAYS(Parse("some words, and more\n"), "Line 1: a column 'x' is required, got the columns");
}

TEST(Tables, NoSpheres)
{
  for (const char* empty :
    { "", "\n", "\n\n# only a comment\n", "x,y,z,radius\n", "\xEF\xBB\xBF", "   " })
  {
    EXPECT_SAYS(Parse(empty), "At least one line with a sphere is required");
  }
  ReadSettings skip;
  skip.SkipLines = 10;
  EXPECT_SAYS(Parse("1,2,3,1\n", skip), "At least one line with a sphere is required");
}

TEST(Tables, RadiiOfZeroArePoints)
{
  EXPECT_EQ(Parse("1,2,3,0\n4,5,6,0.5\n").Radius, (std::vector<double>{ 0, 0.5 }));
}

TEST(Tables, SkippedLinesLeaveATable)
{
  ReadSettings skip = Columns("id,type,x,y,z,r");
  skip.SkipLines = 9;
  ExpectTheTwo("ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp pp\n0 9\n0 9\n"
               "0 9\nITEM: ATOMS id type x y z radius\n1 1 1 2 3 0.5\n2 1 -4 5.5 60 0.25\n",
    skip);
}
