// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCThreePointProbability
 * @brief Three-point probability functions S_rsq(r1, r2, theta) of a sphere pack
 *
 * Input: a sphere pack with `Mode` (vtkRUCPackAlgorithm) and an optional mask
 * (vtkRUCRegionAlgorithm). S_rsq(r1, r2, theta) is the probability that a point x lies in phase r,
 * x + r1 u in phase s and x + r2 v in phase q, where theta is the angle between the directions u
 * and v, averaged over x and over the orientation of the plane of u and v. Phases are the modes
 * 1…N_p and the matrix m. The normalisation is raw: S_rrr(0, 0, .) = c_r. S_rqs(r1, r2) = S_rsq(r2,
 * r1).
 *
 * A throw is a random point and a random plane with NumberOfDirections rays spaced evenly around a
 * circle, which are traced through the spheres. All pairs of points on all pairs of rays count
 * (Core/Statistics/Sampling/FanSampling.h). Overlaps count once.
 *
 * Output 0 is an image over (r1, r2, theta), in slabs over the ranks, with the spacing (lag
 * spacing, lag spacing, 360 / NumberOfDirections in degrees). It has an array `S_3_5_5` for each
 * triple and, with StandardErrors, `S_3_5_5_error`, an absolute probability as well. The other
 * outputs are tables, whole on rank 0.
 *
 * Output 1 has the limits (10): `r` and, for each triple, `S_3_5_5_r1_axis` (r2 = 0),
 * `S_3_5_5_r2_axis` (r1 = 0) and `S_3_5_5_diagonal` (r1 = r2 at theta = 0), each followed by
 * `…_limit`, which is a two-point function or 0, and, with StandardErrors, by `…_error`.
 *
 * Output 2 has the checks, a row for each triple and limit: `Triple`, `Place`, `Limit`,
 * `Difference` (the discrete norm of S_rsq - limit over the lags k = 1…K; for the place "far
 * apart", where both points are at the last lag in opposite directions, the magnitude of the
 * difference) and, with StandardErrors, `StandardError` (the norm of the standard errors).
 *
 * Output 3 has the third-order parameters of every triple r = s = q
 * (Core/Statistics/ThirdOrder/ThirdOrderParameters.h): `Phase` (m, and all but m),
 * `VolumeFraction`, `zeta`, `eta` and, with StandardErrors, `zeta_error` and `eta_error`.
 *
 * Output 4, if Multipoles is on, has the three-point functions around centres of spheres that do
 * not overlap, without sampling (Core/Statistics/ThirdOrder/NeighbourhoodMultipoles.h): classes
 * `r`, `s`
 * <= `q` from 1, degree `l`, `Distance1`, `Distance2` from the surface of the sphere in the middle,
 * `T` and `T_error`. The sum over l of T P_l(cos theta) is the probability that two points at these
 * distances from a sphere of class r, and at the angle theta around its centre, lie in spheres of
 * the classes s and q. Field data `ClassOfMode` and `NumberOfCentres` (of each class).
 *
 * The two-point functions of the limits are those of the exact pair sum, or, where spheres overlap
 * and with a mask, of Chord Sampling of the same region with 20 000 lines. Field data `LimitMethod`
 * says which. Equation 10 is that of Lee et al., Phys. Rev. E 80, 061301 (2009).
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
struct NeighbourhoodSettings;
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
    THIRD_ORDER = 3,
    MULTIPOLES = 4
  };

  ///@{
  /**
   * The triples of phases, such as "3 5 5; 7 7 5; m m m", or "all" (every r and s <= q). Default:
   * "m m m".
   */
  vtkSetStdStringFromCharMacro(Phases);
  vtkGetCharFromStdStringMacro(Phases);
  ///@}
  ///@{
  /**
   * The last lag of r1 and r2. Default: 0, which stands for a quarter of the shortest edge of the
   * window (of a cylinder, of the lesser of diameter and height; half of it where all axes are
   * periodic), or for the largest lag there is if that is less. The largest lag is half of the
   * shortest edge less twice the margin, or four shortest edges of a fully periodic box.
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
  /**
   * The number of rays around a circle, 2 to 512; theta goes in steps of 360 / NumberOfDirections
   * degrees. An even number >= 8 gives third-order parameters. Default: 40, steps of 9 degrees.
   */
  vtkSetMacro(NumberOfDirections, int);
  vtkGetMacro(NumberOfDirections, int);
  ///@}
  ///@{
  /** The number of throws, >= 1. Default: 50 000. */
  vtkSetMacro(NumberOfThrows, int);
  vtkGetMacro(NumberOfThrows, int);
  ///@}
  ///@{
  /** Whether standard errors are wanted. They take about twice the memory. Default: off. */
  vtkSetMacro(StandardErrors, bool);
  vtkGetMacro(StandardErrors, bool);
  vtkBooleanMacro(StandardErrors, bool);
  ///@}
  ///@{
  /**
   * Whether output 4 is filled. It takes spheres that do not overlap, and no mask. Otherwise the
   * table has one row, a `Note` that says so. Default: off.
   */
  vtkSetMacro(Multipoles, bool);
  vtkGetMacro(Multipoles, bool);
  vtkBooleanMacro(Multipoles, bool);
  ///@}
  ///@{
  /**
   * The number of classes of output 4, 1 to 4: modes are put into at most so many, of about equal
   * volume, the smallest spheres first. Default: 1.
   */
  vtkSetMacro(MultipoleClasses, int);
  vtkGetMacro(MultipoleClasses, int);
  ///@}
  ///@{
  /** The highest degree l of output 4, 0 to 13. Default: 8. */
  vtkSetMacro(MultipoleDegree, int);
  vtkGetMacro(MultipoleDegree, int);
  ///@}
  /**
   * The distances of output 4, at most 32, > 0, ascending. Default: none, which stands for twelve
   * from 0.04 to 1.44 mean diameters.
   */
  void ClearMultipoleDistances();
  void SetMultipoleDistance(int i, double distance);

  /**
   * What a rank would use, in megabytes of 10^6 bytes, with the properties as they are, in a region
   * with a border (a fully periodic box takes a little less). "all" counts for the modes of the
   * input as it was last updated. It is 0 where it is not known.
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
  /** The memory of the mask. That of counts and image is checked once the triples are known. */
  double GetMemoryToCheck() override;

