// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Effective properties are the same on any number of ranks; what is refused and what is told
#include "Equality.h"
#include "Refusals.h"
#include "Stops.h"

#include "vtkRUCEffectiveProperties.h"

#include "vtkCellData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

using Effective = vtkRUCEffectiveProperties;

namespace
{
class EffectiveEquality : public EveryPack
{
};
INSTANTIATE_EVERY_PACK(EffectiveEquality);

void MakeQuick(Effective* filter)
{
  filter->SetMethod(Effective::SOLVER);
  filter->SetResolution(12);
  filter->SetSecondResolution(0);
  filter->SetMaximumIterations(5);
}

const std::string Name = "Effective Properties";
void RefusesSetting(
  const std::vector<std::string>& parts, const std::function<void(Effective*)>& spoil)
{
  std::vector<std::string> all = parts;
  all.push_back(Name);
  RefusesSettings<Effective>(all, spoil, true, MakeQuick);
}
}

TEST_P(EffectiveEquality, Conductivity)
{
  ExpectSame<Effective>(
    [](Effective* f)
    {
      MakeQuick(f);
      f->SetSecondResolution(8);
      f->SetInterfaceRule(Effective::BOTH_RULES);
      f->SetFields(2);
    });
}

TEST_P(EffectiveEquality, Elasticity)
{
  ExpectSame<Effective>(
    [](Effective* f)
    {
      MakeQuick(f);
      f->SetProperty(Effective::ELASTICITY);
      f->SetMatrixExpansion(50.0);
      f->SetFields(4);
    });
}

TEST_P(EffectiveEquality, BoundsAlone)
{
  ExpectSame<Effective>(
    [](Effective* f)
    {
      MakeQuick(f);
      f->SetMethod(Effective::BOUNDS);
    },
    { Effective::CONVERGENCE });
}

TEST_P(EffectiveEquality, BoundsOfModes)
{
  ExpectSame<Effective>(
    [](Effective* f)
    {
      MakeQuick(f);
      f->SetMethod(Effective::BOUNDS);
      f->ClearModeConductivities();
      for (int mode = 0; mode < (EveryPack::HasFewSizes() ? 3 : 2); ++mode)
      {
        f->SetModeConductivity(mode, 2.0 + mode);
      }
    },
    { Effective::CONVERGENCE });
}

TEST_P(EffectiveEquality, Window)
{
  ExpectSame<Effective>(
    [](Effective* f)
    {
      MakeQuick(f);
      f->SetWindowOrigin(1.0, 2.0, 3.0);
      f->SetWindowSize(6.0, 7.0, 8.0);
      f->SetFields(1);
    });
}

// The solution lies between the bounds, and the image has the fraction of the pack
TEST(EffectiveProperties, AreWithinTheirBounds)
{
  vtkNew<Effective> filter;
  filter->SetController(nullptr);
  filter->SetInputData(MakePolyData(FewSizes(), Edge, true, [](std::size_t) { return true; }));
  filter->SetResolution(48);
  filter->SetSecondResolution(32);
  filter->Update();
  vtkTable* table = vtkTable::SafeDownCast(filter->GetOutputDataObject(Effective::PROPERTIES));
  ASSERT_EQ(table->GetNumberOfRows(), 7);
  EXPECT_EQ(table->GetValueByName(6, "Quantity").ToString(), "k");
  const auto value = [&](const char* name) { return table->GetValueByName(6, name).ToDouble(); };
  EXPECT_LT(value("Reuss"), value("HashinShtrikmanLower"));
  EXPECT_LT(value("HashinShtrikmanLower"), value("ThirdOrderLower"));
  EXPECT_LT(value("ThirdOrderLower"), value("Solver") + value("DiscretisationError"));
  EXPECT_LT(value("Solver") - value("DiscretisationError"), value("ThirdOrderUpper"));
  EXPECT_LT(value("ThirdOrderUpper"), value("HashinShtrikmanUpper"));
  EXPECT_LT(value("HashinShtrikmanUpper"), value("Voigt"));
  vtkImageData* image = vtkImageData::SafeDownCast(filter->GetOutputDataObject(Effective::FIELDS));
  vtkDataArray* fraction = image->GetCellData()->GetArray("VolumeFraction");
  double sum = 0.0;
  for (vtkIdType n = 0; n < fraction->GetNumberOfTuples(); ++n)
  {
    sum += fraction->GetTuple1(n);
  }
  EXPECT_NEAR(sum / static_cast<double>(fraction->GetNumberOfTuples()),
    image->GetFieldData()->GetArray("SolvedFraction")->GetTuple1(0), 1e-6);
}

TEST(EffectiveRefusals, SettingsOutOfRange)
{
  RefusesSetting({ "Property requires", "got 2" }, [](auto* f) { f->SetProperty(2); });
  RefusesSetting({ "Method requires", "got 3" }, [](auto* f) { f->SetMethod(3); });
  RefusesSetting({ "InterfaceRule requires", "got 5" }, [](auto* f) { f->SetInterfaceRule(5); });
  RefusesSetting({ "Boundary requires", "got -1" }, [](auto* f) { f->SetBoundary(-1); });
  RefusesSetting(
    { "Fields requires a value from 0 to 3", "got 4" }, [](auto* f) { f->SetFields(4); });
  RefusesSetting({ "Resolution requires", "got 1." }, [](auto* f) { f->SetResolution(1); });
  RefusesSetting({ "SecondResolution requires", "less than Resolution, 12", "got 12" },
    [](auto* f) { f->SetSecondResolution(12); });
  RefusesSetting({ "Tolerance requires", "got 0" }, [](auto* f) { f->SetTolerance(0.0); });
  RefusesSetting(
    { "MaximumIterations requires", "got 0" }, [](auto* f) { f->SetMaximumIterations(0); });
}

