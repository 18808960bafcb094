// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCImageStatistics
 * @brief Two-point probabilities, chords and surfaces of the phases of a label image
 *
 * Input: an image with a label, a whole number, for each voxel; voxels are cells, or boxes of the
 * spacing around points. The label MatrixLabel is the matrix m, the others in rising order are the
 * modes 1…N_p. At most 64 labels. Second input, optional: a mask with the same voxels.
 *
 * S_rs(x) comes from exact counts of all pairs of voxels that lie x apart, by Fourier transforms
 * (Core/Statistics/Voxels/ImageCorrelation.h). The image is spread over the ranks in slabs.
 *
 * Outputs 0 to 3 are the tables of vtkRUCTwoPointProbability, whole on rank 0: S_rs(r), checks,
 * gradients and autocovariance, without standard errors: the counts are exact, and how far another
 * image of the same medium would be from them one image does not tell. Output 4 is the image of
 * S_rs(x) of ImagePairs over lag vectors. Output 5 is a table by length like that of
 * vtkRUCChordLengths, without errors, from the runs of voxels along the axes; it has no rows with
 * ChordLengths off. Output 6 has a row for each phase: `Phase`, `Label`, `VolumeFraction`,
 * `SurfacePerVolume`, `SurfaceAtOneVoxel` (both 1 / length) and `MeanChord` = 4 VolumeFraction /
 * SurfacePerVolume.
 */
#ifndef vtkRUCImageStatistics_h
#define vtkRUCImageStatistics_h

#include "RUCImagesModule.h"
#include "vtkRUCEstimatedAlgorithm.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

class vtkImageData;
namespace LabelInput
{
struct Image;
}
namespace ruc
{
struct ImageLags;
struct ImageSettings;
struct ImageTwoPoint;
struct PhaseSlab;
struct VoxelGrid;
}

