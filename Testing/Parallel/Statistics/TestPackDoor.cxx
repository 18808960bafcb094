// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// What filters say of packs that are likely not what they are meant to be
#include "Refusals.h"

#include "RankCommunicator.h"
#include "vtkRUCChordLengths.h"
#include "vtkRUCDirectionalProbability.h"
#include "vtkRUCEffectiveProperties.h"
#include "vtkRUCLabelImage.h"
#include "vtkRUCNeighbourStatistics.h"
#include "vtkRUCOnePointProbability.h"
#include "vtkRUCParticleModes.h"
#include "vtkRUCPointsToSpherePack.h"
#include "vtkRUCProbabilityMap.h"
#include "vtkRUCRadialDistribution.h"
#include "vtkRUCThirdOrderParameters.h"
#include "vtkRUCThreePointProbability.h"
#include "vtkRUCTwoPointProbability.h"
#include "vtkRUCUnitCellReconstruction.h"
#include "vtkRUCVoidDistances.h"

#include "vtkImageData.h"
#include "vtkTable.h"
#include "vtkTrivialProducer.h"

#include <cmath>
#include <string>
#include <type_traits>

namespace
{
vtkSmartPointer<vtkPolyData> DataOf(const ruc::SpherePack& pack, bool periodic = true)
{
  return MakePolyData(pack, Edge, periodic, IsMine);
}

// Makes a filter quick and silent
template <class Filter>
void Prepare(Filter*)
{
}
void Prepare(vtkRUCParticleModes* filter)
{
  filter->SetMethod(vtkRUCParticleModes::ONE_PER_SIZE);
}
void Prepare(vtkRUCPointsToSpherePack* filter)
{
  // Else it finds one where none is given
  filter->SetFindWindow(false);
}
void Prepare(vtkRUCChordLengths* filter)
{
  filter->SetNumberOfLines(200);
}
void Prepare(vtkRUCNeighbourStatistics* filter)
{
  // Else cells of the sparse spheres near the faces of the block are not known
  filter->SetWindowMargin(3.6);
}
void Prepare(vtkRUCVoidDistances* filter)
{
  filter->SetSpacing(0.4);
}
void Prepare(vtkRUCThirdOrderParameters* filter)
{
  // Else few centres are as far from the faces of the block
  filter->SetCutOff(2.5);
}
void Prepare(vtkRUCThreePointProbability* filter)
{
  // Enough to meet every phase
  filter->SetNumberOfThrows(200);
  filter->SetNumberOfLags(4);
}
void Prepare(vtkRUCEffectiveProperties* filter)
{
  filter->SetMethod(vtkRUCEffectiveProperties::BOUNDS);
  filter->SetResolution(12);
  filter->SetSecondResolution(0);
}
void Prepare(vtkRUCProbabilityMap* filter)
{
  filter->SetResolution(4);
}
void Prepare(vtkRUCUnitCellReconstruction* filter)
{
  filter->SetNumberOfParticles(20);
  filter->SetMaximumIterations(2);
}

// Returns the warnings of a filter, which takes the data
template <class Filter>
std::vector<std::string> WarningsOf(
  vtkPolyData* data, const std::function<void(Filter*)>& configure = {})
{
  vtkNew<Filter> filter;
  Prepare(filter.Get());
  if (configure)
  {
    configure(filter);
  }
  const Errors errors(filter);
  const Warnings warnings(filter);
  filter->SetInputData(data);
  filter->Update();
  EXPECT_TRUE(errors.Texts.empty()) << (errors.Texts.empty() ? "" : errors.Texts.front());
  return warnings.Texts;
}

void ExpectOne(const std::vector<std::string>& warnings, const std::vector<std::string>& parts)
{
  EXPECT_EQ(warnings.size(), Rank() == 0 ? 1u : 0u) << "one warning, on rank 0";
  for (const std::string& text : warnings)
  {
    ExpectParts(text, parts);
    EXPECT_EQ(text.find("(0x"), std::string::npos) << text;
  }
}

// Does it for every filter that looks at the spheres of a pack
template <class Check>
void ForEachFilter(Check&& check)
{
  check(static_cast<vtkRUCPointsToSpherePack*>(nullptr));
  check(static_cast<vtkRUCParticleModes*>(nullptr));
  check(static_cast<vtkRUCOnePointProbability*>(nullptr));
  check(static_cast<vtkRUCTwoPointProbability*>(nullptr));
  check(static_cast<vtkRUCThreePointProbability*>(nullptr));
  check(static_cast<vtkRUCDirectionalProbability*>(nullptr));
  check(static_cast<vtkRUCProbabilityMap*>(nullptr));
  check(static_cast<vtkRUCChordLengths*>(nullptr));
  check(static_cast<vtkRUCRadialDistribution*>(nullptr));
  check(static_cast<vtkRUCThirdOrderParameters*>(nullptr));
  check(static_cast<vtkRUCNeighbourStatistics*>(nullptr));
  check(static_cast<vtkRUCVoidDistances*>(nullptr));
  check(static_cast<vtkRUCLabelImage*>(nullptr));
  check(static_cast<vtkRUCEffectiveProperties*>(nullptr));
}

template <class Filter>
using FilterOf = std::remove_pointer_t<Filter>;

void ExpectSameColumns(vtkTable* got, vtkTable* expected)
{
  ASSERT_EQ(got->GetNumberOfRows(), expected->GetNumberOfRows());
  for (vtkIdType column = 0; column < expected->GetNumberOfColumns(); ++column)
  {
    for (vtkIdType row = 0; row < expected->GetNumberOfRows(); ++row)
    {
      ASSERT_EQ(got->GetValue(row, column).ToDouble(), expected->GetValue(row, column).ToDouble());
    }
  }
}

ruc::SpherePack LeftHalf()
{
  ruc::SpherePack half;
  for (std::size_t i = 0; i < FewSizes().Size(); ++i)
  {
    if (FewSizes().X[i] < 0.5 * Edge)
    {
      half.Append(FewSizes(), i);
    }
  }
  return half;
}

ruc::SpherePack Diameters()
{
  ruc::SpherePack pack = FewSizes();
  for (double& radius : pack.Radius)
  {
    radius *= 2.0;
  }
  return pack;
}
}

