// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Base/SealedBytes.h"

#include "ruc/Base/Bytes.h"

#include <stdexcept>
#include <utility>

namespace ruc
{
std::uint64_t FingerprintOfBytes(std::string_view bytes)
{
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (unsigned char byte : bytes)
  {
    hash = (hash ^ byte) * 0x100000001b3u;
  }
  return hash;
}

std::string SealBytes(std::string_view format, std::uint32_t version, const std::string& body)
{
  ByteWriter writer;
  writer.Bytes = format;
  writer.Put(version);
  writer.Put(body); // writes its length first
  writer.Put(FingerprintOfBytes(writer.Bytes));
  return std::move(writer.Bytes);
}

std::string_view UnsealBytes(
  std::string_view bytes, std::string_view format, std::uint32_t version, const char* what)
{
  constexpr const char* name = "checkpoint";
  const std::size_t head = format.size() + sizeof(std::uint32_t) + sizeof(std::uint64_t);
  const std::string_view start = bytes.substr(0, format.size());
  if (bytes.empty() || start != format.substr(0, start.size()))
  {
    throw std::invalid_argument(Text("These bytes are no checkpoint of ", what, "."));
  }
  const auto truncated = [&](const std::string& expected)
  {
    throw std::invalid_argument(
      Text("The checkpoint is truncated: ", bytes.size(), " bytes of ", expected, "."));
  };
  if (bytes.size() < head)
  {
    truncated("at least " + std::to_string(head));
  }
  ByteReader reader(bytes.substr(format.size()), name);
  const auto found = reader.Get<std::uint32_t>();
  const auto length = reader.Get<std::uint64_t>();
  if (found != version)
  {
    throw std::invalid_argument(
      Text("The checkpoint is of version ", found, ", this program reads version ", version, "."));
  }
  const std::uint64_t rest = bytes.size() - head;
  constexpr std::size_t tail = sizeof(std::uint64_t);
  if (rest < tail || rest - tail < length)
  {
    truncated(Text(head + tail, " + ", length));
  }
  ByteReader last(bytes.substr(bytes.size() - tail), name);
  if (rest - tail > length ||
    last.Get<std::uint64_t>() != FingerprintOfBytes(bytes.substr(0, bytes.size() - tail)))
  {
    throw std::invalid_argument("The checkpoint is damaged: its checksum does not fit.");
  }
  return bytes.substr(head, length);
}
}