TEST(EffectiveRefusals, Materials)
{
  RefusesSetting({ "MatrixConductivity requires a finite number > 0", "got -1" },
    [](auto* f) { f->SetMatrixConductivity(-1.0); });
  RefusesSetting(
    { "ModeConductivities requires one number, or one for each of the 3 modes", "got 2" },
    [](auto* f) { f->SetModeConductivity(1, 5.0); });
  RefusesSetting({ "ModeConductivities requires", "got 1e+09" },
    [](auto* f) { f->SetModeConductivity(0, 1e9); });
  const auto elastic = [](const std::function<void(Effective*)>& spoil)
  {
    return [=](Effective* f)
    {
      f->SetProperty(Effective::ELASTICITY);
      spoil(f);
    };
  };
  RefusesSetting(
    { "MatrixModulus requires", "got 0" }, elastic([](Effective* f) { f->SetMatrixModulus(0.0); }));
  RefusesSetting({ "MatrixPoissonRatio requires numbers > -1 and < 0.5", "got 0.5" },
    elastic([](Effective* f) { f->SetMatrixPoissonRatio(0.5); }));
  RefusesSetting({ "SphereExpansion requires spheres of one material", "got 3" },
    elastic(
      [](Effective* f)
      {
        f->SetModeModulus(0, 1.0);
        f->SetModeModulus(1, 2.0);
        f->SetModeModulus(2, 3.0);
        f->SetSphereExpansion(1.0);
      }));
}

TEST(EffectiveRefusals, Windows)
{
  RefusesSettings<Effective>(
    { Name, "Boundary Periodic requires a box that is periodic" },
    [](auto* f) { f->SetBoundary(Effective::PERIODIC); }, false, MakeQuick);
  RefusesSettings<Effective>(
    { Name, "WindowOrigin and WindowSize requires a box within" },
    [](auto* f) { f->SetWindowSize(5.0, 5.0, 5.0); }, false, MakeQuick);
  RefusesSettings<Effective>(
    { Name, "WindowSize requires three edges > 0", "got 1 0 1" },
    [](auto* f) { f->SetWindowSize(1.0, 0.0, 1.0); }, true, MakeQuick);
}

TEST(EffectiveRefusals, MemoryAboveTheLimit)
{
  RefusesSettings<Effective>(
    { Name, "MemoryLimit" },
    [](auto* f)
    {
      f->SetResolution(1000);
      f->SetMemoryLimit(1000.0);
    },
    true, MakeQuick);
}

TEST(EffectiveRefusals, WhatIsNotSolvedIsTold)
{
  vtkNew<Effective> filter;
  MakeQuick(filter);
  filter->SetMaximumIterations(1);
  filter->SetInputData(MakePolyData(FewSizes(), Edge, true, IsMine));
  const Warnings warnings(filter);
  filter->Update();
  EXPECT_EQ(warnings.Texts.size(), Rank() == 0 ? 2u : 0u);
  if (Rank() == 0)
  {
    ExpectParts(warnings.Texts[0], { "the smallest radius, 0.4, has 0.4 voxels" });
    ExpectParts(warnings.Texts[1], { "not solved to the Tolerance", "in 1 iterations" });
  }
}

// The bounds are whole, and what was solved lies above what it would have been
TEST(EffectiveProperties, KeepWhatTheyHaveWhereStopped)
{
  const auto run = [](bool stopped)
  {
    auto filter = vtkSmartPointer<Effective>::New();
    filter->SetResolution(24);
    filter->SetSecondResolution(16);
    filter->SetInputData(MakePolyData(FewSizes(), Edge, true, IsMine));
    const Warnings warnings(filter);
    if (stopped)
    {
      const StopAt stop(filter, 3);
      filter->Update();
      filter->RemoveAllObservers();
      return filter;
    }
    filter->Update();
    return filter;
  };
  const auto whole = run(false), part = run(true);
  if (Rank() > 0)
  {
    return;
  }
  const auto table = [](Effective* filter)
  { return vtkTable::SafeDownCast(filter->GetOutputDataObject(Effective::PROPERTIES)); };
  vtkFieldData* fields = part->GetOutputDataObject(Effective::PROPERTIES)->GetFieldData();
  EXPECT_EQ(fields->GetAbstractArray("EndedBy")->GetVariantValue(0).ToString(), "Stopped");
  ASSERT_EQ(table(part)->GetNumberOfRows(), 7);
  EXPECT_EQ(table(part)->GetValueByName(6, "ThirdOrderUpper").ToDouble(),
    table(whole)->GetValueByName(6, "ThirdOrderUpper").ToDouble());
  EXPECT_GT(table(part)->GetValueByName(6, "Solver").ToDouble(),
    table(whole)->GetValueByName(6, "Solver").ToDouble());
}
