// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Gaps, contacts and rattlers: brute force, contact values of hard spheres, windows, ranks
#include "HardPack.h"
#include "NeighbourPacks.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

namespace
{
using oracle::MeasureNeighbours;
using ruc::NeighbourSettings;
using ruc::NeighbourStatistics;

ruc::PackShare ShareOf(const oracle::PackInBox& made)
{
  return ruc::SharePack(made.Pack, made.Box);
}

oracle::PackInBox Hard(int large, int small, double fraction, bool periodic = true)
{
  const HardPack made(large, small, fraction, periodic);
  return { made.Pack, made.Box };
}

struct Neighbour
{
  std::size_t I, J;
  double Gap;
  ruc::Vector3 Offset;
};

// All ordered pairs up to a gap, in the canonical order of the pack, by brute force
std::vector<Neighbour> AllNeighbours(
  const ruc::SpherePack& pack, const ruc::Window& box, double most)
{
  std::vector<Neighbour> all;
  oracle::ForEachPair(pack, box, 2.0 * pack.LargestRadius() * (1.0 + most) + 1e-9,
    [&](std::size_t i, std::size_t j, const std::array<int, 3>& image, double d)
    {
      const double gap = d / (pack.Radius[i] + pack.Radius[j]) - 1.0;
      ruc::Vector3 offset;
      for (int q = 0; q < 3; ++q)
      {
        offset[q] = pack.Centre(j)[q] + image[q] * box.Size[q] - pack.Centre(i)[q];
      }
      if (gap <= most)
      {
        all.push_back({ i, j, gap, offset });
        all.push_back({ j, i, gap, { -offset[0], -offset[1], -offset[2] } });
      }
    });
  return all;
}

TEST(NeighbourStatistics, AreThoseOfAllPairs)
{
  for (bool periodic : { true, false })
  {
    SCOPED_TRACE(periodic);
    const oracle::PackInBox made = Hard(120, 360, 0.5, periodic);
    const double margin = periodic ? 0.0 : 2.5;
    NeighbourSettings settings;
    settings.ContactTolerance = 0.05;
    settings.Blocks = 8;
    const NeighbourStatistics found = MeasureNeighbours(made, settings, margin);
    const ruc::SpherePack pack = ShareOf(made).Own;
    const ruc::Window inside = made.Box.Shrunk(margin);
    const std::vector<Neighbour> all = AllNeighbours(pack, made.Box, 0.2);

    std::vector<int> contacts(pack.Size(), 0);
    std::vector<double> nearest(pack.Size(), 1e300);
    std::array<double, 9> fabric{};
    double ends = 0.0, centres = 0.0;
    for (const Neighbour& pair : all)
    {
      const bool touch = pair.Gap <= 0.05;
      contacts[pair.I] += touch;
      nearest[pair.I] =
        std::min(nearest[pair.I], pair.Gap * (pack.Radius[pair.I] + pack.Radius[pair.J]));
      if (touch && inside.Contains(pack.Centre(pair.I)))
      {
        ++ends;
        for (int n = 0; n < 9; ++n)
        {
          fabric[n] += pair.Offset[n / 3] * pair.Offset[n % 3] / ruc::Dot(pair.Offset, pair.Offset);
        }
      }
    }
    for (std::size_t i = 0; i < pack.Size(); ++i)
    {
      const NeighbourStatistics::Sphere& sphere = found.Spheres[i];
      EXPECT_EQ(sphere.Counts, inside.Contains(pack.Centre(i)));
      EXPECT_EQ(sphere.Contacts, contacts[i]);
      centres += sphere.Counts;
      if (sphere.Counts && nearest[i] < 1e300)
      {
        EXPECT_NEAR(sphere.NearestGap, nearest[i], 1e-12);
      }
    }
    EXPECT_EQ(found.Counted, static_cast<std::int64_t>(centres));
    EXPECT_EQ(found.Contacts.size(),
      static_cast<std::size_t>(std::accumulate(contacts.begin(), contacts.end(), 0) / 2));
    const NeighbourStatistics::Means& means = found.OfModes.back();
    EXPECT_NEAR(means.Contacts.Value, ends / centres, 1e-9);
    EXPECT_GT(means.Contacts.Error, 0.0);
    EXPECT_NEAR(means.Fabric[0].Value, fabric[0] / ends, 1e-9);
    EXPECT_NEAR(means.Fabric[3].Value, fabric[5] / ends, 1e-9);
    EXPECT_NEAR(means.Fabric[4].Value, fabric[2] / ends, 1e-9);
    EXPECT_NEAR(means.Fabric[5].Value, fabric[1] / ends, 1e-9);

    ASSERT_EQ(found.Neighbours.size(), 3u);
    for (std::size_t k = 0; k < found.Gap.size(); k += 7)
    {
      for (int r = 0; r < 3; ++r)
      {
        for (int s = 0; s < 3; ++s)
        {
          double pairs = 0.0, spheres = 0.0;
          for (const Neighbour& pair : all)
          {
            pairs += pair.Gap <= found.Gap[k] && (r == 2 || pack.Mode[pair.I] == r + 1) &&
              (s == 2 || pack.Mode[pair.J] == s + 1) && inside.Contains(pack.Centre(pair.I));
          }
          for (std::size_t i = 0; i < pack.Size(); ++i)
          {
            spheres += (r == 2 || pack.Mode[i] == r + 1) && inside.Contains(pack.Centre(i));
          }
          EXPECT_NEAR(found.Neighbours[r][s][k].Value, pairs / spheres, 1e-9);
        }
      }
    }
  }
}

// One sphere after the other that has fewer than four contacts is taken off
TEST(NeighbourStatistics, RattlersAreThoseThatNothingHolds)
{
  const oracle::PackInBox made = Hard(120, 360, 0.55);
  NeighbourSettings settings;
  settings.ContactTolerance = 0.1;
  const NeighbourStatistics found = MeasureNeighbours(made, settings);
  const ruc::SpherePack pack = ShareOf(made).Own;
  const std::vector<Neighbour> all = AllNeighbours(pack, made.Box, settings.ContactTolerance);
  std::vector<bool> rattles(pack.Size(), false);
  std::vector<int> held;
  for (bool changed = true; changed;)
  {
    changed = false;
    held.assign(pack.Size(), 0);
    for (const Neighbour& pair : all)
    {
      held[pair.I] += !rattles[pair.J];
    }
    for (std::size_t i = 0; i < pack.Size(); ++i)
    {
      changed = changed || (!rattles[i] && held[i] < 4);
      rattles[i] = rattles[i] || held[i] < 4;
    }
  }
  double rattlers = 0.0, contacts = 0.0;
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    EXPECT_EQ(found.Spheres[i].Rattler, rattles[i]);
    rattlers += rattles[i];
    contacts += rattles[i] ? 0.0 : held[i];
  }
  EXPECT_GT(rattlers, 10.0);
  EXPECT_LT(rattlers, pack.Size() - 10.0);
  const NeighbourStatistics::Means& means = found.OfModes.back();
  EXPECT_NEAR(means.Rattlers.Value, rattlers / pack.Size(), 1e-9);
  EXPECT_NEAR(means.HeldContacts.Value, contacts / (pack.Size() - rattlers), 1e-9);
}

