// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MaskData.h"

#include "RankCommunicator.h"
#include "VoxelPiece.h"
#include "ruc/Images/PhaseSlab.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"

#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace
{
std::vector<std::uint8_t> FindInside(const VoxelPiece& piece, int label)
{
  std::vector<std::uint8_t> inside(piece.Block.Voxels());
  for (std::size_t v = 0; v < inside.size(); ++v)
  {
    const double value = piece.Values->GetTuple1(static_cast<vtkIdType>(v));
    inside[v] = label == 0 ? value != 0.0 && !std::isnan(value) : value == label;
  }
  return inside;
}
}

MaskData::Mask MaskData::SpreadMask(
  vtkImageData* image, const std::string& arrayName, int label, RankCommunicator& ranks)
{
  VoxelPiece piece;
  ranks.Agree([&]() { piece = VoxelInput::Find(image, arrayName, "Mask"); });
  std::vector<VoxelPiece> pieces = ranks.AllGather(piece);
  Mask mask;
  mask.Grid = VoxelInput::FindGrid(pieces);
  if (mask.Grid.Voxels() == 0.0)
  {
    throw std::invalid_argument("Mask requires an image with voxels, got none.");
  }
  ruc::PhaseSlab slab = ruc::SpreadPhases(
    { pieces[ranks.Rank()].Block, FindInside(piece, label) }, mask.Grid.Dimensions, 2, ranks);
  mask.Inside = { slab.Dimensions, slab.Begin(), slab.End(), std::move(slab.Phases) };
  return mask;
}
