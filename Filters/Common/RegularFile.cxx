// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RegularFile.h"

#include "ruc/Base/Text.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace
{
using ruc::Text;

[[noreturn]] void Fail(const std::string& what)
{
  throw std::invalid_argument(what);
}

// An open file, which is closed at the end of the object's life
class OpenFile
{
public:
  explicit OpenFile(const std::string& name)
    : Number(open(name.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC))
  {
    if (this->Number < 0)
    {
      Fail(Text("a file that can be opened is required, got: ", std::strerror(errno), "."));
    }
    if (fstat(this->Number, &this->Status) != 0 || !S_ISREG(this->Status.st_mode))
    {
      close(this->Number);
      Fail(Text("a regular file is required, got ",
        S_ISDIR(this->Status.st_mode)      ? "a folder"
          : S_ISFIFO(this->Status.st_mode) ? "a pipe"
                                           : "a device or socket",
        "."));
    }
  }
  ~OpenFile() { close(this->Number); }
  OpenFile(const OpenFile&) = delete;
  void operator=(const OpenFile&) = delete;

  double Size() const { return static_cast<double>(this->Status.st_size); }

  void Seek(std::uint64_t offset) const
  {
    if (lseek(this->Number, static_cast<off_t>(offset), SEEK_SET) < 0)
    {
      Fail(
        Text("a file in which places can be sought is required, got: ", std::strerror(errno), "."));
    }
  }

  // Reads at most `count` bytes and returns how many; 0 at the end of the file
  std::size_t Read(char* bytes, std::size_t count) const
  {
    ssize_t got = -1;
    do
    {
      got = read(this->Number, bytes, count);
    } while (got < 0 && errno == EINTR);
    if (got < 0)
    {
      Fail(
        Text("a file that can be read to its end is required, got: ", std::strerror(errno), "."));
    }
    return static_cast<std::size_t>(got);
  }

private:
  int Number;
  struct stat Status
  {
  };
};

void RequireRoom(double bytes)
{
  const auto most = static_cast<double>(RegularFile::MostBytes());
  if (bytes > most)
  {
    Fail(Text("a file of at most ", most / 1e6,
      " MB is required, a quarter of this machine's memory, got ", bytes / 1e6, " MB."));
  }
}

class FileStream : public ruc::ByteStream
{
public:
  explicit FileStream(const std::string& name)
    : File(name)
  {
  }
  std::size_t Read(char* buffer, std::size_t size) override
  {
    std::size_t done = 0;
    while (const std::size_t got = done < size ? this->File.Read(buffer + done, size - done) : 0)
    {
      done += got;
    }
    return done;
  }
  void Seek(std::uint64_t offset) override { this->File.Seek(offset); }
  std::uint64_t MostBytes() const override { return static_cast<std::uint64_t>(this->File.Size()); }

private:
  OpenFile File;
};
}

std::uint64_t RegularFile::MostBytes()
{
  return static_cast<std::uint64_t>(0.25 * static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
    static_cast<double>(sysconf(_SC_PAGE_SIZE)));
}

RegularFile::Stamp RegularFile::FindStamp(const std::string& name)
{
  struct stat status;
  if (stat(name.c_str(), &status) != 0)
  {
    return {};
  }
  return { static_cast<std::int64_t>(status.st_dev), static_cast<std::int64_t>(status.st_ino),
    static_cast<std::int64_t>(status.st_size), static_cast<std::int64_t>(status.st_mtim.tv_sec),
    static_cast<std::int64_t>(status.st_mtim.tv_nsec) };
}

std::unique_ptr<ruc::ByteStream> RegularFile::Open(const std::string& name)
{
  return std::make_unique<FileStream>(name);
}

bool RegularFile::IsReadable(const std::string& name)
{
  try
  {
    OpenFile file(name);
    return true;
  }
  catch (const std::invalid_argument&)
  {
    return false;
  }
}

std::string RegularFile::Read(const std::string& name)
{
  constexpr std::size_t step = std::size_t(1) << 20;
  const OpenFile file(name);
  RequireRoom(file.Size());
  std::string bytes(static_cast<std::size_t>(file.Size()), '\0');
  // Some files of the system have no size, and a file may become longer meanwhile
  for (std::size_t done = 0;;)
  {
    if (done == bytes.size())
    {
      RequireRoom(static_cast<double>(done + step));
      bytes.resize(done + step);
    }
    const std::size_t got = file.Read(&bytes[done], bytes.size() - done);
    done += got;
    if (got == 0)
    {
      bytes.resize(done);
      return bytes;
    }
  }
}
