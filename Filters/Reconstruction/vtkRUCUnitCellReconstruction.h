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
 * on from it, to the same end, bit by bit, on any number of ranks.
 *
 * Every iteration asks whether to stop: by the time limit, by the stop file, by a
 * vtkRUCStopRequest, or by SetAbortExecute from an observer of progress. The best cells so far are
 * then the output. Equation numbers: Lee et al., Phys. Rev. E 80, 061301 (2009).
 */
#ifndef vtkRUCUnitCellReconstruction_h
#define vtkRUCUnitCellReconstruction_h

#include "RUCReconstructionModule.h"
#include "vtkRUCPackAlgorithm.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

class ProgressReport;
namespace CellSearch
{
struct FoundCell;
struct Settings;
}
namespace ruc
{
struct CellContents;
struct CellFigures;
struct LagGrid;
struct ModeAmounts;
struct TwoPointProbability;
enum class EndReason : std::uint8_t;
}

class RUCRECONSTRUCTION_EXPORT vtkRUCUnitCellReconstruction : public vtkRUCPackAlgorithm
{
public:
  static vtkRUCUnitCellReconstruction* New();
  vtkTypeMacro(vtkRUCUnitCellReconstruction, vtkRUCPackAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Methods
  {
    GRADIENT = 0,
    ANNEALED_POPULATION = 1,
    HYBRID = 2
  };

  ///@{
  /** How the centres are found. Default: GRADIENT. */
  vtkSetMacro(Method, int);
  vtkGetMacro(Method, int);
  ///@}
  ///@{
  /** Independent cells, >= 1. Default: 1. */
  vtkSetMacro(NumberOfCells, int);
  vtkGetMacro(NumberOfCells, int);
  ///@}
  ///@{
  /** Diameters of the modes' spheres in the cell, each > 0, one for each mode. Required with a
   * table; with a pack they take the place of its own. Default: none. */
  void ClearModeDiameters();
  void SetModeDiameter(int i, double diameter);
  ///@}
  ///@{
  /** Spheres of every mode in the cell, each >= 1, in place of CellSize and NumberOfParticles.
   * Default: none. */
  void ClearModeCounts();
  void SetModeCount(int i, int count);
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
  /** Seed of all random numbers; >= 0. Cell n has Seed + n - 1. Default: 1. */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}
  ///@{
  /** File that holds the state of the search where rank 0 runs; of several cells one each, with .1,
   * .2, … after this name. Default: empty, none. */
  vtkSetStdStringFromCharMacro(CheckpointFile);
  vtkGetCharFromStdStringMacro(CheckpointFile);
  ///@}
  ///@{
  /** Seconds between two states that are written, >= 0. Default: 60. */
  vtkSetMacro(CheckpointInterval, double);
  vtkGetMacro(CheckpointInterval, double);
  ///@}

