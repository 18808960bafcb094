// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCOnePointProbability
 * @brief Volume fractions of the phases of a sphere pack
 *
 * Input: a sphere pack with `Mode` (vtkRUCPackAlgorithm). Output, whole on rank 0: the table
 * `Phase` ("1", "2", …, "m" for the matrix), `VolumeFraction`, `VolumeFraction_error` (standard
 * error; 0 for a method without sampling).
 *
 * Sphere Volumes: c_r = volume of the spheres of mode r whose centres lie in the window / volume of
 * the window, c_m = 1 - sum c_r. Where spheres overlap the shared volume counts twice;
 * `OverlapPercent` tells how much that is.
 */
#ifndef vtkRUCOnePointProbability_h
#define vtkRUCOnePointProbability_h

#include "vtkRUCPackAlgorithm.h"

class RUCFILTERS_EXPORT vtkRUCOnePointProbability : public vtkRUCPackAlgorithm
{
public:
  static vtkRUCOnePointProbability* New();
  vtkTypeMacro(vtkRUCOnePointProbability, vtkRUCPackAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Methods
  {
    SPHERE_VOLUMES = 0
  };

  ///@{
  /** The estimator. Default and only choice: SPHERE_VOLUMES. */
  vtkSetMacro(Method, int);
  vtkGetMacro(Method, int);
  ///@}

protected:
  vtkRUCOnePointProbability() = default;
  ~vtkRUCOnePointProbability() override = default;
  const char* GetLabel() const override { return "One-Point Probability"; }
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  void Execute(vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks) override;

private:
  vtkRUCOnePointProbability(const vtkRUCOnePointProbability&) = delete;
  void operator=(const vtkRUCOnePointProbability&) = delete;

  int Method = SPHERE_VOLUMES;
};

#endif
