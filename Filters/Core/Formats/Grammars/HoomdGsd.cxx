// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
//
// GSD of HOOMD-blue, by its specification (glotzerlab/gsd, doc: file-layer, schema-hoomd, shapes):
// a header of 256 bytes, an index with an entry of 32 bytes for each chunk, names of the chunks. A
// chunk that a frame lacks is that of frame 0 if both have as many particles, else a default. The
// box is centred on 0 and periodic; its tilts are factors of ly and lz.
#include "ruc/Base/Text.h"
#include "ruc/Formats/Fields.h"
#include "ruc/Formats/Grammars/Grammars.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <stdexcept>

namespace ruc
{
namespace
{
constexpr std::uint64_t Magic = 0x65DF65DF65DF65DFu;
constexpr std::uint64_t HeaderBytes = 256, EntryBytes = 32, NameBytes = 64;

// Little-endian, whatever the machine
template <class T>
T Take(const char* at)
{
  std::uint64_t bits = 0;
  for (std::size_t n = 0; n < sizeof(T); ++n)
  {
    bits |= static_cast<std::uint64_t>(static_cast<unsigned char>(at[n])) << (8 * n);
  }
  if constexpr (std::is_same_v<T, float>)
  {
    const auto half = static_cast<std::uint32_t>(bits);
    float value;
    std::memcpy(&value, &half, sizeof value);
    return value;
  }
  else if constexpr (std::is_same_v<T, double>)
  {
    double value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }
  else
  {
    return static_cast<T>(bits);
  }
}

[[noreturn]] void Fail(const std::string& what)
{
  throw std::invalid_argument(what);
}

// Bytes of a type's number, 0 for one that is not known: integers, then float, double, characters
std::uint64_t SizeOfType(unsigned int type)
{
  static constexpr std::uint64_t sizes[] = { 0, 1, 2, 4, 8, 1, 2, 4, 8, 4, 8, 1 };
  return type < std::size(sizes) ? sizes[type] : 0;
}

struct Chunk
{
  std::uint64_t Frame = 0, Rows = 0, Location = 0;
  std::uint32_t Columns = 0;
  unsigned int Type = 0;
};

class GsdFile
{
public:
  explicit GsdFile(ByteStream& bytes);

  std::uint64_t NumberOfFrames() const { return this->Frames; }
  std::uint64_t NumberOfParticles(std::uint64_t frame) const;
  /** The chunk of a frame, else that of frame 0; with `particles` only if both have as many. */
  const Chunk* Find(const char* name, std::uint64_t frame, bool particles) const;
  std::string Read(const Chunk& chunk) const;
  /** The numbers of a chunk, checked to have that shape; empty where there is none. */
  std::vector<double> Numbers(const char* name, std::uint64_t frame, bool particles,
    std::uint64_t rows, std::uint32_t columns) const;
  std::uint64_t StepOf(std::uint64_t frame) const;

private:
  void ReadNames(std::uint64_t location, std::uint64_t allocated, bool fixed);
  void ReadIndex(std::uint64_t location, std::uint64_t allocated);

