// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Formats/TableRows.h"

#include "ruc/Base/Text.h"

#include <algorithm>

namespace ruc
{
namespace
{
// What stands behind the mark of a comment
bool IsComment(std::string_view line, std::string_view& comment)
{
  for (std::string_view mark : { "#", "%", "//" })
  {
    if (line.substr(0, mark.size()) == mark)
    {
      comment = TrimBlanks(line.substr(
        line.find_first_not_of("#%/") == line.npos ? line.size() : line.find_first_not_of("#%/")));
      return true;
    }
  }
  return false;
}

char FindSeparator(std::string_view line)
{
  Fields fields;
  for (char separator : { ';', '\t', ',' })
  {
    TableRows::Split(line, separator, fields);
    const bool mixed = separator == '\t' &&
      std::any_of(fields.begin(), fields.end(),
        [](std::string_view field)
        {
          const std::size_t blank = field.find(' ');
          return blank != field.npos && IsNumber(field.substr(0, blank));
        });
    if (fields.size() > 1 && !mixed)
    {
      return separator;
    }
  }
  return TableRows::Whitespace;
}
}

bool IsNumber(std::string_view field)
{
  double ignored;
  return ParseNumber(field, ignored);
}

void TableRows::Split(std::string_view line, char separator, Fields& fields)
{
  if (separator == Whitespace && line.find('"') == line.npos)
  {
    SplitBlanks(line, fields);
    return;
  }
  fields.clear();
  const auto separates = [separator](char c)
  { return separator == Whitespace ? c == ' ' || c == '\t' : c == separator; };
  bool quoted = false;
  for (std::size_t begin = 0, at = 0; at <= line.size(); ++at)
  {
    quoted = quoted != (at < line.size() && line[at] == '"');
    if (at < line.size() && (quoted || !separates(line[at])))
    {
      continue;
    }
    std::string_view field = TrimBlanks(line.substr(begin, at - begin));
    if (field.size() >= 2 && field.front() == '"' && field.back() == '"')
    {
      field = TrimBlanks(field.substr(1, field.size() - 2));
    }
    if (separator != Whitespace || at > begin)
    {
      fields.push_back(field);
    }
    begin = at + 1;
  }
}

void TableRows::RequireText(std::string_view line) const
{
  const std::size_t bad = FindBadByte(line);
  if (bad != line.npos)
  {
    const bool wide = line.substr(0, 2) == "\xFF\xFE" || line.substr(0, 2) == "\xFE\xFF";
    this->Lines.Fail(wide ? Text("UTF-8 text is required, got UTF-16: save the table as UTF-8.")
                          : Text("UTF-8 text is required, got the byte ",
                              static_cast<unsigned int>(static_cast<unsigned char>(line[bad])),
                              " at place ", bad + 1, ", as in Latin-1: save the table as UTF-8."));
  }
}

bool TableRows::Next(Fields& fields)
{
  std::string_view line, comment;
  while (this->Lines.Next(line))
  {
    if (this->Lines.Line() <= static_cast<std::size_t>(std::max(this->SkipLines, 0)))
    {
      continue;
    }
    if (this->Lines.Line() == 1 && line.substr(0, 3) == "\xEF\xBB\xBF")
    {
      line.remove_prefix(3);
    }
    this->RequireText(line);
    if (IsComment(TrimBlanks(line), comment))
    {
      if (this->Separator == 0 && this->Comments.size() < 1000)
      {
        this->Comments.emplace_back(comment);
      }
      continue;
    }
    if (this->Separator == 0 && Lower(line).rfind("sep=", 0) == 0 && line.size() == 5)
    {
      this->Separator = line[4];
      continue;
    }
    if (this->Separator == 0 && !TrimBlanks(line).empty())
    {
      this->Separator = FindSeparator(line);
    }
    line = line.substr(0, line.find(" #")); // a comment behind the numbers
    Split(this->Separator == '\t' ? line : TrimBlanks(line), this->Separator, fields);
    if (fields.size() == this->Count + 1 && this->Count > 0 && fields.back().empty())
    {
      fields.pop_back(); // a separator at the end of the line
    }
    if (std::any_of(
          fields.begin(), fields.end(), [](std::string_view field) { return !field.empty(); }))
    {
      return true;
    }
  }
  return false;
}
}