// T. Boublik, J. Chem. Phys. 53, 471 (1970); G. A. Mansoori et al., J. Chem. Phys. 54, 1523 (1971)
double ContactValue(const ruc::PackShare& share, double d1, double d2)
{
  double moments[4] = { 0.0, 0.0, 0.0, 0.0 };
  for (double radius : share.Own.Radius)
  {
    for (int n = 0; n < 4; ++n)
    {
      moments[n] += oracle::Pi / 6.0 * std::pow(2.0 * radius, n) / share.Observed.Volume();
    }
  }
  const double free = 1.0 - moments[3], mean = d1 * d2 / (d1 + d2) * moments[2];
  return 1.0 / free + 3.0 * mean / (free * free) + 2.0 * mean * mean / std::pow(free, 3);
}

TEST(NeighbourStatistics, OfHardSpheresHaveTheirContactValues)
{
  const oracle::PackInBox made = Hard(1000, 3000, 0.4);
  const ruc::PackShare share = ShareOf(made);
  NeighbourSettings settings;
  settings.MaximumGap = 0.04;
  settings.Gaps = 2;
  settings.Blocks = 64;
  const NeighbourStatistics found = MeasureNeighbours(made, settings);
  const double radii[] = { 1.0, 0.6 };
  for (int r = 0; r < 2; ++r)
  {
    for (int s = 0; s < 2; ++s)
    {
      const double contact = radii[r] + radii[s];
      const double density = share.Count[s] / made.Box.Volume();
      // The mean of g from contact to a gap, which is linear in the gap
      const auto mean = [&](int k)
      {
        const double shell = 4.0 / 3.0 * oracle::Pi * std::pow(contact, 3) *
          (std::pow(1.0 + found.Gap[k], 3) - 1.0) * density;
        const ruc::ValueWithError& n = found.Neighbours[r][s][k];
        return ruc::ValueWithError{ n.Value / shell, n.Error / shell };
      };
      const double value = 2.0 * mean(1).Value - mean(2).Value;
      EXPECT_NEAR(value, ContactValue(share, 2.0 * radii[r], 2.0 * radii[s]),
        4.0 * (2.0 * mean(1).Error + mean(2).Error));
      EXPECT_LT(mean(1).Error, 0.15 * value);
    }
  }
}

