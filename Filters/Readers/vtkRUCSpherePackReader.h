// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCSpherePackReader
 * @brief Reads a table of spheres, one a line, as a sphere pack
 *
 * The text has columns separated by commas, semicolons, tabs or blanks, with or without a header;
 * see Core/Geometry/SpherePackText.h for what is accepted and what is refused, with the line's
 * number.
 *
 * Output: points (double) with vertex cells and the arrays `Radius` (double), `Id` (place in the
 * file from 0, or the column "id") and, where the file has such a column, `Mode` (int). With
 * `BoxSize` set the window becomes field data of the pack; where an axis is periodic, rows that
 * only repeat a sphere in a neighbouring image of the box are left out, counted in the field data
 * `NumberOfGhosts` and told in a warning.
 *
 * The file is read on rank 0, which holds the whole output. A file that cannot be read gives an
 * error and an empty output, which every filter of this plugin refuses on all ranks.
 */
#ifndef vtkRUCSpherePackReader_h
#define vtkRUCSpherePackReader_h

#include "RUCReadersModule.h"

#include "vtkPolyDataAlgorithm.h"

#include <string>

class RUCREADERS_EXPORT vtkRUCSpherePackReader : public vtkPolyDataAlgorithm
{
public:
  static vtkRUCSpherePackReader* New();
  vtkTypeMacro(vtkRUCSpherePackReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The file, on the machine of rank 0. */
  vtkSetStdStringFromCharMacro(FileName);
  vtkGetCharFromStdStringMacro(FileName);
  ///@}
  /** Whether it is a regular file that can be opened; its contents are not looked at. */
  static int CanReadFile(const char* fileName);

  ///@{
  /** Name or 1-based number of the column of radii. Default: empty, found by name, the fourth
   * without a header. */
  vtkSetStdStringFromCharMacro(RadiusColumn);
  vtkGetCharFromStdStringMacro(RadiusColumn);
  ///@}
  ///@{
  /** The column holds diameters. Default: off. (A column found by the name "diameter" is taken as
   * such.) */
  vtkSetMacro(RadiusIsDiameter, bool);
  vtkGetMacro(RadiusIsDiameter, bool);
  ///@}
  ///@{
  /** Factor for coordinates and radii, > 0. Default: 1. */
  vtkSetMacro(Scale, double);
  vtkGetMacro(Scale, double);
  ///@}
  ///@{
  /** Lines at the start of the file that are passed over. Default: 0. */
  vtkSetMacro(SkipLines, int);
  vtkGetMacro(SkipLines, int);
  ///@}
  ///@{
  /** The unit of length after scaling, a text that the data carries along. Default: empty. */
  vtkSetStdStringFromCharMacro(LengthUnit);
  vtkGetCharFromStdStringMacro(LengthUnit);
  ///@}
  ///@{
  /** The window of the centres, in the scaled unit; edges of 0 (the default) set none. */
  vtkSetVector3Macro(BoxOrigin, double);
  vtkGetVector3Macro(BoxOrigin, double);
  vtkSetVector3Macro(BoxSize, double);
  vtkGetVector3Macro(BoxSize, double);
  vtkSetVector3Macro(BoxPeriodic, int);
  vtkGetVector3Macro(BoxPeriodic, int);
  ///@}

protected:
  vtkRUCSpherePackReader();
  ~vtkRUCSpherePackReader() override = default;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;

private:
  vtkRUCSpherePackReader(const vtkRUCSpherePackReader&) = delete;
  void operator=(const vtkRUCSpherePackReader&) = delete;

  // Fills the output from the file, or throws std::invalid_argument
  void Read(vtkPolyData* output);

  std::string FileName;
  std::string RadiusColumn;
  bool RadiusIsDiameter = false;
  double Scale = 1.0;
  int SkipLines = 0;
  std::string LengthUnit;
  double BoxOrigin[3] = { 0.0, 0.0, 0.0 };
  double BoxSize[3] = { 0.0, 0.0, 0.0 };
  int BoxPeriodic[3] = { 0, 0, 0 };
};

#endif
