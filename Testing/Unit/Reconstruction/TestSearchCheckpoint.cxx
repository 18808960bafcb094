// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/SearchCheckpoint.h"

#include "SearchProblem.h"
#include "ThreadRanks.h"

#include <cstring>

namespace
{
using ruc::GradientSearchSettings;
using ruc::GradientState;
using ruc::PopulationSettings;
using ruc::PopulationState;
using ruc::SearchKey;
using ruc::SearchState;
using ruc::UnitCell;

GradientSearchSettings Gradient(int iterations)
{
  GradientSearchSettings settings;
  settings.MaximumIterations = iterations;
  return settings;
}

PopulationSettings Population(int generations)
{
  PopulationSettings settings;
  settings.Population = 8;
  settings.MatingPool = 3;
  settings.MaximumGenerations = generations;
  settings.RefinementSteps = 10;
  return settings;
}

template <class Settings>
SearchKey KeyOf(const Settings& settings)
{
  return ruc::MakeKey(TheSearchProblem().Contents, TheSearchProblem().Target, settings);
}

UnitCell Search(const GradientSearchSettings& settings, ruc::Communicator& ranks,
  const GradientState* resume = nullptr, const std::function<void(const GradientState&)>& save = {},
  const std::function<bool(const SearchState&)>& carryOn = CarryOn)
{
  return ruc::SearchByGradient(
    TheSearchProblem().Contents, TheSearchProblem().Target, settings, ranks, carryOn, resume, save);
}

// A small state with every member set
PopulationState SmallState()
{
  PopulationState state;
  state.Generation = 3;
  state.Centres = { { 1.0, 2.0, 3.0 }, { 4.0, -0.0, 1e-300 } };
  state.Objective = { 0.5, 0.25 };
  state.OverlapPercent = { 0.0, 1.5 };
  state.First = { 1.0, 2.0, 3.0 };
  state.Temperature = 0.125;
  state.Stagnation = 2;
  state.Convergence = { { ruc::SearchPhase::AnnealingPopulation, 0, 0.75, 0.5, 0.0, {} },
    { ruc::SearchPhase::RemovingOverlap, 1, 0.5, 0.0, 0.7, { 0.1, 0.2, 0.3 } } };
  state.Descending = 1;
  state.Descent = { { 1.0, 2.0 }, { 3.0, 4.0 }, 5.0, 6, { { 7.0, 8.0 } }, { { 9.0, 10.0 } } };
  return state;
}

const SearchKey SmallKey = { 2, 11, 12, 13 };

// FNV-1a-64 as published, of all but the last eight bytes
std::uint64_t Checksum(const std::string& bytes)
{
  std::uint64_t hash = 14695981039346656037u;
  for (std::size_t n = 0; n + 8 < bytes.size(); ++n)
  {
    hash ^= static_cast<unsigned char>(bytes[n]);
    hash *= 1099511628211u;
  }
  return hash;
}

std::string Refusal(std::string_view bytes, const SearchKey& key = SmallKey)
{
  return oracle::MessageOf([&]() { ruc::ReadPopulationCheckpoint(bytes, key); });
}
}

TEST(SearchCheckpoint, KeepsEveryNumber)
{
  const PopulationState state = SmallState();
  const PopulationState read =
    ruc::ReadPopulationCheckpoint(ruc::WriteCheckpoint(state, SmallKey), SmallKey);
  EXPECT_EQ(read.Generation, state.Generation);
  EXPECT_EQ(read.Centres, state.Centres);
  EXPECT_TRUE(std::signbit(read.Centres[1][1]));
  EXPECT_EQ(read.Objective, state.Objective);
  EXPECT_EQ(read.OverlapPercent, state.OverlapPercent);
  EXPECT_EQ(read.First.Minimum, 1.0);
  EXPECT_EQ(read.First.Mean, 2.0);
  EXPECT_EQ(read.First.Maximum, 3.0);
  EXPECT_EQ(read.Temperature, state.Temperature);
  EXPECT_EQ(read.Stagnation, state.Stagnation);
  ASSERT_EQ(read.Convergence.size(), 2u);
  EXPECT_EQ(read.Convergence[1].Phase, ruc::SearchPhase::RemovingOverlap);
  EXPECT_EQ(read.Convergence[0].Phase, ruc::SearchPhase::AnnealingPopulation);
  EXPECT_EQ(read.Convergence[0].Objective, 0.75);
  EXPECT_EQ(read.Convergence[0].OverlapPercent, 0.5);
  EXPECT_EQ(read.Convergence[1].Iteration, 1);
  EXPECT_EQ(read.Descending, 1);
  EXPECT_EQ(read.Descent.Place, state.Descent.Place);
  EXPECT_EQ(read.Descent.Gradient, state.Descent.Gradient);
  EXPECT_EQ(read.Descent.Value, 5.0);
  EXPECT_EQ(read.Descent.Iterations, 6);
  EXPECT_EQ(read.Descent.Steps, state.Descent.Steps);
  EXPECT_EQ(read.Descent.GradientChanges, state.Descent.GradientChanges);
}

