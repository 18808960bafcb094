// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCCellSizeStudy
 * @brief How large a cell must be to be as another piece of its pack
 *
 * Input: a sphere pack with `Mode` (vtkRUCPackAlgorithm). Cells of several sizes are made by the
 * method Gradient of vtkRUCUnitCellReconstruction and compared with the pack as by
 * vtkRUCCompareWithPack (Core/Study/CellSizes.h).
 *
 * The outputs are tables, whole on rank 0. Output 0 has a row for each size: `Spheres`; `Edge`;
 * `F2` and `F2_deviation`, the mean and the standard deviation over the cells (NaN for one);
 * `ObjectiveFloor`, the F2 between the pack and its medium; `LargestZ` and `LargestFittedZ`, the
 * largest |Z| of all descriptors and of those that the search fits; `NumberWithin`, with |Z| <= 2,
 * of `NumberOfDescriptors`; and `Bound`, which is 2. Output 1 has the Z of every descriptor, of all
 * that all sizes have: `Descriptor`, `Pack`, `Pack_error`, `Fitted`, and `Z_100`, ... for each
 * size.
 *
 * Field data: `Verdict`, a sentence; `LeastSize` and `LeastFittedSize`, from which on no
 * descriptor, or none that is fitted, has |Z| > 2, or 0; `ObjectiveFloor`, `NumberOfCells`,
 * `NumberOfLags`, `MaximumLag`; `LeftOut`, why sizes are left out, if any are; `Stopped`.
 */
#ifndef vtkRUCCellSizeStudy_h
#define vtkRUCCellSizeStudy_h

#include "RUCReconstructionModule.h"
#include "vtkRUCPackAlgorithm.h"

#include "ruc/Study/CellSizes.h"

class RUCRECONSTRUCTION_EXPORT vtkRUCCellSizeStudy : public vtkRUCPackAlgorithm
{
public:
  static vtkRUCCellSizeStudy* New();
  vtkTypeMacro(vtkRUCCellSizeStudy, vtkRUCPackAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The numbers of spheres in a cell. Default: 100, 200, 400, 800, 1600 and 3200. */
  void ClearSizes();
  void SetSize(int i, int spheres);
  ///@}
  ///@{
  /** The number of cells of each size, 1 to 100. Default: 3. */
  vtkSetMacro(NumberOfCells, int);
  vtkGetMacro(NumberOfCells, int);
  ///@}
  ///@{
  /**
   * The last lag of S_rs. Default: 0, which stands for half the shortest edge of the window or, if
   * that is less, the edge of the smallest cell. It is at most two edges of that.
   */
  vtkSetMacro(MaximumLag, double);
  vtkGetMacro(MaximumLag, double);
  ///@}
  ///@{
  /** The number of lags after 0; 1 to 100 000. Default: 277. */
  vtkSetMacro(NumberOfLags, int);
  vtkGetMacro(NumberOfLags, int);
  ///@}
  ///@{
  /** As of vtkRUCUnitCellReconstruction. Default: 100. */
  vtkSetMacro(MaximumIterations, int);
  vtkGetMacro(MaximumIterations, int);
  ///@}
  ///@{
  /** As of vtkRUCUnitCellReconstruction. Defaults: 1, 1 and 0. */
  vtkSetMacro(ContactWeight, double);
  vtkGetMacro(ContactWeight, double);
  vtkSetMacro(PoreWeight, double);
  vtkGetMacro(PoreWeight, double);
  vtkSetMacro(SpectrumWeight, double);
  vtkGetMacro(SpectrumWeight, double);
  ///@}
  ///@{
  /** About the number of blocks for the pack's own errors, 8 to 1000. Default: 64. */
  vtkSetMacro(Blocks, int);
  vtkGetMacro(Blocks, int);
  ///@}
  ///@{
  /** The seed of the first cell of each size, >= 0. Default: 1. */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

protected:
  vtkRUCCellSizeStudy();
  ~vtkRUCCellSizeStudy() override = default;
  const char* GetLabel() const override { return "Cell Size Study"; }
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  using vtkRUCPackAlgorithm::Execute;
  void Execute(vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks) override;
  std::optional<ruc::Estimate> MakeEstimate() override;

private:
  vtkRUCCellSizeStudy(const vtkRUCCellSizeStudy&) = delete;
  void operator=(const vtkRUCCellSizeStudy&) = delete;

  ruc::CellSizeSettings MakeSettings() const;

  std::vector<int> Sizes = { 100, 200, 400, 800, 1600, 3200 };
  int NumberOfCells = 3;
  double MaximumLag = 0.0;
  int NumberOfLags = 277;
  int MaximumIterations = 100;
  double ContactWeight = 1.0;
  double PoreWeight = 1.0;
  double SpectrumWeight = 0.0;
  int Blocks = 64;
  int Seed = 1;
};

#endif
