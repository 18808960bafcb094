// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCCompareProbabilities.h"

#include "ComparisonTables.h"
#include "ImageSlab.h"
#include "PackData.h"
#include "ProbabilityTable.h"
#include "RankCommunicator.h"
#include "ruc/Base/FixedPoint.h"
#include "ruc/Base/Require.h"
#include "ruc/Base/Text.h"
#include "ruc/Statistics/Results/ProbabilityComparison.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkRUCCompareProbabilities);

namespace
{
enum Ports
{
  COMPARISON = 0,
  CURVES = 1,
  DIFFERENCES = 2
};

void RequireSameGrid(const ruc::TwoPointProbability& a, const ruc::TwoPointProbability& b)
{
  ruc::Require(a.Modes == b.Modes, "Cell", ruc::Text("the modes of the input, ", a.Modes), b.Modes);
  // The lags of both may be rounded
  if (a.Lags.Count != b.Lags.Count ||
    std::abs(a.Lags.Spacing - b.Lags.Spacing) > 2.0 * ProbabilityTable::Rounding * a.Lags.Spacing)
  {
    throw std::invalid_argument(ruc::Text("Cell requires the lags of the input, ", a.Lags.Count,
      " steps to ", a.Lags.Maximum(), ", got ", b.Lags.Count, " to ", b.Lags.Maximum(), "."));
  }
}

void RequireSameGrid(vtkImageData* pack, vtkImageData* cell, RankCommunicator& ranks)
{
  std::string error;
  if (!std::equal(pack->GetExtent(), pack->GetExtent() + 6, cell->GetExtent()))
  {
    error = "Cell requires an image of the input's size; set the same NumberOfLags and, for S_rsq, "
            "NumberOfDirections for both.";
  }
  for (int q = 0; q < 3 && error.empty(); ++q)
  {
    const double a = pack->GetSpacing()[q], b = cell->GetSpacing()[q];
    if (!(std::abs(a - b) <= 2.0 * ProbabilityTable::Rounding * std::abs(a)))
    {
      error = ruc::Text("Cell requires an image with the spacing of the input, ", a, ", got ", b,
        "; set the same MaximumLag for both.");
    }
  }
  ranks.ThrowIfAny(error);
}

bool IsError(const std::string& name)
{
  return name.size() > 6 && name.compare(name.size() - 6, 6, "_error") == 0;
}

// The names of the arrays that both images have. A rank without points, which may have no arrays,
// gets those of the others.
std::vector<std::string> CommonArrays(
  vtkImageData* pack, vtkImageData* cell, RankCommunicator& ranks)
{
  std::ostringstream own;
  vtkPointData* points = pack->GetPointData();
  for (int n = 0; pack->GetNumberOfPoints() > 0 && n < points->GetNumberOfArrays(); ++n)
  {
    const char* name = points->GetArrayName(n);
    const vtkIdType count = pack->GetNumberOfPoints();
    if (name && PackData::FindArray(points, name, count) &&
      PackData::FindArray(cell->GetPointData(), name, count))
    {
      own << name << '\n';
    }
  }
  const std::string all = ranks.FirstText(own.str());
  ranks.ThrowIfAny(pack->GetNumberOfPoints() > 0 && own.str() != all
      ? "Cell requires images with the same arrays on all ranks."
      : "");
  std::vector<std::string> names;
  std::istringstream lines(all);
  for (std::string name; std::getline(lines, name);)
  {
    names.push_back(name);
  }
  ruc::Require(!names.empty(), "Cell", "an array of the input's names", "none");
  return names;
}

// The exponent of the least power of two beyond all finite magnitudes of both arrays on all ranks
int FindExponent(vtkDataArray* a, vtkDataArray* b, RankCommunicator& ranks)
{
  double negative = 0.0;
  for (vtkDataArray* array : { a, b })
  {
    for (vtkIdType n = 0; array && n < array->GetNumberOfTuples(); ++n)
    {
      const double magnitude = std::abs(array->GetTuple1(n));
      negative = std::isfinite(magnitude) ? std::min(negative, -magnitude) : negative;
    }
  }
  ranks.Minimum(&negative, 1);
  return negative < 0.0 ? std::ilogb(-negative) + 1 : 0;
}

// A sum of numbers of magnitude below 8 that is the same in whatever order and on however many
// ranks it is taken
class OrderlessSum
{
public:
  void Add(double value)
  {
    ruc::AddWide(ruc::RoundToFixedPoint(std::ldexp(value, Bits)), this->Limbs);
  }
  double Total(RankCommunicator& ranks)
  {
    ranks.Sum(this->Limbs, 2);
    return std::ldexp(ruc::WideValue(this->Limbs), -Bits);
  }

private:
  static constexpr int Bits = 48;
  std::int64_t Limbs[2] = { 0, 0 };
};

// The norms, over all points, of both images and of their difference, and its largest magnitude
struct ImageComparison
{
  double Pack = 0.0, Cell = 0.0, Difference = 0.0, Largest = 0.0;
};

// Adds the magnitude of the difference of two arrays to the image, of which this rank has the
// extent, and returns the norms over all ranks. Points on the border of two slabs belong to the
// upper one.
ImageComparison CompareArrays(vtkDataArray* a, vtkDataArray* b, const std::string& name,
  const int* whole, vtkImageData* image, RankCommunicator& ranks)
{
  const int* extent = image->GetExtent();
  const auto isOwn = [&](int i, int j, int k)
  {
    return (i < extent[1] || i == whole[1]) && (j < extent[3] || j == whole[3]) &&
      (k < extent[5] || k == whole[5]);
  };
  const int exponent = FindExponent(a, b, ranks);
  OrderlessSum norms[3];
  double negative = 0.0;
  vtkIdType place = 0;
  ImageSlab::AddArray(image, name,
    [&](int i, int j, int k)
    {
      const double x = a->GetTuple1(place), y = b->GetTuple1(place++);
      const double difference = std::abs(x - y);
      if (std::isfinite(difference) && isOwn(i, j, k))
      {
        const double values[] = { x, y, difference };
        for (int m = 0; m < 3; ++m)
        {
          const double scaled = std::ldexp(values[m], -exponent);
          norms[m].Add(scaled * scaled);
        }
        negative = std::min(negative, -difference);
      }
      return difference;
    });
  ranks.Minimum(&negative, 1);
  const auto norm = [&](OrderlessSum& sum)
  { return std::ldexp(std::sqrt(sum.Total(ranks)), exponent); };
  return { norm(norms[0]), norm(norms[1]), norm(norms[2]), -negative };
}

// Adds the standard errors of both as the root of the sum of their squares
void AddErrors(vtkDataArray* a, vtkDataArray* b, const std::string& name, vtkImageData* image)
{
  vtkIdType place = 0;
  ImageSlab::AddArray(image, name,
    [&](int, int, int)
    {
      const double x = a->GetTuple1(place), y = b->GetTuple1(place++);
      return std::hypot(x, y);
    });
}
}

