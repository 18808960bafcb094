// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCPeriodicMesh
 * @brief Tetrahedra of a periodic cell of spheres, for a solver
 *
 * Input: a sphere pack in a box that is periodic along its three axes (vtkRUCPackAlgorithm), whose
 * spheres do not touch (Core/Meshing/PeriodicMesh.h). `Mode` may be missing; all spheres then are
 * of Phase 1.
 *
 * Everything is on rank 0. Output 0 has the tetrahedra, with `Phase`, the mode of the sphere, and
 * `ParticleId`, its Id, raised as by vtkRUCLabelImage; both are 0 in the matrix. Its points have
 * `Boundary`, a sum of 1, 2, 4, 8, 16, 32 for the faces x-, x+, y-, y+, z-, z+ of the box that they
 * lie on, and `PeriodicOf`, the point of which they are the copy. Output 1 has the surfaces between
 * particles and matrix, output 2 the shares of the angles between faces of a tetrahedron, output 3
 * a row for each figure of quality.
 *
 * Field data, besides those of a pack, whose window is the box of the mesh: `OriginShift`, by which
 * it lies beside the pack's, `OriginMargin` (ShiftedCell::Margin), `ElementSize`, `LeastGap`,
 * `NarrowGaps`, how many gaps are below a fiftieth of the mean radius, and `MeshFractions`, those
 * of the tetrahedra in the layout of `VolumeFractions`.
 */
#ifndef vtkRUCPeriodicMesh_h
#define vtkRUCPeriodicMesh_h

#include "RUCMeshingModule.h"
#include "vtkRUCPackAlgorithm.h"

namespace ruc
{
struct MeshSettings;
}

class RUCMESHING_EXPORT vtkRUCPeriodicMesh : public vtkRUCPackAlgorithm
{
public:
  static vtkRUCPeriodicMesh* New();
  vtkTypeMacro(vtkRUCPeriodicMesh, vtkRUCPackAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Ports
  {
    TETRAHEDRA = 0,
    SURFACES = 1,
    ANGLES = 2,
    QUALITY = 3
  };

  ///@{
  /**
   * About the length of an edge of a tetrahedron. Default: 0, which stands for half the mean
   * radius.
   */
  vtkSetMacro(ElementSize, double);
  vtkGetMacro(ElementSize, double);
  ///@}
  ///@{
  /** Whether points lie on rings around the places where spheres nearly touch. Default: on. */
  vtkSetMacro(ContactRings, bool);
  vtkGetMacro(ContactRings, bool);
  ///@}
  ///@{
  /**
   * Whether the box is moved to where its planes, edges and corner are farthest from touching a
   * sphere. Default: on.
   */
  vtkSetMacro(ShiftOrigin, bool);
  vtkGetMacro(ShiftOrigin, bool);
  ///@}
  ///@{
  /**
   * The most rounds in which points move until no tetrahedron is flatter than 162 degrees, 0 to
   * 1000. Default: 10.
   */
  vtkSetMacro(ImprovementRounds, int);
  vtkGetMacro(ImprovementRounds, int);
  ///@}
  ///@{
  /** The least gap between spheres that is taken. Default: 0, for any above 0. */
  vtkSetMacro(LeastGap, double);
  vtkGetMacro(LeastGap, double);
  ///@}
  ///@{
  /** The seed of the random part of shifts and places, >= 0. Default: 0. */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

protected:
  vtkRUCPeriodicMesh();
  ~vtkRUCPeriodicMesh() override = default;
  const char* GetLabel() const override { return "Periodic Mesh"; }
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  void Execute(vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks) override;
  std::optional<ruc::Estimate> MakeEstimate() override;

private:
  vtkRUCPeriodicMesh(const vtkRUCPeriodicMesh&) = delete;
  void operator=(const vtkRUCPeriodicMesh&) = delete;

  ruc::MeshSettings MakeSettings() const;

  double ElementSize = 0.0;
  bool ContactRings = true;
  bool ShiftOrigin = true;
  int ImprovementRounds = 10;
  double LeastGap = 0.0;
  int Seed = 0;
};

#endif
