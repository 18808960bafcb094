// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCPackAlgorithm
 * @brief What the filters of sphere packs have in common
 *
 * The input is a sphere pack: any point set with a point array `Radius` and, for most filters,
 * `Mode`, or a composite data set of such (PackInput). It may lie on one rank, be spread over
 * ranks, or leave ranks empty; outputs are the same.
 *
 * The window, the region in which the centres were observed, comes from the pack's field data
 * (`BoxOrigin`, `BoxSize`, `BoxPeriodic`, or `CylinderBase`, `CylinderAxis`, `CylinderRadius`,
 * `CylinderHeight`), else from the properties of the same names, else it is the box of the centres'
 * bounds. All lengths are in the pack's unit.
 */
#ifndef vtkRUCPackAlgorithm_h
#define vtkRUCPackAlgorithm_h

#include "vtkRUCEstimatedAlgorithm.h"

#include <optional>
#include <string>

class vtkPointSet;

namespace PackData
{
struct ObservedPack;
struct PackOrigin;
struct PackPiece;
struct SharedPack;
struct WindowProperties;
}
namespace ruc
{
struct PackFigures;
struct PackShare;
}

class RUCCOMMON_EXPORT vtkRUCPackAlgorithm : public vtkRUCEstimatedAlgorithm
{
public:
  vtkTypeMacro(vtkRUCPackAlgorithm, vtkRUCEstimatedAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The origin and the edges of a box window. Edges of 0 (the default) leave the window to the
   * pack.
   */
  vtkSetVector3Macro(BoxOrigin, double);
  vtkGetVector3Macro(BoxOrigin, double);
  vtkSetVector3Macro(BoxSize, double);
  vtkGetVector3Macro(BoxSize, double);
  ///@}
  ///@{
  /** Which axes of the box window are periodic. Default: none. */
  vtkSetVector3Macro(BoxPeriodic, int);
  vtkGetVector3Macro(BoxPeriodic, int);
  ///@}
  ///@{
  /**
   * A cylinder window: the centre of its base, the direction of its axis (default z), its radius
   * and its height. Radius and height 0 (the default) leave the window to the pack.
   */
  vtkSetVector3Macro(CylinderBase, double);
  vtkGetVector3Macro(CylinderBase, double);
  vtkSetVector3Macro(CylinderAxis, double);
  vtkGetVector3Macro(CylinderAxis, double);
  vtkSetMacro(CylinderRadius, double);
  vtkGetMacro(CylinderRadius, double);
  vtkSetMacro(CylinderHeight, double);
  vtkGetMacro(CylinderHeight, double);
  ///@}
  ///@{
  /**
   * Whether spheres with centres outside the window are left out, instead of the pack being
   * refused. Default: off.
   */
  vtkSetMacro(CropToWindow, bool);
  vtkGetMacro(CropToWindow, bool);
  ///@}
  ///@{
  /**
   * The number of spheres that the input has on all ranks together, which rank 0 cannot know by
   * itself. It serves the estimates alone, and setting it does not modify the filter. Default: 0,
   * which stands for the input's field data `NumberOfSpheres`, or on one rank for its points.
   */
  void SetSpheresInInput(vtkIdType number) { this->SpheresInInput = number; }
  vtkIdType GetSpheresInInput() const { return this->SpheresInInput; }
  ///@}

protected:
  vtkRUCPackAlgorithm() = default;
  ~vtkRUCPackAlgorithm() override = default;

  /**
   * Fills the outputs as vtkRUCParallelAlgorithm::Execute does, for this rank's points of the pack,
   * which are null where it has none.
   */
  virtual void Execute(
    vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks) = 0;
  void Execute(
    vtkInformationVector** inputs, vtkInformationVector* outputs, RankCommunicator& ranks) override;

  /** Whether a table of spheres is a pack. */
  virtual bool TakesTables() const { return false; }

  virtual PackData::WindowProperties GetWindowProperties();

  ///@{
  /**
   * These do what the functions of the same names in PackData do, with the filter's window, and
   * print the warnings. A share has modes. Collective.
   */
  PackData::PackPiece FindPiece(
    vtkPointSet* input, bool withModes, RankCommunicator& ranks, double leastDiameter = 0.0);
  PackData::SharedPack FindShare(vtkPointSet* input, RankCommunicator& ranks);
  PackData::ObservedPack GatherPack(vtkPointSet* input, bool withModes, RankCommunicator& ranks);
  ///@}

  /**
   * Runs the filters upstream when ParaView asks how large an image will be, and returns this
   * rank's share of the pack that comes, without warnings. Collective.
   */
  PackData::SharedPack FindShareEarly(
    vtkInformationVector** inputs, vtkInformationVector* outputs, RankCommunicator& ranks);

  /**
   * Returns the overlap of a pack in percent of the spheres' volume. If the volumes of the spheres
   * add up to that of the window or more, or the overlap is above PackData::MostOverlap, diameters
   * have most likely been taken as radii. An `exact` result, a sum over spheres in which overlaps
   * count twice, is then refused (std::invalid_argument), and comes with a warning if the overlap
   * is above PackData::TolerableOverlap. Any other result comes with a warning in the first case
   * alone. Collective.
   */
  double CheckOverlap(const ruc::PackShare& share, bool exact, RankCommunicator& ranks);
  /**
   * Warns of the same by the volumes alone. `volume` is that of all spheres, `ofWindow` that of the
   * window.
   */
  void WarnOfVolume(double volume, double ofWindow, const RankCommunicator& ranks);

  /**
   * Throws std::invalid_argument, the same on every rank, where GetMemoryToCheck is above
   * MemoryLimit on any rank. A run whose memory is not known on any rank is let through.
   * Collective.
   */
  void CheckMemory(RankCommunicator& ranks);
  /** The number of spheres on all ranks, while it is known or set; else 0. */
  vtkIdType GetKnownSpheres() const
  {
    return this->SpheresFound > 0 ? this->SpheresFound : this->SpheresInInput;
  }
  /** Returns the figures of the pack as this rank alone knows it, or none where it does not. */
  std::optional<ruc::PackFigures> FindFigures();

  int FillInputPortInformation(int port, vtkInformation* info) override;

private:
  void Warn(const PackData::PackOrigin& origin, const RankCommunicator& ranks);

  vtkRUCPackAlgorithm(const vtkRUCPackAlgorithm&) = delete;
  void operator=(const vtkRUCPackAlgorithm&) = delete;

  double BoxOrigin[3] = { 0.0, 0.0, 0.0 };
  double BoxSize[3] = { 0.0, 0.0, 0.0 };
  int BoxPeriodic[3] = { 0, 0, 0 };
  double CylinderBase[3] = { 0.0, 0.0, 0.0 };
  double CylinderAxis[3] = { 0.0, 0.0, 1.0 };
  double CylinderRadius = 0.0;
  double CylinderHeight = 0.0;
  bool CropToWindow = false;
  vtkIdType SpheresInInput = 0;
  vtkIdType SpheresFound = 0; // the number on all ranks, while a run checks its memory
};

#endif
