// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RegularFile.h"
#include "ruc/Formats/BoundedBytes.h"
#include "ruc/Formats/PackFormats.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

/** What is known of a file of sphere packs: its format and where its frames are. */
struct PackFile
{
  const ruc::PackFormat* Format = nullptr;
  std::vector<ruc::FramePlace> Frames;

  /** Returns the times of the frames; none if there is one frame that does not tell its time. */
  std::vector<double> Times() const;
  /** Returns the last frame that is not later than `time`, or the first one. */
  std::size_t FrameAt(double time) const;
};

/**
 * The files of one reader. Each is scanned once for its frames, and again only if its size, its
 * date, or what the user says about it has changed. The file that was read last stays open, so that
 * the frames of a packed one are unpacked one after the other.
 *
 * Whatever is wrong throws std::invalid_argument.
 */
class PackFiles
{
public:
  /** Returns what is known of the file; `format` is as in ruc::ChooseFormat. */
  const PackFile& Find(
    const std::string& name, const std::string& format, const ruc::ReadSettings& settings);

  /**
   * Reads a frame, counted from 0, of a file that Find has returned. Refuses a frame of more bytes
   * than RegularFile::MostBytes.
   */
  ruc::PackFrame Read(const std::string& name, std::size_t frame, ruc::ReadSettings settings);

private:
  struct Scanned : PackFile
  {
    RegularFile::Stamp Stamp{};
    std::string Choice; // format and skipped lines, as the user set them
  };
  ruc::BoundedBytes& Open(const std::string& name);

  std::map<std::string, Scanned> Known;
  std::shared_ptr<ruc::BoundedBytes> Current;
  std::string CurrentName;
  RegularFile::Stamp CurrentStamp{};
};
