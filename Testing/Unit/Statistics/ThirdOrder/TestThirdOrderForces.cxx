// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// The gradients of multipoles by the places of the spheres, near and far
#include "Oracles.h"
#include "ThreadRanks.h"
#include "ruc/Statistics/ThirdOrder/MultipoleProducts.h"
#include "ruc/Statistics/ThirdOrder/MultipoleSums.h"

#include <cmath>
#include <omp.h>

namespace
{
using ruc::SpherePack;

struct Problem
{
  ruc::PackShare Share;
  std::vector<int> Source;
  ruc::MultipoleSettings Settings;
};

Problem MakeProblem(int sources, double alpha)
{
  const ruc::Window box =
    ruc::Window::MakeBox({ 0, 0, 0 }, { 8.0, 8.0, 9.0 }, { true, true, true });
  Problem problem;
  problem.Share = ruc::SharePack(oracle::RelaxedPack({ 20, 30 }, { 0.9, 0.6 }, box, 3), box);
  for (std::size_t i = 0; i < problem.Share.Own.Size(); ++i)
  {
    problem.Source.push_back(sources > 1 ? problem.Share.Own.Mode[i] - 1 : 0);
  }
  problem.Settings.CutOff = 4.5;
  problem.Settings.Degree = 8;
  problem.Settings.Sources = sources;
  problem.Settings.WithFourth = false;
  problem.Settings.Alpha = alpha;
  return problem;
}

// A function of the spectra of all spheres, sum over s <= t and l of w Z_st(l) (1 + Z_st(l)), and,
// if wanted, its gradient by the centres
double Evaluate(const Problem& problem, std::vector<double>* gradient)
{
  const ruc::PackShare& share = problem.Share;
  const ruc::MultipoleSettings& settings = problem.Settings;
  ruc::Communicator serial;
  const ruc::LocalMultipoles multipoles(settings);
  const ruc::MultipoleProducts products(multipoles);
  const ruc::Surroundings surroundings(share, settings.CutOff, serial);
  const std::size_t size = multipoles.Size(), count = share.Own.Size();
  const int degrees = settings.Degree - 1, sources = settings.Sources;
  std::vector<double> sums(count * size);
  const auto gather =
    [&](std::size_t n, ruc::LocalMultipoles::Neighbours& around, std::vector<std::size_t>& places)
  {
    places.clear();
    around.Start(share.Own.Radius[surroundings.PlaceOf(n)]);
    // In one box the images have the places of their originals
    surroundings.ForEachAround(n,
      [&](const ruc::PairNeighbourhood::Part& part, std::size_t j, double dx, double dy, double dz,
        double d2)
      {
        around.Add(dx, dy, dz, d2, part.Pack.Radius[j], sources > 1 ? part.Pack.Mode[j] - 1 : 0);
        std::size_t place = 0;
        while (share.Own.X[place] != part.Pack.X[j] || share.Own.Y[place] != part.Pack.Y[j])
        {
          ++place;
        }
        places.push_back(place);
      });
  };
  ruc::LocalMultipoles::Neighbours around(settings);
  std::vector<std::size_t> places;
  for (std::size_t n = 0; n < count; ++n)
  {
    gather(n, around, places);
    multipoles.Sum(around, &sums[surroundings.PlaceOf(n) * size]);
  }
  std::optional<ruc::ThirdOrderEwald> ewald;
  if (settings.Alpha > 0.0)
  {
    ewald.emplace(share, problem.Source, settings, serial);
    for (std::size_t i = 0; i < count; ++i)
    {
      ewald->Add(&i, 1, multipoles, &sums[i * size]);
    }
  }
  double volume = 0.0;
  for (double radius : share.Own.Radius)
  {
    volume += std::pow(radius, 3);
  }
  double value = 0.0;
  std::vector<double> lambda(count * size, 0.0), one(degrees), slopes(degrees);
  for (int s = 0; s < sources; ++s)
  {
    for (int t = s; t < sources; ++t)
    {
      std::vector<double> spectrum(degrees, 0.0);
      for (std::size_t i = 0; i < count; ++i)
      {
        products.Second(&sums[i * size], s, t, one.data());
        for (int l = 0; l < degrees; ++l)
        {
          spectrum[l] += std::pow(share.Own.Radius[i], 3) / volume * one[l];
        }
      }
      for (int l = 0; l < degrees; ++l)
      {
        const double weight = std::sin(1.0 + l + 3 * s + 5 * t);
        value += weight * spectrum[l] * (1.0 + spectrum[l]);
        slopes[l] = weight * (1.0 + 2.0 * spectrum[l]);
      }
      for (std::size_t i = 0; i < count; ++i)
      {
        std::vector<double> mu = slopes;
        for (double& m : mu)
        {
          m *= std::pow(share.Own.Radius[i], 3) / volume;
        }
        products.AddGradient(&sums[i * size], s, t, mu.data(), &lambda[i * size]);
      }
    }
  }
  if (!gradient)
  {
    return value;
  }
  gradient->assign(3 * count, 0.0);
  std::vector<double> forces;
  for (std::size_t n = 0; n < count; ++n)
  {
    gather(n, around, places);
    const std::size_t i = surroundings.PlaceOf(n);
    forces.assign(3 * around.Size(), 0.0);
    multipoles.FindForces(around, &lambda[i * size], forces.data());
    for (std::size_t k = 0; k < forces.size(); ++k)
    {
      (*gradient)[3 * places[k / 3] + k % 3] += forces[k];
      (*gradient)[3 * i + k % 3] -= forces[k];
    }
  }
  if (ewald)
  {
    ewald->AddForces(lambda, multipoles, *gradient, serial);
  }
  return value;
}

void ExpectSlopes(int sources, double alpha)
{
  Problem problem = MakeProblem(sources, alpha);
  std::vector<double> gradient;
  Evaluate(problem, &gradient);
  double largest = 0.0, sum[3] = { 0.0, 0.0, 0.0 };
  for (std::size_t n = 0; n < gradient.size(); ++n)
  {
    largest = std::max(largest, std::abs(gradient[n]));
    sum[n % 3] += gradient[n];
  }
  ASSERT_GT(largest, 0.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(sum[axis] / largest, 0.0, 1e-9) << "moving all spheres changes nothing";
  }
  SpherePack& pack = problem.Share.Own;
  std::vector<double>* axes[3] = { &pack.X, &pack.Y, &pack.Z };
  // Rounding of the sums by 2^-38 over the step, and the third derivative times its square
  constexpr double step = 1e-4;
  for (std::size_t i = 0; i < pack.Size(); i += 7)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      double& place = (*axes[axis])[i];
      const double before = place;
      place = before + step;
      const double up = Evaluate(problem, nullptr);
      place = before - step;
      const double down = Evaluate(problem, nullptr);
      place = before;
      EXPECT_NEAR(gradient[3 * i + axis] / largest, (up - down) / (2.0 * step) / largest, 1e-5);
    }
  }
}
}

TEST(ThirdOrderForces, AreSlopesWithASmoothEnd)
{
  ExpectSlopes(1, 0.0);
  ExpectSlopes(2, 0.0);
}

// Where the near part ends, Ewald's factor is e^-20, so that a sphere that crosses it is not felt
TEST(ThirdOrderForces, AreSlopesWithEwaldsSum)
{
  ExpectSlopes(1, 1.0);
  ExpectSlopes(2, 1.0);
}

// The far forces are sums over all spheres, which come in any order
TEST(ThirdOrderForces, SameBitsOnAnyThreads)
{
  const Problem problem = MakeProblem(2, 1.0);
  std::vector<double> serial, threaded;
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  Evaluate(problem, &serial);
  omp_set_num_threads(3);
  Evaluate(problem, &threaded);
  omp_set_num_threads(threads);
  EXPECT_EQ(serial, threaded);
}
