// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Statistics/Results/TwoPointProbability.h"
#include "ruc/Statistics/ThirdOrder/ThreePointProbability.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace ruc
{
/**
 * S_rsq along a line on which it degenerates, against what it must be there, with one number for
 * each lag.
 */
struct DegenerateLimit
{
  std::string Place;    // "r1 axis", "r2 axis" or "diagonal"
  std::string Expected; // "S_3_5", or "0"
  std::vector<double> Values;
  std::vector<double> Errors; // standard errors; NaN where there are none
  std::vector<double> Limit;

  /** || Values - Limit ||, the discrete norm over k = 1…K. */
  double Difference() const;
  /** || Errors ||, with the same norm. */
  double StandardError() const;
};

/**
 * Returns the limits of a triple, equation (10) of Lee et al., Phys. Rev. E 80, 061301 (2009),
 * against two-point functions on the same lags: S_rs delta_rq on the r1 axis (r2 = 0), S_rq
 * delta_rs on the r2 axis (r1 = 0), and S_rs delta_sq on the diagonal (r1 = r2 at theta = 0).
 */
std::array<DegenerateLimit, 3> FindDegenerateLimits(const ThreePointProbability& probability,
  std::size_t triple, const TwoPointProbability& twoPoint);
}
