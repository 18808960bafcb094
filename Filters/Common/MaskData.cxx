// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MaskData.h"

#include "RankCommunicator.h"
#include "VoxelPiece.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

namespace
{
// The part of the mask that one rank has
struct Slab
{
  VoxelPiece Piece;
  std::vector<std::uint8_t> Inside; // 0 for voxels outside, x running fastest

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Piece, self.Inside);
  }
};

Slab LocalSlab(vtkImageData* image, const std::string& name, int label)
{
  Slab slab;
  slab.Piece = VoxelInput::Find(image, name, "Mask");
  slab.Inside.resize(slab.Piece.Block.Voxels());
  for (std::size_t v = 0; v < slab.Inside.size(); ++v)
  {
    const double value = slab.Piece.Values->GetTuple1(static_cast<vtkIdType>(v));
    slab.Inside[v] = label == 0 ? value != 0.0 && !std::isnan(value) : value == label;
  }
  return slab;
}

void CopyVoxels(const ruc::VoxelBlock& block, const std::vector<std::uint8_t>& own,
  const ruc::VoxelGrid& grid, std::vector<std::uint8_t>& inside)
{
  const std::uint8_t* source = own.data();
  for (int z = block.First[2]; z < block.First[2] + block.Count[2]; ++z)
  {
    for (int y = block.First[1]; y < block.First[1] + block.Count[1]; ++y)
    {
      const std::size_t place =
        (static_cast<std::size_t>(z) * grid.Dimensions[1] + y) * grid.Dimensions[0] +
        block.First[0];
      std::copy_n(source, block.Count[0], inside.begin() + place);
      source += block.Count[0];
    }
  }
}
}

ruc::VoxelMask MaskData::GatherMask(
  vtkImageData* image, const std::string& arrayName, int label, RankCommunicator& ranks)
{
  Slab own;
  ranks.Agree([&]() { own = LocalSlab(image, arrayName, label); });
  const std::vector<Slab> slabs = ranks.AllGather(std::exchange(own, {}));
  std::vector<VoxelPiece> pieces;
  for (const Slab& slab : slabs)
  {
    pieces.push_back(slab.Piece);
  }
  const ruc::VoxelGrid grid = VoxelInput::FindGrid(pieces);
  if (grid.Voxels() == 0.0)
  {
    throw std::invalid_argument("Mask requires an image with voxels, got none.");
  }
  std::vector<std::uint8_t> inside(
    static_cast<std::size_t>(grid.Dimensions[0]) * grid.Dimensions[1] * grid.Dimensions[2], 0);
  for (std::size_t rank = 0; rank < slabs.size(); ++rank)
  {
    CopyVoxels(pieces[rank].Block, slabs[rank].Inside, grid, inside);
  }
  return ruc::VoxelMask(grid.Dimensions, grid.Lower, grid.Spacing, std::move(inside));
}
