// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Particles/SizeClasses.h"

#include <algorithm>
#include <cmath>

namespace ruc
{
namespace
{
// Spheres smaller than 2^-24 of the largest are points beside it and need no finer classes
constexpr int MostOctaves = 24;

// The octaves [First, Last) of radius, counted from the largest down, and how many spheres they
// hold
struct Span
{
  int First, Last;
  double Spheres;
};

// A number proportional to the pairs that a search would look at, for spheres spread evenly
double PairsOf(const std::vector<Span>& classes, double distance, double largest)
{
  double pairs = 0.0;
  for (std::size_t c = 0; c < classes.size(); ++c)
  {
    for (std::size_t d = c; d < classes.size(); ++d)
    {
      const double reach =
        distance + std::ldexp(largest, -classes[c].First) + std::ldexp(largest, -classes[d].First);
      pairs +=
        (c == d ? 0.5 : 1.0) * classes[c].Spheres * classes[d].Spheres * reach * reach * reach;
    }
  }
  return pairs;
}

std::vector<Span> Merged(std::vector<Span> classes, std::size_t c)
{
  classes[c].Last = classes[c + 1].Last;
  classes[c].Spheres += classes[c + 1].Spheres;
  classes.erase(classes.begin() + c + 1);
  return classes;
}
}

SizeClasses::SizeClasses(double reach)
  : Distance(reach)
  , Largest(1, 0.0)
{
}

SizeClasses::SizeClasses(
  const std::vector<double>& radii, double distance, double factor, Communicator& ranks)
  : Distance(distance)
{
  double largest = 0.0;
  for (double radius : radii)
  {
    largest = std::max(largest, radius);
  }
  largest = -largest;
  ranks.Minimum(&largest, 1);
  this->LargestRadius = -largest;
  this->ClassOfOctave.assign(MostOctaves, 0);
  std::vector<std::int64_t> spheres(MostOctaves, 0);
  for (double radius : radii)
  {
    ++spheres[std::min(std::ilogb(this->LargestRadius / radius), MostOctaves - 1)];
  }
  ranks.Sum(spheres.data(), spheres.size());

  std::vector<Span> classes;
  for (int octave = 0; octave < MostOctaves; ++octave)
  {
    if (spheres[octave] > 0)
    {
      classes.push_back({ octave, octave + 1, static_cast<double>(spheres[octave]) });
    }
  }
  // The cheapest merger comes first, as long as it costs little
  constexpr double worth = 1.25;
  const double scaled = factor * this->LargestRadius;
  while (classes.size() > 1)
  {
    std::size_t best = 0;
    double least = 0.0;
    for (std::size_t c = 0; c + 1 < classes.size(); ++c)
    {
      const double pairs = PairsOf(Merged(classes, c), distance, scaled);
      if (c == 0 || pairs < least)
      {
        best = c;
        least = pairs;
      }
    }
    if (least > worth * PairsOf(classes, distance, scaled))
    {
      break;
    }
    classes = Merged(classes, best);
  }

  for (const Span& span : classes)
  {
    // Octaves without spheres go with the larger ones before them
    std::fill(this->ClassOfOctave.begin() + (this->Largest.empty() ? 0 : span.First),
      this->ClassOfOctave.end(), this->Count());
    this->Largest.push_back(std::ldexp(scaled, -span.First));
  }
  if (classes.empty())
  {
    this->Largest.push_back(0.0);
  }
}

namespace
{
Communicator& Serial()
{
  static Communicator serial;
  return serial;
}
}

SizeClasses::SizeClasses(const std::vector<double>& radii, double distance, double factor)
  : SizeClasses(radii, distance, factor, Serial())
{
}

int SizeClasses::ClassOf(double radius) const
{
  return this->Count() == 1 ? 0
                            : this->ClassOfOctave[std::min(std::ilogb(this->LargestRadius / radius),
                                static_cast<int>(this->ClassOfOctave.size()) - 1)];
}
}
