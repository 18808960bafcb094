// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RankCommunicator.h"

#include "ruc/Base/Text.h"

#include "vtkCommunicator.h"
#include "vtkMPIController.h"
#include "vtkMultiProcessController.h"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

namespace
{
// What a call of MPI, which counts in int, is asked to carry at a time
constexpr vtkIdType MostBytes = vtkIdType(1) << 30;
constexpr int AllToAllTag = 61301, SignalTag = 61302, HereTag = 61303;
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

void RankCommunicator::BroadcastBytes(std::string& bytes, int root)
{
  auto size = static_cast<vtkIdType>(bytes.size());
  this->Controller->Broadcast(&size, 1, root);
  bytes.resize(size);
  for (vtkIdType done = 0; done < size; done += MostBytes)
  {
    this->Controller->Broadcast(bytes.data() + done, std::min(size - done, MostBytes), root);
  }
}

std::vector<std::string> RankCommunicator::AllGatherBytes(
  std::string own, const std::vector<std::size_t>& known)
{
  const int ranks = this->Size();
  const auto size = static_cast<vtkIdType>(own.size());
  std::vector<vtkIdType> sizes(known.begin(), known.end());
  if (known.empty())
  {
    sizes.resize(ranks);
    this->Controller->AllGather(&size, sizes.data(), 1);
  }
  const vtkIdType longest = *std::max_element(sizes.begin(), sizes.end());
  const vtkIdType step = MostBytes / ranks;
  std::vector<std::string> all(ranks);
  for (vtkIdType done = 0; done < longest; done += step)
  {
    const auto part = [&](vtkIdType of) { return std::clamp<vtkIdType>(of - done, 0, step); };
    std::vector<vtkIdType> lengths(ranks), offsets(ranks, 0);
    std::transform(sizes.begin(), sizes.end(), lengths.begin(), part);
    std::partial_sum(lengths.begin(), lengths.end() - 1, offsets.begin() + 1);
    std::string bytes(offsets.back() + lengths.back(), '\0');
    this->Controller->AllGatherV(
      own.data() + std::min(done, size), bytes.data(), part(size), lengths.data(), offsets.data());
    for (int rank = 0; rank < ranks; ++rank)
    {
      all[rank].append(bytes, offsets[rank], lengths[rank]);
    }
  }
  return all;
}

std::vector<std::string> RankCommunicator::AllToAllBytes(std::vector<std::string> outgoing)
{
  const int ranks = this->Size();
  const int rank = this->Rank();
  std::vector<std::string> incoming(ranks);
  const auto send = [&](int to)
  {
    const auto size = static_cast<vtkIdType>(outgoing[to].size());
    this->Controller->Send(&size, 1, to, AllToAllTag);
    if (size > 0)
    {
      this->Controller->Send(outgoing[to].data(), size, to, AllToAllTag);
    }
    std::string().swap(outgoing[to]);
  };
  const auto receive = [&](int from)
  {
    vtkIdType size = 0;
    this->Controller->Receive(&size, 1, from, AllToAllTag);
    incoming[from].resize(size);
    if (size > 0)
    {
      this->Controller->Receive(incoming[from].data(), size, from, AllToAllTag);
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

void RankCommunicator::RequireMpi() const
{
  if (this->Size() > 1 && !vtkMPIController::SafeDownCast(this->Controller))
  {
    throw std::invalid_argument(ruc::Text("Several ranks require MPI, got ", this->Size(),
      " ranks of a ", this->Controller->GetClassName(), "."));
  }
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
