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
/** The phases r, s, q of S_rsq, counted from 0, the matrix last. */
struct PhaseTriple
{
  int R, S, Q;

  bool operator==(const PhaseTriple& other) const
  {
    return this->R == other.R && this->S == other.S && this->Q == other.Q;
  }
};

/**
 * Returns the triples in a text such as "3 5 5; 7 7 5; m m m" (phases 1 to `modes` and m; what is
 * repeated counts once), or in "all". "all" means every r and s <= q, N^2 (N + 1) / 2 of them for N
 * phases, which is all there is to know, since S_rqs(r1, r2) = S_rsq(r2, r1). Throws
 * std::invalid_argument for any other text.
 */
std::vector<PhaseTriple> ParseTriples(const std::string& text, int modes);

/** The name of a triple, such as "S_3_5_5". */
std::string TripleName(const PhaseTriple& triple, int modes);

/**
 * What throws of fans of rays have counted, as whole numbers. A batch b of throws counts N_b(r1,
 * r2, theta), the ordered pairs of rays at the angle theta for which the centre, the point at r1 on
 * the first and the point at r2 on the second ray lie in phases r, s, q; and D_b, those for which
 * all three lie in the region.
 */
struct ThreePointCounts
{
  int Modes = 0;
  ThreePointGrid Grid = {};
  bool WithErrors = false;
  std::int64_t Throws = 0;
  std::int64_t Batches = 0;       // the number of batches
  std::int64_t ThrowsSquares = 0; // the sum over batches of their squared numbers of throws

  struct Triple
  {
    PhaseTriple Phases;                          // s <= q
    std::vector<std::int64_t> Sum;               // the sum of N_b over batches
    std::vector<std::int64_t> Squares, Products; // with errors, the sums of N_b^2 and N_b D_b
    std::vector<ThirdOrderIntegrals> Integrals;  // with errors and for r = s = q, of every batch
  };
  std::vector<Triple> Triples;
  // The sums over batches of D_b and D_b^2. They are empty where every point is in the region, so
  // that D_b is the number of throws times that of ray pairs.
  std::vector<std::int64_t> Inside, InsideSquares;

  double Denominator(std::size_t place, int t) const;
  double DenominatorSquares(std::size_t place, int t) const;
};

/**
 * The three-point probability functions of chosen triples of phases,
 *
 *     S_rsq(r1, r2, theta) = probability that x lies in phase r, x + r1 u in s and x + r2 v in q,
 *
 * where theta is the angle between u and v, averaged over x and over the orientations of u and v
 * (Lee et al., Phys. Rev. E 80, 061301, 2009, section III). The normalisation is raw: S_rrr = c_r
 * where r1 = r2 = 0.
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

  /** S_rsq; NaN where no three points of a throw lay in the region. */
  double Value(std::size_t triple, int k1, int k2, int t) const;

  /**
   * The standard error of S_rsq, an absolute probability, from batches of throws. It is NaN where
   * S_rsq is, without errors, and with a single batch.
   */
  double Error(std::size_t triple, int k1, int k2, int t) const;

  /**
   * Zeta and eta of the phase of a triple r = s = q (see ThirdOrderRule). Where no three points lay
   * in the region, which are then far apart, S_rrr is taken as c^3. They are NaN without throws in
   * the phase, and for a number of directions for which the rule is not valid.
   */
  ThirdOrderParameters ThirdOrder(std::size_t triple) const;
  /** Their standard errors, which are NaN without errors and with a single batch. */
  ThirdOrderParameters ThirdOrderError(std::size_t triple) const;

private:
  struct Source
  {
    std::size_t Triple; // the place of the counted triple
    bool Swapped;       // whether r1 and r2 change places, as s > q
  };
  std::size_t PlaceOf(const Source& source, int k1, int k2, int t) const;
  ThirdOrderIntegrals IntegralsOf(std::size_t triple) const;

  ThreePointCounts Counts;
  std::vector<PhaseTriple> Triples;
  std::vector<Source> Sources;
};
}
