// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Homogenisation/EffectiveCell.h"
#include "ruc/Homogenisation/ElasticVoxels.h"

#include "ThreadRanks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

using namespace ruc;

namespace
{
const Window Cube = Window::MakeBox({ 0, 0, 0 }, { 1, 1, 1 }, { true, true, true });

enum class Lattice
{
  Simple,
  BodyCentred,
  FaceCentred
};

// Spheres of a cubic lattice, of which one stands where no symmetry of the grid helps
SpherePack Spheres(Lattice lattice, double fraction)
{
  std::vector<Vector3> places = { { 0.0, 0.0, 0.0 } };
  if (lattice == Lattice::BodyCentred)
  {
    places.push_back({ 0.5, 0.5, 0.5 });
  }
  if (lattice == Lattice::FaceCentred)
  {
    places.insert(places.end(), { { 0.5, 0.5, 0.0 }, { 0.5, 0.0, 0.5 }, { 0.0, 0.5, 0.5 } });
  }
  SpherePack pack;
  for (const Vector3& at : places)
  {
    pack.X.push_back(at[0] + 0.21);
    pack.Y.push_back(at[1] + 0.33);
    pack.Z.push_back(at[2] + 0.45);
    pack.Radius.push_back(
      std::cbrt(3.0 * fraction / (4.0 * Pi * static_cast<double>(places.size()))));
    pack.Mode.push_back(1);
  }
  return pack;
}

SolvedCell Conduct(Lattice lattice, double fraction, double k, InterfaceRule rule, int voxels)
{
  Communicator one;
  return SolveCell(Spheres(lattice, fraction), Cube, MakeCellGrid(Cube, voxels, false),
    MakeConductors(1.0, { k }, 1), rule, { 1e-5, 500 }, one);
}

double MeanBulk(const EffectiveTensor& of)
{
  double sum = 0.0;
  for (int a = 0; a < 3; ++a)
  {
    for (int b = 0; b < 3; ++b)
    {
      sum += of.Value[a][b];
    }
  }
  return sum / 9.0;
}

// A few spheres of two modes without any symmetry
SpherePack Few()
{
  SpherePack pack;
  pack.X = { 0.2, 0.7, 0.55, 0.1 };
  pack.Y = { 0.3, 0.8, 0.25, 0.8 };
  pack.Z = { 0.15, 0.3, 0.7, 0.75 };
  pack.Radius = { 0.22, 0.2, 0.25, 0.18 };
  pack.Mode = { 1, 2, 1, 2 };
  return pack;
}

std::vector<double> Numbers(const SolvedCell& cell)
{
  std::vector<double> numbers = { cell.Fraction };
  for (const auto& row : cell.Tensor.Value)
  {
    numbers.insert(numbers.end(), row.begin(), row.end());
  }
  for (const SolverStep& step : cell.Tensor.Steps)
  {
    numbers.push_back(step.Energy);
  }
  return numbers;
}
}

