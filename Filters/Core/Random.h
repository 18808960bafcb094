// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Random123/philox.h>

#include <array>
#include <cstdint>

namespace ruc
{
/**
 * Three numbers uniform in [0, 1) that depend on (seed, stream, sample) alone: Philox4x32-10 of
 * Random123 with the seed as key. The same on every rank, thread and machine.
 */
inline std::array<double, 3> UniformTriple(
  std::uint32_t seed, std::uint32_t stream, std::uint64_t sample)
{
  const r123::Philox4x32::ctr_type counter = { { static_cast<std::uint32_t>(sample),
    static_cast<std::uint32_t>(sample >> 32), stream, 0 } };
  const r123::Philox4x32::key_type key = { { seed, 0 } };
  const r123::Philox4x32::ctr_type bits = r123::Philox4x32()(counter, key);
  return { bits[0] * 0x1p-32, bits[1] * 0x1p-32, bits[2] * 0x1p-32 };
}
}
