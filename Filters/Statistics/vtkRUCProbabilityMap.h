// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCProbabilityMap
 * @brief Two-point probability functions S_rs(x) of a sphere pack over lag vectors x
 *
 * Input: a sphere pack with `Mode` (vtkRUCPackAlgorithm). S_rs(x) is the probability that a point y
 * lies in phase r and y + x in phase s, the mean over x and -x, by the exact sum over pairs for
 * spheres that do not overlap (Core/Statistics/PairSums/ProbabilityMap.h). Phases are the modes
 * 1…N_p and the matrix m.
 *
 * The output is an image over the lag vectors x, with an array `S_m_m`, … for each of the
 * PhasePairs, in slabs over the ranks. Its centre is x = 0.
 */
#ifndef vtkRUCProbabilityMap_h
#define vtkRUCProbabilityMap_h

#include "RUCStatisticsModule.h"
#include "vtkRUCPackAlgorithm.h"

#include <string>

namespace ruc
{
struct PackShare;
struct ProbabilityMap;
}

class RUCSTATISTICS_EXPORT vtkRUCProbabilityMap : public vtkRUCPackAlgorithm
{
public:
  static vtkRUCProbabilityMap* New();
  vtkTypeMacro(vtkRUCProbabilityMap, vtkRUCPackAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The pairs of phases, such as "1 1; 3 m; m m". Default: "m m". */
  vtkSetStdStringFromCharMacro(PhasePairs);
  vtkGetCharFromStdStringMacro(PhasePairs);
  ///@}
  ///@{
  /**
   * The number of lag vectors from the centre of the image to each of its faces, 1 to 1000.
   * Default: 20, which gives an image of 41^3.
   */
  vtkSetMacro(Resolution, int);
  vtkGetMacro(Resolution, int);
  ///@}
  ///@{
  /**
   * The distance of neighbouring lag vectors. Default: 0, which stands for MaximumLag / Resolution.
   */
  vtkSetMacro(Spacing, double);
  vtkGetMacro(Spacing, double);
  ///@}
  ///@{
  /**
   * The largest lag along each axis, where Spacing is 0. Default: 0, which stands for half the
   * shortest edge of the window, as in vtkRUCTwoPointProbability. The image reaches less far where
   * a window without periodic axes does not hold its corners (ruc::LagLimit::ForMap).
   */
  vtkSetMacro(MaximumLag, double);
  vtkGetMacro(MaximumLag, double);
  ///@}

protected:
  vtkRUCProbabilityMap() = default;
  ~vtkRUCProbabilityMap() override = default;
  const char* GetLabel() const override { return "Probability Map"; }
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;
  void Execute(vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks) override;
  std::optional<ruc::Estimate> MakeEstimate() override;

private:
  vtkRUCProbabilityMap(const vtkRUCProbabilityMap&) = delete;
  void operator=(const vtkRUCProbabilityMap&) = delete;

  void ValidateProperties() const;
  // The distance from the centre of the image to its faces
  double FindReach(const ruc::PackShare& share) const;
  // Fills this rank's slab; the map is the same on all ranks
  void FillImage(const ruc::ProbabilityMap& map, int modes, const RankCommunicator& ranks,
    vtkInformationVector* outputs) const;

  std::string PhasePairs = "m m";
  int Resolution = 20;
  double Spacing = 0.0;
  double MaximumLag = 0.0;
};

#endif