TEST(NeighbourStatistics, CellsOfAWindowAreThoseOfTheWholePack)
{
  const oracle::PackInBox made = Hard(300, 900, 0.55);
  const NeighbourStatistics whole = MeasureNeighbours(made);
  EXPECT_EQ(whole.Cells, whole.Counted);
  oracle::PackInBox cut = made;
  cut.Pack = ShareOf(made).Own;
  cut.Box.Periodic = {};
  const NeighbourStatistics found = MeasureNeighbours(cut, {}, ruc::NeighbourMargin(1.0, 0.2));
  EXPECT_GT(found.Counted, 50);
  EXPECT_GT(found.Cells, 0.97 * found.Counted);
  for (std::size_t i = 0; i < found.Spheres.size(); ++i)
  {
    const NeighbourStatistics::Sphere &one = found.Spheres[i], &other = whole.Spheres[i];
    EXPECT_EQ(std::isnan(one.LocalFraction), one.Faces == 0);
    if (one.Faces > 0)
    {
      EXPECT_TRUE(one.Counts);
      EXPECT_NEAR(one.LocalFraction, other.LocalFraction, 1e-9);
      EXPECT_NEAR(one.Q6, other.Q6, 1e-9);
      EXPECT_EQ(one.Contacts, other.Contacts);
    }
  }
}

TEST(NeighbourStatistics, OfOneSphere)
{
  oracle::PackInBox made = oracle::SimpleCubic(1, 1.0);
  made.Box = ruc::Window::MakeBox({ 0, 0, 0 }, { 3.0, 4.0, 5.0 }, { true, true, true });
  const NeighbourStatistics found = MeasureNeighbours(made);
  ASSERT_EQ(found.Counted, 1);
  EXPECT_EQ(found.Spheres[0].Contacts, 0);
  EXPECT_EQ(found.Spheres[0].Faces, 6);
  EXPECT_NEAR(found.Spheres[0].NearestGap, 1.0, 1e-12);
  EXPECT_NEAR(found.Spheres[0].LocalFraction, 4.0 / 3.0 * oracle::Pi / 60.0, 1e-12);
  EXPECT_TRUE(found.Spheres[0].Rattler);
  EXPECT_EQ(found.OfModes.back().Contacts.Value, 0.0);
  // In a window nothing is known of what is around it
  made.Box = ruc::Window::MakeBox({ -20, -20, -20 }, { 40, 40, 40 }, {});
  const NeighbourStatistics alone = MeasureNeighbours(made, {}, 4.0);
  EXPECT_EQ(alone.Counted, 1);
  EXPECT_EQ(alone.Cells, 0);
  EXPECT_TRUE(std::isnan(alone.Spheres[0].NearestGap));
  EXPECT_EQ(alone.OfModes.back().Contacts.Value, 0.0);
}

TEST(NeighbourStatistics, ImagesThatTouchAreContactsOfTheirOwn)
{
  const NeighbourStatistics found = MeasureNeighbours(oracle::SimpleCubic(2));
  EXPECT_EQ(found.Spheres[0].Contacts, 6);
  EXPECT_EQ(found.Contacts.size(), 24u);
  EXPECT_FALSE(found.Spheres[0].Rattler);
  EXPECT_EQ(found.OfModes.back().HeldContacts.Value, 6.0);
  EXPECT_NEAR(found.OfModes.back().Fabric[0].Value, 1.0 / 3.0, 1e-12);
}

