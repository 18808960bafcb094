// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCParticleModes
 * @brief Sorts the spheres of a pack into modes, classes of particle size
 *
 * Input: a sphere pack (vtkRUCPackAlgorithm). Output 0: the same points on the same ranks, without
 * the spheres below MinimumDiameter, with the point array `Mode` (int, 1 to the number of modes, by
 * ascending diameter). Output 1, whole on rank 0: the table `Mode`, `Count`, `MinimumDiameter`,
 * `MaximumDiameter`, `VolumeMeanDiameter` ((sum d^3 / Count)^(1/3)), `VolumeFraction`.
 *
 * Modes that would be empty are left out, with a warning, and the others are numbered without a
 * gap.
 */
#ifndef vtkRUCParticleModes_h
#define vtkRUCParticleModes_h

#include "RUCPacksModule.h"
#include "vtkRUCPackAlgorithm.h"

#include <vector>

namespace PackData
{
struct PackOrigin;
}
namespace ruc
{
class ParticleModes;
}

class RUCPACKS_EXPORT vtkRUCParticleModes : public vtkRUCPackAlgorithm
{
public:
  static vtkRUCParticleModes* New();
  vtkTypeMacro(vtkRUCParticleModes, vtkRUCPackAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Methods
  {
    EQUAL_WIDTH = 0,
    EQUAL_VOLUME = 1,
    EXPLICIT_EDGES = 2,
    ONE_PER_SIZE = 3
  };

  ///@{
  /** How the range of diameters is divided. Default: EQUAL_WIDTH. */
  vtkSetMacro(Method, int);
  vtkGetMacro(Method, int);
  ///@}
  ///@{
  /** The number of modes wanted by EQUAL_WIDTH and EQUAL_VOLUME, 1 to 256. Default: 9. */
  vtkSetMacro(NumberOfModes, int);
  vtkGetMacro(NumberOfModes, int);
  ///@}
  ///@{
  /**
   * The edges for EXPLICIT_EDGES: 2 to 257 ascending diameters >= 0, between which the diameters of
   * all spheres lie that MinimumDiameter keeps. Mode i holds edge i <= d < edge i + 1, the last
   * mode its upper edge as well. Default: none.
   */
  void ClearEdges();
  void SetEdge(int i, double diameter);
  int GetNumberOfEdges() const { return static_cast<int>(this->Edges.size()); }
  double GetEdge(int i) const { return this->Edges[i]; }
  ///@}
  ///@{
  /** Spheres of a smaller diameter, such as debris, are left out. Default: 0, which keeps all. */
  vtkSetMacro(MinimumDiameter, double);
  vtkGetMacro(MinimumDiameter, double);
  ///@}

protected:
  vtkRUCParticleModes();
  ~vtkRUCParticleModes() override = default;
  const char* GetLabel() const override { return "Particle Modes"; }
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  void Execute(vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks) override;
  std::optional<ruc::Estimate> MakeEstimate() override;

private:
  vtkRUCParticleModes(const vtkRUCParticleModes&) = delete;
  void operator=(const vtkRUCParticleModes&) = delete;

  // Warns on rank 0 where modes would hold no sphere
  ruc::ParticleModes FindModes(const std::vector<double>& radii, RankCommunicator& ranks);
  void AddSummary(
    vtkDataObject* data, const PackData::PackOrigin& origin, const ruc::ParticleModes& modes) const;

  int Method = EQUAL_WIDTH;
  int NumberOfModes = 9;
  std::vector<double> Edges;
  double MinimumDiameter = 0.0;
};

#endif
