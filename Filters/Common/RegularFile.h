// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCCommonModule.h"

#include <string>

/** Files that are read whole. Neither function waits for anybody, as opening a pipe would. */
namespace RegularFile RUCCOMMON_EXPORT
{
/** Whether the name leads to a regular file that can be opened; its contents are not looked at. */
bool IsReadable(const std::string& name);

/**
 * The bytes of a regular file. Throws std::invalid_argument, with the end of a sentence that begins
 * with the file's name, for whatever else the name leads to, for a file of more bytes than a
 * quarter of the machine's memory, and where reading fails.
 *
 * A quarter, because the spheres of a text take about three times its bytes: a row of four short
 * numbers has 30, a sphere 48 and its point with its arrays 56. The size is looked at before
 * anything is allocated.
 */
std::string Read(const std::string& name);
}
