// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCSphereMapper.h"

#include <vtkBoundingBox.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataArray.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkShaderProperty.h>
#include <vtkSmartPointer.h>

#include <array>

vtkStandardNewMacro(vtkRUCSphereMapper);

void vtkRUCSphereMapper::PrepareShaders(vtkShaderProperty* shaders)
{
  shaders->AddGeometryShaderReplacement("//VTK::Clip::Dec", true,
    "//VTK::Clip::Dec\n"
    "flat out vec4 sphereVCGSOutput;\n"
    "out vec3 pointVCGSOutput;\n",
    false);
  // The superclass's triangle goes through the centre, where the cone of sight that touches the
  // sphere in perspective is wider than the sphere.
  shaders->AddGeometryShaderReplacement("EmitVertex();", true,
    "{\n"
    "    vec3 centre = gl_in[0].gl_Position.xyz;\n"
    "    if (cameraParallel == 0)\n"
    "    {\n"
    "      float distance2 = dot(centre, centre);\n"
    "      offset *= sqrt(distance2 / max(distance2 - radius * radius, 0.01 * distance2));\n"
    "    }\n"
    "    pointVCGSOutput = centre + offset.x * base1.xyz + offset.y * base2.xyz;\n"
    "    sphereVCGSOutput = vec4(centre, radius);\n"
    "    gl_Position = VCDCMatrix * vec4(pointVCGSOutput, 1.0);\n"
    "    EmitVertex();\n"
    "  }\n",
    true);
  shaders->AddFragmentShaderReplacement("//VTK::PositionVC::Dec", true,
    "//VTK::PositionVC::Dec\n"
    "flat in vec4 sphereVCVSOutput;\n"
    "in vec3 pointVCVSOutput;\n"
    "uniform mat4 VCDCMatrix;\n",
    false);
  shaders->AddFragmentShaderReplacement(
    "//VTK::Camera::Dec", true, "uniform int cameraParallel;\n", false);
  // Here and not with the colours, since depth peeling compares the depth before these.
  shaders->AddFragmentShaderReplacement("//VTK::Depth::Impl", true,
    "  vec3 sight = cameraParallel != 0 ? vec3(0.0, 0.0, -1.0) : normalize(pointVCVSOutput);\n"
    "  vec3 toPoint = pointVCVSOutput - sphereVCVSOutput.xyz;\n"
    "  vec3 nearest = toPoint - dot(toPoint, sight) * sight;\n"
    "  float half2 = sphereVCVSOutput.w * sphereVCVSOutput.w - dot(nearest, nearest);\n"
    "  if (half2 < 0.0)\n"
    "  {\n"
    "    discard;\n"
    "  }\n"
    "  vec3 fromCentre = nearest - sqrt(half2) * sight;\n"
    "  vec3 sphereNormal = fromCentre / sphereVCVSOutput.w;\n"
    "  vec4 surfaceDC = VCDCMatrix * vec4(sphereVCVSOutput.xyz + fromCentre, 1.0);\n"
    "  gl_FragDepth = 0.5 * surfaceDC.z / surfaceDC.w + 0.5;\n",
    false);
}

const char* vtkRUCSphereMapper::GetShading()
{
  // The directions and intensities of vtkLightKit: key, fill, head and two back lights
  return "//VTK::Color::Impl\n"
         "  diffuseColor *= 0.75 * max(dot(sphereNormal, vec3(0.112, 0.766, 0.633)), 0.0)\n"
         "    + 0.25 * max(dot(sphereNormal, vec3(0.0, -0.966, 0.259)), 0.0)\n"
         "    + 0.25 * max(sphereNormal.z, 0.0)\n"
         "    + 0.21 * max(0.94 * abs(sphereNormal.x) - 0.342 * sphereNormal.z, 0.0);\n";
}

void vtkRUCSphereMapper::AddSpheres(vtkDataObject* data, vtkBoundingBox& box)
{
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    auto leaves = vtk::TakeSmartPointer(composite->NewIterator());
    for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
    {
      this->AddSpheres(leaves->GetCurrentDataObject(), box);
    }
    return;
  }
  auto* points = vtkPointSet::SafeDownCast(data);
  if (!points)
  {
    return;
  }
  vtkDataArray* radii =
    this->ScaleArray ? points->GetPointData()->GetArray(this->ScaleArray) : nullptr;
  if (radii && radii->GetNumberOfTuples() < points->GetNumberOfPoints())
  {
    radii = nullptr; // damaged data
  }
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    const double radius = this->ScaleFactor * (radii ? radii->GetComponent(i, 0) : 1.0);
    double centre[3];
    points->GetPoint(i, centre);
    box.AddBounds(std::array<double, 6>{ centre[0] - radius, centre[0] + radius, centre[1] - radius,
      centre[1] + radius, centre[2] - radius, centre[2] + radius }
                    .data());
  }
}

void vtkRUCSphereMapper::ComputeBounds()
{
  vtkDataObject* input = this->GetInputDataObject(0, 0);
  if (input && this->BoundsTime > input->GetMTime() && this->BoundsTime > this->GetMTime())
  {
    return;
  }
  vtkBoundingBox box;
  this->AddSpheres(input, box);
  box.GetBounds(this->Bounds);
  this->BoundsTime.Modified();
}
