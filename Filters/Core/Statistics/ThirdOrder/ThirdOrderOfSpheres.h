// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Particles/PackFigures.h"
#include "ruc/Particles/PackShare.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace ruc
{
/** How ThirdOrderOfSpheres is measured. Lengths are in the unit of the pack. */
struct ThirdOrderSettings
{
  /**
   * Spheres closer to a centre than this count: in the degrees above 6 up to three quarters of it.
   * At least two largest diameters, and at most where a centre has 100 000 neighbours. 0 stands for
   * four mean diameters, more where the spheres are sparse or of very different sizes
   * (AutomaticCutOff).
   */
  double CutOff = 0.0;
  int MaximumDegree = 10; // from 4 to GreatestDegree of SolidHarmonics.h
  bool ByMode = false;    // whether every mode is a phase of its own, or all spheres are one
  bool WithEta = true;
  int Blocks = 32; // about the number of blocks for the standard errors, from 2 to 1000
  int Slabs = 4;   // the number of slabs along each axis, from 1 to 100
  // Whether the far field of a periodic box is added; without it the sums end as in a window
  bool WithFarField = true;
  const char* Name = "The third order"; // what requires what, where a pack is refused
};

/** The cut-off that 0 stands for. */
double AutomaticCutOff(double meanDiameter, double largestDiameter, double fraction);

/** A value with its standard error, which is NaN with fewer than two blocks. */
struct ThirdOrderFigure
{
  double Value, Error;
};

/**
 * The three-point parameters of spheres that do not overlap, exact but for the cut-offs, without
 * sampling. With F_r(x) = PV int over phase r of (3nn - 1) / (4 pi d^3) dy they are
 *
 *     I_qrs = 1/3 <chi_q F_r : F_s>,   J_qrs the same with P_4 in place of P_2,
 *     zeta = 9 I_rrr / (2 c_r (1 - c_r)),   eta = 5 zeta / 21 + 150 J_rrr / (7 c_r (1 - c_r)),
 *
 * where zeta and eta are those of ThirdOrderParameters.h. A sphere's own F vanishes inside it, and
 * that of the others is harmonic there, so that I and J are sums over the multipoles around the
 * centres (LocalMultipoles.h).
 *
 * In a box that is periodic along all axes every sphere is a centre, and the far field is Ewald's
 * sum (ThirdOrderEwald.h), unless that would take longer than some minutes. Otherwise the sums end
 * smoothly at the cut-off, and centres lie that far from every face.
 */
struct ThirdOrderOfSpheres
{
  int Sources = 1; // the number of phases but the matrix, which is phase `Sources`
  double CutOff = 0.0;
  int MaximumDegree = 0;
  bool Ewald = false;
  std::int64_t Centres = 0;
  int Blocks = 0;                // that have centres
  std::vector<double> Fractions; // of all phases, the matrix last

  /** Zeta and eta of a phase against all that is not this phase; eta is NaN without WithEta. */
  struct Parameters
  {
    ThirdOrderFigure Zeta, Eta;
  };
  Parameters Spheres;               // all spheres as one phase
  std::vector<Parameters> OfPhases; // of all phases, the matrix last

  /** I_qrs and J_qrs of all phases q and r <= s, at PlaceOf(q, r, s). */
  std::vector<ThirdOrderFigure> Second, Fourth;
  std::size_t PlaceOf(int q, int r, int s) const;

  /**
   * The spectrum Z(l) / (2 (1 - c)), whose sum over l is zeta, for l = 2 to MaximumDegree, and last
   * the rest of all higher degrees. The rest is from each neighbour with itself alone.
   */
  std::vector<ThirdOrderFigure> Spectrum;
  /** Its parts by the phase of the centre and the pair r <= s of phases around, as Spectrum. */
  std::vector<std::vector<double>> SpectrumOf;

  /** Zeta and the fraction of spheres in a slab across an axis. */
  struct Slab
  {
    int Axis; // 0 to 2 along x, y, z, or 3 along the axis of a cylinder
    double From, To;
    std::int64_t Centres;
    double Fraction; // of spheres with their centre in the slab
    ThirdOrderFigure Zeta;
  };
  std::vector<Slab> Slabs;

  /**
   * For every sphere of the share of this rank its part of zeta, the mean of F : F in it over 2 (1
   * - c), so that the mean over the centres, weighted by volume, is zeta. NaN for spheres that are
   * no centres.
   */
  std::vector<double> FieldEnergy;
};

/**
 * Measures a pack. The result is equal, bit by bit, on every rank and for any number of ranks and
 * threads. `progress` is told the share that is done, on the calling thread. Collective.
 *
 * Throws std::invalid_argument, the same on every rank, for settings out of range, more than 32
 * modes as phases, spheres that overlap by more than 0.01 % of their volume or of which two overlap
 * by more than a tenth of a + b, spheres that fill the window, and a window without a centre as far
 * as the cut-off from every face.
 */
ThirdOrderOfSpheres MeasureThirdOrder(const PackShare& share, const ThirdOrderSettings& settings,
  Communicator& ranks, const std::function<void(double)>& progress = {});

/** What MeasureThirdOrder takes. Throws std::invalid_argument for settings out of range. */
Estimate EstimateThirdOrder(const PackFigures& pack, const ThirdOrderSettings& settings);
}
