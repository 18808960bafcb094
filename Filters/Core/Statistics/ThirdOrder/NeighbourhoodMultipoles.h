// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Base/Estimate.h"
#include "ruc/Particles/PackFigures.h"
#include "ruc/Particles/PackShare.h"
#include "ruc/Statistics/ThirdOrder/ShellMultipoles.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <tuple>
#include <vector>

namespace ruc
{
/** How NeighbourhoodMultipoles are measured. */
struct NeighbourhoodSettings
{
  /**
   * The distances of the shells from the surface of the sphere around whose centre they lie,
   * ascending, > 0, at most 32 of them. None stand for AutomaticShells.
   */
  std::vector<double> Distances;
  int Degree = 8;  // from 0 to HighestOfShells of ShellMultipoles.h
  int Classes = 1; // from 1 to 4, see FindClasses
  int Blocks = 32; // about the number of blocks for the standard errors, from 2 to 1000
  const char* Name = "Multipoles";  // what requires what, where a pack is refused
  const char* Prefix = "Multipole"; // of the names of the first three
  int LeastCentres = 1;             // of every class
  bool NeedsScatter = false;        // whether a class without standard errors is refused
};

/** Twelve shells from 0.04 to 1.44 mean diameters, the denser the closer. */
std::vector<double> AutomaticShells(double meanDiameter);

/**
 * Returns the class of each mode, from 0, if modes are put into at most so many classes of about
 * equal volume, the smallest spheres first. Every class has a mode.
 */
std::vector<int> FindClasses(
  const std::vector<double>& diameters, const std::vector<double>& volumes, int classes);

/**
 * The three-point functions of a pack around its centres: T_r;sq,l(n1, n2) is the mean over the
 * spheres of class r of T_sq,l(n1, n2) of ShellMultipoles.h. So the sum over l of T_l P_l(cos
 * theta) is the probability that two points at the distances n1 and n2 from the surface of a sphere
 * of class r, and at the angle theta around its centre, lie in the classes s and q. The sphere
 * itself does not count.
 *
 * In a window the centres are those as far from every face as a sphere of the largest radius and
 * the last shell around another one reach.
 */
struct NeighbourhoodMultipoles
{
  ShellSettings Shells;
  std::vector<int> ClassOfMode;
  std::vector<std::int64_t> Centres; // of each class
  /** T and its standard errors, which are NaN with fewer than two blocks, at PlaceOf. */
  std::vector<double> Value, Error;

  /** The place of T; s <= q, as T_r;qs(n2, n1) is T_r;sq(n1, n2). */
  std::size_t PlaceOf(int r, int s, int q, int l, int n1, int n2) const
  {
    return r * this->Shells.NumberOfProducts() + this->Shells.PlaceOf(s, q, l, n1, n2);
  }

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Shells, self.ClassOfMode, self.Centres, self.Value, self.Error);
  }
};

/**
 * Measures a pack. The result is equal, bit by bit, on every rank and for any number of ranks and
 * threads. `progress` is told the share that is done, on the calling thread. Collective.
 *
 * Throws std::invalid_argument, the same on every rank, for settings out of range, spheres that
 * overlap by more than 0.01 % of their volume, and a window without LeastCentres of every class
 * inside.
 */
NeighbourhoodMultipoles MeasureNeighbourhoods(const PackShare& share,
  const NeighbourhoodSettings& settings, Communicator& ranks,
  const std::function<void(double)>& progress = {});

/** What MeasureNeighbourhoods takes. */
Estimate EstimateNeighbourhoods(const PackFigures& pack, const NeighbourhoodSettings& settings);
}
