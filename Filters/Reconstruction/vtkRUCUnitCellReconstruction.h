// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCUnitCellReconstruction
 * @brief Small periodic cells with the one- and two-point probabilities of a sphere pack
 *
 * The input is the target: a sphere pack with `Mode` (vtkRUCPackAlgorithm); or a table of S_rs with
 * the columns `r`, `S_1_1`, `S_1_2`, … `S_m_m` on equal lags from 0, from vtkRUCTwoPointProbability
 * or from a file of any program, together with the ModeDiameters. The cell is a periodic cube. It
 * holds, of every mode, the whole number of spheres nearest to the target's share, or ModeCounts;
 * all have the volume mean diameter of the mode. Its edge h_c minimises the difference of the
 * volume fractions, equation (12). The centres minimise
 *
 *     F2 = sum over all ordered pairs of phases of || S_rs of the pack - S_rs of the cell || (13)
 *
 * with the discrete norm over the lags r_1…r_K, not divided by K, and no two spheres overlap,
 * images included (14).
 *
 * Gradient starts from random centres, pushes the overlap out, descends by L-BFGS on the exact F2
 * and its gradient with an overlap penalty, and removes the last overlap exactly. With
 * ContactWeight, PoreWeight and SpectrumWeight it then descends on F2, near neighbours, pores and
 * the spectrum together, which are compared in the pack's standard errors
 * (Core/Reconstruction/SearchObjective.h). Annealed
 * Population is RECON3D of the paper (Core/Reconstruction/Population/PopulationSearch.h). Hybrid
 * has a small population whose best member descends by L-BFGS, then is changed a little and
 * descends again. Several cells are independent searches with the seeds Seed, Seed + 1, …, one on
 * each rank or group of ranks at a time.
 *
 * The outputs are whole on rank 0:
 * - 0 is the best cell (with the least F2 of those without overlap, if there are any), a sphere
 *   pack with its periodic box and the field data `Objective` (F2), `StartObjective` (F2 of the
 *   random start, freed from overlap as far as that went; for a population its mean),
 *   `OnePointDifference` (F1, equation 11), `OverlapPercent`, `Iterations` (or generations),
 *   `EndedBy` (text), `Stopped` (1 if the search was ended from outside) and `Cell` (its number);
 *   with SpectrumWeight also `Zeta` (NaN where the cell has overlap), `ZetaOfPack` and
 *   `ZetaOfPack_error`.
 * - 1 is the table of convergence of the best cell, `Iteration`, `Objective`, `OverlapPercent`, for
 *   a dense cell `SumOfMultipliers`, and `GapMisfit`, `NearestMisfit`, `PoreMisfit`,
 *   `SpectrumMisfit`, `ThirdOrderMisfit` (which are also field data; NaN while F2 descends alone)
 *   where they count, whose row 0 is the start and whose last row is the cell that is returned.
 * - 2 is the table `r`, `S_1_1_pack`, `S_1_1_cell`, … of the best cell; for several cells also
 *   `S_1_1_mean`, `S_1_1_deviation` (the standard deviation over the cells), ….
 * - 3 is a multiblock data set of all cells.
 * - 4 is a table with a row for each cell, like Table I of the paper: `Cell`, `Seed`,
 *   `BeforeMinimum`, `BeforeMean`, `BeforeMaximum`, `AfterMinimum`, `AfterMean`, `AfterMaximum` (F2
 *   over the population; for Gradient that of the start and of the cell), `Iterations`,
 *   `OverlapPercent`, `Objective` (F2 of the cell), `DifferencePercent` (equation 17) and
 *   `EndedBy`.
 * - 5 compares the target with the mean of the cells by equations (16) and (17), like output 0 of
 *   vtkRUCCompareProbabilities.
 *
 * With a CheckpointFile the state of a search is written every CheckpointInterval seconds and at
 * its end, always to a new file that then replaces the last one. A search whose file exists goes on
 * from it, to the same end, bit by bit, on any number of ranks. A search that was ended from
 * outside more often than ContinueAfterStops is shown as it was instead; the field data `Stops`
 * says how often that was.
 *
 * Every iteration asks whether to stop: by the time limit, by the stop file, by a
 * vtkRUCStopRequest, or by SetAbortExecute from an observer of progress. The best cells so far are
 * then the output. Equation numbers refer to Lee et al., Phys. Rev. E 80, 061301 (2009).
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

