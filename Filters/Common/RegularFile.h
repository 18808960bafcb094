// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCCommonModule.h"
#include "ruc/Formats/ByteStream.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>

/** Reads files. No function waits for another process, as opening a pipe would. */
namespace RegularFile RUCCOMMON_EXPORT
{
/**
 * Returns whether the name leads to a regular file that can be opened. Its contents are not looked
 * at.
 */
bool IsReadable(const std::string& name);

/**
 * Returns the bytes of a regular file. Throws std::invalid_argument if the name leads to anything
 * else, if the file has more bytes than a quarter of the machine's memory, and if reading fails;
 * the message is the end of a sentence that begins with the file's name.
 *
 * The limit is a quarter because the spheres of a text take about three times its bytes: a row of
 * four short numbers has 30 bytes, a sphere has 48, and its point with its arrays has 56. The size
 * is looked at before anything is allocated.
 */
std::string Read(const std::string& name);

/** Returns the number of bytes up to which Read takes a file. */
std::uint64_t MostBytes();

/** What tells whether a file is still the same: device, number, bytes, and date of its change. */
using Stamp = std::array<std::int64_t, 5>;

/** Returns the stamp of a file, or zeros if there is no such file. */
Stamp FindStamp(const std::string& name);

/**
 * Opens a regular file of any size, whose bytes are then read as they are asked for. Throws as Read
 * does but for the size.
 */
std::unique_ptr<ruc::ByteStream> Open(const std::string& name);
}
