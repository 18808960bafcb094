// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/**
 * @file
 * Files and texts as the formats see them: what a reader does, in a few lines.
 */

#include "ruc/Formats/FramePack.h"
#include "ruc/Formats/GzipBytes.h"
#include "ruc/Formats/PackFormats.h"

#include "Oracles.h"

#include <cstdlib>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace formats
{
/** A file as bytes. */
class FileBytes : public ruc::ByteStream
{
public:
  explicit FileBytes(const std::string& name)
    : File(name, std::ios::binary | std::ios::ate)
  {
    EXPECT_TRUE(this->File.good()) << name;
    this->Size = static_cast<std::uint64_t>(this->File.tellg());
    this->File.seekg(0);
  }
  std::size_t Read(char* buffer, std::size_t size) override
  {
    this->File.read(buffer, static_cast<std::streamsize>(size));
    return static_cast<std::size_t>(this->File.gcount());
  }
  void Seek(std::uint64_t offset) override
  {
    this->File.clear();
    this->File.seekg(static_cast<std::streamoff>(offset));
  }
  std::uint64_t MostBytes() const override { return this->Size; }

private:
  std::ifstream File;
  std::uint64_t Size;
};

inline std::string TextOf(const std::string& name)
{
  std::ifstream file(name, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return file ? text.str() : std::string();
}

/** The whole way of a file or text: format by content, frames, one frame as a pack. */
class Opened
{
public:
  explicit Opened(std::unique_ptr<ruc::ByteStream> bytes, const ruc::ReadSettings& settings = {})
    : Bytes(ruc::Unpack(std::move(bytes)))
    , Settings(settings)
  {
    this->Format = &ruc::ChooseFormat(*this->Bytes, ruc::AutomaticFormat, settings);
    this->Frames = this->Format->Scan(*this->Bytes);
  }
  ruc::PackFrame Frame(std::size_t n = 0)
  {
    return ruc::ReadFrame(*this->Format, *this->Bytes, this->Frames, n, this->Settings);
  }
  ruc::FramePack Pack(std::size_t n = 0, const ruc::PackSettings& settings = {})
  {
    return ruc::MakePack(this->Frame(n), settings);
  }

  std::unique_ptr<ruc::ByteStream> Bytes;
  ruc::ReadSettings Settings;
  const ruc::PackFormat* Format = nullptr;
  std::vector<ruc::FramePlace> Frames;
};

struct HeldText
{
  std::string Text;
};

/** A text that it keeps. */
class TextBytes
  : private HeldText
  , public ruc::MemoryBytes
{
public:
  explicit TextBytes(std::string_view text)
    : HeldText{ std::string(text) }
    , ruc::MemoryBytes(HeldText::Text)
  {
  }
};

inline Opened OpenText(std::string_view text, const ruc::ReadSettings& settings = {})
{
  return Opened(std::make_unique<TextBytes>(text), settings);
}

/** With the files beside it. */
inline Opened OpenFile(const std::string& name)
{
  ruc::ReadSettings settings;
  const std::string folder = name.substr(0, name.find_last_of('/') + 1);
  settings.Beside = [folder](const std::string& beside) { return TextOf(folder + beside); };
  return Opened(std::make_unique<FileBytes>(name), settings);
}

/** A file of this project. */
inline std::string DataFile(const std::string& name)
{
  return std::string(RUC_TEST_DATA "/formats/") + name;
}
}
