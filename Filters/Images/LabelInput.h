// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "VoxelPiece.h"
#include "ruc/Images/PhaseSlab.h"

#include <cstdint>
#include <string>
#include <vector>

class RankCommunicator;
class vtkAlgorithm;
class vtkDataArray;
class vtkImageData;

/** Images of which every rank has a piece, and label images: those whose values are whole numbers,
 * each of which stands for a phase. */
namespace LabelInput
{
/**
 * An image of which this rank has a piece, whose numbers are those of the whole one.
 */
struct Image
{
  ruc::VoxelGrid Grid;
  VoxelPiece Piece;
};

/**
 * Finds the image of which the ranks have pieces. Throws std::invalid_argument, the same on every
 * rank, for what VoxelInput refuses, and where there are no voxels. Collective.
 */
Image FindImage(
  vtkImageData* piece, const std::string& arrayName, const char* what, RankCommunicator& ranks);

/**
 * Returns the grid of the image at the first input of a filter as this rank knows it without the
 * others and before a run, or one without voxels.
 */
ruc::VoxelGrid FindGridHere(vtkAlgorithm& filter);
/** Returns whether its voxels are cells, as far as that is known. */
bool HasCellsHere(vtkAlgorithm& filter);

/**
 * Returns the values of this rank's voxels. Throws std::invalid_argument, the same on every rank,
 * with their number, where values are not finite. Collective.
 */
std::vector<float> ReadValues(const Image& image, RankCommunicator& ranks);

/** The voxels of this rank, numbered by the labels that it has. */
struct LocalLabels
{
  ruc::PhaseBlock Block;
  std::vector<std::int64_t> Labels;
  std::vector<std::int64_t> OfAllRanks; // in rising order
};

/**
 * Numbers the labels of this rank. Throws std::invalid_argument, the same on every rank, for values
 * that are no whole numbers, and where all ranks together have more than ruc::MostImageLabels, of
 * which the message tells the number. Collective.
 */
LocalLabels NumberLabels(const Image& image, const std::string& arrayName, RankCommunicator& ranks);

/**
 * Returns the labels of all ranks: the matrix last, the others in rising order. Throws
 * std::invalid_argument, the same on every rank, where no voxel has the label of the matrix or any
 * other.
 */
std::vector<std::int64_t> FindPhases(const LocalLabels& labels, int matrixLabel);

/** Renumbers the voxels by the places of their labels in `phases`. */
void Renumber(LocalLabels& labels, const std::vector<std::int64_t>& phases);

/**
 * Sets the voxels of a slab to ruc::OutsideMask that are not `label` in a mask, or where that is 0
 * are 0 or not a number. The mask has the voxels of the image. Collective.
 */
void TakeMask(const Image& mask, int label, ruc::PhaseSlab& slab, RankCommunicator& ranks);
}
