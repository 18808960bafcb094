// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCThreePointProbability
 * @brief Three-point probability functions S_rsq(r1, r2, theta) of a sphere pack
 *
 * Input: a sphere pack with `Mode` (vtkRUCPackAlgorithm) and an optional mask
 * (vtkRUCRegionAlgorithm). S_rsq(r1, r2, theta) is the probability that a point x lies in phase r,
 * x + r1 u in phase s and x + r2 v in phase q, theta being the angle between the directions u and
 * v, averaged over x and over the orientation of the plane of u and v; phases are the modes 1…N_p
 * and the matrix m. Raw normalisation: S_rrr(0, 0, .) = c_r. S_rqs(r1, r2) = S_rsq(r2, r1).
 *
 * A throw is a random point and a random plane with NumberOfDirections rays evenly around a circle,
 * which are traced through the spheres; all pairs of points on all pairs of rays count
 * (Core/Statistics/FanSampling.h). Overlaps count once.
 *
 * Outputs: 0 an image over (r1, r2, theta), spacing (lag spacing, lag spacing, 360 / directions in
 * degrees), with an array `S_3_5_5` for each triple and, with StandardErrors, `S_3_5_5_error`; in
 * slabs over the ranks. Tables, whole on rank 0: 1 limits (10): `r` and, for each triple,
 * `S_3_5_5_r1_axis` (r2 = 0), `S_3_5_5_r2_axis` (r1 = 0) and `S_3_5_5_diagonal` (r1 = r2 at theta =
 * 0), each followed by `…_limit`, which is a two-point function or 0, and `…_error`; 2 checks, a
 * row for each triple and limit: `Triple`, `Place`, `Limit`, `Difference` (discrete norm over the
 * lags k = 1…K of S_rsq - limit; for the place "far apart", both points at the last lag in opposite
 * directions, the magnitude of the difference) and with StandardErrors `StandardError` (norm of the
 * standard errors); 3 third-order parameters of every triple r = s = q: `Phase` (m, and all but m),
 * `VolumeFraction`, `zeta`, `eta`, `zeta_error`, `eta_error`
 * (Core/Statistics/ThirdOrderParameters.h).
 *
 * The two-point functions of the limits are the exact pair sum; where spheres overlap, and with a
 * mask, Chord Sampling of the same region with 20 000 lines. Field data `LimitMethod` says which.
 * Equation 10 is that of Lee et al., Phys. Rev. E 80, 061301 (2009).
 */
#ifndef vtkRUCThreePointProbability_h
#define vtkRUCThreePointProbability_h

#include "RUCStatisticsModule.h"
#include "vtkRUCRegionAlgorithm.h"

#include <string>
#include <vector>

class ProgressReport;
namespace ruc
{
struct FanSettings;
struct LagGrid;
struct PackShare;
struct PhaseTriple;
struct ThreePointGrid;
struct TwoPointProbability;
class ThreePointProbability;
}

class RUCSTATISTICS_EXPORT vtkRUCThreePointProbability : public vtkRUCRegionAlgorithm
{
public:
  static vtkRUCThreePointProbability* New();
  vtkTypeMacro(vtkRUCThreePointProbability, vtkRUCRegionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Ports
  {
    PROBABILITIES = 0,
    LIMITS = 1,
    CHECKS = 2,
    THIRD_ORDER = 3
  };

  ///@{
  /** Triples of phases such as "3 5 5; 7 7 5; m m m", or "all" (every r and s <= q). Default: "m m
   * m". */
  vtkSetStdStringFromCharMacro(Phases);
  vtkGetCharFromStdStringMacro(Phases);
  ///@}
  ///@{
  /**
   * The last lag of r1 and r2. Default: 0, a quarter of the shortest edge of the window (of a
   * cylinder: of the lesser of diameter and height; half of it where all axes are periodic), or the
   * largest lag there is: half of the shortest edge less twice the margin; four shortest edges of a
   * fully periodic box.
   */
  vtkSetMacro(MaximumLag, double);
  vtkGetMacro(MaximumLag, double);
  ///@}
  ///@{
  /** K, the number of lags after 0; 1 to 20 000. Default: 277. */
  vtkSetMacro(NumberOfLags, int);
  vtkGetMacro(NumberOfLags, int);
  ///@}
  ///@{
  /** Rays around a circle, 2 to 512: theta goes in steps of 360 / this. An even number >= 8 gives
   * third-order parameters. Default: 20, steps of 18 degrees. */
  vtkSetMacro(NumberOfDirections, int);
  vtkGetMacro(NumberOfDirections, int);
  ///@}
  ///@{
  /** Throws, >= 1. Default: 50 000. */
  vtkSetMacro(NumberOfThrows, int);
  vtkGetMacro(NumberOfThrows, int);
  ///@}
  ///@{
  /** Whether standard errors are wanted; they take three times the memory. Default: off. */
  vtkSetMacro(StandardErrors, bool);
  vtkGetMacro(StandardErrors, bool);
  vtkBooleanMacro(StandardErrors, bool);
  ///@}

  /**
   * What a rank would use, in megabytes of 10^6 bytes, with the properties as they are, in a region
   * with a border (a fully periodic box takes a little less); "all" counts for the modes of the
   * input as it was last updated. 0 where that is not known.
   */
  double GetEstimatedMemory() override;

protected:
  vtkRUCThreePointProbability();
  ~vtkRUCThreePointProbability() override = default;
  const char* GetLabel() const override { return "Three-Point Probability"; }
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;
  void Execute(vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks) override;
  std::optional<ruc::Estimate> MakeEstimate() override;
  /** The mask's; that of counts and image is checked once the triples are known. */
  double GetMemoryToCheck() override;

private:
  vtkRUCThreePointProbability(const vtkRUCThreePointProbability&) = delete;
  void operator=(const vtkRUCThreePointProbability&) = delete;

  // Megabytes a rank
  double EstimateMemory(std::size_t triples, bool bounded, int ranks) const;
  // The lags, also where they are automatic, and the angles
  ruc::ThreePointGrid FindGrid(const ruc::PackShare& share, const ruc::SamplingRegion& region);
  ruc::FanSettings MakeSettings() const;
  // Refuses what cannot be done or would take more than MemoryLimit; returns what it takes
  double CheckWork(const ruc::SamplingRegion& region, const ruc::ThreePointGrid& grid,
    std::size_t triples, const RankCommunicator& ranks);
  ruc::ThreePointProbability Sample(const ruc::PackShare& share, const ruc::SamplingRegion& region,
    const ruc::ThreePointGrid& grid, const std::vector<ruc::PhaseTriple>& triples, double memory,
    RankCommunicator& ranks, ProgressReport& report) const;
  bool WasStopped(const ruc::ThreePointProbability& probability) const;
  // How the functions were measured, as field data
  void AddSummary(const ruc::ThreePointProbability& probability, bool exact, double memory,
    vtkDataObject* data) const;
  // For the limits
  ruc::TwoPointProbability MeasureTwoPoint(const PackData::SharedPack& pack, bool exact,
    const ruc::SamplingRegion& region, const ruc::LagGrid& lags, RankCommunicator& ranks,
    ProgressReport& report) const;
  void FillImage(const ruc::ThreePointProbability& probability, vtkInformationVector* outputs,
    const RankCommunicator& ranks) const;

  std::string Phases = "m m m";
  double MaximumLag = 0.0;
  int NumberOfLags = 277;
  int NumberOfDirections = 20;
  int NumberOfThrows = 50000;
  bool StandardErrors = false;
};

#endif
