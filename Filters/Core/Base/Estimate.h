// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace ruc
{
constexpr double BytesOfMegabyte = 1e6;

/**
 * What work will take, told without doing any from a few figures of the pack (PackFigures): the
 * number of pairs, points or spheres on a line times the seconds that one takes on a core of a
 * virtual AMD EPYC of 2023. It is good to a factor of three where the pack is even, which is enough
 * to tell a minute from a day; `Testing/Benchmark/run` prints estimated over measured. Every
 * function Estimate… stands beside the work that it is about.
 */
struct Estimate
{
  double Seconds = 0.0;         // of one core
  double MegabytesOfRank = 0.0; // of every rank
  double MegabytesOfAll = 0.0;  // shared by the ranks
  std::string Automatic = {};   // what 0 stands for in settings that are then automatic, in words

  Estimate& operator+=(const Estimate& other)
  {
    this->Seconds += other.Seconds;
    this->MegabytesOfRank += other.MegabytesOfRank;
    this->MegabytesOfAll += other.MegabytesOfAll;
    return *this;
  }
};
}
