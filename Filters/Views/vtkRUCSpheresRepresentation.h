// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCViewsModule.h"

#include <vtkNew.h>
#include <vtkPointGaussianRepresentation.h>

class vtkPolyData;
class vtkRUCSphereMapper;

/**
 * Draws points as spheres of their true radius, and the window of a pack as lines.
 *
 * On several rendering ranks each rank draws its own points, and the nearest one wins in every
 * pixel, so that the picture is that of one rank. Translucent spheres blend in the order of their
 * depth. Hence the first rank draws them all, and data in the view that lie on other ranks are
 * blended in front of all of them or behind.
 *
 * The window comes from the data's field data: `BoxOrigin` and `BoxSize`, or `CylinderBase`,
 * `CylinderAxis`, `CylinderRadius` and `CylinderHeight`. Its lines are white on a dark background
 * and black on a light one.
 */
class RUCVIEWS_EXPORT vtkRUCSpheresRepresentation : public vtkPointGaussianRepresentation
{
public:
  static vtkRUCSpheresRepresentation* New();
  vtkTypeMacro(vtkRUCSpheresRepresentation, vtkPointGaussianRepresentation);

  ///@{
  /** Whether the window is drawn. Default: on. */
  void SetShowWindow(bool show);
  vtkGetMacro(ShowWindow, bool);
  ///@}
  ///@{
  /**
   * Whether the spheres are drawn even where the view shows surfaces that stand for them. Default:
   * off.
   */
  vtkSetMacro(ShowCutSpheres, bool);
  vtkGetMacro(ShowCutSpheres, bool);
  ///@}
  ///@{
  /** Whether the view shows such surfaces; its client says so. Default: off. */
  vtkSetMacro(CutShown, bool);
  vtkGetMacro(CutShown, bool);
  ///@}

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;
  void SetVisibility(bool visible) override;
  void SetOpacity(double opacity) override;
  /** By how much the radii are multiplied, > 0. Default: 1, the true size. */
  void SetSplatSize(double scale) override;

protected:
  vtkRUCSpheresRepresentation();
  ~vtkRUCSpheresRepresentation() override;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

private:
  vtkRUCSpheresRepresentation(const vtkRUCSpheresRepresentation&) = delete;
  void operator=(const vtkRUCSpheresRepresentation&) = delete;

  bool IsTranslucent() const;
  /** Tells the view of spheres and window, and on which ranks it needs them. */
  void OfferData(vtkInformation* inInfo, vtkInformation* outInfo);
  /** Makes the actors draw what the view delivered to this rank. */
  void PrepareActors(vtkInformation* inInfo);

  bool ShowWindow = true;
  bool ShowCutSpheres = false;
  bool CutShown = false;
  vtkNew<vtkRUCSphereMapper> Spheres;
  vtkNew<vtkPolyData> Window;
  vtkNew<vtkActor> WindowActor;
};
