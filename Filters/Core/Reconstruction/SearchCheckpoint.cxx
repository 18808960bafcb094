// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/SearchCheckpoint.h"

#include "ruc/Base/Bytes.h"

#include <stdexcept>

namespace ruc
{
namespace
{
constexpr std::string_view Magic = "RUCSTATE";
constexpr std::uint32_t Version = 3;
constexpr const char* What = "checkpoint";
constexpr std::uint64_t GradientMethod = 1, PopulationMethod = 2;

std::uint64_t Checksum(std::string_view bytes)
{
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (unsigned char byte : bytes)
  {
    hash = (hash ^ byte) * 0x100000001b3u;
  }
  return hash;
}

static_assert(sizeof(int) == sizeof(std::int32_t), "states hold their integers as 32 bits");

template <class Value>
std::uint64_t FingerprintOf(const Value& value)
{
  return Checksum(ToBytes(value));
}

// The fingerprint of those settings that make it another search
template <class Settings>
std::uint64_t FingerprintOfSettings(const Settings& settings)
{
  ByteWriter writer;
  Settings::VisitSearch(
    settings, [&](const char*, const auto& value, const Range&) { writer.Put(value); });
  return Checksum(writer.Bytes);
}

template <class State>
std::string Write(const State& state, const SearchKey& key, const SearchStops& stops)
{
  const std::string body = ToBytes(key) + ToBytes(stops) + ToBytes(state);
  ByteWriter writer;
  writer.Bytes = Magic;
  writer.Put(Version);
  writer.Put(body); // writes its length first
  writer.Put(Checksum(writer.Bytes));
  return writer.Bytes;
}

// Returns what stands between head and checksum, once both are checked
std::string_view CheckedBody(std::string_view bytes)
{
  constexpr std::size_t head = Magic.size() + sizeof(std::uint32_t) + sizeof(std::uint64_t);
  const std::string_view start = bytes.substr(0, Magic.size());
  if (bytes.empty() || start != Magic.substr(0, start.size()))
  {
    throw std::invalid_argument("These bytes are no checkpoint of a search.");
  }
  const auto truncated = [&](const std::string& expected)
  {
    throw std::invalid_argument(
      Text("The checkpoint is truncated: ", bytes.size(), " bytes of ", expected, "."));
  };
  if (bytes.size() < head)
  {
    truncated("at least " + std::to_string(head));
  }
  ByteReader reader(bytes.substr(Magic.size()), What);
  const auto version = reader.Get<std::uint32_t>();
  const auto length = reader.Get<std::uint64_t>();
  if (version != Version)
  {
    throw std::invalid_argument(Text(
      "The checkpoint is of version ", version, ", this program reads version ", Version, "."));
  }
  const std::uint64_t rest = bytes.size() - head;
  constexpr std::size_t tail = sizeof(std::uint64_t);
  if (rest < tail || rest - tail < length)
  {
    truncated(Text(head + tail, " + ", length));
  }
  ByteReader last(bytes.substr(bytes.size() - tail), What);
  if (rest - tail > length ||
    last.Get<std::uint64_t>() != Checksum(bytes.substr(0, bytes.size() - tail)))
  {
    throw std::invalid_argument("The checkpoint is damaged: its checksum does not fit.");
  }
  return bytes.substr(head, length);
}

template <class State>
State Read(std::string_view bytes, const SearchKey& key, SearchStops* stops)
{
  ByteReader reader(CheckedBody(bytes), What);
  const auto found = reader.Get<SearchKey>();
  const auto require = [](std::uint64_t place, std::uint64_t expected, const char* what)
  {
    if (place != expected)
    {
      throw std::invalid_argument(Text("The checkpoint is of another search: its ", what,
        ". To begin anew, remove the file or name another one."));
    }
  };
  require(found.Method, key.Method, "method differs");
  require(found.Contents, key.Contents, "cell has other contents");
  require(found.Target, key.Target, "target differs");
  require(found.Settings, key.Settings, "settings or seed differ");
  SearchStops ignored;
  reader.Get(stops ? *stops : ignored);
  State state;
  reader.Get(state);
  reader.Finish();
  return state;
}
}

SearchKey MakeKey(const CellContents& contents, const TwoPointProbability& target,
  const GradientSearchSettings& settings)
{
  return { GradientMethod, FingerprintOf(contents), FingerprintOf(target),
    FingerprintOfSettings(settings) };
}

SearchKey MakeKey(const CellContents& contents, const TwoPointProbability& target,
  const PopulationSettings& settings)
{
  return { PopulationMethod, FingerprintOf(contents), FingerprintOf(target),
    FingerprintOfSettings(settings) };
}

std::string WriteCheckpoint(
  const GradientState& state, const SearchKey& key, const SearchStops& stops)
{
  return Write(state, key, stops);
}

std::string WriteCheckpoint(
  const PopulationState& state, const SearchKey& key, const SearchStops& stops)
{
  return Write(state, key, stops);
}

GradientState ReadGradientCheckpoint(
  std::string_view bytes, const SearchKey& key, SearchStops* stops)
{
  return Read<GradientState>(bytes, key, stops);
}

PopulationState ReadPopulationCheckpoint(
  std::string_view bytes, const SearchKey& key, SearchStops* stops)
{
  return Read<PopulationState>(bytes, key, stops);
}
}
