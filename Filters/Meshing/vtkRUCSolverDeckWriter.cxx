// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCSolverDeckWriter.h"

#include "MeshInput.h"
#include "NewFile.h"
#include "PackData.h"
#include "RankCommunicator.h"
#include "ruc/Base/Range.h"
#include "ruc/Base/Require.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVariant.h"

vtkStandardNewMacro(vtkRUCSolverDeckWriter);

vtkRUCSolverDeckWriter::vtkRUCSolverDeckWriter()
{
  this->SetNumberOfOutputPorts(0);
}

int vtkRUCSolverDeckWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

bool vtkRUCSolverDeckWriter::HasExtension(const char* extension) const
{
  const std::size_t point = this->FileName.find_last_of("./");
  return point != std::string::npos && this->FileName.substr(point) == std::string(".") + extension;
}

void vtkRUCSolverDeckWriter::ValidateProperties() const
{
  ruc::Require(this->HasExtension("inp") || this->HasExtension("msh"), "FileName",
    "a name that ends by .inp or .msh", this->FileName.empty() ? "none" : this->FileName);
  ruc::Require(this->Regions >= PHASES && this->Regions <= PARTICLES, "Regions",
    "a value from 0 to 2", this->Regions);
  ruc::Require(this->Physics == ELASTICITY || this->Physics == CONDUCTION, "Physics",
    "the value 0 or 1", this->Physics);
  ruc::Range::Above(0.0).Check("LengthFactor", this->LengthFactor);
}

void vtkRUCSolverDeckWriter::Execute(
  vtkInformationVector** inputs, vtkInformationVector*, RankCommunicator& ranks)
{
  RequireOne(inputs[0], "Input", "mesh");
  this->ValidateProperties();
  ranks.Agree(
    [&]()
    {
      if (ranks.Rank() == 0)
      {
        const ruc::SolverMesh mesh = MeshInput::Read(vtkUnstructuredGrid::GetData(inputs[0]),
          static_cast<MeshInput::RegionKind>(this->Regions), this->LengthFactor);
        const std::string deck = this->HasExtension("msh")
          ? ruc::WriteGmshMesh(mesh)
          : ruc::WriteAbaqusDeck(mesh, static_cast<ruc::SolverPhysics>(this->Physics));
        NewFile file(this->FileName);
        file.Append(deck);
        file.Keep();
      }
    });
  this->Written = true;
}

int vtkRUCSolverDeckWriter::Write()
{
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    vtkErrorMacro(<< "Input requires a mesh, got none.");
    return 0;
  }
  this->Written = false;
  this->Modified(); // or it would not run again
  this->Update();
  vtkDataObject* input = this->GetInputDataObject(0, 0);
  vtkAbstractArray* refusal =
    input ? input->GetFieldData()->GetAbstractArray(PackData::RefusalField) : nullptr;
  if (refusal && RankCommunicator(this->GetController()).Rank() == 0)
  {
    vtkErrorMacro(<< "nothing is written, since the input was refused: "
                  << refusal->GetVariantValue(0).ToString());
  }
  return this->Written;
}

void vtkRUCSolverDeckWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
  os << indent << "Regions: " << this->Regions << "\n";
  os << indent << "Physics: " << this->Physics << "\n";
  os << indent << "LengthFactor: " << this->LengthFactor << "\n";
}
