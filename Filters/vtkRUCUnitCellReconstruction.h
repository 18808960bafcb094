// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCUnitCellReconstruction
 * @brief A small periodic cell with the one- and two-point probabilities of a sphere pack
 *
 * Input: a sphere pack with `Mode` (vtkRUCPackAlgorithm), the target. The cell is a periodic cube
 * that holds of every mode the nearest whole number of spheres to the pack's share, all of the
 * mode's volume mean diameter; its edge h_c minimises the difference of the volume fractions,
 * equation (12). The centres minimise
 *
 *     F2 = sum over all ordered pairs of phases of || S_rs of the pack - S_rs of the cell || (13)
 *
 * with the discrete norm over the lags r_1…r_K, not divided by K, and no two spheres overlap,
 * images included (14). Gradient: random centres, overlap pushed out, L-BFGS on the exact F2 and
 * its gradient with an overlap penalty, last overlap removed exactly.
 *
 * Outputs, whole on rank 0: 0 the cell, a sphere pack with its periodic box and the field data
 * `Objective` (F2), `StartObjective` (F2 of the random start, freed from overlap as far as that
 * went), `OnePointDifference` (F1, equation 11), `OverlapPercent`, `Iterations`, `EndedBy` (text)
 * and `Stopped` (1 when the search was ended from outside); 1 the table of convergence `Iteration`,
 * `Objective`, `OverlapPercent`, where row 0 is the random start and the last row the cell
 * returned; 2 the table `r`, `S_1_1_pack`, `S_1_1_cell`, ….
 *
 * Every iteration asks whether to stop: by the time limit, by the stop file, or by SetAbortExecute
 * from an observer of progress. The best cell so far is then the output. Equation numbers: Lee et
 * al., Phys. Rev. E 80, 061301 (2009).
 */
#ifndef vtkRUCUnitCellReconstruction_h
#define vtkRUCUnitCellReconstruction_h

#include "vtkRUCPackAlgorithm.h"

#include <string>

namespace ruc
{
struct CellContents;
struct PackShare;
struct LagGrid;
struct TwoPointProbability;
struct UnitCell;
}
class ProgressReport;

class RUCFILTERS_EXPORT vtkRUCUnitCellReconstruction : public vtkRUCPackAlgorithm
{
public:
  static vtkRUCUnitCellReconstruction* New();
  vtkTypeMacro(vtkRUCUnitCellReconstruction, vtkRUCPackAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Methods
  {
    GRADIENT = 0
  };

  ///@{
  /** How the centres are found. Default and only choice: GRADIENT. */
  vtkSetMacro(Method, int);
  vtkGetMacro(Method, int);
  ///@}
  ///@{
  /** Spheres in the cell, at least one of every mode. Default: 0, from CellSize. */
  vtkSetMacro(NumberOfParticles, int);
  vtkGetMacro(NumberOfParticles, int);
  ///@}
  ///@{
  /** First guess h_0 of the cell's edge. Default: 0, twice the saturation length of the pack's
   * S_rs. */
  vtkSetMacro(CellSize, double);
  vtkGetMacro(CellSize, double);
  ///@}
  ///@{
  /** The last lag of F2. Default: 0, half the cell's edge. Limits as in vtkRUCTwoPointProbability.
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
  /** Tolerance of the saturation length, as in vtkRUCTwoPointProbability; > 0. Default: 0.0005. */
  vtkSetMacro(SaturationTolerance, double);
  vtkGetMacro(SaturationTolerance, double);
  ///@}
  ///@{
  /** Iterations of L-BFGS, >= 0. Default: 1000. The search ends before when F2 no longer falls by
   * 0.1 % in 100 iterations. */
  vtkSetMacro(MaximumIterations, int);
  vtkGetMacro(MaximumIterations, int);
  ///@}
  ///@{
  /** The search ends when a cell without overlap has F2 at or below this; >= 0. Default: 0. */
  vtkSetMacro(TargetObjective, double);
  vtkGetMacro(TargetObjective, double);
  ///@}
  ///@{
  /** Seconds after which the search ends with the best cell so far; >= 0. Default: 0, no limit. */
  vtkSetMacro(TimeLimit, double);
  vtkGetMacro(TimeLimit, double);
  ///@}
  ///@{
  /** The search ends with the best cell so far once a file of this name exists where rank 0 runs.
   * Default: empty. */
  vtkSetStdStringFromCharMacro(StopFile);
  vtkGetCharFromStdStringMacro(StopFile);
  ///@}
  ///@{
  /** Seed of the random start; >= 0. Default: 1. */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

protected:
  vtkRUCUnitCellReconstruction();
  ~vtkRUCUnitCellReconstruction() override = default;
  const char* GetLabel() const override { return "Unit Cell Reconstruction"; }
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  void Execute(vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks) override;

private:
  vtkRUCUnitCellReconstruction(const vtkRUCUnitCellReconstruction&) = delete;
  void operator=(const vtkRUCUnitCellReconstruction&) = delete;

  void ValidateProperties() const;
  ruc::CellContents FindContents(
    const ruc::PackShare& pack, RankCommunicator& ranks, ProgressReport& report);
  // Why the search should end now: empty, "Time limit", "Stop file" or "Abort"
  std::string FindStopReason(const ProgressReport& report);

  int Method = GRADIENT;
  int NumberOfParticles = 0;
  double CellSize = 0.0;
  double MaximumLag = 0.0;
  int NumberOfLags = 277;
  double SaturationTolerance = 0.0005;
  int MaximumIterations = 1000;
  double TargetObjective = 0.0;
  double TimeLimit = 0.0;
  std::string StopFile;
  int Seed = 1;
};

#endif
