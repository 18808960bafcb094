// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCCompareProbabilities
 * @brief How far the probability functions of cells are from those of a pack
 *
 * Input 0 has the functions of the pack, and input 1 those of one or more cells (or of any other
 * media). Either all are tables of S_rs with the columns `r`, `S_1_1`, … `S_m_m` on the same lags
 * (output 0 of vtkRUCTwoPointProbability, or read from a file), or both are one image with the same
 * grid (output 0 of vtkRUCThreePointProbability, or a map S_rs(x)). The tables of several cells are
 * averaged.
 *
 * Output 0 is a table with a row for each quantity: `Quantity` (c_1, …, c_m, S_1_1, …, and all; for
 * images the names of the arrays); `Pack` and `Cell` (a fraction, or a discrete norm, which leaves
 * lag 0 out); `Difference` (its magnitude, or the norm of the difference); `LargestDifference` (its
 * largest magnitude over the lags) and `Percent`. For the fractions of the modes Percent is
 * equation 16, the difference in percent of the particles' whole fraction in the pack; for
 * functions it is that of the norms, in percent of the mean of both norms; in the last row, all, it
 * is that of the sums over all ordered pairs, which is equation 17. With the tables of several
 * cells there is also `StandardDeviation`, of a fraction over the cells, or the norm of that of a
 * function.
 *
 * Output 1 is a table by lag (empty for images): `r`, `S_1_1_pack`, `S_1_1_cell`,
 * `S_1_1_difference` (pack - cell) and, for several cells, `S_1_1_deviation` (standard deviation
 * over the cells), and so on.
 *
 * Output 2 is, for images, the image of the magnitudes of the differences, such as |S_rsq of the
 * pack - S_rsq of the cell|, under the names of the arrays, and where both have standard errors
 * also `…_error`, the root of the sum of their squares.
 *
 * Tables are whole on rank 0. Field data `DifferencePercent` is the Percent of the last row. The
 * equations are those of Lee et al., Phys. Rev. E 80, 061301 (2009).
 */
#ifndef vtkRUCCompareProbabilities_h
#define vtkRUCCompareProbabilities_h

#include "RUCStatisticsModule.h"
#include "vtkRUCParallelAlgorithm.h"

class vtkImageData;

class RUCSTATISTICS_EXPORT vtkRUCCompareProbabilities : public vtkRUCParallelAlgorithm
{
public:
  static vtkRUCCompareProbabilities* New();
  vtkTypeMacro(vtkRUCCompareProbabilities, vtkRUCParallelAlgorithm);

  ///@{
  /** Adds the probabilities of a cell, or takes all of them away. */
  void AddCellConnection(vtkAlgorithmOutput* output) { this->AddInputConnection(1, output); }
  void RemoveAllCellConnections() { this->RemoveAllInputConnections(1); }
  ///@}

protected:
  vtkRUCCompareProbabilities();
  ~vtkRUCCompareProbabilities() override = default;
  const char* GetLabel() const override { return "Compare Probabilities"; }
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  void Execute(
    vtkInformationVector** inputs, vtkInformationVector* outputs, RankCommunicator& ranks) override;

private:
  vtkRUCCompareProbabilities(const vtkRUCCompareProbabilities&) = delete;
  void operator=(const vtkRUCCompareProbabilities&) = delete;

  void CompareTables(
    vtkInformationVector** inputs, vtkInformationVector* outputs, RankCommunicator& ranks) const;
  void CompareImages(vtkImageData* pack, vtkImageData* cell, vtkInformationVector* outputs,
    RankCommunicator& ranks) const;
};

#endif
