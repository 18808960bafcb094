// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Formats/LineSource.h"

#include "ruc/Formats/BoundedBytes.h"

#include "FormatFiles.h"

#include <zlib.h>

namespace
{
// The text packed by zlib as one member of gzip
std::string Packed(std::string_view text)
{
  z_stream stream = {};
  EXPECT_EQ(deflateInit2(&stream, 6, Z_DEFLATED, 16 + MAX_WBITS, 9, Z_DEFAULT_STRATEGY), Z_OK);
  std::string packed(deflateBound(&stream, text.size()) + 64, '\0');
  stream.next_in = reinterpret_cast<unsigned char*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<unsigned int>(text.size());
  stream.next_out = reinterpret_cast<unsigned char*>(packed.data());
  stream.avail_out = static_cast<unsigned int>(packed.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

std::vector<std::string> LinesOf(ruc::ByteStream& bytes)
{
  ruc::LineSource source(bytes);
  std::vector<std::string> lines;
  std::string_view line;
  while (source.Next(line))
  {
    lines.emplace_back(line);
  }
  EXPECT_EQ(source.Line(), lines.size());
  return lines;
}

std::vector<std::string> LinesOf(std::string_view text)
{
  ruc::MemoryBytes bytes(text);
  return LinesOf(bytes);
}

// Lines of all lengths, more than any buffer holds
std::string LongText()
{
  std::string text;
  for (int n = 0; n < 20000; ++n)
  {
    text += std::to_string(n) + std::string(n % 97, 'x') + "\n";
  }
  return text + std::string(ruc::LineSource::LongestLine, 'y') + "\nend";
}
}

TEST(LineSource, EndsOfLines)
{
  using Lines = std::vector<std::string>;
  EXPECT_EQ(LinesOf(""), Lines());
  EXPECT_EQ(LinesOf("a"), Lines({ "a" }));
  EXPECT_EQ(LinesOf("a\n"), Lines({ "a" }));
  EXPECT_EQ(LinesOf("\na\n\nb"), Lines({ "", "a", "", "b" }));
  EXPECT_EQ(LinesOf("a\r\nb\r\n"), Lines({ "a", "b" }));
  EXPECT_EQ(LinesOf("a\rb\r"), Lines({ "a", "b" }));
}

TEST(LineSource, GoesOnWhereItIsTold)
{
  const std::string text = LongText();
  ruc::MemoryBytes bytes(text);
  ruc::LineSource source(bytes);
  std::string_view line;
  EXPECT_EQ(source.Skip(15000), 15000u);
  ASSERT_TRUE(source.Peek(line));
  const std::string peeked(line);
  EXPECT_EQ(peeked.substr(0, 5), "15000");
  const std::uint64_t offset = source.Offset();
  ASSERT_TRUE(source.Next(line));
  EXPECT_EQ(line, peeked);
  EXPECT_EQ(source.Skip(100000), 5001u);
  EXPECT_FALSE(source.Next(line));
  EXPECT_EQ(source.MostBytesLeft(), 0u);

  ruc::LineSource again(bytes, offset, 15000);
  EXPECT_EQ(again.MostBytesLeft(), text.size() - offset);
  ASSERT_TRUE(again.Next(line));
  EXPECT_EQ(line, peeked);
  EXPECT_SAYS(again.Fail("what."), "Line 15001: what.");
  EXPECT_SAYS(LinesOf("a\n" + std::string(ruc::LineSource::LongestLine + 1, 'x') + "\n"),
    "Line 2: a line of at most 65536 bytes is required");
}

TEST(Gzip, UnpacksMembersAndGoesBack)
{
  const std::string text = LongText();
  const std::size_t half = text.size() / 2;
  // Two members, then zeros, which gzip passes over
  const std::string packed =
    Packed(text.substr(0, half)) + Packed(text.substr(half)) + std::string(5, '\0');
  const auto bytes = ruc::Unpack(std::make_unique<ruc::MemoryBytes>(packed));
  EXPECT_EQ(LinesOf(*bytes), LinesOf(text));
  EXPECT_EQ(ruc::ReadBytes(*bytes, 1000, 50), text.substr(1000, 50));
  EXPECT_EQ(ruc::ReadBytes(*bytes, 500000, 50), text.substr(500000, 50));
  EXPECT_EQ(ruc::ReadBytes(*bytes, text.size() - 3, 50), "end");
  EXPECT_GE(bytes->MostBytes(), text.size());
  // What is not packed is given as it is
  EXPECT_EQ(LinesOf(*ruc::Unpack(std::make_unique<ruc::MemoryBytes>("a\nb"))),
    (std::vector<std::string>{ "a", "b" }));
}

namespace
{
// Counts how often it is read from the start
class CountedBytes : public ruc::MemoryBytes
{
public:
  CountedBytes(std::string_view bytes, int& starts)
    : ruc::MemoryBytes(bytes)
    , Starts(starts)
  {
  }
  void Seek(std::uint64_t offset) override
  {
    this->Starts += offset == 0;
    ruc::MemoryBytes::Seek(offset);
  }

private:
  int& Starts;
};
}

TEST(Gzip, FramesOneAfterTheOtherAreUnpackedOnce)
{
  std::string text;
  for (int step = 0; step < 40; ++step)
  {
    text += "ITEM: TIMESTEP\n" + std::to_string(step) +
      "\nITEM: NUMBER OF ATOMS\n3000\nITEM: ATOMS id x y z radius\n";
    for (int i = 0; i < 3000; ++i)
    {
      text += std::to_string(i) + " " + std::to_string(step) + "." + std::to_string(i) + " " +
        std::to_string(i * i) + " 3 0.25\n";
    }
  }
  ASSERT_GT(text.size(), 2500000u); // more than what is kept
  const std::string packed = Packed(text);
  int starts = 0;
  formats::Opened file(std::make_unique<CountedBytes>(packed, starts));
  ASSERT_EQ(file.Frames.size(), 40u);
  EXPECT_EQ(file.Frame(0).X[1], 0.1);
  const int before = starts;
  for (std::size_t n = 1; n < 40; ++n)
  {
    EXPECT_EQ(file.Frame(n).X[1], static_cast<double>(n) + 0.1);
  }
  EXPECT_EQ(starts, before);
  EXPECT_EQ(file.Frame(3).X[1], 3.1);
  EXPECT_EQ(starts, before + 1) << "back to the start, once";
}

TEST(Gzip, ALimitIsOfOneFrameAndNotOfTheFile)
{
  std::string text;
  std::size_t longest = 0;
  for (int rows : { 2000, 9000, 20000, 6000 })
  {
    const std::size_t begin = text.size();
    text += "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n" + std::to_string(rows) +
      "\nITEM: ATOMS id x y z radius\n";
    for (int i = 0; i < rows; ++i)
    {
      text += std::to_string(i) + " " + std::to_string(i * i) + " 0.12345678 3 0.25\n";
    }
    longest = std::max(longest, text.size() - begin);
  }
  const std::string packed = Packed(text);
  auto owned =
    std::make_unique<ruc::BoundedBytes>(ruc::Unpack(std::make_unique<ruc::MemoryBytes>(packed)));
  ruc::BoundedBytes& bytes = *owned;
  formats::Opened file(std::move(owned)); // which is scanned whole
  ASSERT_EQ(file.Frames.size(), 4u);
  const std::uint64_t most = longest + 2 * ruc::LineSource::LongestLine; // which it reads ahead
  ASSERT_LT(most, text.size());
  for (std::size_t n : { 2u, 3u, 0u, 1u, 2u }) // also after going back to the start
  {
    bytes.Allow(most, "a quarter of it");
    EXPECT_EQ(file.Frame(n).Size(), n == 0 ? 2000u : n == 1 ? 9000u : n == 2 ? 20000u : 6000u);
  }
  bytes.Allow(longest - 1, "a quarter of it");
  EXPECT_SAYS(file.Frame(2), "MB is required, a quarter of it, got more.");
  bytes.Allow(longest - 1, "a quarter of it");
  EXPECT_EQ(file.Frame(0).Size(), 2000u); // a smaller one is read
  bytes.AllowAll();
  EXPECT_EQ(file.Frame(2).Size(), 20000u);
}

TEST(Gzip, WhatIsBeforeAFaultCanBeReadAgain)
{
  const std::string text = LongText();
  std::string cut = Packed(text);
  cut.resize(cut.size() * 9 / 10);
  const auto bytes = ruc::Unpack(std::make_unique<ruc::MemoryBytes>(cut));
  std::vector<char> passed(text.size());
  EXPECT_SAYS(bytes->Read(passed.data(), passed.size()), "The packed file ends early");
  for (std::size_t offset : { 0u, 400000u, 700000u, 100000u })
  {
    EXPECT_EQ(ruc::ReadBytes(*bytes, offset, 5000), text.substr(offset, 5000)) << offset;
  }
}

TEST(Gzip, Refusals)
{
  const std::string text = LongText();
  const std::string packed = Packed(text);
  const auto read = [](const std::string& packedBytes, std::uint64_t most)
  {
    const auto bytes = ruc::Unpack(std::make_unique<ruc::MemoryBytes>(packedBytes), most);
    std::vector<char> passed(1u << 16);
    while (bytes->Read(passed.data(), passed.size()) > 0)
    {
    }
  };
  EXPECT_SAYS(read(packed.substr(0, packed.size() / 2), 1u << 30), "The packed file ends early");
  EXPECT_SAYS(read("\x1f\x8b", 1u << 30), "The packed file ends early");
  std::string damaged = packed;
  damaged[packed.size() / 2] ^= 0x55;
  EXPECT_SAYS(read(damaged, 1u << 30), "The packed file is damaged");
  EXPECT_SAYS(read(packed, 1u << 20), "The file unpacks to more than 1 MB");
  EXPECT_SAYS(read(Packed(std::string(20u << 20, '\n')), ~0ull), "more than 1000 times its size");
}
