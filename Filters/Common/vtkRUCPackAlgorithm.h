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

#include "vtkRUCParallelAlgorithm.h"

#include <optional>
#include <string>

class vtkPointSet;

namespace PackData
{
struct WindowProperties;
}
namespace ruc
{
struct Estimate;
struct PackFigures;
}

class RUCCOMMON_EXPORT vtkRUCPackAlgorithm : public vtkRUCParallelAlgorithm
{
public:
  vtkTypeMacro(vtkRUCPackAlgorithm, vtkRUCParallelAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Origin and edges of a box window; edges of 0 (the default) leave the window to the pack. */
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
  /** A cylinder window: centre of the base, axis direction (default z), radius and height; 0 leaves
   * the window to the pack. */
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
  /** Leave spheres with centres outside the window out, instead of refusing the pack. Default: off.
   */
  vtkSetMacro(CropToWindow, bool);
  vtkGetMacro(CropToWindow, bool);
  ///@}
  ///@{
  /**
   * For the estimates alone: how many spheres the input has on all ranks together, which rank 0
   * cannot know by itself. Does not modify the filter. Default: 0, the input's field data
   * `NumberOfSpheres`, or on one rank its points.
   */
  void SetSpheresInInput(vtkIdType number) { this->SpheresInInput = number; }
  vtkIdType GetSpheresInInput() const { return this->SpheresInInput; }
  ///@}

  ///@{
  /** What every rank may use, in megabytes of 10^6 bytes: a run whose estimate (GetEstimatedMemory)
   * is above that on any rank is refused on all before it begins. Default: 4000. */
  vtkSetMacro(MemoryLimit, double);
  vtkGetMacro(MemoryLimit, double);
  ///@}

  /**
   * What a run with the properties as they are would take on an even pack: seconds, with the work
   * shared by all ranks and their threads, and megabytes of 10^6 bytes on every rank. Told from the
   * input as it was last updated on this rank, without any work and without asking other ranks, so
   * to a factor of three (Core/Base/Estimate.h). 0 where that is not known: without input, for
   * properties out of range, and by the filters that do not say.
   */
  double GetEstimatedTime();
  virtual double GetEstimatedMemory();
  /** What 0 stands for, about, in properties that are then automatic: "Maximum Lag 394". Empty
   * where none is 0, and where that is not known. */
  const char* GetAutomaticValues();

protected:
  vtkRUCPackAlgorithm() = default;
  ~vtkRUCPackAlgorithm() override = default;

  /** The same for the pack, vtkRUCParallelAlgorithm::Execute. */
  virtual void Execute(
    vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks) = 0;
  void Execute(
    vtkInformationVector** inputs, vtkInformationVector* outputs, RankCommunicator& ranks) override;

  PackData::WindowProperties GetWindowProperties() const;

  /** What the estimates are made of, from figures of the pack; none where they are not known. May
   * throw std::invalid_argument for what a run would refuse, which then has no estimates either. */
  virtual std::optional<ruc::Estimate> MakeEstimate();
  /** What comes to that for a region to sample, as far as it is known; nothing by default. */
  virtual ruc::Estimate EstimateRegion();
  /** The part of the estimated memory that is held against MemoryLimit before a run; all of it by
   * default. */
  virtual double GetMemoryToCheck() { return this->GetEstimatedMemory(); }
  /** Collective: throws std::invalid_argument, the same on every rank, where that is above
   * MemoryLimit on any rank. What is not known on any is taken. */
  void CheckMemory(RankCommunicator& ranks);
  /** How many spheres all ranks have, while that is known or set; else 0. */
  vtkIdType GetKnownSpheres() const
  {
    return this->SpheresFound > 0 ? this->SpheresFound : this->SpheresInInput;
  }
  /** The pack as this rank alone knows it, none where it does not. */
  std::optional<ruc::PackFigures> FindFigures();

  int FillInputPortInformation(int port, vtkInformation* info) override;

private:
  vtkRUCPackAlgorithm(const vtkRUCPackAlgorithm&) = delete;
  void operator=(const vtkRUCPackAlgorithm&) = delete;

  std::optional<ruc::Estimate> FindEstimate();

  double BoxOrigin[3] = { 0.0, 0.0, 0.0 };
  double BoxSize[3] = { 0.0, 0.0, 0.0 };
  int BoxPeriodic[3] = { 0, 0, 0 };
  double CylinderBase[3] = { 0.0, 0.0, 0.0 };
  double CylinderAxis[3] = { 0.0, 0.0, 1.0 };
  double CylinderRadius = 0.0;
  double CylinderHeight = 0.0;
  bool CropToWindow = false;
  vtkIdType SpheresInInput = 0;
  vtkIdType SpheresFound = 0; // at the beginning of a run
  double MemoryLimit = 4000.0;
  std::string AutomaticValues;
};

#endif
