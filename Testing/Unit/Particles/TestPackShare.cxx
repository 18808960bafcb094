// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Particles/PackShare.h"

#include "Oracles.h"
#include "ThreadRanks.h"
#include "ruc/Particles/PackOverlap.h"
#include "ruc/Particles/PairNeighbourhood.h"
#include "ruc/Statistics/PairSums/ExactPairSum.h"
#include "ruc/Statistics/Results/OnePointProbability.h"

#include <map>
#include <mutex>
#include <numeric>
#include <set>

namespace
{
using ruc::SpherePack;
using ruc::Window;

const std::vector<Window> Windows = {
  oracle::PeriodicCube(10.0),
  Window::MakeBox({ 0, 0, 0 }, { 10, 10, 10 }, { false, false, false }),
  Window::MakeBox({ 0, 0, 0 }, { 10, 10, 10 }, { true, false, true }),
  Window::MakeCylinder({ 5, 5, 0 }, { 0.0, 0.0, 1.0 }, 5.0, 10.0),
};

SpherePack PackIn(const Window& window, const std::vector<double>& radii, std::uint64_t seed)
{
  return ruc::CropToWindow(
    oracle::RelaxedPack({ 90, 140 }, radii, oracle::PeriodicCube(10.0), seed), window);
}
}

TEST(PackShare, AModeOfTinySpheresKeepsItsVolume)
{
  const Window box = oracle::PeriodicCube(10.0);
  for (double tiny : { 1e-2, 1e-3, 1e-5, 1e-6, 1e-12 })
  {
    SpherePack pack = oracle::RandomPack({ 1, 40 }, { 1.0, tiny }, box, 5);
    for (std::size_t i = 1; i < pack.Size(); i += 2)
    {
      pack.Radius[i] *= 0.5;
    }
    const double cubes = 20 * std::pow(tiny, 3) * (1.0 + 0.125);
    const double squares = 20 * tiny * tiny * (1.0 + 0.25);
    for (int size : { 1, 3 })
    {
      oracle::ThreadRanks::Run(size,
        [&](ruc::Communicator& ranks)
        {
          const ruc::PackShare share =
            ruc::SharePack(oracle::PieceOf(pack, ranks.Rank(), size, false), box, true, ranks);
          // The error is half a unit of 2^-50 of the largest sphere's cube, or of the mode's
          // largest if that is smaller by more than 2^10
          EXPECT_NEAR(share.Volume[1] / (4.0 / 3.0 * oracle::Pi * cubes), 1.0, 1e-6);
          EXPECT_NEAR(share.Surface[1] / (4.0 * oracle::Pi * squares), 1.0, 1e-6);
          EXPECT_EQ(share.Volume, ruc::SharePack(pack, box).Volume);
        });
    }
  }
}

TEST(PackShare, EverySphereHasOneOwnerAndSharesAreEven)
{
  const Window box = oracle::PeriodicCube(10.0);
  const SpherePack pack = oracle::RandomPack({ 2000, 3000 }, { 0.2, 0.1 }, box, 5);
  for (int size : { 1, 2, 3, 7 })
  {
    for (bool allOnLast : { false, true })
    {
      std::mutex mutex;
      std::multiset<std::array<double, 5>> found;
      oracle::ThreadRanks::Run(size,
        [&](ruc::Communicator& ranks)
        {
          const ruc::PackShare share =
            ruc::SharePack(oracle::PieceOf(pack, ranks.Rank(), size, allOnLast), box, true, ranks);
          EXPECT_EQ(share.NumberOfSpheres, 5000);
          EXPECT_EQ(share.Count, (std::vector<std::int64_t>{ 2000, 3000 }));
          EXPECT_EQ(share.Volume, ruc::SharePack(pack, box).Volume);
          EXPECT_NEAR(share.Volume[1], 3000 * 4.0 / 3.0 * oracle::Pi * 1e-3, 1e-9);
          // All centres are in the sample that the regions are cut from
          EXPECT_LE(std::abs(static_cast<int>(share.Own.Size()) - 5000 / size), size);
          const std::lock_guard<std::mutex> lock(mutex);
          for (std::size_t i = 0; i < share.Own.Size(); ++i)
          {
            found.insert({ share.Own.X[i], share.Own.Y[i], share.Own.Z[i], share.Own.Radius[i],
              double(share.Own.Mode[i]) });
          }
        });
      std::multiset<std::array<double, 5>> expected;
      for (std::size_t i = 0; i < pack.Size(); ++i)
      {
        expected.insert({ pack.X[i], pack.Y[i], pack.Z[i], pack.Radius[i], double(pack.Mode[i]) });
      }
      EXPECT_TRUE(found == expected) << size;
    }
  }
}

