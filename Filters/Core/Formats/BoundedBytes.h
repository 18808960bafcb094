// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Text.h"
#include "ruc/Formats/ByteStream.h"

#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

namespace ruc
{
/**
 * The bytes of another stream, of which only so many may be read for one frame: a packed file does
 * not tell how long its frames are before they are read.
 */
class BoundedBytes : public ByteStream
{
public:
  explicit BoundedBytes(std::unique_ptr<ByteStream> bytes)
    : Bytes(std::move(bytes))
  {
  }

  /** Lets any number of bytes be read from now on, as it is before the first call of Allow. */
  void AllowAll() { this->Allow(std::numeric_limits<std::uint64_t>::max(), {}); }

  /**
   * Lets `most` bytes be read from now on. Reading more throws std::invalid_argument, whose text
   * says what the limit is, such as "a quarter of this machine's memory".
   */
  void Allow(std::uint64_t most, const std::string& limit)
  {
    this->Most = most;
    this->Limit = limit;
    this->Done = 0;
  }

  std::size_t Read(char* buffer, std::size_t size) override
  {
    const std::size_t read = this->Bytes->Read(buffer, size);
    this->Done += read;
    if (this->Done > this->Most)
    {
      throw std::invalid_argument(Text("a frame of at most ", static_cast<double>(this->Most) / 1e6,
        " MB is required, ", this->Limit, ", got more."));
    }
    return read;
  }
  void Seek(std::uint64_t offset) override { this->Bytes->Seek(offset); }
  std::uint64_t MostBytes() const override { return this->Bytes->MostBytes(); }

private:
  std::unique_ptr<ByteStream> Bytes;
  std::uint64_t Most = std::numeric_limits<std::uint64_t>::max(), Done = 0;
  std::string Limit;
};
}
