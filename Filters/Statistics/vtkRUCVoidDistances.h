// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCVoidDistances
 * @brief How wide the pores of a sphere pack are
 *
 * Input: a sphere pack with `Mode` (vtkRUCPackAlgorithm) and an optional mask
 * (vtkRUCRegionAlgorithm). delta is the distance from a point of the matrix to the nearest surface
 * of a sphere, at the points of a lattice in the region
 * (Core/Statistics/Neighbours/VoidDistances.h). Overlaps make no difference.
 *
 * The tables are whole on rank 0. Output 0 has the distances `z` and `P`, the share of the points
 * of the matrix with delta > z, with `P_error`. Output 1 has a row for each `Quantity` with its
 * `Value` and `Error`: "mean distance", "largest distance", whose error is NaN, and "critical
 * radius x", y and z, of the largest sphere that fits through the matrix along that axis. These are
 * NaN in a mask, and in a cylinder that does not lie along an axis.
 */
#ifndef vtkRUCVoidDistances_h
#define vtkRUCVoidDistances_h

#include "RUCStatisticsModule.h"
#include "vtkRUCRegionAlgorithm.h"

namespace ruc
{
struct VoidDistances;
struct VoidSettings;
}

class RUCSTATISTICS_EXPORT vtkRUCVoidDistances : public vtkRUCRegionAlgorithm
{
public:
  static vtkRUCVoidDistances* New();
  vtkTypeMacro(vtkRUCVoidDistances, vtkRUCRegionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Ports
  {
    DISTANCES = 0,
    PORES = 1
  };

  ///@{
  /**
   * The spacing of the lattice. Default: 0, which stands for a twentieth of the mean diameter, more
   * where there would be more than some 16 million points.
   */
  vtkSetMacro(Spacing, double);
  vtkGetMacro(Spacing, double);
  ///@}
  ///@{
  /**
   * The last distance z. Farther points count as that. Default: 0, which stands for about a mean
   * diameter, more where spheres are sparse.
   */
  vtkSetMacro(MaximumDistance, double);
  vtkGetMacro(MaximumDistance, double);
  ///@}
  ///@{
  /** The number of distances after 0, 1 to 100 000. Default: 200. */
  vtkSetMacro(NumberOfDistances, int);
  vtkGetMacro(NumberOfDistances, int);
  ///@}
  ///@{
  /** About the number of blocks for the standard errors, 2 to 1000. Default: 32. */
  vtkSetMacro(Blocks, int);
  vtkGetMacro(Blocks, int);
  ///@}

protected:
  vtkRUCVoidDistances();
  ~vtkRUCVoidDistances() override = default;
  const char* GetLabel() const override { return "Void Distances"; }
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  void Execute(vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks) override;
  std::optional<ruc::Estimate> MakeEstimate() override;
  /** The largest radius and MaximumDistance, so that no sphere beyond the border is nearer. */
  double GetAutomaticMargin(const ruc::PackTotals& pack) const override;

private:
  vtkRUCVoidDistances(const vtkRUCVoidDistances&) = delete;
  void operator=(const vtkRUCVoidDistances&) = delete;

  ruc::VoidSettings MakeSettings() const;
  void AddSummary(const ruc::VoidDistances& found, vtkDataObject* data) const;

  double Spacing = 0.0;
  double MaximumDistance = 0.0;
  int NumberOfDistances = 200;
  int Blocks = 32;
};

#endif
