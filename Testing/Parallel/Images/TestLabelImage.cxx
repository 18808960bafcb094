// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Label images are the same on any number of ranks, in pieces, and say what they cannot show
#include "Equality.h"
#include "Refusals.h"
#include "Stops.h"

#include "vtkRUCLabelImage.h"

#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <cmath>
#include <limits>

using LabelImage = vtkRUCLabelImage;

namespace
{
class LabelImageEquality : public EveryPack
{
};
INSTANTIATE_EVERY_PACK(LabelImageEquality);

void WantEverything(LabelImage* filter)
{
  filter->SetVolumeFractions(true);
  filter->SetFractions(LabelImage::EVERY_MODE);
}

// The pack, dealt out in turn, with ids from `first`
// So many spheres, in their order, have one Id
vtkSmartPointer<vtkPolyData> PackWithIds(vtkIdType first, vtkIdType ofOneId = 1)
{
  const auto data = MakePolyData(FewSizes(), Edge, true, IsMine);
  vtkNew<vtkIntArray> id;
  id->SetName("Id");
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    id->InsertNextValue(static_cast<int>(first + (i * NumberOfRanks() + Rank()) / ofOneId));
  }
  data->GetPointData()->AddArray(id);
  return data;
}

vtkImageData* ImageOf(LabelImage* filter)
{
  return vtkImageData::SafeDownCast(filter->GetOutputDataObject(0));
}

long long Total(vtkIdType own)
{
  const long long number = own;
  long long sum = 0;
  vtkMultiProcessController::GetGlobalController()->AllReduce(
    &number, &sum, 1, vtkCommunicator::SUM_OP);
  return sum;
}
}

TEST_P(LabelImageEquality, OnCells)
{
  ExpectSame<LabelImage>(
    [](auto* f)
    {
      WantEverything(f);
      f->SetVoxelSize(0.31);
    });
}

TEST_P(LabelImageEquality, OnPoints)
{
  ExpectSame<LabelImage>(
    [](auto* f)
    {
      WantEverything(f);
      f->SetDimensions(13, 17, 29);
      f->SetArrayOn(LabelImage::POINTS);
    });
}

TEST_P(LabelImageEquality, FewerVoxelsThanRanks)
{
  ExpectSame<LabelImage>(
    [](auto* f)
    {
      WantEverything(f);
      f->SetDimensions(1, 1, 2);
      f->SetFractionMethod(LabelImage::SUPERSAMPLED);
    });
}

TEST(LabelImage, PiecesAreTheWholeImage)
{
  vtkNew<LabelImage> filter;
  filter->SetInputData(MakePolyData(FewSizes(), Edge, true, IsMine));
  filter->SetVoxelSize(0.25);
  filter->Update();
  vtkImageData* image = ImageOf(filter);
  EXPECT_EQ(Total(image->GetNumberOfCells()), 48 * 48 * 48);
  int whole[6];
  filter->GetOutputInformation(0)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
  EXPECT_EQ(std::vector<int>(whole, whole + 6), (std::vector<int>{ 0, 48, 0, 48, 0, 48 }));
  EXPECT_EQ(image->GetSpacing()[2], 0.25);
  EXPECT_EQ(image->GetCellData()->GetNumberOfArrays(), 1);
  EXPECT_EQ(image->GetFieldData()->GetArray("VoxelSize")->GetTuple1(1), 0.25);
  EXPECT_EQ(image->GetFieldData()->GetArray("IncompleteMargin")->GetTuple1(0), 0.0);
  // The share of voxels with centres in spheres is that of the spheres, but for the scatter of the
  // centres of voxels on their surfaces
  vtkDataArray* phase = image->GetCellData()->GetArray("Phase");
  vtkIdType inSpheres = 0;
  for (vtkIdType i = 0; i < phase->GetNumberOfTuples(); ++i)
  {
    inSpheres += phase->GetTuple1(i) > 0.0;
  }
  const double matrix = image->GetFieldData()->GetArray("VolumeFractions")->GetTuple1(3);
  EXPECT_NEAR(1.0 - Total(inSpheres) / std::pow(48.0, 3), matrix, 0.002);
}

TEST(LabelImage, AutomaticVoxelsAreATwentiethOfTheMeanDiameter)
{
  vtkNew<LabelImage> filter;
  filter->SetInputData(MakePolyData(FewSizes(), Edge, false, IsMine));
  filter->Update();
  // 200 spheres each of the diameters 0.8, 1 and 1.2
  const double mean = std::cbrt((0.512 + 1.0 + 1.728) / 3.0);
  EXPECT_NEAR(ImageOf(filter)->GetSpacing()[0], mean / 20.0, 1e-12);
  EXPECT_EQ(
    Total(ImageOf(filter)->GetNumberOfCells()), std::pow(std::floor(20.0 * Edge / mean), 3));
  EXPECT_DOUBLE_EQ(
    ImageOf(filter)->GetFieldData()->GetArray("IncompleteMargin")->GetTuple1(0), 0.6);
}

