// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCCommonModule.h"
#include "ruc/Statistics/Results/ProbabilityComparison.h"

#include <string>
#include <vector>

class vtkTable;

/** The tables of vtkRUCCompareProbabilities, whose columns are documented there. */
namespace ComparisonTables RUCCOMMON_EXPORT
{
/** The rows of the table of the comparison. */
class Rows
{
public:
  void Add(const std::string& quantity, double pack, double cell, double difference, double largest,
    double percent, double deviation);
  void Fill(vtkTable* table, bool withDeviations) const;

private:
  std::vector<std::string> Quantity;
  std::vector<double> Numbers[6];
};

/** The difference in percent of the mean of both; 0 where both are 0. */
double Percent(double difference, double pack, double cell);

/**
 * Fill the outputs 0 and 1 of the filter, with the standard deviations over the cells where there
 * are `several`.
 */
void FillComparison(const ruc::TwoPointProbability& pack, const ruc::MeanProbability& cells,
  bool several, vtkTable* table);
void FillCurves(const ruc::TwoPointProbability& pack, const ruc::MeanProbability& cells,
  bool several, vtkTable* table);
}
