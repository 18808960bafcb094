// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCPeriodicReplicas
 * @brief Copies of the spheres of a periodic cell, to show that it is periodic
 *
 * Input: a sphere pack with a periodic box (vtkRUCPackAlgorithm). Output 0, spread over the ranks:
 * the spheres and their copies with `Radius`, `Mode` (if the input has it), `Id` of the original
 * and `Image` (3 int), by how many box edges along each axis a copy is away from the original;
 * originals have Image 0 0 0. Output 1, on rank 0: the outlines of the box or of every tile, as
 * lines. Output 2, with ClipToBox, spread over the ranks: the surfaces of all spheres that reach
 * into the box (or the block of tiles), cut flush with its faces and closed there, with the same
 * arrays. The facets around a sphere hold its volume; the field data `VolumeErrorPercent` and
 * `AreaErrorPercent` say by how much those of a whole sphere exceed its volume (by rounding) and
 * its area. The corners of facets are outside the sphere, so that facets of spheres in contact
 * reach into each other, by 1 % of the radius or less from a resolution of 24 on.
 *
 * BOUNDARY_COPIES adds those images that reach into the box: a sphere on a face then appears twice,
 * one on an edge of the box four times, one in a corner eight times. TILING repeats the whole cell.
 */
#ifndef vtkRUCPeriodicReplicas_h
#define vtkRUCPeriodicReplicas_h

#include "RUCPacksModule.h"
#include "vtkRUCPackAlgorithm.h"

#include <array>

namespace PackData
{
struct ObservedPack;
}
namespace ruc
{
class Window;
}

class RUCPACKS_EXPORT vtkRUCPeriodicReplicas : public vtkRUCPackAlgorithm
{
public:
  static vtkRUCPeriodicReplicas* New();
  vtkTypeMacro(vtkRUCPeriodicReplicas, vtkRUCPackAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Methods
  {
    BOUNDARY_COPIES = 0,
    TILING = 1
  };

  ///@{
  /** Which copies to make. Default: BOUNDARY_COPIES. */
  vtkSetMacro(Method, int);
  vtkGetMacro(Method, int);
  ///@}
  ///@{
  /**
   * The number of repetitions along each axis for TILING, >= 1, and 1 along an axis that is not
   * periodic; at most 1e8 spheres in all. Default: 1 1 1.
   */
  vtkSetVector3Macro(Tiles, int);
  vtkGetVector3Macro(Tiles, int);
  ///@}
  ///@{
  /** Whether to make the cut surfaces, output 2. Default: off. */
  vtkSetMacro(ClipToBox, bool);
  vtkGetMacro(ClipToBox, bool);
  ///@}
  ///@{
  /** The number of facets of these surfaces around a sphere, 8 to 256. Default: 24. */
  vtkSetMacro(SurfaceResolution, int);
  vtkGetMacro(SurfaceResolution, int);
  ///@}

protected:
  vtkRUCPeriodicReplicas();
  ~vtkRUCPeriodicReplicas() override = default;
  const char* GetLabel() const override { return "Periodic Replicas"; }
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  void Execute(vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks) override;
  std::optional<ruc::Estimate> MakeEstimate() override;

private:
  vtkRUCPeriodicReplicas(const vtkRUCPeriodicReplicas&) = delete;
  void operator=(const vtkRUCPeriodicReplicas&) = delete;

  void CheckProperties() const;
  /**
   * Returns the number of tiles along each axis. Throws std::invalid_argument if they do not fit
   * the box.
   */
  std::array<int, 3> FindTiles(const ruc::Window& box, std::size_t spheres) const;
  /** Adds the field data of all outputs. */
  void AddSummary(const PackData::ObservedPack& observed, const std::array<int, 3>& tiles,
    const ruc::Window& block, std::size_t copies, vtkInformationVector* outputs) const;

  int Method = BOUNDARY_COPIES;
  int Tiles[3] = { 1, 1, 1 };
  bool ClipToBox = false;
  int SurfaceResolution = 24;
};

#endif
