// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/SearchCheckpoint.h"

#include "ruc/Base/Bytes.h"
#include "ruc/Base/SealedBytes.h"

#include <stdexcept>

namespace ruc
{
namespace
{
constexpr std::string_view Format = "RUCSTATE";
constexpr std::uint32_t Version = 5;
constexpr const char* What = "checkpoint";
constexpr std::uint64_t GradientMethod = 1, PopulationMethod = 2;

static_assert(sizeof(int) == sizeof(std::int32_t), "states hold their integers as 32 bits");

template <class Value>
std::uint64_t FingerprintOf(const Value& value)
{
  return FingerprintOfBytes(ToBytes(value));
}

// The fingerprint of those settings that make it another search
template <class Settings>
std::uint64_t FingerprintOfSettings(const Settings& settings)
{
  ByteWriter writer;
  Settings::VisitSearch(
    settings, [&](const char*, const auto& value, const Range&) { writer.Put(value); });
  return FingerprintOfBytes(writer.Bytes);
}

template <class State>
std::string Write(const State& state, const SearchKey& key, const SearchStops& stops)
{
  return SealBytes(Format, Version, ToBytes(key) + ToBytes(stops) + ToBytes(state));
}

template <class State>
State Read(std::string_view bytes, const SearchKey& key, SearchStops* stops)
{
  ByteReader reader(UnsealBytes(bytes, Format, Version, "a search"), What);
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
  const NeighbourTarget& neighbours = settings.Neighbours;
  return { GradientMethod, FingerprintOf(contents),
    neighbours.Empty() ? FingerprintOf(target)
                       : FingerprintOfBytes(ToBytes(target) + ToBytes(neighbours.Pack) +
                           ToBytes(neighbours.Spectrum) + ToBytes(neighbours.ThirdOrder)),
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
