// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Text.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace ruc
{
/**
 * The interval of the values that a setting may have. NaN and infinite values are in no interval.
 */
class Range
{
public:
  static constexpr Range AtLeast(double low) { return { low, true, Infinity }; }
  static constexpr Range Above(double low) { return { low, false, Infinity }; }
  /** From `low` to `high`, both included. */
  static constexpr Range From(double low, double high) { return { low, true, high }; }
  /** Above `low` up to `high`, which is included. */
  static constexpr Range Above(double low, double high) { return { low, false, high }; }

  bool Contains(double value) const
  {
    return std::isfinite(value) && value <= this->High &&
      (this->LowIsIncluded ? value >= this->Low : value > this->Low);
  }

  /** The condition as text, such as "0 < MutatedShare <= 1" or "Population >= 2". */
  std::string Describe(const char* name) const
  {
    return this->High == Infinity
      ? Text(name, this->LowIsIncluded ? " >= " : " > ", this->Low)
      : Text(this->Low, this->LowIsIncluded ? " <= " : " < ", name, " <= ", this->High);
  }

  /**
   * Throws std::invalid_argument, such as "Population requires Population >= 2, got 1.", for a
   * value outside.
   */
  void Check(const char* name, double value) const
  {
    if (!this->Contains(value))
    {
      throw std::invalid_argument(
        Text(name, " requires ", this->Describe(name), ", got ", value, "."));
    }
  }

private:
  static constexpr double Infinity = std::numeric_limits<double>::infinity();

  constexpr Range(double low, bool lowIsIncluded, double high)
    : Low(low)
    , LowIsIncluded(lowIsIncluded)
    , High(high)
  {
  }

  double Low;
  bool LowIsIncluded;
  double High;
};
}
