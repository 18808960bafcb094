// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Comparison/ReportCard.h"

#include "ruc/Base/Text.h"
#include "ruc/Statistics/Results/ProbabilityComparison.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace ruc
{
namespace
{
// The mean of values, and their standard deviation, which is NaN for one
ValueWithError Summarise(const std::vector<double>& values)
{
  const double count = static_cast<double>(values.size());
  double mean = 0.0, squares = 0.0;
  for (double value : values)
  {
    mean += value / count;
  }
  for (double value : values)
  {
    squares += (value - mean) * (value - mean);
  }
  return { mean,
    count > 1.0 ? std::sqrt(squares / (count - 1.0)) : std::numeric_limits<double>::quiet_NaN() };
}

const Descriptor* FindDescriptor(const PackDescriptors& of, const std::string& name)
{
  const auto found = std::find_if(
    of.Values.begin(), of.Values.end(), [&](const Descriptor& d) { return d.Name == name; });
  return found == of.Values.end() ? nullptr : &*found;
}

// The values of one descriptor, none where one of the packs has none
std::vector<double> ValuesOf(const std::vector<PackDescriptors>& all, const std::string& name)
{
  std::vector<double> values;
  for (const PackDescriptors& of : all)
  {
    if (const Descriptor* found = FindDescriptor(of, name))
    {
      values.push_back(found->Value.Value);
    }
  }
  return values.size() == all.size() ? values : std::vector<double>();
}

double ZOf(double difference, double packError, double deviation, int cells)
{
  const double own = std::isfinite(packError) ? packError : 0.0;
  const double others = std::isfinite(deviation) ? deviation / std::sqrt(double(cells)) : 0.0;
  return difference == 0.0 ? 0.0 : difference / std::hypot(own, others);
}

// The standard errors of the packs' mean S_rs, in the layout of Values
std::vector<std::vector<double>> ErrorsOf(
  const std::vector<PackDescriptors>& packs, const MeanProbability& mean)
{
  if (packs.size() == 1)
  {
    return packs.front().Errors->Values;
  }
  std::vector<std::vector<double>> errors = mean.Deviations;
  for (std::vector<double>& of : errors)
  {
    for (double& error : of)
    {
      error /= std::sqrt(double(packs.size()));
    }
  }
  return errors;
}

void AddFunctions(const std::vector<PackDescriptors>& packs,
  const std::vector<PackDescriptors>& cells, bool fitted, ReportCard& card)
{
  std::vector<TwoPointProbability> sums;
  sums.reserve(packs.size());
  for (const PackDescriptors& pack : packs)
  {
    sums.push_back(pack.Sums);
  }
  const MeanProbability mean = AverageProbabilities(sums);
  const TwoPointProbability& pack = mean.Mean;
  TwoPointErrors errors;
  errors.Values = ErrorsOf(packs, mean);
  card.Floor = ObjectiveFloor(pack, errors);
  const int m = pack.Modes;
  std::vector<double> all, matrix;
  for (const PackDescriptors& cell : cells)
  {
    all.push_back(TwoPointDifference(pack, cell.Sums));
    matrix.push_back(NormOfDifference(pack.S(m, m), cell.Sums.S(m, m)));
  }
  const auto add = [&](const char* name, const std::vector<double>& values, double error)
  {
    const auto [value, deviation] = Summarise(values);
    card.Rows.push_back({ name, DescriptorKind::TwoPoint, 0.0, error, value, deviation,
      ZOf(value, error, deviation, card.Cells), fitted });
  };
  add("S_rs", all, card.Floor);
  add("S_m_m", matrix, DiscreteNorm(errors.Values[pack.PairOf(m, m)]));
}

ReportRow MakeRow(const Descriptor& first, const std::vector<double>& ofPacks,
  const std::vector<double>& ofCells, double errorOfCell, bool fitted)
{
  const auto [pack, packDeviation] = Summarise(ofPacks);
  const auto [cell, deviation] = Summarise(ofCells);
  const double packError =
    ofPacks.size() > 1 ? packDeviation / std::sqrt(double(ofPacks.size())) : first.Value.Error;
  const double scatter = ofCells.size() > 1 ? deviation : errorOfCell;
  return { first.Name, first.Kind, pack, packError, cell, scatter,
    ZOf(cell - pack, packError, scatter, static_cast<int>(ofCells.size())), fitted };
}
}

ReportCard MakeReportCard(const std::vector<PackDescriptors>& packs,
  const std::vector<PackDescriptors>& cells, const std::vector<bool>& fitted)
{
  ReportCard card;
  card.Packs = static_cast<int>(packs.size());
  card.Cells = static_cast<int>(cells.size());
  bool functions = false;
  for (const Descriptor& first : packs.front().Values)
  {
    if (first.Kind != DescriptorKind::Fraction && !functions)
    {
      functions = true;
      AddFunctions(packs, cells, fitted[static_cast<int>(DescriptorKind::TwoPoint)], card);
    }
    const std::vector<double> ofPacks = ValuesOf(packs, first.Name);
    const std::vector<double> ofCells = ValuesOf(cells, first.Name);
    if (!ofPacks.empty() && !ofCells.empty())
    {
      const double errorOfCell = FindDescriptor(cells.front(), first.Name)->Value.Error;
      card.Rows.push_back(
        MakeRow(first, ofPacks, ofCells, errorOfCell, fitted[static_cast<int>(first.Kind)]));
    }
  }
  if (!functions)
  {
    AddFunctions(packs, cells, fitted[static_cast<int>(DescriptorKind::TwoPoint)], card);
  }
  // Where neither pack nor cells have an error, such as one of pores that are never so wide, none
  // is known
  card.Rows.erase(std::remove_if(card.Rows.begin(), card.Rows.end(),
                    [](const ReportRow& row) { return !std::isfinite(row.Z); }),
    card.Rows.end());
  return card;
}

int ReportCard::Within() const
{
  return static_cast<int>(std::count_if(this->Rows.begin(), this->Rows.end(),
    [](const ReportRow& row) { return std::abs(row.Z) <= MostZ; }));
}

double ReportCard::LargestZ() const
{
  double largest = 0.0;
  for (const ReportRow& row : this->Rows)
  {
    largest = std::max(largest, std::abs(row.Z));
  }
  return largest;
}

std::string ReportCard::Verdict() const
{
  std::string others;
  for (const ReportRow& row : this->Rows)
  {
    if (!(std::abs(row.Z) <= MostZ))
    {
      std::ostringstream z;
      z << std::showpos << std::fixed << std::setprecision(1) << row.Z;
      others += Text(others.empty() ? "; not in: " : ", ", row.Name, " (Z ", z.str(), ")");
    }
  }
  return Text("Representative within the pack's own error in ", this->Within(), " of ",
    this->Rows.size(), " descriptors", others, ".");
}
}
