// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCParticlesFromImage
 * @brief The particles in a grey, binary or label image
 *
 * Input: an image with an array of one component on its cells or points, such as that of a
 * tomograph. The image is spread over the ranks in slabs. By Method spheres are fitted to its grey
 * values by least squares (Core/Images/Fit/FindSpheres.h), or particles of any shape are what a
 * watershed cuts it into (Core/Images/Watershed/CutParticles.h).
 *
 * Output 0 is the pack, whole on rank 0: `Radius`; `Id`, from 1, or the label; `EqualVolumeRadius`
 * of the voxels of the particle and their `Sphericity`; `Contrast`, what it has more than the
 * matrix, over that of all particles; `FitResidual`, the deviation of the image from the fit around
 * its surface, over the contrast; `CenterError` and `RadiusError`, standard errors; `OverlapDepth`
 * with the neighbour that it overlaps most; `BorderFaces`, the number of faces of the image that
 * cut it. A watershed gives the centre of the particle's voxels, and its `EqualVolumeRadius` as its
 * `Radius`; what only a fit can tell, from `Contrast` to `OverlapDepth`, it leaves out. The field
 * data are the window (see BorderParticles), `LengthUnit`, `VoxelSize`, `MatrixValue`,
 * `ParticleValue`, `Noise` (over the contrast), `Threshold`, `VoxelsPerDiameter`, `Stopped`, and
 * for a fit `Blur` (a length) and `Sweeps`.
 *
 * Output 1 is the image with `ParticleId` (int): the Id, 0 in the matrix, and -1 in particles that
 * are not in the pack, as their centre lies outside or near the border; of a label image, and of a
 * watershed, in all that are not in it. Output 2 are the candidates that are not in the pack, with
 * `Radius`, `Contrast` (of a fit), `Reason` (ruc::DropReason) and `ReasonText`. Output 3 is, with
 * Residual, the image with `Residual` (float), what is left of it when the fitted spheres are taken
 * away; a watershed leaves none.
 *
 * A fit that is stopped gives the spheres as they are so far. Where the run is stopped after the
 * fit, `EqualVolumeRadius` and `Sphericity` are NaN and outputs 1 and 3 have no array.
 */
#ifndef vtkRUCParticlesFromImage_h
#define vtkRUCParticlesFromImage_h

#include "RUCImagesModule.h"
#include "vtkRUCEstimatedAlgorithm.h"

#include <cstdint>
#include <string>
#include <vector>

namespace LabelInput
{
struct Image;
}
namespace ruc
{
struct ParticleSearch;
struct PhaseSearch;
struct SphereSearch;
struct VoxelGrid;
}
class ProgressReport;
struct ImageParticles;

