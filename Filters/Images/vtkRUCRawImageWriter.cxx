// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCRawImageWriter.h"

#include "ImagePiece.h"
#include "NewFile.h"
#include "PackData.h"
#include "RankCommunicator.h"
#include "ruc/Base/Require.h"
#include "ruc/Base/Text.h"
#include "ruc/Images/RawImage.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkSetGet.h"
#include "vtkVariant.h"

#include <optional>
#include <stdexcept>
#include <type_traits>

vtkStandardNewMacro(vtkRUCRawImageWriter);

namespace
{
// Calls visit(values) with the values of an array of that type, null for null
template <class Visit>
void WithValues(int dataType, vtkDataArray* array, Visit&& visit)
{
  void* values = array ? array->GetVoidPointer(0) : nullptr;
  switch (dataType)
  {
    vtkTemplateMacro(visit(static_cast<VTK_TT*>(values)));
    default:
      throw std::invalid_argument("ImageArray requires numbers, got another type.");
  }
}

// Fills in what the type of the array tells
void DescribeType(int dataType, ruc::RawImage& image)
{
  WithValues(dataType, nullptr,
    [&](auto* values)
    {
      using Number = std::remove_pointer_t<decltype(values)>;
      image.Integer = std::is_integral_v<Number>;
      image.Signed = std::is_signed_v<Number>;
      image.BytesOfNumber = sizeof(Number);
    });
}

// Calls write(offset, bytes) for the voxels of the block, in runs that are together in the file
template <class Number, class Write>
void WriteBlock(const ImagePiece& piece, const Number* values, const ruc::ValueMap& map,
  bool turned, std::uint64_t begin, Write&& write)
{
  const ruc::VoxelBlock& block = piece.Block;
  const auto& whole = piece.Grid.Dimensions;
  // Whole rows of the image lie together, plane by plane
  const int rows = block.Count[0] == whole[0] ? block.Count[1] : 1;
  const std::size_t run = static_cast<std::size_t>(block.Count[0]) * rows;
  std::string bytes;
  for (int z = 0; z < block.Count[2]; ++z)
  {
    for (int y = 0; y < block.Count[1]; y += rows, values += run)
    {
      bytes.clear();
      ruc::AppendNumbers(values, run, map, turned, bytes);
      const std::uint64_t place =
        (static_cast<std::uint64_t>(block.First[2] + z) * whole[1] + (block.First[1] + y)) *
          whole[0] +
        block.First[0];
      write(begin + place * sizeof(Number), bytes);
    }
  }
}

// Writes the voxels of this rank into the file that rank 0 makes. Collective
void WriteVoxels(const std::string& name, const std::string& header, const ImagePiece& piece,
  const ruc::ValueMap& map, bool turned, std::size_t bytesOfNumber, RankCommunicator& ranks,
  std::optional<NewFile>& file)
{
  std::string fresh;
  ranks.Agree(
    [&]()
    {
      if (ranks.Rank() == 0)
      {
        file.emplace(name);
        file->Append(header);
        file->Lengthen(header.size() +
          static_cast<std::uint64_t>(piece.Grid.Dimensions[0]) * piece.Grid.Dimensions[1] *
            piece.Grid.Dimensions[2] * bytesOfNumber);
        fresh = file->FreshName();
      }
    });
  ranks.Broadcast(fresh, 0);
  ranks.Agree(
    [&]()
    {
      if (piece.Array)
      {
        PartOfNewFile part(fresh);
        WithValues(piece.DataType, piece.Array,
          [&](auto* values)
          {
            WriteBlock(piece, values, map, turned, header.size(),
              [&](std::uint64_t offset, const std::string& bytes) { part.WriteAt(offset, bytes); });
          });
        part.Finish();
      }
    });
}
}

vtkRUCRawImageWriter::vtkRUCRawImageWriter()
{
  this->SetNumberOfOutputPorts(0);
}

int vtkRUCRawImageWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

