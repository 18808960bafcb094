// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// The statistics of an image are the same however it is spread over any number of ranks, and bad
// images are refused
#include "Equality.h"
#include "Refusals.h"
#include "Stops.h"
#include "VoxelImages.h"

#include "vtkRUCImageStatistics.h"

#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkTable.h"

#include <cmath>
#include <functional>
#include <limits>

using ImageStatistics = vtkRUCImageStatistics;

namespace
{
constexpr int Size[3] = { 17, 13, 20 };

// Layers, balls and a matrix: labels 0, 3 and 7
int LabelAt(int x, int y, int z)
{
  if ((x - 8) * (x - 8) + (y - 6) * (y - 6) + (z - 7) * (z - 7) < 20)
  {
    return 7;
  }
  return (x + 2 * y + z / 3) % 5 == 0 ? 3 : 0;
}

const Form Forms[] = { { "integers on cells", false, VTK_INT },
  { "floats on points", true, VTK_FLOAT } };

vtkSmartPointer<vtkImageData> MakeImage(
  const Form& form, int axis, int begin, int end, const Value& value, const char* name = "Phase")
{
  return VoxelImage{ { Size[0], Size[1], Size[2] }, 0.5, name }.Make(form, axis, begin, end, value);
}

// The piece of a rank of an image that is cut across an axis, or lies on the last rank
struct Cut
{
  const char* Name;
  int Axis;
  bool AllOnLast;
};
const Cut Cuts[] = { { "across x", 0, false }, { "across z", 2, false },
  { "on the last rank", 0, true } };

vtkSmartPointer<vtkImageData> Piece(const Form& form, const Cut& cut, const Value& value)
{
  const int ranks = NumberOfRanks(), n = Size[cut.Axis];
  if (cut.AllOnLast)
  {
    return MakeImage(form, 0, 0, Rank() == ranks - 1 ? Size[0] : 0, value);
  }
  return MakeImage(form, cut.Axis, n * Rank() / ranks, n * (Rank() + 1) / ranks, value);
}

vtkSmartPointer<vtkImageData> Whole(const Form& form, const Value& value = LabelAt)
{
  return MakeImage(form, 0, 0, Size[0], value);
}

double InsideAt(int x, int y, int)
{
  return (x - 8) * (x - 8) + (y - 6) * (y - 6) < 45;
}

void ExpectSameStatistics(const std::function<void(ImageStatistics*)>& configure, bool masked)
{
  for (const Form& form : Forms)
  {
    vtkNew<ImageStatistics> alone;
    configure(alone);
    alone->SetController(nullptr);
    alone->SetInputData(Whole(form));
    if (masked)
    {
      alone->SetInputDataObject(1, Whole(form, InsideAt));
    }
    alone->Update();
    for (const Cut& cut : Cuts)
    {
      SCOPED_TRACE(std::string(form.Name) + " " + cut.Name);
      vtkNew<ImageStatistics> together;
      configure(together);
      together->SetInputData(Piece(form, cut, LabelAt));
      if (masked)
      {
        together->SetInputDataObject(1, Piece(form, Cuts[1], InsideAt));
      }
      together->Update();
      for (int port = 0; port < together->GetNumberOfOutputPorts(); ++port)
      {
        SCOPED_TRACE("output " + std::to_string(port));
        EXPECT_EQ(IsEmpty(alone->GetOutputDataObject(port)),
          port == ImageStatistics::CHORDS && !alone->GetChordLengths());
        ExpectSameOutput(together->GetOutputDataObject(port), alone->GetOutputDataObject(port));
      }
    }
  }
}

// Expects that a good image is taken, and one that is spoiled, or with other settings, is not
void RefusesImage(
  const std::vector<std::string>& parts, const std::function<void(vtkImageData*)>& spoil,
  const std::function<void(ImageStatistics*)>& set = [](ImageStatistics*) {},
  const Value& value = LabelAt)
{
  vtkNew<ImageStatistics> filter;
  const Errors errors(filter);
  filter->SetInputData(Piece(Forms[0], Cuts[1], LabelAt));
  filter->Update();
  EXPECT_TRUE(errors.Texts.empty()) << "the good image is taken";
  const auto bad = Piece(Forms[0], Cuts[1], value);
  spoil(bad);
  set(filter);
  filter->SetInputData(bad);
  ExpectRefusal(filter, errors, parts);
}

void RefusesSettings(
  const std::vector<std::string>& parts, const std::function<void(ImageStatistics*)>& set)
{
  RefusesImage(
    parts, [](vtkImageData*) {}, set);
}

double At(vtkTable* table, const char* column, vtkIdType row)
{
  return vtkDataArray::SafeDownCast(table->GetColumnByName(column))->GetTuple1(row);
}
}

