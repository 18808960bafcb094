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
 */
#ifndef vtkRUCPackAlgorithm_h
#define vtkRUCPackAlgorithm_h

#include "vtkRUCParallelAlgorithm.h"

class vtkPointSet;

namespace PackData
{
struct WindowProperties;
}

class RUCFILTERS_EXPORT vtkRUCPackAlgorithm : public vtkRUCParallelAlgorithm
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

protected:
  vtkRUCPackAlgorithm() = default;
  ~vtkRUCPackAlgorithm() override = default;

  /** The same for the pack, vtkRUCParallelAlgorithm::Execute. */
  virtual void Execute(
    vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks) = 0;
  void Execute(
    vtkInformationVector** inputs, vtkInformationVector* outputs, RankCommunicator& ranks) override;

  PackData::WindowProperties GetWindowProperties() const;

  int FillInputPortInformation(int port, vtkInformation* info) override;

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
};

#endif
