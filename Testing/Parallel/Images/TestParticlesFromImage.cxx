// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Particles are the same however an image is spread over any number of ranks
#include "Equality.h"
#include "Refusals.h"
#include "Stops.h"
#include "ParticleImages.h"

#include "vtkRUCParticlesFromImage.h"

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

using namespace ParticleImages;

namespace
{
vtkSmartPointer<Particles> Alone(
  vtkImageData* image, const std::function<void(Particles*)>& configure = [](Particles*) {})
{
  const auto filter = vtkSmartPointer<Particles>::New();
  filter->SetController(nullptr);
  configure(filter);
  filter->SetInputData(image);
  filter->Update();
  return filter;
}

vtkPolyData* PackOf(vtkAlgorithm* filter)
{
  return vtkPolyData::SafeDownCast(filter->GetOutputDataObject(Particles::PACK));
}

double At(vtkPolyData* pack, const char* name, vtkIdType n)
{
  return pack->GetPointData()->GetArray(name)->GetTuple1(n);
}

double FieldOf(vtkDataObject* data, const char* name)
{
  return data->GetFieldData()->GetArray(name)->GetTuple1(0);
}

// Expects that the pack has the spheres of the image, to so many voxels
void ExpectSpheres(vtkPolyData* pack, double tolerance, double shift)
{
  ASSERT_EQ(pack->GetNumberOfPoints(), NumberOfSpheres);
  for (const Sphere& ball : Spheres)
  {
    double least = 1e9, radius = 0.0;
    for (vtkIdType n = 0; n < pack->GetNumberOfPoints(); ++n)
    {
      const double* p = pack->GetPoint(n);
      const double away = std::hypot((p[0] - Origin[0]) / VoxelEdge + shift - ball.X,
        (p[1] - Origin[1]) / VoxelEdge + shift - ball.Y,
        (p[2] - Origin[2]) / VoxelEdge + shift - ball.Z);
      radius = away < least ? At(pack, "Radius", n) / VoxelEdge : radius;
      least = std::min(least, away);
    }
    EXPECT_LT(least, tolerance) << ball.X;
    EXPECT_NEAR(radius, ball.Radius, tolerance) << ball.X;
  }
}

void ExpectSameParticles(
  const std::function<void(Particles*)>& configure, const Value& value = GreyAt)
{
  for (const Form& form : Forms)
  {
    const auto alone = Alone(MakeImage(form, 0, 0, Size[0], value), configure);
    for (int axis : { 0, 2 })
    {
      SCOPED_TRACE(std::string(form.Name) + " across " + "xyz"[axis]);
      vtkNew<Particles> together;
      configure(together);
      together->SetInputData(Piece(form, axis, value));
      together->Update();
      for (int port = 0; port < together->GetNumberOfOutputPorts(); ++port)
      {
        SCOPED_TRACE("output " + std::to_string(port));
        ExpectSameOutput(together->GetOutputDataObject(port), alone->GetOutputDataObject(port));
      }
    }
  }
}
}

TEST(ParticlesFromImageEquality, Grey)
{
  ExpectSameParticles([](auto* f) { f->SetResidual(true); });
}

TEST(ParticlesFromImageEquality, DarkAndWhole)
{
  ExpectSameParticles(
    [](auto* f)
    {
      f->SetParticlesAre(Particles::DARK);
      f->SetBorderParticles(Particles::WHOLE_ONLY);
      f->SetSmoothing(2);
      f->SetResidual(true);
    },
    [](int x, int y, int z) { return 2000.0 - GreyAt(x, y, z); });
}

TEST(ParticlesFromImageEquality, Binary)
{
  ExpectSameParticles([](auto* f) { f->SetImageKind(Particles::BINARY); },
    [](int x, int y, int z) { return LabelAt(x, y, z) > 0.0; });
}

TEST(ParticlesFromImageEquality, Labels)
{
  ExpectSameParticles([](auto* f) { f->SetImageKind(Particles::LABELS); }, LabelAt);
}

TEST(ParticlesFromImageEquality, Watershed)
{
  ExpectSameParticles([](auto* f) { f->SetMethod(Particles::WATERSHED); });
  ExpectSameParticles(
    [](auto* f)
    {
      f->SetMethod(Particles::WATERSHED);
      f->SetParticlesAre(Particles::DARK);
      f->SetBorderParticles(Particles::WHOLE_ONLY);
      f->SetSmoothing(1);
    },
    [](int x, int y, int z) { return 2000.0 - GreyAt(x, y, z); });
}