TEST(ImageStatisticsEquality, Window)
{
  ExpectSameStatistics([](auto* f) { f->SetImagePairs("1 1; 1 2; m m"); }, false);
}

TEST(ImageStatisticsEquality, Periodic)
{
  ExpectSameStatistics(
    [](auto* f)
    {
      f->SetBoundary(ImageStatistics::PERIODIC);
      f->SetMaximumLag(3.25);
      f->SetNumberOfLags(5);
      f->SetChordLengths(false);
    },
    false);
}

TEST(ImageStatisticsEquality, Mask)
{
  ExpectSameStatistics([](auto* f) { f->SetImagePairs("2 m"); }, true);
}

TEST(ImageStatistics, CountsTheVoxelsOfLabels)
{
  vtkNew<ImageStatistics> filter;
  filter->SetController(nullptr);
  filter->SetInputData(Whole(Forms[0]));
  filter->Update();
  int balls = 0;
  for (int z = 0; z < Size[2]; ++z)
  {
    for (int y = 0; y < Size[1]; ++y)
    {
      for (int x = 0; x < Size[0]; ++x)
      {
        balls += LabelAt(x, y, z) == 7;
      }
    }
  }
  auto* phases = vtkTable::SafeDownCast(filter->GetOutputDataObject(ImageStatistics::PHASES));
  ASSERT_EQ(phases->GetNumberOfRows(), 3);
  EXPECT_EQ(At(phases, "Label", 0), 3);
  EXPECT_EQ(At(phases, "Label", 1), 7);
  EXPECT_EQ(At(phases, "Label", 2), 0);
  EXPECT_EQ(phases->GetValueByName(2, "Phase").ToString(), "m");
  EXPECT_EQ(At(phases, "VolumeFraction", 1), double(balls) / (Size[0] * Size[1] * Size[2]));
  auto* table = vtkTable::SafeDownCast(filter->GetOutputDataObject(0));
  EXPECT_EQ(At(table, "S_2_2", 0), At(phases, "VolumeFraction", 1));
  EXPECT_EQ(At(table, "S_1_2", 0), 0.0);
  EXPECT_EQ(table->GetNumberOfRows(), 4); // a quarter of 13 voxels
  EXPECT_EQ(At(table, "r", 3), 1.5);
  // Chords and lineal path begin with the fraction
  auto* chords = vtkTable::SafeDownCast(filter->GetOutputDataObject(ImageStatistics::CHORDS));
  EXPECT_EQ(At(chords, "L_2", 0), At(phases, "VolumeFraction", 1));
}

