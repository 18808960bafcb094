// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// The input of a filter changes from time step to time step: its box, and whether there is a pack
#include "Equality.h"
#include "Refusals.h"

#include "vtkMatrix3x3.h"
#include "vtkRUCOnePointProbability.h"
#include "vtkRUCTwoPointProbability.h"

TEST(ChangingPacks, EveryTimeStepHasItsOwnBox)
{
  ruc::SpherePack large = FewSizes();
  for (auto* numbers : { &large.X, &large.Y, &large.Z, &large.Radius })
  {
    for (double& number : *numbers)
    {
      number *= 2.0;
    }
  }
  const auto small = MakePolyData(FewSizes(), Edge, true, IsMine);
  const auto twice = MakePolyData(large, 2.0 * Edge, true, IsMine);
  const auto resultOf = [](vtkRUCTwoPointProbability* filter, vtkPolyData* data)
  {
    filter->SetInputData(data);
    filter->SetNumberOfLags(20);
    filter->Update();
    return Numbers(filter->GetOutputDataObject(0));
  };
  vtkNew<vtkRUCTwoPointProbability> one, first, second;
  const Errors errors(one);
  const std::vector<double> expected = resultOf(first, small),
                            expectedTwice = resultOf(second, twice);
  EXPECT_TRUE(Same(resultOf(one, small), expected));
  EXPECT_TRUE(Same(resultOf(one, twice), expectedTwice));
  EXPECT_TRUE(errors.Texts.empty());
  vtkNew<vtkPolyData> empty; // a time step without spheres
  resultOf(one, empty);
  EXPECT_TRUE(IsEmpty(one));
  EXPECT_EQ(errors.Texts.size(), Rank() == 0 ? 1u : 0u);
  EXPECT_TRUE(Same(resultOf(one, small), expected));
}

TEST(ChangingPacks, AnImageWithTurnedAxesIsNoMask)
{
  vtkNew<vtkRUCOnePointProbability> filter;
  const Errors errors(filter);
  filter->SetInputData(MakePolyData(FewSizes(), Edge, false, IsMine));
  filter->SetMethod(vtkRUCOnePointProbability::CHORD_SAMPLING);
  const auto mask = MakeMask(Edge, Rank(), NumberOfRanks());
  mask->SetDirectionMatrix(0, 1, 0, -1, 0, 0, 0, 0, 1);
  filter->SetInputDataObject(1, mask);
  filter->Update();
  ExpectRefusal(filter, errors, { "Mask requires an image with axes along x, y and z" });
}
