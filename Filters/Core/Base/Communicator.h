// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

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

  /** Replaces every number by its least over the ranks. */
  virtual void Minimum(std::int32_t* /*values*/, std::size_t /*count*/) {}
  virtual void Minimum(double* /*values*/, std::size_t /*count*/) {}

  /** Whether all ranks say yes. */
  bool All(bool yes)
  {
    std::int32_t least = yes;
    this->Minimum(&least, 1);
    return least != 0;
  }

  /** `outgoing[q]` goes to rank q; returned is what came from each rank, this one included. */
  virtual std::vector<std::vector<double>> Exchange(std::vector<std::vector<double>> outgoing)
  {
    return outgoing;
  }

  /**
   * Throws std::invalid_argument on every rank when `error` is not empty on any, with the text of
   * the lowest rank that has one. What can fail on one rank alone is agreed on in this way before
   * any rank goes on.
   */
  virtual void ThrowIfAny(const std::string& error)
  {
    if (!error.empty())
    {
      throw std::invalid_argument(error);
    }
  }

  /**
   * The same for numbers of which at most one rank holds another value than 0, so that the sum is
   * exact: a way to share out what the ranks worked out each on their own.
   */
  virtual void Share(double* /*values*/, std::size_t /*count*/) {}
};
}
