// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Labels and fractions of voxels against brute force over spheres and images, and their sums
#include "ruc/Images/LabelImage.h"

#include "Oracles.h"
#include "ThreadRanks.h"
#include "ruc/Images/BallInBox.h"
#include "ruc/Window/Window.h"

#include <omp.h>

namespace
{
struct Labels
{
  std::vector<std::uint8_t> Phase;
  std::vector<std::int32_t> Id;
  std::vector<std::vector<float>> Fractions;

  bool operator==(const Labels& other) const
  {
    return this->Phase == other.Phase && this->Id == other.Id && this->Fractions == other.Fractions;
  }
};

ruc::LabelSettings Everything()
{
  ruc::LabelSettings settings;
  settings.ParticleIds = settings.Fractions = settings.EveryMode = true;
  return settings;
}

Labels Fill(const ruc::SpherePack& piece, const ruc::Window& window, const ruc::VoxelGrid& grid,
  const ruc::VoxelBlock& block, const ruc::LabelSettings& settings, int modes,
  ruc::Communicator& ranks, int steps = 1)
{
  const ruc::LabelImage image(
    grid, block, ruc::SpheresOfBlock(piece, window, grid, block, 0, ranks), modes, settings);
  Labels labels;
  // What the image does not write is seen
  labels.Phase.assign(settings.Phases ? block.Voxels() : 0, 99);
  labels.Id.assign(settings.ParticleIds ? block.Voxels() : 0, -99);
  labels.Fractions.assign(
    settings.FractionArrays(modes), std::vector<float>(block.Voxels(), -99.0f));
  ruc::LabelArrays arrays;
  arrays.Phase = settings.Phases ? labels.Phase.data() : nullptr;
  arrays.ParticleId = settings.ParticleIds ? labels.Id.data() : nullptr;
  for (std::vector<float>& fractions : labels.Fractions)
  {
    arrays.Fractions.push_back(fractions.data());
  }
  for (int step = 0; step < steps; ++step)
  {
    image.Fill(step, steps, arrays);
  }
  return labels;
}

Labels FillAll(const ruc::SpherePack& pack, const ruc::Window& window, const ruc::VoxelGrid& grid,
  const ruc::LabelSettings& settings)
{
  ruc::Communicator serial;
  return Fill(
    pack, window, grid, { { 0, 0, 0 }, grid.Dimensions }, settings, pack.NumberOfModes(), serial);
}

// Spheres at random, which may overlap, with ids in no order
ruc::SpherePack RandomSpheres(const ruc::Window& window)
{
  ruc::SpherePack pack = oracle::RandomPack({ 20, 60, 100 }, { 0.9, 0.5, 0.21 }, window, 3);
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    pack.Id.push_back(1 + (7 * i) % pack.Size());
  }
  return pack;
}

struct Ball
{
  ruc::Vector3 Centre;
  double Radius;
  int Mode;
  std::int32_t Id;
};

// All spheres with all images, whether they reach the box or not
std::vector<Ball> Balls(const ruc::SpherePack& pack, const ruc::Window& window)
{
  std::vector<Ball> balls;
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    for (int n = 0; n < 27; ++n)
    {
      const int image[3] = { n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1 };
      ruc::Vector3 centre = pack.Centre(i);
      bool there = true;
      for (int q = 0; q < 3; ++q)
      {
        centre[q] += image[q] * window.Size[q];
        there = there && (image[q] == 0 || window.Periodic[q]);
      }
      if (there)
      {
        balls.push_back({ centre, pack.Radius[i], pack.Mode[i], std::int32_t(pack.Id[i]) });
      }
    }
  }
  return balls;
}

template <class Visit>
void ForEachVoxel(const ruc::VoxelGrid& grid, Visit&& visit)
{
  std::size_t place = 0;
  for (int z = 0; z < grid.Dimensions[2]; ++z)
  {
    for (int y = 0; y < grid.Dimensions[1]; ++y)
    {
      for (int x = 0; x < grid.Dimensions[0]; ++x)
      {
        visit(place++, grid.CentreOf(x, y, z));
      }
    }
  }
}