class RUCIMAGES_EXPORT vtkRUCImageStatistics : public vtkRUCEstimatedAlgorithm
{
public:
  static vtkRUCImageStatistics* New();
  vtkTypeMacro(vtkRUCImageStatistics, vtkRUCEstimatedAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Boundaries
  {
    FROM_IMAGE = 0,
    PERIODIC = 1,
    WINDOW = 2
  };
  enum Ports
  {
    PROBABILITIES = 0,
    CHECKS = 1,
    GRADIENTS = 2,
    AUTOCOVARIANCES = 3,
    MAP = 4,
    CHORDS = 5,
    PHASES = 6
  };

  ///@{
  /** The array of labels. Default: "", which stands for the first array of one component, of the
   * points or else of the cells. */
  vtkSetStdStringFromCharMacro(PhaseArray);
  vtkGetCharFromStdStringMacro(PhaseArray);
  ///@}
  ///@{
  /** The label of the matrix. Default: 0. */
  vtkSetMacro(MatrixLabel, int);
  vtkGetMacro(MatrixLabel, int);
  ///@}
  ///@{
  /**
   * Whether the image repeats along its axes. FROM_IMAGE takes it from the image's field data
   * `BoxPeriodic`, without which it is a window. Default: FROM_IMAGE.
   */
  vtkSetMacro(Boundary, int);
  vtkGetMacro(Boundary, int);
  ///@}
  ///@{
  /**
   * The last lag, at most half the shortest edge of the image. Default: 0, which stands for a
   * quarter of it, rounded down to voxels.
   */
  vtkSetMacro(MaximumLag, double);
  vtkGetMacro(MaximumLag, double);
  ///@}
  ///@{
  /** K, the number of lags after 0, at most one a voxel. Default: 0, for one a voxel. */
  vtkSetMacro(NumberOfLags, int);
  vtkGetMacro(NumberOfLags, int);
  ///@}
  ///@{
  /** The tolerance, > 0, of the saturation length, as in vtkRUCTwoPointProbability, where 1.5 mean
   * chords of the particles take the place of the mean diameter. Default: 0.0005. */
  vtkSetMacro(SaturationTolerance, double);
  vtkGetMacro(SaturationTolerance, double);
  ///@}
  ///@{
  /** The pairs of phases of output 4, such as "1 1; 1 m". It is empty for none. Default: "m m". */
  vtkSetStdStringFromCharMacro(ImagePairs);
  vtkGetCharFromStdStringMacro(ImagePairs);
  ///@}
  ///@{
  /** Whether output 5 is made. Default: on. */
  vtkSetMacro(ChordLengths, bool);
  vtkGetMacro(ChordLengths, bool);
  vtkBooleanMacro(ChordLengths, bool);
  ///@}
  ///@{
  /** The array of the mask, and the label of the voxels inside it, where 0 stands for all but 0.
   * Defaults: "", which stands for the first array of one component; 0. */
  vtkSetStdStringFromCharMacro(MaskArray);
  vtkGetCharFromStdStringMacro(MaskArray);
  vtkSetMacro(MaskLabel, int);
  vtkGetMacro(MaskLabel, int);
  ///@}
  ///@{
  /**
   * The number of labels that the input has on all ranks, for the estimates alone; setting it does
   * not modify the filter. Default: 0, which stands for the range of the values on rank 0.
   */
  void SetLabelsInInput(int number) { this->LabelsInInput = number; }
  int GetLabelsInInput() const { return this->LabelsInInput; }
  ///@}

  /** A mask, with the voxels of the input. */
  void SetMaskConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void RemoveAllMaskConnections() { this->RemoveAllInputConnections(1); }

protected:
  vtkRUCImageStatistics();
  ~vtkRUCImageStatistics() override = default;
  const char* GetLabel() const override { return "Image Statistics"; }
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  void Execute(
    vtkInformationVector** inputs, vtkInformationVector* outputs, RankCommunicator& ranks) override;
  std::optional<ruc::Estimate> MakeEstimate() override;

private:
  vtkRUCImageStatistics(const vtkRUCImageStatistics&) = delete;
  void operator=(const vtkRUCImageStatistics&) = delete;

  void ValidateProperties() const;
  bool HasMask() { return this->GetNumberOfInputConnections(1) > 0; }
  // Tells the pipeline of the image over lag vectors
  void Announce(const ruc::ImageLags& lags, vtkInformation* info) const;
  std::array<bool, 3> FindPeriodic(vtkImageData* image, RankCommunicator& ranks);
  // The image in slabs, without what is outside the mask, and its labels, the matrix last
  ruc::PhaseSlab ReadPhases(const LabelInput::Image& image, vtkImageData* mask,
    std::vector<std::int64_t>& labels, RankCommunicator& ranks);
  // Chooses how many spectra are kept, and refuses what does not fit
  void PlanMemory(
    const ruc::VoxelGrid& grid, ruc::ImageSettings& settings, RankCommunicator& ranks);
  ruc::ImageSettings MakeSettings(
    const ruc::VoxelGrid& grid, int phases, const std::array<bool, 3>& periodic) const;
  // Fill the tables, on rank 0
  void FillTables(const ruc::ImageTwoPoint& measured, const std::vector<std::int64_t>& labels,
    vtkInformationVector* outputs);
  void FillMap(const ruc::ImageTwoPoint& measured, const ruc::ImageSettings& settings,
    const RankCommunicator& ranks, vtkInformationVector* outputs) const;
  // Adds field data that tell how the image was measured
  void AddSummary(
    const ruc::ImageTwoPoint& measured, const ruc::ImageSettings& settings, vtkDataObject* data);

  std::string PhaseArray;
  int MatrixLabel = 0;
  int Boundary = FROM_IMAGE;
  double MaximumLag = 0.0;
  int NumberOfLags = 0;
  double SaturationTolerance = 0.0005;
  std::string ImagePairs = "m m";
  bool ChordLengths = true;
  std::string MaskArray;
  int MaskLabel = 0;
  int LabelsInInput = 0;
};

#endif