TEST(SearchCheckpoint, KeepsTheStops)
{
  const ruc::SearchStops stops = { 3, true, std::string("shown\0then", 10) };
  const std::string bytes = ruc::WriteCheckpoint(SmallState(), SmallKey, stops);
  ruc::SearchStops read;
  EXPECT_EQ(ruc::ReadPopulationCheckpoint(bytes, SmallKey, &read).Centres, SmallState().Centres);
  EXPECT_EQ(read.Count, 3);
  EXPECT_TRUE(read.BeforeState);
  EXPECT_EQ(read.Shown, stops.Shown);
  ruc::ReadPopulationCheckpoint(ruc::WriteCheckpoint(SmallState(), SmallKey), SmallKey, &read);
  EXPECT_EQ(read.Count, 0);
  EXPECT_FALSE(read.BeforeState);
  EXPECT_TRUE(read.Shown.empty());
}

TEST(SearchCheckpoint, StartsAsTheHeaderSays)
{
  const std::string bytes = ruc::WriteCheckpoint(SmallState(), SmallKey);
  EXPECT_EQ(bytes.substr(0, 8), "RUCSTATE");
  EXPECT_EQ(bytes.substr(8, 4), std::string("\5\0\0\0", 4));
  std::uint64_t length = 0, key = 0, checksum = 0;
  std::memcpy(&length, &bytes[12], 8);
  EXPECT_EQ(length, bytes.size() - 28);
  std::memcpy(&key, &bytes[28], 8);
  EXPECT_EQ(key, SmallKey.Contents);
  std::memcpy(&checksum, &bytes[bytes.size() - 8], 8);
  EXPECT_EQ(checksum, Checksum(bytes));
}

TEST(SearchCheckpoint, EveryTruncatedLengthIsRefused)
{
  const std::string bytes = ruc::WriteCheckpoint(SmallState(), SmallKey);
  EXPECT_NE(Refusal("").find("no checkpoint"), std::string::npos);
  for (std::size_t length = 1; length < bytes.size(); ++length)
  {
    EXPECT_NE(
      Refusal(std::string_view(bytes).substr(0, length)).find("truncated"), std::string::npos)
      << length;
  }
  EXPECT_NE(Refusal(bytes + "x").find("damaged"), std::string::npos);
}

TEST(SearchCheckpoint, EveryFlippedBitIsRefused)
{
  const std::string bytes = ruc::WriteCheckpoint(SmallState(), SmallKey);
  for (std::size_t n = 0; n < bytes.size(); ++n)
  {
    for (int bit = 0; bit < 8; ++bit)
    {
      std::string damaged = bytes;
      damaged[n] = static_cast<char>(damaged[n] ^ (1 << bit));
      const std::string message = Refusal(damaged);
      const char* expected = n < 8 ? "no checkpoint" : n < 12 ? "version" : "";
      EXPECT_NE(message.find("checkpoint"), std::string::npos) << n << ": " << message;
      EXPECT_NE(message.find(expected), std::string::npos) << n << ": " << message;
      if (n >= 20) // past the length
      {
        EXPECT_NE(message.find("damaged"), std::string::npos) << n << ": " << message;
      }
    }
  }
}

TEST(SearchCheckpoint, AValueThatCannotBeIsRefused)
{
  // One byte is forged together with the checksum, found from two states that differ in it alone
  const auto forge = [](const std::string& a, const std::string& b, char value)
  {
    const std::size_t place = std::mismatch(a.begin(), a.end(), b.begin()).first - a.begin();
    std::string forged = a;
    forged[place] = value;
    const std::uint64_t hash = Checksum(forged);
    std::memcpy(&forged[forged.size() - 8], &hash, 8);
    return forged;
  };
  const char* cannotBe = "The checkpoint is damaged: it holds a value that cannot be.";
  const SearchKey key = { 1, 11, 12, 13 };
  GradientState state, converged;
  converged.Converged = true;
  const std::string a = ruc::WriteCheckpoint(state, key), b = ruc::WriteCheckpoint(converged, key);
  EXPECT_TRUE(ruc::ReadGradientCheckpoint(forge(a, b, 1), key).Converged);
  EXPECT_SAYS(ruc::ReadGradientCheckpoint(forge(a, b, 2), key), cannotBe);

  PopulationState other = SmallState();
  other.Convergence[0].Phase = ruc::SearchPhase::RemovingOverlap;
  const std::string c = ruc::WriteCheckpoint(SmallState(), SmallKey),
                    d = ruc::WriteCheckpoint(other, SmallKey);
  EXPECT_EQ(Refusal(forge(c, d, 3)), "<no exception>");
  for (int phase : { 4, 255 })
  {
    EXPECT_EQ(Refusal(forge(c, d, static_cast<char>(phase))), cannotBe);
  }
}