  // Annealed Population, with the paper's numbers as defaults where it gives one; the last four of
  // Hybrid. See Core/Reconstruction/PopulationSearch.h.
  ///@{
  /** N_i, individuals, >= 2. Default: 512. */
  vtkSetMacro(Population, int);
  vtkGetMacro(Population, int);
  ///@}
  ///@{
  /** Share of the first population at random; the others by ballistic deposition. In [0, 1].
   * Default: 0.5. */
  vtkSetMacro(RandomShare, double);
  vtkGetMacro(RandomShare, double);
  ///@}
  ///@{
  /** Overlap (a + b - d) / (a + b) that the ballistic deposition allows, in [0, 1]. Default: 0.25.
   */
  vtkSetMacro(DepositionDegree, double);
  vtkGetMacro(DepositionDegree, double);
  ///@}
  ///@{
  /** m, individuals in the mating pool, 1 to Population. Default: 16. */
  vtkSetMacro(MatingPool, int);
  vtkGetMacro(MatingPool, int);
  ///@}
  ///@{
  /** >= 0. Default: 10 000. */
  vtkSetMacro(MaximumGenerations, int);
  vtkGetMacro(MaximumGenerations, int);
  ///@}
  ///@{
  /** Generations without a better best individual that end the search, >= 1. Default: 300. */
  vtkSetMacro(PatienceGenerations, int);
  vtkGetMacro(PatienceGenerations, int);
  ///@}
  ///@{
  /** Expected copies of the best individual in the roulette by rank, in [1, 2]. Default: 1.5. */
  vtkSetMacro(SelectionPressure, double);
  vtkGetMacro(SelectionPressure, double);
  ///@}
  ///@{
  /** Overlap in percent at which the penalty p of equation (15) is 1/2, > 0. Default: 1. */
  vtkSetMacro(HalfOverlap, double);
  vtkGetMacro(HalfOverlap, double);
  ///@}
  ///@{
  /** Share of the spheres that an operator on some of them changes, in (0, 1]. Default: 0.01. */
  vtkSetMacro(MutatedShare, double);
  vtkGetMacro(MutatedShare, double);
  ///@}
  ///@{
  /** b of the non-uniform mutations, >= 0. Default: 2. */
  vtkSetMacro(MutationShape, double);
  vtkGetMacro(MutationShape, double);
  ///@}
  ///@{
  /** Longest step of the non-uniform mutations in half edges, in (0, 1]. Default: 1. */
  vtkSetMacro(MutationReach, double);
  vtkGetMacro(MutationReach, double);
  ///@}
  ///@{
  /** G of the non-uniform mutations, >= 1. Default: 10 000. */
  vtkSetMacro(MutationGenerations, int);
  vtkGetMacro(MutationGenerations, int);
  ///@}
  ///@{
  /** Probability of the mass-spring mutation of a child, in [0, 1]. Default: 0.9. */
  vtkSetMacro(MassSpringProbability, double);
  vtkGetMacro(MassSpringProbability, double);
  ///@}
  ///@{
  /** T of the acceptance, in units of the fitness, > 0. Default: 0.001. */
  vtkSetMacro(InitialTemperature, double);
  vtkGetMacro(InitialTemperature, double);
  ///@}
  ///@{
  /** Factor of T in a generation, in (0, 1]. Default: 0.98. */
  vtkSetMacro(CoolingFactor, double);
  vtkGetMacro(CoolingFactor, double);
  ///@}
  ///@{
  /** Generations without a better best individual after which T is the initial one again, >= 1.
   * Default: 100. */
  vtkSetMacro(ReheatingGenerations, int);
  vtkGetMacro(ReheatingGenerations, int);
  ///@}
  ///@{
  /** Individuals of Hybrid, >= 2. Default: 16. */
  vtkSetMacro(HybridPopulation, int);
  vtkGetMacro(HybridPopulation, int);
  ///@}
  ///@{
  /** Individuals in the mating pool of Hybrid, 1 to HybridPopulation. Default: 1. */
  vtkSetMacro(HybridMatingPool, int);
  vtkGetMacro(HybridMatingPool, int);
  ///@}
  ///@{
  /** MutationReach of Hybrid, in (0, 1]. Default: 0.1. */
  vtkSetMacro(HybridMutationReach, double);
  vtkGetMacro(HybridMutationReach, double);
  ///@}
  ///@{
  /** Steps of L-BFGS of Hybrid at a time, >= 1. Default: 100. */
  vtkSetMacro(RefinementSteps, int);
  vtkGetMacro(RefinementSteps, int);
  ///@}
  ///@{
  /**
   * Eight weights, >= 0, by which one of the operators is drawn: uniform, boundary, non-uniform and
   * multi-non-uniform mutation, simple, simple arithmetic, whole arithmetic and heuristic
   * crossover. Default: 1 each.
   */
  void ClearOperatorWeights();
  void SetOperatorWeight(int i, double weight);
  ///@}

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
  ruc::Estimate MakeEstimate() override;

private:
  vtkRUCUnitCellReconstruction(const vtkRUCUnitCellReconstruction&) = delete;
  void operator=(const vtkRUCUnitCellReconstruction&) = delete;

  void ValidateProperties() const;
  // The spheres, density and sizes of a cell, and `input`, the work on the pack before the search
  ruc::CellFigures FindCellFigures(ruc::LagGrid& lags, ruc::Estimate& input);
  ruc::ModeAmounts FindAmounts(const ruc::ModeAmounts& ofInput) const;
  // `findEdge` is called when nothing else tells the size
  ruc::CellContents FindContents(
    const ruc::ModeAmounts& amounts, const std::function<double()>& findEdge) const;
  // Twice the saturation length, or with a warning the last lag
  double FindEdge(
    const ruc::TwoPointProbability& probability, double diameter, RankCommunicator& ranks);
  CellSearch::Settings GetSearchSettings() const;
  // Why the search should end now, for a reason from outside
  ruc::EndReason FindStopReason(const ProgressReport& report);
  // Searches, and fills the outputs
  void Reconstruct(const ruc::CellContents& contents, const ruc::TwoPointProbability& target,
    const std::string& lengthUnit, vtkInformationVector* outputs, RankCommunicator& ranks,
    ProgressReport& report);
  void FillOutputs(const std::vector<CellSearch::FoundCell>& cells, std::size_t best,
    const ruc::CellContents& contents, const ruc::TwoPointProbability& target,
    const std::string& lengthUnit, vtkInformationVector* outputs, RankCommunicator& ranks);
  void AddCellFields(vtkDataObject* data, const CellSearch::FoundCell& found,
    const ruc::CellContents& contents, const ruc::TwoPointProbability& target,
    const std::string& lengthUnit) const;

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
  int NumberOfCells = 1;
  std::vector<double> ModeDiameters;
  std::vector<int> ModeCounts;
  std::string CheckpointFile;
  double CheckpointInterval = 60.0;
  int Population = 512;
  double RandomShare = 0.5;
  double DepositionDegree = 0.25;
  int MatingPool = 16;
  int MaximumGenerations = 10000;
  int PatienceGenerations = 300;
  double SelectionPressure = 1.5;
  double HalfOverlap = 1.0;
  double MutatedShare = 0.01;
  double MutationShape = 2.0;
  double MutationReach = 1.0;
  int MutationGenerations = 10000;
  double MassSpringProbability = 0.9;
  double InitialTemperature = 1e-3;
  double CoolingFactor = 0.98;
  int ReheatingGenerations = 100;
  int HybridPopulation = 16;
  int HybridMatingPool = 1;
  double HybridMutationReach = 0.1;
  int RefinementSteps = 100;
  std::vector<double> OperatorWeights = { 1, 1, 1, 1, 1, 1, 1, 1 };
};

#endif
