// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// The window of a pack that brings none, from the reader and from Points To Sphere Pack to a
// statistic, on any number of ranks the one that the core finds for the whole pack
#include "Refusals.h"

#include "../../Unit/EnclosedPacks.h"
#include "ruc/Particles/FoundWindow.h"

#include "vtkRUCOnePointProbability.h"
#include "vtkRUCParticleModes.h"
#include "vtkRUCPointsToSpherePack.h"
#include "vtkRUCSpherePackReader.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"

#include <cstdio>

namespace
{
const std::string SettledFile = RUC_TEST_DATA "/settled_cylinder.csv";

const ruc::SpherePack& Settled()
{
  static const ruc::SpherePack pack = oracle::ReadTable(SettledFile);
  return pack;
}

const ruc::FoundWindow& FoundAlone()
{
  static const ruc::FoundWindow found = []()
  {
    ruc::Communicator alone;
    return ruc::FindWindow(Settled(), std::nullopt, {}, alone);
  }();
  return found;
}

void Update(vtkAlgorithm* algorithm)
{
  algorithm->UpdateInformation();
  algorithm->UpdatePiece(Rank(), NumberOfRanks(), 0);
}

double Number(vtkDataObject* data, const char* name)
{
  vtkDataArray* field = data->GetFieldData()->GetArray(name);
  return field ? field->GetTuple1(0) : -1.0;
}

std::string Words(vtkDataObject* data, const char* name)
{
  vtkAbstractArray* field = data->GetFieldData()->GetAbstractArray(name);
  return field ? field->GetVariantValue(0).ToString() : "";
}

void ExpectFoundWindow(vtkDataObject* data)
{
  const ruc::Window& window = *FoundAlone().Observed;
  EXPECT_EQ(Words(data, "WindowSource"), "Eroded");
  EXPECT_EQ(Number(data, "CylinderRadius"), window.Radius);
  EXPECT_EQ(Number(data, "CylinderHeight"), window.Height);
  for (int q = 0; q < 3; ++q)
  {
    EXPECT_EQ(data->GetFieldData()->GetArray("CylinderBase")->GetComponent(0, q), window.Base[q]);
  }
}

// The fraction of all spheres of a pack, as the filters tell it
double FractionOf(vtkAlgorithmOutput* pack, vtkTable*& table,
  const std::function<void(vtkRUCOnePointProbability*)>& configure = {})
{
  static vtkSmartPointer<vtkRUCOnePointProbability> one;
  vtkNew<vtkRUCParticleModes> modes;
  modes->SetInputConnection(pack);
  modes->SetNumberOfModes(1);
  one = vtkSmartPointer<vtkRUCOnePointProbability>::New();
  one->SetInputConnection(modes->GetOutputPort());
  if (configure)
  {
    configure(one);
  }
  Update(one);
  table = vtkTable::SafeDownCast(one->GetOutputDataObject(0));
  return Rank() == 0
    ? vtkDataArray::SafeDownCast(table->GetColumnByName("VolumeFraction"))->GetTuple1(0)
    : 0.0;
}
}

TEST(FoundWindows, OfAFile)
{
  vtkNew<vtkRUCSpherePackReader> reader;
  const Warnings warnings(reader);
  reader->SetFileName(SettledFile.c_str());
  Update(reader);
  if (Rank() == 0)
  {
    // The pack stays whole
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 47000);
    ExpectFoundWindow(reader->GetOutput());
    EXPECT_EQ(Words(reader->GetOutput(), "FaceKinds"), "mantle=z; z-=wall; z+=loose");
    EXPECT_EQ(Number(reader->GetOutput(), "WindowErosion"), FoundAlone().Erosion);
    ExpectParts(reader->GetSummary(),
      { "cylinder window of radius", "by its faces (mantle=z; z-=wall; z+=loose)",
        "The window stays 1.61188 largest diameters away from faces that cut no pack.",
        "spheres outside it do not count." });
    EXPECT_EQ(warnings.Texts.size(), FoundAlone().Warnings.size());
  }
  vtkTable* table = nullptr;
  const double fraction = FractionOf(reader->GetOutputPort(), table);
  if (Rank() == 0)
  {
    ExpectFoundWindow(table);
    EXPECT_NEAR(fraction, oracle::FractionIn(Settled(), *FoundAlone().Observed), 1e-9);
  }
}

