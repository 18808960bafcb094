// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCChordLengths
 * @brief Chord-length densities and lineal-path functions of a sphere pack
 *
 * Input: a sphere pack with `Mode` (vtkRUCPackAlgorithm) and an optional mask
 * (vtkRUCRegionAlgorithm). Random lines through the region are cut into chords, the longest
 * intervals that lie in one phase. Overlaps count once.
 *
 * The output, whole on rank 0, is a table with the columns `r`; `p_1`, …, `p_m`, the chord-length
 * probability densities in 1 / length; `L_1`, …, `L_m`, the lineal-path functions, which are the
 * probability that a segment of length r lies in the phase; and their standard errors `p_1_error`,
 * …, `L_1_error`, … in the same units. Field data `MeanChordLength` has a number for every phase.
 * See Core/Statistics/Sampling/ChordLengths.h. TargetError bounds the sum of standard errors of the
 * S_rs that the same lines give, as in vtkRUCTwoPointProbability.
 */
#ifndef vtkRUCChordLengths_h
#define vtkRUCChordLengths_h

#include "RUCStatisticsModule.h"
#include "vtkRUCSamplingAlgorithm.h"

class RUCSTATISTICS_EXPORT vtkRUCChordLengths : public vtkRUCSamplingAlgorithm
{
public:
  static vtkRUCChordLengths* New();
  vtkTypeMacro(vtkRUCChordLengths, vtkRUCSamplingAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The greatest length. It is at most the shortest edge of the window or mask less twice the
   * margin, or four shortest edges of a periodic box. Default: 0, which stands for half the
   * shortest edge, or for the largest length there is if that is less.
   */
  vtkSetMacro(MaximumLag, double);
  vtkGetMacro(MaximumLag, double);
  ///@}
  ///@{
  /** K, the number of lengths after 0; 1 to 100 000. Default: 277. */
  vtkSetMacro(NumberOfLags, int);
  vtkGetMacro(NumberOfLags, int);
  ///@}

protected:
  vtkRUCChordLengths() = default;
  ~vtkRUCChordLengths() override = default;
  const char* GetLabel() const override { return "Chord Lengths"; }
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  void Execute(vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks) override;
  std::optional<ruc::Estimate> MakeEstimate() override;

private:
  vtkRUCChordLengths(const vtkRUCChordLengths&) = delete;
  void operator=(const vtkRUCChordLengths&) = delete;

  double MaximumLag = 0.0;
  int NumberOfLags = 277;
};

#endif
