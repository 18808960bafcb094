// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Files of voxels are the same on any number of ranks, and come into being whole or not at all
#include "Equality.h"
#include "Refusals.h"

#include "vtkRUCLabelImage.h"
#include "vtkRUCRawImageWriter.h"

#include "vtkCellData.h"
#include "vtkMultiProcessController.h"
#include "vtkUnsignedCharArray.h"

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

using Writer = vtkRUCRawImageWriter;

namespace
{
// A file of this test alone
std::string FileOf(const std::string& what)
{
  return "image_np" + std::to_string(NumberOfRanks()) + what;
}

std::string ReadFile(const std::string& name)
{
  vtkMultiProcessController::GetGlobalController()->Barrier();
  std::ifstream file(name, std::ios::binary);
  return std::string((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
}

// The cells of a rank of an image of 7 x 5 x 11 voxels, which it shares with the others along an
// axis. A voxel's number is x + 10 y + 100 z - 300
template <class Array>
vtkSmartPointer<vtkImageData> Image(int along = 2)
{
  const int voxels[3] = { 7, 5, 11 };
  auto image = vtkSmartPointer<vtkImageData>::New();
  int extent[6] = { 0, voxels[0], 0, voxels[1], 0, voxels[2] };
  extent[2 * along] = voxels[along] * Rank() / NumberOfRanks();
  extent[2 * along + 1] = voxels[along] * (Rank() + 1) / NumberOfRanks();
  image->SetExtent(extent);
  image->SetSpacing(0.5, 1.0, 2.0);
  image->SetOrigin(-1.0, 2.0, 3.0);
  vtkNew<Array> values;
  values->SetName("Number");
  for (int z = extent[4]; z < extent[5]; ++z)
  {
    for (int y = extent[2]; y < extent[3]; ++y)
    {
      for (int x = extent[0]; x < extent[1]; ++x)
      {
        values->InsertNextValue(x + 10 * y + 100 * z - 300);
      }
    }
  }
  image->GetCellData()->AddArray(values);
  return image;
}

// What a file should hold after its header
std::string Expected(bool bigEndian, const std::function<std::int32_t(std::int32_t)>& mapped)
{
  std::string bytes;
  for (int z = 0; z < 11; ++z)
  {
    for (int y = 0; y < 5; ++y)
    {
      for (int x = 0; x < 7; ++x)
      {
        const std::uint32_t number = static_cast<std::uint32_t>(mapped(x + 10 * y + 100 * z - 300));
        for (int byte = 0; byte < 4; ++byte)
        {
          bytes += static_cast<char>(number >> 8 * (bigEndian ? 3 - byte : byte) & 255);
        }
      }
    }
  }
  return bytes;
}

bool LeavesNothing(const std::string& name)
{
  vtkMultiProcessController::GetGlobalController()->Barrier();
  for (const auto& entry : std::filesystem::directory_iterator("."))
  {
    if (entry.path().filename().string().rfind(name, 0) == 0)
    {
      return false;
    }
  }
  return true;
}

void Refuses(const std::vector<std::string>& parts, vtkImageData* image,
  const std::function<void(Writer*)>& configure)
{
  const std::string name = FileOf("_refused.raw");
  vtkNew<Writer> writer;
  const Errors errors(writer);
  writer->SetInputData(image);
  writer->SetFileName(name.c_str());
  configure(writer);
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_EQ(errors.Texts.size(), Rank() == 0 ? 1u : 0u);
  for (const std::string& text : errors.Texts)
  {
    ExpectParts(text, parts);
    ExpectParts(text, { "Raw Image Writer" });
  }
  EXPECT_TRUE(LeavesNothing(name));
}
}

TEST(RawImageWriter, NumbersAreAtTheirPlaces)
{
  for (int along : { 0, 1, 2 })
  {
    for (bool bigEndian : { false, true })
    {
      const std::string name = FileOf("_plain.raw");
      vtkNew<Writer> writer;
      writer->SetInputData(Image<vtkIntArray>(along));
      writer->SetFileName(name.c_str());
      writer->SetByteOrder(bigEndian ? Writer::BIG_ENDIAN_BYTES : Writer::LITTLE_ENDIAN_BYTES);
      EXPECT_EQ(writer->Write(), 1);
      EXPECT_EQ(ReadFile(name), Expected(bigEndian, [](auto n) { return n; })) << along;
      writer->SetValues("-300 - -1=0; 0=5; 1-900=-1");
      EXPECT_EQ(writer->Write(), 1);
      EXPECT_EQ(
        ReadFile(name), Expected(bigEndian, [](auto n) { return n < 0 ? 0
                                                           : n == 0   ? 5
                                                                      : -1; }));
    }
  }
}

TEST(RawImageWriter, HeadersComeBefore)
{
  const auto write = [](const std::string& name, int header)
  {
    vtkNew<Writer> writer;
    writer->SetInputData(Image<vtkIntArray>());
    writer->SetFileName(name.c_str());
    writer->SetHeader(header);
    EXPECT_EQ(writer->Write(), 1);
    return ReadFile(name);
  };
  const std::string little = Expected(false, [](auto n) { return n; });
  const std::string meta = write(FileOf(".mha"), Writer::BY_EXTENSION);
  EXPECT_EQ(meta.substr(meta.size() - little.size()), little);
  ExpectParts(
    meta, { "DimSize = 7 5 11\n", "Offset = -0.75 2.5 4\n", "MET_INT\nElementDataFile = LOCAL\n" });
  const std::string amitex = write(FileOf(".vtk"), Writer::BY_EXTENSION);
  const std::string big = Expected(true, [](auto n) { return n; });
  EXPECT_EQ(amitex.substr(amitex.size() - big.size()), big);
  ExpectParts(
    amitex, { "DIMENSIONS    8   6   12\n", "SCALARS Number int\nLOOKUP_TABLE default\n" });
  EXPECT_EQ(write(FileOf(".raw"), Writer::AMITEX_VTK), amitex);
  EXPECT_EQ(write(FileOf("_none.vtk"), Writer::NONE), little);
  const std::string apart = write(FileOf("_apart.mhd"), Writer::BY_EXTENSION);
  ExpectParts(apart, { "ElementDataFile = " + FileOf("_apart.raw") + "\n" });
  EXPECT_EQ(ReadFile(FileOf("_apart.raw")), little);
}

// In pieces of cells or points, an image that is made on all ranks is written as by one
TEST(RawImageWriter, LabelImagesAreThoseOfOneRank)
{
  for (int on : { vtkRUCLabelImage::CELLS, vtkRUCLabelImage::POINTS })
  {
    const auto write = [&](const std::string& name, vtkMultiProcessController* controller,
                         const std::function<bool(std::size_t)>& keep)
    {
      vtkNew<vtkRUCLabelImage> labels;
      labels->SetController(controller);
      labels->SetInputData(MakePolyData(FewSizes(), Edge, true, keep));
      labels->SetDimensions(31, 17, 23);
      labels->SetArrayOn(on);
      vtkNew<Writer> writer;
      writer->SetController(controller);
      writer->SetInputConnection(labels->GetOutputPort());
      writer->SetFileName(name.c_str());
      EXPECT_EQ(writer->Write(), 1);
    };
    const std::string together = FileOf("_together.mha");
    const std::string alone = FileOf("_alone_" + std::to_string(Rank()) + ".mha");
    write(together, vtkMultiProcessController::GetGlobalController(), IsMine);
    write(alone, nullptr, [](std::size_t) { return true; });
    EXPECT_TRUE(ReadFile(together) == ReadFile(alone));
    EXPECT_GT(ReadFile(alone).size(), 31u * 17 * 23);
  }
}

TEST(RawImageWriterRefusals, Settings)
{
  const auto image = Image<vtkUnsignedCharArray>();
  Refuses(
    { "Header requires a value from 0 to 3, got 7." }, image, [](Writer* w) { w->SetHeader(7); });
  Refuses({ "ByteOrder requires the value 0 or 1, got -1." }, image,
    [](Writer* w) { w->SetByteOrder(-1); });
  Refuses({ "Values requires values and others", "got '1:2'." }, image,
    [](Writer* w) { w->SetValues("0=1; 1:2"); });
  Refuses({ "Values requires numbers of the type of the image, which is unsigned char, got 256." },
    image, [](Writer* w) { w->SetValues("0=256"); });
  Refuses({ "ImageArray requires an array of one component 'Phase', got on cells 'Number'" }, image,
    [](Writer* w) { w->SetImageArray("Phase"); });
  Refuses({ "FileName requires the name of a file, got none." }, image,
    [](Writer* w) { w->SetFileName(""); });
  Refuses({ "cannot write 'no_such_folder/a.raw.new-", "No such file or directory" }, image,
    [](Writer* w) { w->SetFileName("no_such_folder/a.raw"); });
}

TEST(RawImageWriterRefusals, Images)
{
  const auto asItIs = [](Writer*) {};
  vtkNew<vtkImageData> none;
  Refuses({ "Input requires an image with voxels, got none." }, none, asItIs);
  // On the last rank alone
  const bool last = Rank() == NumberOfRanks() - 1;
  const auto turned = Image<vtkIntArray>();
  if (last)
  {
    turned->SetDirectionMatrix(0, 1, 0, 1, 0, 0, 0, 0, 1);
  }
  Refuses({ "Input requires an image with axes along x, y and z, got one with turned axes." },
    turned, asItIs);
  const auto rgb = Image<vtkIntArray>();
  if (last)
  {
    vtkNew<vtkIntArray> colours;
    colours->SetName("Number");
    colours->SetNumberOfComponents(3);
    colours->SetNumberOfTuples(rgb->GetNumberOfCells());
    colours->Fill(0.0);
    rgb->GetCellData()->RemoveArray("Number");
    rgb->GetCellData()->AddArray(colours);
  }
  Refuses({ "'Number' requires one component, got 3." }, rgb,
    [](Writer* w) { w->SetImageArray("Number"); });
  const auto few = Image<vtkIntArray>();
  if (last)
  {
    few->GetCellData()->GetArray("Number")->SetNumberOfTuples(3);
  }
  Refuses({ "'Number' requires a value for each of", "voxels, got 3." }, few, asItIs);
  if (NumberOfRanks() > 2)
  {
    Refuses({ "Input requires all", "voxels of the image on the ranks together, got" },
      Rank() == 1 ? none.Get() : Image<vtkIntArray>().Get(), asItIs);
  }
  if (NumberOfRanks() > 1)
  {
    Refuses({ "Input requires pieces of one image" },
      last ? Image<vtkUnsignedCharArray>().Get() : Image<vtkIntArray>().Get(), asItIs);
  }
}

TEST(RawImageWriterRefusals, AnOldFileStays)
{
  const std::string name = FileOf("_old.raw");
  vtkNew<Writer> writer;
  const Errors errors(writer);
  writer->SetInputData(Image<vtkIntArray>());
  writer->SetFileName(name.c_str());
  EXPECT_EQ(writer->Write(), 1);
  const std::string before = ReadFile(name);
  writer->SetImageArray("another");
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_EQ(ReadFile(name), before);
}
