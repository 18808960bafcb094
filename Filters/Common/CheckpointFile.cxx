// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CheckpointFile.h"

#include "NewFile.h"
#include "RankCommunicator.h"
#include "RegularFile.h"
#include "ruc/Base/Text.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <exception>
#include <stdexcept>

CheckpointFile::CheckpointFile(std::string name, double interval)
  : Name(std::move(name))
  , Interval(interval)
  , Last(std::chrono::steady_clock::now())
{
}

std::string CheckpointFile::ReadHere() const
{
  if (!this->IsWanted())
  {
    return {};
  }
  if (access(this->Name.c_str(), F_OK) != 0)
  {
    // Told before work that could not be kept
    const std::size_t slash = this->Name.rfind('/');
    const std::string folder = slash == std::string::npos ? "." : this->Name.substr(0, slash + 1);
    if (access(folder.c_str(), F_OK) != 0)
    {
      throw std::invalid_argument(
        ruc::Text("CheckpointFile requires a name in a folder that is there, got '", this->Name,
          "': ", std::strerror(errno), "."));
    }
    return {};
  }
  std::string bytes, error;
  try
  {
    bytes = RegularFile::Read(this->Name);
    error = bytes.empty() ? "it is empty." : "";
  }
  catch (const std::exception& e)
  {
    error = e.what();
  }
  if (!error.empty())
  {
    throw std::invalid_argument(
      ruc::Text("CheckpointFile requires a checkpoint or a name that is free, got '", this->Name,
        "': ", error));
  }
  return bytes;
}

std::string CheckpointFile::Read(RankCommunicator& ranks) const
{
  std::string bytes;
  ranks.Agree(
    [&]()
    {
      if (ranks.Rank() == 0)
      {
        bytes = this->ReadHere();
      }
    });
  ranks.Broadcast(bytes, 0);
  return bytes;
}

bool CheckpointFile::IsDue() const
{
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - this->Last;
  return this->IsWanted() && passed.count() >= this->Interval;
}

std::string CheckpointFile::Write(const std::string& bytes)
{
  this->Last = std::chrono::steady_clock::now();
  try
  {
    NewFile file(this->Name);
    file.Append(bytes);
    file.Keep();
  }
  catch (const std::invalid_argument& e)
  {
    return e.what();
  }
  return {};
}
