// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Results/TwoPointChecks.h"

#include "ruc/Base/Text.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <limits>

namespace ruc
{
std::vector<double> Gradient(const std::vector<double>& values, double spacing)
{
  const std::size_t last = values.size() - 1;
  std::vector<double> gradient(values.size());
  for (std::size_t k = 1; k < last; ++k)
  {
    gradient[k] = (values[k + 1] - values[k - 1]) / (2.0 * spacing);
  }
  if (last == 1)
  {
    gradient[0] = gradient[1] = (values[1] - values[0]) / spacing;
  }
  else
  {
    gradient[0] = (-3.0 * values[0] + 4.0 * values[1] - values[2]) / (2.0 * spacing);
    gradient[last] =
      (3.0 * values[last] - 4.0 * values[last - 1] + values[last - 2]) / (2.0 * spacing);
  }
  return gradient;
}

double SaturationLength(
  const std::vector<double>& values, double spacing, double limit, double tolerance, double length)
{
  const std::vector<double> gradient = Gradient(values, spacing);
  std::size_t from = values.size();
  while (from > 0 && std::abs(values[from - 1] - limit) <= tolerance &&
    length * std::abs(gradient[from - 1]) <= tolerance)
  {
    --from;
  }
  return from < values.size() ? from * spacing : std::numeric_limits<double>::quiet_NaN();
}

std::vector<TwoPointCheck> CheckTwoPointProbability(
  const TwoPointProbability& probability, double tolerance, double length)
{
  std::vector<TwoPointCheck> checks;
  for (int r = 0; r < probability.Phases(); ++r)
  {
    for (int s = r; s < probability.Phases(); ++s)
    {
      const std::vector<double>& values = probability.S(r, s);
      TwoPointCheck check;
      check.Limit = probability.Fractions[r] * probability.Fractions[s];
      check.ErrorAtZero = std::abs(values.front() - (r == s ? probability.Fractions[r] : 0.0));
      check.ErrorAtInfinity = std::abs(values.back() - check.Limit);
      check.SaturationLength =
        SaturationLength(values, probability.Lags.Spacing, check.Limit, tolerance, length);
      checks.push_back(check);
    }
  }
  return checks;
}

double SaturationLength(const TwoPointProbability& probability, double tolerance, double length)
{
  double largest = 0.0;
  for (const TwoPointCheck& check : CheckTwoPointProbability(probability, tolerance, length))
  {
    if (std::isnan(check.SaturationLength))
    {
      return check.SaturationLength;
    }
    largest = std::max(largest, check.SaturationLength);
  }
  return largest;
}

void RequireProbabilities(const TwoPointProbability& probability, double tolerance)
{
  const auto name = [&](int r, int s)
  { return "S_" + probability.PhaseName(r) + "_" + probability.PhaseName(s); };
  double total = 0.0;
  for (int r = 0; r < probability.Phases(); ++r)
  {
    const double fraction = probability.S(r, r)[0];
    total += fraction;
    if (!(fraction > 0.0))
    {
      throw std::invalid_argument(
        Text("A target requires fractions > 0, got ", fraction, " for ", name(r, r), " at r = 0."));
    }
    for (int k = 0; k <= probability.Lags.Count; ++k)
    {
      double sum = 0.0;
      for (int s = 0; s < probability.Phases(); ++s)
      {
        const double value = probability.S(r, s)[k];
        sum += value;
        if (!(value >= -tolerance && value <= 1.0 + tolerance))
        {
          throw std::invalid_argument(Text("A target requires probabilities from 0 to 1, got ",
            value, " for ", name(r, s), " at r = ", k * probability.Lags.Spacing, "."));
        }
      }
      if (!(std::abs(sum - fraction) <= tolerance))
      {
        throw std::invalid_argument(Text("A target requires that the S_", probability.PhaseName(r),
          "_s add up to the fraction of phase ", probability.PhaseName(r), ", ", fraction,
          ", at every lag, got ", sum, " at r = ", k * probability.Lags.Spacing, "."));
      }
    }
  }
  if (!(std::abs(total - 1.0) <= tolerance))
  {
    throw std::invalid_argument(
      Text("A target requires fractions, S_rr at r = 0, that add up to 1, got ", total, "."));
  }
}
}
