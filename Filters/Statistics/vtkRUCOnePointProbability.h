// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCOnePointProbability
 * @brief Volume fractions of the phases of a sphere pack
 *
 * Input: a sphere pack with `Mode` (vtkRUCPackAlgorithm), and for the sampled methods an optional
 * mask (vtkRUCSamplingAlgorithm). The output, whole on rank 0, is a table with the columns `Phase`
 * ("1", "2", …, and "m" for the matrix), `VolumeFraction` and, for a sampled method,
 * `VolumeFraction_error`, the standard error, also a fraction. Sphere Volumes cannot tell by how
 * much the fractions of one pack differ from those of another of its kind, and gives no errors.
 *
 * Sphere Volumes: c_r is the volume of the spheres of mode r whose centres lie in the window over
 * the volume of the window, and c_m = 1 - sum c_r. Where spheres overlap, the shared volume counts
 * twice; `OverlapPercent` tells how much that is.
 *
 * Chord Sampling and Template Sampling: c_r is the share of the lines' length, or of the throws'
 * centres, that lies in phase r. TargetError bounds the sum of the standard errors over the phases.
 */
#ifndef vtkRUCOnePointProbability_h
#define vtkRUCOnePointProbability_h

#include "RUCStatisticsModule.h"
#include "vtkRUCSamplingAlgorithm.h"

class ProgressReport;
class vtkTable;
namespace ruc
{
struct SampledTwoPoint;
}

class RUCSTATISTICS_EXPORT vtkRUCOnePointProbability : public vtkRUCSamplingAlgorithm
{
public:
  static vtkRUCOnePointProbability* New();
  vtkTypeMacro(vtkRUCOnePointProbability, vtkRUCSamplingAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Methods
  {
    SPHERE_VOLUMES = 0,
    CHORD_SAMPLING = 1,
    TEMPLATE_SAMPLING = 2
  };

  ///@{
  /** The estimator. Default: SPHERE_VOLUMES. */
  vtkSetMacro(Method, int);
  vtkGetMacro(Method, int);
  ///@}

protected:
  vtkRUCOnePointProbability() = default;
  ~vtkRUCOnePointProbability() override = default;
  const char* GetLabel() const override { return "One-Point Probability"; }
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  void Execute(vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks) override;
  std::optional<ruc::Estimate> MakeEstimate() override;

private:
  vtkRUCOnePointProbability(const vtkRUCOnePointProbability&) = delete;
  void operator=(const vtkRUCOnePointProbability&) = delete;

  void ValidateProperties();
  // Samples by lines or throws, and tells about them in the table's field data
  ruc::SampledTwoPoint Sample(const PackData::SharedPack& pack, vtkTable* table,
    RankCommunicator& ranks, ProgressReport& report);

  int Method = SPHERE_VOLUMES;
};

#endif
