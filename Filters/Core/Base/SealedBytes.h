// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace ruc
{
/** Returns the FNV-1a-64 fingerprint of bytes. */
std::uint64_t FingerprintOfBytes(std::string_view bytes);

/**
 * Returns bytes that a later run of the program tells from others and from damaged ones, with all
 * numbers in the byte order of the machine: the name of the format, of eight letters; its version
 * (32 bits); the length of the body (64 bits); the body; and the fingerprint of everything before
 * (64 bits).
 */
std::string SealBytes(std::string_view format, std::uint32_t version, const std::string& body);

/**
 * Returns the body of bytes that SealBytes made, within them. Throws std::invalid_argument that
 * says that they are no checkpoint of `what`, such as "a search", are of another version, truncated
 * or damaged.
 */
std::string_view UnsealBytes(
  std::string_view bytes, std::string_view format, std::uint32_t version, const char* what);
}
