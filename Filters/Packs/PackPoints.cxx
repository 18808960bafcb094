// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PackPoints.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

std::vector<vtkIdType> PackPoints::Copy(vtkPointSet* input, const ruc::CheckedPiece& piece,
  bool crop, const std::function<bool(vtkIdType point)>& keep, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  // Rounded to float, the centres may be outside again
  points->SetDataType(piece.NumberMoved() > 0 ? VTK_DOUBLE : input->GetPoints()->GetDataType());
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkPointData> arrays; // without those that have no value for some points
  arrays->ShallowCopy(input->GetPointData());
  for (int n = arrays->GetNumberOfArrays() - 1; n >= 0; --n)
  {
    if (arrays->GetAbstractArray(n)->GetNumberOfTuples() < input->GetNumberOfPoints())
    {
      arrays->RemoveArray(n);
    }
  }
  output->GetPointData()->CopyAllOn();
  output->GetPointData()->CopyAllocate(arrays, input->GetNumberOfPoints());
  std::vector<vtkIdType> copied;
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    ruc::Vector3 centre;
    input->GetPoint(i, centre.data());
    ruc::MoveIntoBox(centre, piece.Observed());
    if (keep(i) && (!crop || piece.Observed().Contains(centre)))
    {
      const vtkIdType id = points->InsertNextPoint(centre.data());
      vertices->InsertNextCell(1, &id);
      output->GetPointData()->CopyData(arrays, i, id);
      copied.push_back(i);
    }
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
  return copied;
}
