// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Formats/GzipBytes.h"

#include "ruc/Base/Text.h"

#include <zlib.h>

#include <array>
#include <cstring>
#include <new>
#include <stdexcept>
#include <vector>

namespace ruc
{
namespace
{
constexpr std::uint64_t MiB = 1u << 20;
// More than a LineSource reads ahead
constexpr std::size_t KeptBytes = MiB;

class GzipBytes : public ByteStream
{
public:
  GzipBytes(std::unique_ptr<ByteStream> packed, std::uint64_t mostBytes)
    : Packed(std::move(packed))
    , Most(mostBytes)
  {
    if (inflateInit2(&this->Inflate, 16 + MAX_WBITS) != Z_OK) // 16: with a header of gzip
    {
      throw std::bad_alloc();
    }
    this->Restart();
  }
  ~GzipBytes() override { inflateEnd(&this->Inflate); }
  GzipBytes(const GzipBytes&) = delete;
  GzipBytes& operator=(const GzipBytes&) = delete;

  std::size_t Read(char* buffer, std::size_t size) override;
  void Seek(std::uint64_t offset) override;
  std::uint64_t MostBytes() const override
  {
    constexpr std::uint64_t deflateRatio = 1032; // no byte stands for more
    const std::uint64_t packed = this->Packed->MostBytes();
    return packed < this->Most / deflateRatio ? packed * deflateRatio : this->Most;
  }

private:
  std::size_t UnpackInto(char* buffer, std::size_t size); // from where unpacking has come to
  void Keep(const char* unpacked, std::size_t size);
  void Restart();
  bool Refill();          // false at the end of the packed bytes
  bool BeginsMember();    // after the end of one
  void CheckSize() const; // throws where too much was unpacked

  std::unique_ptr<ByteStream> Packed;
  const std::uint64_t Most;
  z_stream Inflate = {};
  std::vector<unsigned char> Input = std::vector<unsigned char>(65536);
  std::uint64_t PackedBytes = 0, UnpackedBytes = 0, At = 0; // At: the next byte to be read
  std::string Last;                                         // the bytes that were unpacked last
  bool InMember = true;
};

void GzipBytes::Restart()
{
  inflateReset(&this->Inflate);
  this->Packed->Seek(0);
  this->Inflate.avail_in = 0;
  this->PackedBytes = this->UnpackedBytes = this->At = 0;
  this->Last.clear();
  this->InMember = true;
}

bool GzipBytes::Refill()
{
  const std::size_t read =
    this->Packed->Read(reinterpret_cast<char*>(this->Input.data()), this->Input.size());
  this->Inflate.next_in = this->Input.data();
  this->Inflate.avail_in = static_cast<unsigned int>(read);
  this->PackedBytes += read;
  return read > 0;
}

// Another member may follow; gzip itself passes over anything else there, such as zeros
bool GzipBytes::BeginsMember()
{
  if (this->Inflate.avail_in == 0 && !this->Refill())
  {
    return false;
  }
  if (*this->Inflate.next_in != 0x1f)
  {
    return false;
  }
  inflateReset(&this->Inflate);
  return this->InMember = true;
}

void GzipBytes::CheckSize() const
{
  const std::uint64_t packed = this->PackedBytes - this->Inflate.avail_in;
  const bool bomb = this->UnpackedBytes > 16 * MiB && this->UnpackedBytes / 1000 > packed;
  if (bomb || this->UnpackedBytes > this->Most)
  {
    throw std::invalid_argument(
      Text("The file unpacks to more than ", (bomb ? this->UnpackedBytes : this->Most) / MiB, " MB",
        bomb ? Text(" from ", packed / 1024, " kB, more than 1000 times its size.") : "."));
  }
}

std::size_t GzipBytes::UnpackInto(char* buffer, std::size_t size)
{
  std::size_t done = 0;
  while (done < size && (this->InMember || this->BeginsMember()))
  {
    if (this->Inflate.avail_in == 0 && !this->Refill())
    {
      throw std::invalid_argument("The packed file ends early: it was cut short.");
    }
    const auto room = static_cast<unsigned int>(std::min<std::size_t>(size - done, MiB));
    this->Inflate.next_out = reinterpret_cast<unsigned char*>(buffer + done);
    this->Inflate.avail_out = room;
    const int status = inflate(&this->Inflate, Z_NO_FLUSH);
    const std::size_t unpacked = room - this->Inflate.avail_out;
    this->Keep(buffer + done, unpacked);
    done += unpacked;
    this->CheckSize();
    if (status == Z_STREAM_END)
    {
      this->InMember = false;
    }
    else if (status != Z_OK && status != Z_BUF_ERROR)
    {
      throw std::invalid_argument(Text("The packed file is damaged: ",
        this->Inflate.msg ? this->Inflate.msg : "it cannot be unpacked", "."));
    }
  }
  return done;
}

void GzipBytes::Keep(const char* unpacked, std::size_t size)
{
  this->UnpackedBytes += size;
  this->At = this->UnpackedBytes;
  this->Last.append(unpacked, size);
  if (this->Last.size() > 2 * KeptBytes)
  {
    this->Last.erase(0, this->Last.size() - KeptBytes);
  }
}

std::size_t GzipBytes::Read(char* buffer, std::size_t size)
{
  const auto known =
    static_cast<std::size_t>(std::min<std::uint64_t>(size, this->UnpackedBytes - this->At));
  std::memcpy(
    buffer, this->Last.data() + this->Last.size() - (this->UnpackedBytes - this->At), known);
  this->At += known;
  return known + this->UnpackInto(buffer + known, size - known);
}

void GzipBytes::Seek(std::uint64_t offset)
{
  if (offset < this->UnpackedBytes - this->Last.size())
  {
    this->Restart();
  }
  this->At = std::min(offset, this->UnpackedBytes);
  std::array<char, 65536> passed;
  while (this->At<offset&& this->Read(passed.data(),
           static_cast<std::size_t>(std::min<std::uint64_t>(passed.size(), offset - this->At)))> 0)
  {
  }
}
}

std::unique_ptr<ByteStream> Unpack(std::unique_ptr<ByteStream> bytes, std::uint64_t mostBytes)
{
  const bool packed = ReadBytes(*bytes, 0, 2) == "\x1f\x8b";
  bytes->Seek(0);
  return packed ? std::make_unique<GzipBytes>(std::move(bytes), mostBytes) : std::move(bytes);
}
}
