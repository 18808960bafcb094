// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCTwoPointProbability
 * @brief Two-point probability functions S_rs(r) of a sphere pack
 *
 * Input: a sphere pack with `Mode` (vtkRUCPackAlgorithm), and for the sampled methods an optional
 * mask (vtkRUCSamplingAlgorithm). S_rs(r) is the probability that a point lies in phase r and
 * another, a lag r away in any direction, in phase s. Phases are the modes 1…N_p and the matrix m.
 * The normalisation is raw: S_rs(0) = c_r delta_rs and S_rs(infinity) = c_r c_s.
 *
 * Exact Pair Sum is the closed form for spheres that do not overlap, unbiased in a box or cylinder
 * window and exact in a periodic box (Core/Statistics/PairSums/ExactPairSum.h). Chord Sampling, for
 * spheres that may overlap and for any window, counts all pairs of points on random lines
 * (Core/Statistics/Sampling/ChordSampling.h). Template Sampling is the paper's template, for
 * comparison. TargetError bounds the sum over all ordered pairs of phases of || standard error of
 * S_rs ||, the discrete norm over the lags k = 1…K.
 *
 * The outputs are tables, whole on rank 0. Output 0 has a row for each lag r_k = k MaximumLag /
 * NumberOfLags, k = 0 to NumberOfLags, and the columns `r` and `S_1_1`, `S_1_2`, …, `S_m_m`, one
 * for each unordered pair of phases; then, for a sampled method and for the exact one with Blocks,
 * their standard errors `S_1_1_error`, …, which are absolute probabilities as well. Those of a
 * sampled method are of the sampling, those of the exact one of the pack as a sample of its medium
 * (Core/Statistics/PairSums/PairSumErrors.h). With the latter all outputs have the field data
 * `NumberOfBlocks`, `ObjectiveFloor`, `c_error` (of all phases, the matrix last) and `OneMedium`, a
 * sentence that says whether the pack is one medium along its axes.
 *
 * Output 1 has the checks: `Pair`; `Limit` (c_r c_s); `ErrorAtZero` (7; not for a sampled method,
 * whose c_r is S_rr(0)); `ErrorAtInfinity` (8, at the last lag); `Asymmetry` (9, with the mean of
 * the two norms as divisor; not for the exact method, where S_rs = S_sr by construction) and
 * `SaturationLength` (not a number where it is not reached). Its field data are `VolumeCheck` = 1 -
 * sum c_r - c_m; `SphereVolumeFractions`, those of Sphere Volumes in One-Point Probability;
 * `SpecificSurface`, the surface of the spheres over the volume of the window, in 1 / length; and
 * `SpecificSurfaceFromSlope`, -4 dS_mm/dr at 0, whose limit it is.
 *
 * Output 2 has `r` and the gradients dS/dr, in 1 / length, under the names of output 0. Output 3
 * has the autocovariance: `r` and `chi_1_1`, … = S_rs - c_r c_s. Equation numbers are those of Lee
 * et al., Phys. Rev. E 80, 061301 (2009).
 */
#ifndef vtkRUCTwoPointProbability_h
#define vtkRUCTwoPointProbability_h

#include "RUCStatisticsModule.h"
#include "vtkRUCSamplingAlgorithm.h"

class ProgressReport;
class vtkTable;
namespace ruc
{
struct LagGrid;
struct PackShare;
struct SampledTwoPoint;
struct TwoPointErrors;
struct TwoPointProbability;
}

class RUCSTATISTICS_EXPORT vtkRUCTwoPointProbability : public vtkRUCSamplingAlgorithm
{
public:
  static vtkRUCTwoPointProbability* New();
  vtkTypeMacro(vtkRUCTwoPointProbability, vtkRUCSamplingAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Methods
  {
    EXACT_PAIR_SUM = 0,
    CHORD_SAMPLING = 1,
    TEMPLATE_SAMPLING = 2
  };
  enum Ports
  {
    PROBABILITIES = 0,
    CHECKS = 1,
    GRADIENTS = 2,
    AUTOCOVARIANCES = 3
  };

  ///@{
  /** The estimator. Default: EXACT_PAIR_SUM. */
  vtkSetMacro(Method, int);
  vtkGetMacro(Method, int);
  ///@}
  ///@{
  /**
   * The last lag. Default: 0, which stands for half the shortest edge of the window (of a cylinder,
   * of the lesser of diameter and height), or for the largest lag there is if that is less. The
   * largest lag is, for the exact method, the shortest edge that is not periodic less the largest
   * diameter; for the other methods the shortest edge less twice the margin; and four shortest
   * edges of a periodic box.
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
   * The tolerance, > 0, of the saturation length: S_rs counts as saturated from the lag on after
   * which |S_rs - c_r c_s| and (mean diameter) |dS_rs/dr| stay at or below it. The mean diameter is
   * the volume mean over the pack. Default: 0.0005.
   */
  vtkSetMacro(SaturationTolerance, double);
  vtkGetMacro(SaturationTolerance, double);
  ///@}

  ///@{
  /**
   * About the number of blocks of the pack whose scatter tells the standard errors of Exact Pair
   * Sum: 0 for none, or 8 to 1000. A window without room for eight blocks with edges of two mean
   * diameters is refused. Default: 0.
   */
  vtkSetMacro(Blocks, int);
  vtkGetMacro(Blocks, int);
  ///@}

protected:
  vtkRUCTwoPointProbability();
  ~vtkRUCTwoPointProbability() override = default;
  const char* GetLabel() const override { return "Two-Point Probability"; }
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  void Execute(vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks) override;
  std::optional<ruc::Estimate> MakeEstimate() override;

private:
  vtkRUCTwoPointProbability(const vtkRUCTwoPointProbability&) = delete;
  void operator=(const vtkRUCTwoPointProbability&) = delete;

  void ValidateProperties();
  // Measures by the method; `region` is null for the exact one
  ruc::SampledTwoPoint Measure(const ruc::PackShare& share, const ruc::SamplingRegion* region,
    const ruc::LagGrid& lags, RankCommunicator& ranks, ProgressReport& report) const;
  // Is called on rank 0
  void FillTables(const ruc::SampledTwoPoint& measured, const ruc::PackShare& share,
    vtkInformationVector* outputs) const;
  // Adds field data that tell how the functions were measured, and where they saturate
  void AddSummary(const ruc::TwoPointProbability& probability, const ruc::PackShare& share,
    vtkDataObject* data) const;
  // Adds what the blocks tell, and warns where the pack is not one medium
  void AddErrors(const ruc::TwoPointProbability& probability, const ruc::TwoPointErrors& errors,
    vtkInformationVector* outputs, const RankCommunicator& ranks);
  // Adds field data of numbers that must agree
  void AddConsistency(const ruc::TwoPointProbability& probability, const ruc::PackShare& share,
    vtkTable* table) const;

  int Method = EXACT_PAIR_SUM;
  double MaximumLag = 0.0;
  int NumberOfLags = 277;
  double SaturationTolerance = 0.0005;
  int Blocks = 0;
};

#endif
