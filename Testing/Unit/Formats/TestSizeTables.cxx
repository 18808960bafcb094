// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Lists of diameters and sieve curves as people write them, and what is refused
#include "ruc/Formats/SizeTable.h"

#include <gtest/gtest.h>

namespace
{
using Numbers = std::vector<double>;

ruc::SizeTable Read(std::string_view text)
{
  ruc::MemoryBytes bytes(text);
  return ruc::ReadSizeTable(bytes);
}

void ExpectRefusal(std::string_view text, const std::string& part)
{
  try
  {
    Read(text);
    ADD_FAILURE() << "nothing was refused: " << text;
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}
}

TEST(SizeTables, Diameters)
{
  for (const char* text :
    { "2\n0.5\n2", "# beads\n2\n\n5e-1\r\n+2.0\n", "diameter [mm]\n2\n.5\n2\n",
      "\xEF\xBB\xBF\"d\"\n\"2\"\n0.5\n2 # the last\n", "radius\n1\n0.25\n1\n", "2;\n0.5;\n2;\n" })
  {
    const ruc::SizeTable table = Read(text);
    EXPECT_EQ(table.Diameters, (Numbers{ 2.0, 0.5, 2.0 })) << text;
    EXPECT_TRUE(table.Passing.empty());
  }
}

TEST(SizeTables, SieveCurves)
{
  for (const char* text : { "0.5 0\n1 40\n2 40\n4 100\n", "0.5,0\n1,40\n2,40\n4,100",
         "sieve [mm];passing [%]\n0.5;0\n1;40\n2;40\n4;100\n",
         "Opening\tPassing\n0.5\t0\n1\t40\n2\t40\n4\t100\n" })
  {
    const ruc::SizeTable table = Read(text);
    EXPECT_EQ(table.Diameters, (Numbers{ 0.5, 1.0, 2.0, 4.0 })) << text;
    EXPECT_EQ(table.Passing, (Numbers{ 0.0, 40.0, 40.0, 100.0 })) << text;
  }
}

TEST(SizeTables, AnyNumberOfLines)
{
  std::string text;
  for (int n = 1; n <= 100000; ++n)
  {
    text += std::to_string(n) + "\n";
  }
  const ruc::SizeTable table = Read(text);
  ASSERT_EQ(table.Diameters.size(), 100000u);
  EXPECT_EQ(table.Diameters.back(), 100000.0);
}

TEST(SizeTables, WhatCannotBe)
{
  ExpectRefusal("", "got none");
  ExpectRefusal("\n# only a comment\n", "got none");
  ExpectRefusal("diameter\n", "got none");
  ExpectRefusal("1\nnan\n", "Line 2: a size requires a finite number, got 'nan'");
  ExpectRefusal("1\ninf\n", "finite number");
  ExpectRefusal("1\n2\nthree\n", "Line 3: a size requires a number, got 'three'");
  ExpectRefusal("1\n0\n", "Line 2: a length above 0");
  ExpectRefusal("1\n-2\n", "above 0");
  ExpectRefusal("1\n2 3\n", "got 2 column(s)");
  ExpectRefusal("1 2 3 0.5\n", "got 4 column(s)");
  ExpectRefusal("1\n\xff\n", "UTF-8");
}

TEST(SizeTables, DecimalCommas)
{
  for (const char* text : { "1,5\n2,25\n", "2,25\n1,5\n", "0,063 0\n1,5 100\n", "0,5;0\n1,5;100\n",
         "diameter\n1,5\n", "1\n1,5\n", "0,5\t0\n1,5\t100\n" })
  {
    ExpectRefusal(text, "a decimal point");
  }
}

TEST(SizeTables, CurvesThatDoNotRise)
{
  ExpectRefusal("1 5\n2 100\n", "Line 1: a sieve that nothing passes");
  ExpectRefusal("1 0\n3 50\n2 100\n", "Line 3: an opening above the last, 3, is required, got 2");
  ExpectRefusal("1 0\n1 100\n", "above the last");
  ExpectRefusal("1 0\n2 60\n3 50\n", "Line 3: a passing from the last, 60 %");
  ExpectRefusal("1 0\n2 101\n", "to 100 %");
  ExpectRefusal("1 0\n2 50\n", "A last sieve that 100 % pass is required, got 50 %");
  ExpectRefusal("1 0\n2 1\n", "got 1 %"); // shares of 1
  ExpectRefusal("1 0\n", "A last sieve");
  ExpectRefusal("1 0\n2 nan\n", "finite number");
}
