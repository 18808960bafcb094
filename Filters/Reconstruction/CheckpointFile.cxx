// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CheckpointFile.h"

#include "RankCommunicator.h"
#include "RegularFile.h"
#include "ruc/Base/Text.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>

namespace
{
constexpr int MostNames = 100; // that are tried for a new file
}

CheckpointFile::CheckpointFile(std::string name, double interval)
  : Name(std::move(name))
  , Interval(interval)
  , Last(std::chrono::steady_clock::now())
{
}

std::string CheckpointFile::Read(RankCommunicator& ranks) const
{
  std::string bytes, error;
  if (this->IsWanted() && ranks.Rank() == 0 && access(this->Name.c_str(), F_OK) == 0)
  {
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
      error = ruc::Text("CheckpointFile requires a checkpoint or a name that is free, got '",
        this->Name, "': ", error);
    }
  }
  else if (this->IsWanted() && ranks.Rank() == 0)
  {
    // Told before a search that could not be kept
    const std::size_t slash = this->Name.rfind('/');
    const std::string folder = slash == std::string::npos ? "." : this->Name.substr(0, slash + 1);
    if (access(folder.c_str(), F_OK) != 0)
    {
      error = ruc::Text("CheckpointFile requires a name in a folder that is there, got '",
        this->Name, "': ", std::strerror(errno), ".");
    }
  }
  ranks.ThrowIfAny(error);
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
  // Finds a name that nothing has yet, so that no file of somebody else is written to, nor one that
  // a link leads to
  std::string next;
  int file = -1;
  for (int number = 0; file < 0 && number < MostNames; ++number)
  {
    next = ruc::Text(this->Name, ".new-", getpid(), "-", number);
    file = open(next.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (file < 0 && errno != EEXIST)
    {
      break;
    }
  }
  if (file < 0)
  {
    return ruc::Text("cannot write '", next, "': ", std::strerror(errno));
  }
  int error = 0;
  for (std::size_t done = 0; done < bytes.size() && error == 0;)
  {
    const ssize_t written = write(file, bytes.data() + done, bytes.size() - done);
    if (written > 0)
    {
      done += written;
    }
    else if (errno != EINTR)
    {
      error = errno;
    }
  }
  if (error == 0 && fsync(file) != 0)
  {
    error = errno;
  }
  if (close(file) != 0 && error == 0)
  {
    error = errno;
  }
  if (error == 0 && std::rename(next.c_str(), this->Name.c_str()) != 0)
  {
    error = errno;
  }
  if (error != 0)
  {
    unlink(next.c_str());
    return ruc::Text("cannot write '", next, "': ", std::strerror(error));
  }
  return {};
}
