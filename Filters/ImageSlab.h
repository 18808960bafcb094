// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <array>
#include <string>

class RankCommunicator;

/** The part of an image that ParaView expects of a rank. */
class ImageSlab
{
public:
  /** Gives the image its extent on this rank, of the `whole` one, its spacing and the origin 0. */
  ImageSlab(vtkImageData* image, const std::array<int, 6>& whole,
    const std::array<double, 3>& spacing, const RankCommunicator& ranks);

  /** Adds a point array; value(i, j, k) are its numbers. The first becomes the active scalars. */
  template <class Value>
  void AddArray(const std::string& name, Value&& value);

private:
  vtkDoubleArray* NewArray(const std::string& name);

  vtkImageData* Image;
};

template <class Value>
void ImageSlab::AddArray(const std::string& name, Value&& value)
{
  vtkDoubleArray* values = this->NewArray(name);
  const int* extent = this->Image->GetExtent();
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
