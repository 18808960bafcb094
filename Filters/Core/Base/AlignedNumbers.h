// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace ruc
{
/** Begins at a cache line, so that vectors of 64 bytes do not lie across two of them. */
template <class Number>
struct CacheLineAllocator
{
  using value_type = Number;
  static constexpr std::align_val_t Alignment{ 64 };

  CacheLineAllocator() = default;
  template <class Other>
  CacheLineAllocator(const CacheLineAllocator<Other>&)
  {
  }
  Number* allocate(std::size_t count)
  {
    return static_cast<Number*>(::operator new(count * sizeof(Number), Alignment));
  }
  void deallocate(Number* numbers, std::size_t) { ::operator delete(numbers, Alignment); }

  template <class Other>
  bool operator==(const CacheLineAllocator<Other>&) const
  {
    return true;
  }
  template <class Other>
  bool operator!=(const CacheLineAllocator<Other>&) const
  {
    return false;
  }
};

/** Numbers that loops over vectors read and write many times. */
using AlignedNumbers = std::vector<double, CacheLineAllocator<double>>;
}
