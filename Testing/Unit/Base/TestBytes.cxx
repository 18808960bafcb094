// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Base/Bytes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
enum class Colour
{
  Red,
  Green,
  Blue
};
constexpr int CountOf(Colour)
{
  return 3;
}

struct Inner
{
  Colour Kind = Colour::Red;
  std::vector<double> Values;
  bool operator==(const Inner& other) const
  {
    return this->Kind == other.Kind && this->Values == other.Values;
  }
  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Kind, self.Values);
  }
};

struct Outer
{
  std::int32_t Number = 0;
  bool Yes = false;
  std::string Text;
  std::array<bool, 3> Flags{};
  std::array<double, 2> Pair{};
  std::vector<std::array<double, 3>> Points;
  std::vector<Inner> Inners;
  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(
      self.Number, self.Yes, self.Text, self.Flags, self.Pair, self.Points, self.Inners);
  }
  bool operator==(const Outer& other) const { return Fields(*this) == Fields(other); }
};

Outer Example()
{
  Outer example;
  example.Number = -7;
  example.Yes = true;
  example.Text = std::string("a\0b", 3);
  example.Flags = { true, false, true };
  example.Pair = { -0.0, std::numeric_limits<double>::denorm_min() };
  example.Points = { { 1.0, 2.0, 3.0 }, { 4.0, 5.0, 6.0 } };
  example.Inners = { { Colour::Blue, { 0.1, 0.2 } }, { Colour::Green, {} } };
  return example;
}

template <class Value>
std::string ErrorOf(const std::string& bytes)
{
  try
  {
    Value value{};
    ruc::FromBytes(bytes, value);
  }
  catch (const std::invalid_argument& e)
  {
    return e.what();
  }
  return {};
}

const char* const Lengths = "The message between ranks is damaged: its lengths do not fit.";
const char* const Value = "The message between ranks is damaged: it holds a value that cannot be.";
}

TEST(Bytes, ReturnEveryBitOfWhatWasPut)
{
  const Outer example = Example();
  Outer found;
  found.Points.resize(9); // what was there before is replaced
  ruc::FromBytes(ruc::ToBytes(example), found);
  EXPECT_EQ(found, example);
  EXPECT_TRUE(std::signbit(found.Pair[0]));
}

TEST(Bytes, OfNumbersAreTheNumbersBehindTheirCount)
{
  const std::string bytes = ruc::ToBytes(std::vector<std::int32_t>{ 1, 2 });
  ASSERT_EQ(bytes.size(), sizeof(std::uint64_t) + 2 * sizeof(std::int32_t));
  EXPECT_EQ(ruc::ToBytes(std::uint64_t(2)), bytes.substr(0, 8));
  EXPECT_EQ(ruc::ToBytes(std::int32_t(2)), bytes.substr(12));
}

TEST(Bytes, CutOffAnywhereAreRefused)
{
  const std::string bytes = ruc::ToBytes(Example());
  for (std::size_t size = 0; size < bytes.size(); ++size)
  {
    EXPECT_EQ(ErrorOf<Outer>(bytes.substr(0, size)), Lengths) << size;
  }
  EXPECT_EQ(ErrorOf<Outer>(bytes + "x"), Lengths);
}

TEST(Bytes, WithAForgedLengthAreRefusedWithoutMemoryForIt)
{
  const std::string rest(100, '\0');
  for (std::uint64_t size : { std::uint64_t(101), std::uint64_t(1) << 40, ~std::uint64_t(0) })
  {
    const std::string bytes = ruc::ToBytes(size) + rest;
    EXPECT_EQ(ErrorOf<std::string>(bytes), Lengths) << size;
    EXPECT_EQ(ErrorOf<std::vector<double>>(bytes), Lengths) << size;
    EXPECT_EQ(ErrorOf<std::vector<Inner>>(bytes), Lengths) << size;
  }
}

TEST(Bytes, OfABoolOrAnEnumAreRefusedOutOfRange)
{
  for (int byte = 0; byte < 256; ++byte)
  {
    const std::string bytes(1, static_cast<char>(byte));
    EXPECT_EQ(ErrorOf<bool>(bytes), byte < 2 ? "" : Value) << byte;
    EXPECT_EQ(ErrorOf<Colour>(bytes), byte < 3 ? "" : Value) << byte;
  }
}

// Whatever byte is changed, the result is a value or an error
TEST(Bytes, ChangedAnywhereAreAValueOrRefused)
{
  const std::string bytes = ruc::ToBytes(Example());
  for (std::size_t place = 0; place < bytes.size(); ++place)
  {
    for (int change : { 1, 2, 4, 64, 128, 255 })
    {
      std::string changed = bytes;
      changed[place] = static_cast<char>(changed[place] ^ change);
      const std::string error = ErrorOf<Outer>(changed);
      EXPECT_TRUE(error.empty() || error == Lengths || error == Value) << error;
    }
  }
}

TEST(Bytes, AreNamedInMessages)
{
  ruc::ByteReader reader("", "checkpoint");
  try
  {
    reader.Get<double>();
    FAIL() << "nothing was thrown";
  }
  catch (const std::invalid_argument& e)
  {
    EXPECT_STREQ(e.what(), "The checkpoint is damaged: its lengths do not fit.");
  }
}
