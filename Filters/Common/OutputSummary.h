// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCCommonModule.h"
#include "ruc/Statistics/Results/LagGrid.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"

#include <cstdint>

class RankCommunicator;

/**
 * What the outputs of the filters tell about how they came about, besides the field data of
 * PackData.
 */
namespace OutputSummary RUCCOMMON_EXPORT
{
/** Calls add(data) for every output of a filter. */
template <class Add>
void ForEachOutput(vtkInformationVector* outputs, Add&& add)
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    add(outputs->GetInformationObject(port)->Get(vtkDataObject::DATA_OBJECT()));
  }
}

/** What was sampled. */
struct Samples
{
  const char* Name; // "NumberOfLines" or "NumberOfThrows"
  std::int64_t Number;
  double TotalError;
  bool Stopped; // whether sampling ended before there were as many as wanted
};

/** Adds the field data `NumberOfLags` and `MaximumLag`, which may have been automatic. */
void AddLags(vtkDataObject* data, const ruc::LagGrid& lags);

/** Adds the number of samples under its name, `TotalError` and `Stopped`. */
void AddSamples(vtkDataObject* data, const Samples& samples);

/** Warns on rank 0, in the name of the filter, that sampling was stopped early, if it was. */
void WarnOfStop(vtkObject* filter, bool stopped, const RankCommunicator& ranks);
}
