// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCCommonModule.h"

#include <chrono>
#include <string>

class vtkAlgorithm;

/**
 * Tells a user how far a filter is: the text and the bar of the GUI about ten times a second, and a
 * line on the standard output every few seconds, which is what a batch run shows. To be updated on
 * rank 0 alone, from its main thread.
 */
class RUCCOMMON_EXPORT ProgressReport
{
public:
  /** Forgets wishes that an earlier run should stop; on any rank. */
  ProgressReport(vtkAlgorithm* filter, const std::string& name);

  /**
   * `fraction` in [0, 1] of the work is done; `text` says what is going on. Returns whether to
   * carry on: false once there is a vtkRUCStopRequest or somebody has called SetAbortExecute.
   */
  bool Update(double fraction, const std::string& text);

  double Seconds() const;

private:
  vtkAlgorithm* Filter;
  std::string Name;
  std::chrono::steady_clock::time_point Start, LastUpdate, LastLine;
};
