// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Packs, windows and lags that the statistics of a pack refuse
#include "Refusals.h"

#include "vtkRUCChordLengths.h"
#include "vtkRUCEffectiveProperties.h"
#include "vtkRUCLabelImage.h"
#include "vtkRUCNeighbourStatistics.h"
#include "vtkRUCOnePointProbability.h"
#include "vtkRUCParticleModes.h"
#include "vtkRUCPointsToSpherePack.h"
#include "vtkRUCRadialDistribution.h"
#include "vtkRUCThirdOrderParameters.h"
#include "vtkRUCThreePointProbability.h"
#include "vtkRUCTwoPointProbability.h"
#include "vtkRUCVoidDistances.h"

#include "vtkMultiBlockDataSet.h"
#include "vtkStringArray.h"

#include <limits>

using TwoPoint = vtkRUCTwoPointProbability;

namespace
{
const std::string Name = "Two-Point Probability";
const double NaN = std::numeric_limits<double>::quiet_NaN();
const double Infinity = std::numeric_limits<double>::infinity();

void RefusesLags(const std::vector<std::string>& parts, const std::function<void(TwoPoint*)>& spoil,
  bool periodic = true)
{
  std::vector<std::string> all = parts;
  all.push_back(Name);
  RefusesSettings<TwoPoint>(all, spoil, periodic);
}
}

TEST(PackRefusals, NoPoints)
{
  RefusesPack<TwoPoint>({ Name, "at least one sphere", "no points" }, [](auto& p) { p = {}; });
  RefusesPack<vtkRUCOnePointProbability>(
    { "One-Point Probability", "no points" }, [](auto& p) { p = {}; });
}

TEST(PackRefusals, NoRadius)
{
  RefusesData<TwoPoint>({ Name, "'Radius' is required", "'Mode'" },
    [](vtkPolyData* d) { d->GetPointData()->RemoveArray("Radius"); });
}

TEST(PackRefusals, NoRadiusOnOneRank)
{
  RefusesData<TwoPoint>({ Name, "'Radius' is required" },
    [](vtkPolyData* d)
    {
      if (Rank() == NumberOfRanks() - 1)
      {
        d->GetPointData()->RemoveArray("Radius");
      }
    });
}

// An array of `count` values, whatever number of points it belongs to
namespace
{
template <class Array>
void Shorten(vtkDataSet* data, const char* name, vtkIdType count)
{
  vtkNew<Array> few;
  few->SetName(name);
  few->SetNumberOfValues(count);
  few->FillComponent(0, 1.0);
  data->GetPointData()->RemoveArray(name);
  data->GetPointData()->AddArray(few);
}
}

TEST(PackRefusals, ArraysShorterThanThePoints)
{
  for (vtkIdType count : { 0, 1, 5 })
  {
    SCOPED_TRACE(count);
    const std::string got = "points, got " + std::to_string(count);
    RefusesData<TwoPoint>({ Name, "'Radius' requires a value for each of", got },
      [&](vtkPolyData* d) { Shorten<vtkDoubleArray>(d, "Radius", count); });
    RefusesData<vtkRUCOnePointProbability>({ "'Radius' requires a value for each of", got },
      [&](vtkPolyData* d) { Shorten<vtkDoubleArray>(d, "Radius", count); });
    RefusesData<TwoPoint>({ Name, "'Mode' requires a value for each of", got },
      [&](vtkPolyData* d) { Shorten<vtkIntArray>(d, "Mode", count); });
    RefusesData<vtkRUCThreePointProbability>({ "'Mode' requires a value for each of", got },
      [&](vtkPolyData* d) { Shorten<vtkIntArray>(d, "Mode", count); });
    RefusesData<TwoPoint>({ Name, "'Id' requires a value for each of", got },
      [&](vtkPolyData* d) { Shorten<vtkIntArray>(d, "Id", count); });
  }
}

