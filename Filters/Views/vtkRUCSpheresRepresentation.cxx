// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCSpheresRepresentation.h"

#include "ruc/Window/BoxOutline.h"
#include "vtkRUCSphereMapper.h"

#include <vtkActor.h>
#include <vtkBoundingBox.h>
#include <vtkCellArray.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMath.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkMultiProcessController.h>
#include <vtkObjectFactory.h>
#include <vtkPVRenderView.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <array>
#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkRUCSpheresRepresentation);

namespace
{
constexpr int WindowPort = 1;

// The values of a field, or none where there is no such field with `count` values
std::vector<double> Field(vtkDataObject* data, const char* name, int count)
{
  std::vector<double> values;
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  if (array && array->GetNumberOfValues() == count)
  {
    for (int i = 0; i < count; ++i)
    {
      values.push_back(array->GetVariantValue(i).ToDouble());
    }
  }
  return values;
}

void AddBox(const std::vector<double>& origin, const std::vector<double>& size, vtkPolyData* lines)
{
  const vtkIdType first = lines->GetNumberOfPoints();
  ruc::ForEachOfOutline(
    { origin[0], origin[1], origin[2] }, { size[0], size[1], size[2] }, { 0, 0, 0 },
    [&](const ruc::Vector3& corner) { lines->GetPoints()->InsertNextPoint(corner.data()); },
    [&](int a, int b)
    {
      const vtkIdType ends[2] = { first + a, first + b };
      lines->GetLines()->InsertNextCell(2, ends);
    });
}

void AddCylinder(const std::vector<double>& base, std::vector<double> axis, double radius,
  double height, vtkPolyData* lines)
{
  constexpr int facets = 64;
  constexpr int facetsPerLine = 8;
  const vtkIdType first = lines->GetNumberOfPoints();
  double sides[2][3];
  vtkMath::Normalize(axis.data());
  vtkMath::Perpendiculars(axis.data(), sides[0], sides[1], 0.0);
  for (int i = 0; i < facets; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / facets;
    const vtkIdType below = first + 2 * i;
    const vtkIdType next = first + 2 * ((i + 1) % facets);
    for (double level : { 0.0, height })
    {
      double point[3];
      for (int q = 0; q < 3; ++q)
      {
        point[q] = base[q] + level * axis[q] +
          radius * (std::cos(angle) * sides[0][q] + std::sin(angle) * sides[1][q]);
      }
      lines->GetPoints()->InsertNextPoint(point);
    }
    const std::array<std::array<vtkIdType, 2>, 3> edges{ { { below, next }, { below + 1, next + 1 },
      { below, below + 1 } } };
    for (int edge = 0; edge < (i % facetsPerLine == 0 ? 3 : 2); ++edge)
    {
      lines->GetLines()->InsertNextCell(2, edges[edge].data());
    }
  }
}

void AddWindow(vtkDataObject* data, vtkPolyData* lines)
{
  const std::vector<double> origin = Field(data, "BoxOrigin", 3);
  const std::vector<double> size = Field(data, "BoxSize", 3);
  const std::vector<double> base = Field(data, "CylinderBase", 3);
  const std::vector<double> axis = Field(data, "CylinderAxis", 3);
  const std::vector<double> radius = Field(data, "CylinderRadius", 1);
  const std::vector<double> height = Field(data, "CylinderHeight", 1);
  if (!origin.empty() && !size.empty())
  {
    AddBox(origin, size, lines);
  }
  else if (!base.empty() && !axis.empty() && !radius.empty() && !height.empty())
  {
    AddCylinder(base, axis, radius[0], height[0], lines);
  }
}

// The data set itself, or those of a composite
std::vector<vtkDataObject*> DataSets(vtkDataObject* data)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(data);
  if (!composite)
  {
    return { data };
  }
  std::vector<vtkDataObject*> leaves;
  auto iterator = vtk::TakeSmartPointer(composite->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    leaves.push_back(iterator->GetCurrentDataObject());
  }
  return leaves;
}

bool IsDark(const double colour[3])
{
  return 0.2126 * colour[0] + 0.7152 * colour[1] + 0.0722 * colour[2] < 0.5;
}
}

vtkRUCSpheresRepresentation::vtkRUCSpheresRepresentation()
{
  this->Mapper = this->Spheres;
  this->Actor->SetMapper(this->Spheres);
  this->Spheres->PrepareShaders(this->Actor->GetShaderProperty());
  this->PresetShaderStrings[SPHERE] = vtkRUCSphereMapper::GetShading();
  this->PresetShaderScales[SPHERE] = 1.0;

  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputDataObject(this->Window);
  this->WindowActor->SetMapper(mapper);
  this->WindowActor->PickableOff();
  this->WindowActor->GetProperty()->LightingOff();
  this->WindowActor->GetProperty()->SetLineWidth(2.0);
}

vtkRUCSpheresRepresentation::~vtkRUCSpheresRepresentation() = default;

