// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Formats/SizeTable.h"

#include "ruc/Base/Text.h"
#include "ruc/Formats/SphereRows.h"
#include "ruc/Formats/TableColumns.h"
#include "ruc/Formats/TableRows.h"
#include "ruc/Window/Window.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ruc
{
namespace
{
constexpr std::string_view DecimalComma = "a decimal point";

bool HasDecimalComma(std::string_view field)
{
  return !IsNumber(field) && NumberFault(field).rfind(DecimalComma, 0) == 0;
}

class SizeReader
{
public:
  explicit SizeReader(ByteStream& bytes)
    : Rows(bytes)
  {
  }

  SizeTable Read()
  {
    bool more = this->Rows.Next(this->Row);
    if (more && this->IsHeader())
    {
      const std::vector<std::string> names(this->Row.begin(), this->Row.end());
      this->Scale = FindColumn(names, RowColumns::Radius) == 0 ? 2.0 : 1.0;
      more = this->Rows.Next(this->Row);
    }
    while (this->Row.size() > 1 && this->Row.back().empty()) // separators at the end of the line
    {
      this->Row.pop_back();
    }
    this->Columns = this->Row.size();
    this->Rows.SetCount(this->Columns);
    for (; more; more = this->Rows.Next(this->Row))
    {
      this->Append();
    }
    this->CheckEnd();
    return std::move(this->Table);
  }

private:
  bool IsHeader() const
  {
    return std::none_of(this->Row.begin(), this->Row.end(),
      [](std::string_view field) { return IsNumber(field) || HasDecimalComma(field); });
  }

  // A comma in numbers looks like one between columns, as in 1,5
  [[noreturn]] void Fail(const std::string& fault)
  {
    std::string line;
    for (std::string_view field : this->Row)
    {
      line += Text(line.empty() ? "" : ",", field);
    }
    Fields parts;
    SplitBlanks(line, parts);
    const auto comma = std::find_if(parts.begin(), parts.end(), HasDecimalComma);
    const bool separates = this->Rows.GetSeparator() == ',' && comma != parts.end();
    this->Rows.GetLines().Fail(separates
        ? Text(fault, " Where ", Quote(*comma), " is one number, a decimal point is required.")
        : fault);
  }

  double Number(std::size_t column)
  {
    double value;
    if (!ParseNumber(this->Row[column], value) || !std::isfinite(value))
    {
      this->Fail(Text("a size requires ", NumberFault(this->Row[column])));
    }
    return value;
  }

  void Append()
  {
    if (this->Row.size() != this->Columns || this->Columns > 2)
    {
      this->Fail(Text("one column with a diameter, or two with the opening of a sieve and the per "
                      "cent that passes it, are required, got ",
        this->Row.size(), " column(s)."));
    }
    const double length = this->Scale * this->Number(0);
    if (!(length >= LeastLength && length <= GreatestLength))
    {
      this->Fail(Text("a length above 0 is required, got ", length, "."));
    }
    if (this->Columns == 2)
    {
      this->AppendPassing(length, this->Number(1));
    }
    this->Table.Diameters.push_back(length);
  }

  void AppendPassing(double opening, double passing)
  {
    std::vector<double>& all = this->Table.Passing;
    if (all.empty() && passing != 0.0)
    {
      this->Fail(Text(
        "a sieve that nothing passes (0 %) is required first, the size of the smallest spheres, "
        "got ",
        passing, " %."));
    }
    if (!all.empty() && !(opening > this->Table.Diameters.back()))
    {
      this->Fail(Text("an opening above the last, ", this->Table.Diameters.back(),
        ", is required, got ", opening, "."));
    }
    if (!all.empty() && !(passing >= all.back() && passing <= 100.0))
    {
      this->Fail(Text(
        "a passing from the last, ", all.back(), " %, to 100 % is required, got ", passing, " %."));
    }
    all.push_back(passing);
  }

  void CheckEnd() const
  {
    if (this->Table.Diameters.empty())
    {
      throw std::invalid_argument("At least one line with a size is required, got none.");
    }
    if (this->Columns == 2 && this->Table.Passing.back() != 100.0)
    {
      throw std::invalid_argument(
        Text("A last sieve that 100 % pass is required, got ", this->Table.Passing.back(), " %."));
    }
  }

  TableRows Rows;
  Fields Row;
  std::size_t Columns = 0;
  double Scale = 1.0; // from lengths in the file to diameters
  SizeTable Table;
};
}

SizeTable ReadSizeTable(ByteStream& bytes)
{
  return SizeReader(bytes).Read();
}
}
