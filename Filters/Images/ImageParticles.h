// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "LabelInput.h"
#include "ruc/Images/Fit/FindSpheres.h"
#include "ruc/Images/Fit/ParticleLabels.h"
#include "ruc/Images/Watershed/CutParticles.h"

#include <cstdint>
#include <functional>
#include <vector>

class vtkPolyData;

/** An image and the particles that are found in it, on the way from the one to the others. */
struct ImageParticles
{
  LabelInput::Image Input;
  double Edge = 1.0;    // of a voxel, in the mean
  ruc::Vector3 Edges{}; // over that
  bool HasLabels = false;
  bool OfPoints = false;      // whether voxels are points
  bool AreCut = false;        // whether particles are those of a watershed
  bool AreMeasured = true;    // whether Number and Shapes, and Slab of a fit, are of the particles
  ruc::VoxelSlab<float> Slab; // of the values, and later of what is left of them
  /** Of the label, and later of the particle, from 1; NotInPack for particles that are not in the
   * pack. */
  ruc::VoxelSlab<std::int32_t> Number;
  static constexpr std::int32_t NotInPack = ruc::CutParticles::NotKept;
  std::vector<std::int64_t> Labels; // of the image, in rising order
  ruc::FoundSpheres Found;
  std::vector<std::int64_t> Ids;
  std::vector<ruc::ParticleShape> Shapes; // of the labels, and later of the particles

  /**
   * Numbers the labels of the slab, and replaces those above 0 by 1. Throws std::invalid_argument,
   * the same on every rank, for values that are no whole numbers from 0 to 2^24. Collective.
   */
  void NumberLabels(RankCommunicator& ranks);
  /** Takes the particles of a watershed in place of those of a fit: Found has their centres and
   * radii of equal volume, as balls, and no more. */
  void TakeCut(ruc::CutParticles cut);
  /**
   * Sets Ids, Number and Shapes for the particles that were fitted, and takes these from the slab.
   * `goOn` is asked with the share of the work that is done, and answers the same on all ranks;
   * where it says no, nothing is measured and all shapes are NaN. Collective.
   */
  void FindShapes(const std::function<bool(double)>& goOn, RankCommunicator& ranks);

  /** The box of the image, less a margin, in which the centres are. */
  ruc::Window FindWindow() const;
  /** Fills the outputs on rank 0, as vtkRUCParticlesFromImage says. */
  void FillPack(vtkPolyData* data) const;
  void FillDropped(vtkPolyData* data) const;

private:
  void NumberIds();
  void NumberVoxels();
  void KeepShapesOfLabels();
  void FillFit(vtkPolyData* data) const;
  ruc::Vector3 PlaceOf(const ruc::Ball& ball) const;
  int FacesThatCut(const ruc::Ball& ball) const;
};
