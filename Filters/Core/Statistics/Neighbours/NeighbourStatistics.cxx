// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Neighbours/NeighbourStatistics.h"

#include "ruc/Base/FixedPoint.h"
#include "ruc/Base/Range.h"
#include "ruc/Base/Require.h"
#include "ruc/Base/Text.h"
#include "ruc/Particles/SphereOverlap.h"
#include "ruc/Statistics/Neighbours/NeighbourSearch.h"
#include "ruc/Statistics/Results/SpaceBlocks.h"

#include <algorithm>
#include <cmath>

namespace ruc
{
void CheckSettings(const NeighbourSettings& settings)
{
  Range::Above(0.0, 2.0).Check("MaximumGap", settings.MaximumGap);
  Range::From(0.0, settings.MaximumGap).Check("ContactTolerance", settings.ContactTolerance);
  Range::From(1, 10000).Check("NumberOfGaps", settings.Gaps);
  Range::From(2, 1000).Check("Blocks", settings.Blocks);
}

namespace
{
// What the means of a mode are made of: a mean is a sum over a number of spheres, or of contacts
enum Mean
{
  Contacts,
  NearestGap,
  LocalFraction,
  Faces,
  Q4,
  Q6,
  Rattlers,
  HeldContacts,
  Fabric, // and the five after it
  NumberOfMeans = Fabric + 6
};

// Sums that do not depend on the order of what is added, by block, mode and mean
class MeanSums
{
public:
  MeanSums(int blocks, int modes, const PackShare& share)
    : Blocks(blocks)
    , Modes(modes)
    , Longest(Length(share.Observed.GetBounds().Size) + 2.0 * share.LargestRadius)
    , Limbs(static_cast<std::size_t>(blocks) * modes * NumberOfMeans * 3, 0)
  {
  }

  void Add(int block, int mode, int mean, double value)
  {
    std::int64_t* sum = &this->Limbs[this->PlaceOf(block, mode, mean)];
    AddWide(RoundToFixedPoint(std::clamp(value / this->UnitOf(mean), -Most, Most) * Scale), sum);
    ++sum[2];
  }

  // The sums and the numbers of a mode, or of all, block by block
  ValueWithError Find(int mode, int mean) const
  {
    std::vector<double> sums(this->Blocks), norms(this->Blocks);
    for (int block = 0; block < this->Blocks; ++block)
    {
      std::int64_t all[3] = { 0, 0, 0 };
      for (int m = 0; m < this->Modes; ++m)
      {
        for (int n = 0; n < 3 && (m == mode || mode == this->Modes); ++n)
        {
          all[n] += this->Limbs[this->PlaceOf(block, m, mean) + n];
        }
      }
      sums[block] = WideValue(all) / Scale * this->UnitOf(mean);
      norms[block] = static_cast<double>(all[2]);
    }
    return JackknifeRatio(sums, norms);
  }

  void Share(Communicator& ranks) { ranks.Sum(this->Limbs.data(), this->Limbs.size()); }

  // How many values there are
  std::int64_t Number(int mode, int mean) const
  {
    std::int64_t number = 0;
    for (int block = 0; block < this->Blocks; ++block)
    {
      number += this->Limbs[this->PlaceOf(block, mode, mean) + 2];
    }
    return number;
  }

private:
  static constexpr double Most = 1024.0, Scale = 1099511627776.0; // 2^10 and 2^40

  std::size_t PlaceOf(int block, int mode, int mean) const
  {
    return ((static_cast<std::size_t>(block) * this->Modes + mode) * NumberOfMeans + mean) * 3;
  }
  double UnitOf(int mean) const { return mean == NearestGap ? this->Longest / Most : 1.0; }

