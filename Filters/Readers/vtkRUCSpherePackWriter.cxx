// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCSpherePackWriter.h"

#include "NewFile.h"
#include "PackData.h"
#include "PackInput.h"
#include "RankCommunicator.h"
#include "ruc/Base/Text.h"
#include "ruc/Formats/PackFormats.h"

#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <tuple>

vtkStandardNewMacro(vtkRUCSpherePackWriter);

namespace
{
// The spheres of a rank, or of all
struct Spheres
{
  ruc::SpherePack Pack;
  std::vector<int> Type;

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Pack, self.Type);
  }
};

// Which arrays all points have
struct Arrays
{
  bool Id = false, Mode = false, Type = false;
};

template <class Number>
std::vector<Number> ReadWhole(vtkPointSet* points, const char* name)
{
  constexpr double most =
    std::min(9007199254740992.0, static_cast<double>(std::numeric_limits<Number>::max()));
  vtkDataArray* array = PackData::RequireArray(points, name);
  std::vector<Number> numbers;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    const double value = array->GetTuple1(i);
    if (!(value == std::floor(value) && std::abs(value) <= most))
    {
      throw std::invalid_argument(
        ruc::Text("Array '", name, "' requires whole numbers, got ", value, "."));
    }
    numbers.push_back(static_cast<Number>(value));
  }
  return numbers;
}

Spheres ReadSpheres(vtkPointSet* points, const Arrays& arrays)
{
  Spheres spheres;
  ruc::SpherePack& pack = spheres.Pack;
  const vtkIdType count = points ? points->GetNumberOfPoints() : 0;
  if (count == 0)
  {
    return spheres;
  }
  vtkDataArray* radius = PackData::RequireArray(points, "Radius");
  for (vtkIdType i = 0; i < count; ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    pack.X.push_back(p[0]);
    pack.Y.push_back(p[1]);
    pack.Z.push_back(p[2]);
    pack.Radius.push_back(radius->GetTuple1(i));
  }
  pack.Id = arrays.Id ? ReadWhole<std::int64_t>(points, "Id") : std::vector<std::int64_t>();
  pack.Mode = arrays.Mode ? ReadWhole<int>(points, "Mode") : std::vector<int>();
  spheres.Type = arrays.Mode ? pack.Mode
    : arrays.Type            ? ReadWhole<int>(points, "Type")
                             : std::vector<int>();
  const std::string fault = ruc::FindFaultySphere(pack, false, 0);
  if (!fault.empty())
  {
    throw std::invalid_argument(fault);
  }
  return spheres;
}

// By ids, if there are any and none repeats, otherwise by place
void Sort(Spheres& spheres)
{
  const ruc::SpherePack& pack = spheres.Pack;
  std::vector<std::size_t> order(pack.Size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto byPlace = [&](std::size_t i)
  {
    return std::tuple(
      pack.X[i], pack.Y[i], pack.Z[i], pack.Radius[i], spheres.Type.empty() ? 0 : spheres.Type[i]);
  };
  std::sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b) { return byPlace(a) < byPlace(b); });
  const auto id = [&](std::size_t i) { return pack.Id.empty() ? 0 : pack.Id[i]; };
  std::vector<std::size_t> byId = order;
  std::stable_sort(
    byId.begin(), byId.end(), [&](std::size_t a, std::size_t b) { return id(a) < id(b); });
  const bool distinct = !pack.Id.empty() &&
    std::adjacent_find(byId.begin(), byId.end(),
      [&](std::size_t a, std::size_t b) { return id(a) == id(b); }) == byId.end();
  Spheres sorted;
  for (std::size_t i : distinct ? byId : order)
  {
    sorted.Pack.Append(pack, i);
    if (!spheres.Type.empty())
    {
      sorted.Type.push_back(spheres.Type[i]);
    }
  }
  if (!distinct)
  {
    sorted.Pack.Id.resize(sorted.Pack.Size());
    std::iota(sorted.Pack.Id.begin(), sorted.Pack.Id.end(), std::int64_t(0));
  }
  spheres = std::move(sorted);
}

