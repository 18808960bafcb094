// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Samples, margins and masks that the sampling methods refuse
#include "Refusals.h"

#include "vtkRUCOnePointProbability.h"
#include "vtkRUCTwoPointProbability.h"

using OnePoint = vtkRUCOnePointProbability;
using TwoPoint = vtkRUCTwoPointProbability;

namespace
{
const std::string Name = "Two-Point Probability";

class SamplingRefusals : public testing::TestWithParam<int>
{
protected:
  void ExpectRefused(const std::vector<std::string>& parts,
    const std::function<void(TwoPoint*)>& spoil, bool periodic = true)
  {
    std::vector<std::string> all = parts;
    all.push_back(Name);
    RefusesSettings<TwoPoint>(
      all,
      [&](TwoPoint* f)
      {
        f->SetMethod(this->GetParam());
        spoil(f);
      },
      periodic);
  }

  void ExpectMaskRefused(const std::vector<std::string>& parts,
    const std::function<void(vtkImageData*)>& spoil, bool periodic = false)
  {
    this->ExpectRefused(
      parts,
      [&](TwoPoint* f)
      {
        const auto mask = MakeMask(Edge, Rank(), NumberOfRanks());
        spoil(mask);
        f->SetInputDataObject(1, mask);
      },
      periodic);
  }
};
}

TEST_P(SamplingRefusals, NoSamples)
{
  const std::string samples =
    this->GetParam() == TwoPoint::CHORD_SAMPLING ? "NumberOfLines" : "NumberOfThrows";
  this->ExpectRefused({ samples + " requires", "got 0" },
    [](TwoPoint* f)
    {
      f->SetNumberOfLines(0);
      f->SetNumberOfThrows(0);
    });
}

TEST_P(SamplingRefusals, TargetErrorOutOfRange)
{
  this->ExpectRefused(
    { "TargetError requires", "got -0.1" }, [](TwoPoint* f) { f->SetTargetError(-0.1); });
  this->ExpectRefused(
    { "TargetError requires", "got 1e-12" }, [](TwoPoint* f) { f->SetTargetError(1e-12); });
}

TEST_P(SamplingRefusals, Seed)
{
  this->ExpectRefused({ "Seed requires", "got -1" }, [](TwoPoint* f) { f->SetSeed(-1); });
}

TEST_P(SamplingRefusals, NoLags)
{
  this->ExpectRefused(
    { "NumberOfLags requires", "got 0" }, [](TwoPoint* f) { f->SetNumberOfLags(0); });
}

TEST_P(SamplingRefusals, MarginOutOfRange)
{
  this->ExpectRefused(
    { "WindowMargin requires", "got -2" }, [](TwoPoint* f) { f->SetWindowMargin(-2.0); }, false);
  this->ExpectRefused(
    { "margin of 6" }, [](TwoPoint* f) { f->SetWindowMargin(6.0); }, false);
}

TEST_P(SamplingRefusals, LagBeyondTheRegion)
{
  this->ExpectRefused(
    { "MaximumLag requires", "got 11.9" }, [](TwoPoint* f) { f->SetMaximumLag(11.9); }, false);
}

TEST_P(SamplingRefusals, EmptyMask)
{
  this->ExpectMaskRefused({ "ask requires at least one inside voxel" },
    [](vtkImageData* m) { m->GetPointData()->GetArray(0)->Fill(0.0); });
}

TEST_P(SamplingRefusals, MaskThatMissesThePack)
{
  this->ExpectMaskRefused({ "Mask requires at least one centre of the pack inside", "none of 600" },
    [](vtkImageData* m) { m->SetOrigin(100.0, 0.0, 0.0); });
}

TEST_P(SamplingRefusals, MaskThinnerThanTheMargin)
{
  this->ExpectMaskRefused(
    { "ask requires inside voxels" }, [](vtkImageData* m) { m->SetSpacing(0.5, 0.5, 0.04); });
}

TEST_P(SamplingRefusals, MaskWithoutAnArray)
{
  this->ExpectMaskRefused({ "Mask requires an image with an array" },
    [](vtkImageData* m) { m->GetPointData()->Initialize(); });
}

TEST_P(SamplingRefusals, MaskOfAPeriodicPack)
{
  this->ExpectMaskRefused(
    { "Mask requires a pack that is not periodic" }, [](vtkImageData*) {}, true);
}

INSTANTIATE_TEST_SUITE_P(, SamplingRefusals,
  testing::Values(int(TwoPoint::CHORD_SAMPLING), int(TwoPoint::TEMPLATE_SAMPLING)),
  [](const auto& info) { return info.param == TwoPoint::CHORD_SAMPLING ? "Chords" : "Template"; });

TEST(MethodRefusals, MaskAndTheExactSum)
{
  RefusesSettings<TwoPoint>(
    { Name, "Mask requires Method", "Exact Pair Sum" },
    [](TwoPoint* f) { f->SetInputDataObject(1, MakeMask(Edge, Rank(), NumberOfRanks())); }, false);
}

TEST(BlockRefusals, NumberOfBlocks)
{
  for (int blocks : { -1, 1, 7, 1001 })
  {
    RefusesSettings<vtkRUCTwoPointProbability>(
      { "Two-Point Probability", "Blocks requires 0 or a number from 8 to 1000" },
      [blocks](auto* f) { f->SetBlocks(blocks); });
  }
}

TEST(BlockRefusals, NoRoom)
{
  Refuses<vtkRUCTwoPointProbability>(
    { "Two-Point Probability", "Blocks requires a window with room for 8 blocks" },
    { [](ruc::SpherePack& pack)
      {
        ruc::SpherePack few;
        for (int i = 0; i < 600; ++i)
        {
          if (std::max({ pack.X[i], pack.Y[i], pack.Z[i] }) < 3.5)
          {
            few.Append(pack, i);
          }
        }
        pack = few;
        pack.Mode.assign(pack.Size(), 1);
      },
      {}, {}, 3.5 },
    false, [](auto* f) { f->SetBlocks(64); });
}

TEST(MethodRefusals, LinesOfOnePointProbability)
{
  RefusesSettings<OnePoint>({ "One-Point Probability", "NumberOfLines requires", "got -4" },
    [](OnePoint* f)
    {
      f->SetMethod(OnePoint::CHORD_SAMPLING);
      f->SetNumberOfLines(-4);
    });
}
