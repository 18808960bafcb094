// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ProgressReport.h"

#include "RankCommunicator.h"
#include "vtkRUCStopRequest.h"

#include "vtkAlgorithm.h"

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace
{
constexpr std::chrono::milliseconds UpdateInterval(100);
constexpr std::chrono::seconds LineInterval(3);
constexpr double LeastFraction = 0.01; // ParaView's window listens to its abort button from 1 % on
}

ProgressReport::ProgressReport(vtkAlgorithm* filter, const std::string& name)
  : Filter(filter)
  , Name(name)
  , Start(std::chrono::steady_clock::now())
  , LastUpdate(Start - UpdateInterval)
  , LastLine(Start)
{
  filter->SetAbortExecute(0); // VTK does not reset it between runs
  vtkRUCStopRequest::Clear();
}

ProgressReport::~ProgressReport()
{
  this->Filter->SetAbortExecute(0);
}

double ProgressReport::Seconds() const
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Start).count();
}

void ProgressReport::Tell(double fraction, const std::string& activity)
{
  this->Tell(fraction, { this->Name, activity, false, {}, 0.0 });
}

void ProgressReport::Tell(double fraction, RunProgress progress)
{
  progress.Filter = this->Name;
  const auto now = std::chrono::steady_clock::now();
  if (now - this->LastUpdate >= UpdateInterval)
  {
    this->LastUpdate = now;
    this->Filter->SetProgressText(progress.ToText().c_str());
    this->Filter->UpdateProgress(std::max(fraction, LeastFraction));
  }
  if (now - this->LastLine >= LineInterval)
  {
    this->LastLine = now;
    std::ostringstream line;
    line << this->Name << ": " << static_cast<int>(this->Seconds()) << " s, " << progress.Activity;
    if (!progress.Quantity.empty())
    {
      line << ", " << progress.Quantity << " = " << std::setprecision(4) << progress.Value;
    }
    std::cout << line.str() << std::endl;
  }
}

bool ProgressReport::Update(double fraction, const std::string& activity)
{
  this->Tell(fraction, { this->Name, activity, true, {}, 0.0 });
  return !this->Filter->GetAbortExecute() && !vtkRUCStopRequest::IsPending();
}

std::function<void(double)> ProgressReport::ForPairs(const RankCommunicator& ranks)
{
  return [this, &ranks](double done)
  {
    if (ranks.Rank() == 0)
    {
      this->Tell(done, "summing pairs");
    }
  };
}

std::function<bool(double)> ProgressReport::ForSums(const RankCommunicator& ranks)
{
  return [this, &ranks](double done)
  { return ranks.Rank() != 0 || this->Update(done, "summing pairs"); };
}
