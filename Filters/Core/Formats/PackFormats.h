// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/**
 * @file
 * Packs as other programs write them. A reader that has a file as a ByteStream, packed by gzip or
 * not, goes this way:
 *
 *   std::unique_ptr<ByteStream> bytes = Unpack(std::make_unique<FileOfReader>(name), memoryLimit);
 *   const PackFormat* format = FindFormat(*bytes);           // by content; nullptr: none
 *   std::vector<FramePlace> frames = format->Scan(*bytes);   // once, one pass; keep these
 *   std::vector<double> times = FrameTimes(frames);          // TIME_STEPS
 *   PackFrame frame = ReadFrame(*format, *bytes, frames, n, readSettings);
 *   FramePack result = MakePack(std::move(frame), packSettings); // FramePack.h
 *   // result.Pack, result.Type, result.Box; the box is the window where result.BoxIsWindow
 *
 * Whatever is wrong is a std::invalid_argument that says where, what is required, and what was got;
 * the reader puts the file's name in front.
 */

#include "ruc/Formats/ByteStream.h"
#include "ruc/Formats/PackFrame.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ruc
{
/** Where a frame begins, and what was seen on the way there. */
struct FramePlace
{
  /** Its first byte, or its number where the format has an index of its own. */
  std::uint64_t Offset = 0;
  std::size_t LinesBefore = 0;
  std::optional<double> Time; // or the step
  std::string LengthUnit;     // told by an earlier frame
};

/** What the reader's user may say about a file. */
struct ReadSettings
{
  /** Of tables: names of the columns, such as "id,x,y,z,r", where - skips one; empty: as the file
   * tells. */
  std::string Columns;
  /** Of tables: name or 1-based number of the column of radii; empty: found by name. */
  std::string RadiusColumn;
  /** Of tables: the radius column holds diameters. */
  bool RadiusIsDiameter = false;
  /** Of tables: lines at the start that are passed over unread. */
  int SkipLines = 0;
  /** The text of a file of that name in the folder of this one, empty where there is none. */
  std::function<std::string(const std::string& name)> Beside;
};

/** A format: its grammar is in the file of Grammars that is named as it. */
struct PackFormat
{
  const char* Name;
  /** Whether bytes from the start of a file, up to 4 KiB of them, have the sign of this format. */
  bool (*Recognise)(std::string_view begin);
  /** Where the frames are. A frame that is wrong, or cut short, is the last one that is found; it
   * is refused when it is read, and those before it can be used. At least one. */
  std::vector<FramePlace> (*Scan)(ByteStream& bytes);
  /** Reads the spheres of one frame. */
  PackFrame (*Read)(ByteStream& bytes, const FramePlace& place, const ReadSettings& settings);
};

/** All formats, in the order in which they are asked whether they recognise a file. */
const std::vector<const PackFormat*>& PackFormats();

/** The first that recognises the file; nullptr where none does. */
const PackFormat* FindFormat(ByteStream& bytes);

/** Reads the n-th frame, from 0, and throws std::invalid_argument that names it where there are
 * several. */
PackFrame ReadFrame(const PackFormat& format, ByteStream& bytes,
  const std::vector<FramePlace>& frames, std::size_t n, const ReadSettings& settings);

/** The times of the frames; where not all have one, or they do not rise, their numbers from 0. */
std::vector<double> FrameTimes(const std::vector<FramePlace>& frames);
}
