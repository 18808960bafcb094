// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Packs that go on from a state on the way end as if they had never been stopped
#include "ruc/Packing/DensePackCheckpoint.h"
#include "ruc/Packing/SphereSizes.h"

#include "PackingOracles.h"

namespace
{
using oracle::Always;
using oracle::Equal;

void ExpectSame(const ruc::DensePack& a, const ruc::DensePack& b)
{
  EXPECT_TRUE(a.Pack.X == b.Pack.X && a.Pack.Y == b.Pack.Y && a.Pack.Z == b.Pack.Z);
  EXPECT_EQ(a.Pack.Radius, b.Pack.Radius);
  EXPECT_EQ(a.Box, b.Box);
  EXPECT_EQ(a.Fraction, b.Fraction);
  EXPECT_EQ(a.Jammed, b.Jammed);
  EXPECT_EQ(a.IsSoft, b.IsSoft);
  ASSERT_EQ(a.History.size(), b.History.size());
  for (std::size_t n = 0; n < a.History.size(); ++n)
  {
    EXPECT_EQ(a.History[n].Rate, b.History[n].Rate);
    EXPECT_EQ(a.History[n].Fraction, b.History[n].Fraction);
    EXPECT_EQ(a.History[n].ReducedPressure, b.History[n].ReducedPressure);
    EXPECT_EQ(a.History[n].Collisions, b.History[n].Collisions);
  }
}

// From every state, as a file holds it
void ExpectToResume(const ruc::DensePackSettings& settings)
{
  std::vector<std::string> states;
  const ruc::DensePack whole = ruc::MakeDensePack(settings, Always, nullptr,
    [&](const ruc::DensePackState& state)
    { states.push_back(ruc::WriteCheckpoint(state, settings)); });
  ASSERT_GT(states.size(), 1u);
  const std::size_t step = 1 + states.size() / 6;
  for (std::size_t n = 0; n < states.size(); n += step)
  {
    const ruc::DensePackState state = ruc::ReadDensePackCheckpoint(states[n], settings);
    ExpectSame(ruc::MakeDensePack(settings, Always, &state), whole);
  }
  const ruc::DensePackState last = ruc::ReadDensePackCheckpoint(states.back(), settings);
  ExpectSame(ruc::MakeDensePack(settings, Always, &last), whole);
}

std::string Refusal(std::string_view bytes, const ruc::DensePackSettings& settings)
{
  try
  {
    ruc::ReadDensePackCheckpoint(bytes, settings);
    return "<no exception>";
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
}

ruc::DensePackState StateOf(const ruc::DensePackSettings& settings)
{
  ruc::DensePackState found;
  ruc::MakeDensePack(settings, Always, nullptr,
    [&](const ruc::DensePackState& state) { found = found.History.empty() ? state : found; });
  return found;
}
}

// Spheres that are pushed apart, some of them shaken, to the end or to where they begin to grow
TEST(DensePackCheckpoint, SpheresThatArePushedApart)
{
  ruc::DensePackSettings settings = Equal(300, 0.615);
  settings.Protocol = ruc::PackingProtocol::Soft;
  ExpectToResume(settings);
  settings.Periodic = { true, true, false };
  settings.Fraction = 0.58;
  ExpectToResume(settings);
}

TEST(DensePackCheckpoint, PushingThatWasStoppedGoesOn)
{
  ruc::DensePackSettings settings = Equal(300, 0.61);
  settings.Protocol = ruc::PackingProtocol::Soft;
  const ruc::DensePack whole = ruc::MakeDensePack(settings, Always);
  std::optional<ruc::DensePackState> last;
  int stops = 0;
  for (bool stopped = true; stopped; ++stops)
  {
    const std::optional<ruc::DensePackState> resume = last;
    int calls = 0;
    const ruc::DensePack pack = ruc::MakeDensePack(
      settings, [&](const ruc::GrowthStep&, double) { return ++calls < 5; },
      resume ? &*resume : nullptr, [&](const ruc::DensePackState& state) { last = state; });
    stopped = pack.Stopped;
    if (!stopped)
    {
      ExpectSame(pack, whole);
    }
  }
  EXPECT_GT(stops, 2);
}

TEST(DensePackCheckpoint, GrowthOfEqualSpheres)
{
  ExpectToResume(Equal(200, 0.635));
}

// It jams, and is tried again more slowly
TEST(DensePackCheckpoint, GrowthThatJams)
{
  ExpectToResume(Equal(18, 0.658));
}

TEST(DensePackCheckpoint, SizesThatAreExchanged)
{
  ruc::SphereSizes sizes;
  sizes.Law = ruc::SizeLaw::LogNormal;
  sizes.StandardDeviation = 0.5;
  ruc::DensePackSettings settings;
  settings.Radii = sizes.Make(300).Radius;
  settings.Fraction = 0.66;
  settings.Exchange = true;
  ExpectToResume(settings);
}

TEST(DensePackCheckpoint, EquilibrationBetweenWalls)
{
  ruc::DensePackSettings settings = Equal(150, 0.40);
  settings.Periodic = { true, false, true };
  settings.Equilibration = 400.0;
  ExpectToResume(settings); // of a soft pack
  settings.Protocol = ruc::PackingProtocol::Events;
  ExpectToResume(settings);
}

TEST(DensePackCheckpoint, APackThatWasStoppedGoesOn)
{
  const ruc::DensePackSettings settings = Equal(200, 0.63);
  const ruc::DensePack whole = ruc::MakeDensePack(settings, Always);
  std::optional<ruc::DensePackState> last;
  int stops = 0;
  for (bool stopped = true; stopped; ++stops)
  {
    const std::optional<ruc::DensePackState> resume = last;
    int rounds = 0;
    const ruc::DensePack pack = ruc::MakeDensePack(
      settings,
      [&](const ruc::GrowthStep& step, double) { return step.Collisions == 0.0 || ++rounds < 4; },
      resume ? &*resume : nullptr, [&](const ruc::DensePackState& state) { last = state; });
    stopped = pack.Stopped;
    if (!stopped)
    {
      ExpectSame(pack, whole);
    }
  }
  EXPECT_GT(stops, 1);
}

TEST(DensePackCheckpoint, OtherBytesAreRefused)
{
  const ruc::DensePackSettings settings = Equal(100, 0.62);
  const std::string good = ruc::WriteCheckpoint(StateOf(settings), settings);
  EXPECT_EQ(Refusal(good, settings), "<no exception>");
  EXPECT_EQ(Refusal("x,y,z", settings), "These bytes are no checkpoint of a pack.");
  EXPECT_NE(
    Refusal(good.substr(0, good.size() / 2), settings).find("truncated"), std::string::npos);
  std::string damaged = good;
  damaged[good.size() / 2] ^= 1;
  EXPECT_NE(Refusal(damaged, settings).find("damaged"), std::string::npos);
  ruc::DensePackSettings other = settings;
  other.Seed = 2;
  EXPECT_NE(Refusal(good, other).find("other settings"), std::string::npos);
  EXPECT_NE(Refusal(good, Equal(100, 0.621)).find("other settings"), std::string::npos);
}

TEST(DensePackCheckpoint, AForgedStateIsRefused)
{
  const ruc::DensePackSettings settings = Equal(100, 0.62);
  const ruc::DensePackState good = StateOf(settings);
  const auto refuses = [&](const std::function<void(ruc::DensePackState&)>& forge)
  {
    ruc::DensePackState state = good;
    forge(state);
    EXPECT_NE(Refusal(ruc::WriteCheckpoint(state, settings), settings), "<no exception>");
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refuses([&](ruc::DensePackState& state) { state.Rate = nan; });
  refuses([&](ruc::DensePackState& state) { state.Fraction = 0.7; });
  refuses([&](ruc::DensePackState& state) { state.Spheres.Spheres.pop_back(); });
  refuses([&](ruc::DensePackState& state) { state.Spheres.Spheres[3].Place[1] = nan; });
  refuses([&](ruc::DensePackState& state) { state.Spheres.Near[0].push_back(100); });
  refuses([&](ruc::DensePackState& state) { state.Spheres.Near[0].pop_back(); });
  refuses([&](ruc::DensePackState& state) { state.Spheres.Order[0] = state.Spheres.Order[1]; });
  refuses([&](ruc::DensePackState& state) { state.Spheres.Unit = 0.0; });
  refuses([&](ruc::DensePackState& state) { state.At = ruc::DensePackState::Stage(3); });
  refuses(
    [&](ruc::DensePackState& state) { state.At = ruc::DensePackState::Stage::Equilibrating; });
  refuses([&](ruc::DensePackState& state) { state.At = ruc::DensePackState::Stage::Pushing; });
  // Too large for the grid
  ruc::DensePackState large = good;
  large.Spheres.Reach[0] *= 10.0;
  EXPECT_THROW(ruc::MakeDensePack(settings, Always, &large), std::invalid_argument);
}

TEST(DensePackCheckpoint, AForgedStateOfPushingIsRefused)
{
  ruc::DensePackSettings settings = Equal(300, 0.61);
  settings.Protocol = ruc::PackingProtocol::Soft;
  ruc::DensePackState good;
  ruc::MakeDensePack(
    settings, Always, nullptr, [&](const ruc::DensePackState& state) { good = state; });
  ASSERT_EQ(good.At, ruc::DensePackState::Stage::Pushing);
  EXPECT_EQ(Refusal(ruc::WriteCheckpoint(good, settings), settings), "<no exception>");
  const auto refuses = [&](const std::function<void(ruc::OverlapRemovalState&)>& forge)
  {
    ruc::DensePackState state = good;
    forge(state.Removal);
    EXPECT_NE(Refusal(ruc::WriteCheckpoint(state, settings), settings), "<no exception>");
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refuses([](ruc::OverlapRemovalState& state) { state.Attempt = 10; });
  refuses([](ruc::OverlapRemovalState& state) { state.Descent.Iterations = 4000; });
  refuses([](ruc::OverlapRemovalState& state) { state.Descent.Place.pop_back(); });
  refuses([](ruc::OverlapRemovalState& state) { state.Descent.Gradient.clear(); });
  refuses([](ruc::OverlapRemovalState& state) { state.Descent.Steps.pop_back(); });
  refuses([](ruc::OverlapRemovalState& state) { state.Descent.GradientChanges[0].push_back(0.0); });
  refuses([&](ruc::OverlapRemovalState& state) { state.Descent.Steps[1][2] = nan; });
  refuses([&](ruc::OverlapRemovalState& state) { state.Descent.Value = nan; });
}
