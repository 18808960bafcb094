// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The corners of the grammars of binary files: Baranau's .xyzd and HOOMD's GSD
#include "FormatFiles.h"

#include <algorithm>
#include <cstring>

namespace
{
using formats::OpenText;
using ruc::PackFrame;
using ruc::Vector3;
using Doubles = std::vector<double>;

PackFrame Parse(std::string_view text)
{
  return OpenText(text).Frame();
}

template <class T>
void Put(std::string& bytes, T value, bool swapped = false)
{
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  if (swapped)
  {
    std::reverse(raw, raw + sizeof value);
  }
  bytes.append(raw, sizeof value);
}

std::string Xyzd(bool swapped = false)
{
  std::string bytes;
  for (double x : { 1.0, 2.0, 3.0, 0.5, 3.5, 4.0, 5.0, 1.0 })
  {
    Put(bytes, x, swapped);
  }
  return bytes;
}

formats::Opened OpenXyzd(const std::string& bytes, const std::string& name, const std::string& text)
{
  ruc::ReadSettings settings;
  settings.Beside = [name, text](const std::string& wanted)
  { return wanted == name ? text : std::string(); };
  return OpenText(bytes, settings);
}
}

TEST(XyzdGrammar, ScaledByPorosities)
{
  const std::string bytes = Xyzd();
  const std::string info =
    "N: 2\n Dimensions: 4 5 6\n Theoretical Porosity: 0.875\nFinal Porosity: 0 (Tolerance: 1)\n";
  const PackFrame frame = OpenXyzd(bytes, "packing.nfo", info).Frame();
  EXPECT_EQ(frame.X, (Doubles{ 1, 3.5 }));
  EXPECT_NEAR(frame.Radius[0], 0.5, 1e-15); // (1 / 0.125)^(1/3) = 2
  EXPECT_EQ(frame.Box->Edges, (Vector3{ 4, 5, 6 }));
  EXPECT_TRUE(frame.Warnings.empty());
  std::string narrow;
  for (float x : { 1.0f, 2.0f, 3.0f, 0.5f, 3.5f, 4.0f, 5.0f, 1.0f })
  {
    Put(narrow, x);
  }
  EXPECT_EQ(OpenXyzd(narrow, "packing.nfo", info).Frame().X, (Doubles{ 1, 3.5 }));
  const PackFrame conf =
    OpenXyzd(bytes, "generation.conf", "Particles count: 2\nPacking size: 4 5 6\n").Frame();
  EXPECT_EQ(conf.Radius, (Doubles{ 0.25, 0.5 }));
  EXPECT_EQ(conf.Warnings.size(), 1u);
  EXPECT_EQ(conf.Box->Edges, (Vector3{ 4, 5, 6 }));
  const PackFrame alone = Parse(bytes);
  EXPECT_FALSE(alone.Box);
  EXPECT_EQ(alone.Warnings.size(), 2u);
}

TEST(XyzdGrammar, Refusals)
{
  EXPECT_SAYS(Parse(Xyzd(true)), "Little-endian numbers are required");
  EXPECT_SAYS(OpenXyzd(Xyzd(), "packing.nfo", "N: 3\n").Frame(), "got 64 bytes for 3 spheres");
  EXPECT_SAYS(Parse(Xyzd() + std::string(8, '\0')), "Little-endian numbers are required, 32 bytes");
  EXPECT_SAYS(
    OpenXyzd(Xyzd(), "packing.nfo", "N: 2\nTheoretical Porosity: 1\nFinal Porosity: 0.5\n").Frame(),
    "Porosities below 1 are required");
  std::string zero;
  for (int n = 0; n < 200; ++n)
  {
    zero += Xyzd();
  }
  Put(zero, 1.0);
  Put(zero, 1.0);
  Put(zero, 1.0);
  Put(zero, 0.0);
  EXPECT_SAYS(Parse(zero), "Sphere 401 requires finite numbers and a diameter > 0");
}

