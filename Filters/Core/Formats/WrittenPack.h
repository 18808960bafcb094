// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Formats/FramePack.h"

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>

namespace ruc
{
/** What a format asks for that a pack does not have. */
struct WriteSettings
{
  /** The density of the spheres, in files that hold one; finite and > 0. */
  double Density = 1.0;
  /** The number of the frame in its file, from 0, where its time is no number of a step. */
  std::int64_t Frame = 0;
};

/** The bytes of a pack in a format. */
struct WrittenPack
{
  std::string Bytes;
  /** The bytes of a file of the same name with the extension .nfo beside it, where there is one. */
  std::string Info;
  /** Whether they tell the unit of length of the pack. */
  bool HoldLengthUnit = false;
};

/** How a format is written. */
struct PackWriter
{
  /**
   * Writes spheres in the order of the pack with all digits, so that reading gives the same bits.
   * The pack has a type for each sphere or none, and ids that are told apart.
   */
  WrittenPack (*Write)(const FramePack& pack, const WriteSettings& settings) = nullptr;
  /** The extensions of its files, with blanks between. */
  const char* Extensions = "";
  /** Whether a file may hold several packs, one after the other. */
  bool HoldsFrames = false;
};

// What the formats have in common when they write

/** Appends a number with 17 digits, so that reading gives the same bits, whatever the locale. */
void AppendNumber(std::string& text, double value);
/** The same by a stream, which is slower, for standard libraries without to_chars of a double. */
void AppendNumberByStream(std::string& text, double value);
/** Appends numbers with blanks between. */
void AppendNumbers(std::string& text, std::initializer_list<double> values);

/** Returns the type of a sphere, which is 1 where the pack has no types. */
int TypeOf(const FramePack& pack, std::size_t i);

/**
 * Ids and types as LAMMPS and LIGGGHTS take them: from 1. If any is smaller, all are raised alike.
 */
struct LammpsNumbers
{
  explicit LammpsNumbers(const FramePack& pack);
  /** Returns "id type " of a sphere. */
  std::string Of(const FramePack& pack, std::size_t i) const;

  std::int64_t AddedToId = 0, AddedToType = 0;
};

/** Returns the box of the pack, or the bounds of its spheres if it has none. */
Window BoxOrBounds(const FramePack& pack);
}
