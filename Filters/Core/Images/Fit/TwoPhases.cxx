// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Images/Fit/TwoPhases.h"

#include "ruc/Base/Require.h"
#include "ruc/Base/Text.h"

namespace ruc
{
TwoPhases FindPhases(const VoxelSlab<float>& image, const PhaseSearch& search, Communicator& ranks)
{
  TwoPhases phases;
  phases.Levels = FindGreyLevels(image, ranks);
  const GreyLevels& levels = phases.Levels;
  phases.Binary = search.Binary.value_or(levels.TwoValues);
  Require(!phases.Binary || levels.TwoValues, "A binary image", "two values", "more");
  phases.Threshold = search.Threshold.value_or(levels.Threshold);
  Require(phases.Threshold >= levels.Low && phases.Threshold < levels.High, "Threshold",
    Text("a value between those of the image, from ", levels.Low, " to ", levels.High),
    phases.Threshold);
  phases.MatrixValue = search.MatrixValue.value_or(phases.Binary ? levels.Low : levels.Below);
  phases.Contrast =
    search.ParticleValue.value_or(phases.Binary ? levels.High : levels.Above) - phases.MatrixValue;
  Require(phases.Contrast > 0.0, "ParticleValue",
    Text("a value above that of the matrix, ", phases.MatrixValue),
    phases.MatrixValue + phases.Contrast);
  const double noise = phases.Binary ? 0.0 : levels.Noise / phases.Contrast;
  phases.Smoothing = search.Smoothing >= 0 ? search.Smoothing : SmoothingFor(noise);
  return phases;
}

VoxelSlab<float> Smoothed(VoxelSlab<float> image, int times, Communicator& ranks)
{
  SetHalo(image, times, ranks);
  for (int n = 0; n < times; ++n)
  {
    Smooth(image);
  }
  SetHalo(image, 0, ranks);
  return image;
}
}
