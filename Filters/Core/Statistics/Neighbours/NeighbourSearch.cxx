// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Neighbours/NeighbourSearch.h"

#include "ruc/Particles/PairNeighbourhood.h"
#include "ruc/Particles/SphereOverlap.h"
#include "ruc/Statistics/Neighbours/RadicalCell.h"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>

namespace ruc
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
// In a dense pack the cell of nearly every sphere is known at this reach, in units of the cube root
// of the volume that a sphere has, or of the largest diameter where spheres are sparse
constexpr double FirstReach = 2.2;
constexpr double Growth = 1.5;
constexpr std::size_t SpheresAtATime = 256;
}

GapCounts::GapCounts(int blocks, int modes, const NeighbourSettings& settings)
  : Blocks(blocks)
  , Modes(modes <= MostModesOfPairs ? modes : 1)
  , Steps(settings.Gaps)
  , Step(settings.MaximumGap / settings.Gaps)
{
}

void GapCounts::Add(
  int block, int mode, int ofMode, double gap, std::vector<std::int64_t>& counts) const
{
  if (!(gap <= this->GapAt(this->Steps)))
  {
    return;
  }
  int k = gap > 0.0 ? static_cast<int>(std::ceil(gap / this->Step)) : 0;
  // The quotient is rounded
  k = k > 0 && gap <= this->GapAt(k - 1) ? k - 1 : k;
  k = std::min(gap > this->GapAt(k) ? k + 1 : k, this->Steps);
  const bool byMode = this->Modes > 1;
  ++counts[this->PlaceOf(block, byMode ? mode - 1 : 0, byMode ? ofMode - 1 : 0) + k];
}

namespace
{
// The search around the spheres of a share, which looks farther as long as cells are not known
class Search
{
public:
  Search(const PackShare& share, const CountedCentres& centres, const NeighbourSettings& settings,
    const SpaceBlocks& blocks, const GapCounts& layout)
    : Share(share)
    , Centres(centres)
    , Settings(settings)
    , Blocks(blocks)
    , Layout(layout)
    , Spacing(
        std::min(std::cbrt(share.Observed.Volume() / static_cast<double>(share.NumberOfSpheres)),
          2.0 * share.LargestRadius))
    , Pending(share.Own.Size(), true)
  {
    const Vector3& size = share.Observed.GetBounds().Size;
    const double all = Length(size) + 2.0 * share.LargestRadius;
    this->LongestReach = share.Observed.IsFullyPeriodic() ? Infinity : all;
    this->Found.Spheres.resize(
      share.Own.Size(), { 0, false, false, NotANumber, NotANumber, NotANumber, NotANumber, 0 });
    this->Found.Counts.assign(layout.Size(), 0);
    for (std::size_t i = 0; i < share.Own.Size(); ++i)
    {
      this->Found.Spheres[i].Counts = centres.Region.Contains(share.Own.Centre(i));
    }
  }

  FoundNeighbours Run(Communicator& ranks, const std::function<void(double)>& progress)
  {
    const double contacts = 2.0 * this->Share.LargestRadius * (1.0 + this->Settings.MaximumGap);
    this->Reach = std::max(1.001 * contacts, FirstReach * this->Spacing);
    for (bool first = true; first || !this->IsDone(ranks); first = false)
    {
      const Surroundings around(this->Share, this->Reach, ranks);
      this->LookAround(around, first, first ? progress : std::function<void(double)>());
      this->Reach *= Growth;
    }
    ranks.Sum(this->Found.Counts.data(), this->Found.Counts.size());
    return std::move(this->Found);
  }

private:
  // Room to work in, of one thread
  struct Workspace
  {
    RadicalCellFinder Cells;
    std::vector<SphereAround> Around;
    std::vector<std::int64_t> Counts;
  };
  // A contact that may be with a sphere of another rank, whose centre is still to be given a place
  struct Met
  {
    KnownContact Contact;
    Vector3 Other;
  };

  bool IsDone(Communicator& ranks) const
  {
    return ranks.All(std::none_of(
      this->Pending.begin(), this->Pending.end(), [](char pending) { return pending != 0; }));
  }

