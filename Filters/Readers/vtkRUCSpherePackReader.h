// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCSpherePackReader
 * @brief Reads a table of spheres, one in each line, as a sphere pack
 *
 * The text has columns separated by commas, semicolons, tabs or blanks, with or without a header.
 * Core/Formats/SpherePackText.h says what is accepted, and what is refused with the number of the
 * line.
 *
 * Output: points (double) with vertex cells and the arrays `Radius` (double), `Id` (the place in
 * the file from 0, or the column "id") and, if the file has such a column, `Mode` (int). With
 * `BoxSize` the window becomes field data of the pack, and every centre must lie in it. If an axis
 * is periodic, rows that only repeat a sphere in a neighbouring image of the box are left out; the
 * field data `NumberOfGhosts` and a warning give their number. Other centres outside along such an
 * axis are moved into the box; a warning gives their number. GetSummary, and a line of the log,
 * tell what was read.
 *
 * Rank 0 reads the file and holds the whole output. A file that cannot be read gives an error and
 * an output that is empty but for the field data `Refusal`; with such an input every filter of this
 * plugin is empty on all ranks.
 */
#ifndef vtkRUCSpherePackReader_h
#define vtkRUCSpherePackReader_h

#include "RUCReadersModule.h"

#include "vtkPolyDataAlgorithm.h"

#include <string>

namespace ruc
{
struct SpherePackText;
class Window;
}

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
   * Returns whether the name leads to a regular file that can be opened. Its contents are not
   * looked at.
   */
  static int CanReadFile(const char* fileName);

  ///@{
  /**
   * The name, or the number counted from 1, of the column with the radius. Default: empty; the
   * column is then found by name, and is the fourth in a text without header.
   */
  vtkSetStdStringFromCharMacro(RadiusColumn);
  vtkGetCharFromStdStringMacro(RadiusColumn);
  ///@}
  ///@{
  /**
   * Whether that column holds diameters. A column that is found by the name of a diameter always
   * does. Default: off.
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
  /** The number of lines at the start of the file that are passed over. Default: 0. */
  vtkSetMacro(SkipLines, int);
  vtkGetMacro(SkipLines, int);
  ///@}
  ///@{
  /** The unit of length after scaling, a text that the data carries along. Default: empty. */
  vtkSetStdStringFromCharMacro(LengthUnit);
  vtkGetCharFromStdStringMacro(LengthUnit);
  ///@}
  ///@{
  /** The window of the centres, in the unit after scaling. Edges of 0 (the default) set none. */
  vtkSetVector3Macro(BoxOrigin, double);
  vtkGetVector3Macro(BoxOrigin, double);
  vtkSetVector3Macro(BoxSize, double);
  vtkGetVector3Macro(BoxSize, double);
  vtkSetVector3Macro(BoxPeriodic, int);
  vtkGetVector3Macro(BoxPeriodic, int);
  ///@}

  /**
   * Returns what was last read: number, radii, extent, window and fraction (ruc::PackOverview). It
   * is empty before, and if the file was refused.
   */
  vtkGetCharFromStdStringMacro(Summary);

protected:
  vtkRUCSpherePackReader();
  ~vtkRUCSpherePackReader() override = default;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;

private:
  vtkRUCSpherePackReader(const vtkRUCSpherePackReader&) = delete;
  void operator=(const vtkRUCSpherePackReader&) = delete;

  // Fills the output from the file, or throws std::invalid_argument
  void Read(vtkPolyData* output);
  // Leaves out periodic copies and moves every centre into the window, which becomes field data
  void PutIntoBox(ruc::SpherePackText& spheres, const ruc::Window& window, vtkPolyData* output);

  std::string FileName;
  std::string RadiusColumn;
  bool RadiusIsDiameter = false;
  double Scale = 1.0;
  int SkipLines = 0;
  std::string LengthUnit;
  double BoxOrigin[3] = { 0.0, 0.0, 0.0 };
  double BoxSize[3] = { 0.0, 0.0, 0.0 };
  int BoxPeriodic[3] = { 0, 0, 0 };
  std::string Summary;
};

#endif
