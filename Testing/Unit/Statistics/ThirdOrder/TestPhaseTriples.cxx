// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/ThirdOrder/ThreePointProbability.h"

#include "Oracles.h"

#include <algorithm>
#include <array>
#include <set>
#include <vector>

namespace
{
using ruc::ParseTriples;
using ruc::PhaseTriple;
}

TEST(PhaseTriples, AreParsed)
{
  using List = std::vector<PhaseTriple>;
  EXPECT_EQ(
    ParseTriples("3 5 5; 7 7 5; m m m", 7), (List{ { 2, 4, 4 }, { 6, 6, 4 }, { 7, 7, 7 } }));
  EXPECT_EQ(ParseTriples("1 m 2", 2), (List{ { 0, 2, 1 } }));
  // What is repeated counts once; the other order of s and q is another function
  EXPECT_EQ(ParseTriples("1 1 2;1 2 1 ; 1 1 2", 2), (List{ { 0, 0, 1 }, { 0, 1, 0 } }));
  EXPECT_EQ(ParseTriples("  \t1   1\n1  ", 1), (List{ { 0, 0, 0 } }));
  EXPECT_EQ(ParseTriples("m m m;", 3), (List{ { 3, 3, 3 } })); // as after any list
}

TEST(PhaseTriples, AllOfThem)
{
  for (int modes : { 1, 2, 3, 9 })
  {
    const std::size_t phases = modes + 1;
    const std::vector<PhaseTriple> all = ParseTriples("all", modes);
    EXPECT_EQ(all.size(), phases * phases * (phases + 1) / 2);
    std::set<std::array<int, 3>> different;
    for (const PhaseTriple& triple : all)
    {
      EXPECT_LE(triple.S, triple.Q);
      for (int phase : { triple.R, triple.S, triple.Q })
      {
        EXPECT_GE(phase, 0);
        EXPECT_LE(phase, modes);
      }
      different.insert({ triple.R, std::min(triple.S, triple.Q), std::max(triple.S, triple.Q) });
    }
    EXPECT_EQ(different.size(), all.size());
  }
  EXPECT_EQ(ParseTriples(" all ", 1), ParseTriples("all", 1));
}

TEST(PhaseTriples, RefuseBadText)
{
  for (const char* text : { "3 5", "3 5 x", "3 5 5 5", "0 1 1", "1e3 1 1", "1 1 9", "-1 1 1",
         "1.0 1 1", "1 1 M", "m", "all all", "1 1 1; all", "99999999999999999999 1 1", "1,1,1" })
  {
    EXPECT_SAYS(ParseTriples(text, 8), "Phases requires triples of phases, 1 to 8 or m, such as");
  }
  EXPECT_SAYS(ParseTriples("3 5 5; 3 5 x", 8), "got ' 3 5 x'.");
  EXPECT_SAYS(ParseTriples("1 1 1;;2 2 2", 8), "got ''.");
  EXPECT_SAYS(ParseTriples("3 3 3", 2),
    "Phases requires triples of phases, 1 to 2 or m, such as '1 1 m; m m m', or 'all', got '3 3 "
    "3'.");
  EXPECT_SAYS(ParseTriples("", 2), "Phases requires at least one triple of phases, got none.");
  EXPECT_SAYS(ParseTriples(";", 2), "Phases requires");
  EXPECT_SAYS(ParseTriples(" ", 2), "Phases requires");
}

TEST(PhaseTriples, HaveNames)
{
  EXPECT_EQ(ruc::TripleName({ 2, 4, 4 }, 9), "S_3_5_5");
  EXPECT_EQ(ruc::TripleName({ 0, 9, 9 }, 9), "S_1_m_m");
  EXPECT_EQ(ruc::TripleName({ 11, 0, 12 }, 12), "S_12_1_m");
}
