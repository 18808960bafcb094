// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OutputSummary.h"

#include "PackData.h"
#include "RankCommunicator.h"

void OutputSummary::AddLags(vtkDataObject* data, const ruc::LagGrid& lags)
{
  PackData::AddField(data, "NumberOfLags", std::vector<long long>{ lags.Count });
  PackData::AddField(data, "MaximumLag", std::vector<double>{ lags.Maximum() });
}

void OutputSummary::AddSamples(vtkDataObject* data, const Samples& samples)
{
  PackData::AddField(
    data, samples.Name, std::vector<long long>{ static_cast<long long>(samples.Number) });
  PackData::AddField(data, "TotalError", std::vector<double>{ samples.TotalError });
  PackData::AddField(data, "Stopped", std::vector<long long>{ samples.Stopped });
}

void OutputSummary::WarnOfStop(vtkObject* filter, bool stopped, const RankCommunicator& ranks)
{
  if (stopped && ranks.Rank() == 0)
  {
    vtkWarningWithObjectMacro(filter, << "stopped before all samples were taken.");
  }
}
