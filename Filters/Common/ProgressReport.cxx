// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ProgressReport.h"

#include "vtkRUCStopRequest.h"

#include "vtkAlgorithm.h"

#include <iostream>

namespace
{
constexpr std::chrono::milliseconds UpdateInterval(100);
constexpr std::chrono::seconds LineInterval(3);
}

ProgressReport::ProgressReport(vtkAlgorithm* filter, const std::string& name)
  : Filter(filter)
  , Name(name)
  , Start(std::chrono::steady_clock::now())
  , LastUpdate(Start - UpdateInterval)
  , LastLine(Start)
{
  filter->SetAbortExecute(0); // VTK leaves it standing
  vtkRUCStopRequest::Clear();
}

double ProgressReport::Seconds() const
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Start).count();
}

bool ProgressReport::Update(double fraction, const std::string& text)
{
  const auto now = std::chrono::steady_clock::now();
  if (now - this->LastUpdate >= UpdateInterval)
  {
    this->LastUpdate = now;
    this->Filter->SetProgressText((this->Name + ": " + text).c_str());
    this->Filter->UpdateProgress(fraction);
  }
  if (now - this->LastLine >= LineInterval)
  {
    this->LastLine = now;
    std::cout << this->Name << ": " << static_cast<int>(this->Seconds()) << " s, " << text
              << std::endl;
  }
  return !this->Filter->GetAbortExecute() && !vtkRUCStopRequest::IsPending();
}
