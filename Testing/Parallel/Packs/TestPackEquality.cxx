// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Modes, copies and tiles of a pack are the same on any number of ranks
#include "Equality.h"

#include "vtkRUCParticleModes.h"
#include "vtkRUCPeriodicReplicas.h"

using Modes = vtkRUCParticleModes;
using Replicas = vtkRUCPeriodicReplicas;

namespace
{
class PackEquality : public EveryPack
{
};
INSTANTIATE_EVERY_PACK(PackEquality);

class ReplicasEquality : public EveryPack
{
};
INSTANTIATE_TEST_SUITE_P(, ReplicasEquality,
  testing::Combine(testing::Bool(), testing::Values(true)),
  [](const auto& info) { return std::get<0>(info.param) ? "FewSizes" : "ManySizes"; });
}

TEST_P(PackEquality, ModesStayWithTheirSpheres)
{
  vtkNew<Modes> alone;
  alone->SetNumberOfModes(2);
  alone->SetController(nullptr);
  alone->SetInputData(this->Whole());
  alone->Update();
  for (const Spread& spread : Spreads())
  {
    SCOPED_TRACE(spread.Name);
    const auto piece = MakePolyData(this->Pack(), Edge, this->IsPeriodic(), spread.IsMine);
    vtkNew<Modes> modes;
    modes->SetNumberOfModes(2);
    modes->SetInputData(piece);
    modes->Update();
    EXPECT_EQ(vtkPolyData::SafeDownCast(modes->GetOutputDataObject(0))->GetNumberOfPoints(),
      piece->GetNumberOfPoints());
    if (Rank() == 0)
    {
      EXPECT_TRUE(
        Same(Numbers(modes->GetOutputDataObject(1)), Numbers(alone->GetOutputDataObject(1))))
        << "the table of modes";
    }
  }
}

TEST_P(ReplicasEquality, Copies)
{
  ExpectSame<Replicas>(
    [](auto* f)
    {
      f->SetClipToBox(true);
      f->SetSurfaceResolution(8);
    },
    {}, { 0, 2 });
}

TEST_P(ReplicasEquality, TilesWithoutTheirSurfaces)
{
  ExpectSame<Replicas>(
    [](auto* f)
    {
      f->SetMethod(Replicas::TILING);
      f->SetTiles(2, 1, 3);
    },
    { 2 }, { 0, 2 });
}