vtkRUCCompareProbabilities::vtkRUCCompareProbabilities()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
}

int vtkRUCCompareProbabilities::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  // Execute says that the first port takes one input, and that the second is required
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 1);
  return 1;
}

int vtkRUCCompareProbabilities::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == DIFFERENCES ? "vtkImageData" : "vtkTable");
  return 1;
}

int vtkRUCCompareProbabilities::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* input = inputs[0]->GetInformationObject(0);
  vtkInformation* image = outputs->GetInformationObject(DIFFERENCES);
  const int none[6] = { 0, -1, 0, -1, 0, -1 };
  image->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), none, 6);
  if (input->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()))
  {
    image->CopyEntry(input, vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
    image->CopyEntry(input, vtkDataObject::ORIGIN());
    image->CopyEntry(input, vtkDataObject::SPACING());
  }
  return this->Superclass::RequestInformation(request, inputs, outputs);
}

void vtkRUCCompareProbabilities::Execute(
  vtkInformationVector** inputs, vtkInformationVector* outputs, RankCommunicator& ranks)
{
  RequireOne(inputs[0], "Input", "table or image");
  vtkImageData* pack = vtkImageData::GetData(inputs[0]);
  const int cells = inputs[1]->GetNumberOfInformationObjects();
  if (cells == 0)
  {
    throw std::invalid_argument(ruc::Text("Cell requires ",
      pack ? "an image" : "one or more tables", " to compare the input with, got none."));
  }
  for (int n = 0; n < cells; ++n)
  {
    if ((vtkImageData::GetData(inputs[1], n) != nullptr) != (pack != nullptr))
    {
      throw std::invalid_argument(ruc::Text("Cell requires the kind of data of the input, ",
        pack ? "an image" : "a table", ", got ", pack ? "a table." : "an image."));
    }
  }
  const std::string unit = PackData::FindLengthUnit(vtkDataObject::GetData(inputs[0]), ranks);
  for (int port : { COMPARISON, CURVES, DIFFERENCES })
  {
    PackData::AddField(vtkDataObject::GetData(outputs, port), "LengthUnit", unit);
  }
  if (!pack)
  {
    this->CompareTables(inputs, outputs, ranks);
    return;
  }
  ruc::Require(cells == 1, "Cell", "one image", cells);
  this->CompareImages(pack, vtkImageData::GetData(inputs[1]), outputs, ranks);
}

