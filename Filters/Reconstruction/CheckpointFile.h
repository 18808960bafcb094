// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <functional>
#include <string>

class RankCommunicator;

/**
 * A file that holds the last state of a search. Rank 0 writes and reads it. A new state goes to a
 * file of its own beside it, NAME.new- and a number that no file has yet, which takes its place
 * once it is on the disk; whatever happens on the way, the last good state remains. A search that
 * is killed while it writes may leave such a file behind.
 */
class CheckpointFile
{
public:
  /** Without a name nothing is ever written. `interval` in seconds, >= 0. */
  CheckpointFile(std::string name, double interval);

  bool IsWanted() const { return !this->Name.empty(); }
  const std::string& GetName() const { return this->Name; }

  /**
   * Collective: the bytes of the file on every rank; empty where there is no file. Throws
   * std::invalid_argument, the same on every rank, for what is no regular file, cannot be read or
   * is empty.
   */
  std::string Read(RankCommunicator& ranks) const;

  /** Whether the interval has passed since the last state was written, or the search began. */
  bool IsDue() const;

  /** On rank 0: writes a state. Returns why that failed, or an empty text. */
  std::string Write(const std::string& bytes);

private:
  std::string Name;
  double Interval;
  std::chrono::steady_clock::time_point Last;
};
