// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCThirdOrderParameters
 * @brief Zeta, eta and all three-point integrals I_qrs and J_qrs of a sphere pack, without sampling
 *
 * Input: a pack of spheres that do not overlap, with `Mode` (vtkRUCPackAlgorithm). The parameters
 * follow from multipoles around the centres (Core/Statistics/ThirdOrder/ThirdOrderOfSpheres.h). In
 * a box that is periodic along all axes every sphere is a centre; elsewhere centres lie CutOff from
 * every face. Standard errors are from leaving out one block of space at a time.
 *
 * The tables are whole on rank 0. Output 0 has a row for each phase, against all that is not this
 * phase: `Phase` (spheres, then the modes where they are phases, and m), `VolumeFraction`, `zeta`,
 * `zeta_error` and, with Eta, `eta` and `eta_error`.
 *
 * Output 1 has a row for each triple of phases q and r <= s: `q`, `r`, `s`, `I`, `I_error` and,
 * with Eta, `J` and `J_error`.
 *
 * Output 2 is the spectrum by degree `l`: `Z`, whose sum, with field data `RestOfZeta` for the
 * higher degrees, is zeta of the spheres; `Z_error`; and, with modes as phases, the parts
 * `Z_q_r_s`, of which those with r < s count twice.
 *
 * Output 3 is the pack, in shares over the ranks, with `FieldEnergy`, the part of each sphere in
 * zeta: the mean over the centres, weighted by volume, is zeta. It is NaN for spheres that are no
 * centres.
 *
 * Output 4 has slabs across each axis: `Axis`, `From`, `To`, `NumberOfCentres`, `VolumeFraction`,
 * `zeta` and `zeta_error`.
 */
#ifndef vtkRUCThirdOrderParameters_h
#define vtkRUCThirdOrderParameters_h

#include "RUCStatisticsModule.h"
#include "vtkRUCPackAlgorithm.h"

namespace ruc
{
struct ThirdOrderOfSpheres;
struct ThirdOrderSettings;
}

class RUCSTATISTICS_EXPORT vtkRUCThirdOrderParameters : public vtkRUCPackAlgorithm
{
public:
  static vtkRUCThirdOrderParameters* New();
  vtkTypeMacro(vtkRUCThirdOrderParameters, vtkRUCPackAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Ports
  {
    PARAMETERS = 0,
    INTEGRALS = 1,
    SPECTRUM = 2,
    PACK = 3,
    SLABS = 4
  };

  enum PhaseChoice
  {
    SPHERES = 0,
    MODES = 1
  };

  ///@{
  /** Whether all spheres are one phase, or every mode is one, of at most 32. Default: SPHERES. */
  vtkSetMacro(Phases, int);
  vtkGetMacro(Phases, int);
  ///@}
  ///@{
  /**
   * Up to here spheres count as neighbours of a centre, at least two largest diameters. Default: 0,
   * which stands for four mean diameters, more where spheres are sparse or of very different sizes.
   */
  vtkSetMacro(CutOff, double);
  vtkGetMacro(CutOff, double);
  ///@}
  ///@{
  /** The highest degree of the multipoles, 4 to 14. Default: 10. */
  vtkSetMacro(MaximumDegree, int);
  vtkGetMacro(MaximumDegree, int);
  ///@}
  ///@{
  /** Whether eta and J_qrs are found, which takes about half as long again. Default: on. */
  vtkSetMacro(Eta, bool);
  vtkGetMacro(Eta, bool);
  ///@}
  ///@{
  /** About the number of blocks for the standard errors, 2 to 1000. Default: 32. */
  vtkSetMacro(Blocks, int);
  vtkGetMacro(Blocks, int);
  ///@}
  ///@{
  /** The number of slabs across each axis, 1 to 100. Default: 4. */
  vtkSetMacro(Slabs, int);
  vtkGetMacro(Slabs, int);
  ///@}

protected:
  vtkRUCThirdOrderParameters();
  ~vtkRUCThirdOrderParameters() override = default;
  const char* GetLabel() const override { return "Third-Order Parameters"; }
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  void Execute(vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks) override;
  std::optional<ruc::Estimate> MakeEstimate() override;

private:
  vtkRUCThirdOrderParameters(const vtkRUCThirdOrderParameters&) = delete;
  void operator=(const vtkRUCThirdOrderParameters&) = delete;

  ruc::ThirdOrderSettings MakeSettings() const;
  void AddSummary(const ruc::ThirdOrderOfSpheres& found, vtkDataObject* data) const;
  void Warn(const ruc::ThirdOrderOfSpheres& found);

  int Phases = SPHERES;
  double CutOff = 0.0;
  int MaximumDegree = 10;
  bool Eta = true;
  int Blocks = 32;
  int Slabs = 4;
};

#endif
