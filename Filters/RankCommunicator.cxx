// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RankCommunicator.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"

#include <stdexcept>
#include <vector>

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