TEST(SearchCheckpoint, OtherBytesAreRefused)
{
  EXPECT_NE(Refusal("x,y,z,radius\n1,2,3,4\n").find("no checkpoint"), std::string::npos);
  EXPECT_NE(Refusal(std::string(1000, '\0')).find("no checkpoint"), std::string::npos);
  std::string later = ruc::WriteCheckpoint(SmallState(), SmallKey);
  later[8] = 6;
  EXPECT_NE(Refusal(later).find("of version 6, this program reads version 5"), std::string::npos);
}

TEST(SearchCheckpoint, OfAnotherSearchIsRefusedWithTheReason)
{
  const std::string bytes = ruc::WriteCheckpoint(SmallState(), SmallKey);
  EXPECT_NE(Refusal(bytes, { 1, 11, 12, 13 }).find("its method differs"), std::string::npos);
  EXPECT_NE(Refusal(bytes, { 2, 0, 12, 13 }).find("other contents"), std::string::npos);
  EXPECT_NE(Refusal(bytes, { 2, 11, 0, 13 }).find("its target differs"), std::string::npos);
  EXPECT_NE(
    Refusal(bytes, { 2, 11, 12, 0 }).find("its settings or seed differ"), std::string::npos);
  const std::string gradient = ruc::WriteCheckpoint(GradientState(), KeyOf(Gradient(1)));
  EXPECT_SAYS(ruc::ReadPopulationCheckpoint(gradient, KeyOf(Population(1))), "its method differs");
}

TEST(SearchCheckpoint, TheKeyTellsSearchesApart)
{
  const ruc::CellContents& contents = TheSearchProblem().Contents;
  const ruc::TwoPointProbability& target = TheSearchProblem().Target;
  const SearchKey key = KeyOf(PopulationSettings());
  EXPECT_NE(key.Method, KeyOf(Gradient(1)).Method);

  ruc::CellContents other = contents;
  ++other.Count[0];
  EXPECT_NE(key.Contents, ruc::MakeKey(other, target, PopulationSettings()).Contents);
  other = contents;
  other.Edge = std::nextafter(other.Edge, 1e9);
  EXPECT_NE(key.Contents, ruc::MakeKey(other, target, PopulationSettings()).Contents);

  ruc::TwoPointProbability changed = target;
  changed.Values[1][3] += 1e-16;
  EXPECT_NE(key.Target, ruc::MakeKey(contents, changed, PopulationSettings()).Target);
  changed = target;
  changed.Lags.Spacing *= 2.0;
  EXPECT_NE(key.Target, ruc::MakeKey(contents, changed, PopulationSettings()).Target);

  const std::function<void(PopulationSettings&)> changes[] = {
    [](PopulationSettings& s) { ++s.Seed; },
    [](PopulationSettings& s) { ++s.Population; },
    [](PopulationSettings& s) { s.RandomShare = 0.25; },
    [](PopulationSettings& s) { s.DepositionDegree = 0.125; },
    [](PopulationSettings& s) { ++s.MatingPool; },
    [](PopulationSettings& s) { s.SelectionPressure = 1.75; },
    [](PopulationSettings& s) { s.HalfOverlap = 2.0; },
    [](PopulationSettings& s) { s.OperatorWeights[7] = 0.5; },
    [](PopulationSettings& s) { s.MutatedShare = 0.5; },
    [](PopulationSettings& s) { s.MutationShape = 1.0; },
    [](PopulationSettings& s) { s.MutationReach = 0.5; },
    [](PopulationSettings& s) { ++s.MutationGenerations; },
    [](PopulationSettings& s) { s.MassSpringProbability = 0.5; },
    [](PopulationSettings& s) { s.InitialTemperature = 0.5; },
    [](PopulationSettings& s) { s.CoolingFactor = 0.5; },
    [](PopulationSettings& s) { ++s.ReheatingGenerations; },
    [](PopulationSettings& s) { ++s.RefinementSteps; },
  };
  for (const auto& change : changes)
  {
    PopulationSettings settings;
    change(settings);
    EXPECT_NE(KeyOf(settings).Settings, key.Settings);
  }
  GradientSearchSettings seeded;
  seeded.Seed = 2;
  EXPECT_NE(KeyOf(seeded).Settings, KeyOf(GradientSearchSettings()).Settings);
}

