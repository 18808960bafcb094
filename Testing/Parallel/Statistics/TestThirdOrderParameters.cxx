// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Third-order parameters are the same on any number of ranks; what is refused and what is told
#include "Equality.h"
#include "Refusals.h"

#include "vtkRUCThirdOrderParameters.h"

#include "vtkMultiProcessController.h"
#include "vtkTable.h"

#include <algorithm>
#include <array>

using ThirdOrder = vtkRUCThirdOrderParameters;

namespace
{
class ThirdOrderEquality : public EveryPack
{
};
INSTANTIATE_EVERY_PACK(ThirdOrderEquality);

// Spheres stay in the share of their rank: those of all ranks, in one order
using Sphere = std::array<double, 6>;
std::vector<Sphere> AllSpheres(vtkDataObject* data, bool onAllRanks)
{
  auto* spheres = vtkPolyData::SafeDownCast(data);
  std::vector<double> own;
  for (vtkIdType i = 0; i < spheres->GetNumberOfPoints(); ++i)
  {
    own.insert(own.end(), spheres->GetPoint(i), spheres->GetPoint(i) + 3);
    for (const char* name : { "Radius", "Mode", "FieldEnergy" })
    {
      const double value = spheres->GetPointData()->GetArray(name)->GetTuple1(i);
      own.push_back(std::isnan(value) ? -1.0 : value);
    }
  }
  std::vector<double> all = own;
  if (onAllRanks)
  {
    vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
    const vtkIdType size = static_cast<vtkIdType>(own.size());
    std::vector<vtkIdType> sizes(NumberOfRanks()), places(NumberOfRanks(), 0);
    controller->AllGather(&size, sizes.data(), 1);
    for (int rank = 1; rank < NumberOfRanks(); ++rank)
    {
      places[rank] = places[rank - 1] + sizes[rank - 1];
    }
    all.resize(places.back() + sizes.back());
    controller->AllGatherV(own.data(), all.data(), size, sizes.data(), places.data());
  }
  std::vector<Sphere> sorted(all.size() / 6);
  for (std::size_t n = 0; n < all.size(); ++n)
  {
    sorted[n / 6][n % 6] = all[n];
  }
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

void ExpectSameParameters(const std::function<void(ThirdOrder*)>& configure)
{
  vtkNew<ThirdOrder> alone;
  configure(alone);
  alone->SetController(nullptr);
  alone->SetInputData(EveryPack::Whole());
  alone->Update();
  for (const Spread& spread : Spreads())
  {
    SCOPED_TRACE(spread.Name);
    vtkNew<ThirdOrder> together;
    configure(together);
    together->SetInputData(
      MakePolyData(EveryPack::Pack(), Edge, EveryPack::IsPeriodic(), spread.IsMine));
    together->Update();
    for (int port = 0; port < alone->GetNumberOfOutputPorts(); ++port)
    {
      SCOPED_TRACE("output " + std::to_string(port));
      vtkDataObject* expected = alone->GetOutputDataObject(port);
      EXPECT_FALSE(IsEmpty(expected));
      if (port == ThirdOrder::PACK)
      {
        EXPECT_EQ(
          AllSpheres(together->GetOutputDataObject(port), true), AllSpheres(expected, false));
        continue;
      }
      ExpectSameOutput(together->GetOutputDataObject(port), expected);
    }
  }
}
}

TEST_P(ThirdOrderEquality, Spheres)
{
  ExpectSameParameters([](ThirdOrder* f) { f->SetCutOff(3.0); });
}

TEST_P(ThirdOrderEquality, Modes)
{
  ExpectSameParameters(
    [](ThirdOrder* f)
    {
      f->SetCutOff(2.6);
      f->SetPhases(ThirdOrder::MODES);
      f->SetMaximumDegree(6);
    });
}

TEST_P(ThirdOrderEquality, ZetaAlone)
{
  ExpectSameParameters(
    [](ThirdOrder* f)
    {
      f->SetCutOff(2.6);
      f->SetEta(false);
    });
}

TEST(ThirdOrderRefusals, SettingsOutOfRange)
{
  const std::string name = "Third-Order Parameters";
  RefusesSettings<ThirdOrder>(
    { name, "Phases requires a value from 0 to 1", "got 2" }, [](auto* f) { f->SetPhases(2); });
  RefusesSettings<ThirdOrder>(
    { name, "CutOff requires CutOff >= 0", "got -1" }, [](auto* f) { f->SetCutOff(-1.0); });
  RefusesSettings<ThirdOrder>(
    { name, "CutOff requires at least two diameters of the largest sphere, 2.4", "got 1" },
    [](auto* f) { f->SetCutOff(1.0); });
  for (int degree : { 3, 15 })
  {
    RefusesSettings<ThirdOrder>({ name, "MaximumDegree requires", "got " + std::to_string(degree) },
      [=](auto* f) { f->SetMaximumDegree(degree); });
  }
  RefusesSettings<ThirdOrder>(
    { name, "Blocks requires", "got 1." }, [](auto* f) { f->SetBlocks(1); });
  RefusesSettings<ThirdOrder>({ name, "Slabs requires", "got 0" }, [](auto* f) { f->SetSlabs(0); });
}

TEST(ThirdOrderRefusals, SpheresThatOverlap)
{
  RefusesPack<ThirdOrder>(
    { "Third-Order Parameters", "The third order requires spheres that overlap by at most 0.01 %" },
    [](ruc::SpherePack& pack)
    {
      for (double& radius : pack.Radius)
      {
        radius *= 1.05;
      }
    });
}

TEST(ThirdOrderRefusals, NoCentreWithin)
{
  const auto spoil = [](ruc::SpherePack& pack)
  {
    const ruc::SpherePack all = std::exchange(pack, {});
    for (std::size_t i = 0; i < all.Size(); ++i)
    {
      if (all.X[i] < 3.0)
      {
        pack.Append(all, i);
      }
    }
  };
  Refuses<ThirdOrder>({ "Third-Order Parameters", "from every face of the window, got none" },
    { spoil, {}, {} }, false, [](auto* f) { f->SetCutOff(4.0); });
}

TEST(ThirdOrderRefusals, FewCentresAreTold)
{
  vtkNew<ThirdOrder> filter;
  filter->SetInputData(MakePolyData(FewSizes(), Edge, false, IsMine));
  filter->SetCutOff(4.0);
  const Warnings warnings(filter);
  filter->Update();
  EXPECT_EQ(warnings.Texts.size(), Rank() == 0 ? 1u : 0u);
  for (const std::string& text : warnings.Texts)
  {
    ExpectParts(text, { "only ", "fewer than 100 centres" });
  }
}
