// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCRadialDistribution
 * @brief Radial distribution functions g_rs(r) of the centres of a sphere pack
 *
 * Input: a sphere pack with `Mode` (vtkRUCPackAlgorithm). g_rs(r) is the density of centres of mode
 * s at the distance r from a centre of mode r, over their density in the whole window. Centres that
 * were placed independently have g = 1.
 *
 * The output, whole on rank 0, is a table with the columns `r`; `g_1_1`, `g_1_2`, …, one for each
 * unordered pair of modes; and `g` of all centres, whatever their mode. A row is a bin of the width
 * MaximumLag / NumberOfLags around r. See Core/Statistics/PairSums/RadialDistribution.h.
 */
#ifndef vtkRUCRadialDistribution_h
#define vtkRUCRadialDistribution_h

#include "RUCStatisticsModule.h"
#include "vtkRUCPackAlgorithm.h"

class RUCSTATISTICS_EXPORT vtkRUCRadialDistribution : public vtkRUCPackAlgorithm
{
public:
  static vtkRUCRadialDistribution* New();
  vtkTypeMacro(vtkRUCRadialDistribution, vtkRUCPackAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The last distance. It is at most the shortest edge of the window that is not periodic less half
   * a bin, or four shortest edges of a periodic box. Default: 0, which stands for half the shortest
   * edge, as in vtkRUCTwoPointProbability.
   */
  vtkSetMacro(MaximumLag, double);
  vtkGetMacro(MaximumLag, double);
  ///@}
  ///@{
  /** K, the number of distances after 0; 1 to 100 000. Default: 277. */
  vtkSetMacro(NumberOfLags, int);
  vtkGetMacro(NumberOfLags, int);
  ///@}

protected:
  vtkRUCRadialDistribution() = default;
  ~vtkRUCRadialDistribution() override = default;
  const char* GetLabel() const override { return "Radial Distribution"; }
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  void Execute(vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks) override;
  std::optional<ruc::Estimate> MakeEstimate() override;

private:
  vtkRUCRadialDistribution(const vtkRUCRadialDistribution&) = delete;
  void operator=(const vtkRUCRadialDistribution&) = delete;

  double MaximumLag = 0.0;
  int NumberOfLags = 277;
};

#endif