TEST(PackDoor, AGoodPackIsTakenWithoutAWord)
{
  ForEachFilter(
    [](auto* f)
    {
      for (bool periodic : { true, false })
      {
        EXPECT_TRUE(WarningsOf<FilterOf<decltype(f)>>(DataOf(FewSizes(), periodic)).empty());
      }
    });
}

TEST(PackDoor, ACutPackIsToldWithBothVolumes)
{
  ForEachFilter(
    [](auto* f)
    {
      const auto warnings = WarningsOf<FilterOf<decltype(f)>>(DataOf(LeftHalf()));
      ExpectOne(warnings, { "the centres fill only a volume of about ", " of the window's 1728" });
      // A cell with 16 spheres on average is 3.8 wide, so that 3 to 6 layers cross the box
      const std::string about = "about ";
      for (const std::string& text : warnings)
      {
        EXPECT_NEAR(std::stod(text.substr(text.find(about) + about.size())), 864.0, 300.0);
      }
    });
}

TEST(PackDoor, AMissingWindowIsTold)
{
  const auto data = DataOf(FewSizes());
  data->GetFieldData()->Initialize();
  ForEachFilter(
    [&](auto* f)
    {
      ExpectOne(WarningsOf<FilterOf<decltype(f)>>(data),
        { "no window is known", "with 600 spheres fractions are about 1.00502 % too high" });
    });
}

TEST(PackDoor, AWindowOfThePropertiesBesideThatOfThePackIsTold)
{
  using Filter = vtkRUCTwoPointProbability;
  const auto warnings = [](double edge)
  {
    return WarningsOf<Filter>(DataOf(FewSizes()),
      [=](Filter* f)
      {
        f->SetBoxSize(edge, edge, edge);
        f->SetBoxPeriodic(1, 1, 1);
      });
  };
  ExpectOne(warnings(0.5 * Edge), { "the window of the properties is not used", "12 x 12 x 12" });
  EXPECT_TRUE(warnings(Edge).empty());
}

