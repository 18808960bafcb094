// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCParallelAlgorithm.h"

#include "PackData.h"
#include "RankCommunicator.h"
#include "ruc/Base/Text.h"

#include "vtkAbstractArray.h"
#include "vtkDataObjectTypes.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace
{
// Gives the other ranks the columns of rank 0's table, without its rows. Readers of tables leave
// them so, and views that work on all ranks look a column up on each. Collective.
void ShareColumns(vtkTable* table, const RankCommunicator& ranks)
{
  vtkMultiProcessStream stream;
  vtkDataSetAttributes* row = table->GetRowData();
  if (ranks.Rank() == 0)
  {
    for (int n = 0; n < row->GetNumberOfArrays(); ++n)
    {
      vtkAbstractArray* column = row->GetAbstractArray(n);
      stream << std::string(column->GetName()) << column->GetDataType()
             << column->GetNumberOfComponents();
    }
  }
  ranks.GetController()->Broadcast(stream, 0);
  if (ranks.Rank() == 0)
  {
    return;
  }
  while (!stream.Empty())
  {
    std::string name;
    int type = 0, components = 0;
    stream >> name >> type >> components;
    auto column = vtkSmartPointer<vtkAbstractArray>::Take(vtkAbstractArray::CreateArray(type));
    column->SetName(name.c_str());
    column->SetNumberOfComponents(components);
    PackData::AddColumn(table, column);
  }
}

std::vector<vtkDataObject*> FindInputs(vtkInformationVector** inputs, int ports)
{
  std::vector<vtkDataObject*> found;
  for (int port = 0; port < ports; ++port)
  {
    for (int n = 0; n < inputs[port]->GetNumberOfInformationObjects(); ++n)
    {
      if (vtkDataObject* data = vtkDataObject::GetData(inputs[port], n))
      {
        found.push_back(data);
      }
    }
  }
  return found;
}

// Returns why an input is empty that a filter or reader of this plugin has refused to make, or an
// empty text
std::string FindRefusal(const std::vector<vtkDataObject*>& inputs)
{
  std::string refusal;
  for (vtkDataObject* data : inputs)
  {
    vtkAbstractArray* why = data->GetFieldData()->GetAbstractArray(PackData::RefusalField);
    if (refusal.empty() && why && why->GetNumberOfValues() > 0)
    {
      refusal = why->GetVariantValue(0).ToString();
    }
  }
  return refusal;
}
}

vtkCxxSetObjectMacro(vtkRUCParallelAlgorithm, Controller, vtkMultiProcessController);

vtkRUCParallelAlgorithm::vtkRUCParallelAlgorithm()
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkRUCParallelAlgorithm::~vtkRUCParallelAlgorithm()
{
  this->SetController(nullptr);
}

void vtkRUCParallelAlgorithm::RequireOne(
  vtkInformationVector* inputsOfPort, const char* port, const char* what)
{
  const int count = inputsOfPort->GetNumberOfInformationObjects();
  if (count > 1)
  {
    throw std::invalid_argument(ruc::Text(port, " takes one ", what, ", got ", count, "."));
  }
}

int vtkRUCParallelAlgorithm::RequestDataObject(
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

int vtkRUCParallelAlgorithm::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    outputs->GetInformationObject(port)->Set(CAN_HANDLE_PIECE_REQUEST(), 1);
  }
  return 1;
}

int vtkRUCParallelAlgorithm::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  // The request is the same for all ports, whichever was asked; else the filter would run once for
  // each port on more than one rank.
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
    for (int n = 0; n < inputs[port]->GetNumberOfInformationObjects(); ++n)
    {
      vtkInformation* info = inputs[port]->GetInformationObject(n);
      request(info);
      if (info->Has(Pipeline::WHOLE_EXTENT()))
      {
        // The executive takes the piece of this extent. By default it would be the extent that is
        // asked of an image output, which may have another grid.
        int whole[6];
        info->Get(Pipeline::WHOLE_EXTENT(), whole);
        info->Set(Pipeline::UPDATE_EXTENT(), whole, 6);
      }
    }
  }
  return 1;
}

vtkRUCParallelAlgorithm::Cause vtkRUCParallelAlgorithm::FindCause(vtkInformationVector** inputs)
{
  Cause cause = { { this, this->GetMTime() } };
  for (vtkDataObject* data : FindInputs(inputs, this->GetNumberOfInputPorts()))
  {
    cause.emplace_back(data, std::max(data->GetMTime(), data->GetUpdateTime()));
  }
  return cause;
}

bool vtkRUCParallelAlgorithm::WasTold(vtkInformationVector** inputs, RankCommunicator& ranks)
{
  // The pipeline asks again and again for an image that does not have the extent announced
  std::int64_t changed = this->Refused != this->FindCause(inputs);
  ranks.Sum(&changed, 1);
  const std::string upstream =
    ranks.FirstText(FindRefusal(FindInputs(inputs, this->GetNumberOfInputPorts())));
  if (changed > 0)
  {
    this->Refusal = upstream;
    this->Refused.clear();
  }
  return !this->Refusal.empty();
}

void vtkRUCParallelAlgorithm::ClearOutputs(vtkInformationVector* outputs)
{
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataObject* data = outputs->GetInformationObject(port)->Get(vtkDataObject::DATA_OBJECT());
    data->Initialize();
    if (!this->Refusal.empty())
    {
      PackData::AddField(data, PackData::RefusalField, this->Refusal);
    }
  }
}

int vtkRUCParallelAlgorithm::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  RankCommunicator ranks(this->Controller);
  try
  {
    ranks.RequireMpi();
    const bool told = this->WasTold(inputs, ranks);
    this->ClearOutputs(outputs);
    if (told)
    {
      return 1;
    }
    this->Execute(inputs, outputs, ranks);
    for (int port = 0; ranks.Size() > 1 && port < this->GetNumberOfOutputPorts(); ++port)
    {
      if (vtkTable* table = vtkTable::GetData(outputs, port))
      {
        ShareColumns(table, ranks);
      }
    }
  }
  catch (const std::exception& e)
  {
    // Bad input is found on all ranks alike. Anything else, such as a lack of memory, may fail on
    // one rank alone; then only the end of the job keeps the others from waiting for ever.
    if (ranks.Size() > 1 && !dynamic_cast<const std::invalid_argument*>(&e))
    {
      vtkErrorMacro(<< "rank " << ranks.Rank() << " cannot go on: " << e.what());
      throw;
    }
    if (ranks.Rank() == 0)
    {
      vtkErrorMacro(<< e.what());
    }
    // Outputs become empty instead of the request failing, after which the filters downstream would
    // keep their former results
    this->Refusal = this->GetObjectDescription() + ": " + e.what();
    this->ClearOutputs(outputs);
    this->Refused = this->FindCause(inputs);
  }
  return 1;
}

void vtkRUCParallelAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller << "\n";
}