// Surroundings meet each pair from both sides
TEST(PairNeighbourhood, MeetsEveryPairOfImagesOnceOverAllRanks)
{
  using Pair = std::tuple<double, double, double>; // two places and a distance tell a pair apart
  for (const Window& window : Windows)
  {
    const SpherePack pack = PackIn(window, { 0.7, 0.4 }, 2);
    for (double cutoff : { 2.0, 7.0, window.IsFullyPeriodic() ? 16.0 : 12.0 })
    {
      std::map<Pair, int> expected;
      oracle::ForEachPair(pack, window, cutoff,
        [&](std::size_t i, std::size_t j, const std::array<int, 3>&, double d)
        {
          // To nine digits, as the oracle rounds differently
          ++expected[{
            std::min(pack.X[i], pack.X[j]), std::max(pack.X[i], pack.X[j]), std::round(1e9 * d) }];
        });
      for (int size : { 1, 2, 5 })
      {
        std::mutex mutex;
        std::map<Pair, int> found, around;
        oracle::ThreadRanks::Run(size,
          [&](ruc::Communicator& ranks)
          {
            const ruc::PackShare share =
              ruc::SharePack(oracle::PieceOf(pack, ranks.Rank(), size, false), window, true, ranks);
            const ruc::PairNeighbourhood pairs(share, cutoff, ranks);
            const ruc::Surroundings surroundings(share, cutoff, ranks);
            const std::lock_guard<std::mutex> lock(mutex);
            pairs.ForEachPair(0, pairs.Size(),
              [&](std::size_t i, const ruc::PairNeighbourhood::Part& part, std::size_t j, double,
                double, double, double d2)
              {
                const double a = share.Own.X[i], b = part.Pack.X[j];
                ++found[{ std::min(a, b), std::max(a, b), std::round(1e9 * std::sqrt(d2)) }];
              });
            for (std::size_t i = 0; i < surroundings.Size(); ++i)
            {
              surroundings.ForEachAround(i,
                [&](const ruc::PairNeighbourhood::Part& part, std::size_t j, double, double, double,
                  double d2)
                {
                  const double a = share.Own.X[surroundings.PlaceOf(i)], b = part.Pack.X[j];
                  ++around[{ std::min(a, b), std::max(a, b), std::round(1e9 * std::sqrt(d2)) }];
                });
            }
          });
        EXPECT_TRUE(found == expected)
          << window.Describe() << " cut-off " << cutoff << " on " << size
          << " ranks: " << found.size() << " and " << expected.size() << " pairs";
        for (auto& [pair, count] : around)
        {
          count /= 2;
        }
        EXPECT_TRUE(around == expected);
      }
    }
  }
}

TEST(PackShare, ResultsAreTheSameForAnySharing)
{
  for (const Window& window : Windows)
  {
    for (bool manySizes : { false, true })
    {
      SpherePack pack = PackIn(window, { 0.7, 0.4 }, 3);
      for (std::size_t i = 0; manySizes && i < pack.Size(); ++i)
      {
        pack.Radius[i] *= 1.0 - 1e-4 * i; // closed form for every pair: too many for tables
      }
      for (std::size_t i = pack.Size(); manySizes && i < 300; ++i)
      {
        // More sizes than tables take; spheres may overlap
        oracle::Uniform random(100 + i);
        pack.X.push_back(random(3.0, 7.0));
        pack.Y.push_back(random(3.0, 7.0));
        pack.Z.push_back(random(3.0, 7.0));
        pack.Radius.push_back(0.1 + 1e-4 * i);
        pack.Mode.push_back(1);
      }
      const ruc::LagGrid lags = { 0.2, 20 };
      const ruc::PackShare whole = ruc::SharePack(pack, window);
      ruc::Communicator serial;
      const ruc::TwoPointProbability expected = ruc::SumPairs(pack, window, lags);
      const ruc::PackOverlap overlap = ruc::MeasureOverlap(whole, serial);
      EXPECT_NEAR(overlap.Percent, ruc::MeasureOverlap(pack, window).Percent, 1e-9);
      for (int size : { 2, 3, 6 })
      {
        for (bool allOnLast : { false, true })
        {
          oracle::ThreadRanks::Run(size,
            [&](ruc::Communicator& ranks)
            {
              const ruc::PackShare share = ruc::SharePack(
                oracle::PieceOf(pack, ranks.Rank(), size, allOnLast), window, true, ranks);
              const ruc::TwoPointProbability got = ruc::SumPairs(share, lags, ranks);
              EXPECT_TRUE(got.Values == expected.Values) << window.Describe() << size;
              EXPECT_TRUE(got.Fractions == expected.Fractions);
              const ruc::PackOverlap shared = ruc::MeasureOverlap(share, ranks);
              EXPECT_EQ(shared.Percent, overlap.Percent);
              EXPECT_EQ(shared.Pairs, overlap.Pairs);
              EXPECT_EQ(shared.Deepest, overlap.Deepest);
            });
        }
      }
    }
  }
}

TEST(PackShare, MoreRanksThanSpheres)
{
  const Window box = oracle::PeriodicCube(10.0);
  SpherePack pack = oracle::RandomPack({ 1, 2 }, { 1.0, 0.5 }, box, 5);
  const ruc::LagGrid lags = { 1.0, 5 };
  const auto expected = ruc::SumPairs(pack, box, lags).Values;
  oracle::ThreadRanks::Run(5,
    [&](ruc::Communicator& ranks)
    {
      const ruc::PackShare share =
        ruc::SharePack(oracle::PieceOf(pack, ranks.Rank(), 5, true), box, true, ranks);
      EXPECT_TRUE(ruc::SumPairs(share, lags, ranks).Values == expected);
    });
}