TEST(PackDoor, CentresOutsideAPeriodicBoxMakeNoDifference)
{
  // The numbers have few digits, so that whole edges are added and taken off without rounding
  ruc::SpherePack inside = FewSizes();
  for (std::vector<double>* axis : { &inside.X, &inside.Y, &inside.Z })
  {
    for (double& c : *axis)
    {
      c = std::ldexp(std::round(std::ldexp(c, 20)), -20);
    }
  }
  ruc::SpherePack outside = inside;
  for (std::size_t i = 0; i < 100; ++i)
  {
    outside.X[6 * i] += Edge * (i % 2 == 0 ? 1 : -3);
    outside.Z[6 * i] -= Edge;
  }
  vtkNew<vtkRUCTwoPointProbability> a, b;
  const Warnings warnings(b);
  a->SetInputData(DataOf(inside));
  b->SetInputData(DataOf(outside));
  b->SetCropToWindow(true);
  a->Update();
  b->Update();
  ExpectSameColumns(vtkTable::SafeDownCast(b->GetOutputDataObject(0)),
    vtkTable::SafeDownCast(a->GetOutputDataObject(0)));
  ExpectOne(warnings.Texts, { "100 of 600 centres lay outside the periodic box", "were moved" });

  // Particle Modes hands the spheres on where they were moved to, and says so once
  vtkNew<vtkRUCParticleModes> modes;
  Prepare(modes.Get());
  modes->SetInputData(DataOf(outside));
  modes->SetCropToWindow(true);
  const Warnings first(modes);
  vtkNew<vtkRUCTwoPointProbability> c;
  const Warnings second(c);
  c->SetInputConnection(modes->GetOutputPort());
  c->Update();
  ExpectOne(first.Texts, { "100 of 600 centres" });
  EXPECT_TRUE(second.Texts.empty());
  std::int64_t points = modes->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT);
  RankCommunicator(vtkMultiProcessController::GetGlobalController()).Sum(&points, 1);
  EXPECT_EQ(points, 600);
}

// 200 spheres of each of the radii 0.4, 0.5 and 0.6 in a cube of edge 12; with diameters as radii
// they take pi / 2 of it
TEST(PackDoor, DiametersAsRadiiAreRefusedByExactSums)
{
  const std::vector<std::string> parts = { "Exact sums require spheres with volumes that add up to "
                                           "less than that of the window, got 1.5708 of it",
    "RadiusIsDiameter" };
  const auto spoil = [](ruc::SpherePack& pack) { pack = Diameters(); };
  RefusesPack<vtkRUCOnePointProbability>(parts, spoil);
  RefusesPack<vtkRUCTwoPointProbability>(parts, spoil);
  RefusesPack<vtkRUCDirectionalProbability>(parts, spoil);
  Refuses<vtkRUCProbabilityMap>(parts, { spoil, {}, {} }, true, [](auto* f) { Prepare(f); });
  Refuses<vtkRUCUnitCellReconstruction>(
    parts, { spoil, {}, {} }, true, [](auto* f) { Prepare(f); });
}

TEST(PackDoor, OverlapThatNoPackHasIsRefusedByExactSums)
{
  // Half of the spheres, whose volumes do not add up to that of the window
  RefusesPack<vtkRUCTwoPointProbability>(
    { "Exact sums require spheres with an overlap of at most 10 % of their volume, got " },
    [](ruc::SpherePack& pack)
    {
      const ruc::SpherePack all = Diameters();
      pack = {};
      for (std::size_t i = 0; i < all.Size(); ++i)
      {
        if (all.X[i] < 0.5 * Edge)
        {
          pack.Append(all, i);
        }
      }
    });
}

TEST(PackDoor, SamplingOfDiametersGoesOnWithAWarning)
{
  const std::vector<std::string> parts = { "a pack of spheres has volumes that add up to less" };
  const auto data = DataOf(Diameters());
  ExpectOne(WarningsOf<vtkRUCChordLengths>(data), parts);
  ExpectOne(WarningsOf<vtkRUCLabelImage>(data), parts);
  ExpectOne(WarningsOf<vtkRUCThreePointProbability>(data), parts);
  ExpectOne(WarningsOf<vtkRUCRadialDistribution>(data), parts);
  ExpectOne(WarningsOf<vtkRUCParticleModes>(data), parts);
  ExpectOne(WarningsOf<vtkRUCTwoPointProbability>(data,
              [](auto* f)
              {
                f->SetMethod(vtkRUCTwoPointProbability::CHORD_SAMPLING);
                f->SetNumberOfLines(200);
              }),
    parts);
}

