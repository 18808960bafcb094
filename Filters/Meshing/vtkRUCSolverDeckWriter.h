// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCSolverDeckWriter
 * @brief Writes a periodic mesh for a solver
 *
 * Input: the tetrahedra of vtkRUCPeriodicMesh, whole on rank 0. The extension decides on the
 * format: inp for Abaqus and CalculiX, msh for gmsh and what reads its files
 * (Core/Meshing/SolverMesh.h). The file takes the place of an old one once it is whole (NewFile).
 */
#ifndef vtkRUCSolverDeckWriter_h
#define vtkRUCSolverDeckWriter_h

#include "RUCMeshingModule.h"
#include "vtkRUCParallelAlgorithm.h"

#include <string>

class RUCMESHING_EXPORT vtkRUCSolverDeckWriter : public vtkRUCParallelAlgorithm
{
public:
  static vtkRUCSolverDeckWriter* New();
  vtkTypeMacro(vtkRUCSolverDeckWriter, vtkRUCParallelAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum RegionKinds
  {
    PHASES = 0,
    MODES = 1,
    PARTICLES = 2
  };
  enum PhysicsKinds
  {
    ELASTICITY = 0,
    CONDUCTION = 1
  };

  ///@{
  /** The file to write, on the machine of rank 0, which ends by inp or msh. */
  vtkSetStdStringFromCharMacro(FileName);
  vtkGetCharFromStdStringMacro(FileName);
  ///@}
  ///@{
  /**
   * What elements make a region with a material of its own, beside MATRIX: all particles together,
   * PARTICLES; those of a mode, MODE_1, MODE_2 and so on; or each particle, PARTICLE_ and its
   * ParticleId. Default: PHASES.
   */
  vtkSetMacro(Regions, int);
  vtkGetMacro(Regions, int);
  ///@}
  ///@{
  /**
   * Whether equations of inp tie displacements or temperatures, with elements for them. Default:
   * ELASTICITY.
   */
  vtkSetMacro(Physics, int);
  vtkGetMacro(Physics, int);
  ///@}
  ///@{
  /** All lengths are multiplied by this, > 0, such as 1e-6 for metres from micrometres. Default: 1.
   */
  vtkSetMacro(LengthFactor, double);
  vtkGetMacro(LengthFactor, double);
  ///@}

  /** Writes the file, on all ranks together. Returns 1, or 0 after an error. */
  int Write();

protected:
  vtkRUCSolverDeckWriter();
  ~vtkRUCSolverDeckWriter() override = default;
  const char* GetLabel() const override { return "Solver Deck Writer"; }
  int FillInputPortInformation(int port, vtkInformation* info) override;
  void Execute(
    vtkInformationVector** inputs, vtkInformationVector* outputs, RankCommunicator& ranks) override;

private:
  vtkRUCSolverDeckWriter(const vtkRUCSolverDeckWriter&) = delete;
  void operator=(const vtkRUCSolverDeckWriter&) = delete;

  void ValidateProperties() const;
  bool HasExtension(const char* extension) const;

  std::string FileName;
  int Regions = PHASES;
  int Physics = ELASTICITY;
  double LengthFactor = 1.0;
  bool Written = false; // whether Execute has come to its end
};

#endif