TEST(NeighbourStatistics, WhatIsRefused)
{
  const oracle::PackInBox made = Hard(20, 60, 0.4, false);
  NeighbourSettings settings;
  settings.ContactTolerance = 0.3;
  EXPECT_SAYS(MeasureNeighbours(made, settings), "0 <= ContactTolerance <= 0.2, got 0.3");
  settings = {};
  settings.MaximumGap = 0.0;
  EXPECT_SAYS(MeasureNeighbours(made, settings), "0 < MaximumGap <= 2, got 0");
  settings = {};
  settings.Blocks = 1;
  EXPECT_SAYS(MeasureNeighbours(made, settings), "2 <= Blocks <= 1000, got 1");
  EXPECT_SAYS(MeasureNeighbours(made, {}, 100.0), "room for a margin of 100");
  oracle::PackInBox corner = made;
  corner.Box = ruc::Window::MakeBox({ 0, 0, 0 }, { 100, 100, 100 }, {});
  EXPECT_SAYS(MeasureNeighbours(corner, {}, 40.0),
    "requires a sphere at least WindowMargin, 40, from every face of the window, got none");
}

using Row = std::vector<double>;
std::vector<Row> RowsOf(const ruc::SpherePack& pack, const NeighbourStatistics& found)
{
  std::vector<Row> rows;
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    const NeighbourStatistics::Sphere& s = found.Spheres[i];
    Row row = { pack.X[i], pack.Y[i], pack.Z[i], double(s.Contacts), double(s.Counts),
      double(s.Rattler), s.NearestGap, s.LocalFraction, s.Q4, s.Q6, double(s.Faces) };
    std::replace_if(
      row.begin(), row.end(), [](double x) { return std::isnan(x); }, -1.0);
    rows.push_back(row);
  }
  return rows;
}
std::vector<Row> ContactsOf(const NeighbourStatistics& found)
{
  std::vector<Row> rows;
  for (const NeighbourStatistics::Contact& c : found.Contacts)
  {
    rows.push_back({ c.From[0], c.From[1], c.From[2], c.To[0], c.To[1], c.To[2], c.Gap,
      double(c.FromMode), double(c.ToMode) });
  }
  return rows;
}
Row MeansOf(const NeighbourStatistics& found)
{
  Row row;
  const auto add = [&](const ruc::ValueWithError& value)
  {
    EXPECT_FALSE(std::isnan(value.Value));
    row.push_back(value.Value);
    row.push_back(value.Error);
  };
  for (const NeighbourStatistics::Means& means : found.OfModes)
  {
    row.push_back(double(means.Counted));
    for (const ruc::ValueWithError& value :
      { means.Contacts, means.NearestGap, means.LocalFraction, means.Faces, means.Q4, means.Q6,
        means.Rattlers, means.HeldContacts, means.Fabric[0], means.Fabric[5] })
    {
      add(value);
    }
  }
  for (const auto& ofMode : found.Neighbours)
  {
    for (const NeighbourStatistics::Distribution& distribution : ofMode)
    {
      std::for_each(distribution.begin(), distribution.end(), add);
    }
  }
  return row;
}

TEST(NeighbourStatistics, AreTheSameOnAnyRanks)
{
  for (bool periodic : { true, false })
  {
    const oracle::PackInBox made = Hard(180, 520, 0.55, periodic);
    NeighbourSettings settings;
    settings.ContactTolerance = 0.1;
    settings.Blocks = 8;
    const double margin = periodic ? 0.0 : 2.5;
    const NeighbourStatistics whole = MeasureNeighbours(made, settings, margin);
    const std::vector<Row> spheres = RowsOf(ShareOf(made).Own, whole);
    std::vector<Row> contacts = ContactsOf(whole);
    std::sort(contacts.begin(), contacts.end());
    EXPECT_FALSE(contacts.empty());
    for (int ranks = 2; ranks <= 4; ++ranks)
    {
      oracle::ThreadRanks::Run(ranks,
        [&](ruc::Communicator& communicator)
        {
          const ruc::SpherePack piece =
            oracle::PieceOf(made.Pack, communicator.Rank(), ranks, ranks == 3);
          const ruc::PackShare share = ruc::SharePack(piece, made.Box, true, communicator);
          const ruc::SamplingRegion region(made.Box, margin);
          const NeighbourStatistics found =
            ruc::MeasureNeighbours(share, { region, margin, false }, settings, communicator);
          EXPECT_EQ(MeansOf(found), MeansOf(whole));
          std::vector<Row> all = communicator.Concatenate(RowsOf(share.Own, found));
          std::sort(all.begin(), all.end());
          EXPECT_EQ(all, spheres);
          all = communicator.Concatenate(ContactsOf(found));
          std::sort(all.begin(), all.end());
          EXPECT_EQ(all, contacts);
        });
    }
  }
}
}
