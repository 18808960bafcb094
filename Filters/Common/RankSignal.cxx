// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RankSignal.h"

#include "RankCommunicator.h"

#ifdef RUC_MPI

#include "vtkMPICommunicator.h"
#include "vtkMPIController.h"

#include <chrono>
#include <thread>
#include <vector>

namespace
{
constexpr int SignalTag = 61302, HereTag = 61303;
}

const bool RankSignal::WithMpi = true;

class RankSignal::Ranks
{
public:
  explicit Ranks(vtkMPIController* controller)
    : Controller(controller)
  {
    if (!this->IsFirst())
    {
      this->Controller->NoBlockReceive(&this->Message, 1, 0, SignalTag, this->Receipt);
    }
  }

  ~Ranks()
  {
    if (!this->IsFirst() && !this->Done)
    {
      this->Receipt.Cancel(); // an error was thrown before the end
    }
  }

  void Give(int message)
  {
    if (this->Done)
    {
      return;
    }
    this->Done = true;
    this->Message = message;
    for (int rank = 1; rank < this->Controller->GetNumberOfProcesses(); ++rank)
    {
      this->Controller->Send(&this->Message, 1, rank, SignalTag);
    }
  }

  int Heard()
  {
    if (!this->IsFirst() && !this->Done)
    {
      this->Done = this->Receipt.Test() != 0;
    }
    return this->Done ? this->Message : 0;
  }

  void Close(const std::function<int()>& ask)
  {
    if (this->IsFirst())
    {
      this->AwaitOthers(ask);
      this->Give(0); // for which the others wait
      return;
    }
    const int here = 1;
    this->Controller->Send(&here, 1, 0, HereTag);
    if (!this->Done)
    {
      this->Receipt.Wait();
      this->Done = true;
    }
  }

private:
  bool IsFirst() const { return this->Controller->GetLocalProcessId() == 0; }

  void AwaitOthers(const std::function<int()>& ask)
  {
    const int ranks = this->Controller->GetNumberOfProcesses();
    std::vector<int> here(ranks);
    std::vector<vtkMPICommunicator::Request> others(ranks);
    for (int rank = 1; rank < ranks; ++rank)
    {
      this->Controller->NoBlockReceive(&here[rank], 1, rank, HereTag, others[rank]);
    }
    for (int rank = 1; rank < ranks;)
    {
      if (others[rank].Test())
      {
        ++rank;
        continue;
      }
      const int message = ask();
      if (message != 0)
      {
        this->Give(message);
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
  }

  vtkMPIController* Controller;
  vtkMPICommunicator::Request Receipt; // of the message, on a rank above 0
  int Message = 0;
  bool Done = false; // given, or received
};

RankSignal::RankSignal(const RankCommunicator& ranks)
{
  if (ranks.Size() > 1)
  {
    this->Others = std::make_unique<Ranks>(vtkMPIController::SafeDownCast(ranks.GetController()));
  }
}

#else

const bool RankSignal::WithMpi = false;

// There is one rank
class RankSignal::Ranks
{
public:
  void Give(int) {}
  int Heard() { return 0; }
  void Close(const std::function<int()>&) {}
};

RankSignal::RankSignal(const RankCommunicator&) {}

#endif

RankSignal::~RankSignal() = default;

void RankSignal::Give(int message)
{
  if (this->Others)
  {
    this->Others->Give(message);
  }
}

int RankSignal::Heard()
{
  return this->Others ? this->Others->Heard() : 0;
}

void RankSignal::Close(const std::function<int()>& ask)
{
  if (this->Others)
  {
    this->Others->Close(ask);
  }
}
