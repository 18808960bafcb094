// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Settings that directions, maps, chord lengths and the radial distribution refuse or warn of
#include "Refusals.h"

#include "vtkRUCChordLengths.h"
#include "vtkRUCDirectionalProbability.h"
#include "vtkRUCProbabilityMap.h"
#include "vtkRUCRadialDistribution.h"

#include "ruc/Base/Text.h"

#include <algorithm>

using Directional = vtkRUCDirectionalProbability;
using Map = vtkRUCProbabilityMap;
using Radial = vtkRUCRadialDistribution;
using Chords = vtkRUCChordLengths;

TEST(DirectionalRefusals, NumberOfDirectionsOutOfRange)
{
  for (int directions : { 1, 0, -3 })
  {
    SCOPED_TRACE(directions);
    RefusesSettings<Directional>(
      { "Directional Probability", "NumberOfDirections requires a number >= 2",
        std::to_string(directions) },
      [=](Directional* f) { f->SetNumberOfDirections(directions); });
  }
}

TEST(DirectionalRefusals, MethodOutOfRange)
{
  for (int method : { -1, 2 })
  {
    SCOPED_TRACE(method);
    RefusesSettings<Directional>(
      { "Directional Probability", "Method requires a value from 0 to 1", std::to_string(method) },
      [=](Directional* f) { f->SetMethod(method); });
  }
}

TEST(DirectionalRefusals, MaskAndTheExactSum)
{
  RefusesSettings<Directional>(
    { "Directional Probability", "Mask requires Method Chord Sampling", "Exact Pair Sum" },
    [](Directional* f) { f->SetInputDataObject(1, MakeMask(Edge, Rank(), NumberOfRanks())); },
    false);
}

TEST(MapRefusals, PairsThatAreNone)
{
  for (const char* pairs : { "", "1", "1 2 3", "0 1", "4 m", "m x", ";", "1,1" })
  {
    SCOPED_TRACE(pairs);
    RefusesSettings<Map>({ "Probability Map", "PhasePairs requires pairs of phases, 1 to 3 or m" },
      [=](Map* f) { f->SetPhasePairs(pairs); });
  }
}

TEST(MapRefusals, SpacingAndResolutionOutOfRange)
{
  RefusesSettings<Map>(
    { "Probability Map", "Spacing requires", "got -1" }, [](Map* f) { f->SetSpacing(-1.0); });
  RefusesSettings<Map>(
    { "Probability Map", "Resolution requires", "got 0" }, [](Map* f) { f->SetResolution(0); });
}

TEST(MapRefusals, MapBeyondTheWindow)
{
  RefusesSettings<Map>(
    { "Probability Map", "Spacing x Resolution requires a length" },
    [](Map* f) { f->SetSpacing(1.0); }, false);
}

TEST(RadialDistributionRefusals, LagsOutOfRange)
{
  RefusesSettings<Radial>(
    { "Radial Distribution", "MaximumLag", "got 12" }, [](Radial* f) { f->SetMaximumLag(12.0); },
    false);
  RefusesSettings<Radial>({ "Radial Distribution", "NumberOfLags requires", "got 0" },
    [](Radial* f) { f->SetNumberOfLags(0); });
}

// The only sphere of its mode is no neighbour of itself
TEST(RadialDistributionRefusals, AModeOfOneSphereIsTold)
{
  ruc::SpherePack pack = FewSizes();
  const int alone = 1 + *std::max_element(pack.Mode.begin(), pack.Mode.end());
  const auto warned = [](const ruc::SpherePack& spheres)
  {
    vtkNew<Radial> filter;
    filter->SetInputData(MakePolyData(spheres, Edge, true, IsMine));
    filter->SetNumberOfLags(8);
    const Warnings warnings(filter);
    filter->Update();
    return warnings.Texts;
  };
  EXPECT_TRUE(warned(pack).empty());
  pack.Mode[0] = alone;
  const std::vector<std::string> texts = warned(pack);
  ASSERT_EQ(texts.size(), Rank() == 0 ? 1u : 0u);
  const std::string name = ruc::Text("g_", alone, "_", alone, " require");
  EXPECT_TRUE(texts.empty() || texts[0].find(name) != std::string::npos);
}

TEST(ChordLengthRefusals, NoLines)
{
  RefusesSettings<Chords>({ "Chord Lengths", "NumberOfLines requires", "got 0" },
    [](Chords* f) { f->SetNumberOfLines(0); });
}

TEST(ChordLengthRefusals, LagBeyondTheRegion)
{
  RefusesSettings<Chords>(
    { "Chord Lengths", "MaximumLag requires", "got 11.9" },
    [](Chords* f) { f->SetMaximumLag(11.9); }, false);
}