void vtkRUCCompareProbabilities::CompareTables(
  vtkInformationVector** inputs, vtkInformationVector* outputs, RankCommunicator& ranks) const
{
  const ruc::TwoPointProbability pack =
    ProbabilityTable::Read(vtkTable::GetData(inputs[0]), "Input", ranks);
  std::vector<ruc::TwoPointProbability> cells;
  for (int n = 0; n < inputs[1]->GetNumberOfInformationObjects(); ++n)
  {
    cells.push_back(ProbabilityTable::Read(vtkTable::GetData(inputs[1], n), "Cell", ranks));
    RequireSameGrid(pack, cells.back());
  }
  const ruc::MeanProbability mean = ruc::AverageProbabilities(cells);
  if (ranks.Rank() == 0)
  {
    const bool several = cells.size() > 1;
    ComparisonTables::FillComparison(pack, mean, several, vtkTable::GetData(outputs, COMPARISON));
    ComparisonTables::FillCurves(pack, mean, several, vtkTable::GetData(outputs, CURVES));
  }
  PackData::AddField(vtkTable::GetData(outputs, COMPARISON), "DifferencePercent",
    std::vector<double>{ ruc::CompareProbabilities(pack, mean.Mean).Percent });
  PackData::AddField(vtkTable::GetData(outputs, COMPARISON), "NumberOfCells",
    std::vector<long long>{ static_cast<long long>(cells.size()) });
}

void vtkRUCCompareProbabilities::CompareImages(vtkImageData* pack, vtkImageData* cell,
  vtkInformationVector* outputs, RankCommunicator& ranks) const
{
  RequireSameGrid(pack, cell, ranks);
  vtkImageData* image = vtkImageData::GetData(outputs, DIFFERENCES);
  image->CopyStructure(pack);
  vtkInformation* info = outputs->GetInformationObject(DIFFERENCES);
  const int* whole = info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
  ComparisonTables::Rows rows;
  const auto addRow = [&](const std::string& name, const ImageComparison& of)
  {
    rows.Add(name, of.Pack, of.Cell, of.Difference, of.Largest,
      ComparisonTables::Percent(of.Difference, of.Pack, of.Cell), 0.0);
  };
  ImageComparison all;
  for (const std::string& name : CommonArrays(pack, cell, ranks))
  {
    vtkDataArray* a = pack->GetPointData()->GetArray(name.c_str());
    vtkDataArray* b = cell->GetPointData()->GetArray(name.c_str());
    if (IsError(name))
    {
      AddErrors(a, b, name, image);
      continue;
    }
    const ImageComparison one = CompareArrays(a, b, name, whole, image, ranks);
    addRow(name, one);
    all = { all.Pack + one.Pack, all.Cell + one.Cell, all.Difference + one.Difference,
      std::max(all.Largest, one.Largest) };
  }
  addRow("all", all);
  vtkTable* table = vtkTable::GetData(outputs, COMPARISON);
  if (ranks.Rank() == 0)
  {
    rows.Fill(table, false);
  }
  PackData::AddField(table, "DifferencePercent",
    std::vector<double>{ ComparisonTables::Percent(all.Difference, all.Pack, all.Cell) });
  info->Set(vtkDataObject::SPACING(), image->GetSpacing(), 3);
}
