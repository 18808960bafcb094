// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCPackAlgorithm.h"

#include "PackData.h"
#include "RankCommunicator.h"

#include "vtkDataObjectTypes.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkPointSet.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <stdexcept>

vtkCxxSetObjectMacro(vtkRUCPackAlgorithm, Controller, vtkMultiProcessController);

vtkRUCPackAlgorithm::vtkRUCPackAlgorithm()
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkRUCPackAlgorithm::~vtkRUCPackAlgorithm()
{
  this->SetController(nullptr);
}

int vtkRUCPackAlgorithm::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

int vtkRUCPackAlgorithm::RequestDataObject(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    const char* type = this->GetOutputPortInformation(port)->Get(vtkDataObject::DATA_TYPE_NAME());
    vtkInformation* info = outputs->GetInformationObject(port);
    vtkDataObject* present = info->Get(vtkDataObject::DATA_OBJECT());
    if (!present || !present->IsA(type))
    {
      info->Set(vtkDataObject::DATA_OBJECT(),
        vtkSmartPointer<vtkDataObject>::Take(vtkDataObjectTypes::NewDataObject(type)));
    }
  }
  return 1;
}

int vtkRUCPackAlgorithm::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    outputs->GetInformationObject(port)->Set(CAN_HANDLE_PIECE_REQUEST(), 1);
  }
  return 1;
}

int vtkRUCPackAlgorithm::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  // One request for all ports, whichever was asked: else the filter runs once a port on more than
  // one rank.
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  const RankCommunicator ranks(this->Controller);
  const auto request = [&](vtkInformation* info)
  {
    info->Set(Pipeline::UPDATE_PIECE_NUMBER(), ranks.Rank());
    info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), ranks.Size());
    info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  };
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    request(outputs->GetInformationObject(port));
  }
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    if (inputs[port]->GetNumberOfInformationObjects() > 0) // else it is optional
    {
      request(inputs[port]->GetInformationObject(0));
    }
  }
  return 1;
}

int vtkRUCPackAlgorithm::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const auto clear = [&]()
  {
    for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
    {
      outputs->GetInformationObject(port)->Get(vtkDataObject::DATA_OBJECT())->Initialize();
    }
  };
  clear();
  RankCommunicator ranks(this->Controller);
  try
  {
    this->Execute(vtkPointSet::GetData(inputs[0]), outputs, ranks);
  }
  catch (const std::exception& e)
  {
    // Bad input is found on all ranks alike. What else fails, such as memory, may fail on one
    // alone; then only ending the job keeps the others from waiting for ever.
    if (ranks.Size() > 1 && !dynamic_cast<const std::invalid_argument*>(&e))
    {
      vtkErrorMacro(<< this->GetLabel() << ": rank " << ranks.Rank()
                    << " cannot go on: " << e.what());
      throw;
    }
    // Empty outputs rather than a failed request, after which the filters downstream would keep
    // their former results
    clear();
    if (ranks.Rank() == 0)
    {
      vtkErrorMacro(<< this->GetLabel() << ": " << e.what());
    }
  }
  return 1;
}

PackData::WindowProperties vtkRUCPackAlgorithm::GetWindowProperties() const
{
  PackData::WindowProperties properties;
  std::copy_n(this->BoxOrigin, 3, properties.BoxOrigin);
  std::copy_n(this->BoxSize, 3, properties.BoxSize);
  std::copy_n(this->BoxPeriodic, 3, properties.BoxPeriodic);
  std::copy_n(this->CylinderBase, 3, properties.CylinderBase);
  std::copy_n(this->CylinderAxis, 3, properties.CylinderAxis);
  properties.CylinderRadius = this->CylinderRadius;
  properties.CylinderHeight = this->CylinderHeight;
  properties.Crop = this->CropToWindow;
  return properties;
}

void vtkRUCPackAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&](const char* name, const auto& v)
  { os << indent << name << ": " << v[0] << " " << v[1] << " " << v[2] << "\n"; };
  print("BoxOrigin", this->BoxOrigin);
  print("BoxSize", this->BoxSize);
  print("BoxPeriodic", this->BoxPeriodic);
  print("CylinderBase", this->CylinderBase);
  print("CylinderAxis", this->CylinderAxis);
  os << indent << "CylinderRadius: " << this->CylinderRadius << "\n";
  os << indent << "CylinderHeight: " << this->CylinderHeight << "\n";
  os << indent << "CropToWindow: " << this->CropToWindow << "\n";
  os << indent << "Controller: " << this->Controller << "\n";
}
