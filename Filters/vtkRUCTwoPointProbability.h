// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCTwoPointProbability
 * @brief Two-point probability functions S_rs(r) of a sphere pack
 *
 * Input: a sphere pack with `Mode` (vtkRUCPackAlgorithm). S_rs(r) is the probability that a point
 * lies in phase r and another, a lag r away in any direction, in phase s; phases are the modes
 * 1…N_p and the matrix m. Raw normalisation: S_rs(0) = c_r delta_rs, S_rs(infinity) = c_r c_s.
 *
 * Exact Pair Sum: the closed form for spheres that do not overlap, unbiased in a box or cylinder
 * window and exact in a periodic box; see Core/Statistics/TwoPointProbability.h.
 *
 * Outputs, tables whole on rank 0: 0 `r`, `S_1_1`, `S_1_2`, …, `S_m_m`, a column for each unordered
 * pair and a row for each lag r_k = k MaximumLag / NumberOfLags, k = 0 to NumberOfLags; 1 the
 * checks `Pair`, `Limit` (c_r c_s), `ErrorAtZero` (7), `ErrorAtInfinity` (8, at the last lag),
 * `Asymmetry` (9; 0, since S_rs = S_sr by construction) and `SaturationLength` (not a number where
 * it is not reached); 2 `r` and the gradients dS/dr under the names of output 0. Equation numbers:
 * Lee et al., Phys. Rev. E 80, 061301 (2009).
 */
#ifndef vtkRUCTwoPointProbability_h
#define vtkRUCTwoPointProbability_h

#include "vtkRUCPackAlgorithm.h"

class RUCFILTERS_EXPORT vtkRUCTwoPointProbability : public vtkRUCPackAlgorithm
{
public:
  static vtkRUCTwoPointProbability* New();
  vtkTypeMacro(vtkRUCTwoPointProbability, vtkRUCPackAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Methods
  {
    EXACT_PAIR_SUM = 0
  };

  ///@{
  /** The estimator. Default and only choice: EXACT_PAIR_SUM. */
  vtkSetMacro(Method, int);
  vtkGetMacro(Method, int);
  ///@}
  ///@{
  /**
   * The last lag. Default: 0, half the shortest edge of the window (of a cylinder: of the lesser of
   * diameter and height). At most the shortest non-periodic edge less the largest diameter, or four
   * shortest edges of a periodic box.
   */
  vtkSetMacro(MaximumLag, double);
  vtkGetMacro(MaximumLag, double);
  ///@}
  ///@{
  /** K, the number of lags after 0; 1 to 100 000. Default: 277. */
  vtkSetMacro(NumberOfLags, int);
  vtkGetMacro(NumberOfLags, int);
  ///@}
  ///@{
  /**
   * S_rs counts as saturated from the lag on after which |S_rs - c_r c_s| and (mean diameter)
   * |dS_rs/dr| stay at or below this; > 0. Default: 0.0005. The mean diameter is the volume mean
   * over the pack.
   */
  vtkSetMacro(SaturationTolerance, double);
  vtkGetMacro(SaturationTolerance, double);
  ///@}

protected:
  vtkRUCTwoPointProbability();
  ~vtkRUCTwoPointProbability() override = default;
  const char* GetLabel() const override { return "Two-Point Probability"; }
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  void Execute(vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks) override;

private:
  vtkRUCTwoPointProbability(const vtkRUCTwoPointProbability&) = delete;
  void operator=(const vtkRUCTwoPointProbability&) = delete;

  int Method = EXACT_PAIR_SUM;
  double MaximumLag = 0.0;
  int NumberOfLags = 277;
  double SaturationTolerance = 0.0005;
};

#endif