// Exact values by Rayleigh's method (R. C. McPhedran, D. R. McKenzie, Proc. R. Soc. A 359, 45,
// 1978) in a program of its own; 10^4 stands for spheres of no resistance, 0.04 % below them. Of a
// grid of 64, 0.2 % is asked
TEST(EffectiveCell, ConductsAsCubicArraysDo)
{
  struct Case
  {
    Lattice Array;
    double Fraction, Conductivity;
    InterfaceRule Rule;
    double Exact;
  };
  const Case cases[] = {
    { Lattice::Simple, 0.4, 0.0, InterfaceRule::Arithmetic, 0.49011 },
    { Lattice::Simple, 0.4, 10.0, InterfaceRule::Laminate, 2.36443 },
    { Lattice::Simple, 0.4, 100.0, InterfaceRule::Harmonic, 3.13336 },
    { Lattice::Simple, 0.4, 1e4, InterfaceRule::Harmonic, 3.26257 },
    { Lattice::BodyCentred, 0.4, 0.0, InterfaceRule::Arithmetic, 0.498465 },
    { Lattice::BodyCentred, 0.4, 10.0, InterfaceRule::Laminate, 2.29703 },
    { Lattice::BodyCentred, 0.4, 100.0, InterfaceRule::Harmonic, 2.93488 },
    { Lattice::FaceCentred, 0.4, 10.0, InterfaceRule::Laminate, 2.29331 },
    { Lattice::FaceCentred, 0.4, 100.0, InterfaceRule::Harmonic, 2.92423 },
  };
  for (const Case& of : cases)
  {
    const SolvedCell cell = Conduct(of.Array, of.Fraction, of.Conductivity, of.Rule, 64);
    EXPECT_EQ(cell.Tensor.EndedBy, SolverEnd::Tolerance);
    EXPECT_NEAR(cell.Fraction, of.Fraction, 1e-6);
    for (int a = 0; a < 3; ++a)
    {
      EXPECT_NEAR(cell.Tensor.Value[a][a], of.Exact, 0.002 * of.Exact)
        << static_cast<int>(of.Array) << ' ' << of.Conductivity;
    }
  }
}

// What is solved for is a bound of the voxels' energy, which closes in on the exact one
TEST(EffectiveCell, ComesNearerOnAFinerGrid)
{
  const double exact = 2.36443;
  const auto error = [&](int voxels)
  {
    return std::abs(
      Conduct(Lattice::Simple, 0.4, 10.0, InterfaceRule::Laminate, voxels).Tensor.Value[0][0] -
      exact);
  };
  EXPECT_LT(error(64), 0.7 * error(20));
}

TEST(EffectiveCell, HasTheBulkModulusOfHillWhereAllShearAlike)
{
  // R. Hill, J. Mech. Phys. Solids 12, 199, 1964
  Communicator one;
  const ElasticModuli matrix = ModuliOf(3.0, 0.38);
  CellMaterials materials;
  materials.Property = CellProperty::Elasticity;
  materials.Matrix = matrix;
  materials.Moduli = { { 50.0, matrix.Shear }, { 20.0, matrix.Shear } };
  materials.OfMode = { 0, 1 };
  const SpherePack pack = Few();
  double c[2] = { 0.0, 0.0 };
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    c[pack.Mode[i] - 1] += 4.0 / 3.0 * Pi * std::pow(pack.Radius[i], 3);
  }
  const double y = 4.0 / 3.0 * matrix.Shear;
  const double exact =
    1.0 / ((1.0 - c[0] - c[1]) / (matrix.Bulk + y) + c[0] / (50.0 + y) + c[1] / (20.0 + y)) - y;
  SolverSettings settings;
  settings.Tolerance = 1e-6;
  const auto error = [&](int voxels)
  {
    const SolvedCell cell = SolveCell(pack, Cube, MakeCellGrid(Cube, voxels, false), materials,
      InterfaceRule::Laminate, settings, one);
    for (int a = 3; a < 6; ++a)
    {
      EXPECT_NEAR(cell.Tensor.Value[a][a], matrix.Shear, 1e-5 * matrix.Shear);
    }
    return std::abs(MeanBulk(cell.Tensor) / exact - 1.0);
  };
  EXPECT_LT(error(32), 5e-4);
}

TEST(EffectiveCell, OfOneMaterialIsThatMaterial)
{
  Communicator one;
  const CellGrid grid = MakeCellGrid(Cube, 12, false);
  const SolvedCell conductor = SolveCell(
    Few(), Cube, grid, MakeConductors(2.0, { 2.0, 2.0 }, 2), InterfaceRule::Laminate, {}, one);
  const CellMaterials glass = MakeElastic(70.0, 0.2, { 70.0 }, { 0.2 }, 2);
  const SolvedCell elastic = SolveCell(Few(), Cube, grid, glass, InterfaceRule::Laminate, {}, one);
  const double lambda = glass.Matrix.Bulk - 2.0 / 3.0 * glass.Matrix.Shear;
  for (int a = 0; a < 6; ++a)
  {
    for (int b = 0; b < 6; ++b)
    {
      if (a < 3 && b < 3)
      {
        EXPECT_NEAR(conductor.Tensor.Value[a][b], a == b ? 2.0 : 0.0, 1e-5);
      }
      const double exact =
        (a < 3 && b < 3 ? lambda : 0.0) + (a == b ? (a < 3 ? 2.0 : 1.0) * glass.Matrix.Shear : 0.0);
      EXPECT_NEAR(elastic.Tensor.Value[a][b], exact, 1e-4);
    }
  }
}

