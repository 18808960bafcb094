// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace ruc
{
/**
 * Bytes that are read one after the other, from any place on. The core opens no files: a reader
 * derives a class of this for its file, and tests have their bytes in memory.
 */
class ByteStream
{
public:
  virtual ~ByteStream() = default;

  /**
   * Reads up to `size` bytes into the buffer and returns their number, which is less only at the
   * end of the stream.
   */
  virtual std::size_t Read(char* buffer, std::size_t size) = 0;

  /** Sets the next byte to be read, counted from the start of the stream. */
  virtual void Seek(std::uint64_t offset) = 0;

  /** Returns a number of bytes that the stream does not exceed: its size, if that is known. */
  virtual std::uint64_t MostBytes() const = 0;
};

/** Bytes in memory, which the caller keeps alive. */
class MemoryBytes : public ByteStream
{
public:
  explicit MemoryBytes(std::string_view bytes)
    : Bytes(bytes)
  {
  }

  std::size_t Read(char* buffer, std::size_t size) override
  {
    size = std::min(size, this->Bytes.size() - this->At);
    std::memcpy(buffer, this->Bytes.data() + this->At, size);
    this->At += size;
    return size;
  }
  void Seek(std::uint64_t offset) override
  {
    this->At = static_cast<std::size_t>(std::min<std::uint64_t>(offset, this->Bytes.size()));
  }
  std::uint64_t MostBytes() const override { return this->Bytes.size(); }

private:
  std::string_view Bytes;
  std::size_t At = 0;
};

/**
 * Returns up to `size` bytes from a place on; fewer at the end of the stream. Memory is taken only
 * for bytes that can be there.
 */
inline std::string ReadBytes(ByteStream& bytes, std::uint64_t offset, std::uint64_t size)
{
  const std::uint64_t most = bytes.MostBytes();
  std::string read(
    static_cast<std::size_t>(std::min(size, offset < most ? most - offset : 0)), '\0');
  bytes.Seek(offset);
  read.resize(bytes.Read(read.data(), read.size()));
  return read;
}
}
