// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/**
 * @file
 * Ranks within one process, for testing what ranks do together without MPI.
 */

#include "ruc/Base/Communicator.h"
#include "ruc/Particles/SpherePack.h"

#include <omp.h>

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace oracle
{
/** What the ranks share: a barrier, and a place for the data of each. */
class ThreadRanks
{
public:
  explicit ThreadRanks(int size)
    : Numbers(size)
    , Integers(size)
    , Texts(size)
    , Mail(size)
    , Size(size)
  {
  }

  /**
   * Runs work(communicator) as every rank at once, and rethrows what the lowest rank threw. Either
   * all ranks or none must throw.
   */
  static void Run(int size, const std::function<void(ruc::Communicator&)>& work)
  {
    // With the thread sanitizer, Clang's OpenMP reads what belongs to the thread that came first to
    // it: let that be one that stays
    omp_get_max_threads();
    ThreadRanks shared(size);
    std::vector<std::exception_ptr> errors(size);
    std::vector<std::thread> threads;
    for (int rank = 0; rank < size; ++rank)
    {
      threads.emplace_back(
        [&, rank]()
        {
          Member member(shared, rank);
          try
          {
            work(member);
          }
          catch (...)
          {
            errors[rank] = std::current_exception();
          }
        });
    }
    for (std::thread& thread : threads)
    {
      thread.join();
    }
    for (const std::exception_ptr& error : errors)
    {
      if (error)
      {
        std::rethrow_exception(error);
      }
    }
  }

private:
  class Member : public ruc::Communicator
  {
  public:
    Member(ThreadRanks& shared, int rank)
      : Shared(shared)
      , Own(rank)
    {
    }
    int Rank() const override { return this->Own; }
    int Size() const override { return this->Shared.Size; }
    void Sum(std::int64_t* values, std::size_t count) override
    {
      this->Reduce(this->Shared.Integers, values, count, [](auto a, auto b) { return a + b; });
    }
    using ruc::Communicator::Sum; // the sum of doubles
    void Minimum(std::int32_t* values, std::size_t count) override
    {
      std::vector<std::int64_t> wide(values, values + count);
      this->Reduce(
        this->Shared.Integers, wide.data(), count, [](auto a, auto b) { return std::min(a, b); });
      std::copy(wide.begin(), wide.end(), values);
    }
    void Minimum(double* values, std::size_t count) override
    {
      this->Reduce(
        this->Shared.Numbers, values, count, [](auto a, auto b) { return std::min(a, b); });
    }

  protected:
    void BroadcastBytes(std::string& bytes, int root) override
    {
      bytes = this->AllGatherBytes(std::move(bytes), {})[root];
    }
    std::vector<std::string> AllGatherBytes(
      std::string own, const std::vector<std::size_t>&) override
    {
      this->Shared.Texts[this->Own] = std::move(own);
      this->Shared.Wait();
      const std::vector<std::string> all = this->Shared.Texts;
      this->Shared.Wait();
      return all;
    }
    std::vector<std::string> AllToAllBytes(std::vector<std::string> outgoing) override
    {
      this->Shared.Mail[this->Own] = std::move(outgoing);
      this->Shared.Wait();
      std::vector<std::string> incoming;
      for (int rank = 0; rank < this->Shared.Size; ++rank)
      {
        incoming.push_back(this->Shared.Mail[rank][this->Own]);
      }
      this->Shared.Wait();
      return incoming;
    }

  private:
    template <class Value, class Operation>
    void Reduce(std::vector<std::vector<Value>>& places, Value* values, std::size_t count,
      Operation&& operation)
    {
      places[this->Own].assign(values, values + count);
      this->Shared.Wait();
      for (std::size_t n = 0; n < count; ++n)
      {
        values[n] = places[0][n];
        for (int rank = 1; rank < this->Shared.Size; ++rank)
        {
          values[n] = operation(values[n], places[rank][n]);
        }
      }
      this->Shared.Wait();
    }

    ThreadRanks& Shared;
    int Own;
  };

  void Wait()
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    const std::size_t round = this->Round;
    if (++this->Waiting == this->Size)
    {
      this->Waiting = 0;
      ++this->Round;
      this->Condition.notify_all();
      return;
    }
    this->Condition.wait(lock, [&]() { return this->Round != round; });
  }

  std::vector<std::vector<double>> Numbers;
  std::vector<std::vector<std::int64_t>> Integers;
  std::vector<std::string> Texts;
  std::vector<std::vector<std::string>> Mail;
  int Size;
  int Waiting = 0;
  std::size_t Round = 0;
  std::mutex Mutex;
  std::condition_variable Condition;
};

/** A rank's piece of a pack that is spread in turn, or lies on the last rank. */
inline ruc::SpherePack PieceOf(const ruc::SpherePack& pack, int rank, int ranks, bool allOnLast)
{
  ruc::SpherePack piece;
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    if ((allOnLast ? ranks - 1 : static_cast<int>(i % ranks)) == rank)
    {
      piece.Append(pack, i);
    }
  }
  return piece;
}
}