namespace
{
// Writes a file of GSD as its page tells, in version 2
class Gsd
{
public:
  template <class T>
  void Add(std::uint64_t frame, const std::string& name, unsigned char type, std::uint32_t columns,
    const std::vector<T>& values)
  {
    std::size_t id = 0;
    while (id < this->Names.size() && this->Names[id] != name)
    {
      ++id;
    }
    if (id == this->Names.size())
    {
      this->Names.push_back(name);
    }
    std::string entry;
    Put(entry, frame);
    Put(entry, static_cast<std::uint64_t>(values.size() / columns));
    Put(entry, static_cast<std::uint64_t>(256 + this->Data.size()));
    Put(entry, columns);
    Put(entry, static_cast<std::uint16_t>(id));
    entry += static_cast<char>(type);
    entry += '\0';
    this->Index += entry;
    for (T value : values)
    {
      Put(this->Data, value);
    }
  }
  std::string Write(const std::string& schema = "hoomd", std::uint32_t version = 2u << 16,
    std::uint64_t entries = 0) const
  {
    std::string names;
    for (const std::string& name : this->Names)
    {
      names += name + std::string(version >> 16 == 1 ? 64 - name.size() : 1, '\0');
    }
    names.resize((names.size() / 64 + 1) * 64);
    std::string file;
    Put(file, std::uint64_t(0x65DF65DF65DF65DFu));
    Put(file, std::uint64_t(256 + this->Data.size()));
    Put(file, entries > 0 ? entries : std::uint64_t(this->Index.size() / 32 + 1));
    Put(file, std::uint64_t(256 + this->Data.size() + this->Index.size() + 32));
    Put(file, std::uint64_t(names.size() / 64));
    Put(file, std::uint32_t(1u << 16 | 4));
    Put(file, version);
    file.resize(112);
    file += schema;
    file.resize(256);
    return file + this->Data + this->Index + std::string(32, '\0') + names;
  }

private:
  std::string Data, Index;
  std::vector<std::string> Names;
};

Gsd TwoParticles()
{
  Gsd gsd;
  gsd.Add<float>(0, "configuration/box", 9, 1, { 4, 5, 6, 0.5, 0, 0.25 });
  gsd.Add<std::uint32_t>(0, "particles/N", 3, 1, { 2 });
  gsd.Add<float>(0, "particles/position", 9, 3, { 0, 0, 0, 1, 1, 1 });
  return gsd;
}

std::vector<char> Shapes(std::vector<std::string> shapes)
{
  std::vector<char> bytes;
  for (std::string& shape : shapes)
  {
    shape.resize(64);
    bytes.insert(bytes.end(), shape.begin(), shape.end());
  }
  return bytes;
}
}

TEST(GsdGrammar, ChunksOfFrameZeroAndDefaults)
{
  Gsd gsd = TwoParticles();
  gsd.Add<double>(0, "particles/diameter", 10, 1, { 0.5, 1 });
  gsd.Add<std::uint64_t>(1, "configuration/step", 4, 1, { 70 });
  gsd.Add<double>(1, "particles/position", 10, 3, { 2, 0, 0, 1, 1, 1 });
  gsd.Add<std::uint32_t>(2, "particles/N", 3, 1, { 1 });
  gsd.Add<float>(2, "particles/position", 9, 3, { 1, 1, 1 });
  for (std::uint32_t version : { 1u << 16, 2u << 16 | 1 })
  {
    const std::string bytes = gsd.Write("hoomd", version);
    auto file = OpenText(bytes);
    ASSERT_EQ(file.Frames.size(), 3u);
    EXPECT_EQ(file.Frame(0).Radius, (Doubles{ 0.25, 0.5 }));
    const PackFrame second = file.Frame(1);
    EXPECT_EQ(second.Step, 70);
    EXPECT_EQ(second.X, (Doubles{ 2, 1 }));
    EXPECT_EQ(second.Radius, (Doubles{ 0.25, 0.5 }));
    EXPECT_EQ(second.Type, (std::vector<int>{ 0, 0 }));
    EXPECT_TRUE(file.Frame(2).Radius.empty()); // another number of particles: frame 0's do not fit
    EXPECT_EQ(second.Box->Edges, (Vector3{ 4, 5, 6 }));
    EXPECT_EQ(second.Box->Tilts, (Vector3{ 2.5, 0, 1.5 })); // factors of ly and lz
    EXPECT_EQ(second.Box->Origin, (Vector3{ -3.25, -3.25, -3 }));
  }
}

