// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Particles are the same however an image is spread over any number of ranks, and bad images are
// refused
#include "Equality.h"
#include "Refusals.h"
#include "Stops.h"
#include "VoxelImages.h"

#include "vtkRUCParticlesFromImage.h"

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <functional>
#include <limits>

using Particles = vtkRUCParticlesFromImage;

namespace
{
constexpr int Size[3] = { 41, 29, 36 };
constexpr double VoxelEdge = 0.5; // of a voxel
constexpr double Origin[3] = { 1.0, 2.0, 3.0 };

struct Sphere
{
  double X, Y, Z, Radius; // in voxels; the last two are cut
};
const Sphere Spheres[] = { { 10.2, 11.0, 10.1, 6.5 }, { 28.3, 12.1, 11.5, 5.2 },
  { 12.0, 14.9, 26.3, 7.0 }, { 19.8, 17.0, 13.0, 3.9 }, { 38.5, 14.0, 24.0, 6.0 },
  { 27.0, 20.0, 34.0, 6.8 } };
constexpr int NumberOfSpheres = 6;

double BlurredBall(const Sphere& ball, int x, int y, int z)
{
  constexpr double blur = 1.05;
  const double r = std::max(0.1, std::hypot(x + 0.5 - ball.X, y + 0.5 - ball.Y, z + 0.5 - ball.Z));
  const double t = (ball.Radius - r) / blur;
  return 0.5 * std::erfc(-t / std::sqrt(2.0)) -
    blur / r * std::exp(-0.5 * t * t) / std::sqrt(2.0 * 3.14159265358979324);
}

// Between 500 in the matrix and 900, with even noise of a deviation of a tenth of that
double GreyAt(int x, int y, int z)
{
  double value = 500.0;
  for (const Sphere& ball : Spheres)
  {
    value += 400.0 * BlurredBall(ball, x, y, z);
  }
  std::uint32_t hash = 73856093u * x ^ 19349663u * y ^ 83492791u * z;
  hash = (hash ^ (hash >> 15)) * 2246822519u;
  hash = (hash ^ (hash >> 13)) * 3266489917u;
  const double even = ((hash ^ (hash >> 16)) & 0xffff) / 65536.0 - 0.5;
  return std::rint(value + 40.0 * std::sqrt(12.0) * even);
}

double LabelAt(int x, int y, int z)
{
  for (int n = 0; n < NumberOfSpheres; ++n)
  {
    const Sphere& ball = Spheres[n];
    if (std::hypot(x + 0.5 - ball.X, y + 0.5 - ball.Y, z + 0.5 - ball.Z) < ball.Radius)
    {
      return 10.0 * (n + 1);
    }
  }
  return 0.0;
}

const Form Forms[] = { { "integers on cells", false, VTK_UNSIGNED_SHORT },
  { "floats on points", true, VTK_FLOAT } };

vtkSmartPointer<vtkImageData> MakeImage(
  const Form& form, int axis, int begin, int end, const Value& value, const char* name = "Grey")
{
  return VoxelImage{ { Size[0], Size[1], Size[2] }, VoxelEdge, name }.Make(
    form, axis, begin, end, value);
}

vtkSmartPointer<vtkImageData> Piece(
  const Form& form, int axis, const Value& value = GreyAt, const char* name = "Grey")
{
  const int ranks = NumberOfRanks(), n = Size[axis];
  return MakeImage(form, axis, n * Rank() / ranks, n * (Rank() + 1) / ranks, value, name);
}

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
  RefusesValues({ "Sphere Fit requires voxels of matrix, with the label 0, got none" }, slices,
    [](auto* f) { f->SetImageKind(Particles::LABELS); });
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