double Distance(const ruc::Vector3& a, const ruc::Vector3& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

struct Case
{
  const char* Name;
  ruc::Window Window;
  std::array<int, 3> Dimensions;
};

// Prime and odd edges, one voxel, voxels that are no cubes
std::vector<Case> Cases()
{
  const auto box = [](const std::array<bool, 3>& periodic) {
    return ruc::Window::MakeBox({ -1.0, 2.0, 5.0 }, { 6.0, 5.0, 4.0 }, periodic);
  };
  return { { "periodic", box({ true, true, true }), { 23, 20, 17 } },
    { "mixed", box({ false, true, false }), { 19, 31, 13 } }, { "window", box({}), { 24, 20, 16 } },
    { "one voxel thick", box({ true, false, true }), { 31, 29, 1 } },
    { "one voxel", box({ true, true, true }), { 1, 1, 1 } },
    { "large origin",
      ruc::Window::MakeBox({ 1e6, -1e6, 1e6 }, { 6.0, 5.0, 4.0 }, { true, true, true }),
      { 12, 10, 8 } },
    { "cylinder", ruc::Window::MakeCylinder({ 0.0, 1.0, 2.0 }, { 0, 0, 1 }, 2.5, 4.0),
      { 20, 21, 16 } } };
}

// In a cylinder, spheres of the box around it, as it makes no difference to the labels
ruc::SpherePack SpheresOf(const Case& of)
{
  return RandomSpheres(of.Window.GetBounds());
}
}

TEST(LabelImage, PhasesAndIdsAreThoseOfTheSphereAtTheCentre)
{
  for (const Case& of : Cases())
  {
    SCOPED_TRACE(of.Name);
    const ruc::VoxelGrid grid = ruc::MakeVoxelGrid(of.Window, 0.0, of.Dimensions);
    const ruc::SpherePack pack = SpheresOf(of);
    ruc::LabelSettings settings = Everything();
    settings.Fractions = false;
    const Labels labels = FillAll(pack, of.Window, grid, settings);
    const std::vector<Ball> balls = Balls(pack, of.Window.GetBounds());
    std::size_t doubtful = 0, inSpheres = 0;
    ForEachVoxel(grid,
      [&](std::size_t place, const ruc::Vector3& centre)
      {
        std::pair<int, std::int32_t> first = { 0, 0 };
        bool doubt = false;
        for (const Ball& ball : balls)
        {
          const double out = Distance(ball.Centre, centre) - ball.Radius;
          // The centres themselves are rounded
          doubt =
            doubt || std::abs(out) < 1e-15 * std::abs(of.Window.GetBounds().Origin[0]) + 1e-13;
          if (out <= 0.0)
          {
            const std::pair<int, std::int32_t> found = { ball.Mode, ball.Id };
            first = first.first == 0 ? found : std::min(first, found);
          }
        }
        doubtful += doubt;
        if (!doubt)
        {
          inSpheres += first.first != 0;
          ASSERT_EQ(int(labels.Phase[place]), first.first) << place;
          ASSERT_EQ(labels.Id[place], first.second) << place;
        }
      });
    EXPECT_LE(doubtful, 1u);
    EXPECT_TRUE(inSpheres > 0 || labels.Phase.size() == 1);
  }
}

TEST(LabelImage, ASurfaceBelongsToItsSphere)
{
  const ruc::Window box = ruc::Window::MakeBox({ 0, 0, 0 }, { 8.0, 8.0, 8.0 }, {});
  const ruc::VoxelGrid grid = ruc::MakeVoxelGrid(box, 1.0, { 0, 0, 0 });
  ruc::SpherePack pack = oracle::RandomPack({ 1 }, { 2.0 }, box, 1);
  pack.X = pack.Y = pack.Z = { 3.5 };
  ruc::LabelSettings settings;
  const Labels labels = FillAll(pack, box, grid, settings);
  // As many points of the integer lattice are within 2 of a point of it
  EXPECT_EQ(std::count(labels.Phase.begin(), labels.Phase.end(), 1), 33);
  const auto at = [&](int x) { return int(labels.Phase[(3 * 8 + 3) * 8 + x]); };
  EXPECT_TRUE(at(1) == 1 && at(5) == 1 && at(0) == 0 && at(6) == 0);
}

