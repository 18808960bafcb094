// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PackFiles.h"

#include "ruc/Base/Text.h"
#include "ruc/Formats/GzipBytes.h"

#include <algorithm>

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

ruc::BoundedBytes& PackFiles::Open(const std::string& name)
{
  const RegularFile::Stamp stamp = RegularFile::FindStamp(name);
  if (!this->Current || this->CurrentName != name || this->CurrentStamp != stamp)
  {
    this->Current = std::make_shared<ruc::BoundedBytes>(ruc::Unpack(RegularFile::Open(name)));
    this->CurrentName = name;
    this->CurrentStamp = stamp;
  }
  return *this->Current;
}

const PackFile& PackFiles::Find(
  const std::string& name, const std::string& format, const ruc::ReadSettings& settings)
{
  ruc::BoundedBytes& stream = this->Open(name);
  const std::string choice = ruc::Text(format, settings.SkipLines);
  Scanned& known = this->Known[name];
  if (!known.Format || known.Stamp != this->CurrentStamp || known.Choice != choice)
  {
    known = {};
    stream.AllowAll();
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
  ruc::BoundedBytes& stream = this->Open(name);
  stream.Allow(RegularFile::MostBytes(), "a quarter of this machine's memory");
  return ruc::ReadFrame(*file.Format, stream, file.Frames, frame, settings);
}