TEST(ParticlesFromImage, FindsTheSpheresOfEveryKind)
{
  const Form& form = Forms[0];
  const auto whole = [&](const Value& value, const char* name = "Grey")
  { return MakeImage(form, 0, 0, Size[0], value, name); };
  // Standard errors of centres are some 0.02 voxels, more where spheres are cut
  const auto grey = Alone(whole(GreyAt));
  ExpectSpheres(PackOf(grey), 0.12, 0.0);
  EXPECT_NEAR(FieldOf(PackOf(grey), "MatrixValue"), 500.0, 4.0);
  EXPECT_NEAR(FieldOf(PackOf(grey), "ParticleValue"), 900.0, 6.0);
  EXPECT_NEAR(FieldOf(PackOf(grey), "Noise"), 0.1, 0.01);
  EXPECT_NEAR(FieldOf(PackOf(grey), "Blur"), 1.05 * VoxelEdge, 0.03 * VoxelEdge);
  const auto dark = Alone(whole([](int x, int y, int z) { return 2000.0 - GreyAt(x, y, z); }),
    [](auto* f) { f->SetParticlesAre(Particles::DARK); });
  ExpectSpheres(PackOf(dark), 0.12, 0.0);
  EXPECT_NEAR(FieldOf(PackOf(dark), "MatrixValue"), 1500.0, 4.0);
  EXPECT_NEAR(FieldOf(PackOf(dark), "ParticleValue"), 1100.0, 6.0);
  // Two values, and labels by the name of the array, are known as what they are
  const auto binary = Alone(whole([](int x, int y, int z) { return LabelAt(x, y, z) > 0.0; }));
  ExpectSpheres(PackOf(binary), 0.2, 0.0);
  const auto labels = Alone(whole(LabelAt, "ParticleId"));
  ExpectSpheres(PackOf(labels), 0.2, 0.0);
  for (int n = 0; n < NumberOfSpheres; ++n)
  {
    EXPECT_EQ(At(PackOf(labels), "Id", n), 10.0 * (n + 1));
  }
  // A point is the centre of its voxel
  ExpectSpheres(PackOf(Alone(MakeImage(Forms[1], 0, 0, Size[0], GreyAt))), 0.12, 0.5);
}

TEST(ParticlesFromImage, TellsOfEveryParticle)
{
  const auto filter =
    Alone(MakeImage(Forms[0], 0, 0, Size[0], GreyAt), [](auto* f) { f->SetResidual(true); });
  vtkPolyData* pack = PackOf(filter);
  auto* image = vtkImageData::SafeDownCast(filter->GetOutputDataObject(Particles::IDS));
  vtkDataArray* ids = image->GetCellData()->GetArray("ParticleId");
  ASSERT_EQ(ids->GetNumberOfTuples(), Size[0] * Size[1] * Size[2]);
  int cut = 0;
  for (vtkIdType n = 0; n < pack->GetNumberOfPoints(); ++n)
  {
    const double radius = At(pack, "Radius", n);
    EXPECT_EQ(At(pack, "Id", n), n + 1);
    EXPECT_NEAR(At(pack, "Contrast", n), 1.0, 0.02);
    EXPECT_NEAR(At(pack, "FitResidual", n), 0.1, 0.01);
    EXPECT_GT(At(pack, "RadiusError", n), 0.0);
    EXPECT_LT(At(pack, "RadiusError", n), 0.05 * VoxelEdge);
    EXPECT_LT(At(pack, "CenterError", n), 0.08 * VoxelEdge);
    EXPECT_LT(At(pack, "OverlapDepth", n), 0.1 * VoxelEdge);
    const bool whole = At(pack, "BorderFaces", n) == 0.0;
    cut += whole ? 0 : 1;
    EXPECT_NEAR(At(pack, "EqualVolumeRadius", n), radius, (whole ? 0.15 : 2.0) * VoxelEdge);
    double centre[3];
    pack->GetPoint(n, centre);
    int subId = 0;
    double inCell[3], weights[8];
    EXPECT_EQ(
      ids->GetTuple1(image->FindCell(centre, nullptr, 0, 0.0, subId, inCell, weights)), n + 1);
  }
  EXPECT_EQ(cut, 2);
  // What is left is noise
  auto* left = vtkImageData::SafeDownCast(filter->GetOutputDataObject(Particles::RESIDUAL));
  vtkDataArray* residual = left->GetCellData()->GetArray("Residual");
  double square = 0.0;
  for (vtkIdType n = 0; n < residual->GetNumberOfTuples(); ++n)
  {
    square += residual->GetTuple1(n) * residual->GetTuple1(n);
  }
  EXPECT_NEAR(std::sqrt(square / residual->GetNumberOfTuples()), 40.0, 1.5);
}

