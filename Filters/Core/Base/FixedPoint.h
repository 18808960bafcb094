// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace ruc
{
/**
 * Adding 1.5 x 2^52 to a number of magnitude below 2^51 rounds it to a whole number and leaves that
 * number in the low bits of the sum; unlike std::llrint this vectorises on every instruction set.
 */
constexpr double FixedPointRounder = 6755399441055744.0;

/** Returns the whole number nearest to `value`, where |value| < 2^51. */
inline std::int64_t RoundToFixedPoint(double value)
{
  const double shifted = value + FixedPointRounder;
  std::int64_t bits, base;
  std::memcpy(&bits, &shifted, sizeof(bits));
  std::memcpy(&base, &FixedPointRounder, sizeof(base));
  return bits - base;
}

/** Adds to every sum a value, which is held to +-most, times `scale` < 2^51 / most, as above. */
void AddFixedPoint(
  const double* values, std::size_t count, double most, double scale, std::int64_t* sums);

/**
 * Adds a number to a sum of fixed-point numbers that 64 bits cannot hold. The sum is limbs[0] +
 * 2^32 limbs[1]. Such sums may be added limb by limb; neither limb overflows before 2^31 numbers
 * were added.
 */
inline void AddWide(std::int64_t value, std::int64_t* limbs)
{
  limbs[0] += value & 0xffffffff;
  limbs[1] += value >> 32;
}

/** Returns the double nearest to such a sum. */
inline double WideValue(const std::int64_t* limbs)
{
  __extension__ using Wide = __int128;
  return static_cast<double>(Wide(limbs[1]) * (Wide(1) << 32) + limbs[0]);
}
}
