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
 * How far lags may reach with each method, and how far they do where nobody says it. A run and its
 * estimate take their lags from the same limit.
 *
 * Where all axes are periodic the largest lag is four times the shortest edge. Elsewhere it is
 * 0.999 of the length at which no pair would be left, so that every pair that matters has a place
 * in the window with some weight left.
 */
class LagLimit
{
public:
  /** Exact pair sums. Largest lag: the shortest edge that is not periodic less one diameter.
   * Automatic: half the shortest edge. */
  static LagLimit ForPairSum(const Window& window, double largestRadius);

  /**
   * Maps of S_rs(x), whose reach is half the edge of their cube. Every pair with a displacement
   * closer than a diameter to a lag vector of the map must have a place in the window. Largest:
   *   - for a box that of a pair sum;
   *   - for a cylinder of axis u the lesser of (height - diameter) / (|u_x| + |u_y| + |u_z|) and
   *     (2 radius - diameter) / (the largest distance of a corner of the cube of half edge 1 from
   *     the axis), upright that is sqrt(2).
   * Automatic: `lag`, the last lag of the functions that are measured along with the map.
   */
  static LagLimit ForMap(const Window& window, double largestRadius,
    double lag = std::numeric_limits<double>::infinity());

  /** Distances of centres in bins of one spacing around the lags. Largest lag: the shortest edge
   * that is not periodic less half a bin. Automatic: half the shortest edge. */
  static LagLimit ForDistances(const Window& window, int numberOfLags);

  /** Chords and templates in the part of a window that is sampled. Largest lag: the shortest edge
   * of that part, of a window without its two margins. Automatic: half the window's shortest edge.
   */
  static LagLimit ForSampling(const Window& window, const Window& sampled);

  /** Fans, which reach to both sides: without periodic axes half of what there is for lines. */
  static LagLimit ForFans(const Window& window, const Window& sampled);

  /** The S_rs that a periodic cell of this edge is to have. Largest lag: two edges, beyond which
   * the cell is compared with its own copies alone, and no more than that of the pack. Automatic:
   * half the edge. */
  static LagLimit ForCell(double edge);

  /** What a maximum lag of 0 stands for; never more than Largest. */
  double Automatic;
  double Largest;

  /**
   * The lags up to `maximum`, or up to Automatic where that is 0. Throws std::invalid_argument for
   * a maximum that is not finite or < 0, for a number of lags out of range, and for a window
   * without room for any lag.
   */
  LagGrid MakeGrid(double maximum, int numberOfLags) const;

  /** Throws std::invalid_argument unless 0 < maximum <= Largest (1 + 1e-12). */
  void Check(double maximum) const;

  /** Throws std::invalid_argument unless lags that are `spacing` apart differ: by 1e-9 of the
   * shortest edge. Lags that lie closer are lost in the rounding of distances. */
  void CheckSpacing(double spacing) const;

  /** Both. */
  void Check(const LagGrid& lags) const;

private:
  LagLimit(double automatic, double largest, double shortestEdge, std::string where = {});
  void RequireRoom() const;

  double Finest; // spacing of lags

  // For messages: what is asked, for what window, and what is wrong where there is no room for a
  // lag
  std::string Required = "MaximumLag requires 0 < MaximumLag <= ";
  std::string SpacingName = "MaximumLag / NumberOfLags";
  std::string Where;
  std::string Lack;
};
}
