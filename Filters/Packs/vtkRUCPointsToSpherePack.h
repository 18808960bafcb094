// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCPointsToSpherePack
 * @brief Makes a sphere pack of points that come from any reader or filter
 *
 * Input: points with whatever arrays they have, a composite data set of such (PackInput), or a
 * table with columns x, y and z. The output has the points, spread over the ranks as they come,
 * with vertex cells, all their arrays and
 *
 * - `Radius` (double), from an array of radii or of diameters, or else from properties;
 * - `Id`, from an array or else the place among all points, counted from 0;
 * - `Type` (int), if there is such an array; names are numbered from 1 in the order of the
 *   alphabet, and become the field data `TypeNames`.
 *
 * An array that is not named by a property is found by its name as ruc::FindColumn does, so that
 * those of a radius go before those of a diameter; where several may be meant, a warning tells
 * which is taken. The window is that of vtkRUCPackAlgorithm. If it
 * is known, it becomes field data, and centres that are outside along a periodic axis are moved
 * into it. Points of radius 0 are left out with a warning. The field data `RadiusSource` tells
 * where the radii come from.
 */
#ifndef vtkRUCPointsToSpherePack_h
#define vtkRUCPointsToSpherePack_h

#include "RUCPacksModule.h"
#include "vtkRUCPackAlgorithm.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkPolyData;

class RUCPACKS_EXPORT vtkRUCPointsToSpherePack : public vtkRUCPackAlgorithm
{
public:
  static vtkRUCPointsToSpherePack* New();
  vtkTypeMacro(vtkRUCPointsToSpherePack, vtkRUCPackAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** What stands in place of the name of an array that is to be found by its name. */
  static constexpr const char* FindByName = "Find by name";

  ///@{
  /** The array with the radii. Default: FindByName, as is an empty text. */
  vtkSetStdStringFromCharMacro(RadiusArray);
  vtkGetCharFromStdStringMacro(RadiusArray);
  ///@}
  ///@{
  /**
   * Whether that array holds diameters. An array that has the name of a diameter always does.
   * Default: off.
   */
  vtkSetMacro(RadiusIsDiameter, bool);
  vtkGetMacro(RadiusIsDiameter, bool);
  ///@}
  ///@{
  /**
   * The radius of every point if there is no array of radii, and RadiusByType does not tell it, in
   * the unit after scaling; >= 0. Default: 0, which means none.
   */
  vtkSetMacro(UniformRadius, double);
  vtkGetMacro(UniformRadius, double);
  ///@}
  ///@{
  /**
   * The radii by type if there is no array of radii, such as "1=0.3; 2=0.42", with names if types
   * are names (ruc::PackSettings), in the unit after scaling. Default: empty.
   */
  vtkSetStdStringFromCharMacro(RadiusByType);
  vtkGetCharFromStdStringMacro(RadiusByType);
  ///@}
  ///@{
  /** The array with the ids, which are whole numbers. Default: FindByName. */
  vtkSetStdStringFromCharMacro(IdArray);
  vtkGetCharFromStdStringMacro(IdArray);
  ///@}
  ///@{
  /** The array with the types, which are whole numbers or names. Default: FindByName. */
  vtkSetStdStringFromCharMacro(TypeArray);
  vtkGetCharFromStdStringMacro(TypeArray);
  ///@}
  ///@{
  /**
   * A factor for coordinates, radii and the window of the input, > 0; the properties of the window
   * are in the unit after scaling. Default: 1.
   */
  vtkSetMacro(Scale, double);
  vtkGetMacro(Scale, double);
  ///@}
  ///@{
  /**
   * The unit of length after scaling, a text that the data carries along. Default: empty, which
   * means that of the input unless Scale changes it.
   */
  vtkSetStdStringFromCharMacro(LengthUnit);
  vtkGetCharFromStdStringMacro(LengthUnit);
  ///@}
  ///@{
  /**
   * Whether a window is looked for (ruc::FindWindow) if neither the input nor properties tell one.
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

protected:
  vtkRUCPointsToSpherePack() = default;
  ~vtkRUCPointsToSpherePack() override = default;
  const char* GetLabel() const override { return "Points To Sphere Pack"; }
  bool TakesTables() const override { return true; }
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  void Execute(vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks) override;
  std::optional<ruc::Estimate> MakeEstimate() override;

private:
  vtkRUCPointsToSpherePack(const vtkRUCPointsToSpherePack&) = delete;
  void operator=(const vtkRUCPointsToSpherePack&) = delete;

  // The names of the arrays that are taken, the same on all ranks; empty where there is none
  struct Arrays
  {
    std::string Radius, Id, Type;
    bool Diameters = false;
  };
  Arrays FindArrays(vtkPointSet* input, RankCommunicator& ranks) const;
  void WarnOfOthers(vtkPointSet* input, const Arrays& arrays, RankCommunicator& ranks);
  // Returns the points and fields of the input in the unit after scaling, with all arrays
  vtkSmartPointer<vtkPolyData> ScalePoints(vtkPointSet* input, RankCommunicator& ranks) const;
  // These add Radius and Id to the points. `typeNames` are empty unless types are names. Collective
  void AddRadii(const Arrays& arrays, const std::vector<std::string>& typeNames,
    vtkPolyData* points, RankCommunicator& ranks);
  void AddIds(const Arrays& arrays, vtkPolyData* points, RankCommunicator& ranks);
  // Adds the fields of a window that is found, if none is known. Collective
  void AddFoundWindow(vtkPolyData* points, RankCommunicator& ranks);

  std::string RadiusArray = FindByName;
  bool RadiusIsDiameter = false;
  double UniformRadius = 0.0;
  std::string RadiusByType;
  std::string IdArray = FindByName;
  std::string TypeArray = FindByName;
  double Scale = 1.0;
  std::string LengthUnit;
  bool FindWindow = true;
  double WindowErosion = -1.0;
  std::string FaceKinds;
};

#endif