std::string CannotWrite(const std::exception& e)
{
  return ruc::Text("FileName requires a file that can be written: ", e.what(), ".");
}

// Returns the whole pack on rank 0. Collective
ruc::FramePack Gather(vtkDataObject* input, RankCommunicator& ranks)
{
  const vtkSmartPointer<vtkPointSet> points = PackInput::Find(input, ranks);
  const auto allHave = [&](const char* name)
  {
    return ranks.All(!points || points->GetNumberOfPoints() == 0 ||
      PackData::FindArray(points->GetPointData(), name, points->GetNumberOfPoints()));
  };
  Arrays arrays;
  arrays.Id = allHave("Id");
  arrays.Mode = allHave("Mode");
  arrays.Type = allHave("Type");
  std::vector<Spheres> outgoing(ranks.Size());
  ranks.Agree([&]() { outgoing[0] = ReadSpheres(points, arrays); });
  Spheres all;
  for (const Spheres& piece : ranks.AllToAll(std::move(outgoing)))
  {
    all.Pack.Append(piece.Pack);
    all.Type.insert(all.Type.end(), piece.Type.begin(), piece.Type.end());
  }
  Sort(all);
  ruc::FramePack pack;
  // A window that was found is no box of the pack, which reaches beyond it
  if (!PackData::TakesFoundWindow(points, {}, ranks))
  {
    pack.Box = PackData::FindOwnWindow(points, ranks);
  }
  pack.LengthUnit = PackData::FindLengthUnit(points, ranks);
  pack.Pack = std::move(all.Pack);
  pack.Type = std::move(all.Type);
  return pack;
}

// The cells of Unit Cell Reconstruction are packs of their own; any other input is one pack.
// Collective
std::vector<vtkDataObject*> FindPacks(vtkDataObject* input, RankCommunicator& ranks)
{
  std::vector<vtkDataObject*> cells;
  bool named = false;
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(input);
  for (unsigned int n = 0; blocks && n < blocks->GetNumberOfBlocks(); ++n)
  {
    cells.push_back(blocks->GetBlock(n));
    named = named || (cells.back() && cells.back()->GetFieldData()->GetAbstractArray("Cell"));
  }
  if (ranks.All(!named))
  {
    return { input };
  }
  double most = -static_cast<double>(cells.size());
  ranks.Minimum(&most, 1);
  cells.resize(static_cast<std::size_t>(-most), nullptr);
  return cells;
}
}

vtkRUCSpherePackWriter::vtkRUCSpherePackWriter()
{
  this->SetNumberOfOutputPorts(0);
}

vtkRUCSpherePackWriter::~vtkRUCSpherePackWriter() = default;

int vtkRUCSpherePackWriter::FillInputPortInformation(int, vtkInformation* info)
{
  PackInput::Accept(info);
  return 1;
}

int vtkRUCSpherePackWriter::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (this->Step < this->Times.size() && inputs[0]->GetNumberOfInformationObjects() > 0)
  {
    inputs[0]->GetInformationObject(0)->Set(
      vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP(), this->Times[this->Step]);
  }
  return this->Superclass::RequestUpdateExtent(request, inputs, outputs);
}

const ruc::PackFormat& vtkRUCSpherePackWriter::FindFormat() const
{
  const std::size_t point = this->FileName.find_last_of("./");
  return ruc::FormatOfExtension(point == std::string::npos || this->FileName[point] == '/'
      ? ""
      : this->FileName.substr(point + 1));
}

void vtkRUCSpherePackWriter::Execute(
  vtkInformationVector** inputs, vtkInformationVector*, RankCommunicator& ranks)
{
  RequireOne(inputs[0], "Input", "pack");
  const ruc::PackFormat& format = this->FindFormat();
  vtkDataObject* input = vtkDataObject::GetData(inputs[0]);
  const std::vector<vtkDataObject*> packs = FindPacks(input, ranks);
  const std::size_t frames = std::max<std::size_t>(this->Times.size(), 1) * packs.size();
  if (frames > 1 && !format.Writer.HoldsFrames)
  {
    throw std::invalid_argument(ruc::Text("a file of the format ", format.Name,
      " holds one pack, got ", frames, "; write them as dump or extxyz, or take one out."));
  }
  for (vtkDataObject* of : packs)
  {
    ruc::FramePack pack = Gather(of, ranks);
    if (frames > 1)
    {
      pack.Time = this->Times.empty() || packs.size() > 1 ? static_cast<double>(this->Frames)
                                                          : this->Times[this->Step];
    }
    else if (input && input->GetInformation()->Has(vtkDataObject::DATA_TIME_STEP()))
    {
      pack.Time = input->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP());
    }
    ranks.Agree(
      [&]()
      {
        if (ranks.Rank() == 0)
        {
          this->Append(pack);
        }
      });
    ++this->Frames;
  }
  this->Gathered = true;
}

