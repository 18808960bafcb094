// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/SpectrumTerm.h"
#include "Statistics/ThirdOrder/ThirdOrderPacks.h"
#include "TermProblem.h"
#include "ruc/Reconstruction/GradientSearch.h"
#include "ruc/Reconstruction/SearchCheckpoint.h"

namespace
{
using ruc::NeighbourTarget;
using ruc::PackSpectrum;

constexpr const char* Name = "SpectrumWeight";

PackSpectrum Measure(const ruc::SpherePack& pack, const ruc::Window& window)
{
  ruc::Communicator alone;
  return ruc::MeasureSpectrum(ruc::SharePack(pack, window), Name, alone);
}

struct Problem : TermProblem
{
  Problem()
  {
    this->Spectrum.SpectrumWeight = 1.0;
    this->Spectrum.Spectrum = Measure(this->Made.Pack, this->Made.Box);
  }
  NeighbourTarget Spectrum;
};

const Problem& TheProblem()
{
  static const Problem problem;
  return problem;
}

double SmoothEnd(double ratio)
{
  const double t = std::clamp((ratio - 0.7) / 0.3, 0.0, 1.0);
  return 1.0 - t * t * t * (10.0 - 15.0 * t + 6.0 * t * t);
}

// Z(l) / (2 (1 - c)) of a periodic cube by its definition: over all pairs of spheres around each
// centre, with Legendre polynomials of the angle between them
std::vector<double> SpectrumByPairs(const ruc::SpherePack& pack, double edge, double cutOff)
{
  std::vector<double> spectrum(ruc::HighestOfSpectrum - 1, 0.0);
  double cubes = 0.0;
  const int images = static_cast<int>(std::ceil(cutOff / edge));
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    const double a = pack.Radius[i];
    cubes += a * a * a;
    std::vector<std::array<double, 5>> around; // direction, distance, cube of the radius
    for (std::size_t j = 0; j < pack.Size(); ++j)
    {
      for (int n = 0; n < std::pow(2 * images + 1, 3); ++n)
      {
        const int side = 2 * images + 1;
        const ruc::Vector3 d = { pack.X[j] - pack.X[i] + edge * (n % side - images),
          pack.Y[j] - pack.Y[i] + edge * (n / side % side - images),
          pack.Z[j] - pack.Z[i] + edge * (n / side / side - images) };
        const double r = ruc::Length(d);
        if (r > 0.0 && r < cutOff)
        {
          around.push_back({ d[0] / r, d[1] / r, d[2] / r, r, std::pow(pack.Radius[j], 3) });
        }
      }
    }
    for (const auto& j : around)
    {
      for (const auto& k : around)
      {
        const double cosine = j[0] * k[0] + j[1] * k[1] + j[2] * k[2];
        double before = 1.0, legendre = cosine;
        for (int l = 2; l <= ruc::HighestOfSpectrum; ++l)
        {
          const double next = ((2 * l - 1) * cosine * legendre - (l - 1) * before) / l;
          before = std::exchange(legendre, next);
          const double end = l > 6 ? 0.75 * cutOff : cutOff;
          spectrum[l - 2] += l * (l - 1.0) * std::pow(a, 2 * l - 1) * j[4] * k[4] *
            std::pow(j[3] * k[3], -l - 1) * SmoothEnd(j[3] / end) * SmoothEnd(k[3] / end) *
            legendre;
        }
      }
    }
  }
  const double matrix = 1.0 - cubes * 4.0 / 3.0 * ruc::Pi / (edge * edge * edge);
  for (double& value : spectrum)
  {
    value /= cubes * 2.0 * matrix;
  }
  return spectrum;
}

double MisfitOf(const std::vector<double>& values, const PackSpectrum& pack)
{
  double misfit = 0.0;
  for (std::size_t l = 0; l < values.size(); ++l)
  {
    misfit += std::pow((values[l] - pack.Value[l]) / pack.Error[l], 2) / values.size();
  }
  return misfit;
}

double Evaluate(const ruc::CellContents& contents, const PackSpectrum& pack,
  const std::vector<double>& centres, double* gradient = nullptr)
{
  ruc::Communicator alone;
  return ruc::SpectrumTerm(contents, pack, alone).Evaluate(centres.data(), 1.0, gradient);
}

ruc::GradientSearchSettings Settings(int iterations)
{
  ruc::GradientSearchSettings settings;
  settings.MaximumIterations = iterations;
  settings.Neighbours = TheProblem().Spectrum;
  return settings;
}