  int Blocks, Modes;
  double Longest;
  std::vector<std::int64_t> Limbs; // of each the sum, in two limbs, and the number
};

void AddSpheres(const PackShare& share, const FoundNeighbours& found, const std::vector<int>& held,
  const SpaceBlocks& blocks, MeanSums& sums)
{
  for (std::size_t i = 0; i < found.Spheres.size(); ++i)
  {
    const NeighbourStatistics::Sphere& sphere = found.Spheres[i];
    if (!sphere.Counts)
    {
      continue;
    }
    const int block = blocks.Of(share.Own.Centre(i)), mode = share.Own.Mode[i] - 1;
    sums.Add(block, mode, Contacts, sphere.Contacts);
    sums.Add(block, mode, Rattlers, sphere.Rattler);
    if (!std::isnan(sphere.NearestGap))
    {
      sums.Add(block, mode, NearestGap, sphere.NearestGap);
    }
    if (!std::isnan(sphere.LocalFraction))
    {
      sums.Add(block, mode, LocalFraction, sphere.LocalFraction);
      sums.Add(block, mode, Faces, sphere.Faces);
      sums.Add(block, mode, Q4, sphere.Q4);
      sums.Add(block, mode, Q6, sphere.Q6);
    }
    if (!sphere.Rattler)
    {
      sums.Add(block, mode, HeldContacts, held[i]);
    }
  }
}

void AddFabric(
  const PackShare& share, const FoundNeighbours& found, const SpaceBlocks& blocks, MeanSums& sums)
{
  constexpr int axes[6][2] = { { 0, 0 }, { 1, 1 }, { 2, 2 }, { 1, 2 }, { 0, 2 }, { 0, 1 } };
  for (const KnownContact& contact : found.Contacts)
  {
    if (found.Spheres[contact.Sphere].Counts)
    {
      const Vector3& d = contact.Offset;
      const double d2 = Dot(d, d);
      const int block = blocks.Of(share.Own.Centre(contact.Sphere));
      for (int n = 0; n < 6; ++n)
      {
        sums.Add(block, share.Own.Mode[contact.Sphere] - 1, Fabric + n,
          d[axes[n][0]] * d[axes[n][1]] / d2);
      }
    }
  }
}

NeighbourStatistics::Means FindMeans(const MeanSums& sums, int mode)
{
  NeighbourStatistics::Means means;
  means.Contacts = sums.Find(mode, Contacts);
  means.NearestGap = sums.Find(mode, NearestGap);
  means.LocalFraction = sums.Find(mode, LocalFraction);
  means.Faces = sums.Find(mode, Faces);
  means.Q4 = sums.Find(mode, Q4);
  means.Q6 = sums.Find(mode, Q6);
  means.Rattlers = sums.Find(mode, Rattlers);
  means.HeldContacts = sums.Find(mode, HeldContacts);
  for (int n = 0; n < 6; ++n)
  {
    means.Fabric[n] = sums.Find(mode, Fabric + n);
  }
  return means;
}

// The modes [First, Last) that a row or column of the distributions stands for
struct ModesOf
{
  ModesOf(const GapCounts& layout, int n)
    : First(n < layout.Modes ? n : 0)
    , Last(n < layout.Modes ? n + 1 : layout.Modes)
  {
  }
  int First, Last;
};

// The mean number of neighbours of some modes around spheres of some modes, by gap
NeighbourStatistics::Distribution FindDistribution(const GapCounts& layout,
  const std::vector<std::int64_t>& counts, const std::vector<std::vector<double>>& spheres,
  const ModesOf& modes, const ModesOf& ofModes)
{
  std::vector<double> norms, sums(layout.Blocks, 0.0);
  for (const std::vector<double>& ofBlock : spheres)
  {
    norms.push_back(
      std::accumulate(ofBlock.begin() + modes.First, ofBlock.begin() + modes.Last, 0.0));
  }
  NeighbourStatistics::Distribution distribution;
  for (int k = 0; k <= layout.Steps; ++k)
  {
    for (int block = 0; block < layout.Blocks; ++block)
    {
      for (int r = modes.First; r < modes.Last; ++r)
      {
        for (int s = ofModes.First; s < ofModes.Last; ++s)
        {
          sums[block] += static_cast<double>(counts[layout.PlaceOf(block, r, s) + k]);
        }
      }
    }
    distribution.push_back(JackknifeRatio(sums, norms));
  }
  return distribution;
}

// The number of spheres that count, by block and mode
std::vector<std::vector<double>> CountSpheres(const PackShare& share, const FoundNeighbours& found,
  const SpaceBlocks& blocks, const GapCounts& layout, Communicator& ranks)
{
  std::vector<std::int64_t> counts(static_cast<std::size_t>(layout.Blocks) * layout.Modes, 0);
  for (std::size_t i = 0; i < found.Spheres.size(); ++i)
  {
    if (found.Spheres[i].Counts)
    {
      const int mode = layout.Modes > 1 ? share.Own.Mode[i] - 1 : 0;
      ++counts[static_cast<std::size_t>(blocks.Of(share.Own.Centre(i))) * layout.Modes + mode];
    }
  }
  ranks.Sum(counts.data(), counts.size());
  std::vector<std::vector<double>> spheres;
  for (int block = 0; block < layout.Blocks; ++block)
  {
    const auto begin = counts.begin() + static_cast<std::ptrdiff_t>(block) * layout.Modes;
    spheres.emplace_back(begin, begin + layout.Modes);
  }
  return spheres;
}

std::vector<NeighbourStatistics::Contact> TellContacts(
  const PackShare& share, const FoundNeighbours& found)
{
  std::vector<NeighbourStatistics::Contact> contacts;
  for (const KnownContact& contact : found.Contacts)
  {
    if (contact.Tells)
    {
      const Vector3 from = share.Own.Centre(contact.Sphere);
      const Vector3& d = contact.Offset;
      contacts.push_back({ from, { from[0] + d[0], from[1] + d[1], from[2] + d[2] }, contact.Gap,
        share.Own.Mode[contact.Sphere], contact.OtherMode });
    }
  }
  return contacts;
}
}

NeighbourStatistics MeasureNeighbours(const PackShare& share, const CountedCentres& centres,
  const NeighbourSettings& settings, Communicator& ranks,
  const std::function<void(double)>& progress)
{
  CheckSettings(settings);
  const SpaceBlocks blocks(centres.Region.GetBounds(), settings.Blocks);
  const GapCounts layout(blocks.Count(), share.NumberOfModes(), settings);
  FoundNeighbours found = FindNeighbours(share, centres, settings, blocks, layout, ranks, progress);
  NeighbourStatistics result;
  const std::vector<std::vector<double>> spheres =
    CountSpheres(share, found, blocks, layout, ranks);
  for (const std::vector<double>& ofBlock : spheres)
  {
    const auto number = std::accumulate(ofBlock.begin(), ofBlock.end(), 0.0);
    result.Counted += static_cast<std::int64_t>(number);
    result.Blocks += number > 0.0;
  }
  Require(result.Counted > 0, "Neighbour Statistics",
    Text("a sphere at least WindowMargin, ", centres.Margin, ", from every face of the window"),
    "none");

  const std::vector<int> held = FindRattlers(share, found, ranks);
  MeanSums sums(blocks.Count(), share.NumberOfModes(), share);
  AddSpheres(share, found, held, blocks, sums);
  AddFabric(share, found, blocks, sums);
  sums.Share(ranks);
  for (int mode = 0; mode <= share.NumberOfModes(); ++mode)
  {
    result.OfModes.push_back(FindMeans(sums, mode));
    const bool all = mode == share.NumberOfModes();
    result.OfModes.back().Counted = all ? result.Counted : sums.Number(mode, Contacts);
    result.Cells += all ? 0 : sums.Number(mode, LocalFraction);
  }
  const int modes = layout.Modes > 1 ? layout.Modes + 1 : 1;
  result.Neighbours.resize(modes);
  for (int r = 0; r < modes; ++r)
  {
    for (int s = 0; s < modes; ++s)
    {
      result.Neighbours[r].push_back(
        FindDistribution(layout, found.Counts, spheres, ModesOf(layout, r), ModesOf(layout, s)));
    }
  }
  for (int k = 0; k <= layout.Steps; ++k)
  {
    result.Gap.push_back(layout.GapAt(k));
  }
  result.Contacts = TellContacts(share, found);
  result.Spheres = std::move(found.Spheres);
  return result;
}

double NeighbourMargin(double largestRadius, double maximumGap)
{
  return 2.0 * largestRadius * std::max(1.5, 1.0 + maximumGap);
}

Estimate EstimateNeighbours(const PackFigures& pack, const NeighbourSettings& settings)
{
  constexpr double secondsPerCell = 3e-5, secondsPerNeighbour = 1e-8, bytesPerSphere = 400.0,
                   bytesPerContact = 80.0;
  CheckSettings(settings);
  const double modes = pack.Modes <= MostModesOfPairs ? pack.Modes : 1;
  const double reach = 2.0 * pack.LargestRadius * (1.0 + settings.MaximumGap);
  const double around = 2.0 * pack.PairsWithin(reach);
  // Some six a sphere, and more where neighbours that do not touch count as contacts, too
  const double contacts = 6.0 + 40.0 * settings.ContactTolerance;
  // Of every block, of all ranks and of a thread each
  const double counts = 3.0 * settings.Blocks * modes * modes * (settings.Gaps + 1.0);
  return { pack.Spheres * secondsPerCell + around * secondsPerNeighbour,
    8.0 * counts / BytesOfMegabyte,
    pack.Spheres * (bytesPerSphere + contacts * bytesPerContact) / BytesOfMegabyte };
}
}
