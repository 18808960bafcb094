// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Statistics/Results/LagGrid.h"
#include "ruc/Window/Window.h"

#include <limits>
#include <string>

namespace ruc
{
/**
 * How far lags may reach with each method, and how far they do reach where no maximum is set. A run
 * and its estimate take their lags from the same limit. Lengths are in the unit of the pack.
 *
 * Where all axes are periodic, the largest lag is four times the shortest edge. Elsewhere it is
 * 0.999 of the length given below, at which no pair would be left, so that every pair that matters
 * has a place in the window with some weight left.
 */
class LagLimit
{
public:
  /**
   * The limit of exact pair sums. The largest lag is the shortest edge that is not periodic less
   * one diameter of the largest sphere. The automatic one is half the shortest edge.
   */
  static LagLimit ForPairSum(const Window& window, double largestRadius);

  /**
   * The limit of maps of S_rs(x), for their reach, which is half the edge of their cube. Every pair
   * with a displacement closer than a diameter to a lag vector of the map must have a place in the
   * window. The largest reach is
   *
   * - for a box, that of a pair sum;
   * - for a cylinder of axis u, the lesser of (height - diameter) / (|u_x| + |u_y| + |u_z|) and (2
   *   radius - diameter) / (the largest distance from the axis of a corner of the cube of half edge
   *   1), which is sqrt(2) for an upright cylinder.
   *
   * The automatic reach is `lag`, the last lag of the functions that are measured along with the
   * map.
   */
  static LagLimit ForMap(const Window& window, double largestRadius,
    double lag = std::numeric_limits<double>::infinity());

  /**
   * The limit of distances of centres, in bins of one spacing around the lags. The largest lag is
   * the shortest edge that is not periodic less half a bin. The automatic one is half the shortest
   * edge.
   */
  static LagLimit ForDistances(const Window& window, int numberOfLags);

  /**
   * The limit of chords and templates in the part of a window that is sampled. The largest lag is
   * the shortest edge of that part, which is the window without its two margins. The automatic one
   * is half the shortest edge of the window.
   */
  static LagLimit ForSampling(const Window& window, const Window& sampled);

  /**
   * The limit of fans, which reach to both sides. Unless all axes are periodic, both lags are half
   * of those for chords.
   */
  static LagLimit ForFans(const Window& window, const Window& sampled);

  /**
   * The limit for the S_rs that a periodic cell of this edge is to have. The largest lag is two
   * edges, beyond which the cell would be compared with its own copies alone. The automatic one is
   * half the edge. The limit of the pack holds besides.
   */
  static LagLimit ForCell(double edge);

  /** What a maximum lag of 0 stands for; never more than Largest. */
  double Automatic;
  double Largest;

  /**
   * Returns the lags up to `maximum`, or up to Automatic where that is 0. Throws
   * std::invalid_argument for a maximum that is not finite or < 0, for a number of lags out of
   * range, and for a window without room for any lag. A maximum above Largest is for Check to
   * refuse.
   */
  LagGrid MakeGrid(double maximum, int numberOfLags) const;

  /** Throws std::invalid_argument unless 0 < maximum <= Largest (1 + 1e-12). */
  void Check(double maximum) const;

  /**
   * Throws std::invalid_argument unless `spacing` is at least 1e-9 of the shortest edge. Lags that
   * lie closer are lost in the rounding of distances.
   */
  void CheckSpacing(double spacing) const;

  /** Makes both checks. */
  void Check(const LagGrid& lags) const;

private:
  LagLimit(double automatic, double largest, double shortestEdge, std::string where = {});
  void RequireRoom() const;

  double Finest; // the least spacing of lags

  // Parts of messages: what is required, the name of the spacing, for what window, and what is
  // wrong where there is no room for any lag
  std::string Required = "MaximumLag requires 0 < MaximumLag <= ";
  std::string SpacingName = "MaximumLag / NumberOfLags";
  std::string Where;
  std::string Lack;
};
}
