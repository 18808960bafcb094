// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Particles/PackOverlap.h"
#include "ruc/Reconstruction/CellObjective.h"
#include "ruc/Reconstruction/Population/PopulationState.h"

#include <omp.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

namespace ruc
{
/**
 * Makes and evaluates the members of a population on all ranks and threads, each member on one
 * thread of one rank.
 */
class MemberMaker
{
public:
  /** All arguments must outlive the maker. */
  MemberMaker(
    const CellContents& contents, const TwoPointProbability& target, Communicator& communicator)
    : Contents(contents)
    , Ranks(communicator)
  {
    for (int thread = 0; thread < omp_get_max_threads(); ++thread)
    {
      this->OfThread.push_back(std::make_unique<CellObjective>(contents, target, this->Serial));
    }
  }

  /**
   * Makes the members `first` to `last` - 1 and returns them on all ranks. make(n, goesOn) returns
   * the centres of the n-th member. It is called once for each, by any thread of any rank.
   * Collective.
   *
   * Meanwhile carryOn() is asked again and again on the thread that calls this. When it says no,
   * this rank begins no other member, and goesOn(), which a long make() asks, says no as well. A
   * member that is not made then has no centres on any rank (Member::IsMade).
   */
  template <class Function, class Question>
  std::vector<Member> Make(int first, int last, Function&& make, Question&& carryOn)
  {
    const std::size_t length = 3 * std::size_t(this->Contents.NumberOfSpheres());
    const std::size_t stride = length + 3; // centres, F2, overlap, and 1 if the member is made
    const int number = last - first;
    std::vector<double> numbers(number * stride, 0.0);
    const int rank = this->Ranks.Rank(), ranks = this->Ranks.Size();
    std::atomic<bool> stopped(false);
    std::atomic<int> left((number - rank + ranks - 1) / ranks);
    const std::function<bool()> goesOn = [&, caller = std::this_thread::get_id()]()
    {
      if (!stopped && std::this_thread::get_id() == caller && !carryOn())
      {
        stopped = true;
      }
      return !stopped;
    };
#pragma omp parallel num_threads(this->OfThread.size())
    {
#pragma omp for schedule(dynamic) nowait
      for (int n = rank; n < number; n += ranks)
      {
        double* place = &numbers[n * stride];
        if (const Chromosome centres = goesOn() ? make(first + n, goesOn) : Chromosome(); !stopped)
        {
          std::copy(centres.begin(), centres.end(), place);
          this->Evaluate(centres, place[length], place[length + 1]);
          place[length + 2] = 1.0;
        }
        --left;
      }
      while (omp_get_thread_num() == 0 && left > 0 && goesOn())
      {
        std::this_thread::sleep_for(std::chrono::milliseconds(1)); // other threads still work
      }
    }
    this->Ranks.AllGatherInTurn(numbers.data(), number, [&](std::size_t n) { return n * stride; });
    std::vector<Member> members(number);
    for (int n = 0; n < number; ++n)
    {
      const double* place = &numbers[n * stride];
      if (place[length + 2] == 1.0)
      {
        members[n] = { Chromosome(place, place + length), place[length], place[length + 1] };
      }
    }
    return members;
  }

private:
  void Evaluate(const Chromosome& centres, double& objective, double& overlapPercent)
  {
    CellObjective& evaluator = *this->OfThread[omp_get_thread_num()];
    objective = evaluator.Evaluate(centres.data(), nullptr).TwoPoint;
    overlapPercent =
      MeasureOverlap(this->Contents.MakePack(centres.data()), this->Contents.MakeBox()).Percent;
  }

  const CellContents& Contents;
  Communicator& Ranks;
  Communicator Serial;
  std::vector<std::unique_ptr<CellObjective>> OfThread;
};
}
