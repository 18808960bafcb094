// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Statistics/Results/LagGrid.h"
#include "ruc/Statistics/ThirdOrder/ThirdOrderParameters.h"
#include "ruc/Statistics/ThirdOrder/ThreePointGrid.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ruc
{
/** The phases r, s, q of S_rsq; counted from 0, the matrix last. */
struct PhaseTriple
{
  int R, S, Q;

  bool operator==(const PhaseTriple& other) const
  {
    return this->R == other.R && this->S == other.S && this->Q == other.Q;
  }
};

/**
 * The triples in a text such as "3 5 5; 7 7 5; m m m" (phases 1 to `modes` and m; what is repeated
 * counts once), or in "all": every r and s <= q, N^2 (N + 1) / 2 of them for N phases, which is all
 * there is to know, since S_rqs(r1, r2) = S_rsq(r2, r1).
 * Throws std::invalid_argument for any other text.
 */
std::vector<PhaseTriple> ParseTriples(const std::string& text, int modes);

/** "S_3_5_5" */
std::string TripleName(const PhaseTriple& triple, int modes);

/**
 * What throws of fans of rays have counted, as whole numbers. A throw b counts N_b(r1, r2, theta):
 * its ordered pairs of rays at the angle theta, r1 along the first and r2 along the second, with
 * centre and both points in phases r, s, q; and D_b: with all three in the region.
 */
struct ThreePointCounts
{
  int Modes = 0;
  ThreePointGrid Grid = {};
  bool WithErrors = false;
  std::int64_t Throws = 0;
  std::int64_t Batches = 0;       // of throws
  std::int64_t ThrowsSquares = 0; // of the throws of every batch

  struct Triple
  {
    PhaseTriple Phases;                          // s <= q
    std::vector<std::int64_t> Sum;               // over batches, of N_b
    std::vector<std::int64_t> Squares, Products; // of N_b^2 and N_b D_b, with errors
    std::vector<ThirdOrderIntegrals> Integrals;  // of every batch, with errors and for r = s = q
  };
  std::vector<Triple> Triples;
  // Sums over batches of D_b and D_b^2; empty where every point is in the region, so that D_b is
  // the number of its throws times that of ray pairs
  std::vector<std::int64_t> Inside, InsideSquares;

  double Denominator(std::size_t place, int t) const;
  double DenominatorSquares(std::size_t place, int t) const;
};

/**
 * The three-point probability functions of chosen triples of phases,
 *
 *     S_rsq(r1, r2, theta) = probability that x lies in phase r, x + r1 u in s and x + r2 v in q,
 *
 * theta being the angle between u and v, averaged over x and over the orientations of u and v (Lee
 * et al., Phys. Rev. E 80, 061301, 2009, section III). Normalisation is raw: S_rrr = c_r where r1 =
 * r2 = 0.
 */
class ThreePointProbability
{
public:
  /** The triples that are to be known must be among those counted, in either order of s and q. */
  ThreePointProbability(ThreePointCounts counts, std::vector<PhaseTriple> triples);

  int GetModes() const { return this->Counts.Modes; }
  const ThreePointGrid& GetGrid() const { return this->Counts.Grid; }
  const std::vector<PhaseTriple>& GetTriples() const { return this->Triples; }
  bool HasErrors() const { return this->Counts.WithErrors; }
  std::int64_t GetThrows() const { return this->Counts.Throws; }

  /** S_rsq; not a number where no three points of a throw lay in the region. */
  double Value(std::size_t triple, int k1, int k2, int t) const;

  /** Its standard error, from batches of throws; not a number where S_rsq is, without errors and
   * with a single batch. */
  double Error(std::size_t triple, int k1, int k2, int t) const;

  /**
   * Zeta and eta of the phase of a triple r = s = q; see ThirdOrderRule. Where no three points lay
   * in the region, which are far apart, S_rrr is taken as c^3. Not numbers without throws in the
   * phase, and for directions the rule does not take.
   */
  ThirdOrderParameters ThirdOrder(std::size_t triple) const;
  /** Their standard errors; not numbers without errors and with a single batch. */
  ThirdOrderParameters ThirdOrderError(std::size_t triple) const;

private:
  struct Source
  {
    std::size_t Triple; // that was counted
    bool Swapped;       // r1 and r2, where s > q
  };
  std::size_t PlaceOf(const Source& source, int k1, int k2, int t) const;
  ThirdOrderIntegrals IntegralsOf(std::size_t triple) const;

  ThreePointCounts Counts;
  std::vector<PhaseTriple> Triples;
  std::vector<Source> Sources;
};
}