TEST(ImageStatistics, TakesTheBoundaryFromTheImage)
{
  const auto fields = [](vtkImageData* image, int x, int y, int z)
  {
    vtkNew<vtkIntArray> periodic;
    periodic->SetName("BoxPeriodic");
    for (int q : { x, y, z })
    {
      periodic->InsertNextValue(q);
    }
    image->GetFieldData()->AddArray(periodic);
  };
  const auto numbers = [](vtkImageData* image, int boundary)
  {
    vtkNew<ImageStatistics> filter;
    filter->SetController(nullptr);
    filter->SetBoundary(boundary);
    filter->SetInputData(image);
    filter->Update();
    auto* table = vtkTable::SafeDownCast(filter->GetOutputDataObject(0));
    std::vector<double> values;
    for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
    {
      values.push_back(At(table, "S_m_m", row));
    }
    return values;
  };
  const auto plain = Whole(Forms[0]), periodic = Whole(Forms[0]), partly = Whole(Forms[0]);
  fields(periodic, 1, 1, 1);
  fields(partly, 1, 0, 1);
  const auto ofWindow = numbers(plain, ImageStatistics::WINDOW);
  const auto ofPeriodic = numbers(plain, ImageStatistics::PERIODIC);
  EXPECT_EQ(numbers(plain, ImageStatistics::FROM_IMAGE), ofWindow);
  EXPECT_EQ(numbers(periodic, ImageStatistics::FROM_IMAGE), ofPeriodic);
  EXPECT_EQ(numbers(periodic, ImageStatistics::WINDOW), ofWindow);
  EXPECT_NE(ofWindow, ofPeriodic);
  const auto ofPart = numbers(partly, ImageStatistics::FROM_IMAGE);
  EXPECT_NE(ofPart, ofWindow);
  EXPECT_NE(ofPart, ofPeriodic);

  vtkNew<ImageStatistics> filter;
  const Warnings warnings(filter);
  filter->SetController(nullptr);
  filter->SetBoundary(ImageStatistics::PERIODIC);
  filter->SetInputData(partly);
  filter->Update();
  ASSERT_EQ(warnings.Texts.size(), 1u);
  ExpectParts(warnings.Texts[0], { "Image Statistics", "along y it is not" });
}

TEST(ImageStatistics, KeepsFewerSpectraInLessMemory)
{
  // The same numbers with a limit that just two spectra fit into
  const auto run = [](double limit, std::string& told)
  {
    vtkNew<ImageStatistics> filter;
    const Errors errors(filter);
    filter->SetController(nullptr);
    filter->SetMemoryLimit(limit);
    filter->SetInputData(Whole(Forms[0]));
    filter->Update();
    told = errors.Texts.empty() ? "" : errors.Texts[0];
    return Numbers(filter->GetOutputDataObject(0));
  };
  std::string told;
  const std::vector<double> expected = run(4000.0, told);
  EXPECT_EQ(told, "");
  run(1.0, told);
  ExpectParts(told, { "MemoryLimit requires at least", "MB on every rank", "got 1." });
  const std::string least = told.substr(told.find("least ") + 6);
  EXPECT_TRUE(Same(run(std::stod(least), told), expected));
  EXPECT_EQ(told, "");
}

TEST(ImageStatistics, TellsWhatARunTakes)
{
  vtkNew<ImageStatistics> filter;
  filter->SetController(nullptr);
  EXPECT_EQ(filter->GetEstimatedTime(), 0.0);
  filter->SetInputData(Whole(Forms[0]));
  EXPECT_GT(filter->GetEstimatedTime(), 0.0);
  const double memory = filter->GetEstimatedMemory();
  EXPECT_GT(memory, 0.0);
  EXPECT_STREQ(filter->GetAutomaticValues(), "Maximum Lag 1.5, Number Of Lags 3");
  filter->SetLabelsInInput(64);
  EXPECT_GT(filter->GetEstimatedMemory(), memory);
}

TEST(ImageStatistics, AStoppedRunHasNoResult)
{
  for (int event : { 0, 1, 4 })
  {
    vtkNew<ImageStatistics> filter;
    const Errors errors(filter);
    const StopAt stop(filter, event);
    filter->SetInputData(Piece(Forms[0], Cuts[1], LabelAt));
    filter->Update();
    if (Rank() == 0)
    {
      ExpectParts(stop.Texts.back(), { "counting pairs of voxels", "may be stopped" });
    }
    ExpectRefusal(filter, errors, { "were stopped before their end" });
  }
}

