// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace ruc
{
constexpr double BytesOfMegabyte = 1e6;

/**
 * What work will take, told without doing any of it from a few figures of the pack (PackFigures).
 * The seconds are the number of pairs, points or spheres on a line times the seconds that one of
 * them takes on a core of a virtual AMD EPYC of 2023. Where the pack is even the estimate is good
 * to a factor of three, which is enough to tell a minute from a day; `Testing/Benchmark/run` prints
 * estimated over measured. Every function Estimate… stands beside the work that it is about.
 */
struct Estimate
{
  double Seconds = 0.0;         // on one core
  double MegabytesOfRank = 0.0; // on every rank
  double MegabytesOfAll = 0.0;  // divided among the ranks
  /** The values, in words, that the program chooses where a setting is 0. */
  std::string Automatic = {};

  Estimate& operator+=(const Estimate& other)
  {
    this->Seconds += other.Seconds;
    this->MegabytesOfRank += other.MegabytesOfRank;
    this->MegabytesOfAll += other.MegabytesOfAll;
    return *this;
  }
};
}