TEST(PackRefusals, MaskShorterThanItsVoxels)
{
  const auto mask = MakeMask(Edge, Rank(), NumberOfRanks());
  Shorten<vtkIntArray>(mask, "label", 3);
  const auto sampling = [](vtkRUCOnePointProbability* f)
  {
    f->SetMethod(vtkRUCOnePointProbability::CHORD_SAMPLING);
    f->SetNumberOfLines(100);
  };
  RefusesSettings<vtkRUCOnePointProbability>(
    { "Mask requires an array with a value for each of", "got 3" },
    [&](vtkRUCOnePointProbability* f) { f->SetInputData(1, mask); }, false, sampling);
}

TEST(PackRefusals, EstimatesOfShortArraysAreNotKnown)
{
  for (const char* name : { "Radius", "Mode" })
  {
    const auto data = MakePolyData(FewSizes(), Edge, true, IsMine);
    Shorten<vtkDoubleArray>(data, name, 0);
    vtkNew<TwoPoint> filter;
    filter->SetInputData(data);
    EXPECT_EQ(filter->GetEstimatedTime(), 0.0);
    EXPECT_EQ(filter->GetEstimatedMemory(), 0.0);
  }
}

TEST(PackRefusals, RadiusAsText)
{
  RefusesData<TwoPoint>({ Name, "'Radius' requires numbers", "got text" },
    [](vtkPolyData* d)
    {
      vtkNew<vtkStringArray> text;
      text->SetName("Radius");
      text->SetNumberOfValues(d->GetNumberOfPoints());
      d->GetPointData()->RemoveArray("Radius");
      d->GetPointData()->AddArray(text);
    });
}

TEST(PackRefusals, RadiusOfThreeComponents)
{
  RefusesData<TwoPoint>({ Name, "'Radius' requires numbers of one component", "3 component" },
    [](vtkPolyData* d)
    {
      vtkNew<vtkDoubleArray> vectors;
      vectors->SetName("Radius");
      vectors->SetNumberOfComponents(3);
      vectors->SetNumberOfTuples(d->GetNumberOfPoints());
      vectors->Fill(1.0);
      d->GetPointData()->AddArray(vectors);
    });
}

TEST(PackRefusals, RadiusOutOfRange)
{
  for (double radius : { NaN, Infinity, 0.0, -1.0 })
  {
    SCOPED_TRACE(radius);
    RefusesPack<TwoPoint>({ Name, "'Radius' requires finite values > 0", "got" },
      [=](auto& p) { p.Radius[5] = radius; });
  }
}

TEST(PackRefusals, CoordinatesThatAreNotFinite)
{
  RefusesPack<TwoPoint>({ Name, "finite coordinates", "nan" }, [](auto& p) { p.Y[7] = NaN; });
  RefusesPack<TwoPoint>({ Name, "finite coordinates", "inf" }, [](auto& p) { p.Z[7] = Infinity; });
}

TEST(PackRefusals, NoModes)
{
  RefusesData<TwoPoint>(
    { Name, "'Mode' is required" }, [](vtkPolyData* d) { d->GetPointData()->RemoveArray("Mode"); });
}

TEST(PackRefusals, ModesOutOfRange)
{
  RefusesPack<TwoPoint>(
    { Name, "'Mode' requires the values 1", "got 0" }, [](auto& p) { p.Mode[3] = 0; });
  RefusesPack<TwoPoint>({ Name, "'Mode' requires the values 1", "got 2000000000" },
    [](auto& p) { p.Mode[3] = 2000000000; });
}

TEST(PackRefusals, GapInTheModes)
{
  RefusesPack<TwoPoint>({ Name, "'Mode' requires the values 1", "no sphere of mode 4" },
    [](auto& p) { p.Mode[3] = 5; });
}

TEST(PackRefusals, CoincidentCentres)
{
  RefusesPack<TwoPoint>({ Name, "distinct centres" },
    [](auto& p)
    {
      p.X[1] = p.X[0];
      p.Y[1] = p.Y[0];
      p.Z[1] = p.Z[0];
    });
}

TEST(WindowRefusals, CentreOutsideTheBox)
{
  Refuses<TwoPoint>({ Name, "requires every centre inside", "1 of 600 outside" },
    { [](auto& p) { p.X[0] = 1.5 * Edge; }, {}, {} }, false);
}

