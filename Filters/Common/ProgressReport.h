// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RunProgress.h"
#include "RUCCommonModule.h"

#include <chrono>
#include <functional>
#include <string>

class RankCommunicator;
class vtkAlgorithm;

/**
 * Tells a user how far a filter is: text and bar of the window about ten times a second, and a line
 * on the standard output every few seconds, which is what a batch run shows. It is updated on rank
 * 0 alone, from its main thread. A `fraction` is the share of the work that is done, in [0, 1]; an
 * `activity` says what is going on.
 */
class RUCCOMMON_EXPORT ProgressReport
{
public:
  /** Forgets wishes that an earlier run should stop. It may be made on any rank. */
  ProgressReport(vtkAlgorithm* filter, const std::string& name);

  /**
   * Takes the wish back that this run should stop, which was met. Since VTK 9.3 filters downstream
   * look for one upstream, and would empty their outputs in place of showing what the run has kept.
   */
  ~ProgressReport();

  ProgressReport(const ProgressReport&) = delete;
  ProgressReport& operator=(const ProgressReport&) = delete;

  /** Tells of work that has nothing to show before its end, and so cannot be stopped. */
  void Tell(double fraction, const std::string& activity);

  /** Tells of anything. The name of the filter is filled in by the report. */
  void Tell(double fraction, RunProgress progress);

  /**
   * Tells of work that can be stopped. Returns whether to go on, which is false once there is a
   * vtkRUCStopRequest or somebody has called SetAbortExecute.
   */
  [[nodiscard]] bool Update(double fraction, const std::string& activity);

  /**
   * Returns a function that tells, on rank 0, the share of the pairs that are summed. That of
   * ForPairs is for sums that cannot be stopped; the other one returns whether to go on.
   */
  std::function<void(double)> ForPairs(const RankCommunicator& ranks);
  std::function<bool(double)> ForSums(const RankCommunicator& ranks);

  /** The seconds since the report was made. */
  double Seconds() const;

private:
  vtkAlgorithm* Filter;
  std::string Name;
  std::chrono::steady_clock::time_point Start, LastUpdate, LastLine;
};
