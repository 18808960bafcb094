// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ProbabilityTable.h"

#include "PackData.h"
#include "RankCommunicator.h"
#include "ruc/Base/Text.h"

#include "vtkDataArray.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <unordered_map>
#include <vector>

namespace
{
// The number of modes that names such as S_2_7 tell; 0 where there are none
int FindModes(vtkTable* table)
{
  int modes = 0;
  for (vtkIdType c = 0; c < table->GetNumberOfColumns(); ++c)
  {
    std::istringstream name(table->GetColumnName(c) ? table->GetColumnName(c) : "");
    char s = 0, bar1 = 0, bar2 = 0;
    int r = 0, q = 0;
    if (name >> s >> bar1 >> r >> bar2 && s == 'S' && bar1 == '_' && bar2 == '_')
    {
      modes = std::max(modes, r);
      modes = name >> q ? std::max(modes, q) : modes;
    }
  }
  return modes;
}

// Throws std::invalid_argument where the table, on the rank that has it, is not what is required
ruc::TwoPointProbability ReadLocal(vtkTable* table, const std::string& what)
{
  // A table looks through all its columns for a name, which takes long where there are many
  std::unordered_map<std::string, vtkDataArray*> columns;
  for (vtkIdType c = 0; c < table->GetNumberOfColumns(); ++c)
  {
    const char* name = table->GetColumnName(c);
    columns.emplace(name ? name : "", vtkDataArray::SafeDownCast(table->GetColumn(c)));
  }
  const auto column = [&](const std::string& name, const std::string& other)
  {
    vtkDataArray* array = columns[name] ? columns[name] : columns[other];
    if (!array || array->GetNumberOfComponents() != 1)
    {
      throw std::invalid_argument(ruc::Text(
        what, " requires the columns r, S_1_1, S_1_2, … S_m_m of numbers, got none '", name, "'."));
    }
    if (array->GetNumberOfTuples() != table->GetNumberOfRows())
    {
      throw std::invalid_argument(
        ruc::Text(what, " requires a number in each of ", table->GetNumberOfRows(),
          " rows of column ", name, ", got ", array->GetNumberOfTuples(), "."));
    }
    std::vector<double> values;
    for (vtkIdType row = 0; row < array->GetNumberOfTuples(); ++row)
    {
      values.push_back(array->GetTuple1(row));
      if (!std::isfinite(values.back()))
      {
        throw std::invalid_argument(ruc::Text(what, " requires finite numbers, got ", values.back(),
          " in column ", name, ", row ", row, "."));
      }
    }
    return values;
  };
  const std::vector<double> r = column("r", "r");
  const int modes = FindModes(table);
  if (modes < 1)
  {
    throw std::invalid_argument(
      ruc::Text(what, " requires the columns S_1_1, S_1_2, … S_m_m, got none of them."));
  }
  const double pairs = 0.5 * (modes + 1.0) * (modes + 2.0);
  if (pairs > table->GetNumberOfColumns())
  {
    throw std::invalid_argument(
      ruc::Text(what, " requires a column for each of the ", pairs, " unordered pairs of ", modes,
        " modes and the matrix, got ", table->GetNumberOfColumns(), " columns in all."));
  }
  if (r.size() < 2)
  {
    throw std::invalid_argument(
      ruc::Text(what, " requires at least two rows, of the lags 0 and on, got ", r.size(), "."));
  }
  const int count = static_cast<int>(r.size()) - 1;
  const double spacing = r.back() / count;
  // A lag of five digits, which ParaView writes, is within 5e-5 of the true one, and so is the last
  // lag, from which the step is made. Within half a step no lag stands for its neighbour.
  const double tolerance = std::min(2.0 * ProbabilityTable::Rounding * r.back(), 0.5 * spacing);
  for (int k = 0; k <= count; ++k)
  {
    if (!(spacing > 0.0 && std::abs(r[k] - k * spacing) <= tolerance))
    {
      throw std::invalid_argument(ruc::Text(what, " requires lags 0, dr, 2 dr, … in column r, got ",
        r[k], " in row ", k, ", where ", k * spacing, " is due."));
    }
  }
  ruc::TwoPointProbability probability(modes, { spacing, count });
  for (int a = 0; a <= modes; ++a)
  {
    for (int b = a; b <= modes; ++b)
    {
      probability.S(a, b) =
        column(PackData::PairName(probability, a, b), PackData::PairName(probability, b, a));
    }
    probability.Fractions[a] = probability.S(a, a)[0];
  }
  return probability;
}
}

ruc::TwoPointProbability ProbabilityTable::Read(
  vtkTable* table, const std::string& what, RankCommunicator& ranks)
{
  std::int64_t holders = table && table->GetNumberOfRows() > 0;
  const bool holds = holders > 0;
  ranks.Sum(&holders, 1);
  if (holders != 1)
  {
    throw std::invalid_argument(holders == 0
        ? ruc::Text(what, " requires a table with rows, got none.")
        : ruc::Text(what, " requires all rows on one rank, got them on ", holders, "."));
  }
  ruc::TwoPointProbability probability(1, { 1.0, 0 });
  ranks.Agree([&]() { probability = holds ? ReadLocal(table, what) : probability; });
  ranks.Broadcast(probability, ranks.LowestRank(holds));
  return probability;
}
