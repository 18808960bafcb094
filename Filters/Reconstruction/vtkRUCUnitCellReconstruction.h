// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCUnitCellReconstruction
 * @brief Small periodic cells with the one- and two-point probabilities of a sphere pack
 *
 * Input: a sphere pack with `Mode` (vtkRUCPackAlgorithm), the target; or a table of S_rs with the
 * columns `r`, `S_1_1`, `S_1_2`, … `S_m_m` on equal lags from 0 (from vtkRUCTwoPointProbability, or
 * from any program by way of a file), with the ModeDiameters. The cell is a periodic cube that
 * holds of every mode the nearest whole number of spheres to the target's share, or ModeCounts, all
 * of the mode's volume mean diameter; its edge h_c minimises the difference of the volume
 * fractions, equation (12). The centres minimise
 *
 *     F2 = sum over all ordered pairs of phases of || S_rs of the pack - S_rs of the cell || (13)
 *
 * with the discrete norm over the lags r_1…r_K, not divided by K, and no two spheres overlap,
 * images included (14).
 *
 * Gradient: random centres, overlap pushed out, L-BFGS on the exact F2 and its gradient with an
 * overlap penalty, last overlap removed exactly. Annealed Population: the paper's RECON3D
 * (Core/Reconstruction/PopulationSearch.h). Hybrid: a small population whose best member descends
 * by L-BFGS, then is changed a little and descends again. Several cells are independent searches
 * with the seeds Seed, Seed + 1, …, one on each rank or group of
 * ranks at a time.
 *
 * Outputs, whole on rank 0: 0 the best cell (least F2, without overlap if there is one), a sphere
 * pack with its periodic box and the field data `Objective` (F2), `StartObjective` (F2 of the
 * random start, freed from overlap as far as that went; of a population its mean),
 * `OnePointDifference` (F1, equation 11), `OverlapPercent`, `Iterations` (or generations),
 * `EndedBy` (text), `Stopped` (1 when the search was ended from outside) and `Cell` (its number); 1
 * the table of convergence of the best cell `Iteration`, `Objective`, `OverlapPercent`, where row 0
 * is the start and the last row the cell returned; 2 the table `r`, `S_1_1_pack`, `S_1_1_cell`, …
 * of the best cell, and of several cells `S_1_1_mean`, `S_1_1_deviation` (standard deviation over
 * the cells); 3 a multiblock data set of all cells; 4 a row for each cell, as the paper's Table I:
 * `Cell`, `Seed`, `BeforeMinimum`, `BeforeMean`, `BeforeMaximum`, `AfterMinimum`, `AfterMean`,
 * `AfterMaximum` (F2 over the population; of Gradient that of the start and of the cell),
 * `Iterations`, `OverlapPercent`, `Objective` (F2 of the cell), `DifferencePercent` (equation 17)
 * and `EndedBy`; 5 the comparison of target and mean of the cells by equations 16 and 17, as output
 * 0 of vtkRUCCompareProbabilities.
 *
 * With a CheckpointFile the state of a search is written every CheckpointInterval seconds and at
 * its end, always to a new file that then replaces the last one. A search whose file is there goes
 * on from it, to the same end, bit by bit, on any number of ranks. One that was ended from outside
 * more often than ContinueAfterStops is shown as it was instead; `Stops` is how often that was.
 *
 * Every iteration asks whether to stop: by the time limit, by the stop file, by a
 * vtkRUCStopRequest, or by SetAbortExecute from an observer of progress. The best cells so far are
 * then the output. Equation numbers: Lee et al., Phys. Rev. E 80, 061301 (2009).
 */
#ifndef vtkRUCUnitCellReconstruction_h
#define vtkRUCUnitCellReconstruction_h

#include "CellProperties.h"
#include "CellSearch.h"
#include "RUCReconstructionModule.h"
#include "vtkRUCPackAlgorithm.h"

#include <string>
#include <vector>

class ProgressReport;