// Layers across z: the fields are uniform in each, and the solution is exact
TEST(EffectiveCell, ConductsAsLayersDo)
{
  Communicator one;
  const CellGrid grid = MakeCellGrid(Cube, 8, false);
  const CellSlab slab(grid, 0, 1);
  const double share = 0.3; // of a layer's plane that is half cut
  const std::vector<float> none(64, 0.0f), all(64, 1.0f), part(64, static_cast<float>(share));
  ConductivityVoxels law(slab, 1.0, { 20.0 }, InterfaceRule::Laminate);
  for (int z = 0; z < 8; ++z)
  {
    law.SetPlane(z,
      { { z < 3      ? all.data()
            : z == 3 ? part.data()
                     : none.data() },
        { none.data(), none.data(), all.data() } });
  }
  SolverSettings settings;
  settings.Tolerance = 1e-8;
  const EffectiveTensor tensor = CellSolver(slab, law, one).Solve(settings);
  const double c = (3.0 + share) / 8.0, along = c * 20.0 + 1.0 - c,
               across = 1.0 / (c / 20.0 + 1.0 - c);
  EXPECT_NEAR(tensor.Value[0][0], along, 1e-5 * along);
  EXPECT_NEAR(tensor.Value[1][1], along, 1e-5 * along);
  EXPECT_NEAR(tensor.Value[2][2], across, 1e-5 * across);
  EXPECT_NEAR(tensor.Value[0][2], 0.0, 1e-5);
}

TEST(EffectiveCell, IsAsStiffAsLayersAre)
{
  Communicator one;
  const CellGrid grid = MakeCellGrid(Cube, 8, false);
  const CellSlab slab(grid, 0, 1);
  const double share = 0.3;
  const std::vector<float> none(64, 0.0f), all(64, 1.0f), part(64, static_cast<float>(share));
  const ElasticModuli a = ModuliOf(3.0, 0.38), b = ModuliOf(70.0, 0.2);
  ElasticVoxels law(slab, a, { b }, InterfaceRule::Laminate);
  for (int z = 0; z < 8; ++z)
  {
    law.SetPlane(z,
      { { z < 3      ? all.data()
            : z == 3 ? part.data()
                     : none.data() },
        { none.data(), none.data(), all.data() } });
  }
  SolverSettings settings;
  settings.Tolerance = 1e-9;
  const EffectiveTensor tensor = CellSolver(slab, law, one).Solve(settings);
  // G. E. Backus, J. Geophys. Res. 67, 4427, 1962
  const double c = (3.0 + share) / 8.0;
  const auto lambda = [](const ElasticModuli& of) { return of.Bulk - 2.0 / 3.0 * of.Shear; };
  const auto plane = [&](const ElasticModuli& of) { return lambda(of) + 2.0 * of.Shear; };
  const auto mean = [&](auto&& value) { return c * value(b) + (1.0 - c) * value(a); };
  const double zz = 1.0 / mean([&](const auto& of) { return 1.0 / plane(of); });
  const double ratio = mean([&](const auto& of) { return lambda(of) / plane(of); });
  const double xx =
    mean([&](const auto& of) { return 4.0 * of.Shear * (lambda(of) + of.Shear) / plane(of); }) +
    ratio * ratio * zz;
  EXPECT_NEAR(tensor.Value[2][2], zz, 1e-5 * zz);
  EXPECT_NEAR(tensor.Value[0][2], ratio * zz, 1e-4 * zz);
  EXPECT_NEAR(tensor.Value[0][0], xx, 1e-4 * xx);
  const double yz = 1.0 / mean([](const auto& of) { return 1.0 / of.Shear; });
  const double xy = mean([](const auto& of) { return of.Shear; });
  EXPECT_NEAR(tensor.Value[3][3], yz, 1e-4 * yz);
  EXPECT_NEAR(tensor.Value[5][5], xy, 1e-4 * xy);
}

