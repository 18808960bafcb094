// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Results/Phases.h"

#include "ruc/Base/Text.h"

#include <sstream>
#include <stdexcept>

namespace ruc
{
std::string PhaseName(int phase, int modes)
{
  return phase == modes ? "m" : std::to_string(phase + 1);
}

std::vector<std::vector<int>> ParsePhaseLists(
  const std::string& text, int modes, std::size_t length, const std::string& required)
{
  std::vector<std::vector<int>> lists;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ';');)
  {
    std::istringstream words(part);
    std::vector<int> phases;
    bool good = true;
    for (std::string word; words >> word;)
    {
      const bool digits = word.size() <= 6 && word.find_first_not_of("0123456789") == word.npos;
      const int phase = word == "m" ? modes : digits ? std::stoi(word) - 1 : -1;
      good = good && phase >= 0 && (word == "m" || phase < modes);
      phases.push_back(phase);
    }
    if (!good || phases.size() != length)
    {
      throw std::invalid_argument(Text(required, ", got '", part, "'."));
    }
    lists.push_back(std::move(phases));
  }
  return lists;
}
}
