// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Every filter gives the same bits whatever the number of ranks and threads, and however the pack
 * is spread over the ranks: each rank compares what all ranks work out together with what it works
 * out alone.
 */
#include "Packs.h"

#include "vtkRUCChordLengths.h"
#include "vtkRUCCompareProbabilities.h"
#include "vtkRUCDirectionalProbability.h"
#include "vtkRUCOnePointProbability.h"
#include "vtkRUCParticleModes.h"
#include "vtkRUCPeriodicReplicas.h"
#include "vtkRUCProbabilityMap.h"
#include "vtkRUCRadialDistribution.h"
#include "vtkRUCThreePointProbability.h"
#include "vtkRUCTwoPointProbability.h"
#include "vtkRUCUnitCellReconstruction.h"

#include "vtkCommunicator.h"
#include "vtkImageData.h"
#include "vtkMPIController.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkTable.h"

#include <omp.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>

namespace
{
int Failures = 0;

void Check(bool good, const std::string& what)
{
  if (!good)
  {
    ++Failures;
    std::cerr << "FAILED: " << what << std::endl;
  }
}

// All numbers of a set of arrays, and of a data set; but the memory of a rank depends on how many
// there are
std::vector<double> Numbers(vtkFieldData* fields)
{
  std::vector<double> numbers;
  for (int a = 0; fields && a < fields->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = fields->GetArray(a);
    if (array && array->GetName() && array->GetName() == std::string("EstimatedMemory"))
    {
      continue;
    }
    for (vtkIdType v = 0; array && v < array->GetNumberOfValues(); ++v)
    {
      numbers.push_back(array->GetComponent(
        v / array->GetNumberOfComponents(), v % array->GetNumberOfComponents()));
    }
  }
  return numbers;
}

std::vector<double> Numbers(vtkDataObject* data)
{
  std::vector<double> numbers;
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data))
  {
    for (unsigned int n = 0; n < blocks->GetNumberOfBlocks(); ++n)
    {
      const std::vector<double> more = Numbers(blocks->GetBlock(n));
      numbers.insert(numbers.end(), more.begin(), more.end());
    }
    const std::vector<double> more = Numbers(blocks->GetFieldData());
    numbers.insert(numbers.end(), more.begin(), more.end());
    return numbers;
  }
  const auto add = [&](vtkFieldData* fields)
  {
    const std::vector<double> more = Numbers(fields);
    numbers.insert(numbers.end(), more.begin(), more.end());
  };
  if (auto* points = vtkPolyData::SafeDownCast(data))
  {
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      numbers.insert(numbers.end(), points->GetPoint(i), points->GetPoint(i) + 3);
    }
    add(points->GetPointData());
  }
  else
  {
    add(vtkTable::SafeDownCast(data)->GetRowData());
  }
  add(data->GetFieldData());
  return numbers;
}

bool Same(const std::vector<double>& a, const std::vector<double>& b)
{
  return a.size() == b.size() &&
    std::equal(a.begin(), a.end(), b.begin(),
      [](double x, double y) { return x == y || (x != x && y != y); });
}

// The points of a slab of the whole image
void CheckSlab(vtkImageData* slab, vtkImageData* whole, const std::string& what)
{
  Check(Same(Numbers(slab->GetFieldData()), Numbers(whole->GetFieldData())), what + ", field data");
  const int* extent = slab->GetExtent();
  for (int a = 0; a < whole->GetPointData()->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* expected = whole->GetPointData()->GetArray(a);
    vtkDataArray* got = slab->GetPointData()->GetArray(expected->GetName());
    for (int k = extent[4]; k <= extent[5]; ++k)
    {
      for (int j = extent[2]; j <= extent[3]; ++j)
      {
        for (int i = extent[0]; i <= extent[1]; ++i)
        {
          int place[3] = { i, j, k };
          Check(got->GetTuple1(slab->ComputePointId(place)) ==
              expected->GetTuple1(whole->ComputePointId(place)),
            what + ", " + expected->GetName());
        }
      }
    }
  }
}

// One output on all ranks against that of this rank alone: slabs of an image, else whole on rank 0
void CheckOutput(vtkMPIController* controller, vtkDataObject* got, vtkDataObject* expected,
  const std::string& what)
{
  if (auto* image = vtkImageData::SafeDownCast(got))
  {
    CheckSlab(image, vtkImageData::SafeDownCast(expected), what);
  }
  else if (controller->GetLocalProcessId() == 0)
  {
    Check(Same(Numbers(got), Numbers(expected)), what);
  }
  else
  {
    Check(got->GetNumberOfElements(vtkDataObject::POINT) +
          got->GetNumberOfElements(vtkDataObject::ROW) ==
        0,
      what + " is on rank 0 alone");
  }
}

