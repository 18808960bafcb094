// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Sampling/FanLags.h"

#include <algorithm>
#include <cmath>

namespace ruc
{
namespace
{
// The first lag at or after a position on a ray, or one beyond the last lag
int FirstLag(double position, const LagGrid& lags)
{
  const double lag = std::ceil(position / lags.Spacing);
  return static_cast<int>(std::clamp(lag, 0.0, lags.Count + 1.0));
}

void EndList(TracedFan& fan)
{
  fan.Begin.push_back(static_cast<std::int32_t>(fan.Lags.size()));
}
}

FanLags::FanLags(const SamplingRegion& region, const RayDirections& rays, const LagGrid& lags,
  int modes, const std::vector<PhaseTriple>& triples)
  : Region(region)
  , Rays(rays)
  , Lags(lags)
  , Modes(modes)
  , ListOfPhase(modes + 1, -1)
{
  for (const PhaseTriple& triple : triples)
  {
    for (const int phase : { triple.S, triple.Q })
    {
      if (this->ListOfPhase[phase] < 0)
      {
        this->ListOfPhase[phase] = this->ListsOfPhases++;
      }
    }
  }
}

void FanLags::Find(TracedFan& fan, Scratch& scratch) const
{
  scratch.Hits.resize(this->Rays.Size());
  for (std::vector<SphereHit>& hits : scratch.Hits)
  {
    hits.clear();
  }
  for (const RayHit& hit : fan.Hits)
  {
    scratch.Hits[hit.Ray].push_back(hit.Sphere);
  }
  fan.Lags.clear();
  fan.Begin.assign(1, 0);
  for (int ray = 0; ray < this->Rays.Size(); ++ray)
  {
    scratch.Inside.assign(1, { 0.0, this->Length() });
    if (this->IsBounded())
    {
      this->Region.Clip(
        fan.Fan.Centre, this->Rays.Of(fan.Fan, ray), this->Length(), scratch.Inside);
    }
    FindPhaseChanges(scratch.Hits[ray], scratch.Inside, this->Modes, scratch.Changes);
    this->AddLagsOfPhases(scratch.Changes, fan);
    if (this->IsBounded())
    {
      for (const LineInterval& inside : scratch.Inside)
      {
        this->AddLags(inside.Begin, inside.End, fan);
      }
      EndList(fan);
    }
  }
}

void FanLags::AddLagsOfPhases(const std::vector<PhaseChange>& changes, TracedFan& fan) const
{
  for (int list = 0; list < this->ListsOfPhases; ++list)
  {
    for (std::size_t n = 0; n + 1 < changes.size(); ++n)
    {
      const int phase = changes[n].After;
      if (phase <= this->Modes && this->ListOfPhase[phase] == list)
      {
        this->AddLags(changes[n].Position, changes[n + 1].Position, fan);
      }
    }
    EndList(fan);
  }
  for (std::size_t n = 0; n + 1 < changes.size() && changes[n].Position <= 0.0; ++n)
  {
    fan.Phase = changes[n].After;
  }
}

void FanLags::AddLags(double begin, double end, TracedFan& fan) const
{
  const int first = FirstLag(begin, this->Lags), after = FirstLag(end, this->Lags);
  if (first < after)
  {
    fan.Lags.push_back(first);
    if (after <= this->Lags.Count)
    {
      fan.Lags.push_back(after);
    }
  }
}
}
