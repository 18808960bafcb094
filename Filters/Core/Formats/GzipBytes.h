// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Formats/ByteStream.h"

#include <limits>
#include <memory>

namespace ruc
{
/**
 * Returns the stream itself, or what it unpacks to if its first bytes are those of gzip (one member
 * or several). Bytes are unpacked as they are read. The last MiB is kept, so that whoever has read
 * ahead can go back to where the next frame begins; going back farther begins again at the start.
 *
 * Reading throws std::invalid_argument if the packed bytes are damaged or end early, and if they
 * unpack to more than `mostBytes` or, from 16 MiB on, to more than a thousand times their number:
 * texts do not, but files made to fill the memory do.
 */
std::unique_ptr<ByteStream> Unpack(std::unique_ptr<ByteStream> bytes,
  std::uint64_t mostBytes = std::numeric_limits<std::uint64_t>::max());
}