TEST(ParticlesFromImage, CutsParticlesOfAnyShape)
{
  const auto filter = Alone(MakeImage(Forms[0], 0, 0, Size[0], GreyAt),
    [](auto* f)
    {
      f->SetMethod(Particles::WATERSHED);
      f->SetResidual(true); // which a watershed leaves none of
    });
  vtkPolyData* pack = PackOf(filter);
  auto* image = vtkImageData::SafeDownCast(filter->GetOutputDataObject(Particles::IDS));
  vtkDataArray* ids = image->GetCellData()->GetArray("ParticleId");
  ASSERT_EQ(ids->GetNumberOfTuples(), Size[0] * Size[1] * Size[2]);
  ASSERT_EQ(pack->GetNumberOfPoints(), NumberOfSpheres);
  std::vector<int> voxels(NumberOfSpheres + 1, 0);
  for (vtkIdType n = 0; n < ids->GetNumberOfTuples(); ++n)
  {
    const int id = static_cast<int>(ids->GetTuple1(n));
    ++voxels[std::max(id, 0)];
  }
  int cut = 0;
  for (int n = 0; n < NumberOfSpheres; ++n)
  {
    EXPECT_EQ(At(pack, "Id", n), n + 1);
    const double radius = At(pack, "Radius", n);
    EXPECT_EQ(At(pack, "EqualVolumeRadius", n), radius);
    EXPECT_NEAR(4.0 / 3.0 * 3.14159265358979324 * std::pow(radius / VoxelEdge, 3), voxels[n + 1],
      1e-6 * voxels[n + 1]);
    EXPECT_GT(At(pack, "Sphericity", n), 0.8);
    cut += At(pack, "BorderFaces", n) > 0.0 ? 1 : 0;
    double least = 1e9;
    for (const Sphere& ball : Spheres)
    {
      const double* p = pack->GetPoint(n);
      least = std::min(least,
        std::hypot((p[0] - Origin[0]) / VoxelEdge - ball.X, (p[1] - Origin[1]) / VoxelEdge - ball.Y,
          (p[2] - Origin[2]) / VoxelEdge - ball.Z));
    }
    EXPECT_LT(least, At(pack, "BorderFaces", n) > 0.0 ? 3.0 : 0.5);
  }
  EXPECT_EQ(cut, 2);
  for (const char* name :
    { "Contrast", "FitResidual", "CenterError", "RadiusError", "OverlapDepth" })
  {
    EXPECT_EQ(pack->GetPointData()->GetArray(name), nullptr) << name;
  }
  EXPECT_EQ(pack->GetFieldData()->GetArray("Blur"), nullptr);
  EXPECT_EQ(filter->GetOutputDataObject(Particles::RESIDUAL)
              ->GetAttributes(vtkDataObject::CELL)
              ->GetNumberOfArrays(),
    0);
  // All in one piece where the neck between two is never deep enough
  const auto joined = Alone(
    MakeImage(Forms[1], 0, 0, Size[0],
      [](int x, int y, int z) {
        return BlurredBall({ 12, 14, 18, 7 }, x, y, z) + BlurredBall({ 24, 14, 18, 7 }, x, y, z);
      }),
    [](auto* f)
    {
      f->SetMethod(Particles::WATERSHED);
      f->SetMarkerHeight(6.0);
    });
  EXPECT_EQ(PackOf(joined)->GetNumberOfPoints(), 1);
  EXPECT_LT(At(PackOf(joined), "Sphericity", 0), 0.95);
  joined->SetMarkerHeight(0.5);
  joined->Update();
  EXPECT_EQ(PackOf(joined)->GetNumberOfPoints(), 2);
}

