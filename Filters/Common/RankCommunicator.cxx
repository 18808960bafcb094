// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RankCommunicator.h"

#include "RankSignal.h"

#include "ruc/Base/Text.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace
{
// The most bytes that a call of MPI, which counts in int, is asked to carry at a time
constexpr vtkIdType MostBytes = vtkIdType(1) << 30;
constexpr int AllToAllTag = 61301;
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
  // In every step the ranks form pairs. The lower rank of a pair sends first, so that no ring of
  // ranks waits for each other.
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
  if (this->Size() > 1 && (!RankSignal::WithMpi || !this->Controller->IsA("vtkMPIController")))
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
