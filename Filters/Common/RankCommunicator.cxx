// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RankCommunicator.h"

#include "vtkCommunicator.h"
#include "vtkMPIController.h"
#include "vtkMultiProcessController.h"

#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

namespace
{
constexpr int ExchangeTag = 61301, SignalTag = 61302, HereTag = 61303;
}

int RankCommunicator::Rank() const
{
  return this->Controller ? this->Controller->GetLocalProcessId() : 0;
}

int RankCommunicator::Size() const
{
  return this->Controller ? this->Controller->GetNumberOfProcesses() : 1;
}

void RankCommunicator::Sum(std::int64_t* values, std::size_t count)
{
  if (this->Size() > 1)
  {
    static_assert(
      sizeof(vtkTypeInt64) == sizeof(std::int64_t), "the same integers under two names");
    const std::vector<std::int64_t> own(values, values + count);
    this->Controller->AllReduce(reinterpret_cast<const vtkTypeInt64*>(own.data()),
      reinterpret_cast<vtkTypeInt64*>(values), static_cast<vtkIdType>(count),
      vtkCommunicator::SUM_OP);
  }
}

void RankCommunicator::Share(double* values, std::size_t count)
{
  if (this->Size() > 1)
  {
    const std::vector<double> own(values, values + count);
    this->Controller->AllReduce(
      own.data(), values, static_cast<vtkIdType>(count), vtkCommunicator::SUM_OP);
  }
}

void RankCommunicator::Minimum(std::int32_t* values, std::size_t count)
{
  if (this->Size() > 1)
  {
    static_assert(sizeof(int) == sizeof(std::int32_t), "the same integers under two names");
    const std::vector<int> own(values, values + count);
    this->Controller->AllReduce(
      own.data(), values, static_cast<vtkIdType>(count), vtkCommunicator::MIN_OP);
  }
}

void RankCommunicator::Minimum(double* values, std::size_t count)
{
  if (this->Size() > 1)
  {
    const std::vector<double> own(values, values + count);
    this->Controller->AllReduce(
      own.data(), values, static_cast<vtkIdType>(count), vtkCommunicator::MIN_OP);
  }
}

std::vector<std::vector<double>> RankCommunicator::Exchange(
  std::vector<std::vector<double>> outgoing)
{
  const int ranks = this->Size();
  const int rank = this->Rank();
  std::vector<std::vector<double>> incoming(ranks);
  const auto send = [&](int to)
  {
    const vtkIdType count = static_cast<vtkIdType>(outgoing[to].size());
    this->Controller->Send(&count, 1, to, ExchangeTag);
    if (count > 0)
    {
      this->Controller->Send(outgoing[to].data(), count, to, ExchangeTag);
    }
    std::vector<double>().swap(outgoing[to]);
  };
  const auto receive = [&](int from)
  {
    vtkIdType count = 0;
    this->Controller->Receive(&count, 1, from, ExchangeTag);
    incoming[from].resize(count);
    if (count > 0)
    {
      this->Controller->Receive(incoming[from].data(), count, from, ExchangeTag);
    }
  };
  // In every step the ranks make pairs; the lower one of a pair talks first, so none waits in a
  // ring
  for (int step = 0; step < ranks; ++step)
  {
    const int partner = (step - rank + ranks) % ranks;
    if (partner == rank)
    {
      incoming[rank] = std::move(outgoing[rank]);
    }
    else if (rank < partner)
    {
      send(partner);
      receive(partner);
    }
    else
    {
      receive(partner);
      send(partner);
    }
  }
  return incoming;
}

std::unique_ptr<RankCommunicator> RankCommunicator::Split(int group) const
{
  auto part = std::make_unique<RankCommunicator>(this->Controller);
  if (this->Size() > 1)
  {
    part->Own = vtkSmartPointer<vtkMultiProcessController>::Take(
      this->Controller->PartitionController(group, this->Rank()));
    part->Controller = part->Own;
  }
  return part;
}

std::string RankCommunicator::FirstText(const std::string& text)
{
  if (this->Size() == 1)
  {
    return text;
  }
  const int own = text.empty() ? this->Size() : this->Rank();
  int first = own;
  this->Controller->AllReduce(&own, &first, 1, vtkCommunicator::MIN_OP);
  if (first == this->Size())
  {
    return {};
  }
  int length = static_cast<int>(text.size());
  this->Controller->Broadcast(&length, 1, first);
  std::string shared = text;
  shared.resize(length);
  this->Controller->Broadcast(shared.data(), length, first);
  return shared;
}

void RankCommunicator::ThrowIfAny(const std::string& error)
{
  const std::string first = this->FirstText(error);
  if (!first.empty())
  {
    throw std::invalid_argument(first);
  }
}

RankSignal::RankSignal(const RankCommunicator& ranks)
  : Ranks(ranks)
  , Controller(ranks.Size() > 1 ? vtkMPIController::SafeDownCast(ranks.GetController()) : nullptr)
{
  if (ranks.Rank() > 0)
  {
    this->Controller->NoBlockReceive(&this->Message, 1, 0, SignalTag, this->Receipt);
  }
}

RankSignal::~RankSignal()
{
  if (this->Ranks.Rank() > 0 && !this->Done)
  {
    this->Receipt.Cancel(); // an error was thrown before the end
  }
}

void RankSignal::Give(int message)
{
  if (this->Done)
  {
    return;
  }
  this->Done = true;
  this->Message = message;
  for (int rank = 1; rank < this->Ranks.Size(); ++rank)
  {
    this->Controller->Send(&this->Message, 1, rank, SignalTag);
  }
}

int RankSignal::Heard()
{
  if (this->Ranks.Rank() > 0 && !this->Done)
  {
    this->Done = this->Receipt.Test() != 0;
  }
  return this->Done ? this->Message : 0;
}

void RankSignal::Close(const std::function<int()>& ask)
{
  const int ranks = this->Ranks.Size();
  if (this->Ranks.Rank() > 0)
  {
    const int here = 1;
    this->Controller->Send(&here, 1, 0, HereTag);
    if (!this->Done)
    {
      this->Receipt.Wait();
      this->Done = true;
    }
    return;
  }
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
  this->Give(0); // for which the others wait
}
