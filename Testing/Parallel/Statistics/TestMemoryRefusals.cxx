// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Work that would take more memory than it may is refused before it begins, on all ranks
#include "Refusals.h"

#include "vtkRUCChordLengths.h"
#include "vtkRUCDirectionalProbability.h"
#include "vtkRUCOnePointProbability.h"
#include "vtkRUCProbabilityMap.h"
#include "vtkRUCTwoPointProbability.h"

#include "vtkInformation.h"
#include "vtkImageAlgorithm.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTrivialProducer.h"

#include <limits>

namespace
{
const std::vector<std::string> TooLittle = { "MemoryLimit requires at least", "MB on every rank" };

// With a pack of which rank 0 has none where there are several
template <class Filter>
void ExpectRefused(double limit, const std::function<void(Filter*)>& configure)
{
  vtkNew<Filter> filter;
  const Errors errors(filter);
  filter->SetInputData(MakePolyData(
    FewSizes(), Edge, true, [](std::size_t) { return Rank() == NumberOfRanks() - 1; }));
  filter->SetMemoryLimit(limit);
  configure(filter);
  filter->Update();
  std::vector<std::string> parts = TooLittle;
  parts.push_back("got ");
  ExpectRefusal(filter, errors, parts);
}
}

TEST(MemoryRefusals, EveryFilterOfPacks)
{
  const auto asItIs = [](auto*) {};
  for (double limit : { 1e-6, 0.0, -1.0, std::numeric_limits<double>::quiet_NaN() })
  {
    SCOPED_TRACE(limit);
    ExpectRefused<vtkRUCOnePointProbability>(limit, asItIs);
    ExpectRefused<vtkRUCTwoPointProbability>(limit, asItIs);
    ExpectRefused<vtkRUCChordLengths>(limit, asItIs);
    ExpectRefused<vtkRUCDirectionalProbability>(limit, asItIs);
    ExpectRefused<vtkRUCProbabilityMap>(limit, asItIs);
  }
}

TEST(MemoryRefusals, AllTheDirectionsThereAre)
{
  for (int method :
    { vtkRUCDirectionalProbability::EXACT_PAIR_SUM, vtkRUCDirectionalProbability::CHORD_SAMPLING })
  {
    ExpectRefused<vtkRUCDirectionalProbability>(4000.0,
      [&](auto* f)
      {
        f->SetMethod(method);
        f->SetNumberOfDirections(std::numeric_limits<int>::max());
      });
  }
}

// How many samples a TargetError takes is not known, but the memory is
TEST(MemoryRefusals, SamplesToAnError)
{
  ExpectRefused<vtkRUCTwoPointProbability>(1.0,
    [&](auto* f)
    {
      f->SetMethod(vtkRUCTwoPointProbability::CHORD_SAMPLING);
      f->SetTargetError(0.1);
    });
}

// Of a mask only the extent is needed, of which no voxel is made
TEST(MemoryRefusals, LargeMask)
{
  for (double margin : { 0.0, -1.0 })
  {
    vtkNew<vtkRUCOnePointProbability> filter;
    const Errors errors(filter);
    filter->SetInputData(MakePolyData(FewSizes(), Edge, false, IsMine));
    filter->SetMethod(vtkRUCOnePointProbability::CHORD_SAMPLING);
    filter->SetWindowMargin(margin);
    const auto mask = MakeMask(Edge, Rank(), NumberOfRanks());
    vtkNew<vtkTrivialProducer> producer;
    producer->SetOutput(mask);
    const int whole[6] = { 0, 1999, 0, 1999, 0, 1999 };
    producer->SetWholeExtent(whole[0], whole[1], whole[2], whole[3], whole[4], whole[5]);
    filter->SetMaskConnection(producer->GetOutputPort());
    filter->Update();
    // 8 10^9 voxels: half a byte of each on every rank, and four or five of those in its planes
    const double megabytes = 4000.0 + (margin == 0.0 ? 32000.0 : 40000.0) / NumberOfRanks();
    ExpectRefusal(filter, errors,
      { "MemoryLimit requires at least", " " + std::to_string(megabytes).substr(0, 3),
        "MB on every rank" });
  }
}
