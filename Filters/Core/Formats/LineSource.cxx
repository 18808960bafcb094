// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Formats/LineSource.h"

#include "ruc/Base/Text.h"

#include <cstring>
#include <stdexcept>

namespace ruc
{
LineSource::LineSource(ByteStream& bytes, std::uint64_t offset, std::size_t linesBefore)
  : Bytes(bytes)
  , BufferOffset(offset)
  , LinesBefore(linesBefore)
{
  this->Bytes.Seek(offset);
  this->Refill();
  const std::string_view begin(this->Buffer.data(), this->End);
  if (begin.find('\n') == begin.npos && begin.find('\r') != begin.npos)
  {
    this->LineEnd = '\r';
  }
}

void LineSource::Refill()
{
  const std::size_t rest = this->End - this->At;
  std::memmove(this->Buffer.data(), this->Buffer.data() + this->At, rest);
  this->BufferOffset += this->At;
  this->At = 0;
  const std::size_t room = this->Buffer.size() - rest;
  const std::size_t read = this->Bytes.Read(this->Buffer.data() + rest, room);
  this->End = rest + read;
  this->AtEnd = read < room;
}

bool LineSource::FindEnd(std::size_t& end)
{
  for (std::size_t from = this->At;;)
  {
    const char* data = this->Buffer.data();
    const void* found = std::memchr(data + from, this->LineEnd, this->End - from);
    end = found ? static_cast<std::size_t>(static_cast<const char*>(found) - data) : this->End;
    if (end - this->At > LongestLine)
    {
      throw std::invalid_argument(Text("Line ", this->LinesBefore + 1, ": a line of at most ",
        LongestLine, " bytes is required, got more."));
    }
    if (found || this->AtEnd)
    {
      return found || end > this->At;
    }
    from = this->End - this->At;
    this->Refill();
  }
}

bool LineSource::Take(std::string_view& line, bool goOn)
{
  std::size_t end;
  if (!this->FindEnd(end))
  {
    return false;
  }
  line = std::string_view(this->Buffer.data() + this->At, end - this->At);
  if (!line.empty() && line.back() == '\r')
  {
    line.remove_suffix(1);
  }
  if (goOn)
  {
    this->At = std::min(end + 1, this->End);
    ++this->LinesBefore;
  }
  return true;
}

std::string_view LineSource::Require(const char* what)
{
  std::string_view line;
  if (!this->Next(line))
  {
    throw std::invalid_argument(
      Text("Line ", this->LinesBefore + 1, ": ", what, " is required, got the end of the file."));
  }
  return line;
}

std::size_t LineSource::Skip(std::size_t count)
{
  std::string_view line;
  std::size_t passed = 0;
  while (passed < count && this->Next(line))
  {
    ++passed;
  }
  return passed;
}

std::uint64_t LineSource::MostBytesLeft() const
{
  const std::uint64_t most = this->Bytes.MostBytes(), at = this->Offset();
  return this->AtEnd ? this->End - this->At : at < most ? most - at : 0;
}

void LineSource::Fail(const std::string& what) const
{
  throw std::invalid_argument(Text("Line ", this->LinesBefore, ": ", what));
}
}
