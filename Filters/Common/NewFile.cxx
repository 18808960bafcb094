// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "NewFile.h"

#include "ruc/Base/Text.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace
{
constexpr int MostNames = 100; // that are tried for a new file

[[noreturn]] void FailToWrite(const std::string& name, int error)
{
  throw std::invalid_argument(ruc::Text("cannot write '", name, "': ", std::strerror(error)));
}
}

NewFile::NewFile(std::string name)
  : Name(std::move(name))
{
  struct stat status;
  if (lstat(this->Name.c_str(), &status) == 0 && !S_ISREG(status.st_mode) &&
    !S_ISLNK(status.st_mode))
  {
    throw std::invalid_argument(ruc::Text("cannot write '", this->Name,
      "': a regular file or a free name is required, got a ",
      S_ISDIR(status.st_mode) ? "folder" : "device, pipe or socket"));
  }
  errno = EEXIST;
  for (int number = 0; this->Number < 0 && number < MostNames && errno == EEXIST; ++number)
  {
    this->Fresh = ruc::Text(this->Name, ".new-", getpid(), "-", number);
    this->Number =
      open(this->Fresh.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
  }
  if (this->Number < 0)
  {
    FailToWrite(this->Fresh, errno);
  }
}

NewFile::~NewFile()
{
  if (this->Number >= 0)
  {
    close(this->Number);
    unlink(this->Fresh.c_str());
  }
}

void NewFile::Append(std::string_view bytes)
{
  while (!bytes.empty())
  {
    const ssize_t written = write(this->Number, bytes.data(), bytes.size());
    if (written > 0)
    {
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    else if (errno != EINTR)
    {
      FailToWrite(this->Fresh, errno);
    }
  }
}

void NewFile::Keep()
{
  if (fsync(this->Number) != 0)
  {
    FailToWrite(this->Fresh, errno);
  }
  const int closed = close(std::exchange(this->Number, -1));
  if (closed != 0 || std::rename(this->Fresh.c_str(), this->Name.c_str()) != 0)
  {
    const int error = errno;
    unlink(this->Fresh.c_str());
    FailToWrite(this->Fresh, error);
  }
}

void NewFile::Lengthen(std::uint64_t bytes)
{
  if (ftruncate(this->Number, static_cast<off_t>(bytes)) != 0)
  {
    FailToWrite(this->Fresh, errno);
  }
}

PartOfNewFile::PartOfNewFile(const std::string& freshName)
  : Fresh(freshName)
  , Number(open(freshName.c_str(), O_WRONLY | O_NOFOLLOW | O_CLOEXEC))
{
  if (this->Number < 0)
  {
    FailToWrite(this->Fresh, errno);
  }
}

PartOfNewFile::~PartOfNewFile()
{
  close(this->Number);
}

void PartOfNewFile::WriteAt(std::uint64_t offset, std::string_view bytes)
{
  while (!bytes.empty())
  {
    const ssize_t written =
      pwrite(this->Number, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (written > 0)
    {
      bytes.remove_prefix(static_cast<std::size_t>(written));
      offset += static_cast<std::uint64_t>(written);
    }
    else if (errno != EINTR)
    {
      FailToWrite(this->Fresh, errno);
    }
  }
}

void PartOfNewFile::Finish()
{
  if (fsync(this->Number) != 0)
  {
    FailToWrite(this->Fresh, errno);
  }
}
