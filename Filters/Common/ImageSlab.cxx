// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageSlab.h"

#include "RankCommunicator.h"

#include "vtkExtentTranslator.h"
#include "vtkNew.h"
#include "vtkPointData.h"

std::array<int, 6> ImageSlab::PieceOf(
  const std::array<int, 6>& whole, const RankCommunicator& ranks)
{
  std::array<int, 6> of = whole, piece;
  vtkNew<vtkExtentTranslator> translator;
  translator->PieceToExtentThreadSafe(
    ranks.Rank(), ranks.Size(), 0, of.data(), piece.data(), vtkExtentTranslator::BLOCK_MODE, 0);
  return piece;
}

void ImageSlab::SetExtent(vtkImageData* image, const std::array<int, 6>& whole,
  const std::array<double, 3>& spacing, const RankCommunicator& ranks)
{
  std::array<int, 6> piece = PieceOf(whole, ranks);
  image->SetExtent(piece.data());
  image->SetOrigin(0.0, 0.0, 0.0);
  image->SetSpacing(spacing.data());
}

vtkDoubleArray* ImageSlab::NewArray(vtkImageData* image, const std::string& name)
{
  vtkNew<vtkDoubleArray> values;
  values->SetName(name.c_str());
  values->SetNumberOfValues(image->GetNumberOfPoints());
  vtkPointData* points = image->GetPointData();
  points->AddArray(values); // the image keeps it
  if (!points->GetScalars())
  {
    points->SetActiveScalars(name.c_str());
  }
  return values;
}
