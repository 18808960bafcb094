// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCDirectionalProbability
 * @brief Two-point probability functions S_rs(r n) of a sphere pack along directions n
 *
 * Input: a sphere pack with `Mode` (vtkRUCPackAlgorithm), and for Chord Sampling an optional mask
 * (vtkRUCRegionAlgorithm). S_rs(r n) is the probability that a point x lies in phase r and x + r n
 * in phase s, the mean over n and -n. An isotropic pack has the same function along every
 * direction; how far the functions are apart tells the anisotropy.
 *
 * Exact Pair Sum is the closed form for spheres that do not overlap
 * (Core/Statistics/PairSums/DirectionalProbability.h). Chord Sampling is for spheres that may
 * overlap and for any window: it takes NumberOfLines lines along every direction
 * (Core/Statistics/Sampling/ChordSampling.h), or as many as a TargetError takes along each. The
 * field data `NumberOfLines` adds them up, and `TotalError` is the largest of all directions.
 *
 * The outputs are tables, whole on rank 0. Output 0 is the isotropy: `r`; `sigma_S_1_1`, …, the
 * standard deviation of S_rs(r n) over the directions n (Fig. 6b of Lee et al., Phys. Rev. E 80,
 * 061301, 2009); and, for Chord Sampling, `sigma_S_1_1_noise`, …, the part that sampling errors
 * alone would cause. Output 1 has a row for each direction and lag: `Direction` (its number from
 * 0), `nx`, `ny`, `nz`, `r`, `S_1_1`, … and, for Chord Sampling, the standard errors `S_1_1_error`,
 * ….
 */
#ifndef vtkRUCDirectionalProbability_h
#define vtkRUCDirectionalProbability_h

#include "RUCStatisticsModule.h"
#include "vtkRUCSamplingAlgorithm.h"

class ProgressReport;
namespace OutputSummary
{
struct Samples;
}
namespace ruc
{
struct DirectionalProbability;
struct LagGrid;
struct PackShare;
}

class RUCSTATISTICS_EXPORT vtkRUCDirectionalProbability : public vtkRUCSamplingAlgorithm
{
public:
  static vtkRUCDirectionalProbability* New();
  vtkTypeMacro(vtkRUCDirectionalProbability, vtkRUCSamplingAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Methods
  {
    EXACT_PAIR_SUM = 0,
    CHORD_SAMPLING = 1
  };
  enum Ports
  {
    ISOTROPY = 0,
    DIRECTIONS = 1
  };

  ///@{
  /** The estimator. Default: EXACT_PAIR_SUM. */
  vtkSetMacro(Method, int);
  vtkGetMacro(Method, int);
  ///@}
  ///@{
  /** The number of directions, which are spread evenly over the half sphere; >= 2. Default: 32. */
  vtkSetMacro(NumberOfDirections, int);
  vtkGetMacro(NumberOfDirections, int);
  ///@}
  ///@{
  /**
   * The last lag, with the limits of vtkRUCTwoPointProbability. Default: 0, which stands for half
   * the shortest edge, or for the largest lag there is if that is less.
   */
  vtkSetMacro(MaximumLag, double);
  vtkGetMacro(MaximumLag, double);
  ///@}
  ///@{
  /** K, the number of lags after 0; 1 to 100 000. Default: 277. */
  vtkSetMacro(NumberOfLags, int);
  vtkGetMacro(NumberOfLags, int);
  ///@}

protected:
  vtkRUCDirectionalProbability();
  ~vtkRUCDirectionalProbability() override = default;
  const char* GetLabel() const override { return "Directional Probability"; }
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  void Execute(vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks) override;
  std::optional<ruc::Estimate> MakeEstimate() override;

private:
  vtkRUCDirectionalProbability(const vtkRUCDirectionalProbability&) = delete;
  void operator=(const vtkRUCDirectionalProbability&) = delete;

  void ValidateProperties();
  // Measures by the exact sum where there is no region, else by lines, which `samples` counts
  ruc::DirectionalProbability Measure(const ruc::PackShare& share,
    const ruc::SamplingRegion* region, const ruc::LagGrid& lags, RankCommunicator& ranks,
    ProgressReport& report, OutputSummary::Samples& samples) const;

  int Method = EXACT_PAIR_SUM;
  int NumberOfDirections = 32;
  double MaximumLag = 0.0;
  int NumberOfLags = 277;
};

#endif
