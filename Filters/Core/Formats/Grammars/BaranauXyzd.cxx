// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
//
// .xyzd of Baranau's packing-generation (its README, ReadPackingScript.m): x y z d of every sphere,
// little-endian, float64 or float32, and nothing else. The file packing.nfo beside it, or one of
// the name of the file, tells number, box and two porosities. Diameters in the file are those from
// before the run: the true ones are
// ((1 - final) / (1 - theoretical))^(1/3) times as large. Periodic, from 0 to the edges.
#include "ruc/Base/Text.h"
#include "ruc/Formats/Fields.h"
#include "ruc/Formats/Grammars/Grammars.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace ruc
{
namespace
{
template <class T>
T TakeReal(const char* at, bool swapped)
{
  using Bits = std::conditional_t<sizeof(T) == 8, std::uint64_t, std::uint32_t>;
  Bits bits = 0;
  for (std::size_t n = 0; n < sizeof(T); ++n)
  {
    const std::size_t place = swapped ? sizeof(T) - 1 - n : n;
    bits |= static_cast<Bits>(static_cast<unsigned char>(at[n])) << (8 * place);
  }
  T value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

// Numbers as coordinates and diameters have them
template <class T>
bool AreSane(std::string_view bytes, bool swapped)
{
  const std::size_t count = bytes.size() / (4 * sizeof(T));
  for (std::size_t n = 0; n < 4 * count; ++n)
  {
    const double value = TakeReal<T>(bytes.data() + n * sizeof(T), swapped);
    const bool diameter = n % 4 == 3;
    if (!(std::abs(value) < 1e30) || (diameter && !(value > 0.0)) ||
      (value != 0.0 && std::abs(value) < 1e-30))
    {
      return false;
    }
  }
  return count > 0;
}

// What packing.nfo or generation.conf tells behind a key and its colon
std::vector<double> NumbersBehind(const std::string& text, std::string_view key)
{
  std::vector<double> numbers;
  for (std::string_view line : FirstLines(text, 1000))
  {
    line = TrimBlanks(line);
    if (line.substr(0, key.size()) == key)
    {
      const std::string_view rest = line.substr(key.size());
      ParseNumbers(rest.substr(0, rest.find('(')), numbers);
      return numbers;
    }
  }
  return numbers;
}

struct Companion
{
  std::optional<std::uint64_t> Count;
  std::vector<double> Edges;
  double Factor = 1.0; // of diameters
  std::vector<std::string> Warnings;
};

Companion ReadCompanion(const ReadSettings& settings)
{
  const auto beside = [&](const char* name)
  { return settings.Beside ? settings.Beside(name) : std::string(); };
  Companion companion;
  std::string text = beside(".nfo");
  text = text.empty() ? beside("packing.nfo") : text;
  const bool info = !text.empty();
  text = info ? text : beside("generation.conf");
  const std::vector<double> count = NumbersBehind(text, info ? "N:" : "Particles count:");
  if (count.size() == 1 && count[0] >= 0.0 && count[0] < 1e15)
  {
    companion.Count = static_cast<std::uint64_t>(count[0]);
  }
  companion.Edges = NumbersBehind(text, info ? "Dimensions:" : "Packing size:");
  const std::vector<double> theoretical = NumbersBehind(text, "Theoretical Porosity:");
  const std::vector<double> final = NumbersBehind(text, "Final Porosity:");
  if (theoretical.size() == 1 && final.size() == 1)
  {
    companion.Factor = std::cbrt((1.0 - final[0]) / (1.0 - theoretical[0]));
    if (!(companion.Factor > 0.0 && std::isfinite(companion.Factor)))
    {
      throw std::invalid_argument(Text("Porosities below 1 are required in packing.nfo, got ",
        theoretical[0], " and ", final[0], "."));
    }
  }
  else
  {
    companion.Warnings.push_back("Diameters are those of the file: no packing.nfo beside it tells "
                                 "the two porosities that scale them.");
  }
  if (companion.Edges.size() != 3)
  {
    companion.Edges.clear();
    companion.Warnings.push_back(
      "The box is not known: neither packing.nfo nor generation.conf is beside the file.");
  }
  return companion;
}

std::uint64_t CountBytes(ByteStream& bytes)
{
  std::array<char, 65536> passed;
  std::uint64_t size = 0;
  bytes.Seek(0);
  while (const std::size_t read = bytes.Read(passed.data(), passed.size()))
  {
    size += read;
  }
  return size;
}

template <class T>
void ReadSpheres(ByteStream& bytes, std::uint64_t count, double factor, PackFrame& frame)
{
  std::vector<char> block(4096 * 4 * sizeof(T));
  bytes.Seek(0);
  for (std::uint64_t done = 0; done < count;)
  {
    const std::size_t read = bytes.Read(block.data(), block.size()) / (4 * sizeof(T));
    for (std::size_t n = 0; n < read; ++n)
    {
      double v[4];
      for (std::size_t q = 0; q < 4; ++q)
      {
        v[q] = TakeReal<T>(block.data() + (4 * n + q) * sizeof(T), false);
      }
      if (!std::isfinite(v[0] + v[1] + v[2] + v[3]) || !(v[3] > 0.0))
      {
        throw std::invalid_argument(
          Text("Sphere ", done + n + 1, " requires finite numbers and a diameter > 0, got ", v[0],
            ", ", v[1], ", ", v[2], ", ", v[3], "."));
      }
      frame.X.push_back(v[0]);
      frame.Y.push_back(v[1]);
      frame.Z.push_back(v[2]);
      frame.Radius.push_back(0.5 * factor * v[3]);
    }
    done += read;
  }
}

PackFrame Read(ByteStream& bytes, const FramePlace&, const ReadSettings& settings)
{
  const Companion companion = ReadCompanion(settings);
  const std::uint64_t size = CountBytes(bytes);
  const std::string begin = ReadBytes(bytes, 0, std::min<std::uint64_t>(size, 4096));
  const bool wide = companion.Count ? size == 32 * *companion.Count
                                    : size % 32 == 0 && AreSane<double>(begin, false);
  const bool narrow = companion.Count ? size == 16 * *companion.Count : size % 16 == 0;
  if (AreSane<double>(begin, true) && !AreSane<double>(begin, false) && size % 32 == 0)
  {
    throw std::invalid_argument("Little-endian numbers are required, got big-endian ones.");
  }
  if (!wide && !narrow)
  {
    throw std::invalid_argument(Text(
      "Little-endian numbers are required, 32 bytes a sphere, or 16 in "
      "single precision, got ",
      size, " bytes", companion.Count ? Text(" for ", *companion.Count, " spheres.") : Text(".")));
  }
  PackFrame frame;
  wide ? ReadSpheres<double>(bytes, size / 32, companion.Factor, frame)
       : ReadSpheres<float>(bytes, size / 16, companion.Factor, frame);
  frame.Warnings = companion.Warnings;
  if (!companion.Edges.empty())
  {
    SetBox(frame,
      FrameCell::FromBounds({}, { companion.Edges[0], companion.Edges[1], companion.Edges[2] }),
      { true, true, true }, true);
  }
  return frame;
}

void AppendReal(std::string& bytes, double value)
{
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  for (int n = 0; n < 8; ++n)
  {
    bytes += static_cast<char>(bits >> (8 * n) & 0xff);
  }
}

// With two equal porosities, the diameters of the file are the true ones
WrittenPack Write(const FramePack& pack, const WriteSettings&)
{
  if (!pack.Box || !pack.Box->IsFullyPeriodic())
  {
    throw std::invalid_argument(Text("A box that is periodic along all axes is required, got ",
      pack.Box ? "a " + pack.Box->Describe() : "none", "."));
  }
  const SpherePack& spheres = pack.Pack;
  const Window& box = *pack.Box;
  WrittenPack written;
  double volume = 0.0;
  for (std::size_t i = 0; i < spheres.Size(); ++i)
  {
    const Vector3 centre = spheres.Centre(i);
    for (int q = 0; q < 3; ++q)
    {
      AppendReal(written.Bytes, centre[q] - box.Origin[q]);
    }
    AppendReal(written.Bytes, 2.0 * spheres.Radius[i]);
    volume += 4.0 / 3.0 * Pi * std::pow(spheres.Radius[i], 3);
  }
  std::string& info = written.Info;
  info = Text("N: ", spheres.Size(), "\nDimensions: ");
  AppendNumbers(info, { box.Size[0], box.Size[1], box.Size[2] });
  for (const char* porosity : { "\nTheoretical Porosity: ", "\nFinal Porosity: " })
  {
    info += porosity;
    AppendNumber(info, 1.0 - volume / box.Volume());
  }
  info += "\n";
  return written;
}

// No text, and nothing but numbers that can be coordinates
bool Recognise(std::string_view begin)
{
  const bool binary =
    std::any_of(begin.begin(), begin.end(), [](char c) { return c >= 0 && c < 9; });
  return binary &&
    (AreSane<double>(begin, false) || AreSane<float>(begin, false) || AreSane<double>(begin, true));
}
}

const PackFormat BaranauXyzd = { "Baranau xyzd", Recognise, ScanOneFrame, Read, { Write, "xyzd" } };
}