// A quarter turn of the pack about z turns the tensor, on a grid that is as symmetric
TEST(EffectiveCell, TurnsWithThePack)
{
  Communicator one;
  SpherePack turned = Few();
  const SpherePack pack = Few();
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    turned.X[i] = 1.0 - pack.Y[i];
    turned.Y[i] = pack.X[i];
  }
  SolverSettings settings;
  settings.Tolerance = 1e-7;
  const auto solve = [&](const SpherePack& of)
  {
    return SolveCell(of, Cube, MakeCellGrid(Cube, 24, false), MakeConductors(1.0, { 10, 5 }, 2),
      InterfaceRule::Laminate, settings, one)
      .Tensor.Value;
  };
  const auto a = solve(pack), b = solve(turned);
  const double rounding = 1e-5;
  EXPECT_NEAR(b[1][1], a[0][0], rounding);
  EXPECT_NEAR(b[0][0], a[1][1], rounding);
  EXPECT_NEAR(b[2][2], a[2][2], rounding);
  EXPECT_NEAR(b[0][1], -a[0][1], rounding);
  EXPECT_NEAR(b[1][2], a[0][2], rounding);
  EXPECT_NEAR(b[0][2], -a[1][2], rounding);
  EXPECT_GT(std::abs(a[0][1]), 1e-3);
  EXPECT_GT(std::abs(a[0][2]), 1e-3);
}

// A mirrored cell of a pack that is its own mirror image is that pack
TEST(EffectiveCell, MirroredIsTheSameWhereThePackIsItsOwnImage)
{
  Communicator one;
  SpherePack pack = Spheres(Lattice::Simple, 0.4);
  pack.X[0] = pack.Y[0] = pack.Z[0] = 0.5;
  for (const CellMaterials& materials :
    { MakeConductors(1.0, { 10.0 }, 1), MakeElastic(3.0, 0.38, { 70.0 }, { 0.2 }, 1) })
  {
    SolverSettings settings;
    settings.Tolerance = 1e-6;
    const auto solve = [&](bool mirrored)
    {
      return SolveCell(pack, Cube, MakeCellGrid(Cube, 16, mirrored), materials,
        InterfaceRule::Laminate, settings, one);
    };
    const SolvedCell cell = solve(false), mirrored = solve(true);
    EXPECT_NEAR(mirrored.Fraction, cell.Fraction, 1e-12);
    for (int a = 0; a < cell.Tensor.Size; ++a)
    {
      EXPECT_NEAR(
        mirrored.Tensor.Value[a][a], cell.Tensor.Value[a][a], 1e-5 * cell.Tensor.Value[a][a]);
    }
  }
}

TEST(EffectiveCell, IsEqualForAnyNumberOfRanks)
{
  const CellMaterials conductors = MakeConductors(1.0, { 10.0, 3.0 }, 2);
  const CellMaterials elastic = MakeElastic(3.0, 0.38, { 70.0, 20.0 }, { 0.2 }, 2);
  SolverSettings settings;
  settings.MaximumIterations = 4;
  for (const CellMaterials& materials : { conductors, elastic })
  {
    for (bool mirrored : { false, true })
    {
      const auto solve = [&](Communicator& ranks)
      {
        return Numbers(SolveCell(oracle::PieceOf(Few(), ranks.Rank(), ranks.Size(), false), Cube,
          MakeCellGrid(Cube, 6, mirrored), materials, InterfaceRule::Laminate, settings, ranks));
      };
      Communicator one;
      const std::vector<double> alone = solve(one);
      for (int ranks : { 2, 3, 4, 13 }) // more ranks than planes among them
      {
        oracle::ThreadRanks::Run(ranks,
          [&](Communicator& all)
          {
            const std::vector<double> together = solve(all);
            EXPECT_EQ(together, alone) << ranks;
          });
      }
    }
  }
}

