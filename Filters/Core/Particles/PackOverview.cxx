// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Particles/PackOverview.h"

#include "ruc/Base/Text.h"

#include <algorithm>

namespace ruc
{
namespace
{
constexpr double SmallExtent = 0.1;
constexpr std::size_t LeastForExtent = 3;
constexpr double LeastFraction = 1e-4;

std::string ThreeEdges(const Vector3& edges)
{
  return Text(edges[0], " x ", edges[1], " x ", edges[2]);
}

struct Bounds
{
  Vector3 Lower, Extent;

  explicit Bounds(const SpherePack& pack)
  {
    const std::vector<double>* axes[3] = { &pack.X, &pack.Y, &pack.Z };
    for (int q = 0; q < 3; ++q)
    {
      const auto [least, greatest] = std::minmax_element(axes[q]->begin(), axes[q]->end());
      this->Lower[q] = *least;
      this->Extent[q] = *greatest - *least;
    }
  }
  double Volume() const { return this->Extent[0] * this->Extent[1] * this->Extent[2]; }
  bool IsSmallIn(const Window& window) const
  {
    const Vector3 edges = window.GetBounds().Size;
    bool small = true;
    for (int q = 0; q < 3; ++q)
    {
      small = small && this->Extent[q] <= SmallExtent * edges[q];
    }
    return small;
  }
};

double VolumeOf(const SpherePack& pack)
{
  double volume = 0.0;
  for (double radius : pack.Radius)
  {
    volume += 4.0 / 3.0 * Pi * (radius * radius * radius);
  }
  return volume;
}
}

PackOverview::PackOverview(const SpherePack& pack, const std::optional<Window>& window,
  const std::string& source, const std::string& unit)
{
  const Bounds bounds(pack);
  const auto [least, greatest] = std::minmax_element(pack.Radius.begin(), pack.Radius.end());
  const std::string inUnit = unit.empty() ? "" : " " + unit;
  const std::string in = window ? "the window" : "the bounds of the centres";
  const double volume = window ? window->Volume() : bounds.Volume();
  const double fraction = volume > 0.0 ? VolumeOf(pack) / volume : 1.0; // not known: not small
  this->Text = ruc::Text(pack.Size(), pack.Size() == 1 ? " sphere" : " spheres", " of diameter ",
    2.0 * *least, " to ", 2.0 * *greatest, inUnit, ", centres over ", ThreeEdges(bounds.Extent),
    inUnit, " from (", bounds.Lower[0], ", ", bounds.Lower[1], ", ", bounds.Lower[2], "), ",
    window ? window->Describe() + " by " + source : "no window given",
    volume > 0.0 ? ruc::Text(", fraction ", fraction, " of ", in) : "", ".");

  const char* units = "; are they in one unit? Scale multiplies centres and radii.";
  if (window && pack.Size() >= LeastForExtent && bounds.IsSmallIn(*window))
  {
    this->Warnings.push_back(ruc::Text("the centres extend over ", ThreeEdges(bounds.Extent),
      ", a tenth or less of the ", window->Describe(), units));
  }
  else if (fraction < LeastFraction)
  {
    this->Warnings.push_back(ruc::Text("the spheres, of radius ", *least, " to ", *greatest,
      ", take no more than the fraction ", fraction, " of ", in, ", ",
      window ? window->Describe() : ThreeEdges(bounds.Extent), units));
  }
  else if (window && fraction >= 1.0)
  {
    this->Warnings.push_back(ruc::Text("the volumes of the spheres add up to ", fraction,
      " of the ", window->Describe(), "; if the radii are diameters, set RadiusIsDiameter."));
  }
  if (*least == 0.0)
  {
    this->Warnings.push_back(
      ruc::Text(std::count(pack.Radius.begin(), pack.Radius.end(), 0.0), " of ", pack.Size(),
        " radii are 0; MinimumDiameter of Particle Modes leaves such points out."));
  }
}
}
