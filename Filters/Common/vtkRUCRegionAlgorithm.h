// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCRegionAlgorithm
 * @brief What the filters that sample a region of a sphere pack have in common
 *
 * Sampled are the points of a region: the pack's window (vtkRUCPackAlgorithm) without a margin in
 * which spheres with centres beyond the window, which are unknown, may lie; or the voxels of a mask
 * image, on the optional second input, without such a margin. Along periodic axes there is none.
 *
 * A point in several spheres belongs to the lowest of their modes: overlaps count once. Results
 * depend on the seed, and on nothing else: not on ranks and threads.
 */
#ifndef vtkRUCRegionAlgorithm_h
#define vtkRUCRegionAlgorithm_h

#include "vtkRUCPackAlgorithm.h"

#include <cstdint>
#include <memory>
#include <string>

class vtkDataObject;
namespace PackData
{
struct SharedPack;
}
namespace ruc
{
class SamplingRegion;
}

class RUCCOMMON_EXPORT vtkRUCRegionAlgorithm : public vtkRUCPackAlgorithm
{
public:
  vtkTypeMacro(vtkRUCRegionAlgorithm, vtkRUCPackAlgorithm);
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
  /** Value of the voxels that are inside. Default: 0, all voxels of another value than 0.
   * A value that is not a number is outside. */
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

protected:
  vtkRUCRegionAlgorithm();
  ~vtkRUCRegionAlgorithm() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

  bool HasMask();

  /** The mask, which every rank holds while a region is made of it. */
  ruc::Estimate EstimateRegion() override;

  /** Collective; the same region on every rank. Throws std::invalid_argument where nothing is left
   * of it. */
  std::unique_ptr<ruc::SamplingRegion> MakeRegion(
    const PackData::SharedPack& pack, RankCommunicator& ranks);

  /** The seed; throws std::invalid_argument where it is negative. */
  std::uint32_t GetCheckedSeed() const;

  /** `Seed`, `Mask` or not, `WindowMargin` and `SampledVolume`. */
  void AddRegionSummary(vtkDataObject* data, const ruc::SamplingRegion& region);

private:
  vtkRUCRegionAlgorithm(const vtkRUCRegionAlgorithm&) = delete;
  void operator=(const vtkRUCRegionAlgorithm&) = delete;

  std::string MaskArray;
  int MaskLabel = 0;
  double WindowMargin = -1.0;
  int Seed = 1;
  double UsedMargin = 0.0; // of the last region
};

#endif
