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
#include <vtkUniforms.h>

#include <array>

vtkStandardNewMacro(vtkRUCSphereMapper);

namespace
{
// The superclass's shaders differ between versions of VTK, but not in the names of their
// attributes and uniforms. So the spheres have main functions of their own: the vertex shader
// computes all, and the geometry shader only passes it on.
constexpr const char* VertexMain =
  "uniform float sphereScale;\n"
  "out vec4 sphereVCVSOutput;\n"
  "out mat3 triangleVCVSOutput;\n"
  "out mat3x4 triangleDCVSOutput;\n"
  "void superclassMain();\n"
  "void main()\n"
  "{\n"
  "  superclassMain();\n"
  "  vec3 centre = (MCVCMatrix * vertexMC).xyz;\n"
  "  float radius = sphereScale * radiusMC * length(MCVCMatrix[0].xyz);\n"
  "  sphereVCVSOutput = vec4(centre, radius);\n"
  "  vec3 base1 = vec3(1.0, 0.0, 0.0);\n"
  "  vec3 base2 = vec3(0.0, 1.0, 0.0);\n"
  "  float reach = radius;\n"
  "  if (VCDCMatrix[2][3] != 0.0)\n"
  "  {\n"
  // A perspective projection: the triangle faces the camera and goes through the centre, where
  // the cone of sight that touches the sphere is wider than the sphere.
  "    vec3 toCamera = normalize(-centre);\n"
  "    base2 = normalize(cross(toCamera, vec3(1.0, 0.0, 0.0)));\n"
  "    base1 = cross(base2, toCamera);\n"
  "    float distance2 = dot(centre, centre);\n"
  "    reach *= sqrt(distance2 / max(distance2 - radius * radius, 0.01 * distance2));\n"
  "  }\n"
  // The sides of the triangle touch the circle of radius reach.
  "  triangleVCVSOutput = mat3(centre - reach * (1.7320508 * base1 + base2),\n"
  "    centre + reach * (1.7320508 * base1 - base2), centre + 2.0 * reach * base2);\n"
  "  for (int corner = 0; corner < 3; ++corner)\n"
  "  {\n"
  "    triangleDCVSOutput[corner] = VCDCMatrix * vec4(triangleVCVSOutput[corner], 1.0);\n"
  "  }\n"
  "}\n"
  "void superclassMain()";

constexpr const char* GeometryMain = "in vec4 sphereVCVSOutput[];\n"
                                     "in mat3 triangleVCVSOutput[];\n"
                                     "in mat3x4 triangleDCVSOutput[];\n"
                                     "flat out vec4 sphereVCGSOutput;\n"
                                     "out vec3 pointVCGSOutput;\n"
                                     "void main()\n"
                                     "{\n"
                                     "  int i = 0;\n"
                                     "  for (int corner = 0; corner < 3; ++corner)\n"
                                     "  {\n"
                                     "    //VTK::PrimID::Impl\n"
                                     "    //VTK::Clip::Impl\n"
                                     "    //VTK::Color::Impl\n"
                                     "    //VTK::Picking::Impl\n"
                                     "    sphereVCGSOutput = sphereVCVSOutput[0];\n"
                                     "    pointVCGSOutput = triangleVCVSOutput[0][corner];\n"
                                     "    gl_Position = triangleDCVSOutput[0][corner];\n"
                                     "    EmitVertex();\n"
                                     "  }\n"
                                     "  EndPrimitive();\n"
                                     "}\n"
                                     "void superclassMain()";
}

void vtkRUCSphereMapper::PrepareShaders(vtkShaderProperty* shaders)
{
  this->SetSphereScale(shaders, 1.0);
  shaders->AddVertexShaderReplacement("void main()", true, VertexMain, true);
  shaders->AddGeometryShaderReplacement("void main()", true, GeometryMain, true);
  shaders->AddFragmentShaderReplacement("//VTK::PositionVC::Dec", true,
    "//VTK::PositionVC::Dec\n"
    "flat in vec4 sphereVCVSOutput;\n"
    "in vec3 pointVCVSOutput;\n"
    "uniform mat4 VCDCMatrix;\n",
    false);
  shaders->AddFragmentShaderReplacement(
    "//VTK::Camera::Dec", true, "uniform int cameraParallel;\n", false);
  // This is done here and not with the colours, since depth peeling compares the depth before
  // these.
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

void vtkRUCSphereMapper::SetSphereScale(vtkShaderProperty* shaders, double scale)
{
  shaders->GetVertexCustomUniforms()->SetUniformf("sphereScale", static_cast<float>(scale));
  this->SphereScale = scale;
  this->Modified();
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
    const double radius = this->SphereScale * (radii ? radii->GetComponent(i, 0) : 1.0);
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