void vtkRUCSpherePackWriter::Append(const ruc::FramePack& pack)
{
  ruc::WriteSettings settings;
  settings.Density = this->Density;
  settings.Frame = static_cast<std::int64_t>(this->Frames);
  const ruc::PackFormat& format = this->FindFormat();
  const ruc::WrittenPack written = ruc::WritePack(format, pack, settings);
  if (!pack.LengthUnit.empty() && !written.HoldLengthUnit && this->Frames == 0)
  {
    vtkWarningMacro(<< "the unit of length, '" << pack.LengthUnit
                    << "', is not written: a file of the format " << format.Name
                    << " does not tell it.");
  }
  this->Info = written.Info;
  try
  {
    if (!this->File)
    {
      this->File = std::make_unique<NewFile>(this->FileName);
    }
    this->File->Append(written.Bytes);
  }
  catch (const std::exception& e)
  {
    throw std::invalid_argument(CannotWrite(e));
  }
}

std::vector<double> vtkRUCSpherePackWriter::FindTimes(RankCommunicator& ranks)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  std::vector<double> times;
  if (this->WriteAllTimeSteps)
  {
    this->UpdateInformation();
    vtkInformation* info = this->GetInputInformation(0, 0);
    if (info->Has(Pipeline::TIME_STEPS()))
    {
      const double* steps = info->Get(Pipeline::TIME_STEPS());
      times.assign(steps, steps + info->Length(Pipeline::TIME_STEPS()));
    }
    ranks.Broadcast(times, 0);
  }
  return times;
}

void vtkRUCSpherePackWriter::KeepFiles()
{
  if (!this->Info.empty())
  {
    NewFile info(this->FileName.substr(0, this->FileName.find_last_of('.')) + ".nfo");
    info.Append(this->Info);
    info.Keep();
  }
  this->File->Keep();
}

vtkAbstractArray* vtkRUCSpherePackWriter::FindRefusal()
{
  vtkDataObject* input = this->GetInputDataObject(0, 0);
  return input ? input->GetFieldData()->GetAbstractArray(PackData::RefusalField) : nullptr;
}

int vtkRUCSpherePackWriter::Write()
{
  RankCommunicator ranks(this->GetController());
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    vtkErrorMacro(<< "Input requires a pack, got none.");
    return 0;
  }
  this->File.reset();
  this->Info.clear();
  this->Frames = 0;
  this->Times = this->FindTimes(ranks);
  this->Step = 0;
  do
  {
    this->Gathered = false;
    this->Modified(); // or it would not run again
    this->Update();
  } while (this->Gathered && ++this->Step < this->Times.size());
  this->Times.clear();
  std::string error;
  if (vtkAbstractArray* refusal = this->FindRefusal(); refusal && ranks.Rank() == 0)
  {
    vtkErrorMacro(<< "nothing is written, since the input was refused: "
                  << refusal->GetVariantValue(0).ToString());
  }
  if (this->Gathered && ranks.Rank() == 0)
  {
    try
    {
      this->KeepFiles();
    }
    catch (const std::exception& e)
    {
      error = CannotWrite(e);
      vtkErrorMacro(<< error);
    }
  }
  this->File.reset(); // and what was begun of it
  return this->Gathered && ranks.FirstText(error).empty();
}

void vtkRUCSpherePackWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
  os << indent << "Density: " << this->Density << "\n";
  os << indent << "WriteAllTimeSteps: " << this->WriteAllTimeSteps << "\n";
}