TEST(WindowRefusals, BoxSmallerThanASphere)
{
  RefusesPack<TwoPoint>(
    { Name, "BoxSize requires periodic edges longer" }, [](auto& p) { p.Radius[0] = 0.51 * Edge; });
}

// Every filter has the window checked when it takes its input
namespace
{
template <class Filter>
void RefusesLayer(const char* label, const std::function<void(Filter*)>& configure = {})
{
  const std::vector<std::string> parts = { label,
    "The window requires edges longer than the largest sphere's diameter, 1.2, got a box window" };
  Refuses<Filter>(parts,
    { [](auto& p)
      {
        for (double& z : p.Z)
        {
          z *= 1e-3;
        }
      },
      [](vtkPolyData* d) { d->GetFieldData()->Initialize(); }, {} },
    false, configure);
}
}

TEST(WindowRefusals, LayerOfSpheres)
{
  RefusesLayer<TwoPoint>(Name.c_str());
  RefusesLayer<vtkRUCOnePointProbability>("One-Point Probability");
  RefusesLayer<vtkRUCThirdOrderParameters>("Third-Order Parameters");
  RefusesLayer<vtkRUCNeighbourStatistics>("Neighbour Statistics");
  RefusesLayer<vtkRUCThreePointProbability>("Three-Point Probability");
  RefusesLayer<vtkRUCRadialDistribution>("Radial Distribution");
  RefusesLayer<vtkRUCChordLengths>("Chord Lengths");
  RefusesLayer<vtkRUCVoidDistances>("Void Distances");
  RefusesLayer<vtkRUCParticleModes>("Particle Modes");
  RefusesLayer<vtkRUCLabelImage>("Label Image");
  RefusesLayer<vtkRUCEffectiveProperties>("Effective Properties",
    [](auto* filter)
    {
      filter->SetMethod(vtkRUCEffectiveProperties::BOUNDS);
      filter->SetResolution(12);
      filter->SetSecondResolution(0);
    });
  RefusesLayer<vtkRUCPointsToSpherePack>("Points To Sphere Pack");
}

TEST(PackRefusals, BlocksWithoutData)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetNumberOfBlocks(3);
  vtkNew<vtkRUCThreePointProbability> filter;
  const Errors errors(filter);
  filter->SetInputData(blocks);
  filter->Update();
  ExpectRefusal(filter, errors, { "Three-Point Probability", "requires at least one sphere" });
}

TEST(WindowRefusals, BoxWithoutSize)
{
  Refuses<TwoPoint>(
    { Name, "BoxSize requires three finite edges > 0", "got 0 0 0" }, { {}, {}, {}, 0.0 });
  Refuses<TwoPoint>(
    { Name, "BoxSize requires three finite edges > 0", "got -3 -3 -3" }, { {}, {}, {}, -3.0 });
}

TEST(LagRefusals, MaximumLagOutOfRange)
{
  RefusesLags(
    { "MaximumLag requires 0 < MaximumLag <= ", "got 12" },
    [](TwoPoint* f) { f->SetMaximumLag(12.0); }, false);
  RefusesLags({ "MaximumLag requires", "got 1e+09" }, [](TwoPoint* f) { f->SetMaximumLag(1e9); });
  RefusesLags({ "MaximumLag requires", "got -1" }, [](TwoPoint* f) { f->SetMaximumLag(-1.0); });
}

TEST(LagRefusals, NumberOfLagsOutOfRange)
{
  for (int lags : { 0, -5, 2000000000 })
  {
    SCOPED_TRACE(lags);
    RefusesLags({ "NumberOfLags requires 1 <= NumberOfLags <= 100000", std::to_string(lags) },
      [=](TwoPoint* f) { f->SetNumberOfLags(lags); });
  }
}

TEST(LagRefusals, SaturationTolerance)
{
  RefusesLags({ "SaturationTolerance requires", "got 0" },
    [](TwoPoint* f) { f->SetSaturationTolerance(0.0); });
}