ruc::UnitCell Search(const ruc::GradientSearchSettings& settings, ruc::Communicator& ranks,
  const ruc::GradientState* resume = nullptr,
  const std::function<void(const ruc::GradientState&)>& save = {})
{
  return ruc::SearchByGradient(
    TheProblem().Contents, TheProblem().Target, settings, ranks, CarryOn, resume, save);
}
}

// A rounding of 2^-38 for each of some hundred spheres around a centre
TEST(SpectrumTerm, ComesFromPairsOfNeighboursByTheirAngle)
{
  const Problem& problem = TheProblem();
  const std::vector<double> centres = problem.SomeCentres();
  const PackSpectrum& pack = problem.Spectrum.Spectrum;
  const std::vector<double> values =
    SpectrumByPairs(problem.Contents.MakePack(centres.data()), problem.Contents.Edge, pack.CutOff);
  const double misfit = MisfitOf(values, pack);
  EXPECT_GT(misfit, 10.0);
  EXPECT_NEAR(Evaluate(problem.Contents, pack, centres), misfit, 1e-6 * misfit);
}

// The pack is itself a periodic cell
TEST(SpectrumTerm, ThePackFitsItself)
{
  const PackSpectrum& pack = TheProblem().Spectrum.Spectrum;
  EXPECT_LT(Evaluate(TheProblem().PackAsCell, pack, ruc::CentresOf(TheProblem().Made.Pack)), 1e-10);
  const double zeta = ruc::MeasureZeta(TheProblem().Made.Pack, TheProblem().Made.Box, pack);
  EXPECT_EQ(zeta, pack.Zeta);
  // Ewald's sum is another function, with the same limit
  const double exact =
    oracle::Measure(TheProblem().Made.Pack, TheProblem().Made.Box, {}).Spheres.Zeta.Value;
  EXPECT_NEAR(zeta, exact, 0.005 * exact);
  EXPECT_NE(zeta, exact);
}

// Also of a cell that is smaller than the cut-off, and of one sphere that only meets its images
TEST(SpectrumTerm, SmallCellsMeetTheirImages)
{
  const PackSpectrum& pack = TheProblem().Spectrum.Spectrum;
  for (const std::vector<int>& count : { std::vector<int>{ 1, 3 }, std::vector<int>{ 1 } })
  {
    ruc::CellContents contents;
    contents.Count = count;
    contents.Radius = { 1.0, 0.6 };
    contents.Radius.resize(count.size());
    contents.Edge = 2.4;
    const std::vector<double> centres = { 0.1, 0.2, 0.3, 1.3, 1.3, 1.4, 1.5, 0.2, 1.2, 0.1, 1.5,
      1.6 };
    const double misfit =
      MisfitOf(SpectrumByPairs(contents.MakePack(centres.data()), 2.4, pack.CutOff), pack);
    EXPECT_NEAR(Evaluate(contents, pack, centres), misfit, 1e-5 * misfit);
  }
}

// Sums are rounded
TEST(SpectrumTerm, GradientIsThatOfTheValue)
{
  ExpectGradientOfValue(TheProblem().SomeCentres(), 13, 1e-4, 1e-5,
    [](const std::vector<double>& centres, double* gradient)
    { return Evaluate(TheProblem().Contents, TheProblem().Spectrum.Spectrum, centres, gradient); });
}

TEST(SpectrumTerm, SpheresWithinEachOtherGiveANumber)
{
  const std::vector<double> centres = TheProblem().SomeCentres(false);
  std::vector<double> gradient(centres.size(), 0.0);
  EXPECT_TRUE(std::isfinite(
    Evaluate(TheProblem().Contents, TheProblem().Spectrum.Spectrum, centres, gradient.data())));
  EXPECT_TRUE(std::all_of(
    gradient.begin(), gradient.end(), [](double slope) { return std::isfinite(slope); }));
}

TEST(SpectrumTerm, IsTheSameOnAnyRanksAndThreads)
{
  const Problem& problem = TheProblem();
  const std::vector<double> centres = problem.SomeCentres();
  ExpectSameOnAnyRanks(centres.size(),
    [&](ruc::Communicator& ranks, double* gradient)
    {
      return ruc::SpectrumTerm(problem.Contents, problem.Spectrum.Spectrum, ranks)
        .Evaluate(centres.data(), 1.0, gradient);
    });
}

