// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCCommonModule.h"

#include <chrono>
#include <string>

class RankCommunicator;

/**
 * A file that holds the last state of a search or a pack. Rank 0 writes and reads it. A new state
 * is a NewFile; so, whatever happens meanwhile, the last good state remains.
 */
class RUCCOMMON_EXPORT CheckpointFile
{
public:
  /** If the name is empty, nothing is ever written. `interval` is in seconds, >= 0. */
  CheckpointFile(std::string name, double interval);

  /** Returns whether there is a name. */
  bool IsWanted() const { return !this->Name.empty(); }
  const std::string& GetName() const { return this->Name; }

  /**
   * Returns the bytes of the file on every rank, or nothing if there is no file. Throws
   * std::invalid_argument, the same on every rank, if the name leads to what is no regular file, or
   * to a file that cannot be read or is empty. Collective.
   */
  std::string Read(RankCommunicator& ranks) const;
  /** The same on this rank alone. */
  std::string ReadHere() const;

  /**
   * Returns whether the interval has passed since the last state was written, or since the search
   * began.
   */
  bool IsDue() const;

  /** Writes a state. Returns why that failed, or an empty text. On rank 0 alone. */
  std::string Write(const std::string& bytes);

private:
  std::string Name;
  double Interval;
  std::chrono::steady_clock::time_point Last;
};
