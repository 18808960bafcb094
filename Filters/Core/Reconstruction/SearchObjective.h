// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Reconstruction/CellObjective.h"
#include "ruc/Reconstruction/ContactMultipliers.h"
#include "ruc/Reconstruction/ContactTerm.h"
#include "ruc/Reconstruction/NeighbourMisfits.h"
#include "ruc/Reconstruction/PoreTerm.h"
#include "ruc/Reconstruction/SpectrumTerm.h"
#include "ruc/Reconstruction/ThirdOrderTerm.h"

#include <cstdint>
#include <optional>

namespace ruc
{
/** What near neighbours, pores, the spectrum and third order weigh, and those of the pack. */
struct NeighbourTarget
{
  // >= 0; 0 is as if there was no such term
  double ContactWeight = 0.0, PoreWeight = 0.0, SpectrumWeight = 0.0, ThirdOrderWeight = 0.0;
  NeighbourSums Pack;
  PackSpectrum Spectrum;
  NeighbourhoodMultipoles ThirdOrder;

  /** Whether any weight is > 0, be there a pack or not. */
  bool IsWanted() const
  {
    return this->ContactWeight + this->PoreWeight + this->SpectrumWeight + this->ThirdOrderWeight >
      0.0;
  }

  bool HasContacts() const
  {
    return this->ContactWeight > 0.0 && !(this->Pack.Gaps.Empty() && this->Pack.Nearest.Empty());
  }
  bool HasPores() const { return this->PoreWeight > 0.0 && !this->Pack.Pores.Empty(); }
  bool HasSpectrum() const { return this->SpectrumWeight > 0.0 && !this->Spectrum.Empty(); }
  bool HasThirdOrder() const
  {
    return this->ThirdOrderWeight > 0.0 && !this->ThirdOrder.Value.empty();
  }
  bool Empty() const
  {
    return !this->HasContacts() && !this->HasPores() && !this->HasSpectrum() &&
      !this->HasThirdOrder();
  }
};

/**
 * What a gradient search minimises, a sum of terms. At first it is
 *
 *     L = F2 + the overlap penalty (CellObjective), or of a dense cell the multipliers' term.
 *
 * From BeginNeighbours on it is
 *
 *     L = F2 + penalty or multipliers +
 *         F0 ((contact weight (gaps + nearest) + pore weight pores) / 20 +
 *             spectrum weight spectrum + third-order weight third order),
 *
 * where the misfits are those of ContactTerm, PoreTerm, SpectrumTerm and ThirdOrderTerm. The
 * reference F0 is the F2 that one unit of a misfit is worth. Near neighbours and pores, which are
 * hundreds of units off at first and stiff, come near enough with a twentieth of it. All
 * ranks get the same bits.
 */
class SearchObjective
{
public:
  /** `target`, `neighbours`, `contacts` and `communicator` are kept as references. */
  SearchObjective(const CellContents& contents, const TwoPointProbability& target,
    const NeighbourTarget& neighbours, bool dense, ContactState& contacts,
    Communicator& communicator);

  /** Adds the terms of NeighbourTarget, for a reference F0 > 0. */
  void BeginNeighbours(double reference);
  /** Moves the lattice of the pores to its n-th place. */
  void MoveLattice(int n);

  struct Terms
  {
    double TwoPoint = 0.0;    // F2
    NeighbourMisfits Misfits; // from BeginNeighbours on
    double Total = 0.0;       // L
  };
  /** Evaluates L, and its gradient unless that is null. See CellObjective. Collective. */
  Terms Evaluate(const double* centres, double* gradient, std::int64_t* signal);

  /** Returns the misfits of a cell, those of terms that weigh something. Collective. */
  NeighbourMisfits FindMisfits(const double* centres);
  /** Returns L of a cell without overlap, F2 being known. */
  double ValueOf(double twoPoint, const NeighbourMisfits& misfits) const;

  const TwoPointProbability& GetProbability() const { return this->Pairs.GetProbability(); }
  /** The multipliers of a dense cell. */
  ContactMultipliers& Multipliers() { return *this->Contacts; }

private:
  NeighbourMisfits AddNeighbours(const double* centres, double* gradient);
  /** What one unit of each misfit is worth. */
  NeighbourMisfits Worths() const;

  const NeighbourTarget& Neighbours;
  CellObjective Pairs;
  std::optional<ContactMultipliers> Contacts;
  std::optional<ContactTerm> Near;
  std::optional<PoreTerm> Pores;
  std::optional<SpectrumTerm> Spectrum;
  std::optional<ThirdOrderTerm> ThirdOrder;
  double Reference = 0.0; // 0 before the terms of neighbours are added
};
}
