// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCEffectiveProperties
 * @brief Conductivity or stiffness of a sphere pack or a unit cell: bounds, and a solution on
 * voxels
 *
 * Input: a sphere pack with `Mode` (vtkRUCPackAlgorithm). Bounds follow from the volume fractions
 * and the three-point parameters of the pack (Core/Homogenisation/EffectiveResult.h); the solver
 * finds the tensor of a periodic cell, or of a box of the pack with its mirror images, on voxels
 * (EffectiveCell.h). All values are in the unit in which the materials are given.
 *
 * The tables are whole on rank 0. Output 0 has a row for each `Quantity`: k_xx to k_xy and k, or
 * C_11 to C_66, K and G, with thermal expansion alpha_xx to alpha_xy where that is given; of the
 * means k, K, G `Voigt`, `Reuss`, `HashinShtrikmanLower`, `HashinShtrikmanUpper`,
 * `ThirdOrderLower`, `ThirdOrderUpper` with their errors, and `Estimate`; `Solver`,
 * `DiscretisationError` and `IterationError`. What is not known is NaN.
 *
 * Output 1 tells how the search went: `Case`, `Resolution`, `InterfaceRule`, `Iteration`, `Energy`.
 *
 * Output 2 is the image of the box at Resolution, in the pieces that ParaView expects of the ranks,
 * with cell arrays `VolumeFraction` and, of the case that Fields names, `Temperature` and `Flux`,
 * or `Displacement` and `Stress` (xx, yy, zz, yz, xz, xy).
 *
 * The field data tell `Property`, `Boundary`, `WindowOrigin` and `WindowSize` of what was solved,
 * `Voxels`, `SolvedFraction` (the share of these voxels in spheres), `InterfaceRule`, `Iterations`
 * and `EndedBy`, besides those of the pack (PackData::AddPackSummary).
 *
 * A run that is stopped keeps the bounds and what was found, which lies above what it would have
 * been.
 */
#ifndef vtkRUCEffectiveProperties_h
#define vtkRUCEffectiveProperties_h

#include "RUCHomogenisationModule.h"
#include "vtkRUCPackAlgorithm.h"

#include <array>
#include <memory>
#include <vector>

class ProgressReport;
namespace ruc
{
struct CellBox;
struct CellFields;
struct CellGrid;
struct CellMaterials;
struct CellRun;
struct PackShare;
struct PropertyBounds;
struct SolverSettings;
struct SpherePack;
class Window;
enum class InterfaceRule;
}

