// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/**
 * @file
 * Values as bytes: the one form in which they go from rank to rank and into checkpoints. No byte
 * order is converted, so only processes on machines of one kind understand each other.
 *
 * Numbers, bool, enums, std::string, std::vector and std::array of such values, and structs can be
 * written. A struct says once which fields it has, beside their declaration:
 *
 *     template <class Self>
 *     static auto Fields(Self& self)
 *     {
 *       return std::tie(self.First, self.Second);
 *     }
 *
 * The values of an enum begin at 0. How many there are is said beside its declaration, so that no
 * other value is ever read:
 *
 *     constexpr int CountOf(Colour) { return 3; }
 */

#include "ruc/Base/Text.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace ruc
{
/**
 * Whether the bytes of a value can be copied as they stand, which holds where every pattern of bits
 * is a value.
 */
template <class Value>
struct IsPlain : std::bool_constant<std::is_arithmetic_v<Value> && !std::is_same_v<Value, bool>>
{
};
template <class Value, std::size_t Size>
struct IsPlain<std::array<Value, Size>> : IsPlain<Value>
{
};

/** Appends values to `Bytes`. */
class ByteWriter
{
public:
  template <class Value>
  void Put(const Value& value)
  {
    if constexpr (IsPlain<Value>::value)
    {
      this->Bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    else if constexpr (std::is_same_v<Value, bool> || std::is_enum_v<Value>)
    {
      this->Put(static_cast<std::uint8_t>(value));
    }
    else
    {
      std::apply([&](const auto&... field) { (this->Put(field), ...); }, Value::Fields(value));
    }
  }
  template <class Value, std::size_t Size>
  void Put(const std::array<Value, Size>& values)
  {
    for (const Value& value : values)
    {
      this->Put(value);
    }
  }
  template <class Value>
  void Put(const std::vector<Value>& values)
  {
    this->Put<std::uint64_t>(values.size());
    if constexpr (IsPlain<Value>::value)
    {
      this->Bytes.append(
        reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value));
    }
    else
    {
      for (const Value& value : values)
      {
        this->Put(value);
      }
    }
  }
  void Put(const std::string& text)
  {
    this->Put<std::uint64_t>(text.size());
    this->Bytes += text;
  }

  std::string Bytes;
};

/**
 * Takes values from bytes in the order in which they were put.
 *
 * Throws std::invalid_argument, such as "The checkpoint is damaged: its lengths do not fit.", where
 * the bytes end too early or are left over, and "… it holds a value that cannot be." where a bool
 * or an enum would get a value that it does not have.
 */
class ByteReader
{
public:
  /** `what` names the bytes in messages. The bytes must outlive the reader. */
  explicit ByteReader(std::string_view bytes, std::string what = "message between ranks")
    : Rest(bytes)
    , What(std::move(what))
  {
  }

  template <class Value>
  void Get(Value& value)
  {
    if constexpr (IsPlain<Value>::value)
    {
      std::memcpy(&value, this->Take(sizeof value).data(), sizeof value);
    }
    else if constexpr (std::is_same_v<Value, bool>)
    {
      value = this->GetBelow(2) != 0;
    }
    else if constexpr (std::is_enum_v<Value>)
    {
      value = static_cast<Value>(this->GetBelow(CountOf(Value())));
    }
    else
    {
      std::apply([&](auto&... field) { (this->Get(field), ...); }, Value::Fields(value));
    }
  }
  template <class Value, std::size_t Size>
  void Get(std::array<Value, Size>& values)
  {
    for (Value& value : values)
    {
      this->Get(value);
    }
  }
  template <class Value>
  void Get(std::vector<Value>& values)
  {
    const std::uint64_t size = this->Get<std::uint64_t>();
    values.clear();
    if constexpr (IsPlain<Value>::value)
    {
      this->Require(size <= this->Rest.size() / sizeof(Value), WrongLengths);
      const std::string_view bytes = this->Take(size * sizeof(Value));
      values.resize(size);
      if (size > 0)
      {
        std::memcpy(values.data(), bytes.data(), bytes.size());
      }
    }
    else
    {
      // One by one, so that a forged size takes no more memory than the bytes account for
      this->Require(size <= this->Rest.size(), WrongLengths);
      for (std::uint64_t n = 0; n < size; ++n)
      {
        this->Get(values.emplace_back());
      }
    }
  }
  void Get(std::string& text)
  {
    const std::uint64_t size = this->Get<std::uint64_t>();
    this->Require(size <= this->Rest.size(), WrongLengths);
    text = this->Take(size);
  }
  template <class Value>
  Value Get()
  {
    Value value{};
    this->Get(value);
    return value;
  }

  /** The next `size` bytes as they are. */
  std::string_view Take(std::size_t size)
  {
    this->Require(size <= this->Rest.size(), WrongLengths);
    const std::string_view taken = this->Rest.substr(0, size);
    this->Rest.remove_prefix(size);
    return taken;
  }

  /** Throws std::invalid_argument where bytes are left. It is called after the last value. */
  void Finish() const { this->Require(this->Rest.empty(), WrongLengths); }

private:
  static constexpr const char* WrongLengths = "its lengths do not fit";

  void Require(bool good, const char* fault) const
  {
    if (!good)
    {
      throw std::invalid_argument(Text("The ", this->What, " is damaged: ", fault, "."));
    }
  }
  std::uint8_t GetBelow(int count)
  {
    const auto byte = this->Get<std::uint8_t>();
    this->Require(byte < count, "it holds a value that cannot be");
    return byte;
  }

  std::string_view Rest;
  std::string What;
};

/** Returns a value as bytes. */
template <class Value>
std::string ToBytes(const Value& value)
{
  ByteWriter writer;
  writer.Put(value);
  return std::move(writer.Bytes);
}

/** Sets a value to the one from which ToBytes made these bytes. */
template <class Value>
void FromBytes(std::string_view bytes, Value& value)
{
  ByteReader reader(bytes);
  reader.Get(value);
  reader.Finish();
}
}