// Runs the filter on all ranks with `piece` and on this one alone with `whole`; rank 0 compares
// every output
template <class Filter>
void Compare(vtkMPIController* controller, const std::string& name, vtkPolyData* piece,
  vtkPolyData* whole, const std::function<void(Filter*)>& configure, bool spreadOutput = false,
  const std::vector<int>& emptyPorts = {}, vtkImageData* maskPiece = nullptr,
  vtkImageData* mask = nullptr)
{
  vtkNew<Filter> together;
  configure(together);
  together->SetInputDataObject(0, piece);
  vtkNew<Filter> alone;
  configure(alone);
  alone->SetController(nullptr);
  alone->SetInputDataObject(0, whole);
  if (mask)
  {
    together->SetInputDataObject(1, maskPiece);
    alone->SetInputDataObject(1, mask);
  }
  together->Update();
  alone->Update();
  for (int port = 0; port < alone->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataObject* expected = alone->GetOutputDataObject(port);
    vtkDataObject* got = together->GetOutputDataObject(port);
    const std::string what = name + ", output " + std::to_string(port);
    const bool empty = expected->GetNumberOfElements(vtkDataObject::POINT) +
        expected->GetNumberOfElements(vtkDataObject::ROW) ==
      0;
    Check(empty == (std::count(emptyPorts.begin(), emptyPorts.end(), port) > 0),
      what + " is empty or not, as asked");
    if (spreadOutput && port != 1)
    {
      // the pieces in the order of the ranks are the whole
      const vtkIdType own = got->GetNumberOfElements(vtkDataObject::POINT);
      std::vector<vtkIdType> counts(controller->GetNumberOfProcesses());
      controller->AllGather(&own, counts.data(), 1);
      vtkIdType first = 0;
      for (int rank = 0; rank < controller->GetLocalProcessId(); ++rank)
      {
        first += counts[rank];
      }
      auto* points = vtkPolyData::SafeDownCast(got);
      auto* all = vtkPolyData::SafeDownCast(expected);
      for (vtkIdType i = 0; i < own; ++i)
      {
        const double* p = points->GetPoint(i);
        const std::array<double, 3> place = { p[0], p[1], p[2] };
        const double* q = all->GetPoint(first + i);
        Check(place[0] == q[0] && place[1] == q[1] && place[2] == q[2] &&
            points->GetPointData()->GetArray("Radius")->GetTuple1(i) ==
              all->GetPointData()->GetArray("Radius")->GetTuple1(first + i),
          what + ", point " + std::to_string(first + i));
      }
      vtkIdType total = 0;
      controller->AllReduce(&own, &total, 1, vtkCommunicator::SUM_OP);
      Check(total == all->GetNumberOfPoints(), what + ": number of points");
      continue;
    }
    CheckOutput(controller, got, expected, what);
  }
}

// Compares output 0 of a probability filter with those of `cells` others that differ by their
// seeds: on all ranks, and alone
template <class Filter>
void CompareComparisons(vtkMPIController* controller, const std::string& name, vtkPolyData* piece,
  vtkPolyData* whole, int cells, int emptyPort, const std::function<void(Filter*)>& configure)
{
  const auto run = [&](vtkPolyData* pack, bool alone)
  {
    auto comparison = vtkSmartPointer<vtkRUCCompareProbabilities>::New();
    for (int seed = 0; seed <= cells; ++seed)
    {
      vtkNew<Filter> filter;
      configure(filter);
      filter->SetSeed(seed);
      filter->SetInputDataObject(0, pack);
      if (alone)
      {
        filter->SetController(nullptr);
      }
      comparison->AddInputConnection(seed > 0, filter->GetOutputPort(0));
    }
    if (alone)
    {
      comparison->SetController(nullptr);
    }
    comparison->Update();
    return comparison;
  };
  const auto together = run(piece, false), alone = run(whole, true);
  for (int port = 0; port < alone->GetNumberOfOutputPorts(); ++port)
  {
    const std::string what = name + ", output " + std::to_string(port);
    vtkDataObject* expected = alone->GetOutputDataObject(port);
    const bool empty = expected->GetNumberOfElements(vtkDataObject::POINT) +
        expected->GetNumberOfElements(vtkDataObject::ROW) ==
      0;
    Check(empty == (port == emptyPort), what + " is empty or not, as asked");
    CheckOutput(controller, together->GetOutputDataObject(port), expected, what);
  }
}
}

