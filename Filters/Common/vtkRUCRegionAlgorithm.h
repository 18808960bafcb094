// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCRegionAlgorithm
 * @brief What the filters that sample a region of a sphere pack have in common
 *
 * The points of a region are sampled: those of the pack's window (vtkRUCPackAlgorithm) or of a mask
 * image, on the optional second input, without a margin along its border, into which spheres with
 * unknown centres beyond the border may reach. Periodic axes have no border.
 *
 * A point in several spheres belongs to the lowest of their modes, so that overlaps count once.
 * Results depend on the seed, but not on the number of ranks and threads.
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
struct PackTotals;
}

class RUCCOMMON_EXPORT vtkRUCRegionAlgorithm : public vtkRUCPackAlgorithm
{
public:
  vtkTypeMacro(vtkRUCRegionAlgorithm, vtkRUCPackAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * A label or 0/1 image whose voxels (cells, or boxes of the spacing's size around points) are
   * sampled. It takes the place of the window for the sampled methods. The pack must not be
   * periodic.
   */
  void SetMaskConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void RemoveAllMaskConnections() { this->RemoveAllInputConnections(1); }

  ///@{
  /**
   * The array of the mask, which must have one component. Default: "", which stands for the first
   * such array of its points, or else of its cells.
   */
  vtkSetStdStringFromCharMacro(MaskArray);
  vtkGetCharFromStdStringMacro(MaskArray);
  ///@}
  ///@{
  /**
   * The value of the voxels that are inside. Default: 0, which stands for all values but 0. A value
   * that is not a number is outside.
   */
  vtkSetMacro(MaskLabel, int);
  vtkGetMacro(MaskLabel, int);
  ///@}
  ///@{
  /**
   * The thickness of the margin of window or mask that is not sampled. It may be 0 where every
   * sphere that reaches in is known. Default: -1, which stands for the largest radius.
   */
  vtkSetMacro(WindowMargin, double);
  vtkGetMacro(WindowMargin, double);
  ///@}
  ///@{
  /** The seed of the samples, >= 0. Default: 1. */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

protected:
  vtkRUCRegionAlgorithm();
  ~vtkRUCRegionAlgorithm() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

  bool HasMask();
  /** Tells of the mask, too. */
  PackData::WindowProperties GetWindowProperties() override;

  /** Returns the memory of the mask: every rank holds planes of it while a region is made, and then
   * where runs of inside voxels end. */
  ruc::Estimate EstimateRegion() override;

  /**
   * Returns the region, the same on every rank. Throws std::invalid_argument where nothing is left
   * of it. Collective.
   */
  std::unique_ptr<ruc::SamplingRegion> MakeRegion(
    const PackData::SharedPack& pack, RankCommunicator& ranks);

  /** Returns the seed. Throws std::invalid_argument where it is negative. */
  std::uint32_t GetCheckedSeed() const;

  /** Adds the field data `Seed`, `Mask` (1 or 0), `WindowMargin` and `SampledVolume`. */
  void AddRegionSummary(vtkDataObject* data, const ruc::SamplingRegion& region);
  /** Adds the same but for `Seed`, where nothing is random. */
  void AddMarginSummary(vtkDataObject* data, const ruc::SamplingRegion& region);

  /** The margin that a WindowMargin of -1 stands for: the largest radius unless a filter has
   * another. */
  virtual double GetAutomaticMargin(const ruc::PackTotals& pack) const;
  /** The margin of the last region. */
  double GetUsedMargin() const { return this->UsedMargin; }

private:
  vtkRUCRegionAlgorithm(const vtkRUCRegionAlgorithm&) = delete;
  void operator=(const vtkRUCRegionAlgorithm&) = delete;

  std::string MaskArray;
  int MaskLabel = 0;
  double WindowMargin = -1.0;
  int Seed = 1;
  double UsedMargin = 0.0;
};

#endif