TEST(PackDoor, EveryFilterTakesOnePack)
{
  vtkNew<vtkTrivialProducer> first, second;
  first->SetOutput(DataOf(FewSizes()));
  second->SetOutput(DataOf(LeftHalf()));
  ForEachFilter(
    [&](auto* f)
    {
      vtkNew<FilterOf<decltype(f)>> filter;
      const Errors errors(filter);
      filter->AddInputConnection(first->GetOutputPort());
      filter->AddInputConnection(second->GetOutputPort());
      filter->Update();
      ExpectRefusal(filter, errors, { "Input takes one pack, got 2." });
    });
  vtkNew<vtkRUCUnitCellReconstruction> cell;
  const Errors errors(cell);
  cell->AddInputConnection(first->GetOutputPort());
  cell->AddInputConnection(second->GetOutputPort());
  cell->Update();
  ExpectRefusal(cell, errors, { "Input takes one pack or table, got 2." });
}

TEST(PackDoor, PointsWithoutSizeAreLeftOutByMinimumDiameter)
{
  ruc::SpherePack pack = FewSizes();
  pack.Radius[5] = pack.Radius[300] = 0.0;
  pack.X[5] = 17.0 * Edge; // its place does not matter
  vtkNew<vtkRUCParticleModes> modes;
  Prepare(modes.Get());
  const Errors errors(modes);
  const Warnings warnings(modes);
  modes->SetInputData(DataOf(pack, false));
  modes->SetMinimumDiameter(0.1);
  modes->Update();
  EXPECT_TRUE(errors.Texts.empty() && warnings.Texts.empty());
  std::int64_t points = modes->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT);
  RankCommunicator(vtkMultiProcessController::GetGlobalController()).Sum(&points, 1);
  EXPECT_EQ(points, 598);
  RefusesPack<vtkRUCParticleModes>(
    { "requires finite values > 0, got 0", "Particle Modes with a MinimumDiameter leaves" },
    [](ruc::SpherePack& bad) { bad.Radius[5] = 0.0; });
}

TEST(PackDoor, ARefusedInputIsNotToldAgainDownstream)
{
  ruc::SpherePack pack = FewSizes();
  pack.X[7] = 1e300;
  vtkNew<vtkRUCParticleModes> modes;
  Prepare(modes.Get());
  vtkNew<vtkRUCThreePointProbability> probability;
  Prepare(probability.Get());
  const Errors first(modes), second(probability);
  modes->SetInputData(DataOf(pack));
  probability->SetInputConnection(modes->GetOutputPort());
  for (int port = 0; port < 4; ++port)
  {
    probability->Update(port);
    ExpectParts(RefusalOf(probability->GetOutputDataObject(port)), { "Particle Modes", "1e+300" });
  }
  ExpectRefusal(modes, first, { "Particle Modes: Points require coordinates of at most" });
  EXPECT_TRUE(second.Texts.empty());
  EXPECT_TRUE(IsEmpty(probability));
  modes->SetInputData(DataOf(FewSizes()));
  probability->Update();
  EXPECT_EQ(RefusalOf(probability->GetOutputDataObject(0)), "") << "mended input is taken again";
}

// What is no pack is refused in one line, and not by the pipeline
TEST(PackDoor, OtherDataAreRefusedInOneLine)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 3, 3);
  vtkNew<vtkTable> table;
  ForEachFilter(
    [&](auto* of)
    {
      using Filter = FilterOf<decltype(of)>;
      const auto refuses = [&](vtkDataObject* data, const std::vector<std::string>& parts)
      {
        vtkNew<Filter> filter;
        Prepare(filter.Get());
        const Errors errors(filter);
        filter->SetInputData(data);
        filter->Update();
        ExpectRefusal(filter, errors, parts);
      };
      refuses(image, { "requires points, got a vtkImageData; Particles From Image makes" });
      if (!std::is_same<Filter, vtkRUCPointsToSpherePack>::value)
      {
        refuses(table, { "requires points, got a vtkTable; Points To Sphere Pack makes" });
      }
    });
}
