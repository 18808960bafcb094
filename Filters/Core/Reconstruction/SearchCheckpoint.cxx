// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Reconstruction/SearchCheckpoint.h"

#include "Text.h"

#include <algorithm>
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

class Writer
{
public:
  template <class Number>
  void Put(Number number)
  {
    static_assert(std::is_arithmetic_v<Number>);
    this->Bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
  }
  template <class Number>
  void Put(const std::vector<Number>& numbers)
  {
    this->Put<std::uint64_t>(numbers.size());
    for (const Number& number : numbers)
    {
      this->Put(number);
    }
  }
  void Put(const SearchState& state)
  {
    const auto phase = std::find_if(std::begin(SearchPhases), std::end(SearchPhases),
      [&](const char* name) { return std::strcmp(name, state.Phase) == 0; });
    this->Put(static_cast<std::uint8_t>(phase - std::begin(SearchPhases)));
    this->Put<std::int32_t>(state.Iteration);
    this->Put(state.Objective);
    this->Put(state.OverlapPercent);
  }
  void Put(const ObjectiveRange& range)
  {
    this->Put(range.Minimum);
    this->Put(range.Mean);
    this->Put(range.Maximum);
  }
  void Put(const DescentState& state)
  {
    this->Put(state.Place);
    this->Put(state.Gradient);
    this->Put(state.Value);
    this->Put<std::int32_t>(state.Iterations);
    this->Put(state.Steps);
    this->Put(state.GradientChanges);
  }
  void Put(const GradientState& state)
  {
    this->Put(state.Descent);
    this->Put(state.Best);
    this->Put(state.StartObjective);
    this->Put(state.Kept);
    this->Put(state.Tried);
    this->Put(state.Converged);
    this->Put(state.Convergence);
  }
  void Put(const PopulationState& state)
  {
    this->Put<std::int32_t>(state.Generation);
    this->Put(state.Centres);
    this->Put(state.Objective);
    this->Put(state.OverlapPercent);
    this->Put(state.First);
    this->Put(state.Temperature);
    this->Put<std::int32_t>(state.Stagnation);
    this->Put(state.Convergence);
    this->Put<std::int32_t>(state.Descending);
    this->Put(state.Descent);
  }

  std::string Bytes;
};

// Reads in the order of Writer. The checksum was compared before, so a length that runs over the
// end is a fault of the program that wrote it.
class Reader
{
public:
  explicit Reader(std::string_view bytes)
    : Rest(bytes)
  {
  }

  template <class Number>
  void Get(Number& number)
  {
    static_assert(std::is_arithmetic_v<Number>);
    std::memcpy(&number, this->Take(sizeof number).data(), sizeof number);
  }
  template <class Number>
  void Get(std::vector<Number>& numbers)
  {
    std::uint64_t size = 0;
    this->Get(size);
    this->Require(size <= this->Rest.size());
    numbers.resize(size);
    for (Number& number : numbers)
    {
      this->Get(number);
    }
  }
  void Get(SearchState& state)
  {
    std::uint8_t phase = 0;
    this->Get(phase);
    this->Require(phase < std::size(SearchPhases));
    state.Phase = SearchPhases[phase];
    this->Get(state.Iteration);
    this->Get(state.Objective);
    this->Get(state.OverlapPercent);
  }
  void Get(ObjectiveRange& range)
  {
    this->Get(range.Minimum);
    this->Get(range.Mean);
    this->Get(range.Maximum);
  }
  void Get(DescentState& state)
  {
    this->Get(state.Place);
    this->Get(state.Gradient);
    this->Get(state.Value);
    this->Get(state.Iterations);
    this->Get(state.Steps);
    this->Get(state.GradientChanges);
  }
  void Get(GradientState& state)
  {
    this->Get(state.Descent);
    this->Get(state.Best);
    this->Get(state.StartObjective);
    this->Get(state.Kept);
    this->Get(state.Tried);
    this->Get(state.Converged);
    this->Get(state.Convergence);
  }
  void Get(PopulationState& state)
  {
    this->Get(state.Generation);
    this->Get(state.Centres);
    this->Get(state.Objective);
    this->Get(state.OverlapPercent);
    this->Get(state.First);
    this->Get(state.Temperature);
    this->Get(state.Stagnation);
    this->Get(state.Convergence);
    this->Get(state.Descending);
    this->Get(state.Descent);
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