TEST(SpectrumTerm, BringsTheSpectrumNear)
{
  ruc::Communicator alone;
  const ruc::UnitCell cell = Search(Settings(100), alone);
  EXPECT_TRUE(cell.Overlap.IsNone());
  ruc::GradientSearchSettings plain = Settings(150);
  plain.Neighbours = {};
  const ruc::UnitCell other = Search(plain, alone);
  const PackSpectrum& pack = TheProblem().Spectrum.Spectrum;
  const double without = Evaluate(TheProblem().Contents, pack, ruc::CentresOf(other.Pack));
  EXPECT_LT(cell.Convergence.back().Misfits.Spectrum, 0.1 * without);
  EXPECT_EQ(cell.Convergence.back().Misfits.Spectrum,
    Evaluate(TheProblem().Contents, pack, ruc::CentresOf(cell.Pack)));
  EXPECT_EQ(cell.Zeta, ruc::MeasureZeta(cell.Pack, cell.Box, pack));
  EXPECT_NEAR(cell.Zeta, pack.Zeta, 3.0 * pack.ZetaError);
  EXPECT_TRUE(std::isnan(other.Zeta));
}

TEST(SpectrumTerm, OffIsAsIfItDidNotExist)
{
  ruc::Communicator alone;
  ruc::GradientSearchSettings off = Settings(30), none = Settings(30);
  off.Neighbours.SpectrumWeight = 0.0;
  none.Neighbours = {};
  ExpectEqual(Search(off, alone), Search(none, alone));
}

TEST(SpectrumTerm, ResumesToTheSameEndOnAnyRanks)
{
  const ruc::GradientSearchSettings settings = Settings(10);
  const ruc::SearchKey key = ruc::MakeKey(TheProblem().Contents, TheProblem().Target, settings);
  std::vector<std::string> states;
  ruc::Communicator alone;
  const ruc::UnitCell whole = Search(settings, alone, nullptr,
    [&](const ruc::GradientState& state) { states.push_back(ruc::WriteCheckpoint(state, key)); });
  ASSERT_EQ(states.size(), 15u); // 6 of F2 alone, and 9 with the spectrum
  for (std::size_t n : { 4, 9, 14 })
  {
    const ruc::GradientState state = ruc::ReadGradientCheckpoint(states[n], key);
    oracle::ThreadRanks::Run(1 + static_cast<int>(n % 3),
      [&](ruc::Communicator& communicator)
      { ExpectEqual(Search(settings, communicator, &state), whole); });
  }
  ruc::GradientSearchSettings other = settings;
  other.Neighbours.Spectrum.Value[2] *= 1.01;
  EXPECT_SAYS(ruc::ReadGradientCheckpoint(
                states.back(), ruc::MakeKey(TheProblem().Contents, TheProblem().Target, other)),
    "target differs");
}

TEST(SpectrumTerm, PacksThatTellNoSpectrumAreRefusedByName)
{
  const HardPack& made = TheProblem().Made;
  ruc::SpherePack pack = made.Pack;
  pack.X[0] = pack.X[1] + 1.9;
  pack.Y[0] = pack.Y[1];
  pack.Z[0] = pack.Z[1];
  EXPECT_SAYS(Measure(pack, made.Box),
    "SpectrumWeight requires spheres that overlap by at most 0.01 % of their volume");
  const auto window = [&](bool x, bool y) {
    return ruc::Window::MakeBox(made.Box.Origin, made.Box.Size, { x, y, false });
  };
  EXPECT_SAYS(
    Measure(made.Pack, window(false, false)), "SpectrumWeight requires 100 spheres at least");
  EXPECT_SAYS(
    Measure(made.Pack, window(true, true)), "SpectrumWeight requires 100 spheres at least");
}

// A window cut out of a periodic pack has the pack's spectrum but for the scatter of its errors
TEST(SpectrumTerm, AWindowHasTheSpectrumOfItsPack)
{
  const HardPack large(600, 1500, 0.45), cut(600, 1500, 0.45, false);
  const PackSpectrum whole = Measure(large.Pack, large.Box), part = Measure(cut.Pack, cut.Box);
  for (std::size_t l = 0; l < whole.Value.size(); ++l)
  {
    EXPECT_NEAR(part.Value[l], whole.Value[l], 3.0 * (part.Error[l] + whole.Error[l]));
  }
  EXPECT_LT(part.ZetaError, 0.05 * part.Zeta);
}
