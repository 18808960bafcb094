// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCSpherePackReader
 * @brief Reads sphere packs as other programs write them
 *
 * Core/Formats/PackFormats.h lists the formats; each grammar stands in a file of its own. The
 * contents of the file decide which of them it has, unless `Format` does.
 *
 * Frames are time steps. RequestInformation finds them in one pass of the file, which is made again
 * only if the file has changed; RequestData holds one frame at a time, the last that is not later
 * than the time asked for. A file with one frame that tells no time has no time steps, so that
 * vtkFileSeriesReader numbers such files.
 *
 * Output: points (double) with vertex cells in the order of their ids, and the arrays `Radius`
 * (double), `Id` (the place in the file from 0 if it has none), `Type` (int) and `Mode` (int) if
 * the file has them. Field data: the window, which is the box of the file if that is periodic along
 * all axes, or as `BoxSize` says; `NumberOfGhosts`, the number of rows that only repeated a sphere
 * in a neighbouring image of the box and were left out; `LengthUnit`; `TimeValue`, if the frame has
 * a time or step; `TypeNames`, if types are names, with numbers from 1. GetSummary, and a line of
 * the log, tell what was read.
 *
 * Rank 0 reads the file and holds the whole output; the times of the frames are made known to all
 * ranks. A file that cannot be read gives an error and an output that is empty but for the field
 * data `Refusal`; with such an input every filter of this plugin is empty on all ranks.
 */
#ifndef vtkRUCSpherePackReader_h
#define vtkRUCSpherePackReader_h

#include "RUCReadersModule.h"

#include "vtkPolyDataAlgorithm.h"

#include <memory>
#include <set>
#include <string>
#include <vector>

namespace ruc
{
struct FoundWindow;
struct FramePack;
struct PackSettings;
struct ReadSettings;
}
class PackFiles;
class vtkMultiProcessController;