TEST(LabelImage, FractionsAreSharesOfTheVoxel)
{
  for (const Case& of : Cases())
  {
    SCOPED_TRACE(of.Name);
    const ruc::VoxelGrid grid = ruc::MakeVoxelGrid(of.Window, 0.0, of.Dimensions);
    const ruc::SpherePack pack = SpheresOf(of);
    const Labels labels = FillAll(pack, of.Window, grid, Everything());
    ASSERT_EQ(labels.Fractions.size(), 5u);
    const std::vector<Ball> balls = Balls(pack, of.Window.GetBounds());
    const double origin = std::abs(of.Window.GetBounds().Origin[0]);
    ForEachVoxel(grid,
      [&](std::size_t place, const ruc::Vector3& centre)
      {
        double share[4] = { 0.0, 0.0, 0.0, 0.0 };
        for (const Ball& ball : balls)
        {
          if (Distance(ball.Centre, centre) > ball.Radius + ruc::Length(grid.Spacing))
          {
            continue;
          }
          ruc::Vector3 lower, upper;
          for (int q = 0; q < 3; ++q)
          {
            lower[q] = centre[q] - ball.Centre[q] - 0.5 * grid.Spacing[q];
            upper[q] = lower[q] + grid.Spacing[q];
          }
          share[ball.Mode] += ruc::BallInBox(lower, upper, ball.Radius) / grid.VoxelVolume();
        }
        for (int mode = 1; mode <= 3; ++mode)
        {
          share[mode] = std::clamp(share[mode], 0.0, 1.0);
          share[0] += share[mode];
        }
        const double all = std::min(share[0], 1.0);
        // Floats round by 6e-8, some of them when they are added; a surface moved by e changes a
        // share by e times its area in the voxel
        const double tolerance = 1e-6 + 1e-14 * origin;
        ASSERT_NEAR(labels.Fractions[0][place], all, tolerance) << place;
        ASSERT_NEAR(labels.Fractions[4][place], 1.0 - all, tolerance) << place;
        for (int mode = 1; mode <= 3; ++mode)
        {
          ASSERT_NEAR(labels.Fractions[mode][place], share[mode], tolerance) << place;
        }
      });
  }
}

TEST(LabelImage, FractionsOfAPeriodicPackAddUpToItsVolume)
{
  const ruc::Window box = oracle::PeriodicCube(7.0);
  const ruc::SpherePack pack = oracle::RelaxedPack({ 10, 100 }, { 1.0, 0.4 }, box, 4);
  ruc::LabelSettings settings;
  settings.Fractions = true;
  for (const std::array<int, 3>& dimensions :
    { std::array<int, 3>{ 70, 70, 70 }, { 64, 13, 150 }, { 3, 1, 5 } })
  {
    const ruc::VoxelGrid grid = ruc::MakeVoxelGrid(box, 0.0, dimensions);
    const Labels labels = FillAll(pack, box, grid, settings);
    double sum = 0.0, volume = 0.0;
    for (float share : labels.Fractions[0])
    {
      sum += share;
    }
    for (double radius : pack.Radius)
    {
      volume += 4.0 / 3.0 * oracle::Pi * radius * radius * radius;
    }
    // Every float is rounded by at most 2^-24 of itself, some of them a few times
    EXPECT_NEAR(sum * grid.VoxelVolume() / volume, 1.0, 5e-8);
  }
}