TEST(EffectiveCell, KeepsWhatItHasWhereItIsStopped)
{
  Communicator one;
  int steps = 0;
  const SolvedCell cell =
    SolveCell(Few(), Cube, MakeCellGrid(Cube, 12, false), MakeConductors(1.0, { 10.0 }, 2),
      InterfaceRule::Laminate, {}, one, [&](const SolverStep&) { return ++steps < 2; });
  EXPECT_EQ(cell.Tensor.EndedBy, SolverEnd::Stopped);
  EXPECT_EQ(steps, 2);
  EXPECT_NEAR(cell.Tensor.Value[0][0], cell.Tensor.Steps.back().Energy, 1e-5);
}

TEST(EffectiveCell, HasFieldsOfWhichTheFluxIsThatOfTheTensor)
{
  Communicator one;
  CellFields fields;
  fields.Case = 1;
  SolverSettings settings;
  settings.Tolerance = 1e-7;
  const SolvedCell cell = SolveCell(Few(), Cube, MakeCellGrid(Cube, 16, false),
    MakeConductors(1.0, { 10.0 }, 2), InterfaceRule::Laminate, settings, one, {}, &fields);
  ASSERT_EQ(fields.Flux.size(), 3u);
  ASSERT_EQ(fields.Unknown.size(), 1u);
  for (int a = 0; a < 3; ++a)
  {
    double sum = 0.0;
    for (float value : fields.Flux[a].Values)
    {
      sum += value;
    }
    EXPECT_NEAR(sum / (16 * 16 * 16), cell.Tensor.Value[a][1], 1e-3);
  }
  double sum = 0.0;
  for (float value : fields.VolumeFraction.Values)
  {
    sum += value;
  }
  EXPECT_NEAR(sum / (16 * 16 * 16), cell.Fraction, 1e-6);
}

TEST(EffectiveCell, RefusesWhatItCannotSolve)
{
  EXPECT_THROW(MakeConductors(0.0, { 1.0 }, 1), std::invalid_argument);
  EXPECT_THROW(MakeConductors(1.0, { -1.0 }, 1), std::invalid_argument);
  EXPECT_THROW(MakeConductors(1.0, { NAN }, 1), std::invalid_argument);
  EXPECT_THROW(MakeConductors(1.0, { 1e6 }, 1), std::invalid_argument);
  EXPECT_THROW(MakeConductors(1.0, { 1.0, 2.0 }, 3), std::invalid_argument);
  EXPECT_THROW(MakeElastic(0.0, 0.3, { 1.0 }, { 0.2 }, 1), std::invalid_argument);
  EXPECT_THROW(MakeElastic(1.0, 0.5, { 1.0 }, { 0.2 }, 1), std::invalid_argument);
  EXPECT_THROW(MakeElastic(1.0, 0.3, { 1.0 }, { -1.0 }, 1), std::invalid_argument);
  EXPECT_THROW(MakeElastic(1.0, 0.3, { 0.0 }, { 0.2 }, 1), std::invalid_argument);
  EXPECT_THROW(MakeCellGrid(Cube, 1, false), std::invalid_argument);
  SolverSettings settings;
  settings.Tolerance = 0.0;
  EXPECT_THROW(ValidateSolver(settings), std::invalid_argument);
  settings = {};
  settings.MaximumIterations = 0;
  EXPECT_THROW(ValidateSolver(settings), std::invalid_argument);
}
