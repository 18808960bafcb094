// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Probabilities and their comparisons are the same on any number of ranks
#include "Equality.h"

#include "vtkRUCChordLengths.h"
#include "vtkRUCCompareProbabilities.h"
#include "vtkRUCDirectionalProbability.h"
#include "vtkRUCOnePointProbability.h"
#include "vtkRUCProbabilityMap.h"
#include "vtkRUCRadialDistribution.h"
#include "vtkRUCThreePointProbability.h"
#include "vtkRUCTwoPointProbability.h"

using ChordLengths = vtkRUCChordLengths;
using Directional = vtkRUCDirectionalProbability;
using OnePoint = vtkRUCOnePointProbability;
using TwoPoint = vtkRUCTwoPointProbability;
using ThreePoint = vtkRUCThreePointProbability;

namespace
{
class ProbabilityEquality : public EveryPack
{
};
INSTANTIATE_EVERY_PACK(ProbabilityEquality);

void ByLines(TwoPoint* f)
{
  f->SetMethod(TwoPoint::CHORD_SAMPLING);
  f->SetNumberOfLags(40);
  f->SetNumberOfLines(300);
}

void AlongThreeDirections(Directional* f)
{
  f->SetNumberOfDirections(3);
  f->SetNumberOfLags(40);
  f->SetNumberOfLines(300);
}

void ChordsAlongThreeDirections(Directional* f)
{
  AlongThreeDirections(f);
  f->SetMethod(Directional::CHORD_SAMPLING);
}

void OfThreeHundredLines(ChordLengths* f)
{
  f->SetNumberOfLags(40);
  f->SetNumberOfLines(300);
}

void WithErrors(ThreePoint* f)
{
  f->SetPhases("1 2 2; m m m; 2 1 m; 2 m 1");
  f->SetMaximumLag(3.0);
  f->SetNumberOfLags(11);
  f->SetNumberOfDirections(8);
  f->SetNumberOfThrows(300);
  f->SetStandardErrors(true);
}

// Compares output 0 of a probability filter with those of `cells` others that differ by their
// seeds: together, and alone
template <class Filter>
void ExpectSameComparison(int cells, int emptyPort, const std::function<void(Filter*)>& configure)
{
  const auto run = [&](vtkPolyData* pack, bool onAllRanks)
  {
    auto comparison = vtkSmartPointer<vtkRUCCompareProbabilities>::New();
    for (int seed = 0; seed <= cells; ++seed)
    {
      vtkNew<Filter> filter;
      configure(filter);
      filter->SetSeed(seed);
      filter->SetInputDataObject(0, pack);
      if (!onAllRanks)
      {
        filter->SetController(nullptr);
      }
      comparison->AddInputConnection(seed > 0, filter->GetOutputPort(0));
    }
    if (!onAllRanks)
    {
      comparison->SetController(nullptr);
    }
    comparison->Update();
    return comparison;
  };
  const auto alone = run(EveryPack::Whole(), false);
  for (const Spread& spread : Spreads())
  {
    SCOPED_TRACE(spread.Name);
    const auto together =
      run(MakePolyData(EveryPack::Pack(), Edge, EveryPack::IsPeriodic(), spread.IsMine), true);
    for (int port = 0; port < alone->GetNumberOfOutputPorts(); ++port)
    {
      SCOPED_TRACE("output " + std::to_string(port));
      vtkDataObject* expected = alone->GetOutputDataObject(port);
      EXPECT_EQ(IsEmpty(expected), port == emptyPort);
      ExpectSameOutput(together->GetOutputDataObject(port), expected);
    }
  }
}
}

TEST_P(ProbabilityEquality, OnePointOfSphereVolumes)
{
  ExpectSame<OnePoint>([](auto*) {});
}

TEST_P(ProbabilityEquality, OnePointByChords)
{
  ExpectSame<OnePoint>(
    [](auto* f)
    {
      f->SetMethod(OnePoint::CHORD_SAMPLING);
      f->SetTargetError(0.02);
    });
}

TEST_P(ProbabilityEquality, TwoPointOfPairs)
{
  ExpectSame<TwoPoint>([](auto* f) { f->SetNumberOfLags(40); });
}

