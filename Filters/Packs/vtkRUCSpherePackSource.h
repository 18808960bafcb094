// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCSpherePackSource
 * @brief Makes random packs of hard spheres, up to random close packing
 *
 * Output 0, whole on rank 0: the pack, points with vertex cells and the arrays `Radius`, `Mode` and
 * `Id`, in a box from the origin whose volume follows from the spheres and Fraction. Field data:
 * the window, periodic where there is no wall, `NumberOfSpheres`, `Fraction`, `MaximumFraction`,
 * `ReducedPressure` (after an equilibration the mean and `ReducedPressureError`),
 * `CoordinationNumber`, `RattlerPercent`, `Q6`, `Protocol`, `Seed`, `Stopped`. No two spheres
 * overlap, not by the last digit (Core/Packing/DensePack.h).
 *
 * Output 1, whole on rank 0: the table of the growth, `Collisions` of a sphere, `Fraction`,
 * `ReducedPressure`, `Rate`. It has no rows where the spheres did not need to collide.
 *
 * Rank 0 works alone, so that the pack is the same for any number of ranks. A pack that jams below
 * Fraction is an error that tells the fraction that was reached, and so is one that crystallises as
 * it grows (Q6 above 0.1, and above what few spheres have by chance). One that is stopped has the
 * same spheres in a larger box.
 */
#ifndef vtkRUCSpherePackSource_h
#define vtkRUCSpherePackSource_h

#include "RUCPacksModule.h"
#include "vtkRUCEstimatedAlgorithm.h"

#include <memory>
#include <string>
#include <vector>

namespace ruc
{
struct DensePack;
struct DensePackSettings;
struct PackOrder;
struct SizeTable;
struct SphereSizes;
}

class ProgressReport;

