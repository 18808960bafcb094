// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCSamplingAlgorithm
 * @brief What the filters that sample a sphere pack have in common
 *
 * Sampled are the points of a region: the pack's window (vtkRUCPackAlgorithm) without a margin in
 * which spheres with centres beyond the window, which are unknown, may lie; or the voxels of a mask
 * image, on the optional second input, without such a margin. Along periodic axes there is none.
 *
 * Chord Sampling takes grids of parallel lines of random directions through the region, Template
 * Sampling throws the paper's template of points (Fig. 4 of Lee et al., Phys. Rev. E 80, 061301,
 * 2009). A point in several spheres belongs to the lowest of their modes: overlaps count once.
 * Standard errors come from batches of samples. Results depend on the seed, and on nothing else:
 * not on ranks and threads.
 */
#ifndef vtkRUCSamplingAlgorithm_h
#define vtkRUCSamplingAlgorithm_h

#include "vtkRUCPackAlgorithm.h"

#include <memory>
#include <string>

class ProgressReport;
class vtkDataObject;
namespace PackData
{
struct SharedPack;
}
namespace ruc
{
class SamplingRegion;
struct SamplingSettings;
}

class RUCFILTERS_EXPORT vtkRUCSamplingAlgorithm : public vtkRUCPackAlgorithm
{
public:
  vtkTypeMacro(vtkRUCSamplingAlgorithm, vtkRUCPackAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * A label or 0/1 image whose voxels (cells, or boxes of the spacing's size around points) are
   * sampled. It takes the place of the window for the sampled methods; the pack must not be
   * periodic.
   */
  void SetMaskConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }

  ///@{
  /** Array of the mask, of one component. Default: "", the first of its points, else of its cells.
   */
  vtkSetStdStringFromCharMacro(MaskArray);
  vtkGetCharFromStdStringMacro(MaskArray);
  ///@}
  ///@{
  /** Value of the voxels that are inside. Default: 0, all voxels of another value than 0. */
  vtkSetMacro(MaskLabel, int);
  vtkGetMacro(MaskLabel, int);
  ///@}
  ///@{
  /** Thickness of the margin of window or mask that is not sampled; 0 where every sphere that
   * reaches in is known. Default: -1, the largest radius. */
  vtkSetMacro(WindowMargin, double);
  vtkGetMacro(WindowMargin, double);
  ///@}
  ///@{
  /** Seed of the samples, >= 0. Default: 1. */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}
  ///@{
  /**
   * Lines that Chord Sampling takes, about, >= 1: in 64 grids of random direction, or more where
   * the lines of one would lie closer than the spheres. Field data `NumberOfLines` tells how many
   * it were. Default: 20 000.
   */
  vtkSetMacro(NumberOfLines, int);
  vtkGetMacro(NumberOfLines, int);
  ///@}
  ///@{
  /** Throws that Template Sampling takes, >= 1. Default: 2000. */
  vtkSetMacro(NumberOfThrows, int);
  vtkGetMacro(NumberOfThrows, int);
  ///@}
  ///@{
  /** > 0: samples are taken until the standard errors add up to this, instead of a number of them;
   * the filters say how they add up. Default: 0. */
  vtkSetMacro(TargetError, double);
  vtkGetMacro(TargetError, double);
  ///@}

protected:
  vtkRUCSamplingAlgorithm();
  ~vtkRUCSamplingAlgorithm() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

  bool HasMask();

  /** Collective; the same region on every rank. Throws std::invalid_argument where nothing is left
   * of it. */
  std::unique_ptr<ruc::SamplingRegion> MakeRegion(
    const PackData::SharedPack& pack, RankCommunicator& ranks);

  /** For NumberOfLines or, `throws`, NumberOfThrows. */
  ruc::SamplingSettings GetSettings(bool throws) const;

  /** `Seed`, `Mask` or not, `WindowMargin` and `SampledVolume`. */
  void AddRegionSummary(vtkDataObject* data, const ruc::SamplingRegion& region);

private:
  vtkRUCSamplingAlgorithm(const vtkRUCSamplingAlgorithm&) = delete;
  void operator=(const vtkRUCSamplingAlgorithm&) = delete;

  std::string MaskArray;
  int MaskLabel = 0;
  double WindowMargin = -1.0;
  int Seed = 1;
  int NumberOfLines = 20000;
  int NumberOfThrows = 2000;
  double TargetError = 0.0;
  double UsedMargin = 0.0; // of the last region
};

#endif
