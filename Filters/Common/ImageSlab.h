// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCCommonModule.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"

#include <array>
#include <string>

class RankCommunicator;

/** Images of which every rank holds the part that ParaView expects of it. */
namespace ImageSlab RUCCOMMON_EXPORT
{
/** Returns the part of a whole extent that this rank has; an empty one where there are too many. */
std::array<int, 6> PieceOf(const std::array<int, 6>& whole, const RankCommunicator& ranks);

/**
 * Gives the image its extent on this rank, which is a part of the `whole` one, its spacing, and the
 * origin 0.
 */
void SetExtent(vtkImageData* image, const std::array<int, 6>& whole,
  const std::array<double, 3>& spacing, const RankCommunicator& ranks);

/**
 * Adds a point array with one number for every point, not yet set. The first array of an image
 * becomes its active scalars.
 */
vtkDoubleArray* NewArray(vtkImageData* image, const std::string& name);

/** Adds a point array of the numbers value(i, j, k). */
template <class Value>
void AddArray(vtkImageData* image, const std::string& name, Value&& value)
{
  vtkDoubleArray* values = NewArray(image, name);
  const int* extent = image->GetExtent();
  vtkIdType place = 0;
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      for (int i = extent[0]; i <= extent[1]; ++i)
      {
        values->SetValue(place++, value(i, j, k));
      }
    }
  }
}
}