TEST(ParticlesFromImage, LabelsAreTakenAsTheyAre)
{
  // Without any matrix, as in a polycrystal: slices of 5 planes, the last one of a plane
  const auto slices = [](int, int, int z) { return 7.0 * (z / 5 + 1); };
  const auto take = [](Particles* f)
  {
    f->SetMethod(Particles::WATERSHED);
    f->SetImageKind(Particles::LABELS);
  };
  const auto filter = Alone(MakeImage(Forms[0], 0, 0, Size[0], slices), take);
  vtkPolyData* pack = PackOf(filter);
  ASSERT_EQ(pack->GetNumberOfPoints(), 8);
  for (int n = 0; n < 8; ++n)
  {
    EXPECT_EQ(At(pack, "Id", n), 7.0 * (n + 1));
    const double planes = n < 7 ? 5.0 : 1.0;
    EXPECT_NEAR(4.0 / 3.0 * 3.14159265358979324 * std::pow(At(pack, "Radius", n) / VoxelEdge, 3),
      planes * Size[0] * Size[1], 1e-6);
    EXPECT_EQ(At(pack, "BorderFaces", n), n == 0 || n == 7 ? 5.0 : 4.0);
    EXPECT_NEAR(pack->GetPoint(n)[2], Origin[2] + VoxelEdge * (5.0 * n + 0.5 * planes), 1e-9);
  }
  ExpectSameParticles(take, slices);
}

TEST(ParticlesFromImage, WholeSpheresHaveASmallerWindow)
{
  const auto filter = Alone(MakeImage(Forms[0], 0, 0, Size[0], GreyAt),
    [](auto* f) { f->SetBorderParticles(Particles::WHOLE_ONLY); });
  vtkPolyData* pack = PackOf(filter);
  EXPECT_EQ(pack->GetNumberOfPoints(), 4);
  EXPECT_NEAR(FieldOf(pack, "BoxOrigin"), Origin[0] + 7.0 * VoxelEdge, 0.1 * VoxelEdge);
  auto* dropped = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(Particles::DROPPED));
  int near = 0;
  for (vtkIdType n = 0; n < dropped->GetNumberOfPoints(); ++n)
  {
    near += dropped->GetPointData()->GetAbstractArray("ReasonText")->GetVariantValue(n) ==
      vtkVariant("near the border");
    EXPECT_GE(At(dropped, "Reason", n), 0.0);
  }
  EXPECT_EQ(near, 2);
}

TEST(ParticlesFromImage, WarnsOfSmallParticles)
{
  vtkNew<Particles> filter;
  const Warnings warnings(filter);
  filter->SetController(nullptr);
  filter->SetInputData(MakeImage(Forms[1], 0, 0, Size[0],
    [](int x, int y, int z) {
      return BlurredBall(Spheres[0], x, y, z) + BlurredBall({ 30, 10, 20, 2.2 }, x, y, z);
    }));
  filter->Update();
  ASSERT_EQ(warnings.Texts.size(), 1u);
  ExpectParts(warnings.Texts[0], { "1 of 2 particles have diameters below 5 voxels" });
}

TEST(ParticlesFromImage, TellsWhatARunTakes)
{
  vtkNew<Particles> filter;
  filter->SetController(nullptr);
  EXPECT_EQ(filter->GetEstimatedTime(), 0.0);
  filter->SetInputData(MakeImage(Forms[0], 0, 0, Size[0], GreyAt));
  EXPECT_GT(filter->GetEstimatedTime(), 0.0);
  EXPECT_NEAR(filter->GetEstimatedMemory(), 16e-6 * Size[0] * Size[1] * Size[2], 1e-9);
  EXPECT_STREQ(filter->GetAutomaticValues(), "Minimum Diameter 1.5");
  const vtkMTimeType before = filter->GetMTime();
  filter->SetVoxelsInInput(1000000000);
  EXPECT_EQ(filter->GetMTime(), before);
  EXPECT_NEAR(filter->GetEstimatedMemory(), 16000.0, 1e-6);
  EXPECT_GT(filter->GetEstimatedTime(), 10.0); // 800 s of one thread
}

