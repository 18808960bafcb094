// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCPackAlgorithm
 * @brief What the filters of sphere packs have in common
 *
 * The input is a sphere pack: any point set with a point array `Radius` and, for most filters,
 * `Mode`. It may lie on one rank, be spread over ranks, or leave ranks empty; outputs are the same.
 *
 * The window, the region in which the centres were observed, comes from the pack's field data
 * (`BoxOrigin`, `BoxSize`, `BoxPeriodic`, or `CylinderBase`, `CylinderAxis`, `CylinderRadius`,
 * `CylinderHeight`), else from the properties of the same names, else it is the box of the centres'
 * bounds. All lengths are in the pack's unit.
 *
 * Whatever is wrong with the input or a property is found on all ranks alike, reported once, and
 * leaves every output empty; no rank hangs.
 */
#ifndef vtkRUCPackAlgorithm_h
#define vtkRUCPackAlgorithm_h

#include "RUCFiltersModule.h"
#include "vtkDataObjectAlgorithm.h"

#include <string>
#include <vector>

class RankCommunicator;
class vtkMultiProcessController;
class vtkPointSet;

namespace PackData
{
struct WindowProperties;
}

class RUCFILTERS_EXPORT vtkRUCPackAlgorithm : public vtkDataObjectAlgorithm
{
public:
  vtkTypeMacro(vtkRUCPackAlgorithm, vtkDataObjectAlgorithm);
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
  /** The ranks that work together; the global controller unless set. */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController() const { return this->Controller; }
  ///@}

protected:
  vtkRUCPackAlgorithm();
  ~vtkRUCPackAlgorithm() override;

  /** The name that error messages and progress carry: the label in the menu. */
  virtual const char* GetLabel() const = 0;

  /**
   * Fills the outputs, on all ranks together. Throws std::invalid_argument, the same on every rank,
   * for bad input. The outputs are empty at the start and are emptied again after an error.
   */
  virtual void Execute(
    vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks) = 0;

  PackData::WindowProperties GetWindowProperties() const;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;
  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) final;

private:
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
  vtkMultiProcessController* Controller = nullptr;
};

#endif
