// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkMultiProcessController.h"

#include <cstddef>

/** The number of this rank, and how many ranks there are. */
inline int Rank()
{
  return vtkMultiProcessController::GetGlobalController()->GetLocalProcessId();
}
inline int NumberOfRanks()
{
  return vtkMultiProcessController::GetGlobalController()->GetNumberOfProcesses();
}

/** Whether the i-th sphere of a pack that is dealt out in turn is on this rank. */
inline bool IsMine(std::size_t i)
{
  return i % NumberOfRanks() == static_cast<std::size_t>(Rank());
}