/** The setter and the getter of a property whose value is `place`, a setting of the core. */
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

  /** How the centres are found. Default: GRADIENT. */
  RUCSetting(Method, int, Search.Method);
  /** The number of independent cells, 1 to 10000. Default: 1. */
  RUCSetting(NumberOfCells, int, Search.NumberOfCells);
  /**
   * The diameters of the spheres in the cell, one for each mode, > 0. Required with a table; with a
   * pack they take the place of its own. Default: none.
   */
  void ClearModeDiameters();
  void SetModeDiameter(int i, double diameter);
  /**
   * The number of spheres of every mode in the cell, each >= 1, in place of CellSize and
   * NumberOfParticles. Default: none.
   */
  void ClearModeCounts();
  void SetModeCount(int i, int count);
  /**
   * The number of spheres in the cell, enough for one of every mode. Default: 0, which means that
   * CellSize gives it.
   */
  RUCSetting(NumberOfParticles, int, Cell.NumberOfParticles);
  /**
   * The first guess h_0 of the cell's edge. Default: 0, which means twice the saturation length of
   * the target's S_rs.
   */
  RUCSetting(CellSize, double, Cell.CellSize);
  /**
   * The last lag of F2, at most two edges of the cell, and no more than vtkRUCTwoPointProbability
   * would take for the pack. Default: 0, which means half the cell's edge.
   */
  RUCSetting(MaximumLag, double, Cell.MaximumLag);
  /** K, the number of lags after 0; 1 to 100 000. Default: 277. */
  RUCSetting(NumberOfLags, int, Cell.NumberOfLags);
  /**
   * The tolerance of the saturation length, as in vtkRUCTwoPointProbability; > 0. Default: 0.0005.
   */
  RUCSetting(SaturationTolerance, double, Cell.SaturationTolerance);
  /**
   * The diameters that the spheres of a mode have in the cell, >= 0. 1 gives all the volume mean
   * diameter, as in the paper; more give quantiles of the pack's own diameters in the mode, so that
   * number, surface and volume agree; 0 gives each sphere of the cell its own. Time and memory of
   * F2 grow with its square. It takes a pack, not a table. Default: 1.
   */
  RUCSetting(DiametersPerMode, int, Cell.DiametersPerMode);
  /**
   * The least distance of the surfaces of any two spheres of the cell, in the unit of the pack, >=
   * 0, as meshes need it. Gradient alone knows it. Default: 0.
   */
  RUCSetting(MinimumGap, double, Cell.Gap.Length);
  /** What is added to it, in the sum of both radii, >= 0. Default: 0. */
  RUCSetting(MinimumGapShare, double, Cell.Gap.Share);
  /**
   * The most iterations of L-BFGS on F2, >= 0. The search ends earlier if F2 falls by less than 0.1
   * % in 100 iterations. With ContactWeight, PoreWeight, SpectrumWeight or ThirdOrderWeight half as
   * many more at most: 0.6 of this on F2 alone, then 0.9 on F2 and those terms together. Default:
   * 1000.
   */
  RUCSetting(MaximumIterations, int, Search.Gradient.MaximumIterations);
  /**
   * The search ends when a cell without overlap has F2 at or below this, and its near neighbours
   * and pores, where they count, differ by no more than another pack's would; >= 0. Default: 0.
   */
  RUCSetting(TargetObjective, double, Search.Gradient.TargetObjective);
  ///@{
  /**
   * Whether the search ends at the pack's own error: once F2 is at or below the F2 that is expected
   * between the pack and its medium (ObjectiveFloor of Core/Statistics/PairSums/PairSumErrors.h, by
   * 64 blocks), or at TargetObjective if that is more, and no misfit of the other terms that count
   * is above 1. It requires a pack with room for eight blocks with edges of two mean diameters.
   * Default: off. Field data `ObjectiveFloor` and `PackErrorIteration`, the first iteration of the
   * best cell at which that was so, or -1, tell it in any case where the pack has room.
   */
  vtkSetMacro(StopAtPackError, bool);
  vtkGetMacro(StopAtPackError, bool);
  vtkBooleanMacro(StopAtPackError, bool);
  /**
   * What the near neighbours of the cell weigh beside F2, >= 0: the gaps of all neighbours and the
   * least gap of every sphere, against those of the pack. Gradient alone knows it, and only of a
   * pack, not of a table. 0 means that they do not count. Default: 1.
   */
  RUCSetting(ContactWeight, double, Search.Gradient.Neighbours.ContactWeight);
  /** The same for the widths of the pores. Default: 1. */
  RUCSetting(PoreWeight, double, Search.Gradient.Neighbours.PoreWeight);
  /**
   * The same for the spectrum of zeta, Z(l), l = 2 to 8, of vtkRUCThirdOrderParameters. The pack
   * must overlap by at most 0.01 % and have 100 spheres three mean diameters away from its faces.
   * Default: 0.
   */
  RUCSetting(SpectrumWeight, double, Search.Gradient.Neighbours.SpectrumWeight);
  /**
   * The same for the three-point functions around centres, T of vtkRUCThreePointProbability, of
   * ThirdOrderClasses classes of modes, to the degree ThirdOrderDegree, at ThirdOrderDistances. The
   * pack must overlap by at most 0.01 % and have 100 spheres of each class two largest diameters
   * and the last distance away from its faces. Default: 0.
   */
  RUCSetting(ThirdOrderWeight, double, Search.Gradient.Neighbours.ThirdOrderWeight);
  /** 1 to 4. Default: 3. */
  RUCSetting(ThirdOrderClasses, int, Search.Gradient.ThirdOrder.Classes);
  /** 0 to 13. Default: 8. */
  RUCSetting(ThirdOrderDegree, int, Search.Gradient.ThirdOrder.Degree);
  /**
   * At most 32, > 0, ascending. Default: none, which stands for twelve from 0.04 to 1.44 mean
   * diameters.
   */
  void ClearThirdOrderDistances();
  void SetThirdOrderDistance(int i, double distance);
  /**
   * The search ends with the best cell so far after this many seconds, >= 0. Default: 0, which
   * means no limit.
   */
  vtkSetMacro(TimeLimit, double);
  vtkGetMacro(TimeLimit, double);
  /** The search ends with the best cell so far once a file of this name exists where rank 0 runs.
   * Default: empty. */
  vtkSetStdStringFromCharMacro(StopFile);
  vtkGetCharFromStdStringMacro(StopFile);
  /** The seed of all random numbers, >= 0. Cell n, counted from 1, has Seed + n - 1. Default: 1. */
  RUCSetting(Seed, int, Search.Gradient.Seed);
  /**
   * The file that holds the state of the search, where rank 0 runs. Several cells have one each,
   * with .1, .2, … after this name. Default: empty, which means none.
   */
  void SetCheckpointFile(const char* name);
  const char* GetCheckpointFile() const { return this->Search.CheckpointFile.c_str(); }
  /** The seconds between two states that are written, >= 0. Default: 60. */
  RUCSetting(CheckpointInterval, double, Search.CheckpointInterval);
  /**
   * A search that was ended from outside more often than this is shown as it was, from its
   * checkpoint; otherwise it goes on. -1 means that it always goes on. Default: 0.
   */
  RUCSetting(ContinueAfterStops, int, Search.ContinueAfterStops);

  // Settings of Annealed Population, then of Hybrid, which takes the others from Annealed
  // Population (ruc::HybridOf). Their defaults and ranges are in
  // Core/Reconstruction/Population/PopulationSettings.h.
  /** N_i, the number of individuals. */
  RUCSetting(Population, int, Search.Annealed.Population);
  /**
   * The share of the first population that is random; the others are deposited (ballistic
   * deposition).
   */
  RUCSetting(RandomShare, double, Search.Annealed.RandomShare);
  /** The overlap (a + b - d) / (a + b) that the ballistic deposition allows. */
  RUCSetting(DepositionDegree, double, Search.Annealed.DepositionDegree);
  /** m, the number of individuals in the mating pool. */
  RUCSetting(MatingPool, int, Search.Annealed.MatingPool);
  /** The search ends after this many generations. 0 gives the best of the first population. */
  RUCSetting(MaximumGenerations, int, Search.Annealed.MaximumGenerations);
  /** The search ends after this many generations without a better best individual. */
  RUCSetting(PatienceGenerations, int, Search.Annealed.PatienceGenerations);
  /** The expected number of copies of the best individual in the roulette by rank. */
  RUCSetting(SelectionPressure, double, Search.Annealed.SelectionPressure);
  /** The overlap in percent at which the penalty p of equation (15) is 1/2. */
  RUCSetting(HalfOverlap, double, Search.Annealed.HalfOverlap);
  /** The share of the spheres that an operator on some of them changes. */
  RUCSetting(MutatedShare, double, Search.Annealed.MutatedShare);
  /** The exponent b of the non-uniform mutations. */
  RUCSetting(MutationShape, double, Search.Annealed.MutationShape);
  /** The longest step of the non-uniform mutations, in half edges of the cell. */
  RUCSetting(MutationReach, double, Search.Annealed.MutationReach);
  /** G, the generations over which the non-uniform mutations shrink to 0. */
  RUCSetting(MutationGenerations, int, Search.Annealed.MutationGenerations);
  /** The probability of the mass-spring mutation of a child. */
  RUCSetting(MassSpringProbability, double, Search.Annealed.MassSpringProbability);
  /** The temperature T of the acceptance at the start, in units of the fitness. */
  RUCSetting(InitialTemperature, double, Search.Annealed.InitialTemperature);
  /** The factor of T from one generation to the next. */
  RUCSetting(CoolingFactor, double, Search.Annealed.CoolingFactor);
  /** After this many generations without a better best individual T is the initial one again. */
  RUCSetting(ReheatingGenerations, int, Search.Annealed.ReheatingGenerations);
  /** The number of individuals of Hybrid. */
  RUCSetting(HybridPopulation, int, Search.Hybrid.Population);
  /** The number of individuals in the mating pool of Hybrid. */
  RUCSetting(HybridMatingPool, int, Search.Hybrid.MatingPool);
  /** The MutationReach of Hybrid. */
  RUCSetting(HybridMutationReach, double, Search.Hybrid.MutationReach);
  /** The number of steps of L-BFGS that Hybrid takes at a time. */
  RUCSetting(RefinementSteps, int, Search.Hybrid.RefinementSteps);
  /**
   * Eight weights, >= 0, by which one of the operators is drawn: uniform, boundary, non-uniform and
   * multi-non-uniform mutation, simple, simple arithmetic, whole arithmetic and heuristic
   * crossover. Default: 1 each. Hybrid has weights of its own.
   */
  void ClearOperatorWeights();
  void SetOperatorWeight(int i, double weight);

