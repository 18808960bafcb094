// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Ranks.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkNew.h"

#include <chrono>
#include <string>
#include <thread>
#include <vector>

/**
 * Stops a filter on rank 0, as the window does, at one of the events by which it tells how far it
 * is, and keeps the texts of all of them. Each event takes a while, so that the next is not left
 * out for coming too soon.
 */
class StopAt
{
public:
  explicit StopAt(vtkAlgorithm* filter, int event)
    : Event(event)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback([](vtkObject* caller, unsigned long, void* self, void*)
      { static_cast<StopAt*>(self)->Tell(static_cast<vtkAlgorithm*>(caller)); });
    filter->AddObserver(vtkCommand::ProgressEvent, this->Command);
  }

  std::vector<std::string> Texts;

private:
  void Tell(vtkAlgorithm* running)
  {
    // VTK tells 0 and 1 before and after a run; a wish would then be for the next one
    if (Rank() != 0 || running->GetProgress() <= 0.0 || running->GetProgress() >= 1.0)
    {
      return;
    }
    if (static_cast<int>(this->Texts.size()) == this->Event)
    {
      running->SetAbortExecute(1);
    }
    this->Texts.push_back(running->GetProgressText() ? running->GetProgressText() : "");
    std::this_thread::sleep_for(std::chrono::milliseconds(110));
  }

  int Event;
  vtkNew<vtkCallbackCommand> Command;
};