TEST(ImageStatisticsRefusals, Images)
{
  const auto nothing = [](ImageStatistics*) {};
  const auto keep = [](vtkImageData*) {};
  RefusesImage(
    { "Image Statistics: Input requires an image with an array of one component", "got none" },
    LeaveColours);
  RefusesImage({ "axes along x, y and z, got one with a direction matrix" }, TurnAxes);
  RefusesImage({ "requires an image with voxels, got none" },
    [](vtkImageData* image) { image->Initialize(); });
  RefusesImage({ "takes at most 64 labels; the array has 4420." }, keep, nothing,
    [](int x, int y, int z) { return x + Size[0] * (y + Size[1] * z); });
  RefusesImage({ "MatrixLabel requires a label of the image", "got 0 for an image with 5, 6." },
    keep, nothing, [](int x, int, int) { return 5 + x % 2; });
  RefusesImage({ "MatrixLabel requires", "got 0 for an image with 0." }, keep, nothing,
    [](int, int, int) { return 0; });
}

TEST(ImageStatisticsRefusals, ValuesThatAreNoLabels)
{
  for (double value :
    { 0.5, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    vtkNew<ImageStatistics> filter;
    const Errors errors(filter);
    // On one rank alone
    filter->SetInputData(Piece(Forms[1], Cuts[1],
      [&](int x, int y, int z)
      { return x == 3 && y == 4 && z == Size[2] - 1 ? value : LabelAt(x, y, z); }));
    ExpectRefusal(filter, errors, { "PhaseArray requires labels that are whole numbers, got" });
  }
}

TEST(ImageStatisticsRefusals, Settings)
{
  RefusesSettings({ "an array 'Grains'" }, [](auto* f) { f->SetPhaseArray("Grains"); });
  RefusesSettings({ "got 1 for an image with 0, 3, 7" }, [](auto* f) { f->SetMatrixLabel(1); });
  RefusesSettings(
    { "Boundary requires a value from 0 to 2, got 3" }, [](auto* f) { f->SetBoundary(3); });
  RefusesSettings(
    { "MaximumLag requires", "3.25, got 3.5" }, [](auto* f) { f->SetMaximumLag(3.5); });
  RefusesSettings({ "NumberOfLags requires", "one lag a voxel, 3, got 4" },
    [](auto* f) { f->SetNumberOfLags(4); });
  RefusesSettings({ "SaturationTolerance requires a number > 0, got 0" },
    [](auto* f) { f->SetSaturationTolerance(0.0); });
  RefusesSettings({ "ImagePairs requires pairs of phases, 1 to 2 or m", "3 3" },
    [](auto* f) { f->SetImagePairs("3 3"); });
  RefusesSettings({ "MemoryLimit requires at least" }, [](auto* f) { f->SetMemoryLimit(2.0); });
}

TEST(ImageStatisticsRefusals, Masks)
{
  const auto refuses = [](const std::vector<std::string>& parts, const Value& value, int size)
  {
    vtkNew<ImageStatistics> filter;
    const Errors errors(filter);
    filter->SetInputData(Piece(Forms[0], Cuts[1], LabelAt));
    filter->SetInputDataObject(1, MakeImage(Forms[0], 0, 0, Rank() == 0 ? size : 0, value));
    ExpectRefusal(filter, errors, parts);
  };
  refuses({ "Mask requires the voxels of the image, 17 x 13 x 20", "got 16 x 13 x 20" }, InsideAt,
    Size[0] - 1);
  refuses(
    { "voxels inside the mask, got none" }, [](int, int, int) { return 0.0; }, Size[0]);
  refuses({ "Mask requires an image with voxels, got none" }, InsideAt, 0);
}