TEST_P(ProbabilityEquality, TwoPointWithErrors)
{
  ExpectSame<TwoPoint>(
    [](auto* f)
    {
      f->SetNumberOfLags(40);
      f->SetBlocks(27);
    });
}

TEST_P(ProbabilityEquality, TwoPointByChords)
{
  ExpectSame<TwoPoint>(ByLines);
}

TEST_P(ProbabilityEquality, TwoPointByTheTemplate)
{
  ExpectSame<TwoPoint>(
    [](auto* f)
    {
      f->SetMethod(TwoPoint::TEMPLATE_SAMPLING);
      f->SetNumberOfLags(40);
      f->SetNumberOfThrows(100);
    });
}

TEST_P(ProbabilityEquality, Directions)
{
  ExpectSame<Directional>(AlongThreeDirections);
}

TEST_P(ProbabilityEquality, ChordsAlongDirections)
{
  ExpectSame<Directional>(ChordsAlongThreeDirections);
}

TEST_P(ProbabilityEquality, Map)
{
  ExpectSame<vtkRUCProbabilityMap>(
    [](auto* f)
    {
      f->SetPhasePairs("1 1; 1 m; m m");
      f->SetMaximumLag(4.0);
      f->SetResolution(4);
    });
}

TEST_P(ProbabilityEquality, ChordLengths)
{
  ExpectSame<ChordLengths>(OfThreeHundredLines);
}

TEST_P(ProbabilityEquality, RadialDistribution)
{
  ExpectSame<vtkRUCRadialDistribution>([](auto* f) { f->SetNumberOfLags(40); });
}

TEST_P(ProbabilityEquality, ThreePoint)
{
  ExpectSame<ThreePoint>(WithErrors);
}

TEST_P(ProbabilityEquality, ThreePointWithoutErrors)
{
  ExpectSame<ThreePoint>(
    [](auto* f)
    {
      f->SetPhases("m m m");
      f->SetNumberOfLags(5);
      f->SetNumberOfDirections(3);
      f->SetNumberOfThrows(50);
    });
}

TEST_P(ProbabilityEquality, ThreePointWithMultipoles)
{
  ExpectSame<ThreePoint>(
    [](auto* f)
    {
      WithErrors(f);
      f->SetMultipoles(true);
      f->SetMultipoleClasses(2);
      f->SetMultipoleDegree(4);
      f->SetMultipoleDistance(0, 0.1);
      f->SetMultipoleDistance(1, 0.6);
    });
}

TEST_P(ProbabilityEquality, ComparedImages)
{
  ExpectSameComparison<ThreePoint>(1, 1, WithErrors);
}

TEST_P(ProbabilityEquality, ComparedTables)
{
  ExpectSameComparison<TwoPoint>(3, 2,
    [](auto* f)
    {
      f->SetMethod(TwoPoint::CHORD_SAMPLING);
      f->SetNumberOfLags(20);
      f->SetMaximumLag(2.0);
      f->SetNumberOfLines(200);
    });
}

namespace
{
// A mask takes a pack that is not periodic
class MaskedEquality : public EveryPack
{
};
INSTANTIATE_TEST_SUITE_P(, MaskedEquality,
  testing::Combine(testing::Bool(), testing::Values(false)),
  [](const auto& info) { return std::get<0>(info.param) ? "FewSizes" : "ManySizes"; });
}

TEST_P(MaskedEquality, TwoPoint)
{
  ExpectSame<TwoPoint>(ByLines, {}, {}, true);
}

TEST_P(MaskedEquality, ChordsAlongDirections)
{
  ExpectSame<Directional>(ChordsAlongThreeDirections, {}, {}, true);
}

TEST_P(MaskedEquality, ChordLengths)
{
  ExpectSame<ChordLengths>(OfThreeHundredLines, {}, {}, true);
}

TEST_P(MaskedEquality, ThreePoint)
{
  ExpectSame<ThreePoint>(
    [](auto* f)
    {
      WithErrors(f);
      f->SetMaximumLag(1.0);
    },
    {}, {}, true);
}