TEST(LabelImage, IdsBelowOneAreRaised)
{
  for (int first : { 1, 0, -4 })
  {
    vtkNew<LabelImage> filter;
    filter->SetInputData(PackWithIds(first));
    filter->SetDimensions(40, 40, 40);
    filter->SetParticleIds(true);
    filter->Update();
    vtkDataArray* raised = ImageOf(filter)->GetFieldData()->GetArray("ParticleIdsRaised");
    EXPECT_EQ(raised->GetTuple1(0), 1.0 - first);
    double range[2];
    ImageOf(filter)->GetCellData()->GetArray("ParticleId")->GetRange(range);
    EXPECT_TRUE(range[0] == 0.0 && range[1] <= 600.0 && range[1] > 500.0) << range[1];
  }
}

TEST(LabelImage, ACylinderIsMarked)
{
  vtkNew<LabelImage> filter;
  const auto data = MakePolyData(FewSizes(), Edge, false, IsMine);
  data->GetFieldData()->Initialize();
  filter->SetInputData(data);
  filter->SetCylinderBase(6.0, 6.0, 0.0);
  filter->SetCylinderRadius(5.0);
  filter->SetCylinderHeight(12.0);
  filter->SetCropToWindow(true);
  filter->SetVoxelSize(0.1);
  filter->Update();
  vtkDataArray* window = ImageOf(filter)->GetCellData()->GetArray("Window");
  vtkIdType inside = 0;
  for (vtkIdType i = 0; i < window->GetNumberOfTuples(); ++i)
  {
    inside += window->GetTuple1(i) == 1.0;
  }
  EXPECT_EQ(Total(window->GetNumberOfTuples()), 100 * 100 * 120);
  EXPECT_NEAR(Total(inside) / 1.2e6, 0.785398, 0.001);

  vtkNew<LabelImage> alone;
  alone->SetController(nullptr);
  const auto whole = MakePolyData(FewSizes(), Edge, false, [](std::size_t) { return true; });
  whole->GetFieldData()->Initialize();
  alone->SetInputData(whole);
  alone->SetCylinderBase(6.0, 6.0, 0.0);
  alone->SetCylinderRadius(5.0);
  alone->SetCylinderHeight(12.0);
  alone->SetCropToWindow(true);
  alone->SetVoxelSize(0.1);
  alone->Update();
  ExpectSameOutput(ImageOf(filter), ImageOf(alone));
}

TEST(LabelImageRefusals, NoPoints)
{
  RefusesPack<LabelImage>({ "Label Image", "no points" }, [](auto& p) { p = {}; });
  // Without a window the bounds are infinite on the rank that has the point, and on no other
  RefusesData<LabelImage>({ "Label Image", "finite" },
    [](vtkPolyData* data)
    {
      for (const char* name : { "BoxOrigin", "BoxSize", "BoxPeriodic" })
      {
        data->GetFieldData()->RemoveArray(name);
      }
      if (data->GetNumberOfPoints() > 0 && Rank() == 0)
      {
        data->GetPoints()->SetPoint(0, 1.0, 1.0, std::numeric_limits<double>::infinity());
      }
    });
}

TEST(LabelImageRefusals, Settings)
{
  const auto refuses = [](const std::vector<std::string>& parts, const auto& spoil)
  { RefusesSettings<LabelImage>(parts, spoil, true, [](auto* f) { f->SetVoxelSize(1.0); }); };
  refuses({ "Label Image requires Phases, ParticleIds or VolumeFractions, got none of them." },
    [](LabelImage* f) { f->SetPhases(false); });
  refuses({ "Dimensions requires three numbers >= 1, or 0 0 0, got 10 0 10." },
    [](LabelImage* f) { f->SetDimensions(10, 0, 10); });
  refuses({ "VoxelSize requires a finite number > 0, or 0 for an automatic one, got -1." },
    [](LabelImage* f) { f->SetVoxelSize(-1.0); });
  refuses({ "VoxelSize requires 1 to ", "12 x 12 x 12, got 30." },
    [](LabelImage* f) { f->SetVoxelSize(30.0); });
  refuses({ "SamplesPerAxis requires a number from 1 to 64, got 65." },
    [](LabelImage* f) { f->SetSamplesPerAxis(65); });
  refuses({ "FractionMethod requires the value 0 or 1, got 2." },
    [](LabelImage* f) { f->SetFractionMethod(2); });
  refuses(
    { "Fractions requires the value 0 or 1, got -1." }, [](LabelImage* f) { f->SetFractions(-1); });
  refuses({ "ArrayOn requires the value 0 or 1, got 2." }, [](LabelImage* f) { f->SetArrayOn(2); });
  refuses({ "ParticleIds requires a point array 'Id', got a pack without" },
    [](LabelImage* f) { f->SetParticleIds(true); });
}