class RUCPACKS_EXPORT vtkRUCSpherePackSource : public vtkRUCEstimatedAlgorithm
{
public:
  static vtkRUCSpherePackSource* New();
  vtkTypeMacro(vtkRUCSpherePackSource, vtkRUCEstimatedAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum SizeLaws
  {
    EQUAL = 0,
    CLASSES = 1,
    LOG_NORMAL = 2,
    GAUSSIAN = 3,
    FILE_OF_SIZES = 4
  };
  enum Protocols
  {
    AUTOMATIC = 0,
    SOFT = 1,
    EVENTS = 2
  };
  enum Switches
  {
    SWITCH_AUTOMATIC = 0,
    SWITCH_OFF = 1,
    SWITCH_ON = 2
  };

  ///@{
  /** How many spheres, 2 to 10^7. Default: 1000. */
  vtkSetMacro(NumberOfSpheres, int);
  vtkGetMacro(NumberOfSpheres, int);
  ///@}
  ///@{
  /** The fraction of the box that the spheres fill, above 0. Default: 0.6. */
  vtkSetMacro(Fraction, double);
  vtkGetMacro(Fraction, double);
  ///@}
  ///@{
  /** The seed of all random numbers, >= 0. Default: 1. */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}
  ///@{
  /** How the diameters are distributed. Default: EQUAL. */
  vtkSetMacro(Sizes, int);
  vtkGetMacro(Sizes, int);
  ///@}
  ///@{
  /** The diameters of the classes for CLASSES, each above 0. Default: none. */
  void ClearDiameters();
  void SetDiameter(int place, double diameter);
  ///@}
  ///@{
  /** For each of them its share, above 0, in any unit. Default: none. */
  void ClearShares();
  void SetShare(int place, double share);
  ///@}
  ///@{
  /** Whether shares count the spheres' volumes or their numbers. Default: true, volumes. */
  vtkSetMacro(SharesByVolume, bool);
  vtkGetMacro(SharesByVolume, bool);
  vtkBooleanMacro(SharesByVolume, bool);
  ///@}
  ///@{
  /** The mean diameter of EQUAL, LOG_NORMAL and GAUSSIAN, above 0. Default: 1. */
  vtkSetMacro(MeanDiameter, double);
  vtkGetMacro(MeanDiameter, double);
  ///@}
  ///@{
  /** The standard deviation of the diameter for LOG_NORMAL and GAUSSIAN, above 0. Default: 0.2. */
  vtkSetMacro(StandardDeviation, double);
  vtkGetMacro(StandardDeviation, double);
  ///@}
  ///@{
  /**
   * Diameters, or for LOG_NORMAL their logarithms, that are more than this many standard deviations
   * from the mean do not occur; above 0, at most 6. Default: 2.5.
   */
  vtkSetMacro(Cut, double);
  vtkGetMacro(Cut, double);
  ///@}
  ///@{
  /**
   * The file of the sizes for FILE_OF_SIZES, where rank 0 runs: one diameter a line, or a sieve
   * curve, the opening of a sieve and the per cent of the volume that passes it a line
   * (Core/Formats/SizeTable.h). Default: empty.
   */
  vtkSetMacro(FileName, std::string);
  vtkGetMacro(FileName, std::string);
  ///@}
  ///@{
  /** The edges of the box in proportion to each other, each above 0. Default: 1, 1, 1. */
  vtkSetVector3Macro(BoxProportions, double);
  vtkGetVector3Macro(BoxProportions, double);
  ///@}
  ///@{
  /**
   * Whether the box ends in hard walls across x, y and z; else it is periodic. Default: 0, 0, 0.
   */
  vtkSetVector3Macro(Walls, int);
  vtkGetVector3Macro(Walls, int);
  ///@}
  ///@{
  /** How the pack is made (ruc::PackingProtocol). Default: AUTOMATIC. */
  vtkSetMacro(Protocol, int);
  vtkGetMacro(Protocol, int);
  ///@}
  ///@{
  /**
   * The growth of EVENTS, in diameters in the unit of time, in which a sphere flies about one mean
   * diameter; 0 to 1. Default: 0, which stands for a rate that suits the fraction, and for slower
   * ones where the spheres jam.
   */
  vtkSetMacro(Rate, double);
  vtkGetMacro(Rate, double);
  ///@}
  ///@{
  /**
   * Whether spheres exchange their radii while they grow (ruc::HardSpheres). Default:
   * SWITCH_AUTOMATIC, for LOG_NORMAL, GAUSSIAN and FILE_OF_SIZES.
   */
  vtkSetMacro(Exchange, int);
  vtkGetMacro(Exchange, int);
  ///@}
  ///@{
  /** How often each sphere collides once it has its size, 0 to 10^9. Default: 0. */
  vtkSetMacro(EquilibrationTime, double);
  vtkGetMacro(EquilibrationTime, double);
  ///@}
  ///@{
  /**
   * The file that holds the state of a pack on the way, where rank 0 runs. It is written every
   * CheckpointInterval seconds and where the work is stopped; if it exists, the work goes on from
   * it, to the same pack, bit by bit. Default: empty, for none.
   */
  vtkSetMacro(CheckpointFile, std::string);
  vtkGetMacro(CheckpointFile, std::string);
  ///@}
  ///@{
  /** The seconds between two states in the CheckpointFile, >= 0. Default: 60. */
  vtkSetMacro(CheckpointInterval, double);
  vtkGetMacro(CheckpointInterval, double);
  ///@}
  ///@{
  /** The unit of length, a text that the data carries along. Default: empty. */
  vtkSetMacro(LengthUnit, std::string);
  vtkGetMacro(LengthUnit, std::string);
  ///@}

protected:
  vtkRUCSpherePackSource();
  ~vtkRUCSpherePackSource() override;
  const char* GetLabel() const override { return "Sphere Pack Source"; }
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  void Execute(
    vtkInformationVector** inputs, vtkInformationVector* outputs, RankCommunicator& ranks) override;
  std::optional<ruc::Estimate> MakeEstimate() override;

private:
  vtkRUCSpherePackSource(const vtkRUCSpherePackSource&) = delete;
  void operator=(const vtkRUCSpherePackSource&) = delete;

  void CheckProperties() const;
  ruc::SphereSizes MakeSizes();
  const ruc::SizeTable& ReadSizes();
  // With the radii of so many spheres
  ruc::DensePackSettings MakeSettings(const std::vector<double>& radii) const;
  // Goes on from the checkpoint, if there is one, and writes it
  ruc::DensePack MakeSpheres(const ruc::DensePackSettings& settings, ProgressReport& report);
  // Fills the outputs of rank 0
  void Make(vtkInformationVector* outputs, ProgressReport& report);
  // Throws, or warns after an equilibration, where the spheres are no random pack
  void RequireNoCrystal(const ruc::PackOrder& order);
  void AddSummary(
    const ruc::DensePack& made, const ruc::PackOrder& order, vtkDataObject* data) const;

  int NumberOfSpheres = 1000;
  double Fraction = 0.6;
  int Seed = 1;
  int Sizes = EQUAL;
  std::vector<double> Diameters, Shares;
  bool SharesByVolume = true;
  double MeanDiameter = 1.0;
  double StandardDeviation = 0.2;
  double Cut = 2.5;
  std::string FileName;
  double BoxProportions[3] = { 1.0, 1.0, 1.0 };
  int Walls[3] = { 0, 0, 0 };
  int Protocol = AUTOMATIC;
  double Rate = 0.0;
  int Exchange = SWITCH_AUTOMATIC;
  double EquilibrationTime = 0.0;
  std::string CheckpointFile;
  double CheckpointInterval = 60.0;
  std::string LengthUnit;
  // What was read last, for estimates ask often
  struct SizeFile;
  std::unique_ptr<SizeFile> LastSizes;
};

#endif
