// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Compares texts of numbers with the compiler's reading of them, and the two ways of reading with
// each other
#include "ruc/Base/ParseDouble.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>
#include <random>

namespace
{
using Parser = bool (*)(std::string_view, double&);
class ParseDouble : public testing::TestWithParam<Parser>
{
};
INSTANTIATE_TEST_SUITE_P(
  EveryWay, ParseDouble, testing::Values(ruc::ParseDouble, ruc::ParseDoubleByStrtod));
}

TEST_P(ParseDouble, Numbers)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const struct
  {
    const char* Text;
    double Value;
  } cases[] = { { "0", 0.0 }, { "-0", -0.0 }, { "1", 1.0 }, { "-12.5", -12.5 }, { ".5", 0.5 },
    { "5.", 5.0 }, { "1e3", 1000.0 }, { "1E-3", 0.001 }, { "007", 7.0 },
    { "0.1000000000000000055511151231257827", 0.1 }, { "4.9e-324", 4.9e-324 },
    { "1.7976931348623157e308", 1.7976931348623157e308 }, { "inf", infinity },
    { "-inf", -infinity }, { "Infinity", infinity }, { "1e999", infinity },
    { "1e-999", infinity } };
  for (const auto& [text, wanted] : cases)
  {
    double value = 42.0;
    EXPECT_TRUE(GetParam()(text, value)) << text;
    EXPECT_EQ(value, wanted) << text;
    EXPECT_EQ(std::signbit(value), std::signbit(wanted)) << text;
  }
  double value = 42.0;
  EXPECT_TRUE(GetParam()("nan", value));
  EXPECT_TRUE(std::isnan(value));
}

TEST_P(ParseDouble, NoNumbers)
{
  for (const char* text : { "", " 1", "1 ", "+1", "--1", "-", ".", "e5", "1e", "0x10", "1,5",
         "1.5.2", "one", "1d3", "infinite", "\t2", "-+3", "- 4" })
  {
    double value = 42.0;
    EXPECT_FALSE(GetParam()(text, value)) << text;
    EXPECT_EQ(value, 42.0) << text;
  }
}

// Every bit pattern with 17 digits comes back
TEST_P(ParseDouble, EveryBit)
{
  std::mt19937_64 random(1);
  for (int i = 0; i < 100000; ++i)
  {
    const std::uint64_t bits = random();
    double wanted;
    std::memcpy(&wanted, &bits, sizeof wanted);
    if (!std::isfinite(wanted))
    {
      continue;
    }
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", wanted);
    double value = 0.0;
    ASSERT_TRUE(GetParam()(text, value)) << text;
    ASSERT_EQ(value, wanted) << text;
  }
}
