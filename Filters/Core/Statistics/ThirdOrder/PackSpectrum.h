// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Statistics/ThirdOrder/ThirdOrderOfSpheres.h"

#include <limits>
#include <tuple>
#include <vector>

namespace ruc
{
/** The degrees of a PackSpectrum. What is above has some 0.5 % of zeta. */
constexpr int LowestOfSpectrum = 2, HighestOfSpectrum = 8;

/**
 * The spectrum Z(l) / (2 (1 - c)) of the spheres of a pack (ThirdOrderOfSpheres), l = 2 to 8, as
 * the target of a cell. Its sums end smoothly at CutOff, three mean diameters for most packs, in a
 * periodic box as in a window: it is one function of a pack and of its cell, so that the cut-off
 * biases neither against the other.
 */
struct PackSpectrum
{
  double CutOff = 0.0;
  std::vector<double> Value, Error; // of every degree; standard errors, > 0
  /** The sum of the spectrum with the rest of all higher degrees, and its standard error. */
  double Zeta = std::numeric_limits<double>::quiet_NaN();
  double ZetaError = std::numeric_limits<double>::quiet_NaN();

  bool Empty() const { return this->Value.empty(); }

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.CutOff, self.Value, self.Error, self.Zeta, self.ZetaError);
  }
};

/**
 * Measures a pack. The result is the same for any number of ranks and threads. Collective.
 *
 * Throws std::invalid_argument, the same on every rank, where MeasureThirdOrder does, for fewer
 * than 100 spheres as far as CutOff from every face, and for blocks without scatter. The text
 * begins with `name`, which requires the spectrum.
 */
PackSpectrum MeasureSpectrum(const PackShare& share, const char* name, Communicator& ranks);

/** Returns zeta of a periodic cell without overlap, measured as that of the pack was. */
double MeasureZeta(const SpherePack& cell, const Window& box, const PackSpectrum& spectrum);

/** What MeasureSpectrum takes. */
Estimate EstimateSpectrum(const PackFigures& pack);

/** The cut-off of a spectrum. */
double SpectrumCutOff(double meanDiameter, double largestDiameter, double fraction);
}
