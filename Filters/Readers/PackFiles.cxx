// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PackFiles.h"

#include "ruc/Base/Text.h"
#include "ruc/Formats/GzipBytes.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

std::vector<double> PackFile::Times() const
{
  return this->Frames.size() == 1 && !this->Frames[0].Time ? std::vector<double>()
                                                           : ruc::FrameTimes(this->Frames);
}

std::size_t PackFile::FrameAt(double time) const
{
  const std::vector<double> times = this->Times();
  const auto later = std::upper_bound(times.begin(), times.end(), time);
  return later == times.begin() ? 0 : static_cast<std::size_t>(later - times.begin()) - 1;
}

// The bytes of a file, unpacked. What is read from it for one frame is bounded, as a packed file
// does not tell its length.
class PackFiles::Stream : public ruc::ByteStream
{
public:
  explicit Stream(const std::string& name)
    : Bytes(ruc::Unpack(RegularFile::Open(name)))
  {
  }
  // From now on, reading more bytes throws
  void Allow(std::uint64_t most)
  {
    this->Allowed = most;
    this->Done = 0;
  }
  std::size_t Read(char* buffer, std::size_t size) override
  {
    const std::size_t read = this->Bytes->Read(buffer, size);
    this->Done += read;
    if (this->Done > this->Allowed)
    {
      throw std::invalid_argument(
        ruc::Text("a frame of at most ", static_cast<double>(this->Allowed) / 1e6,
          " MB is required, a quarter of this machine's memory, got more."));
    }
    return read;
  }
  void Seek(std::uint64_t offset) override { this->Bytes->Seek(offset); }
  std::uint64_t MostBytes() const override { return this->Bytes->MostBytes(); }

private:
  std::unique_ptr<ruc::ByteStream> Bytes;
  std::uint64_t Allowed = std::numeric_limits<std::uint64_t>::max(), Done = 0;
};

PackFiles::Stream& PackFiles::Open(const std::string& name)
{
  const RegularFile::Stamp stamp = RegularFile::FindStamp(name);
  if (!this->Current || this->CurrentName != name || this->CurrentStamp != stamp)
  {
    this->Current = std::make_shared<Stream>(name);
    this->CurrentName = name;
    this->CurrentStamp = stamp;
  }
  return *this->Current;
}

const PackFile& PackFiles::Find(
  const std::string& name, const std::string& format, const ruc::ReadSettings& settings)
{
  Stream& stream = this->Open(name);
  const std::string choice = ruc::Text(format, settings.SkipLines);
  Scanned& known = this->Known[name];
  if (!known.Format || known.Stamp != this->CurrentStamp || known.Choice != choice)
  {
    known = {};
    stream.Allow(std::numeric_limits<std::uint64_t>::max());
    const ruc::PackFormat& found = ruc::ChooseFormat(stream, format, settings);
    known.Frames = found.Scan(stream);
    known.Format = &found;
    known.Stamp = this->CurrentStamp;
    known.Choice = choice;
  }
  return known;
}

ruc::PackFrame PackFiles::Read(
  const std::string& name, std::size_t frame, ruc::ReadSettings settings)
{
  const PackFile& file = this->Known.at(name);
  const std::string folder = name.substr(0, name.find_last_of('/') + 1);
  const std::size_t point = name.find_last_of('.');
  const std::string stem =
    point == name.npos || point < folder.size() ? name : name.substr(0, point);
  settings.Beside = [folder, stem](const std::string& other)
  {
    const std::string beside = (other[0] == '.' ? stem : folder) + other;
    return RegularFile::IsReadable(beside) ? RegularFile::Read(beside) : std::string();
  };
  Stream& stream = this->Open(name);
  stream.Allow(RegularFile::MostBytes());
  return ruc::ReadFrame(*file.Format, stream, file.Frames, frame, settings);
}
