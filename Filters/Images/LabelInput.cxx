// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LabelInput.h"

#include "RankCommunicator.h"
#include "ruc/Base/Require.h"
#include "ruc/Base/Text.h"
#include "ruc/Statistics/Voxels/ImageCorrelation.h"

#include "vtkAlgorithm.h"
#include "vtkArrayDispatch.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

namespace LabelInput
{
namespace
{
using ruc::Text;

// Beyond this number labels are no longer counted
constexpr std::size_t MostCounted = 1000000;

// Calls use(value) on the first `count` values of an array
template <class Use>
struct ForValues
{
  template <class Array>
  void operator()(Array* array, std::size_t count, Use& use) const
  {
    for (const auto value : vtk::DataArrayValueRange<1>(array, 0, static_cast<vtkIdType>(count)))
    {
      use(static_cast<double>(value));
    }
  }
};
template <class Use>
void ForEachValue(vtkDataArray* array, std::size_t count, Use&& use)
{
  const ForValues<Use> each;
  if (count == 0)
  {
    return;
  }
  if (!vtkArrayDispatch::Dispatch::Execute(array, each, count, use))
  {
    each(array, count, use);
  }
}

// Numbers labels in the order in which they come
class Numbering
{
public:
  int Find(double value)
  {
    if (value == this->LastValue)
    {
      return this->Last;
    }
    RequireWhole(value);
    auto place = this->Places.find(value);
    if (place == this->Places.end() && this->Places.size() < MostCounted)
    {
      place = this->Places.emplace(value, static_cast<int>(this->Places.size())).first;
    }
    this->LastValue = value;
    this->Last = place == this->Places.end() ? 0 : place->second;
    return this->Last;
  }

  std::vector<std::int64_t> Labels() const
  {
    std::vector<std::int64_t> labels(this->Places.size());
    for (const auto& [value, place] : this->Places)
    {
      labels[place] = static_cast<std::int64_t>(value);
    }
    return labels;
  }

private:
  static void RequireWhole(double value)
  {
    constexpr double mostExact = 9007199254740992.0; // 2^53
    if (!(std::abs(value) <= mostExact) || value != std::rint(value))
    {
      throw std::invalid_argument(
        Text("PhaseArray requires labels that are whole numbers, got ", value, "."));
    }
  }

  std::map<double, int> Places;
  double LastValue = std::numeric_limits<double>::quiet_NaN();
  int Last = 0;
};
}

Image FindImage(
  vtkImageData* piece, const std::string& arrayName, const char* what, RankCommunicator& ranks)
{
  Image image;
  ranks.Agree([&]() { image.Piece = VoxelInput::Find(piece, arrayName, what); });
  vtkDataArray* values = image.Piece.Values;
  std::vector<VoxelPiece> pieces = ranks.AllGather(image.Piece);
  image.Grid = VoxelInput::FindGrid(pieces);
  image.Piece = pieces[ranks.Rank()];
  image.Piece.Values = values;
  if (image.Grid.Voxels() == 0.0)
  {
    throw std::invalid_argument(Text(what, " requires an image with voxels, got none."));
  }
  return image;
}

bool HasCellsHere(vtkAlgorithm& filter)
{
  // Without data, readers of images have points
  auto* piece = vtkImageData::SafeDownCast(filter.GetInputDataObject(0, 0));
  return piece && piece->GetPointData()->GetNumberOfArrays() == 0 &&
    piece->GetCellData()->GetNumberOfArrays() > 0;
}

ruc::VoxelGrid FindGridHere(vtkAlgorithm& filter)
{
  ruc::VoxelGrid grid;
  if (filter.GetNumberOfInputConnections(0) == 0)
  {
    return grid;
  }
  vtkInformation* info = filter.GetInputInformation(0, 0);
  auto* piece = vtkImageData::SafeDownCast(filter.GetInputDataObject(0, 0));
  if (!piece)
  {
    return grid;
  }
  // What the source has told of the whole image, else what this rank has of it
  int extent[6];
  std::copy_n(piece->GetExtent(), 6, extent);
  std::copy_n(piece->GetSpacing(), 3, grid.Spacing.begin());
  if (info->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()))
  {
    info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  }
  if (piece->GetNumberOfPoints() == 0 && info->Has(vtkDataObject::SPACING()))
  {
    info->Get(vtkDataObject::SPACING(), grid.Spacing.data());
  }
  const int points = HasCellsHere(filter) ? 0 : 1;
  for (int q = 0; q < 3; ++q)
  {
    grid.Dimensions[q] = std::max(0, extent[2 * q + 1] - extent[2 * q] + points);
    grid.Lower[q] = piece->GetOrigin()[q] + (extent[2 * q] - 0.5 * points) * grid.Spacing[q];
  }
  return grid;
}

