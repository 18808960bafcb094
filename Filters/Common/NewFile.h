// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCCommonModule.h"

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
  /** Puts the file in its place. */
  void Keep();

private:
  [[noreturn]] void Fail(int error);

  std::string Name, Fresh;
  int Number = -1;
};
