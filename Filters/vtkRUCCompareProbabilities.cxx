// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCCompareProbabilities.h"

#include "FixedPoint.h"
#include "ImageSlab.h"
#include "PackData.h"
#include "ProbabilityTable.h"
#include "RankCommunicator.h"
#include "Statistics/ProbabilityComparison.h"
#include "Text.h"

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

// The rows of output 0
class Rows
{
public:
  void Add(const std::string& quantity, double pack, double cell, double difference, double largest,
    double percent, double deviation)
  {
    this->Quantity.push_back(quantity);
    this->Numbers[0].push_back(pack);
    this->Numbers[1].push_back(cell);
    this->Numbers[2].push_back(difference);
    this->Numbers[3].push_back(largest);
    this->Numbers[4].push_back(percent);
    this->Numbers[5].push_back(deviation);
  }
  void Fill(vtkTable* table, bool withDeviations) const
  {
    const char* names[] = { "Pack", "Cell", "Difference", "LargestDifference", "Percent",
      "StandardDeviation" };
    PackData::AddColumn(table, "Quantity", this->Quantity);
    for (int n = 0; n < (withDeviations ? 6 : 5); ++n)
    {
      PackData::AddColumn(table, names[n], this->Numbers[n]);
    }
  }

private:
  std::vector<std::string> Quantity;
  std::vector<double> Numbers[6];
};

double Percent(double difference, double pack, double cell)
{
  const double mean = 0.5 * (pack + cell);
  return mean > 0.0 ? difference / mean * 100.0 : 0.0;
}

double LargestDifference(const std::vector<double>& a, const std::vector<double>& b)
{
  double largest = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k)
  {
    largest = std::max(largest, std::abs(a[k] - b[k]));
  }
  return largest;
}

void FillRows(const ruc::TwoPointProbability& pack, const ruc::MeanProbability& cells, Rows& rows)
{
  const ruc::TwoPointProbability& cell = cells.Mean;
  const ruc::ProbabilityComparison comparison = ruc::CompareProbabilities(pack, cell);
  for (int phase = 0; phase < pack.Phases(); ++phase)
  {
    const double a = pack.Fractions[phase], b = cell.Fractions[phase];
    const double difference = std::abs(a - b);
    rows.Add("c_" + pack.PhaseName(phase), a, b, difference, difference,
      phase < pack.Modes ? comparison.FractionPercent[phase] : Percent(difference, a, b),
      cells.FractionDeviations[phase]);
  }
  double sums[4] = { 0.0, 0.0, 0.0, 0.0 }, largest = 0.0;
  for (int r = 0; r < pack.Phases(); ++r)
  {
    for (int s = r; s < pack.Phases(); ++s)
    {
      const double norms[] = { ruc::DiscreteNorm(pack.S(r, s)), ruc::DiscreteNorm(cell.S(r, s)),
        ruc::NormOfDifference(pack.S(r, s), cell.S(r, s)),
        ruc::DiscreteNorm(cells.Deviations[pack.PairOf(r, s)]) };
      const double most = LargestDifference(pack.S(r, s), cell.S(r, s));
      rows.Add(PackData::PairName(pack, r, s), norms[0], norms[1], norms[2], most,
        Percent(norms[2], norms[0], norms[1]), norms[3]);
      for (int n = 0; n < 4; ++n)
      {
        sums[n] += (r == s ? 1.0 : 2.0) * norms[n];
      }
      largest = std::max(largest, most);
    }
  }
  rows.Add("all", sums[0], sums[1], sums[2], largest, comparison.Percent, sums[3]);
}

void FillCurves(const ruc::TwoPointProbability& pack, const ruc::MeanProbability& cells,
  bool several, vtkTable* table)
{
  PackData::AddLags(table, pack.Lags);
  for (int r = 0; r < pack.Phases(); ++r)
  {
    for (int s = r; s < pack.Phases(); ++s)
    {
      const std::string name = PackData::PairName(pack, r, s);
      const std::vector<double>&a = pack.S(r, s), &b = cells.Mean.S(r, s);
      std::vector<double> difference(a.size());
      std::transform(a.begin(), a.end(), b.begin(), difference.begin(), std::minus<>());
      PackData::AddColumn(table, name + "_pack", a);
      PackData::AddColumn(table, name + "_cell", b);
      PackData::AddColumn(table, name + "_difference", difference);
      if (several)
      {
        PackData::AddColumn(table, name + "_deviation", cells.Deviations[pack.PairOf(r, s)]);
      }
    }
  }
}

void RequireSameGrid(const ruc::TwoPointProbability& a, const ruc::TwoPointProbability& b)
{
  if (a.Modes != b.Modes)
  {
    throw std::invalid_argument(
      ruc::Text("Cell requires the modes of the input, ", a.Modes, ", got ", b.Modes, "."));
  }
  if (a.Lags.Count != b.Lags.Count ||
    std::abs(a.Lags.Spacing - b.Lags.Spacing) > 1e-6 * a.Lags.Spacing)
  {
    throw std::invalid_argument(ruc::Text("Cell requires the lags of the input, ", a.Lags.Count,
      " steps to ", a.Lags.Maximum(), ", got ", b.Lags.Count, " to ", b.Lags.Maximum(), "."));
  }
}

bool IsError(const std::string& name)
{
  return name.size() > 6 && name.compare(name.size() - 6, 6, "_error") == 0;
}

