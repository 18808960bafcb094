// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace ruc
{
/**
 * How the ranks of a computation that has to talk in every step do so. Every method is collective;
 * this class itself is the one rank of a serial run.
 */
class Communicator
{
public:
  virtual ~Communicator() = default;
  virtual int Rank() const { return 0; }
  virtual int Size() const { return 1; }

  /** Replaces every number by its sum over the ranks. */
  virtual void Sum(std::int64_t* /*values*/, std::size_t /*count*/) {}

  /**
   * The same for numbers of which at most one rank holds another value than 0, so that the sum is
   * exact: a way to share out what the ranks worked out each on their own.
   */
  virtual void Share(double* /*values*/, std::size_t /*count*/) {}
};
}