  void LookAround(
    const Surroundings& around, bool first, const std::function<void(double)>& progress)
  {
    const std::int64_t blocks = (around.Size() + SpheresAtATime - 1) / SpheresAtATime;
    std::vector<std::vector<Met>> met(first ? blocks : 0);
#pragma omp parallel
    {
      Workspace own = { RadicalCellFinder(this->Spacing, this->Share.LargestRadius), {},
        std::vector<std::int64_t>(first ? this->Layout.Size() : 0, 0) };
#pragma omp for schedule(dynamic) nowait
      for (std::int64_t b = 0; b < blocks; ++b)
      {
        const std::size_t begin = b * SpheresAtATime;
        const std::size_t end = std::min(begin + SpheresAtATime, around.Size());
        for (std::size_t i = begin; i < end; ++i)
        {
          if (this->Pending[around.PlaceOf(i)])
          {
            this->LookAroundSphere(around, i, own, first ? &met[b] : nullptr);
          }
        }
        if (progress && omp_get_thread_num() == 0)
        {
          progress(double(b) / blocks);
        }
      }
      if (first)
      {
#pragma omp critical
        std::transform(own.Counts.begin(), own.Counts.end(), this->Found.Counts.begin(),
          this->Found.Counts.begin(), std::plus<>());
      }
    }
    this->Keep(met);
  }

  void LookAroundSphere(
    const Surroundings& around, std::size_t i, Workspace& own, std::vector<Met>* met)
  {
    const std::size_t place = around.PlaceOf(i);
    const SpherePack& pack = this->Share.Own;
    const double radius = pack.Radius[place];
    NeighbourStatistics::Sphere& sphere = this->Found.Spheres[place];
    const int block = this->Blocks.Of(pack.Centre(place));
    double nearest = Infinity;
    own.Around.clear();
    around.ForEachAround(i,
      [&](const PairNeighbourhood::Part& part, std::size_t j, double dx, double dy, double dz,
        double d2)
      {
        const double contact = radius + part.Pack.Radius[j], distance = std::sqrt(d2);
        own.Around.push_back({ { dx, dy, dz }, d2, part.Pack.Radius[j] });
        nearest = std::min(nearest, distance - contact);
        const double gap = distance / contact - 1.0;
        if (met && gap <= this->Settings.MaximumGap)
        {
          if (sphere.Counts)
          {
            this->Layout.Add(block, pack.Mode[place], part.Pack.Mode[j], gap, own.Counts);
          }
          if (gap <= this->Settings.ContactTolerance)
          {
            ++sphere.Contacts;
            met->push_back(this->MakeContact(around, place, part, j, { dx, dy, dz }, gap));
          }
        }
      });
    this->Pending[place] = sphere.Counts && !this->SetCell(place, nearest, own);
  }

  // Sets what is known of the cell and the nearest surface, and returns whether that is all
  bool SetCell(std::size_t place, double nearest, Workspace& own)
  {
    const double radius = this->Share.Own.Radius[place];
    NeighbourStatistics::Sphere& sphere = this->Found.Spheres[place];
    const auto key = [](const SphereAround& s)
    { return std::tie(s.SquaredDistance, s.Offset, s.Radius); };
    std::sort(own.Around.begin(), own.Around.end(),
      [&](const SphereAround& a, const SphereAround& b) { return key(a) < key(b); });
    const RadicalCell cell = own.Cells.Find(radius, this->Reach, own.Around);
    const double depth = this->Centres.WithinMask
      ? this->Centres.Margin
      : this->Share.Observed.DepthOf(this->Share.Own.Centre(place));
    const double seen = std::min(this->Reach, depth);
    if (cell.NeededReach <= seen && cell.Volume > 0.0)
    {
      sphere.LocalFraction = SphereVolume(radius) / cell.Volume;
      sphere.Q4 = cell.Q4;
      sphere.Q6 = cell.Q6;
      sphere.Faces = cell.Faces;
    }
    if (nearest < Infinity)
    {
      sphere.NearestGap = nearest;
    }
    const bool all = this->Reach >= this->LongestReach;
    return (cell.NeededReach <= this->Reach || this->Reach >= depth || all) &&
      (nearest <= this->Reach - radius - this->Share.LargestRadius || all);
  }

  Met MakeContact(const Surroundings& around, std::size_t place,
    const PairNeighbourhood::Part& part, std::size_t j, const Vector3& offset, double gap) const
  {
    const Vector3 centre = this->Share.Own.Centre(place), other = part.Pack.Centre(j);
    const bool tells = centre == other ? offset > Vector3{ 0.0, 0.0, 0.0 } : centre < other;
    const std::int64_t own = around.IsOwn(part) ? static_cast<std::int64_t>(j) : -1;
    return { { static_cast<std::uint32_t>(place), own, offset, gap, part.Pack.Mode[j], tells },
      other };
  }