private:
  vtkRUCThreePointProbability(const vtkRUCThreePointProbability&) = delete;
  void operator=(const vtkRUCThreePointProbability&) = delete;

  // The megabytes of a rank
  double EstimateMemory(std::size_t triples, bool bounded, int ranks) const;
  // The megabytes of a rank for the exact pair sum that the limits are of
  double EstimateLimits(const ruc::LagGrid& lags);
  // The lags of an estimate
  ruc::LagGrid MakeLags(const ruc::PackFigures& pack) const;
  // Returns the lags, also where they are automatic, and the angles
  ruc::ThreePointGrid FindGrid(const ruc::PackShare& share, const ruc::SamplingRegion& region);
  ruc::FanSettings MakeSettings() const;
  // Refuses what cannot be done or would take more than MemoryLimit, and returns what it takes
  double CheckWork(const ruc::SamplingRegion& region, const ruc::ThreePointGrid& grid,
    std::size_t triples, const RankCommunicator& ranks);
  ruc::ThreePointProbability Sample(const ruc::PackShare& share, const ruc::SamplingRegion& region,
    const ruc::ThreePointGrid& grid, const std::vector<ruc::PhaseTriple>& triples, double memory,
    RankCommunicator& ranks, ProgressReport& report) const;
  bool WasStopped(const ruc::ThreePointProbability& probability) const;
  // Adds field data that tell how the functions were measured
  void AddSummary(const ruc::ThreePointProbability& probability, bool exact, double memory,
    vtkDataObject* data) const;
  // Measures the two-point functions of the limits
  ruc::TwoPointProbability MeasureTwoPoint(const PackData::SharedPack& pack, bool exact,
    const ruc::SamplingRegion& region, const ruc::LagGrid& lags, RankCommunicator& ranks,
    ProgressReport& report) const;
  void FillImage(const ruc::ThreePointProbability& probability, vtkInformationVector* outputs,
    const RankCommunicator& ranks) const;
  ruc::NeighbourhoodSettings FindMultipoleSettings() const;
  void FillMultipoles(
    const ruc::PackShare& share, vtkInformationVector* outputs, RankCommunicator& ranks);

  std::string Phases = "m m m";
  double MaximumLag = 0.0;
  int NumberOfLags = 277;
  int NumberOfDirections = 40;
  int NumberOfThrows = 50000;
  bool StandardErrors = false;
  bool Multipoles = false;
  int MultipoleClasses = 1;
  int MultipoleDegree = 8;
  std::vector<double> MultipoleDistances;
};

#endif
