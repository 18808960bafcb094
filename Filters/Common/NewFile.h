// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCCommonModule.h"

#include <cstdint>
#include <string>
#include <string_view>

/**
 * A file that is not seen before it is whole. Its bytes go to a file of its own beside it, whose
 * name is NAME.new- and a number that no file has yet, so that no file of somebody else is written
 * to, nor one that a link leads to. Once they are on the disk, it takes the place of NAME; whatever
 * happens before, an old file of that name remains. A program that is killed while it writes may
 * leave such a file behind.
 *
 * What fails throws std::invalid_argument, such as "cannot write 'a.new-7-0': No space left on
 * device", and leaves no file behind.
 */
class RUCCOMMON_EXPORT NewFile
{
public:
  /** Throws if NAME is there and is neither a regular file nor a link, which would be replaced. */
  explicit NewFile(std::string name);
  ~NewFile();
  NewFile(const NewFile&) = delete;
  void operator=(const NewFile&) = delete;

  void Append(std::string_view bytes);
  /** Makes the file so many bytes long, for others to write at their places (PartOfNewFile). */
  void Lengthen(std::uint64_t bytes);
  /** The name under which the bytes are written. */
  const std::string& FreshName() const { return this->Fresh; }
  /** Puts the file in its place. */
  void Keep();

private:
  std::string Name, Fresh;
  int Number = -1;
};

/** The file of a NewFile of another rank, into which this one writes its part. Throws as NewFile
 * does. */
class RUCCOMMON_EXPORT PartOfNewFile
{
public:
  /** `freshName` is NewFile::FreshName. */
  explicit PartOfNewFile(const std::string& freshName);
  ~PartOfNewFile();
  PartOfNewFile(const PartOfNewFile&) = delete;
  void operator=(const PartOfNewFile&) = delete;

  void WriteAt(std::uint64_t offset, std::string_view bytes);
  /** Returns once all bytes are on the disk. */
  void Finish();

private:
  std::string Fresh;
  int Number = -1;
};
