// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/** @file Images that are spread over the ranks, and what spoils them. */

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <array>
#include <functional>

/** How an image has its values: on points or cells, and of which type of VTK. */
struct Form
{
  const char* Name;
  bool OnPoints;
  int DataType;
};

/** The value of a voxel. */
using Value = std::function<double(int x, int y, int z)>;

/** An image of cubes, with its lower corner, or first point, at (1, 2, 3). */
struct VoxelImage
{
  std::array<int, 3> Size;
  double Edge = 0.5; // of a voxel
  const char* Array;

  /** Makes the voxels from `begin` to `end` along an axis; of points, pieces share none. */
  vtkSmartPointer<vtkImageData> Make(
    const Form& form, int axis, int begin, int end, const Value& value) const
  {
    const auto image = vtkSmartPointer<vtkImageData>::New();
    std::array<int, 3> first{}, count = this->Size;
    first[axis] = begin;
    count[axis] = end - begin;
    if (count[axis] <= 0)
    {
      return image;
    }
    int extent[6];
    for (int q = 0; q < 3; ++q)
    {
      extent[2 * q] = first[q];
      extent[2 * q + 1] = first[q] + count[q] - (form.OnPoints ? 1 : 0);
    }
    image->SetExtent(extent);
    image->SetSpacing(this->Edge, this->Edge, this->Edge);
    image->SetOrigin(1.0, 2.0, 3.0);
    vtkSmartPointer<vtkDataArray> values;
    values.TakeReference(vtkDataArray::CreateDataArray(form.DataType));
    values->SetName(this->Array);
    for (int z = first[2]; z < first[2] + count[2]; ++z)
    {
      for (int y = first[1]; y < first[1] + count[1]; ++y)
      {
        for (int x = first[0]; x < first[0] + count[0]; ++x)
        {
          values->InsertNextTuple1(value(x, y, z));
        }
      }
    }
    image->GetAttributes(form.OnPoints ? vtkDataObject::POINT : vtkDataObject::CELL)
      ->AddArray(values);
    return image;
  }
};

/** Leaves an image colours alone, an array of three components. */
inline void LeaveColours(vtkImageData* image)
{
  image->GetCellData()->Initialize();
  vtkNew<vtkFloatArray> colours;
  colours->SetName("Colour");
  colours->SetNumberOfComponents(3);
  colours->SetNumberOfTuples(image->GetNumberOfCells());
  colours->Fill(1);
  image->GetCellData()->AddArray(colours);
}

/** Turns the axes of an image about z. */
inline void TurnAxes(vtkImageData* image)
{
  vtkNew<vtkMatrix3x3> turned;
  turned->SetElement(0, 0, 0.0);
  turned->SetElement(0, 1, 1.0);
  turned->SetElement(1, 0, -1.0);
  turned->SetElement(1, 1, 0.0);
  image->SetDirectionMatrix(turned);
}