// Where a run is stopped at each of its events, all ranks end it: with the spheres as they are so
// far, or without any where none are fitted yet. The next run goes to its end
TEST(ParticlesFromImage, StopsInEveryPhase)
{
  struct Case
  {
    int Method;
    std::vector<std::string> Phases;
  };
  const Case cases[] = {
    { Particles::SPHERE_FIT,
      { "finding the two phases", "looking for particles", "fitting spheres" } },
    { Particles::WATERSHED,
      { "finding the two phases", "finding distances", "flooding", "measuring particles" } }
  };
  for (const Case& of : cases)
  {
    int kept = 0;
    for (std::size_t event = 0; event <= of.Phases.size(); ++event)
    {
      SCOPED_TRACE(event);
      vtkNew<Particles> filter;
      const Errors errors(filter);
      const Warnings warnings(filter);
      const StopAt stop(filter, static_cast<int>(event));
      filter->SetMethod(of.Method);
      filter->SetInputData(Piece(Forms[0], 2));
      filter->Update();
      // As rank 0 knows
      int known[2] = { stop.Texts.size() <= event ? 1 : 0,
        static_cast<int>(PackOf(filter)->GetNumberOfPoints()) };
      vtkMultiProcessController::GetGlobalController()->Broadcast(known, 2, 0);
      const bool toEnd = known[0] != 0;
      const std::string phase = of.Phases[std::min(event, of.Phases.size() - 1)];
      if (Rank() == 0 && !toEnd)
      {
        ExpectParts(stop.Texts[event], { phase, "may be stopped" });
      }
      if (known[1] == 0)
      {
        EXPECT_FALSE(toEnd);
        ExpectParts(RefusalOf(PackOf(filter)), { "a stop before any was found" });
        continue;
      }
      ++kept;
      EXPECT_EQ(FieldOf(PackOf(filter), "Stopped"), toEnd ? 0.0 : 1.0);
      EXPECT_EQ(warnings.Texts.size(), Rank() == 0 && !toEnd ? 1u : 0u);
    }
    EXPECT_GE(kept, 1); // the fit stopped between two sweeps; the watershed that was not stopped
  }
}

// Where a run is stopped while it measures, the spheres are those of the whole run
TEST(ParticlesFromImage, AStopAfterTheFitKeepsTheSpheres)
{
  vtkNew<Particles> whole;
  const StopAt never(whole, -1);
  whole->SetInputData(Piece(Forms[0], 2));
  whole->Update();
  const auto first = std::find_if(never.Texts.begin(), never.Texts.end(),
    [](const std::string& text) { return text.find("measuring particles") != std::string::npos; });
  const int event = static_cast<int>(first - never.Texts.begin());
  if (Rank() == 0)
  {
    EXPECT_EQ(never.Texts.end() - first, 3);
  }
  for (int later = 0; later < 3; ++later)
  {
    SCOPED_TRACE(later);
    vtkNew<Particles> filter;
    filter->SetResidual(true);
    const Warnings warnings(filter);
    const StopAt stop(filter, event + later);
    filter->SetInputData(Piece(Forms[0], 2));
    filter->Update();
    for (int port : { Particles::IDS, Particles::RESIDUAL })
    {
      auto* image = vtkImageData::SafeDownCast(filter->GetOutputDataObject(port));
      EXPECT_EQ(image->GetCellData()->GetNumberOfArrays(), 0);
      EXPECT_EQ(image->GetPointData()->GetNumberOfArrays(), 0);
    }
    EXPECT_EQ(FieldOf(PackOf(filter), "Stopped"), 1.0);
    ASSERT_EQ(PackOf(filter)->GetNumberOfPoints(), PackOf(whole)->GetNumberOfPoints());
    for (vtkIdType n = 0; n < PackOf(filter)->GetNumberOfPoints(); ++n)
    {
      EXPECT_EQ(At(PackOf(filter), "Radius", n), At(PackOf(whole), "Radius", n));
      EXPECT_EQ(At(PackOf(filter), "BorderFaces", n), At(PackOf(whole), "BorderFaces", n));
      EXPECT_TRUE(std::isnan(At(PackOf(filter), "EqualVolumeRadius", n)));
      EXPECT_TRUE(std::isnan(At(PackOf(filter), "Sphericity", n)));
    }
    if (Rank() == 0)
    {
      ASSERT_EQ(warnings.Texts.size(), 1u);
      ExpectParts(warnings.Texts[0], { "before the particles were measured" });
    }
  }
}
