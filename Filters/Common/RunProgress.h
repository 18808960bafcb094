// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCCommonModule.h"

#include <optional>
#include <string>

/**
 * What a running filter tells about itself. The share of the work that is done is not part of it,
 * since VTK brings that to the client on its own.
 */
struct RUCCOMMON_EXPORT RunProgress
{
  std::string Filter;     // its label in the menu
  std::string Activity;   // what is going on, for a reader: "cell 2, minimising F2, iteration 40"
  bool Stoppable = false; // whether the activity ends early, with a result, when it is told to stop
  std::string Quantity; // the name of a value that the run changes: "F2"; empty where there is none
  double Value = 0.0;   // the value of that quantity

  /**
   * Returns the progress as one line of text. This is all that VTK carries from server to client,
   * and what the progress bar of ParaView shows:
   *
   *     Unit Cell Reconstruction: minimising F2, iteration 40 [F2 = 0.05, may be stopped]
   *     Two-Point Probability: summing pairs [runs to its end]
   *
   * The label ends at the first ": ". The brackets at the end hold the quantity with four digits,
   * where there is one, and always one of the two phrases, by which the client tells the text from
   * those of other filters. A label holds no ": ", and the name of a quantity neither " = " nor "
   * [". Four blanks follow, since ParaView 6.1 loses the last four characters between server and
   * client.
   */
  std::string ToText() const;

  /** Returns the progress from which a text was made, or nothing where it is not such a text. */
  static std::optional<RunProgress> FromText(std::string text);
};