TEST(LabelImage, SamplesAreCounted)
{
  const ruc::Window box =
    ruc::Window::MakeBox({ 0, 0, 0 }, { 6.0, 5.0, 4.0 }, { true, true, true });
  const ruc::SpherePack pack = oracle::RelaxedPack({ 5, 20 }, { 0.8, 0.4 }, box, 5);
  const ruc::VoxelGrid grid = ruc::MakeVoxelGrid(box, 0.0, { 18, 15, 13 });
  ruc::SpherePack withIds = pack;
  withIds.Id.assign(pack.Size(), 1);
  const std::vector<Ball> balls = Balls(withIds, box);
  ruc::LabelSettings settings;
  settings.Fractions = true;
  settings.Method = ruc::FractionMethod::Supersampled;
  settings.SamplesPerAxis = 3;
  const Labels labels = FillAll(pack, box, grid, settings);
  ForEachVoxel(grid,
    [&](std::size_t place, const ruc::Vector3& centre)
    {
      int count = 0;
      for (int n = 0; n < 27; ++n)
      {
        const int third[3] = { n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1 };
        ruc::Vector3 sample = centre;
        for (int q = 0; q < 3; ++q)
        {
          sample[q] += third[q] * grid.Spacing[q] / 3.0;
        }
        count += std::any_of(balls.begin(), balls.end(),
          [&](const Ball& ball) { return Distance(ball.Centre, sample) <= ball.Radius; });
      }
      ASSERT_NEAR(labels.Fractions[0][place], count / 27.0, 1e-6) << place;
    });
  // They come near the exact ones: 0.014 rms of border voxels for four samples an axis
  settings.SamplesPerAxis = 16;
  const Labels fine = FillAll(pack, box, grid, settings);
  settings.Method = ruc::FractionMethod::Exact;
  const Labels exact = FillAll(pack, box, grid, settings);
  for (std::size_t n = 0; n < fine.Fractions[0].size(); ++n)
  {
    ASSERT_NEAR(fine.Fractions[0][n], exact.Fractions[0][n], 0.05);
  }
}

TEST(LabelImage, BlocksStepsAndThreadsMakeNoDifference)
{
  const Case of = Cases()[1];
  const ruc::VoxelGrid grid = ruc::MakeVoxelGrid(of.Window, 0.0, of.Dimensions);
  const ruc::SpherePack pack = SpheresOf(of);
  const int modes = pack.NumberOfModes();
  for (ruc::FractionMethod method :
    { ruc::FractionMethod::Exact, ruc::FractionMethod::Supersampled })
  {
    ruc::LabelSettings settings = Everything();
    settings.Method = method;
    const Labels whole = FillAll(pack, of.Window, grid, settings);
    ruc::Communicator serial;
    const int threads = omp_get_max_threads();
    for (int n : { 1, 3, 7 })
    {
      omp_set_num_threads(n);
      const Labels again = Fill(
        pack, of.Window, grid, { { 0, 0, 0 }, grid.Dimensions }, settings, modes, serial, 2 * n);
      EXPECT_TRUE(again == whole) << n;
    }
    omp_set_num_threads(threads);
    const ruc::VoxelBlock block = { { 3, 4, 5 }, { 7, 11, 6 } };
    const Labels part = Fill(pack, of.Window, grid, block, settings, modes, serial);
    std::size_t place = 0;
    for (int z = 5; z < 11; ++z)
    {
      for (int y = 4; y < 15; ++y)
      {
        for (int x = 3; x < 10; ++x, ++place)
        {
          const std::size_t of = x + grid.Dimensions[0] * (y + std::size_t(grid.Dimensions[1]) * z);
          ASSERT_EQ(part.Phase[place], whole.Phase[of]);
          ASSERT_EQ(part.Id[place], whole.Id[of]);
          for (int n = 0; n < 5; ++n)
          {
            ASSERT_EQ(part.Fractions[n][place], whole.Fractions[n][of]);
          }
        }
      }
    }
  }
}

