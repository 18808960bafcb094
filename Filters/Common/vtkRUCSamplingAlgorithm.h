// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCSamplingAlgorithm
 * @brief What the filters with chord and template sampling have in common
 *
 * Chord Sampling takes grids of parallel lines of random directions through the region
 * (vtkRUCRegionAlgorithm). Template Sampling throws the paper's template of points (Fig. 4 of Lee
 * et al., Phys. Rev. E 80, 061301, 2009). Standard errors come from the scatter of batches of
 * samples, and have the unit of the values.
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
   * About how many lines Chord Sampling takes, >= 1. They lie in 64 grids of random direction, or
   * in more where the lines of a grid would be closer to each other than the spheres. Field data
   * `NumberOfLines` tells how many lines there were. Default: 20 000.
   */
  vtkSetMacro(NumberOfLines, int);
  vtkGetMacro(NumberOfLines, int);
  ///@}
  ///@{
  /** How many throws Template Sampling takes, >= 1. Default: 2000. */
  vtkSetMacro(NumberOfThrows, int);
  vtkGetMacro(NumberOfThrows, int);
  ///@}
  ///@{
  /**
   * Where this is > 0, samples are taken until the standard errors add up to it, instead of a given
   * number of samples. The filters say how the errors add up. Default: 0.
   */
  vtkSetMacro(TargetError, double);
  vtkGetMacro(TargetError, double);
  ///@}

protected:
  vtkRUCSamplingAlgorithm() = default;
  ~vtkRUCSamplingAlgorithm() override = default;

  /** Returns the settings with NumberOfLines, or, for `throws`, with NumberOfThrows. */
  ruc::SamplingSettings GetSettings(bool throws) const;

private:
  vtkRUCSamplingAlgorithm(const vtkRUCSamplingAlgorithm&) = delete;
  void operator=(const vtkRUCSamplingAlgorithm&) = delete;

  int NumberOfLines = 20000;
  int NumberOfThrows = 2000;
  double TargetError = 0.0;
};

#endif
