// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCNeighbourStatistics
 * @brief Contacts, gaps and radical Voronoi cells of a sphere pack
 *
 * Input: a sphere pack with `Mode` (vtkRUCPackAlgorithm) and an optional mask
 * (vtkRUCRegionAlgorithm). The gap of two spheres of radii a and b is d / (a + b) - 1. Spheres in
 * the region, WindowMargin from every face, count; all are their neighbours. Standard errors are
 * those of the jackknife over blocks (Core/Statistics/Neighbours/NeighbourStatistics.h).
 *
 * Output 0 is the pack, in shares over the ranks, with `CoordinationNumber`; `NearestGap`, from
 * surface to surface in the unit of the pack; `LocalFraction`, `Q4`, `Q6` and `NumberOfFaces` of
 * the radical cell; `Rattler` (1 or 0); `Whole`, which is 1 where the sphere counts and its cell is
 * known. What is not known is NaN, and 0 for the number of faces.
 *
 * Output 1 has the contacts as lines, each on one rank, with the cell arrays `Gap`, `Mode1` and
 * `Mode2`. A line across a periodic face ends outside the box.
 *
 * The tables are whole on rank 0. Output 2 has the mean number of neighbours with a gap up to `x`:
 * `N` and `N_error` of all spheres, and, with at most 32 modes, `N_r_s` of mode s around spheres of
 * mode r, each with its error. Output 3 has the means over the spheres of each mode, and last of
 * all: `CoordinationNumber`, `NearestGap`, `LocalFraction`, `NumberOfFaces`, `Q4`, `Q6`,
 * `Rattlers`, `CoordinationWithoutRattlers`, `ExcessCoordination`, which is the latter less the 6
 * of an isostatic pack without friction, and the fabric tensor `Fabric_xx` to `Fabric_xy`, each
 * with its error.
 */
#ifndef vtkRUCNeighbourStatistics_h
#define vtkRUCNeighbourStatistics_h

#include "RUCStatisticsModule.h"
#include "vtkRUCRegionAlgorithm.h"

namespace ruc
{
struct NeighbourSettings;
struct NeighbourStatistics;
}

class RUCSTATISTICS_EXPORT vtkRUCNeighbourStatistics : public vtkRUCRegionAlgorithm
{
public:
  static vtkRUCNeighbourStatistics* New();
  vtkTypeMacro(vtkRUCNeighbourStatistics, vtkRUCRegionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Ports
  {
    PACK = 0,
    CONTACTS = 1,
    GAPS = 2,
    MEANS = 3
  };

  ///@{
  /** Two spheres up to this gap touch; from 0 to MaximumGap. Default: 0.02. */
  vtkSetMacro(ContactTolerance, double);
  vtkGetMacro(ContactTolerance, double);
  ///@}
  ///@{
  /** The last gap of output 2, above 0 and at most 2. Default: 0.2. */
  vtkSetMacro(MaximumGap, double);
  vtkGetMacro(MaximumGap, double);
  ///@}
  ///@{
  /** The number of steps up to it, 1 to 10 000. Default: 100. */
  vtkSetMacro(NumberOfGaps, int);
  vtkGetMacro(NumberOfGaps, int);
  ///@}
  ///@{
  /** About the number of blocks for the standard errors, 2 to 1000. Default: 32. */
  vtkSetMacro(Blocks, int);
  vtkGetMacro(Blocks, int);
  ///@}

protected:
  vtkRUCNeighbourStatistics();
  ~vtkRUCNeighbourStatistics() override = default;
  const char* GetLabel() const override { return "Neighbour Statistics"; }
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  void Execute(vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks) override;
  std::optional<ruc::Estimate> MakeEstimate() override;
  /** One and a half diameters of the largest sphere, more for a MaximumGap above 0.5. */
  double GetAutomaticMargin(const ruc::PackTotals& pack) const override;

private:
  vtkRUCNeighbourStatistics(const vtkRUCNeighbourStatistics&) = delete;
  void operator=(const vtkRUCNeighbourStatistics&) = delete;

  ruc::NeighbourSettings MakeSettings() const;
  void AddSummary(const ruc::NeighbourStatistics& found, vtkDataObject* data) const;
  void Warn(const ruc::NeighbourStatistics& found);

  double ContactTolerance = 0.02;
  double MaximumGap = 0.2;
  int NumberOfGaps = 100;
  int Blocks = 32;
};

#endif