TEST(PackShare, BadInputIsRefusedOnEveryRank)
{
  const Window box = oracle::PeriodicCube(10.0);
  const SpherePack good = oracle::RandomPack({ 6, 6 }, { 1.0, 0.5 }, box, 5);
  const auto refuses = [&](const SpherePack& pack, const Window& window, const std::string& part)
  {
    oracle::ThreadRanks::Run(3,
      [&](ruc::Communicator& ranks)
      {
        EXPECT_SAYS(
          ruc::SharePack(oracle::PieceOf(pack, ranks.Rank(), 3, false), window, true, ranks), part);
      });
  };
  refuses({}, box, "at least one sphere");
  SpherePack bad = good;
  bad.X[4] = std::nan("");
  refuses(bad, box, "finite coordinates");
  bad = good;
  bad.Radius[4] = 0.0;
  refuses(bad, box, "'Radius' requires finite values > 0");
  bad = good;
  bad.Mode[4] = 13;
  refuses(bad, box, "got 13");
  bad.Mode[4] = 5;
  refuses(bad, box, "no sphere of mode 3");
  bad = good;
  bad.X[4] = bad.X[7] + 10.0 * 1e-10 - 10.0 * 1e-10;
  bad.Y[4] = bad.Y[7];
  bad.Z[4] = bad.Z[7];
  refuses(bad, box, "distinct centres");
  bad = good;
  bad.X[3] = bad.Y[5] = 11.0;
  const Window open = Window::MakeBox({ 0, 0, 0 }, { 10, 10, 10 }, { false, false, true });
  refuses(bad, open, "got 2 of 12 outside");
  bad = good;
  bad.Radius[3] = 5.0;
  refuses(bad, box, "longer than the largest sphere's diameter, 10");
}

TEST(GatherPack, GivesTheWholePackInOneOrderToEveryRank)
{
  const Window box = oracle::PeriodicCube(10.0);
  SpherePack pack = oracle::RandomPack({ 20, 30 }, { 0.2, 0.1 }, box, 6);
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    pack.Id.push_back(static_cast<std::int64_t>(1000 + i));
  }
  SpherePack expected = pack;
  ruc::SortCanonically(expected);
  for (int size : { 1, 3 })
  {
    for (bool withId : { true, false })
    {
      oracle::ThreadRanks::Run(size,
        [&](ruc::Communicator& ranks)
        {
          SpherePack piece = oracle::PieceOf(pack, ranks.Rank(), size, false);
          if (!withId && ranks.Rank() == size - 1)
          {
            piece.Id.clear();
          }
          const SpherePack whole =
            ruc::GatherPack(ruc::CheckedPiece(std::move(piece), box, true, ranks), ranks);
          EXPECT_EQ(whole.X, expected.X);
          EXPECT_EQ(whole.Radius, expected.Radius);
          EXPECT_EQ(whole.Mode, expected.Mode);
          std::vector<std::int64_t> places(whole.Size());
          std::iota(places.begin(), places.end(), 0);
          EXPECT_EQ(whole.Id, withId ? expected.Id : places);
        });
    }
  }
}

TEST(CheckedPiece, LeavesOutOrRefusesWhatLiesOutsideOnAnyRank)
{
  const SpherePack pack = oracle::RandomPack({ 40 }, { 0.2 }, oracle::PeriodicCube(10.0), 7);
  const Window half = Window::MakeBox({ 0, 0, 0 }, { 10, 10, 5 }, { false, false, false });
  const Window beyond = Window::MakeBox({ 0, 0, 20 }, { 10, 10, 5 }, { false, false, false });
  const auto inside = static_cast<std::int64_t>(ruc::CropToWindow(pack, half).Size());
  for (int size : { 1, 3 })
  {
    oracle::ThreadRanks::Run(size,
      [&](ruc::Communicator& ranks)
      {
        const auto check = [&](const Window& window, bool crop)
        {
          return ruc::CheckedPiece(
            oracle::PieceOf(pack, ranks.Rank(), size, false), true,
            [&](const SpherePack&) { return window; }, crop, ranks);
        };
        EXPECT_EQ(check(half, true).NumberOfSpheres(), inside);
        EXPECT_SAYS(check(half, false), ruc::Text(40 - inside, " of 40 outside"));
        EXPECT_SAYS(check(beyond, true), "at least one centre inside, got none");
        EXPECT_SAYS(ruc::CheckedPiece(SpherePack(), half, true, ranks), "at least one sphere");
        SpherePack faulty = oracle::PieceOf(pack, ranks.Rank(), size, true);
        if (!faulty.Empty())
        {
          faulty.Radius[0] = -1.0;
        }
        EXPECT_SAYS(ruc::CheckedPiece(faulty, half, true, ranks), "finite values > 0, got -1");
      });
  }
}
