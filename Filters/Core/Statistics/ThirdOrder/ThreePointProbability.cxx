// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/ThirdOrder/ThreePointProbability.h"

#include "ruc/Base/Require.h"
#include "ruc/Base/Text.h"
#include "ruc/Statistics/Results/Phases.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

namespace ruc
{
namespace
{
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
}

std::vector<PhaseTriple> ParseTriples(const std::string& text, int modes)
{
  std::vector<PhaseTriple> triples;
  std::istringstream all(text);
  std::string word;
  if (all >> word && word == "all" && !(all >> word))
  {
    for (int r = 0; r <= modes; ++r)
    {
      for (int s = 0; s <= modes; ++s)
      {
        for (int q = s; q <= modes; ++q)
        {
          triples.push_back({ r, s, q });
        }
      }
    }
    return triples;
  }
  const std::string required = Text(
    "Phases requires triples of phases, 1 to ", modes, " or m, such as '1 1 m; m m m', or 'all'");
  for (const std::vector<int>& phases : ParsePhaseLists(text, modes, 3, required))
  {
    const PhaseTriple triple = { phases[0], phases[1], phases[2] };
    if (std::find(triples.begin(), triples.end(), triple) == triples.end())
    {
      triples.push_back(triple);
    }
  }
  Require(!triples.empty(), "Phases", "at least one triple of phases", "none");
  return triples;
}

std::string TripleName(const PhaseTriple& triple, int modes)
{
  return Text("S_", PhaseName(triple.R, modes), "_", PhaseName(triple.S, modes), "_",
    PhaseName(triple.Q, modes));
}

double ThreePointCounts::Denominator(std::size_t place, int t) const
{
  return this->Inside.empty() ? static_cast<double>(this->Throws) * this->Grid.RayPairs(t)
                              : static_cast<double>(this->Inside[place]);
}

double ThreePointCounts::DenominatorSquares(std::size_t place, int t) const
{
  const double pairs = this->Grid.RayPairs(t);
  return this->Inside.empty() ? static_cast<double>(this->ThrowsSquares) * pairs * pairs
                              : static_cast<double>(this->InsideSquares[place]);
}

ThreePointProbability::ThreePointProbability(
  ThreePointCounts counts, std::vector<PhaseTriple> triples)
  : Counts(std::move(counts))
  , Triples(std::move(triples))
{
  for (const PhaseTriple& wanted : this->Triples)
  {
    for (std::size_t n = 0; n < this->Counts.Triples.size(); ++n)
    {
      const PhaseTriple& phases = this->Counts.Triples[n].Phases;
      if (wanted == phases || wanted == PhaseTriple{ phases.R, phases.Q, phases.S })
      {
        this->Sources.push_back({ n, !(wanted == phases) });
        break;
      }
    }
  }
}

std::size_t ThreePointProbability::PlaceOf(const Source& source, int k1, int k2, int t) const
{
  return source.Swapped ? this->GetGrid().PlaceOf(k2, k1, t) : this->GetGrid().PlaceOf(k1, k2, t);
}

double ThreePointProbability::Value(std::size_t triple, int k1, int k2, int t) const
{
  const Source& source = this->Sources[triple];
  const std::size_t place = this->PlaceOf(source, k1, k2, t);
  const double denominator = this->Counts.Denominator(place, t);
  return denominator > 0.0
    ? static_cast<double>(this->Counts.Triples[source.Triple].Sum[place]) / denominator
    : NotANumber;
}

double ThreePointProbability::Error(std::size_t triple, int k1, int k2, int t) const
{
  const Source& source = this->Sources[triple];
  const std::size_t place = this->PlaceOf(source, k1, k2, t);
  const double denominator = this->Counts.Denominator(place, t);
  const double batches = static_cast<double>(this->Counts.Batches);
  if (!this->HasErrors() || batches < 2.0 || !(denominator > 0.0))
  {
    return NotANumber;
  }
  const ThreePointCounts::Triple& counted = this->Counts.Triples[source.Triple];
  const double ratio = static_cast<double>(counted.Sum[place]) / denominator;
  const double squares = static_cast<double>(counted.Squares[place]) -
    2.0 * ratio * static_cast<double>(counted.Products[place]) +
    ratio * ratio * this->Counts.DenominatorSquares(place, t);
  return std::sqrt(std::max(squares, 0.0) * batches / (batches - 1.0)) / denominator;
}

ThirdOrderIntegrals ThreePointProbability::IntegralsOf(std::size_t triple) const
{
  const ThreePointGrid& grid = this->GetGrid();
  const std::vector<std::int64_t>& sum = this->Counts.Triples[this->Sources[triple].Triple].Sum;
  const double fraction = this->Value(triple, 0, 0, 0);
  return ThirdOrderRule(grid).Integrate(fraction,
    [&](std::size_t place)
    {
      const double all =
        this->Counts.Denominator(place, static_cast<int>(place / grid.SliceSize()));
      return all > 0.0 ? sum[place] / all : fraction * fraction * fraction;
    });
}

ThirdOrderParameters ThreePointProbability::ThirdOrder(std::size_t triple) const
{
  return ThirdOrderRule::Parameters(this->IntegralsOf(triple));
}

ThirdOrderParameters ThreePointProbability::ThirdOrderError(std::size_t triple) const
{
  return ThirdOrderRule::StandardErrors(
    this->IntegralsOf(triple), this->Counts.Triples[this->Sources[triple].Triple].Integrals);
}
}
