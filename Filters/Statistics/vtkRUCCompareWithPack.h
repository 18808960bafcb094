// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCCompareWithPack
 * @brief Whether cells are as another piece of their pack: a report in the pack's own standard
 * errors
 *
 * Input 0 is one pack, or several packs of one process, with `Mode`; input 1 one or more cells with
 * the same modes, such as output 0 of vtkRUCUnitCellReconstruction. Of a composite data set on
 * input 1 each block is a cell, so that output 3 of that filter is all its cells. The windows come
 * from the field data (vtkRUCPackAlgorithm), else they are the bounds of the centres.
 *
 * Output 0 is a table, whole on rank 0, with a row for each descriptor
 * (Core/Statistics/Comparison/PackDescriptors.h and ReportCard.h): `Descriptor`; `Pack` and
 * `Pack_error`, its standard error by blocks of the pack, or of several packs by their scatter;
 * `Cell`, the mean over the cells, and `Cell_deviation`, their standard deviation, or of one cell
 * its own standard error, or NaN; `Z`, the difference over its standard error; `Fitted`, 1 where
 * the search that made the cells fits it; `Row` from 1, and `Upper` and `Lower`, which are 2 and
 * -2, for the chart.
 *
 * Field data: `Verdict`, a sentence; `NumberOfDescriptors`, `NumberWithin` (|Z| <= 2), `LargestZ`;
 * `ObjectiveFloor`, the F2 between pack and medium; `NumberOfPacks`, `NumberOfCells`,
 * `NumberOfLags`, `MaximumLag`, `LengthUnit`; and `LeftOut`, why descriptors are left out, if any
 * are.
 */
#ifndef vtkRUCCompareWithPack_h
#define vtkRUCCompareWithPack_h

#include "RUCStatisticsModule.h"
#include "vtkRUCParallelAlgorithm.h"

namespace ruc
{
struct ReportCard;
}

class RUCSTATISTICS_EXPORT vtkRUCCompareWithPack : public vtkRUCParallelAlgorithm
{
public:
  static vtkRUCCompareWithPack* New();
  vtkTypeMacro(vtkRUCCompareWithPack, vtkRUCParallelAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Adds a cell, or takes all of them away. */
  void AddCellConnection(vtkAlgorithmOutput* output) { this->AddInputConnection(1, output); }
  void RemoveAllCellConnections() { this->RemoveAllInputConnections(1); }
  ///@}
  ///@{
  /**
   * The last lag of S_rs. Default: 0, which stands for half the shortest edge of all windows, of
   * packs and cells.
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
  /**
   * About the number of blocks of a pack for its standard errors, 8 to 1000. A pack without room
   * for eight blocks with edges of two mean diameters is refused. Default: 64.
   */
  vtkSetMacro(Blocks, int);
  vtkGetMacro(Blocks, int);
  ///@}

protected:
  vtkRUCCompareWithPack();
  ~vtkRUCCompareWithPack() override = default;
  const char* GetLabel() const override { return "Compare With Pack"; }
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  void Execute(
    vtkInformationVector** inputs, vtkInformationVector* outputs, RankCommunicator& ranks) override;

private:
  vtkRUCCompareWithPack(const vtkRUCCompareWithPack&) = delete;
  void operator=(const vtkRUCCompareWithPack&) = delete;

  double MaximumLag = 0.0;
  int NumberOfLags = 277;
  int Blocks = 64;
};

#endif
