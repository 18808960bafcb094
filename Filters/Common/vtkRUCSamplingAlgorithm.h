// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCSamplingAlgorithm
 * @brief What the filters with chord and template sampling have in common
 *
 * Chord Sampling takes grids of parallel lines of random directions through the region
 * (vtkRUCRegionAlgorithm), Template Sampling throws the paper's template of points (Fig. 4 of Lee
 * et al., Phys. Rev. E 80, 061301, 2009). Standard errors come from batches of samples.
 */
#ifndef vtkRUCSamplingAlgorithm_h
#define vtkRUCSamplingAlgorithm_h

#include "vtkRUCRegionAlgorithm.h"

namespace ruc
{
struct SamplingSettings;
}

class RUCCOMMON_EXPORT vtkRUCSamplingAlgorithm : public vtkRUCRegionAlgorithm
{
public:
  vtkTypeMacro(vtkRUCSamplingAlgorithm, vtkRUCRegionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

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
  vtkRUCSamplingAlgorithm() = default;
  ~vtkRUCSamplingAlgorithm() override = default;

  /** For NumberOfLines or, `throws`, NumberOfThrows. */
  ruc::SamplingSettings GetSettings(bool throws) const;

private:
  vtkRUCSamplingAlgorithm(const vtkRUCSamplingAlgorithm&) = delete;
  void operator=(const vtkRUCSamplingAlgorithm&) = delete;

  int NumberOfLines = 20000;
  int NumberOfThrows = 2000;
  double TargetError = 0.0;
};

#endif