class RUCIMAGES_EXPORT vtkRUCParticlesFromImage : public vtkRUCEstimatedAlgorithm
{
public:
  static vtkRUCParticlesFromImage* New();
  vtkTypeMacro(vtkRUCParticlesFromImage, vtkRUCEstimatedAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Methods
  {
    SPHERE_FIT = 0,
    WATERSHED = 1
  };
  enum ImageKinds
  {
    AUTOMATIC = 0,
    GREY = 1,
    BINARY = 2,
    LABELS = 3
  };
  enum Brightness
  {
    BRIGHT = 0,
    DARK = 1
  };
  enum Borders
  {
    CENTRES_INSIDE = 0,
    WHOLE_ONLY = 1
  };
  enum Ports
  {
    PACK = 0,
    IDS = 1,
    DROPPED = 2,
    RESIDUAL = 3
  };

  ///@{
  /**
   * How particles are found: SPHERE_FIT fits spheres to the grey values by least squares; WATERSHED
   * cuts what is above the threshold into particles of any shape (Core/Images/Watershed), and takes
   * labels as they are.
   * Default: SPHERE_FIT.
   */
  vtkSetMacro(Method, int);
  vtkGetMacro(Method, int);
  ///@}
  ///@{
  /** How much farther from the matrix, in voxels, a particle of WATERSHED must have its inmost
   * voxel than its widest neck to another one that reaches farther. Default: 0.5. */
  vtkSetMacro(MarkerHeight, double);
  vtkGetMacro(MarkerHeight, double);
  ///@}
  ///@{
  /** The array of values. Default: "", which stands for the first array of one component, of the
   * points or else of the cells. */
  vtkSetStdStringFromCharMacro(ImageArray);
  vtkGetCharFromStdStringMacro(ImageArray);
  ///@}
  ///@{
  /**
   * What the values are: grey values; two values, without blur; or 0 in the matrix and a whole
   * number for each particle. AUTOMATIC takes two values as BINARY, an array `ParticleId` as LABELS
   * and all else as GREY. Default: AUTOMATIC.
   */
  vtkSetMacro(ImageKind, int);
  vtkGetMacro(ImageKind, int);
  ///@}
  ///@{
  /** Whether particles are brighter or darker than the matrix. Default: BRIGHT. */
  vtkSetMacro(ParticlesAre, int);
  vtkGetMacro(ParticlesAre, int);
  ///@}
  ///@{
  /** The value between matrix and particles. Default: 0, which stands for Otsu's. */
  vtkSetMacro(Threshold, double);
  vtkGetMacro(Threshold, double);
  ///@}
  ///@{
  /** How often the image is smoothed before candidates are looked for, at most 10. The fit is to
   * the image as it is. Default: -1, for as often as the noise asks. */
  vtkSetMacro(Smoothing, int);
  vtkGetMacro(Smoothing, int);
  ///@}
  ///@{
  /** The least diameter of a particle. Default: 0, which stands for three voxels. */
  vtkSetMacro(MinimumDiameter, double);
  vtkGetMacro(MinimumDiameter, double);
  ///@}
  ///@{
  /** The grey values of pure matrix and particle. Default: 0 and 0; where they are equal both are
   * fitted. */
  vtkSetMacro(MatrixValue, double);
  vtkGetMacro(MatrixValue, double);
  vtkSetMacro(ParticleValue, double);
  vtkGetMacro(ParticleValue, double);
  ///@}
  ///@{
  /** The depth, over its own diameter, by which a particle may overlap a larger one. Default: 0.2.
   */
  vtkSetMacro(OverlapTolerance, double);
  vtkGetMacro(OverlapTolerance, double);
  ///@}
  ///@{
  /**
   * Which particles the pack has, and its window: those with centres in the image, as cut spheres
   * are fitted as well; or those with centres in the image less the largest radius, which are all
   * whole. Default: CENTRES_INSIDE.
   */
  vtkSetMacro(BorderParticles, int);
  vtkGetMacro(BorderParticles, int);
  ///@}
  ///@{
  /** The unit of length of the image. Default: "", for that of its field data. */
  vtkSetStdStringFromCharMacro(LengthUnit);
  vtkGetCharFromStdStringMacro(LengthUnit);
  ///@}
  ///@{
  /** Whether output 3 is made. Default: off. */
  vtkSetMacro(Residual, bool);
  vtkGetMacro(Residual, bool);
  vtkBooleanMacro(Residual, bool);
  ///@}

  ///@{
  /**
   * The number of voxels that the input has on all ranks, for the estimates alone, which then are
   * those of a cube of them; setting it does not modify the filter. Default: 0, which stands for
   * those of the input.
   */
  void SetVoxelsInInput(vtkIdType number) { this->VoxelsInInput = number; }
  vtkIdType GetVoxelsInInput() const { return this->VoxelsInInput; }
  ///@}

protected:
  vtkRUCParticlesFromImage();
  ~vtkRUCParticlesFromImage() override = default;
  const char* GetLabel() const override { return "Particles From Image"; }
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  void Execute(
    vtkInformationVector** inputs, vtkInformationVector* outputs, RankCommunicator& ranks) override;
  std::optional<ruc::Estimate> MakeEstimate() override;

private:
  vtkRUCParticlesFromImage(const vtkRUCParticlesFromImage&) = delete;
  void operator=(const vtkRUCParticlesFromImage&) = delete;

  void ValidateProperties() const;
  // Whether values are labels, and which kind the others are
  bool HasLabels(const LabelInput::Image& image, RankCommunicator& ranks) const;
  ruc::SphereSearch MakeSearch(const ImageParticles& work) const;
  ruc::ParticleSearch MakeCut(const ImageParticles& work) const;
  // Sets what both searches share
  void SetPhases(const ImageParticles& work, ruc::PhaseSearch& search) const;
  // Fills the slab of the work, and with labels its starts
  void ReadImage(ImageParticles& work, RankCommunicator& ranks) const;
  void FindParticles(ImageParticles& work, RankCommunicator& ranks);
  void CutImage(ImageParticles& work, RankCommunicator& ranks, ProgressReport& report) const;
  void FitSpheres(ImageParticles& work, RankCommunicator& ranks, ProgressReport& report) const;
  double LeastDiameterOf(const ImageParticles& work) const;
  ruc::Estimate EstimateOf(const ruc::VoxelGrid& grid, int ranks) const;
  void Warn(const ImageParticles& work);
  void FillImages(
    ImageParticles& work, vtkInformationVector* outputs, RankCommunicator& ranks) const;
  void AddSummary(const ImageParticles& work, const std::string& unit, vtkDataObject* data) const;

  int Method = SPHERE_FIT;
  double MarkerHeight = 0.5;
  std::string ImageArray;
  int ImageKind = AUTOMATIC;
  int ParticlesAre = BRIGHT;
  double Threshold = 0.0;
  int Smoothing = -1;
  double MinimumDiameter = 0.0;
  double MatrixValue = 0.0;
  double ParticleValue = 0.0;
  double OverlapTolerance = 0.2;
  int BorderParticles = CENTRES_INSIDE;
  std::string LengthUnit;
  bool Residual = false;
  vtkIdType VoxelsInInput = 0;
};

#endif