bool vtkRUCRawImageWriter::HasExtension(const char* extension) const
{
  const std::size_t point = this->FileName.find_last_of("./");
  return point != std::string::npos && this->FileName.substr(point) == std::string(".") + extension;
}

ruc::RawHeader vtkRUCRawImageWriter::FindHeader() const
{
  ruc::Require(this->Header >= BY_EXTENSION && this->Header <= NONE, "Header",
    "a value from 0 to 3", this->Header);
  const bool byExtension = this->Header == BY_EXTENSION;
  if (this->Header == META_IMAGE ||
    (byExtension && (this->HasExtension("mha") || this->HasExtension("mhd"))))
  {
    return ruc::RawHeader::MetaImage;
  }
  return this->Header == AMITEX_VTK || (byExtension && this->HasExtension("vtk"))
    ? ruc::RawHeader::AmitexVtk
    : ruc::RawHeader::None;
}

void vtkRUCRawImageWriter::Execute(
  vtkInformationVector** inputs, vtkInformationVector*, RankCommunicator& ranks)
{
  RequireOne(inputs[0], "Input", "image");
  ruc::Require(!this->FileName.empty(), "FileName", "the name of a file", "none");
  ruc::Require(this->ByteOrder == LITTLE_ENDIAN_BYTES || this->ByteOrder == BIG_ENDIAN_BYTES,
    "ByteOrder", "the value 0 or 1", this->ByteOrder);
  const ruc::RawHeader kind = this->FindHeader();
  const ruc::ValueMap map(this->Values);
  const ImagePiece piece =
    ImagePiece::Find(vtkImageData::GetData(inputs[0]), this->ImageArray, ranks);
  ruc::RawImage image = this->DescribeImage(piece, kind);
  WithValues(piece.DataType, nullptr,
    [&](auto* values)
    {
      map.RequireHeld<std::remove_pointer_t<decltype(values)>>(
        vtkImageScalarTypeNameMacro(piece.DataType));
    });

  const bool apart = image.Header == ruc::RawHeader::MetaImage && this->HasExtension("mhd");
  const std::string stem = this->FileName.substr(0, this->FileName.find_last_of('.'));
  if (apart)
  {
    image.DataFile = stem.substr(stem.find_last_of('/') + 1) + ".raw"; // npos + 1 is 0
  }
  const std::string header = ruc::WriteHeader(image);
  std::optional<NewFile> voxels;
  WriteVoxels(apart ? stem + ".raw" : this->FileName, apart ? std::string() : header, piece, map,
    image.IsBigEndian() != ruc::IsBigEndianHere(), image.BytesOfNumber, ranks, voxels);
  ranks.Agree(
    [&]()
    {
      if (ranks.Rank() == 0)
      {
        this->KeepFiles(*voxels, apart ? header : std::string());
      }
    });
  this->Written = true;
}

ruc::RawImage vtkRUCRawImageWriter::DescribeImage(
  const ImagePiece& piece, ruc::RawHeader header) const
{
  ruc::RawImage image;
  image.Header = header;
  image.BigEndian = this->ByteOrder == BIG_ENDIAN_BYTES;
  image.Grid = piece.Grid;
  image.Name = piece.Name;
  DescribeType(piece.DataType, image);
  return image;
}

void vtkRUCRawImageWriter::KeepFiles(NewFile& voxels, const std::string& header) const
{
  if (header.empty())
  {
    voxels.Keep();
    return;
  }
  NewFile file(this->FileName);
  file.Append(header);
  voxels.Keep();
  file.Keep();
}

int vtkRUCRawImageWriter::Write()
{
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    vtkErrorMacro(<< "Input requires an image, got none.");
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

void vtkRUCRawImageWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
  os << indent << "Header: " << this->Header << "\n";
  os << indent << "ImageArray: " << this->ImageArray << "\n";
  os << indent << "Values: " << this->Values << "\n";
  os << indent << "ByteOrder: " << this->ByteOrder << "\n";
}
