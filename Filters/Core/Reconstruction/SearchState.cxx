// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/SearchState.h"

#include <iterator>

namespace ruc
{
namespace
{
// In the order of the enumerations
constexpr const char* PhaseNames[] = { "removing overlap", "minimising F2", "annealing population",
  "fitting neighbours" };
constexpr const char* ReasonNames[] = { "", "Target objective", "Maximum iterations", "Converged",
  "Stopped", "Time limit", "Stop file", "Abort", "Stop button" };

static_assert(std::size(PhaseNames) == CountOf(SearchPhase()));
static_assert(std::size(ReasonNames) == CountOf(EndReason()));
}

const char* NameOf(SearchPhase phase)
{
  return PhaseNames[static_cast<int>(phase)];
}

const char* NameOf(EndReason reason)
{
  return ReasonNames[static_cast<int>(reason)];
}
}