TEST(FoundWindows, AreOverruled)
{
  vtkNew<vtkRUCSpherePackReader> reader;
  const Warnings warnings(reader);
  const Errors errors(reader);
  reader->SetFileName(SettledFile.c_str());
  vtkTable* table = nullptr;
  // By the window of a filter, which may reach beyond the one that was found
  const ruc::Window wide = ruc::Window::MakeCylinder({ 0, 0, 20 }, { 0, 0, 1 }, 1000, 850);
  const double fraction = FractionOf(reader->GetOutputPort(), table,
    [&](vtkRUCOnePointProbability* one)
    {
      one->SetCylinderBase(0, 0, 20);
      one->SetCylinderRadius(1000);
      one->SetCylinderHeight(850);
      one->SetCropToWindow(true);
    });
  if (Rank() == 0)
  {
    EXPECT_EQ(Words(table, "WindowSource"), "Properties");
    EXPECT_NEAR(fraction, oracle::FractionIn(Settled(), wide), 1e-9);
  }
  reader->SetWindowErosion(2.0);
  reader->SetFaceKinds("mantle=z; z-=cut; z+=wall");
  Update(reader);
  if (Rank() == 0)
  {
    EXPECT_EQ(Words(reader->GetOutput(), "FaceKinds"), "mantle=z; z-=cut; z+=wall");
    EXPECT_EQ(Number(reader->GetOutput(), "WindowErosion"), 2.0);
  }
  reader->SetFaceKinds("");
  reader->SetWindowErosion(12.0);
  Update(reader);
  ASSERT_EQ(errors.Texts.size(), Rank() == 0 ? 1u : 0u);
  if (Rank() == 0)
  {
    ExpectParts(errors.Texts[0], { "WindowErosion requires that it leaves 500 spheres" });
  }
  reader->SetFindWindow(false);
  Update(reader);
  if (Rank() == 0)
  {
    EXPECT_EQ(Words(reader->GetOutput(), "WindowSource"), "");
    EXPECT_EQ(reader->GetOutput()->GetFieldData()->GetArray("CylinderRadius"), nullptr);
  }
}

TEST(FoundWindows, OfPointsThatLieOnAllRanks)
{
  ruc::SpherePack piece;
  for (std::size_t i = 0; i < Settled().Size(); ++i)
  {
    if (IsMine(i))
    {
      piece.Append(Settled(), i);
    }
  }
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> radius;
  radius->SetName("radius");
  for (std::size_t i = 0; i < piece.Size(); ++i)
  {
    places->InsertNextPoint(piece.X[i], piece.Y[i], piece.Z[i]);
    radius->InsertNextValue(piece.Radius[i]);
  }
  vtkNew<vtkPolyData> points;
  points->SetPoints(places);
  points->GetPointData()->AddArray(radius);
  vtkNew<vtkRUCPointsToSpherePack> pack;
  const Warnings warnings(pack);
  pack->SetInputData(points);
  vtkTable* table = nullptr;
  const double fraction = FractionOf(pack->GetOutputPort(), table);
  EXPECT_EQ(warnings.Texts.size(), Rank() == 0 ? FoundAlone().Warnings.size() : 0u);
  EXPECT_EQ(pack->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT),
    points->GetNumberOfPoints());
  if (Rank() == 0)
  {
    ExpectFoundWindow(table);
    ExpectFoundWindow(pack->GetOutputDataObject(0));
    EXPECT_NEAR(fraction, oracle::FractionIn(Settled(), *FoundAlone().Observed), 1e-9);
  }
  pack->SetFindWindow(false);
  FractionOf(pack->GetOutputPort(), table);
  if (Rank() == 0)
  {
    EXPECT_EQ(Words(table, "WindowSource"), "Bounds of the centres");
  }
}

TEST(FoundWindows, APeriodicBoxThatIsNone)
{
  if (Rank() != 0)
  {
    return;
  }
  const std::string name = "not_periodic_np" + std::to_string(NumberOfRanks()) + ".xyz";
  {
    std::ofstream file(name);
    const ruc::SpherePack block =
      oracle::TakeBlock(Settled(), { -200, -200, 200 }, { 200, 200, 600 }, oracle::Taken::ByCentre);
    file << block.Size() << "\nLattice=\"400 0 0 0 400 0 0 0 400\" Origin=\"-200 -200 200\" "
         << "Properties=pos:R:3:radius:R:1\n";
    for (std::size_t i = 0; i < block.Size(); ++i)
    {
      file << block.X[i] << ' ' << block.Y[i] << ' ' << block.Z[i] << ' ' << block.Radius[i]
           << '\n';
    }
  }
  vtkNew<vtkRUCSpherePackReader> reader;
  const Warnings warnings(reader);
  reader->SetController(nullptr); // rank 0 alone
  reader->SetFileName(name.c_str());
  reader->Update();
  std::remove(name.c_str());
  EXPECT_EQ(Words(reader->GetOutput(), "WindowSource"), "File");
  ASSERT_EQ(warnings.Texts.size(), 1u);
  ExpectParts(warnings.Texts[0], { "spheres overlap across the box: is it periodic?" });
}
