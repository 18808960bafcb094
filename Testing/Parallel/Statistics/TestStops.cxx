// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Sums over pairs that are stopped end on all ranks, have no result, and say so
#include "Refusals.h"
#include "Stops.h"

#include "vtkRUCDirectionalProbability.h"
#include "vtkRUCProbabilityMap.h"
#include "vtkRUCRadialDistribution.h"
#include "vtkRUCTwoPointProbability.h"

namespace
{
template <class Filter>
void HasNothingWhereStopped()
{
  vtkNew<Filter> filter;
  const StopAt stop(filter, 0);
  const Errors errors(filter);
  filter->SetInputData(MakePolyData(FewSizes(), Edge, true, IsMine));
  filter->Update();
  ExpectRefusal(filter, errors, { "The sum was stopped before its end" });
}
}

TEST(Stops, OfSumsOverPairs)
{
  HasNothingWhereStopped<vtkRUCTwoPointProbability>();
  HasNothingWhereStopped<vtkRUCDirectionalProbability>();
  HasNothingWhereStopped<vtkRUCProbabilityMap>();
  HasNothingWhereStopped<vtkRUCRadialDistribution>();
}