TEST(LabelImageRefusals, MoreModesThanAByteHolds)
{
  RefusesPack<LabelImage>({ "Phases requires at most 255 modes, got 300." },
    [](ruc::SpherePack& pack)
    {
      for (std::size_t i = 0; i < pack.Size(); ++i)
      {
        pack.Mode[i] = 1 + static_cast<int>(i / 2);
      }
    });
}

// Nothing of that size is allocated
TEST(LabelImageRefusals, ImagesBeyondTheMemory)
{
  const std::vector<std::string> parts = { "Label Image", "MemoryLimit requires at least",
    "MB on every rank" };
  RefusesSettings<LabelImage>(parts, [](auto* f) { f->SetDimensions(40000, 40000, 40000); });
  RefusesSettings<LabelImage>(
    parts, [](auto* f) { f->SetDimensions(2147483646, 2147483646, 2147483646); });
  RefusesSettings<LabelImage>(parts, [](auto* f) { f->SetVoxelSize(1e-5); });
  RefusesSettings<LabelImage>(parts, [](auto* f) { f->SetMemoryLimit(1e-6); });
  // Rank 0 has no spheres where there are others, and so cannot estimate
  vtkNew<LabelImage> filter;
  const Errors errors(filter);
  filter->SetInputData(MakePolyData(
    FewSizes(), Edge, true, [](std::size_t) { return Rank() == NumberOfRanks() - 1; }));
  filter->SetDimensions(4000, 4000, 4000);
  filter->Update();
  ExpectRefusal(filter, errors, parts);
}

TEST(LabelImage, TheSizeOfVoxelsIsThatOfTheSpheresOfAllRanks)
{
  // A rank that has the small spheres alone would want 10^21 voxels
  ruc::SpherePack pack;
  pack.X = { 0.5 * Edge, 0.1 * Edge, 0.9 * Edge, 0.1 * Edge };
  pack.Y = pack.Z = pack.X;
  pack.Y[3] = 0.9 * Edge;
  pack.Radius = { 0.2 * Edge, 1e-7 * Edge, 1e-7 * Edge, 1e-7 * Edge };
  pack.Mode = { 2, 1, 1, 1 };
  pack.Id = { 1, 2, 3, 4 };
  vtkNew<LabelImage> filter;
  const Errors errors(filter);
  filter->SetInputData(MakePolyData(pack, Edge, true, IsMine));
  filter->Update();
  EXPECT_TRUE(errors.Texts.empty()) << errors.Texts.front();
  // The mean diameter by volume, 0.4 Edge / cbrt(4), has 20 voxels
  const long long n = std::lround(20.0 * std::cbrt(4.0) / 0.4);
  EXPECT_EQ(Total(ImageOf(filter)->GetNumberOfCells()), n * n * n);
}

TEST(LabelImage, WarnsOfIdsThatAreRepeated)
{
  for (int ofOneId : { 1, 2, 5 })
  {
    vtkNew<LabelImage> filter;
    const Warnings warnings(filter);
    filter->SetInputData(PackWithIds(1, ofOneId));
    filter->SetDimensions(10, 10, 10);
    filter->SetParticleIds(true);
    filter->Update();
    const std::size_t last = warnings.Texts.size();
    EXPECT_EQ(last, Rank() == 0 && ofOneId > 1 ? 1u : 0u);
    if (last > 0)
    {
      ExpectParts(warnings.Texts[0],
        { std::to_string(600 - 600 / ofOneId) + " spheres have the Id of another one" });
    }
  }
}

TEST(LabelImage, AStoppedRunHasNoImage)
{
  vtkNew<LabelImage> filter;
  const StopAt stop(filter, 0);
  const Errors errors(filter);
  filter->SetInputData(MakePolyData(FewSizes(), Edge, true, IsMine));
  filter->SetDimensions(30, 30, 30);
  filter->Update();
  ExpectRefusal(filter, errors, { "stopped before all voxels were labelled" });
}
