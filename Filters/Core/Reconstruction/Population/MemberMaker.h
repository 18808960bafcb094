// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Particles/PackOverlap.h"
#include "ruc/Reconstruction/CellObjective.h"
#include "ruc/Reconstruction/Population/GeneticOperators.h"

#include <omp.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace ruc
{
/** A cell of a population with what its fitness is made of. */
struct Member
{
  Chromosome Centres;
  double Objective = 0.0;
  double OverlapPercent = 0.0;
};

/** Makes and evaluates members of a population on all ranks and threads, each member on one. */
class MemberMaker
{
public:
  /** All that is referred to must outlive the maker. */
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
   * Collective: members `first` to `last` - 1 on all ranks. make(n) returns the centres of the n-th
   * and is called by any thread of any rank, once for each.
   */
  template <class Function>
  std::vector<Member> Make(int first, int last, Function&& make)
  {
    const std::size_t length = 3 * std::size_t(this->Contents.NumberOfSpheres());
    const std::size_t stride = length + 2;
    const int number = last - first;
    std::vector<double> numbers(number * stride, 0.0);
    const int rank = this->Ranks.Rank(), ranks = this->Ranks.Size();
#pragma omp parallel for schedule(dynamic) num_threads(this->OfThread.size())
    for (int n = rank; n < number; n += ranks)
    {
      double* place = &numbers[n * stride];
      const Chromosome centres = make(first + n);
      std::copy(centres.begin(), centres.end(), place);
      this->Evaluate(centres, place[length], place[length + 1]);
    }
    this->Ranks.AllGatherInTurn(numbers.data(), number, [&](std::size_t n) { return n * stride; });
    std::vector<Member> members(number);
    for (int n = 0; n < number; ++n)
    {
      const double* place = &numbers[n * stride];
      members[n] = { Chromosome(place, place + length), place[length], place[length + 1] };
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