TEST(GsdGrammar, ATypeThatIsNoTypeIsRefused)
{
  for (float type : { -9.6e30f, 1e30f, std::nanf("") })
  {
    Gsd gsd = TwoParticles();
    gsd.Add<float>(0, "particles/typeid", 9, 1, { 0.0f, type });
    const std::string bytes = gsd.Write();
    EXPECT_SAYS(OpenText(bytes).Frame(), "A type from 0 to 2147483647 is required, got");
  }
}

TEST(GsdGrammar, DiametersOfShapes)
{
  Gsd gsd = TwoParticles();
  gsd.Add<std::uint32_t>(0, "particles/typeid", 3, 1, { 1, 0 });
  gsd.Add<char>(0, "particles/type_shapes", 1, 64,
    Shapes(
      { "{\"type\": \"Sphere\", \"diameter\": 3.0}", "{\"diameter\":1.5,\"type\":\"Sphere\"}" }));
  const std::string bytes = gsd.Write();
  EXPECT_EQ(OpenText(bytes).Frame().Radius, (Doubles{ 0.75, 1.5 }));
  EXPECT_TRUE(OpenText(TwoParticles().Write()).Frame().Radius.empty()); // to be asked for
  Gsd other = TwoParticles();
  other.Add<char>(0, "particles/type_shapes", 1, 64, Shapes({ "{\"type\": \"Polygon\"}" }));
  EXPECT_SAYS(
    OpenText(other.Write()).Frame(), "A finite diameter > 0 is required, got 0 of particle 0");
}

TEST(GsdGrammar, Refusals)
{
  const auto parse = [](const std::string& bytes) { OpenText(bytes).Frame(); };
  const std::string good = TwoParticles().Write();
  EXPECT_SAYS(parse(TwoParticles().Write("none")), "Schema 'hoomd' is required, got 'none'.");
  EXPECT_SAYS(
    parse(TwoParticles().Write("hoomd", 7u << 16)), "GSD of version 1 or 2 is required, got 7");
  EXPECT_SAYS(parse(good.substr(0, 100)), "A header of GSD, 256 bytes, is required");
  EXPECT_SAYS(parse(TwoParticles().Write("hoomd", 2u << 16, 1ull << 60)),
    "An index within the file is required");
  EXPECT_SAYS(parse(good.substr(0, 300)), "within the file are required");
  Gsd wide = TwoParticles();
  wide.Add<float>(0, "particles/diameter", 9, 2, { 1, 1, 1, 1 });
  EXPECT_SAYS(parse(wide.Write()), "particles/diameter requires 2 x 1 numbers, got 2 x 2.");
  Gsd nan;
  nan.Add<std::uint32_t>(0, "particles/N", 3, 1, { 1 });
  nan.Add<float>(0, "particles/position", 9, 3, { 0, 0, std::nanf("") });
  EXPECT_SAYS(parse(nan.Write()), "A finite position is required");
  Gsd kind;
  kind.Add<std::uint32_t>(0, "particles/N", 3, 1, { 1 });
  kind.Add<char>(0, "particles/position", 1, 3, { 0, 0, 0 });
  EXPECT_SAYS(parse(kind.Write()), "particles/position requires numbers of type");
  EXPECT_SAYS(parse(Gsd().Write()), "At least one sphere is required");
}