std::vector<float> ReadValues(const Image& image, RankCommunicator& ranks)
{
  std::vector<float> values;
  values.reserve(image.Piece.Block.Voxels());
  std::int64_t bad = 0;
  ForEachValue(image.Piece.Values, image.Piece.Block.Voxels(),
    [&](double value)
    {
      values.push_back(static_cast<float>(value));
      bad += std::isfinite(values.back()) ? 0 : 1;
    });
  ranks.Sum(&bad, 1);
  ruc::Require(bad == 0, "ImageArray", "finite values", ruc::Text(bad, " that are not"));
  return values;
}

LocalLabels NumberLabels(const Image& image, const std::string& arrayName, RankCommunicator& ranks)
{
  LocalLabels local;
  ranks.Agree(
    [&]()
    {
      local.Block.Block = image.Piece.Block;
      const std::size_t voxels = image.Piece.Block.Voxels();
      local.Block.Phases.reserve(voxels);
      Numbering numbering;
      ForEachValue(image.Piece.Values, voxels,
        [&](double value)
        { local.Block.Phases.push_back(static_cast<std::uint8_t>(numbering.Find(value))); });
      local.Labels = numbering.Labels();
    });
  std::vector<std::int64_t>& all = local.OfAllRanks;
  all = ranks.Concatenate(local.Labels);
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  if (all.size() > ruc::MostImageLabels)
  {
    throw std::invalid_argument(Text("takes at most ", ruc::MostImageLabels, " labels; ",
      arrayName.empty() ? std::string("the array") : arrayName, " has ",
      all.size() < MostCounted ? "" : "at least ", all.size(), "."));
  }
  return local;
}

std::vector<std::int64_t> FindPhases(const LocalLabels& labels, int matrixLabel)
{
  std::vector<std::int64_t> phases = labels.OfAllRanks;
  const auto matrix = std::find(phases.begin(), phases.end(), matrixLabel);
  if (matrix == phases.end() || phases.size() < 2)
  {
    std::string present;
    for (std::int64_t label : phases)
    {
      present += Text(present.empty() ? "" : ", ", label);
    }
    throw std::invalid_argument(
      Text("MatrixLabel requires a label of the image, which has at least another one, got ",
        matrixLabel, " for an image with ", present, "."));
  }
  std::rotate(matrix, matrix + 1, phases.end());
  return phases;
}

void Renumber(LocalLabels& labels, const std::vector<std::int64_t>& phases)
{
  std::vector<std::uint8_t> phaseOf;
  for (std::int64_t label : labels.Labels)
  {
    phaseOf.push_back(
      static_cast<std::uint8_t>(std::find(phases.begin(), phases.end(), label) - phases.begin()));
  }
  for (std::uint8_t& phase : labels.Block.Phases)
  {
    phase = phaseOf[phase];
  }
}

void TakeMask(const Image& mask, int label, ruc::PhaseSlab& slab, RankCommunicator& ranks)
{
  ruc::PhaseBlock block;
  block.Block = mask.Piece.Block;
  block.Phases.reserve(mask.Piece.Block.Voxels());
  ForEachValue(mask.Piece.Values, mask.Piece.Block.Voxels(),
    [&](double value)
    { block.Phases.push_back(label == 0 ? value != 0.0 && !std::isnan(value) : value == label); });
  const ruc::PhaseSlab inside = ruc::SpreadPhases(block, mask.Grid.Dimensions, slab.Axis, ranks);
  for (std::size_t n = 0; n < slab.Phases.size(); ++n)
  {
    slab.Phases[n] = inside.Phases[n] != 0 ? slab.Phases[n] : ruc::OutsideMask;
  }
}
}
