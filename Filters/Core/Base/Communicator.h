// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Bytes.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace ruc
{
/**
 * How the ranks of a computation talk to each other. Every method but Rank and Size is collective:
 * all ranks call it, in the same order. This class itself is the single rank of a serial run.
 *
 * What goes from rank to rank may be of any type that Bytes.h writes.
 */
class Communicator
{
public:
  virtual ~Communicator() = default;
  virtual int Rank() const { return 0; }
  virtual int Size() const { return 1; }

  /** Replaces every number by its sum over the ranks. */
  virtual void Sum(std::int64_t* /*values*/, std::size_t /*count*/) {}

  /** Replaces every number by the least that any rank has. */
  virtual void Minimum(std::int32_t* /*values*/, std::size_t /*count*/) {}
  virtual void Minimum(double* /*values*/, std::size_t /*count*/) {}

  /**
   * Replaces every number by its sum over the ranks, which is added up in the order of the ranks.
   * The sum is the same on all ranks and in every run, but not for another number of ranks.
   */
  void Sum(double* values, std::size_t count)
  {
    const std::vector<std::vector<double>> all =
      this->AllGather(std::vector<double>(values, values + count));
    for (std::size_t n = 0; n < count; ++n)
    {
      values[n] = all.front()[n];
      for (std::size_t rank = 1; rank < all.size(); ++rank)
      {
        values[n] += all[rank][n];
      }
    }
  }

  /** Returns whether all ranks say yes. */
  bool All(bool yes)
  {
    std::int32_t least = yes;
    this->Minimum(&least, 1);
    return least != 0;
  }

  /** Returns the lowest rank that says yes, or Size() where none does. */
  int LowestRank(bool yes)
  {
    std::int32_t lowest = yes ? this->Rank() : this->Size();
    this->Minimum(&lowest, 1);
    return lowest;
  }

  /** Replaces the value on every rank by that of rank `root`. */
  template <class Value>
  void Broadcast(Value& value, int root)
  {
    if (this->Size() == 1)
    {
      return;
    }
    std::string bytes = this->Rank() == root ? ToBytes(value) : std::string();
    this->BroadcastBytes(bytes, root);
    if (this->Rank() != root)
    {
      FromBytes(bytes, value);
    }
  }

  /** Returns the values of all ranks, in the order of the ranks. */
  template <class Value>
  std::vector<Value> AllGather(const Value& own)
  {
    if (this->Size() == 1)
    {
      return std::vector<Value>(1, own);
    }
    return FromAllBytes<Value>(this->AllGatherBytes(ToBytes(own), {}));
  }

  /** Returns the values of all ranks in one list, those of rank 0 first. */
  template <class Value>
  std::vector<Value> Concatenate(const std::vector<Value>& own)
  {
    std::vector<Value> all;
    for (const std::vector<Value>& of : this->AllGather(own))
    {
      all.insert(all.end(), of.begin(), of.end());
    }
    return all;
  }

  /**
   * Shares `count` blocks of numbers, of which block n was worked out by rank n % Size(). It lies
   * from values + begin(n) to values + begin(n + 1). Afterwards every rank has all blocks.
   */
  template <class Begin>
  void AllGatherInTurn(double* values, std::size_t count, Begin&& begin)
  {
    const std::size_t size = this->Size();
    if (size == 1)
    {
      return;
    }
    std::string own;
    std::vector<std::size_t> sizes(size, 0);
    for (std::size_t n = 0; n < count; ++n)
    {
      const std::size_t bytes = (begin(n + 1) - begin(n)) * sizeof(double);
      sizes[n % size] += bytes;
      if (n % size == static_cast<std::size_t>(this->Rank()))
      {
        own.append(reinterpret_cast<const char*>(values + begin(n)), bytes);
      }
    }
    const std::vector<std::string> all = this->AllGatherBytes(std::move(own), sizes);
    std::vector<std::size_t> next(size, 0);
    for (std::size_t n = 0; n < count; ++n)
    {
      const std::size_t bytes = (begin(n + 1) - begin(n)) * sizeof(double);
      all[n % size].copy(reinterpret_cast<char*>(values + begin(n)), bytes, next[n % size]);
      next[n % size] += bytes;
    }
  }

  /** Sends `outgoing[q]` to rank q, and returns what came from each rank, this one included. */
  template <class Value>
  std::vector<Value> AllToAll(std::vector<Value> outgoing)
  {
    if (this->Size() == 1)
    {
      return outgoing;
    }
    std::vector<std::string> bytes;
    bytes.reserve(outgoing.size());
    for (Value& value : outgoing)
    {
      bytes.push_back(ToBytes(std::exchange(value, Value{})));
    }
    return FromAllBytes<Value>(this->AllToAllBytes(std::move(bytes)));
  }

  /**
   * Returns the text of the lowest rank that has one that is not empty, or an empty text where none
   * has.
   */
  std::string FirstText(const std::string& text)
  {
    const int first = this->LowestRank(!text.empty());
    std::string shared = text;
    if (first < this->Size())
    {
      this->Broadcast(shared, first);
    }
    return shared;
  }

  /**
   * Throws std::invalid_argument on every rank when `error` is not empty on any rank, with the text
   * of the lowest rank that has one. What can fail on one rank alone is agreed on in this way
   * before any rank goes on.
   */
  void ThrowIfAny(const std::string& error)
  {
    const std::string first = this->FirstText(error);
    if (!first.empty())
    {
      throw std::invalid_argument(first);
    }
  }

  /**
   * Does work that may throw std::invalid_argument on one rank alone, and throws the error of the
   * lowest rank on every rank. The work itself must not be collective.
   */
  template <class Work>
  void Agree(Work&& work)
  {
    std::string error;
    try
    {
      work();
    }
    catch (const std::invalid_argument& e)
    {
      error = e.what();
    }
    this->ThrowIfAny(error);
  }

protected:
  // The same for bytes. They are called only where there is more than one rank. `sizes` says how
  // many bytes every rank gathers, and is empty where the ranks do not know.
  virtual void BroadcastBytes(std::string& /*bytes*/, int /*root*/) {}
  virtual std::vector<std::string> AllGatherBytes(
    std::string own, const std::vector<std::size_t>& /*sizes*/)
  {
    return { std::move(own) };
  }
  virtual std::vector<std::string> AllToAllBytes(std::vector<std::string> outgoing)
  {
    return outgoing;
  }

private:
  template <class Value>
  static std::vector<Value> FromAllBytes(std::vector<std::string> bytes)
  {
    std::vector<Value> values;
    for (std::string& of : bytes)
    {
      FromBytes(std::exchange(of, {}), values.emplace_back());
    }
    return values;
  }
};
}