class RUCHOMOGENISATION_EXPORT vtkRUCEffectiveProperties : public vtkRUCPackAlgorithm
{
public:
  static vtkRUCEffectiveProperties* New();
  vtkTypeMacro(vtkRUCEffectiveProperties, vtkRUCPackAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Ports
  {
    PROPERTIES = 0,
    CONVERGENCE = 1,
    FIELDS = 2
  };
  enum PropertyKinds
  {
    CONDUCTIVITY = 0,
    ELASTICITY = 1
  };
  enum Methods
  {
    BOUNDS = 0,
    SOLVER = 1,
    BOTH = 2
  };
  enum InterfaceRules
  {
    AUTOMATIC_RULE = 0,
    LAMINATE = 1,
    HARMONIC = 2,
    ARITHMETIC = 3,
    BOTH_RULES = 4
  };
  enum Boundaries
  {
    AUTOMATIC = 0,
    PERIODIC = 1,
    MIRRORED = 2
  };

  ///@{
  /** What is found. Default: CONDUCTIVITY. */
  vtkSetMacro(Property, int);
  vtkGetMacro(Property, int);
  ///@}
  ///@{
  /** The conductivity of the matrix, > 0. Default: 1. */
  vtkSetMacro(MatrixConductivity, double);
  vtkGetMacro(MatrixConductivity, double);
  ///@}
  ///@{
  /** Those of the spheres, one for all or one for each mode, >= 0. Default: 10. */
  void ClearModeConductivities();
  void SetModeConductivity(int i, double value);
  ///@}
  ///@{
  /** Young's modulus > 0 and Poisson's ratio > -1, < 0.5 of the matrix. Default: 3, 0.38 (epoxy).
   */
  vtkSetMacro(MatrixModulus, double);
  vtkGetMacro(MatrixModulus, double);
  vtkSetMacro(MatrixPoissonRatio, double);
  vtkGetMacro(MatrixPoissonRatio, double);
  ///@}
  ///@{
  /** Those of the spheres, one for all or one for each mode. Default: 70, 0.2 (glass). */
  void ClearModeModuli();
  void SetModeModulus(int i, double value);
  void ClearModePoissonRatios();
  void SetModePoissonRatio(int i, double value);
  ///@}
  ///@{
  /**
   * Coefficients of thermal expansion of matrix and spheres, for two materials. Where both are 0,
   * the default, the table has none.
   */
  vtkSetMacro(MatrixExpansion, double);
  vtkGetMacro(MatrixExpansion, double);
  vtkSetMacro(SphereExpansion, double);
  vtkGetMacro(SphereExpansion, double);
  ///@}
  ///@{
  /** Whether bounds are found, the cell is solved, or both. Default: BOTH. */
  vtkSetMacro(Method, int);
  vtkGetMacro(Method, int);
  ///@}
  ///@{
  /** Voxels along the shortest edge of what is solved, 2 to 4096. Default: 128. */
  vtkSetMacro(Resolution, int);
  vtkGetMacro(Resolution, int);
  ///@}
  ///@{
  /**
   * The same of a second, coarser grid, which tells how far the first is from voxels of no size. 0
   * leaves it out. Default: 96.
   */
  vtkSetMacro(SecondResolution, int);
  vtkGetMacro(SecondResolution, int);
  ///@}
  ///@{
  /**
   * What a voxel is that a surface cuts. BOTH_RULES solves with LAMINATE and HARMONIC. Default:
   * AUTOMATIC_RULE (ruc::CellMaterials::AutomaticRule).
   */
  vtkSetMacro(InterfaceRule, int);
  vtkGetMacro(InterfaceRule, int);
  ///@}
  ///@{
  /** When a case is solved (ruc::SolverSettings). Default: 0.0001, 500. */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  vtkSetMacro(MaximumIterations, int);
  vtkGetMacro(MaximumIterations, int);
  ///@}
  ///@{
  /** How the box becomes a cell. Default: AUTOMATIC (ruc::CellBoundary). */
  vtkSetMacro(Boundary, int);
  vtkGetMacro(Boundary, int);
  ///@}
  ///@{
  /** The box of the pack that is solved with its mirror images (ruc::FindCellBox). Default: 0. */
  vtkSetVector3Macro(WindowOrigin, double);
  vtkGetVector3Macro(WindowOrigin, double);
  vtkSetVector3Macro(WindowSize, double);
  vtkGetVector3Macro(WindowSize, double);
  ///@}
  ///@{
  /** The case of which the image has the fields, 1 to 3 or to 6. Default: 0, none. */
  vtkSetMacro(Fields, int);
  vtkGetMacro(Fields, int);
  ///@}

protected:
  vtkRUCEffectiveProperties();
  ~vtkRUCEffectiveProperties() override = default;
  const char* GetLabel() const override { return "Effective Properties"; }
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;
  void Execute(vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks) override;
  std::optional<ruc::Estimate> MakeEstimate() override;

private:
  vtkRUCEffectiveProperties(const vtkRUCEffectiveProperties&) = delete;
  void operator=(const vtkRUCEffectiveProperties&) = delete;

  void ValidateProperties() const;
  ruc::SolverSettings GetSettings() const;
  ruc::CellMaterials MakeMaterials(int modes) const;
  ruc::CellBox FindBox(const ruc::Window& observed, double largestRadius) const;
  std::vector<ruc::InterfaceRule> GetRules(const ruc::CellMaterials& materials) const;
  std::vector<int> GetResolutions() const;
  std::vector<ruc::PropertyBounds> FindBounds(const ruc::PackShare& share,
    const ruc::CellMaterials& materials, ProgressReport& report, RankCommunicator& ranks);
  std::vector<ruc::CellRun> SolveAll(const ruc::SpherePack& piece, const ruc::Window& observed,
    const ruc::CellBox& box, const ruc::CellMaterials& materials, ruc::CellFields& fields,
    ProgressReport& report, RankCommunicator& ranks);
  void AddSummary(const ruc::CellBox& box, const ruc::CellGrid& cell, double fraction,
    const std::vector<ruc::CellRun>& runs, vtkDataObject* data) const;
  void Warn(const std::vector<ruc::CellRun>& runs, const ruc::CellGrid& cell, double leastRadius);

  int Property = CONDUCTIVITY;
  double MatrixConductivity = 1.0;
  std::vector<double> ModeConductivities{ 10.0 };
  double MatrixModulus = 3.0;
  double MatrixPoissonRatio = 0.38;
  std::vector<double> ModeModuli{ 70.0 };
  std::vector<double> ModePoissonRatios{ 0.2 };
  double MatrixExpansion = 0.0;
  double SphereExpansion = 0.0;
  int Method = BOTH;
  int Resolution = 128;
  int SecondResolution = 96;
  int InterfaceRule = AUTOMATIC_RULE;
  double Tolerance = 1e-4;
  int MaximumIterations = 500;
  int Boundary = AUTOMATIC;
  double WindowOrigin[3] = { 0.0, 0.0, 0.0 };
  double WindowSize[3] = { 0.0, 0.0, 0.0 };
  int Fields = 0;
  std::array<int, 3> Announced = { 0, 0, 0 }; // voxels of the image
};

#endif