class RUCREADERS_EXPORT vtkRUCSpherePackReader : public vtkPolyDataAlgorithm
{
public:
  static vtkRUCSpherePackReader* New();
  vtkTypeMacro(vtkRUCSpherePackReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  /** Returns the name with which messages begin. */
  std::string GetObjectDescription() const override { return "Sphere Pack Reader"; }

  ///@{
  /** The file to read, on the machine of rank 0. */
  vtkSetStdStringFromCharMacro(FileName);
  vtkGetCharFromStdStringMacro(FileName);
  ///@}
  /**
   * Returns whether the name leads to a regular file whose first 4 KiB, after unpacking, have the
   * sign of a format.
   */
  static int CanReadFile(const char* fileName);

  ///@{
  /** The ranks that are told the times of frames. Default: those of the global controller. */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController() const { return this->Controller; }
  ///@}

  ///@{
  /** The name of the format (ruc::PackFormat::Name), or "Automatic", the default. */
  vtkSetStdStringFromCharMacro(Format);
  vtkGetCharFromStdStringMacro(Format);
  ///@}
  ///@{
  /**
   * The names of the columns of a table, such as "id,x,y,z,r", where - skips one. Default: empty;
   * then the file tells.
   */
  vtkSetStdStringFromCharMacro(Columns);
  vtkGetCharFromStdStringMacro(Columns);
  ///@}
  ///@{
  /** The radius of all spheres, in the unit after scaling, if the file tells none. Default: 0. */
  vtkSetMacro(UniformRadius, double);
  vtkGetMacro(UniformRadius, double);
  ///@}
  ///@{
  /**
   * The radii by type, in the unit after scaling, if the file tells none, such as "1=0.3; 2=0.42".
   * Default: empty.
   */
  vtkSetStdStringFromCharMacro(RadiusByType);
  vtkGetCharFromStdStringMacro(RadiusByType);
  ///@}
  ///@{
  /**
   * For tables: the name, or the number counted from 1, of the column with the radius. Default:
   * empty; the column is then found by name, and is the fourth of four columns without names.
   */
  vtkSetStdStringFromCharMacro(RadiusColumn);
  vtkGetCharFromStdStringMacro(RadiusColumn);
  ///@}
  ///@{
  /**
   * For tables: whether that column holds diameters. A column that is found by the name of a
   * diameter always does. Default: off.
   */
  vtkSetMacro(RadiusIsDiameter, bool);
  vtkGetMacro(RadiusIsDiameter, bool);
  ///@}
  ///@{
  /** A factor for coordinates and radii, > 0. Default: 1. */
  vtkSetMacro(Scale, double);
  vtkGetMacro(Scale, double);
  ///@}
  ///@{
  /**
   * The number of lines at the start of a table that are passed over. If it is not 0, the file is
   * taken for a table unless `Format` says otherwise. Default: 0.
   */
  vtkSetMacro(SkipLines, int);
  vtkGetMacro(SkipLines, int);
  ///@}
  ///@{
  /**
   * The unit of length after scaling, a text that the data carries along. Default: empty, which
   * means that of the file where Scale is 1.
   */
  vtkSetStdStringFromCharMacro(LengthUnit);
  vtkGetCharFromStdStringMacro(LengthUnit);
  ///@}
  ///@{
  /**
   * The window of the centres, in the unit after scaling, in place of the box of the file. Edges of
   * 0 (the default) set none; then BoxPeriodic, if it is not 0 0 0, says which axes of the file's
   * box are periodic, whatever the file tells.
   */
  vtkSetVector3Macro(BoxOrigin, double);
  vtkGetVector3Macro(BoxOrigin, double);
  vtkSetVector3Macro(BoxSize, double);
  vtkGetVector3Macro(BoxSize, double);
  vtkSetVector3Macro(BoxPeriodic, int);
  vtkGetVector3Macro(BoxPeriodic, int);
  ///@}
  ///@{
  /**
   * Whether a window is looked for (ruc::FindWindow) if neither BoxSize nor the file tells one.
   * Spheres with centres outside it stay in the output; filters leave them out
   * (PackData::FindOrigin). Default: on.
   */
  vtkSetMacro(FindWindow, bool);
  vtkGetMacro(FindWindow, bool);
  ///@}
  ///@{
  /**
   * How far that window stays away from walls and loose faces, in largest diameters
   * (ruc::WindowChoices). Default: -1; a negative number is automatic.
   */
  vtkSetMacro(WindowErosion, double);
  vtkGetMacro(WindowErosion, double);
  ///@}
  ///@{
  /**
   * What faces of the pack are, such as "z-=wall; z+=cut; mantle=none" (ruc::WindowChoices).
   * Default: empty; then it is found.
   */
  vtkSetStdStringFromCharMacro(FaceKinds);
  vtkGetCharFromStdStringMacro(FaceKinds);
  ///@}

  /**
   * Returns what was last read: format, frame, and what ruc::PackOverview tells. It is empty
   * before, and if the file was refused.
   */
  vtkGetCharFromStdStringMacro(Summary);

protected:
  vtkRUCSpherePackReader();
  ~vtkRUCSpherePackReader() override;
  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;

private:
  vtkRUCSpherePackReader(const vtkRUCSpherePackReader&) = delete;
  void operator=(const vtkRUCSpherePackReader&) = delete;

  ruc::ReadSettings GetReadSettings() const;
  ruc::PackSettings GetPackSettings() const;
  // Fills the output from the last frame that is not later than `time`, or throws
  // std::invalid_argument
  void Read(double time, vtkPolyData* output);
  void WarnOfUnused(const ruc::FramePack& read); // properties that this file has no use for
  ruc::FoundWindow TakeWindow(const ruc::FramePack& read);
  void FillOutput(
    const ruc::FramePack& read, const ruc::FoundWindow& window, vtkPolyData* output) const;
  std::string UnitOf(const ruc::FramePack& read) const; // after scaling
  // `place` says which frame it is of how many, and its time
  void Describe(
    const ruc::FramePack& read, const ruc::FoundWindow& window, const std::string& place);
  // Tells each warning once, and not again for every frame, until a property changes
  void Warn(const std::vector<std::string>& warnings);

  std::unique_ptr<PackFiles> Files; // rank 0 alone
  vtkMultiProcessController* Controller = nullptr;
  std::string FileName;
  std::string Format = "Automatic";
  std::string Columns;
  double UniformRadius = 0.0;
  std::string RadiusByType;
  std::string RadiusColumn;
  bool RadiusIsDiameter = false;
  double Scale = 1.0;
  int SkipLines = 0;
  std::string LengthUnit;
  double BoxOrigin[3] = { 0.0, 0.0, 0.0 };
  double BoxSize[3] = { 0.0, 0.0, 0.0 };
  int BoxPeriodic[3] = { 0, 0, 0 };
  bool FindWindow = true;
  double WindowErosion = -1.0;
  std::string FaceKinds;
  std::string Summary;
  std::set<std::string> Warned;
  vtkMTimeType WarnedAt = 0;
};

#endif
