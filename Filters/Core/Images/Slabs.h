// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace ruc
{
/**
 * How `count` planes, or other parts, are spread over ranks: each has a contiguous range of about
 * the same length, which is empty where there are fewer planes than ranks.
 */
struct Slabs
{
  std::int64_t Count;
  int Ranks;

  /** The first plane of a rank. That of rank `Ranks` is Count. */
  std::int64_t Begin(int rank) const { return this->Count * rank / this->Ranks; }
  std::int64_t End(int rank) const { return this->Begin(rank + 1); }
  std::int64_t Size(int rank) const { return this->End(rank) - this->Begin(rank); }
  /** The most planes that a rank has. */
  std::int64_t Largest() const { return (this->Count + this->Ranks - 1) / this->Ranks; }
};
}
