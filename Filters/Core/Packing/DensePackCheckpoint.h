// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Packing/DensePack.h"

#include <string>
#include <string_view>

namespace ruc
{
/**
 * @file
 * The state of a dense pack as bytes, from which MakeDensePack goes on: sealed (SealBytes) as
 * "RUCDENSE" of version 2, the fingerprint of the settings (64 bits) and the state as Base/Bytes.h
 * writes it.
 */

/** What it takes at the most to keep and write a state, for each sphere. */
constexpr double MostBytesOfCheckpoint = 5000.0;

std::string WriteCheckpoint(const DensePackState& state, const DensePackSettings& settings);

/**
 * Reads what WriteCheckpoint wrote. Throws std::invalid_argument that says what is wrong with the
 * bytes: that they are no checkpoint of a pack, are of another version, truncated or damaged, hold
 * what cannot be, or are of a pack with other settings.
 */
DensePackState ReadDensePackCheckpoint(std::string_view bytes, const DensePackSettings& settings);
}