int main(int argc, char* argv[])
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  vtkMultiProcessController::SetGlobalController(controller);
  const std::size_t rank = controller->GetLocalProcessId();
  const std::size_t ranks = controller->GetNumberOfProcesses();

  constexpr double edge = 12.0;
  const ruc::SpherePack fewSizes =
    MakePack(edge, [](int i) { return std::make_pair(0.4 + 0.1 * (i % 3), 1 + i % 3); });
  // more distinct radii than the tables take: the direct pair sum
  const ruc::SpherePack manySizes =
    MakePack(edge, [](int i) { return std::make_pair(0.4 + 0.0004 * i, 1 + i / 300); });

  const struct
  {
    std::string Name;
    std::function<bool(std::size_t)> Keep;
  } spreads[] = {
    { "all on the last rank", [&](std::size_t) { return rank == ranks - 1; } },
    { "in turn", [&](std::size_t i) { return i % ranks == rank; } },
    { "backwards, rank 0 empty where there are others",
      [&](std::size_t i)
      { return ranks == 1 || (rank > 0 && (i % (ranks - 1)) + 1 == ranks - rank); } },
  };
  for (const ruc::SpherePack& pack : { fewSizes, manySizes })
  {
    for (bool periodic : { true, false })
    {
      const auto whole = MakePolyData(pack, edge, periodic, [](std::size_t) { return true; });
      for (const auto& spread : spreads)
      {
        const auto piece = MakePolyData(pack, edge, periodic, spread.Keep);
        const std::string name = std::string(periodic ? "periodic" : "block") + ", " + spread.Name;
        Compare<vtkRUCOnePointProbability>(
          controller, "one-point, " + name, piece, whole, [](auto*) {});
        Compare<vtkRUCOnePointProbability>(controller, "one-point by chords, " + name, piece, whole,
          [](auto* f)
          {
            f->SetMethod(vtkRUCOnePointProbability::CHORD_SAMPLING);
            f->SetTargetError(0.02);
          });
        Compare<vtkRUCTwoPointProbability>(
          controller, "two-point, " + name, piece, whole, [](auto* f) { f->SetNumberOfLags(40); });
        Compare<vtkRUCTwoPointProbability>(controller, "chords, " + name, piece, whole,
          [](auto* f)
          {
            f->SetMethod(vtkRUCTwoPointProbability::CHORD_SAMPLING);
            f->SetNumberOfLags(40);
            f->SetNumberOfLines(300);
          });
        Compare<vtkRUCTwoPointProbability>(controller, "template, " + name, piece, whole,
          [](auto* f)
          {
            f->SetMethod(vtkRUCTwoPointProbability::TEMPLATE_SAMPLING);
            f->SetNumberOfLags(40);
            f->SetNumberOfThrows(100);
          });
        const auto directions = [](vtkRUCDirectionalProbability* f)
        {
          f->SetNumberOfDirections(3);
          f->SetNumberOfLags(40);
          f->SetNumberOfLines(300);
        };
        Compare<vtkRUCDirectionalProbability>(
          controller, "directions, " + name, piece, whole, directions);
        const auto chordsAlong = [&](vtkRUCDirectionalProbability* f)
        {
          directions(f);
          f->SetMethod(vtkRUCDirectionalProbability::CHORD_SAMPLING);
        };
        Compare<vtkRUCDirectionalProbability>(
          controller, "chords along directions, " + name, piece, whole, chordsAlong);
        Compare<vtkRUCProbabilityMap>(controller, "map, " + name, piece, whole,
          [](auto* f)
          {
            f->SetPhasePairs("1 1; 1 m; m m");
            f->SetMaximumLag(4.0);
            f->SetResolution(4);
          });
        const auto chordLengths = [](vtkRUCChordLengths* f)
        {
          f->SetNumberOfLags(40);
          f->SetNumberOfLines(300);
        };
        Compare<vtkRUCChordLengths>(
          controller, "chord lengths, " + name, piece, whole, chordLengths);
        Compare<vtkRUCRadialDistribution>(controller, "radial distribution, " + name, piece, whole,
          [](auto* f) { f->SetNumberOfLags(40); });
        const auto threePoint = [](vtkRUCThreePointProbability* f)
        {
          f->SetPhases("1 2 2; m m m; 2 1 m; 2 m 1");
          f->SetMaximumLag(3.0);
          f->SetNumberOfLags(11);
          f->SetNumberOfDirections(8);
          f->SetNumberOfThrows(300);
          f->SetStandardErrors(true);
        };
        Compare<vtkRUCThreePointProbability>(
          controller, "three-point, " + name, piece, whole, threePoint);
        Compare<vtkRUCThreePointProbability>(controller, "three-point without errors, " + name,
          piece, whole,
          [](auto* f)
          {
            f->SetPhases("m m m");
            f->SetNumberOfLags(5);
            f->SetNumberOfDirections(3);
            f->SetNumberOfThrows(50);
          });
        CompareComparisons<vtkRUCThreePointProbability>(
          controller, "compared images, " + name, piece, whole, 1, 1, threePoint);
        CompareComparisons<vtkRUCTwoPointProbability>(controller, "compared tables, " + name, piece,
          whole, 3, 2,
          [](auto* f)
          {
            f->SetMethod(vtkRUCTwoPointProbability::CHORD_SAMPLING);
            f->SetNumberOfLags(20);
            f->SetMaximumLag(2.0);
            f->SetNumberOfLines(200);
          });
        if (!periodic)
        {
          Compare<vtkRUCThreePointProbability>(
            controller, "three-point, mask, " + name, piece, whole,
            [&](auto* f)
            {
              threePoint(f);
              f->SetMaximumLag(1.0);
            },
            false, {}, MakeMask(edge, rank, ranks), MakeMask(edge, 0, 1));
          Compare<vtkRUCTwoPointProbability>(
            controller, "mask, " + name, piece, whole,
            [](auto* f)
            {
              f->SetMethod(vtkRUCTwoPointProbability::CHORD_SAMPLING);
              f->SetNumberOfLags(40);
              f->SetNumberOfLines(300);
            },
            false, {}, MakeMask(edge, rank, ranks), MakeMask(edge, 0, 1));
          Compare<vtkRUCDirectionalProbability>(controller,
            "chords along directions, mask, " + name, piece, whole, chordsAlong, false, {},
            MakeMask(edge, rank, ranks), MakeMask(edge, 0, 1));
          Compare<vtkRUCChordLengths>(controller, "chord lengths, mask, " + name, piece, whole,
            chordLengths, false, {}, MakeMask(edge, rank, ranks), MakeMask(edge, 0, 1));
        }
        Compare<vtkRUCUnitCellReconstruction>(controller, "cell, " + name, piece, whole,
          [](auto* f)
          {
            f->SetNumberOfLags(40);
            f->SetNumberOfParticles(60);
            f->SetMaximumIterations(120);
          });
        // Three cells in as many groups of ranks as there are, by every method; once is enough of
        // what the pack has to do with it
        for (int method = 0; method < 3 && periodic && pack.Radius == fewSizes.Radius; ++method)
        {
          Compare<vtkRUCUnitCellReconstruction>(controller,
            "cells by method " + std::to_string(method) + ", " + name, piece, whole,
            [&](auto* f)
            {
              f->SetMethod(method);
              f->SetNumberOfCells(3);
              f->SetNumberOfLags(20);
              f->SetNumberOfParticles(40);
              f->SetMaximumIterations(20);
              f->SetMaximumGenerations(4);
              f->SetPopulation(7);
              f->SetMatingPool(5);
              f->SetHybridPopulation(5);
              f->SetHybridMatingPool(3);
              f->SetRefinementSteps(4);
            });
        }
        if (periodic)
        {
          Compare<vtkRUCPeriodicReplicas>(
            controller, "copies, " + name, piece, whole,
            [](auto* f)
            {
              f->SetClipToBox(true);
              f->SetSurfaceResolution(8);
            },
            true);
          Compare<vtkRUCPeriodicReplicas>(controller, "tiles, " + name, piece, whole,
            [](auto* f)
            {
              f->SetMode(vtkRUCPeriodicReplicas::TILING);
              f->SetTiles(2, 1, 3);
            },
            true, { 2 }); // without their surfaces
        }
        // Modes stay with their spheres, on their ranks
        vtkNew<vtkRUCParticleModes> modes;
        modes->SetNumberOfModes(2);
        modes->SetInputData(piece);
        modes->Update();
        vtkNew<vtkRUCParticleModes> alone;
        alone->SetNumberOfModes(2);
        alone->SetController(nullptr);
        alone->SetInputData(whole);
        alone->Update();
        auto* output = vtkPolyData::SafeDownCast(modes->GetOutputDataObject(0));
        Check(output->GetNumberOfPoints() == piece->GetNumberOfPoints(),
          "modes keep every sphere, " + name);
        if (rank == 0)
        {
          Check(
            Same(Numbers(modes->GetOutputDataObject(1)), Numbers(alone->GetOutputDataObject(1))),
            "table of modes, " + name);
        }
      }
    }
  }

  // Threads
  const auto whole = MakePolyData(fewSizes, edge, true, [](std::size_t) { return true; });
  std::vector<double> first;
  for (int threads : { 1, 2, 3 })
  {
    omp_set_num_threads(threads);
    vtkNew<vtkRUCUnitCellReconstruction> cell;
    cell->SetController(nullptr);
    cell->SetNumberOfLags(40);
    cell->SetNumberOfParticles(60);
    cell->SetMaximumIterations(120);
    cell->SetInputData(whole);
    cell->Update();
    const std::vector<double> numbers = Numbers(cell->GetOutputDataObject(0));
    first = first.empty() ? numbers : first;
    Check(numbers == first, "cell on " + std::to_string(threads) + " threads");
  }

  int all = 0;
  controller->AllReduce(&Failures, &all, 1, vtkCommunicator::SUM_OP);
  vtkMultiProcessController::SetGlobalController(nullptr);
  controller->Finalize();
  return all == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