TEST(SearchCheckpoint, WhatOnlyEndsASearchMayChange)
{
  PopulationSettings settings;
  const SearchKey key = KeyOf(settings);
  settings.MaximumGenerations = 1;
  settings.PatienceGenerations = 1;
  settings.TargetObjective = 1.0;
  EXPECT_EQ(KeyOf(settings).Settings, key.Settings);
  GradientSearchSettings gradient = Gradient(7);
  gradient.TargetObjective = 1.0;
  EXPECT_EQ(KeyOf(gradient).Settings, KeyOf(Gradient(1)).Settings);
}

TEST(SearchCheckpoint, AGradientSearchResumesFromItToTheSameEnd)
{
  ruc::Communicator serial;
  const SearchKey key = KeyOf(Gradient(1));
  std::vector<std::string> saved;
  const UnitCell whole = Search(Gradient(130), serial, nullptr,
    [&](const GradientState& state) { saved.push_back(ruc::WriteCheckpoint(state, key)); });
  ASSERT_EQ(saved.size(), 130u);
  for (std::size_t n : { 0u, 1u, 50u, 98u, 99u, 100u, 128u })
  {
    const GradientState state = ruc::ReadGradientCheckpoint(saved[n], key);
    ExpectEqual(whole, Search(Gradient(130), serial, &state));
  }
  for (int ranks : { 2, 3 })
  {
    oracle::ThreadRanks::Run(ranks,
      [&](ruc::Communicator& communicator)
      {
        const GradientState state = ruc::ReadGradientCheckpoint(saved[70], key);
        ExpectEqual(whole, Search(Gradient(130), communicator, &state));
      });
  }
}

TEST(SearchCheckpoint, AStoppedGradientSearchLosesNothing)
{
  ruc::Communicator serial;
  const UnitCell whole = Search(Gradient(130), serial);
  for (int stopAt : { 3, 60, 101, 102 })
  {
    GradientState last;
    const UnitCell stopped = Search(
      Gradient(130), serial, nullptr, [&](const GradientState& state) { last = state; },
      [&](const SearchState& state) { return state.Iteration < stopAt; });
    EXPECT_EQ(stopped.EndedBy, ruc::EndReason::Stopped);
    ExpectEqual(whole, Search(Gradient(130), serial, &last));
  }
}

TEST(SearchCheckpoint, AFinishedGradientSearchIsCarriedOn)
{
  ruc::Communicator serial;
  GradientState last;
  Search(Gradient(40), serial, nullptr, [&](const GradientState& state) { last = state; });
  ExpectEqual(Search(Gradient(90), serial), Search(Gradient(90), serial, &last));
}

TEST(SearchCheckpoint, AGradientStateOfAnotherCellIsRefused)
{
  ruc::Communicator serial;
  GradientState last;
  Search(Gradient(2), serial, nullptr, [&](const GradientState& state) { last = state; });
  last.Best.pop_back();
  EXPECT_SAYS(Search(Gradient(5), serial, &last), "Resuming requires a state of 40 spheres");
}

TEST(SearchCheckpoint, APopulationSearchResumesFromItToTheSameEnd)
{
  ruc::Communicator serial;
  const PopulationSettings settings = Population(6);
  const SearchKey key = KeyOf(settings);
  std::vector<std::string> saved;
  const auto search = [&](ruc::Communicator& ranks, const PopulationState* resume,
                        const std::function<void(const PopulationState&)>& save)
  {
    return ruc::SearchByPopulation(TheSearchProblem().Contents, TheSearchProblem().Target, settings,
      ranks, CarryOn, resume, save)
      .Best;
  };
  const UnitCell whole = search(serial, nullptr,
    [&](const PopulationState& state) { saved.push_back(ruc::WriteCheckpoint(state, key)); });
  ASSERT_EQ(saved.size(), 7u);
  for (const std::string& bytes : saved)
  {
    const PopulationState state = ruc::ReadPopulationCheckpoint(bytes, key);
    EXPECT_EQ(ruc::WriteCheckpoint(state, key), bytes);
    ExpectEqual(whole, search(serial, &state, {}));
  }
  oracle::ThreadRanks::Run(3,
    [&](ruc::Communicator& communicator)
    {
      const PopulationState state = ruc::ReadPopulationCheckpoint(saved[2], key);
      ExpectEqual(whole, search(communicator, &state, {}));
    });
}