void vtkRUCSpheresRepresentation::SetShowWindow(bool show)
{
  if (this->ShowWindow != show)
  {
    this->ShowWindow = show;
    this->MarkModified();
  }
}

void vtkRUCSpheresRepresentation::SetSplatSize(double scale)
{
  this->Spheres->SetSphereScale(this->Actor->GetShaderProperty(), scale);
}

void vtkRUCSpheresRepresentation::SetOpacity(double opacity)
{
  const bool wasTranslucent = this->IsTranslucent();
  this->Superclass::SetOpacity(opacity);
  if (this->IsTranslucent() != wasTranslucent)
  {
    this->MarkModified(); // the spheres then go to other ranks
  }
}

void vtkRUCSpheresRepresentation::SetVisibility(bool visible)
{
  this->Superclass::SetVisibility(visible);
  this->WindowActor->SetVisibility(visible);
}

bool vtkRUCSpheresRepresentation::IsTranslucent() const
{
  return this->Actor->GetProperty()->GetOpacity() < 1.0;
}

bool vtkRUCSpheresRepresentation::AddToView(vtkView* view)
{
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  if (renderView)
  {
    renderView->GetRenderer()->AddActor(this->WindowActor);
  }
  return this->Superclass::AddToView(view);
}

bool vtkRUCSpheresRepresentation::RemoveFromView(vtkView* view)
{
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  if (renderView)
  {
    renderView->GetRenderer()->RemoveActor(this->WindowActor);
  }
  return this->Superclass::RemoveFromView(view);
}

int vtkRUCSpheresRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const int result = this->Superclass::RequestData(request, inputs, outputs);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  this->Window->Initialize();
  this->Window->SetPoints(points);
  this->Window->SetLines(lines);
  if (vtkDataObject* input = vtkDataObject::GetData(inputs[0], 0))
  {
    for (vtkDataObject* data : DataSets(input))
    {
      if (this->ShowWindow)
      {
        AddWindow(data, this->Window);
      }
    }
  }
  return result;
}

int vtkRUCSpheresRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (!this->Superclass::ProcessViewRequest(request, inInfo, outInfo))
  {
    return 0;
  }
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    this->OfferData(inInfo, outInfo);
  }
  else if (request == vtkPVView::REQUEST_RENDER())
  {
    this->PrepareActors(inInfo);
  }
  return 1;
}

void vtkRUCSpheresRepresentation::OfferData(vtkInformation* inInfo, vtkInformation* outInfo)
{
  double bounds[6];
  vtkBoundingBox box;
  this->Spheres->AddSpheres(this->ProcessedData, box);
  box.GetBounds(bounds);
  vtkPVRenderView::SetGeometryBounds(inInfo, this, bounds, this->Actor->GetMatrix());
  // The superclass asks for points to be moved so that ranks can be drawn one behind the other,
  // which loses some of them in ParaView 5.11 as Debian 12 has it. Opaque spheres need no order.
  if (this->IsTranslucent())
  {
    vtkPVRenderView::SetOrderedCompositingConfiguration(
      inInfo, this, vtkPVRenderView::USE_BOUNDS_FOR_REDISTRIBUTION, bounds);
  }
  else
  {
    outInfo->Remove(vtkPVRenderView::NEED_ORDERED_COMPOSITING());
    vtkPVRenderView::SetOrderedCompositingConfiguration(inInfo, this, 0);
  }
  vtkPVRenderView::SetDeliverToAllProcesses(inInfo, this, this->IsTranslucent());

  vtkPVView::SetPiece(inInfo, this, this->Window, 0, WindowPort);
  this->Window->GetBounds(bounds);
  vtkPVRenderView::SetGeometryBounds(inInfo, this, bounds, this->Actor->GetMatrix(), WindowPort);
  vtkPVRenderView::SetOrderedCompositingConfiguration(inInfo, this, 0, nullptr, WindowPort);
}

void vtkRUCSpheresRepresentation::PrepareActors(vtkInformation* inInfo)
{
  this->Actor->SetVisibility(this->GetVisibility() && (this->ShowCutSpheres || !this->CutShown));
  vtkDataObject* window = vtkPVView::GetDeliveredPiece(inInfo, this, WindowPort);
  auto* ranks = vtkMultiProcessController::GetGlobalController();
  if (this->IsTranslucent() && ranks && ranks->GetLocalProcessId() > 0)
  {
    // The first rank draws all spheres
    this->Mapper->SetInputDataObject(nullptr);
    window = nullptr;
  }
  this->WindowActor->SetVisibility(this->GetVisibility() && window);
  this->WindowActor->GetMapper()->SetInputDataObject(window);
  this->WindowActor->SetUserMatrix(this->Actor->GetMatrix());
  auto* view = vtkPVRenderView::SafeDownCast(inInfo->Get(vtkPVView::VIEW()));
  const double shade = view && IsDark(view->GetRenderer()->GetBackground()) ? 1.0 : 0.0;
  this->WindowActor->GetProperty()->SetColor(shade, shade, shade);
}
