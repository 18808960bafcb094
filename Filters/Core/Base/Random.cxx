// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Base/Random.h"

#include <Random123/philox.h>

#include <algorithm>

namespace ruc
{
std::array<double, 3> UniformTriple(
  std::uint32_t seed, RandomStream stream, std::uint64_t sample, std::uint32_t part)
{
  const r123::Philox4x32::ctr_type counter = { { static_cast<std::uint32_t>(sample),
    static_cast<std::uint32_t>(sample >> 32), static_cast<std::uint32_t>(stream) + part, 0 } };
  const r123::Philox4x32::key_type key = { { seed, 0 } };
  const r123::Philox4x32::ctr_type bits = r123::Philox4x32()(counter, key);
  return { bits[0] * 0x1p-32, bits[1] * 0x1p-32, bits[2] * 0x1p-32 };
}

RandomSequence::RandomSequence(std::uint32_t seed, RandomStream stream, std::uint64_t sequence)
  : Seed(seed)
  , Stream(stream)
  , Sample(sequence << 24)
{
}

double RandomSequence::Next()
{
  if (this->Used == 3)
  {
    this->Triple = UniformTriple(this->Seed, this->Stream, this->Sample++);
    this->Used = 0;
  }
  return this->Triple[this->Used++];
}

int RandomSequence::NextIndex(int count)
{
  return std::min(static_cast<int>(this->Next() * count), count - 1);
}
}