protected:
  vtkRUCUnitCellReconstruction();
  ~vtkRUCUnitCellReconstruction() override = default;
  const char* GetLabel() const override { return "Unit Cell Reconstruction"; }
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  void Execute(
    vtkInformationVector** inputs, vtkInformationVector* outputs, RankCommunicator& ranks) override;
  void Execute(vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks) override;
  /**
   * Estimates the most that the search can take: to its last iteration or generation, or to the
   * time limit.
   */
  std::optional<ruc::Estimate> MakeEstimate() override;

private:
  vtkRUCUnitCellReconstruction(const vtkRUCUnitCellReconstruction&) = delete;
  void operator=(const vtkRUCUnitCellReconstruction&) = delete;

  void CheckProperties() const;
  // Returns twice the saturation length; if it is not reached, warns and takes the last lag in its
  // place
  double FindEdge(
    const ruc::TwoPointProbability& probability, double diameter, RankCommunicator& ranks);
  // Returns a reason from outside why the search should end now; all but the time limit are known
  // only to rank 0
  ruc::EndReason FindStopReason(const ProgressReport& report, bool isFirstRank);
  // The F2 between the pack and its medium, or NaN for a pack without room for blocks
  double FindFloor(const ruc::PackShare& share, const ruc::TwoPointProbability& target,
    RankCommunicator& ranks) const;
  // Searches, and fills the outputs
  void Reconstruct(const ruc::CellContents& contents, const ruc::TwoPointProbability& target,
    const CellSearch::Settings& search, double floor, const std::string& lengthUnit,
    vtkInformationVector* outputs, RankCommunicator& ranks, ProgressReport& report);
  // Returns the settings with the near neighbours, pores and spectrum of the pack, where wanted
  CellSearch::Settings FindSearch(const ruc::PackShare& share, RankCommunicator& ranks);

  CellProperties Cell;
  CellSearch::Settings Search;
  int NumberOfOperatorWeights = ruc::NumberOfGeneticOperators; // how many were set
  double TimeLimit = 0.0;
  bool StopAtPackError = false;
  std::string StopFile;
};

#endif
