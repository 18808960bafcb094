// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/**
 * @file
 * Packs as other programs write them. A reader that has a file as a ByteStream, packed by gzip or
 * not, goes this way:
 *
 *   std::unique_ptr<ByteStream> bytes = Unpack(std::make_unique<FileOfReader>(name), memoryLimit);
 *   const PackFormat& format = ChooseFormat(*bytes, name, readSettings); // by content, or by name
 *   std::vector<FramePlace> frames = format.Scan(*bytes);    // once, one pass; keep these
 *   std::vector<double> times = FrameTimes(frames);          // TIME_STEPS
 *   PackFrame frame = ReadFrame(format, *bytes, frames, n, readSettings);
 *   FramePack result = MakePack(std::move(frame), packSettings); // FramePack.h
 *   // result.Pack, result.Type, result.Box; the box is the window where result.BoxIsWindow
 *
 * Whatever is wrong throws std::invalid_argument that says where it is, what is required, and what
 * was got. The reader puts the file's name in front. For bytes in memory ReadPack does it all.
 */

#include "ruc/Formats/ByteStream.h"
#include "ruc/Formats/FramePack.h"
#include "ruc/Formats/PackFrame.h"
#include "ruc/Formats/WrittenPack.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ruc
{
/** Where a frame begins, and what was found before it. */
struct FramePlace
{
  /** The place of its first byte, or its number if the format has an index of its own. */
  std::uint64_t Offset = 0;
  std::size_t LinesBefore = 0;
  std::optional<double> Time; // or the step
  std::string LengthUnit;     // told by an earlier frame
};

/** What the user of the reader may say about a file. */
struct ReadSettings
{
  /**
   * For tables: the names of the columns, such as "id,x,y,z,r", where - skips one. Empty means as
   * the file tells.
   */
  std::string Columns;
  /**
   * For tables: the name, or the number counted from 1, of the column with the radius. Empty means
   * that it is found by name.
   */
  std::string RadiusColumn;
  /** For tables: whether that column holds diameters. */
  bool RadiusIsDiameter = false;
  /** For tables: the number of lines at the start that are passed over unread. */
  int SkipLines = 0;
  /**
   * Returns the text of the file of that name in the folder of this one, or nothing if there is
   * none. An extension, such as ".nfo", stands for the name of this file with that extension.
   */
  std::function<std::string(const std::string& name)> Beside;
};

/** A format. Its grammar is in the file of Grammars that has its name. */
struct PackFormat
{
  const char* Name;
  /**
   * Returns whether the bytes from the start of a file, at most 4 KiB, have the sign of this
   * format.
   */
  bool (*Recognise)(std::string_view begin);
  /**
   * Returns where the frames are; there is at least one. A frame that is wrong or cut short is the
   * last one found: it is refused when it is read, and those before it can be used.
   */
  std::vector<FramePlace> (*Scan)(ByteStream& bytes);
  /** Reads the spheres of one frame. */
  PackFrame (*Read)(ByteStream& bytes, const FramePlace& place, const ReadSettings& settings);
  /** How it is written; not all formats are. */
  PackWriter Writer = {};
};

/** Returns all formats, in the order in which they are asked whether they recognise a file. */
const std::vector<const PackFormat*>& PackFormats();

/** Returns the first format that recognises the file, or nullptr, as for files of VTK. */
const PackFormat* FindFormat(ByteStream& bytes);

/** The name that stands for FindFormat in ChooseFormat. */
constexpr const char* AutomaticFormat = "Automatic";

/**
 * Returns the format of that name. For AutomaticFormat it is the one that recognises the file; but
 * it is a table if lines are to be skipped, and for any other text, whose refusal then tells what
 * a table lacks.
 *
 * Throws std::invalid_argument, with the names of all formats, for another name and for a file of
 * bytes that no format recognises; and for files of VTK, which ParaView reads itself.
 */
const PackFormat& ChooseFormat(
  ByteStream& bytes, std::string_view name, const ReadSettings& settings);

/**
 * Reads the n-th frame, counted from 0. Throws std::invalid_argument, which names the frame if
 * there are several.
 */
PackFrame ReadFrame(const PackFormat& format, ByteStream& bytes,
  const std::vector<FramePlace>& frames, std::size_t n, const ReadSettings& settings);

/**
 * Returns the times of the frames. If not all have one, or they do not rise, these are their
 * numbers from 0.
 */
std::vector<double> FrameTimes(const std::vector<FramePlace>& frames);

/** Returns the first frame of the bytes of a file, whose format is told by its contents. */
FramePack ReadPack(std::string_view bytes);

/**
 * Returns the format that is written to files with that extension, in upper or lower case. Throws
 * std::invalid_argument, which lists the extensions, if there is none.
 */
const PackFormat& FormatOfExtension(std::string_view extension);

/**
 * Returns the bytes of a pack in a format that is written. Throws std::invalid_argument if the pack
 * is empty, if the density is not finite and > 0, and if the format asks for a box that the pack
 * does not have.
 */
WrittenPack WritePack(
  const PackFormat& format, const FramePack& pack, const WriteSettings& settings);
}
