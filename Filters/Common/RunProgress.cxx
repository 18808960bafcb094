// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RunProgress.h"

#include <iomanip>
#include <locale>
#include <sstream>

namespace
{
const std::string MayBeStopped = "may be stopped]", RunsToItsEnd = "runs to its end]";
const std::string AfterFilter = ": ", BeforeState = " [", BeforeValue = " = ", AfterValue = ", ";
const std::string LostOnTheWay(4, ' ');

bool EndsWith(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}
}

std::string RunProgress::ToText() const
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << this->Filter << AfterFilter << this->Activity << BeforeState;
  if (!this->Quantity.empty())
  {
    text << this->Quantity << BeforeValue << std::setprecision(4) << this->Value << AfterValue;
  }
  text << (this->Stoppable ? MayBeStopped : RunsToItsEnd) << LostOnTheWay;
  return text.str();
}

std::optional<RunProgress> RunProgress::FromText(std::string text)
{
  text.erase(text.find_last_not_of(' ') + 1);
  const std::size_t colon = text.find(AfterFilter);
  const std::size_t bracket = text.rfind(BeforeState);
  const bool stoppable = EndsWith(text, MayBeStopped);
  if (colon == std::string::npos || bracket == std::string::npos ||
    bracket < colon + AfterFilter.size() || (!stoppable && !EndsWith(text, RunsToItsEnd)))
  {
    return {};
  }
  RunProgress progress;
  progress.Filter = text.substr(0, colon);
  progress.Activity = text.substr(colon + AfterFilter.size(), bracket - colon - AfterFilter.size());
  progress.Stoppable = stoppable;
  const std::size_t state = bracket + BeforeState.size();
  const std::size_t equals = text.find(BeforeValue, state);
  if (equals != std::string::npos)
  {
    std::istringstream value(text.substr(equals + BeforeValue.size()));
    value.imbue(std::locale::classic());
    if (value >> progress.Value)
    {
      progress.Quantity = text.substr(state, equals - state);
    }
  }
  return progress;
}