// The arrays of both images; on a rank without points, which may have none, those of the others
std::vector<std::string> CommonArrays(
  vtkImageData* pack, vtkImageData* cell, RankCommunicator& ranks)
{
  std::ostringstream own;
  vtkPointData* points = pack->GetPointData();
  for (int n = 0; pack->GetNumberOfPoints() > 0 && n < points->GetNumberOfArrays(); ++n)
  {
    vtkDataArray* a = points->GetArray(n);
    vtkDataArray* b = a && a->GetName() ? cell->GetPointData()->GetArray(a->GetName()) : nullptr;
    if (b && a->GetNumberOfComponents() == 1 && b->GetNumberOfComponents() == 1)
    {
      own << a->GetName() << '\n';
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
  if (names.empty())
  {
    throw std::invalid_argument("Cell requires an array of the input's names, got none.");
  }
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

// A sum that is the same in whatever order and on however many ranks it is taken, of numbers of
// magnitude below 8
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
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), port == 1);
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
  vtkImageData* pack = vtkImageData::GetData(inputs[0]);
  const int cells = inputs[1]->GetNumberOfInformationObjects();
  for (int n = 0; n < cells; ++n)
  {
    if ((vtkImageData::GetData(inputs[1], n) != nullptr) != (pack != nullptr))
    {
      throw std::invalid_argument(ruc::Text("Cell requires the kind of data of the input, ",
        pack ? "an image" : "a table", ", got ", pack ? "a table." : "an image."));
    }
  }
  if (!pack)
  {
    this->CompareTables(inputs, outputs, ranks);
    return;
  }
  if (cells != 1)
  {
    throw std::invalid_argument(ruc::Text("Cell requires one image, got ", cells, "."));
  }
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
    Rows rows;
    FillRows(pack, mean, rows);
    rows.Fill(vtkTable::GetData(outputs, COMPARISON), cells.size() > 1);
    FillCurves(pack, mean, cells.size() > 1, vtkTable::GetData(outputs, CURVES));
  }
  PackData::AddField(vtkTable::GetData(outputs, COMPARISON), "DifferencePercent",
    std::vector<double>{ ruc::CompareProbabilities(pack, mean.Mean).Percent });
  PackData::AddField(vtkTable::GetData(outputs, COMPARISON), "NumberOfCells",
    std::vector<long long>{ static_cast<long long>(cells.size()) });
}

void vtkRUCCompareProbabilities::CompareImages(vtkImageData* pack, vtkImageData* cell,
  vtkInformationVector* outputs, RankCommunicator& ranks) const
{
  int extent[6], other[6];
  pack->GetExtent(extent);
  cell->GetExtent(other);
  std::string error;
  if (!std::equal(extent, extent + 6, other))
  {
    error = "Cell requires an image of the input's size; set the same NumberOfLags and, for S_rsq, "
            "NumberOfDirections for both.";
  }
  for (int q = 0; q < 3 && error.empty(); ++q)
  {
    const double a = pack->GetSpacing()[q], b = cell->GetSpacing()[q];
    if (!(std::abs(a - b) <= 1e-6 * std::abs(a)))
    {
      error = ruc::Text("Cell requires an image with the spacing of the input, ", a, ", got ", b,
        "; set the same MaximumLag for both.");
    }
  }
  ranks.ThrowIfAny(error);

  vtkImageData* image = vtkImageData::GetData(outputs, DIFFERENCES);
  image->CopyStructure(pack);
  // Points on the border of two slabs belong to the upper one
  const int* whole = outputs->GetInformationObject(DIFFERENCES)
                       ->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
  const auto isOwn = [&](int i, int j, int k)
  {
    return (i < extent[1] || i == whole[1]) && (j < extent[3] || j == whole[3]) &&
      (k < extent[5] || k == whole[5]);
  };
  Rows rows;
  double sums[3] = { 0.0, 0.0, 0.0 }, largestOfAll = 0.0;
  for (const std::string& name : CommonArrays(pack, cell, ranks))
  {
    vtkDataArray* a = pack->GetPointData()->GetArray(name.c_str());
    vtkDataArray* b = cell->GetPointData()->GetArray(name.c_str());
    const bool isError = IsError(name);
    const int exponent = FindExponent(a, b, ranks);
    OrderlessSum norms[3];
    double largest = 0.0;
    vtkIdType place = 0;
    ImageSlab::AddArray(image, name,
      [&](int i, int j, int k)
      {
        const double x = a->GetTuple1(place), y = b->GetTuple1(place++);
        const double difference = isError ? std::hypot(x, y) : std::abs(x - y);
        if (!isError && std::isfinite(difference) && isOwn(i, j, k))
        {
          const double values[] = { x, y, difference };
          for (int m = 0; m < 3; ++m)
          {
            const double scaled = std::ldexp(values[m], -exponent);
            norms[m].Add(scaled * scaled);
          }
          largest = std::max(largest, difference);
        }
        return difference;
      });
    if (isError)
    {
      continue;
    }
    double negative = -largest;
    ranks.Minimum(&negative, 1);
    double norm[3];
    for (int m = 0; m < 3; ++m)
    {
      norm[m] = std::ldexp(std::sqrt(norms[m].Total(ranks)), exponent);
      sums[m] += norm[m];
    }
    rows.Add(name, norm[0], norm[1], norm[2], -negative, Percent(norm[2], norm[0], norm[1]), 0.0);
    largestOfAll = std::max(largestOfAll, -negative);
  }
  rows.Add("all", sums[0], sums[1], sums[2], largestOfAll, Percent(sums[2], sums[0], sums[1]), 0.0);
  if (ranks.Rank() == 0)
  {
    rows.Fill(vtkTable::GetData(outputs, COMPARISON), false);
  }
  PackData::AddField(vtkTable::GetData(outputs, COMPARISON), "DifferencePercent",
    std::vector<double>{ Percent(sums[2], sums[0], sums[1]) });
  outputs->GetInformationObject(DIFFERENCES)->Set(vtkDataObject::SPACING(), image->GetSpacing(), 3);
}