  // Gives the centres that are no own ones a place
  void Keep(const std::vector<std::vector<Met>>& met)
  {
    std::map<Vector3, std::int64_t> foreign;
    for (const std::vector<Met>& ofBlock : met)
    {
      for (const Met& one : ofBlock)
      {
        this->Found.Contacts.push_back(one.Contact);
        if (one.Contact.Other < 0)
        {
          const auto [entry, isNew] =
            foreign.try_emplace(one.Other, static_cast<std::int64_t>(this->Found.Foreign.size()));
          if (isNew)
          {
            this->Found.Foreign.push_back(one.Other);
          }
          this->Found.Contacts.back().Other = -1 - entry->second;
        }
      }
    }
  }

  const PackShare& Share;
  const CountedCentres& Centres;
  const NeighbourSettings& Settings;
  const SpaceBlocks& Blocks;
  const GapCounts& Layout;
  double Spacing, Reach = 0.0, LongestReach;
  std::vector<char> Pending; // by place in the share: whether a farther reach may tell more
  FoundNeighbours Found;
};
}

FoundNeighbours FindNeighbours(const PackShare& share, const CountedCentres& centres,
  const NeighbourSettings& settings, const SpaceBlocks& blocks, const GapCounts& layout,
  Communicator& ranks, const std::function<void(double)>& progress)
{
  return Search(share, centres, settings, blocks, layout).Run(ranks, progress);
}

namespace
{
// The spheres of the share that each foreign centre touches
std::vector<std::vector<std::size_t>> TouchedByForeign(const FoundNeighbours& found)
{
  std::vector<std::vector<std::size_t>> touched(found.Foreign.size());
  for (const KnownContact& contact : found.Contacts)
  {
    if (contact.Other < 0)
    {
      touched[-1 - contact.Other].push_back(contact.Sphere);
    }
  }
  return touched;
}

// The contacts of every sphere of the share with others of the share
std::vector<std::vector<std::size_t>> TouchedByOwn(const FoundNeighbours& found)
{
  std::vector<std::vector<std::size_t>> touched(found.Spheres.size());
  for (const KnownContact& contact : found.Contacts)
  {
    if (contact.Other >= 0)
    {
      touched[contact.Sphere].push_back(static_cast<std::size_t>(contact.Other));
    }
  }
  return touched;
}
}

std::vector<int> FindRattlers(const PackShare& share, FoundNeighbours& found, Communicator& ranks)
{
  constexpr int leastContacts = 4;
  const std::vector<std::vector<std::size_t>> byForeign = TouchedByForeign(found);
  const std::vector<std::vector<std::size_t>> byOwn = TouchedByOwn(found);
  std::map<Vector3, std::size_t> foreign;
  for (std::size_t n = 0; n < found.Foreign.size(); ++n)
  {
    foreign[found.Foreign[n]] = n;
  }
  std::vector<int> held;
  std::vector<std::size_t> next;
  const auto check = [&](std::size_t i)
  {
    NeighbourStatistics::Sphere& sphere = found.Spheres[i];
    if (sphere.Counts && !sphere.Rattler && held[i] < leastContacts)
    {
      sphere.Rattler = true;
      next.push_back(i);
    }
  };
  for (const NeighbourStatistics::Sphere& sphere : found.Spheres)
  {
    held.push_back(sphere.Contacts);
  }
  for (std::size_t i = 0; i < held.size(); ++i)
  {
    check(i);
  }
  // No sphere is a rattler because of the order in which they are found
  while (!ranks.All(next.empty()))
  {
    std::vector<Vector3> told;
    for (std::size_t n = 0; n < next.size(); ++n)
    {
      const std::size_t i = next[n];
      told.push_back(share.Own.Centre(i));
      for (const std::size_t touched : byOwn[i])
      {
        --held[touched];
        check(touched);
      }
    }
    next.clear();
    for (const Vector3& centre : ranks.Concatenate(told))
    {
      const auto place = foreign.find(centre);
      if (place != foreign.end())
      {
        for (const std::size_t touched : byForeign[place->second])
        {
          --held[touched];
          check(touched);
        }
      }
    }
  }
  return held;
}
}
