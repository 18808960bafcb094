// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/SearchCheckpoint.h"

#include "ruc/Base/Text.h"

#include <cstring>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace ruc
{
namespace
{
constexpr std::string_view Magic = "RUCSTATE";
constexpr std::uint32_t Version = 1;
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

// Calls visit for every field of a state, in the order of the format
template <class State, class Visit>
void ForEachField(State& state, Visit&& visit)
{
  using Plain = std::remove_const_t<State>;
  if constexpr (std::is_same_v<Plain, ObjectiveRange>)
  {
    visit(state.Minimum);
    visit(state.Mean);
    visit(state.Maximum);
  }
  else if constexpr (std::is_same_v<Plain, DescentState>)
  {
    visit(state.Place);
    visit(state.Gradient);
    visit(state.Value);
    visit(state.Iterations);
    visit(state.Steps);
    visit(state.GradientChanges);
  }
  else if constexpr (std::is_same_v<Plain, GradientState>)
  {
    visit(state.Descent);
    visit(state.Best);
    visit(state.StartObjective);
    visit(state.Kept);
    visit(state.Tried);
    visit(state.Converged);
    visit(state.Convergence);
  }
  else
  {
    static_assert(std::is_same_v<Plain, PopulationState>);
    visit(state.Generation);
    visit(state.Centres);
    visit(state.Objective);
    visit(state.OverlapPercent);
    visit(state.First);
    visit(state.Temperature);
    visit(state.Stagnation);
    visit(state.Convergence);
    visit(state.Descending);
    visit(state.Descent);
  }
}

class Writer
{
public:
  template <class Value>
  void Put(const Value& value)
  {
    if constexpr (std::is_arithmetic_v<Value>)
    {
      this->Bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    else
    {
      ForEachField(value, [&](const auto& field) { this->Put(field); });
    }
  }
  template <class Value>
  void Put(const std::vector<Value>& values)
  {
    this->Put<std::uint64_t>(values.size());
    for (const Value& value : values)
    {
      this->Put(value);
    }
  }
  void Put(const SearchState& state)
  {
    this->Put(static_cast<std::uint8_t>(state.Phase));
    this->Put(state.Iteration);
    this->Put(state.Objective);
    this->Put(state.OverlapPercent);
  }

  std::string Bytes;
};

// The checksum was compared before, so a length that runs over the end is a fault of the program
// that wrote it.
class Reader
{
public:
  explicit Reader(std::string_view bytes)
    : Rest(bytes)
  {
  }

  template <class Value>
  void Get(Value& value)
  {
    if constexpr (std::is_arithmetic_v<Value>)
    {
      std::memcpy(&value, this->Take(sizeof value).data(), sizeof value);
    }
    else
    {
      ForEachField(value, [&](auto& field) { this->Get(field); });
    }
  }
  template <class Value>
  void Get(std::vector<Value>& values)
  {
    std::uint64_t size = 0;
    this->Get(size);
    this->Require(size <= this->Rest.size());
    values.resize(size);
    for (Value& value : values)
    {
      this->Get(value);
    }
  }
  void Get(SearchState& state)
  {
    std::uint8_t phase = 0;
    this->Get(phase);
    this->Require(phase < static_cast<std::uint8_t>(SearchPhase::Number));
    state.Phase = static_cast<SearchPhase>(phase);
    this->Get(state.Iteration);
    this->Get(state.Objective);
    this->Get(state.OverlapPercent);
  }

  std::string_view Take(std::size_t size)
  {
    this->Require(size <= this->Rest.size());
    const std::string_view taken = this->Rest.substr(0, size);
    this->Rest.remove_prefix(size);
    return taken;
  }
  void Require(bool condition) const
  {
    if (!condition)
    {
      throw std::invalid_argument("The checkpoint is damaged: its lengths do not fit.");
    }
  }

  std::string_view Rest;
};

static_assert(sizeof(int) == sizeof(std::int32_t), "states hold their integers as 32 bits");

std::uint64_t FingerprintOf(const CellContents& contents)
{
  Writer writer;
  writer.Put(contents.Count);
  writer.Put(contents.Radius);
  writer.Put(contents.Edge);
  return Checksum(writer.Bytes);
}

std::uint64_t FingerprintOf(const TwoPointProbability& target)
{
  Writer writer;
  writer.Put(target.Modes);
  writer.Put(target.Lags.Spacing);
  writer.Put(target.Lags.Count);
  writer.Put(target.Fractions);
  writer.Put(target.Values);
  return Checksum(writer.Bytes);
}

template <class State>
std::string Write(const State& state, const SearchKey& key)
{
  Writer body;
  body.Put(key.Method);
  body.Put(key.Contents);
  body.Put(key.Target);
  body.Put(key.Settings);
  body.Put(state);
  Writer writer;
  writer.Bytes = Magic;
  writer.Put(Version);
  writer.Put<std::uint64_t>(body.Bytes.size());
  writer.Bytes += body.Bytes;
  writer.Put(Checksum(writer.Bytes));
  return writer.Bytes;
}

// What stands between head and checksum
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
  Reader reader(bytes.substr(Magic.size()));
  std::uint32_t version = 0;
  std::uint64_t length = 0, checksum = 0;
  reader.Get(version);
  reader.Get(length);
  if (version != Version)
  {
    throw std::invalid_argument(Text(
      "The checkpoint is of version ", version, ", this program reads version ", Version, "."));
  }
  const std::uint64_t rest = bytes.size() - head;
  if (rest < sizeof checksum || rest - sizeof checksum < length)
  {
    truncated(Text(head + sizeof checksum, " + ", length));
  }
  Reader last(bytes.substr(bytes.size() - sizeof checksum));
  last.Get(checksum);
  if (rest - sizeof checksum > length ||
    checksum != Checksum(bytes.substr(0, bytes.size() - sizeof checksum)))
  {
    throw std::invalid_argument("The checkpoint is damaged: its checksum does not fit.");
  }
  return bytes.substr(head, length);
}

template <class State>
State Read(std::string_view bytes, const SearchKey& key)
{
  Reader reader(CheckedBody(bytes));
  SearchKey found;
  const auto require = [&](std::uint64_t& place, std::uint64_t expected, const char* what)
  {
    reader.Get(place);
    if (place != expected)
    {
      throw std::invalid_argument(Text("The checkpoint is of another search: its ", what, "."));
    }
  };
  require(found.Method, key.Method, "method differs");
  require(found.Contents, key.Contents, "cell has other contents");
  require(found.Target, key.Target, "target differs");
  require(found.Settings, key.Settings, "settings or seed differ");
  State state;
  reader.Get(state);
  reader.Require(reader.Rest.empty());
  return state;
}
}

SearchKey MakeKey(const CellContents& contents, const TwoPointProbability& target,
  const GradientSearchSettings& settings)
{
  Writer writer;
  writer.Put(settings.Seed);
  return { GradientMethod, FingerprintOf(contents), FingerprintOf(target), Checksum(writer.Bytes) };
}

SearchKey MakeKey(const CellContents& contents, const TwoPointProbability& target,
  const PopulationSettings& settings)
{
  Writer writer;
  writer.Put(settings.Seed);
  writer.Put(settings.Population);
  writer.Put(settings.RandomShare);
  writer.Put(settings.DepositionDegree);
  writer.Put(settings.MatingPool);
  writer.Put(settings.SelectionPressure);
  writer.Put(settings.HalfOverlap);
  for (double weight : settings.OperatorWeights)
  {
    writer.Put(weight);
  }
  writer.Put(settings.MutatedShare);
  writer.Put(settings.MutationShape);
  writer.Put(settings.MutationReach);
  writer.Put(settings.MutationGenerations);
  writer.Put(settings.MassSpringProbability);
  writer.Put(settings.InitialTemperature);
  writer.Put(settings.CoolingFactor);
  writer.Put(settings.ReheatingGenerations);
  writer.Put(settings.RefinementSteps);
  return { PopulationMethod, FingerprintOf(contents), FingerprintOf(target),
    Checksum(writer.Bytes) };
}

std::string WriteCheckpoint(const GradientState& state, const SearchKey& key)
{
  return Write(state, key);
}

std::string WriteCheckpoint(const PopulationState& state, const SearchKey& key)
{
  return Write(state, key);
}

GradientState ReadGradientCheckpoint(std::string_view bytes, const SearchKey& key)
{
  return Read<GradientState>(bytes, key);
}

PopulationState ReadPopulationCheckpoint(std::string_view bytes, const SearchKey& key)
{
  return Read<PopulationState>(bytes, key);
}
}