/** The setter and the getter of a property that stands at `place`, a setting of the core. */
#define RUCSetting(name, type, place)                                                              \
  void Set##name(type value)                                                                       \
  {                                                                                                \
    if (this->Get##name() != value)                                                                \
    {                                                                                              \
      this->place = value;                                                                         \
      this->Modified();                                                                            \
    }                                                                                              \
  }                                                                                                \
  type Get##name() const                                                                           \
  {                                                                                                \
    return static_cast<type>(this->place);                                                         \
  }

class RUCRECONSTRUCTION_EXPORT vtkRUCUnitCellReconstruction : public vtkRUCPackAlgorithm
{
public:
  static vtkRUCUnitCellReconstruction* New();
  vtkTypeMacro(vtkRUCUnitCellReconstruction, vtkRUCPackAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Methods
  {
    GRADIENT = CellSearch::GRADIENT,
    ANNEALED_POPULATION = CellSearch::ANNEALED_POPULATION,
    HYBRID = CellSearch::HYBRID
  };

  /** How the centres are found. */
  RUCSetting(Method, int, Search.Method);
  /** Independent cells. */
  RUCSetting(NumberOfCells, int, Search.NumberOfCells);
  /** Diameters of the modes' spheres in the cell, one for each mode. Required with a
   * table; with a pack they take the place of its own. Default: none. */
  void ClearModeDiameters();
  void SetModeDiameter(int i, double diameter);
  /** Spheres of every mode in the cell, each >= 1, in place of CellSize and NumberOfParticles.
   * Default: none. */
  void ClearModeCounts();
  void SetModeCount(int i, int count);
  /** Spheres in the cell, at least one of every mode. Default: 0, from CellSize. */
  RUCSetting(NumberOfParticles, int, Cell.NumberOfParticles);
  /** First guess h_0 of the cell's edge. Default: 0, twice the saturation length of the pack's
   * S_rs. */
  RUCSetting(CellSize, double, Cell.CellSize);
  /** The last lag of F2. Default: 0, half the cell's edge. Limits as in vtkRUCTwoPointProbability.
   */
  RUCSetting(MaximumLag, double, Cell.MaximumLag);
  /** K, the number of lags after 0. */
  RUCSetting(NumberOfLags, int, Cell.NumberOfLags);
  /** Tolerance of the saturation length, as in vtkRUCTwoPointProbability;. */
  RUCSetting(SaturationTolerance, double, Cell.SaturationTolerance);
  /** Iterations of L-BFGS. The search ends before when F2 no longer falls by
   * 0.1 % in 100 iterations. */
  RUCSetting(MaximumIterations, int, Search.Gradient.MaximumIterations);
  /** The search ends when a cell without overlap has F2 at or below this;. */
  RUCSetting(TargetObjective, double, Search.Gradient.TargetObjective);
  /** Seconds after which the search ends with the best cell so far; >= 0. Default: 0, no limit. */
  vtkSetMacro(TimeLimit, double);
  vtkGetMacro(TimeLimit, double);
  /** The search ends with the best cell so far once a file of this name exists where rank 0 runs.
   * Default: empty. */
  vtkSetStdStringFromCharMacro(StopFile);
  vtkGetCharFromStdStringMacro(StopFile);
  /** Seed of all random numbers. Cell n has Seed + n - 1. */
  RUCSetting(Seed, int, Search.Gradient.Seed);
  /** File that holds the state of the search where rank 0 runs; of several cells one each, with .1,
   * .2, … after this name. Default: empty, none. */
  void SetCheckpointFile(const char* name);
  const char* GetCheckpointFile() const { return this->Search.CheckpointFile.c_str(); }
  /** Seconds between two states that are written. */
  RUCSetting(CheckpointInterval, double, Search.CheckpointInterval);
  /** A search that was ended from outside more often than this is shown as it was, from its
   * checkpoint; else it goes on. Default: 0; -1: it always goes on. */
  RUCSetting(ContinueAfterStops, int, Search.ContinueAfterStops);

  // Annealed Population, and the last four before the weights of Hybrid. Defaults and ranges stand
  // in Core/Reconstruction/Population/PopulationSettings.h.
  /** N_i, individuals. */
  RUCSetting(Population, int, Search.Annealed.Population);
  /** Share of the first population at random; the others by ballistic deposition. */
  RUCSetting(RandomShare, double, Search.Annealed.RandomShare);
  /** Overlap (a + b - d) / (a + b) that the ballistic deposition allows. */
  RUCSetting(DepositionDegree, double, Search.Annealed.DepositionDegree);
  /** m, individuals in the mating pool. */
  RUCSetting(MatingPool, int, Search.Annealed.MatingPool);
  /**. */
  RUCSetting(MaximumGenerations, int, Search.Annealed.MaximumGenerations);
  /** Generations without a better best individual that end the search. */
  RUCSetting(PatienceGenerations, int, Search.Annealed.PatienceGenerations);
  /** Expected copies of the best individual in the roulette by rank. */
  RUCSetting(SelectionPressure, double, Search.Annealed.SelectionPressure);
  /** Overlap in percent at which the penalty p of equation (15) is 1/2. */
  RUCSetting(HalfOverlap, double, Search.Annealed.HalfOverlap);
  /** Share of the spheres that an operator on some of them changes. */
  RUCSetting(MutatedShare, double, Search.Annealed.MutatedShare);
  /** b of the non-uniform mutations. */
  RUCSetting(MutationShape, double, Search.Annealed.MutationShape);
  /** Longest step of the non-uniform mutations in half edges. */
  RUCSetting(MutationReach, double, Search.Annealed.MutationReach);
  /** G of the non-uniform mutations. */
  RUCSetting(MutationGenerations, int, Search.Annealed.MutationGenerations);
  /** Probability of the mass-spring mutation of a child. */
  RUCSetting(MassSpringProbability, double, Search.Annealed.MassSpringProbability);
  /** T of the acceptance, in units of the fitness. */
  RUCSetting(InitialTemperature, double, Search.Annealed.InitialTemperature);
  /** Factor of T in a generation. */
  RUCSetting(CoolingFactor, double, Search.Annealed.CoolingFactor);
  /** Generations without a better best individual after which T is the initial one again. */
  RUCSetting(ReheatingGenerations, int, Search.Annealed.ReheatingGenerations);
  /** Individuals of Hybrid. */
  RUCSetting(HybridPopulation, int, Search.Hybrid.Population);
  /** Individuals in the mating pool of Hybrid. */
  RUCSetting(HybridMatingPool, int, Search.Hybrid.MatingPool);
  /** MutationReach of Hybrid. */
  RUCSetting(HybridMutationReach, double, Search.Hybrid.MutationReach);
  /** Steps of L-BFGS of Hybrid at a time. */
  RUCSetting(RefinementSteps, int, Search.Hybrid.RefinementSteps);
  /**
   * Eight weights, >= 0, by which one of the operators is drawn: uniform, boundary, non-uniform and
   * multi-non-uniform mutation, simple, simple arithmetic, whole arithmetic and heuristic
   * crossover. Default: 1 each.
   */
  void ClearOperatorWeights();
  void SetOperatorWeight(int i, double weight);

protected:
  vtkRUCUnitCellReconstruction();
  ~vtkRUCUnitCellReconstruction() override = default;
  const char* GetLabel() const override { return "Unit Cell Reconstruction"; }
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  void Execute(
    vtkInformationVector** inputs, vtkInformationVector* outputs, RankCommunicator& ranks) override;
  void Execute(vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks) override;
  /** At most: to the last iteration or generation, or the time limit. */
  std::optional<ruc::Estimate> MakeEstimate() override;

private:
  vtkRUCUnitCellReconstruction(const vtkRUCUnitCellReconstruction&) = delete;
  void operator=(const vtkRUCUnitCellReconstruction&) = delete;

  void CheckProperties() const;
  // Twice the saturation length, or with a warning the last lag
  double FindEdge(
    const ruc::TwoPointProbability& probability, double diameter, RankCommunicator& ranks);
  // Why the search should end now, for a reason from outside; all but the time only rank 0 knows
  ruc::EndReason FindStopReason(const ProgressReport& report, bool isFirstRank);
  // Searches, and fills the outputs
  void Reconstruct(const ruc::CellContents& contents, const ruc::TwoPointProbability& target,
    const std::string& lengthUnit, vtkInformationVector* outputs, RankCommunicator& ranks,
    ProgressReport& report);

  CellProperties Cell;
  CellSearch::Settings Search;
  int NumberOfOperatorWeights = ruc::NumberOfGeneticOperators; // given, of which as many are kept
  double TimeLimit = 0.0;
  std::string StopFile;
};

#endif
