// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/**
 * @file
 * Lattices of spheres that touch, and how tests measure neighbours.
 */

#include "Oracles.h"
#include "ruc/Statistics/Neighbours/NeighbourStatistics.h"

namespace oracle
{
/** Copies of the places in an orthorhombic cell, as spheres of one size in a periodic box. */
inline PackInBox Lattice(const std::vector<ruc::Vector3>& places, const ruc::Vector3& cell,
  const std::array<int, 3>& copies, double radius)
{
  PackInBox made;
  for (int n = 0; n < copies[0] * copies[1] * copies[2]; ++n)
  {
    const int at[] = { n % copies[0], n / copies[0] % copies[1], n / copies[0] / copies[1] };
    for (const ruc::Vector3& place : places)
    {
      made.Pack.X.push_back((at[0] + place[0]) * cell[0]);
      made.Pack.Y.push_back((at[1] + place[1]) * cell[1]);
      made.Pack.Z.push_back((at[2] + place[2]) * cell[2]);
      made.Pack.Radius.push_back(radius);
      made.Pack.Mode.push_back(1);
    }
  }
  made.Box = ruc::Window::MakeBox({ 0, 0, 0 },
    { copies[0] * cell[0], copies[1] * cell[1], copies[2] * cell[2] }, { true, true, true });
  return made;
}

inline PackInBox SimpleCubic(int copies, double radius = 1.0)
{
  return Lattice({ { 0.25, 0.25, 0.25 } }, { 2.0 * radius, 2.0 * radius, 2.0 * radius },
    { copies, copies, copies }, radius);
}
inline PackInBox BodyCentred(int copies, double radius = 1.0)
{
  const double a = 4.0 / std::sqrt(3.0) * radius;
  return Lattice(
    { { 0, 0, 0 }, { 0.5, 0.5, 0.5 } }, { a, a, a }, { copies, copies, copies }, radius);
}
inline PackInBox FaceCentred(int copies, double radius = 1.0)
{
  const double a = std::sqrt(8.0) * radius;
  return Lattice({ { 0, 0, 0 }, { 0.5, 0.5, 0 }, { 0.5, 0, 0.5 }, { 0, 0.5, 0.5 } }, { a, a, a },
    { copies, copies, copies }, radius);
}
inline PackInBox HexagonalClose(int copies, double radius = 1.0)
{
  const double a = 2.0 * radius;
  return Lattice({ { 0, 0, 0 }, { 0.5, 0.5, 0 }, { 0.5, 5.0 / 6.0, 0.5 }, { 0, 1.0 / 3.0, 0.5 } },
    { a, std::sqrt(3.0) * a, std::sqrt(8.0 / 3.0) * a }, { copies, copies, copies }, radius);
}

inline ruc::NeighbourStatistics MeasureNeighbours(const ruc::SpherePack& pack,
  const ruc::Window& window, const ruc::NeighbourSettings& settings, double margin,
  ruc::Communicator& ranks)
{
  const ruc::SamplingRegion region(window, margin);
  return ruc::MeasureNeighbours(
    ruc::SharePack(pack, window, true, ranks), { region, margin, false }, settings, ranks);
}

inline ruc::NeighbourStatistics MeasureNeighbours(
  const PackInBox& made, const ruc::NeighbourSettings& settings = {}, double margin = 0.0)
{
  ruc::Communicator alone;
  return MeasureNeighbours(made.Pack, made.Box, settings, margin, alone);
}
}