TEST(LabelImage, RanksMakeNoDifference)
{
  const Case of = Cases()[0];
  const ruc::VoxelGrid grid = ruc::MakeVoxelGrid(of.Window, 0.0, of.Dimensions);
  const ruc::SpherePack pack = SpheresOf(of);
  const Labels whole = FillAll(pack, of.Window, grid, Everything());
  for (int size = 1; size <= 4; ++size)
  {
    // Of three ranks the last one has all spheres; the last of several has no voxels
    std::vector<Labels> parts(size);
    oracle::ThreadRanks::Run(size,
      [&](ruc::Communicator& ranks)
      {
        const int filled = std::max(size - 1, 1), planes = grid.Dimensions[2];
        const auto plane = [&](int rank) { return planes * std::min(rank, filled) / filled; };
        const int first = plane(ranks.Rank()), last = plane(ranks.Rank() + 1);
        const ruc::VoxelBlock block = { { 0, 0, first },
          { grid.Dimensions[0], grid.Dimensions[1], last - first } };
        parts[ranks.Rank()] = Fill(oracle::PieceOf(pack, ranks.Rank(), size, size == 3), of.Window,
          grid, block, Everything(), pack.NumberOfModes(), ranks, 2);
      });
    Labels joined = parts[0];
    for (int rank = 1; rank < size; ++rank)
    {
      const auto append = [](auto& to, const auto& from)
      { to.insert(to.end(), from.begin(), from.end()); };
      append(joined.Phase, parts[rank].Phase);
      append(joined.Id, parts[rank].Id);
      for (std::size_t n = 0; n < joined.Fractions.size(); ++n)
      {
        append(joined.Fractions[n], parts[rank].Fractions[n]);
      }
    }
    EXPECT_TRUE(joined == whole) << size;
  }
}

TEST(LabelImage, IdsAreRaised)
{
  const ruc::Window box = oracle::PeriodicCube(3.0);
  ruc::SpherePack pack = oracle::RandomPack({ 1 }, { 1.0 }, box, 1);
  pack.Id = { 0 };
  const ruc::VoxelGrid grid = ruc::MakeVoxelGrid(box, 0.0, { 6, 6, 6 });
  ruc::Communicator serial;
  EXPECT_EQ(ruc::FindRaise(pack, serial), 1);
  const ruc::SpherePack images =
    ruc::SpheresOfBlock(pack, box, grid, { { 0, 0, 0 }, grid.Dimensions }, 1, serial);
  EXPECT_GT(images.Size(), 1u);
  EXPECT_TRUE(std::all_of(images.Id.begin(), images.Id.end(), [](auto id) { return id == 1; }));
}

TEST(LabelImage, IdsAreThoseOfAllRanks)
{
  const auto raise = [](std::vector<std::int64_t> ids, std::vector<std::int64_t> others)
  {
    std::int64_t raise[2];
    oracle::ThreadRanks::Run(2,
      [&](ruc::Communicator& ranks)
      {
        const ruc::Window box = oracle::PeriodicCube(1.0);
        ruc::SpherePack pack = oracle::RandomPack({ ranks.Rank() == 0 ? 2 : 1 }, { 0.1 }, box, 1);
        pack.Id = ranks.Rank() == 0 ? ids : others;
        raise[ranks.Rank()] = ruc::FindRaise(pack, ranks);
      });
    EXPECT_EQ(raise[0], raise[1]);
    return raise[0];
  };
  EXPECT_EQ(raise({ 5, 1 }, { 3 }), 0);
  EXPECT_EQ(raise({ 5, 1 }, { 0 }), 1);
  EXPECT_EQ(raise({ 5, -7 }, { 0 }), 8);
  EXPECT_EQ(raise({ 5, 2147483647 }, { 1 }), 0);
  EXPECT_SAYS(raise({ 5, 2147483647 }, { 0 }), "got ids from 0 to 2.14748e+09");
  EXPECT_SAYS(raise({ 5, 1 }, {}), "requires a point array 'Id'");
}

TEST(LabelImage, RefusesWhatCannotBeLabelled)
{
  ruc::LabelSettings settings;
  EXPECT_NO_THROW(ruc::ValidateLabels(settings, 255));
  EXPECT_SAYS(ruc::ValidateLabels(settings, 256), "Phases requires at most 255 modes, got 256");
  settings.SamplesPerAxis = 0;
  EXPECT_SAYS(
    ruc::ValidateLabels(settings, 1), "SamplesPerAxis requires a number from 1 to 64, got 0");
  settings.SamplesPerAxis = 4;
  settings.Phases = false;
  EXPECT_SAYS(ruc::ValidateLabels(settings, 1), "got none of them");
  settings.Fractions = true;
  EXPECT_NO_THROW(ruc::ValidateLabels(settings, 300));
}
