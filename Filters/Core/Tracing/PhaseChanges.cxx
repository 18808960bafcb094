// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Tracing/PhaseChanges.h"

#include <algorithm>
#include <tuple>

namespace ruc
{
void FindPhaseChanges(std::vector<SphereHit>& hits, const std::vector<LineInterval>& inside,
  int modes, std::vector<PhaseChange>& changes)
{
  std::sort(hits.begin(), hits.end(),
    [](const SphereHit& a, const SphereHit& b)
    { return std::tie(a.In, a.Out, a.Mode) < std::tie(b.In, b.Out, b.Mode); });
  changes.clear();
  const int outside = modes + 1;
  std::vector<SphereHit> entered; // and not left
  auto next = hits.begin();
  for (const LineInterval& interval : inside)
  {
    int phase = outside;
    double t = interval.Begin;
    while (t < interval.End)
    {
      for (; next != hits.end() && next->In <= t; ++next)
      {
        entered.push_back(*next);
      }
      entered.erase(std::remove_if(entered.begin(), entered.end(),
                      [&](const SphereHit& hit) { return hit.Out <= t; }),
        entered.end());
      int lowest = modes;
      double until = next == hits.end() ? interval.End : std::min(interval.End, next->In);
      for (const SphereHit& hit : entered)
      {
        lowest = std::min(lowest, hit.Mode);
        until = std::min(until, hit.Out);
      }
      if (lowest != phase)
      {
        changes.push_back({ t, phase, lowest });
        phase = lowest;
      }
      t = until;
    }
    changes.push_back({ interval.End, phase, outside });
  }
}
}
