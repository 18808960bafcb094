// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Bad images, and settings that do not fit, are refused on every rank
#include "ParticleImages.h"
#include "Refusals.h"

#include <functional>
#include <limits>
#include <string>
#include <vector>

using namespace ParticleImages;

namespace
{
// Expects that a good image is taken, and one that is spoiled, or with other settings, is not
void Refuses(
  const std::vector<std::string>& parts, const std::function<void(vtkImageData*)>& spoil,
  const std::function<void(Particles*)>& set = [](Particles*) {}, const Value& value = GreyAt)
{
  vtkNew<Particles> filter;
  const Errors errors(filter);
  filter->SetInputData(Piece(Forms[0], 2));
  filter->Update();
  EXPECT_TRUE(errors.Texts.empty()) << "the good image is taken";
  const auto bad = Piece(Forms[0], 2, value);
  spoil(bad);
  set(filter);
  filter->SetInputData(bad);
  ExpectRefusal(filter, errors, parts);
}

void RefusesSettings(
  const std::vector<std::string>& parts, const std::function<void(Particles*)>& set)
{
  Refuses(
    parts, [](vtkImageData*) {}, set);
}

void RefusesValues(
  const std::vector<std::string>& parts, const Value& value,
  const std::function<void(Particles*)>& set = [](Particles*) {})
{
  Refuses(
    parts, [](vtkImageData*) {}, set, value);
}
}

TEST(ParticlesFromImageRefusals, Images)
{
  Refuses({ "Particles From Image: Input requires an image with an array of one component" },
    LeaveColours);
  Refuses({ "axes along x, y and z, got one with a direction matrix" }, TurnAxes);
  Refuses({ "requires an image with voxels, got none" },
    [](vtkImageData* image) { image->Initialize(); });
  Refuses({ "Input requires voxels whose edges differ by a tenth at most", "got 0.5 x 0.5 x 0.7" },
    [](vtkImageData* image) { image->SetSpacing(0.5, 0.5, 0.7); });
}

TEST(ParticlesFromImageRefusals, Values)
{
  RefusesValues({ "requires an image of two phases, got one grey only, 5." },
    [](int, int, int) { return 5.0; });
  RefusesValues({ "found no particle of a diameter of 3 voxels or more", "are particles dark?" },
    [](int x, int y, int z) { return x == 20 && y == 14 && z == 18 ? 9.0 : 1.0; });
  RefusesValues({ "A binary image requires two values, got more" }, GreyAt,
    [](auto* f) { f->SetImageKind(Particles::BINARY); });
  RefusesValues(
    { "ImageArray requires labels above 0, got none" }, [](int, int, int) { return 0.0; },
    [](auto* f) { f->SetImageKind(Particles::LABELS); });
  RefusesValues(
    { "Sphere Fit requires voxels of matrix, with the label 0, got none" },
    [](int, int, int z) { return 7.0 * (1 + z / 5); },
    [](auto* f) { f->SetImageKind(Particles::LABELS); });
  for (double value :
    { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    vtkNew<Particles> filter;
    const Errors errors(filter);
    // On one rank alone
    filter->SetInputData(Piece(Forms[1], 2,
      [&](int x, int y, int z)
      { return x < 3 && y == 4 && z == Size[2] - 1 ? value : GreyAt(x, y, z); }));
    ExpectRefusal(filter, errors, { "ImageArray requires finite values, got 3 that are not" });
  }
  vtkNew<Particles> filter;
  const Errors errors(filter);
  filter->SetImageKind(Particles::LABELS);
  filter->SetInputData(Piece(Forms[1], 2,
    [&](int x, int y, int z) { return x == 3 && y == 4 && z == 1 ? 0.5 : LabelAt(x, y, z); }));
  ExpectRefusal(filter, errors, { "ImageArray requires labels that are whole numbers", "got 0.5" });
}

TEST(ParticlesFromImageRefusals, Settings)
{
  RefusesSettings({ "an array 'Grains'" }, [](auto* f) { f->SetImageArray("Grains"); });
  RefusesSettings(
    { "ImageKind requires a value from 0 to 3, got 4" }, [](auto* f) { f->SetImageKind(4); });
  RefusesSettings({ "ParticlesAre requires a value from 0 to 1, got -1" },
    [](auto* f) { f->SetParticlesAre(-1); });
  RefusesSettings({ "BorderParticles requires a value from 0 to 1, got 2" },
    [](auto* f) { f->SetBorderParticles(2); });
  RefusesSettings(
    { "Smoothing requires a number from -1 to 10, got 11" }, [](auto* f) { f->SetSmoothing(11); });
  RefusesSettings({ "Threshold requires a value between those of the image", "got 5000" },
    [](auto* f) { f->SetThreshold(5000.0); });
  RefusesSettings({ "Threshold requires a finite number, got nan" },
    [](auto* f) { f->SetThreshold(std::numeric_limits<double>::quiet_NaN()); });
  RefusesSettings({ "MinimumDiameter requires a finite number >= 0, got -1" },
    [](auto* f) { f->SetMinimumDiameter(-1.0); });
  RefusesSettings({ "OverlapTolerance requires a number from 0 to 1, got 1.5" },
    [](auto* f) { f->SetOverlapTolerance(1.5); });
  RefusesSettings({ "ParticleValue requires a value above that of the matrix, 900, got 500" },
    [](auto* f)
    {
      f->SetMatrixValue(900.0);
      f->SetParticleValue(500.0);
    });
  RefusesSettings(
    { "Method requires a value from 0 to 1, got 2" }, [](auto* f) { f->SetMethod(2); });
  RefusesSettings({ "MarkerHeight requires a finite number > 0, got 0" },
    [](auto* f) { f->SetMarkerHeight(0.0); });
  for (int method : { Particles::SPHERE_FIT, Particles::WATERSHED })
  {
    RefusesSettings({ "MemoryLimit requires at least", "got 0.1" },
      [&](auto* f)
      {
        f->SetMethod(method);
        f->SetMemoryLimit(0.1);
      });
  }
}