  ByteStream& Bytes;
  std::uint64_t Frames = 0;
  std::vector<std::string> Names;
  std::map<std::pair<std::string, std::uint64_t>, Chunk> Chunks;
};

GsdFile::GsdFile(ByteStream& bytes)
  : Bytes(bytes)
{
  const std::string header = ReadBytes(bytes, 0, HeaderBytes);
  if (header.size() < HeaderBytes || Take<std::uint64_t>(header.data()) != Magic)
  {
    Fail("A header of GSD, 256 bytes, is required, got none.");
  }
  const std::string schema(header.data() + 112, ::strnlen(header.data() + 112, 64));
  if (schema != "hoomd")
  {
    Fail(Text("Schema 'hoomd' is required, got ", Quote(schema), "."));
  }
  const auto version = Take<std::uint32_t>(header.data() + 44) >> 16;
  if (version != 1 && version != 2)
  {
    Fail(Text("GSD of version 1 or 2 is required, got ", version, "."));
  }
  const auto number = [&](std::size_t at) { return Take<std::uint64_t>(header.data() + at); };
  this->ReadNames(number(24), number(32), version == 1);
  this->ReadIndex(number(8), number(16));
}

// Of version 1 in slots of 64 bytes, of version 2 one after the other, each with a zero behind
void GsdFile::ReadNames(std::uint64_t location, std::uint64_t allocated, bool fixed)
{
  const std::uint64_t most = this->Bytes.MostBytes();
  if (location > most || allocated > (most - location) / NameBytes)
  {
    Fail(Text("Names within the file are required, got ", allocated, " at ", location, "."));
  }
  const std::string names = ReadBytes(this->Bytes, location, allocated * NameBytes);
  for (std::size_t at = 0; at < names.size() && names[at] != '\0';)
  {
    const std::size_t length = ::strnlen(names.data() + at, names.size() - at);
    this->Names.emplace_back(names, at, length);
    at += fixed ? NameBytes : length + 1;
  }
}

void GsdFile::ReadIndex(std::uint64_t location, std::uint64_t allocated)
{
  const std::uint64_t most = this->Bytes.MostBytes();
  if (location > most || allocated > (most - location) / EntryBytes)
  {
    Fail(
      Text("An index within the file is required, got ", allocated, " entries at ", location, "."));
  }
  const std::string index = ReadBytes(this->Bytes, location, allocated * EntryBytes);
  for (std::size_t at = 0; at + EntryBytes <= index.size(); at += EntryBytes)
  {
    const char* const entry = index.data() + at;
    Chunk chunk;
    chunk.Frame = Take<std::uint64_t>(entry);
    chunk.Rows = Take<std::uint64_t>(entry + 8);
    chunk.Location = Take<std::uint64_t>(entry + 16);
    chunk.Columns = Take<std::uint32_t>(entry + 24);
    const auto name = Take<std::uint16_t>(entry + 28);
    chunk.Type = static_cast<unsigned char>(entry[30]);
    if (chunk.Location == 0) // the rest is not used
    {
      return;
    }
    const std::uint64_t size = SizeOfType(chunk.Type);
    const std::uint64_t room = most - std::min(most, chunk.Location);
    if (name >= this->Names.size() || size == 0 || chunk.Frame >= allocated ||
      (chunk.Columns > 0 && chunk.Rows > room / size / chunk.Columns))
    {
      Fail(Text("An index of chunks within the file is required, got ", chunk.Rows, " x ",
        chunk.Columns, " of type ", chunk.Type, " at ", chunk.Location, "."));
    }
    this->Chunks[{ this->Names[name], chunk.Frame }] = chunk;
    this->Frames = std::max(this->Frames, chunk.Frame + 1);
  }
}

std::string GsdFile::Read(const Chunk& chunk) const
{
  const std::uint64_t size = chunk.Rows * chunk.Columns * SizeOfType(chunk.Type);
  std::string bytes = ReadBytes(this->Bytes, chunk.Location, size);
  if (bytes.size() != size)
  {
    Fail(Text("A chunk of ", size, " bytes is required, got ", bytes.size(), "."));
  }
  return bytes;
}

const Chunk* GsdFile::Find(const char* name, std::uint64_t frame, bool particles) const
{
  const auto own = this->Chunks.find({ name, frame });
  if (own != this->Chunks.end())
  {
    return &own->second;
  }
  const auto first = this->Chunks.find({ name, 0 });
  const bool fits = !particles || this->NumberOfParticles(frame) == this->NumberOfParticles(0);
  return first != this->Chunks.end() && fits ? &first->second : nullptr;
}

std::vector<double> GsdFile::Numbers(const char* name, std::uint64_t frame, bool particles,
  std::uint64_t rows, std::uint32_t columns) const
{
  const Chunk* const chunk = this->Find(name, frame, particles);
  if (!chunk)
  {
    return {};
  }
  if (chunk->Rows != rows || chunk->Columns != columns)
  {
    Fail(Text(name, " requires ", rows, " x ", columns, " numbers, got ", chunk->Rows, " x ",
      chunk->Columns, "."));
  }
  const std::string bytes = this->Read(*chunk);
  const std::uint64_t size = SizeOfType(chunk->Type);
  std::vector<double> numbers;
  numbers.reserve(static_cast<std::size_t>(rows * columns));
  for (std::size_t at = 0; at < bytes.size(); at += size)
  {
    const char* const bits = bytes.data() + at;
    switch (chunk->Type)
    {
      case 3:
        numbers.push_back(Take<std::uint32_t>(bits));
        break;
      case 4:
        numbers.push_back(static_cast<double>(Take<std::uint64_t>(bits)));
        break;
      case 9:
        numbers.push_back(Take<float>(bits));
        break;
      case 10:
        numbers.push_back(Take<double>(bits));
        break;
      default:
        Fail(Text(name, " requires numbers of type 3, 4, 9 or 10, got ", chunk->Type, "."));
    }
  }
  return numbers;
}

std::uint64_t GsdFile::NumberOfParticles(std::uint64_t frame) const
{
  for (std::uint64_t place : { frame, std::uint64_t(0) })
  {
    const auto found = this->Chunks.find({ "particles/N", place });
    if (found != this->Chunks.end() && found->second.Rows == 1 && found->second.Columns == 1 &&
      found->second.Type == 3)
    {
      return Take<std::uint32_t>(this->Read(found->second).data());
    }
  }
  return 0;
}

std::uint64_t GsdFile::StepOf(std::uint64_t frame) const
{
  const std::vector<double> step = this->Numbers("configuration/step", frame, false, 1, 1);
  return step.empty() || !(step[0] >= 0.0 && step[0] < 9e15) ? 0
                                                             : static_cast<std::uint64_t>(step[0]);
}

// Diameters of the types whose shape is {"type": "Sphere", "diameter": d}; 0 of others
std::vector<double> DiametersOfShapes(const GsdFile& file, std::uint64_t frame)
{
  std::vector<double> diameters;
  const Chunk* const chunk = file.Find("particles/type_shapes", frame, false);
  if (!chunk || SizeOfType(chunk->Type) != 1)
  {
    return diameters;
  }
  const std::string shapes = file.Read(*chunk);
  for (std::uint64_t row = 0; row < chunk->Rows; ++row)
  {
    const std::string_view shape = std::string_view(shapes).substr(
      static_cast<std::size_t>(row * chunk->Columns), chunk->Columns);
    const std::size_t key = shape.find("\"diameter\"");
    double diameter = 0.0;
    if (shape.find("\"Sphere\"") != shape.npos && key != shape.npos)
    {
      const std::size_t begin = std::min(shape.find_first_not_of(": \t", key + 10), shape.size());
      const std::size_t end = std::min(shape.find_first_of(",} \t", begin), shape.size());
      ParseNumber(shape.substr(begin, end - begin), diameter);
    }
    diameters.push_back(diameter);
  }
  return diameters;
}

void SetRadii(const GsdFile& file, std::uint64_t place, PackFrame& frame)
{
  const std::vector<double> diameters =
    file.Numbers("particles/diameter", place, true, frame.Size(), 1);
  const std::vector<double> shapes = DiametersOfShapes(file, place);
  if (diameters.empty() && shapes.empty())
  {
    return; // 1.0 by default, which nobody meant
  }
  frame.Radius.reserve(frame.Size());
  for (std::size_t i = 0; i < frame.Size(); ++i)
  {
    const auto type = static_cast<std::size_t>(frame.Type.empty() ? 0 : frame.Type[i]);
    const double diameter = !diameters.empty() ? diameters[i]
      : type < shapes.size()                   ? shapes[type]
                                               : 0.0;
    if (!(diameter > 0.0 && std::isfinite(diameter)))
    {
      Fail(Text("A finite diameter > 0 is required, got ", diameter, " of particle ", i, "."));
    }
    frame.Radius.push_back(0.5 * diameter);
  }
}

void SetBoxOf(const GsdFile& file, std::uint64_t place, PackFrame& frame)
{
  const std::vector<double> box = file.Numbers("configuration/box", place, false, 6, 1);
  if (box.empty())
  {
    return;
  }
  FrameCell cell;
  cell.Edges = { Vector3{ box[0], 0, 0 }, { box[3] * box[1], box[1], 0 },
    { box[4] * box[2], box[5] * box[2], box[2] } };
  for (std::size_t q = 0; q < 3; ++q)
  {
    cell.Origin[q] = -0.5 * (cell.Edges[0][q] + cell.Edges[1][q] + cell.Edges[2][q]);
  }
  SetBox(frame, cell, { true, true, true }, true);
}

std::vector<FramePlace> Scan(ByteStream& bytes)
{
  std::vector<FramePlace> places;
  try
  {
    const GsdFile file(bytes);
    for (std::uint64_t frame = 0; frame < file.NumberOfFrames(); ++frame)
    {
      places.push_back({ frame, 0, {}, {} });
      places.back().Time = static_cast<double>(file.StepOf(frame));
    }
  }
  catch (const std::invalid_argument&) // said when the frame is read
  {
  }
  return places.empty() ? ScanOneFrame(bytes) : places;
}

PackFrame Read(ByteStream& bytes, const FramePlace& place, const ReadSettings&)
{
  const GsdFile file(bytes);
  PackFrame frame;
  const std::uint64_t count = file.NumberOfParticles(place.Offset);
  const std::vector<double> centres =
    file.Numbers("particles/position", place.Offset, true, count, 3);
  for (std::size_t i = 0; i + 2 < centres.size(); i += 3)
  {
    for (std::size_t q = 0; q < 3; ++q)
    {
      if (!std::isfinite(centres[i + q]))
      {
        Fail(
          Text("A finite position is required, got ", centres[i + q], " of particle ", i / 3, "."));
      }
    }
    frame.X.push_back(centres[i]);
    frame.Y.push_back(centres[i + 1]);
    frame.Z.push_back(centres[i + 2]);
  }
  for (double type : file.Numbers("particles/typeid", place.Offset, true, count, 1))
  {
    if (!(type >= 0.0 && type <= 2147483647.0))
    {
      Fail(Text("A type from 0 to 2147483647 is required, got ", type, "."));
    }
    frame.Type.push_back(static_cast<int>(type));
  }
  if (frame.Type.size() != frame.Size())
  {
    frame.Type.assign(frame.Size(), 0); // the default
  }
  SetRadii(file, place.Offset, frame);
  SetBoxOf(file, place.Offset, frame);
  frame.Step = static_cast<std::int64_t>(file.StepOf(place.Offset));
  return frame;
}

bool Recognise(std::string_view begin)
{
  return begin.size() >= 8 && Take<std::uint64_t>(begin.data()) == Magic;
}
}

const PackFormat HoomdGsd = { "HOOMD GSD", Recognise, Scan, Read };
}
