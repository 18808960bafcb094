// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCLabelImage
 * @brief A sphere pack as an image of voxels: phases, particle ids, volume fractions
 *
 * Input: a sphere pack with `Mode` (vtkRUCPackAlgorithm), and with `Id` for ParticleIds. The output
 * is an image of the window, or of the smallest box around a cylinder, in the pieces that ParaView
 * expects of the ranks (Core/Images/LabelImage.h). Its arrays, on cells or points, are
 *
 * - `Phase` (unsigned char): 0 in the matrix, else the mode;
 * - `ParticleId` (int): 0 in the matrix, else the Id. Where the lowest Id is below 1, all are
 * raised for it to be 1, and the field data `ParticleIdsRaised` says by how much;
 * - `VolumeFraction` (float): the share of a voxel's volume that is in particles, and for
 *   EVERY_MODE also `VolumeFraction_1` to `VolumeFraction_m`, those of the modes and the matrix;
 * - `Window` (unsigned char), for a cylinder: 1 where the centre of a voxel lies in it, else 0.
 *
 * The field data are those of the pack (PackData::AddPackSummary), with the volume fractions of the
 * pack itself; `VoxelSize` (3 numbers); and `IncompleteMargin`, the largest radius where an axis is
 * not periodic, else 0: so far from the border of the window the image lacks spheres whose centres
 * lie outside.
 *
 * ParaView wants to know the extent of an image before it asks for the image. Where that depends on
 * the pack, as with Dimensions 0 0 0, the filters upstream run when the extent is asked for. A
 * window that changes with time is then refused.
 *
 * A run that is stopped has no image; the output is then empty.
 */
#ifndef vtkRUCLabelImage_h
#define vtkRUCLabelImage_h

#include "RUCImagesModule.h"
#include "vtkRUCPackAlgorithm.h"

#include <cstdint>

#include <array>

class vtkImageData;
namespace ruc
{
class LabelImage;
struct LabelArrays;
struct LabelSettings;
struct PackTotals;
struct SpherePack;
struct VoxelBlock;
struct VoxelGrid;
class Window;
}

class RUCIMAGES_EXPORT vtkRUCLabelImage : public vtkRUCPackAlgorithm
{
public:
  static vtkRUCLabelImage* New();
  vtkTypeMacro(vtkRUCLabelImage, vtkRUCPackAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum FractionMethods
  {
    EXACT = 0,
    SUPERSAMPLED = 1
  };
  enum FractionKinds
  {
    PARTICLES = 0,
    EVERY_MODE = 1
  };
  enum Attributes
  {
    CELLS = 0,
    POINTS = 1
  };

  ///@{
  /** Which arrays the image has; at least one. Default: phases alone. */
  vtkSetMacro(Phases, bool);
  vtkGetMacro(Phases, bool);
  vtkSetMacro(ParticleIds, bool);
  vtkGetMacro(ParticleIds, bool);
  vtkSetMacro(VolumeFractions, bool);
  vtkGetMacro(VolumeFractions, bool);
  ///@}
  ///@{
  /**
   * The edge of the voxels, which are cubes but for periodic axes (ruc::MakeVoxelGrid). Default: 0,
   * which stands for a twentieth of the volume mean diameter.
   */
  vtkSetMacro(VoxelSize, double);
  vtkGetMacro(VoxelSize, double);
  ///@}
  ///@{
  /**
   * The numbers of voxels along the edges of the window. Default: 0 0 0, which leaves them to
   * VoxelSize.
   */
  vtkSetVector3Macro(Dimensions, int);
  vtkGetVector3Macro(Dimensions, int);
  ///@}
  ///@{
  /** How volume fractions are found. Default: EXACT. */
  vtkSetMacro(FractionMethod, int);
  vtkGetMacro(FractionMethod, int);
  ///@}
  ///@{
  /** For SUPERSAMPLED, how many points of a voxel are looked at along each axis, 1 to 64.
   * Default: 4.
   */
  vtkSetMacro(SamplesPerAxis, int);
  vtkGetMacro(SamplesPerAxis, int);
  ///@}
  ///@{
  /** Of what volume fractions are told. Default: PARTICLES. */
  vtkSetMacro(Fractions, int);
  vtkGetMacro(Fractions, int);
  ///@}
  ///@{
  /** Whether voxels are the cells of the image or boxes around its points. Default: CELLS. */
  vtkSetMacro(ArrayOn, int);
  vtkGetMacro(ArrayOn, int);
  ///@}

protected:
  vtkRUCLabelImage() = default;
  ~vtkRUCLabelImage() override = default;
  const char* GetLabel() const override { return "Label Image"; }
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;
  void Execute(vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks) override;
  std::optional<ruc::Estimate> MakeEstimate() override;
  /**
   * The memory of the pack. That of the voxels is checked once it is known how many there are,
   * since the mean diameter is that of the spheres of all ranks.
   */
  double GetMemoryToCheck() override;

private:
  vtkRUCLabelImage(const vtkRUCLabelImage&) = delete;
  void operator=(const vtkRUCLabelImage&) = delete;

  void ValidateProperties() const;
  ruc::LabelSettings GetSettings() const;
  // Throws std::invalid_argument for properties that make no grid in the window
  ruc::VoxelGrid MakeGrid(const ruc::Window& window, double meanDiameter) const;
  // Returns the grid of the pack, which is asked of the filters upstream. Collective
  ruc::VoxelGrid FindGrid(vtkInformationVector** inputs, vtkInformationVector* outputs);
  // Returns by how much Ids are raised, and warns where some are repeated
  std::int64_t CheckIds(const ruc::SpherePack& spheres, RankCommunicator& ranks);
  void RequireRoom(
    const ruc::VoxelBlock& block, const ruc::PackTotals& totals, RankCommunicator& ranks) const;
  // Adds the arrays, which are not yet set
  // Refuses a grid that is not the one that filters downstream were told of
  void RequireAnnounced(const ruc::VoxelGrid& grid) const;
  ruc::LabelArrays AddArrays(vtkImageData* image, int modes) const;
  // Throws std::invalid_argument on all ranks where the run was stopped
  void Label(const ruc::LabelImage& labels, int steps, const ruc::LabelArrays& arrays,
    RankCommunicator& ranks);

  bool Phases = true;
  bool ParticleIds = false;
  bool VolumeFractions = false;
  double VoxelSize = 0.0;
  int Dimensions[3] = { 0, 0, 0 };
  int FractionMethod = EXACT;
  int SamplesPerAxis = 4;
  int Fractions = PARTICLES;
  int ArrayOn = CELLS;
  std::array<int, 3> Announced = { 0, 0, 0 }; // numbers of voxels
};

#endif
