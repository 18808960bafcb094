// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Require.h"
#include "ruc/Images/VoxelGrid.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace ruc
{
/**
 * Other values for those of voxels, from a text such as "0=1; 1-9=0": 1 in place of 0, and 0 in
 * place of all from 1 to 9. Where a value is in several ranges the first counts, and a value that
 * is in none stays as it is.
 */
class ValueMap
{
public:
  /** Throws std::invalid_argument for a text that is not of that form. */
  explicit ValueMap(const std::string& text);

  bool IsEmpty() const { return this->Entries.empty(); }
  double Map(double value) const;

  /**
   * Throws std::invalid_argument, which names the type, unless numbers of this type hold all the
   * other values.
   */
  template <class Number>
  void RequireHeld(const std::string& type) const
  {
    for (const Entry& entry : this->Entries)
    {
      const double value = entry.Value;
      // Compared as doubles, since a number out of range has no value of the type
      const bool held = !std::is_integral_v<Number> ||
        (value >= static_cast<double>(std::numeric_limits<Number>::lowest()) &&
          value <= static_cast<double>(std::numeric_limits<Number>::max()) &&
          value < 9007199254740992.0 && value == static_cast<double>(static_cast<Number>(value)));
      Require(held, "Values", "numbers of the type of the image, which is " + type, value);
    }
  }

private:
  struct Entry
  {
    double Low, High, Value;
  };
  std::vector<Entry> Entries;
};

/** The forms of the text before the voxels. */
enum class RawHeader
{
  MetaImage,
  AmitexVtk,
  None
};

/** An image as its file describes it. */
struct RawImage
{
  RawHeader Header = RawHeader::None;
  VoxelGrid Grid;
  std::string Name;    // of what the voxels tell
  bool Integer = true; // whether the numbers are integers, else floating-point numbers
  bool Signed = false; // whether integers may be negative
  std::size_t BytesOfNumber = 1;
  bool BigEndian = false; // that of AMITEX VTK is always so
  /** The file of the voxels where that is another one, of MetaImage alone. */
  std::string DataFile;

  bool IsBigEndian() const { return this->BigEndian || this->Header == RawHeader::AmitexVtk; }
};

/**
 * Returns the text before the voxels. That of MetaImage tells the centre of the first voxel. That
 * of AMITEX_FFTP has the ten lines that its reader wants, in their order
 * (https://amitexfftp.github.io/AMITEX/user_guide/input_files.html); they are a legacy VTK file,
 * too.
 */
std::string WriteHeader(const RawImage& image);

/** Whether this machine puts the high byte of a number first. */
bool IsBigEndianHere();

/** Appends numbers, mapped, and with their bytes turned round if `turned`. */
template <class Number>
void AppendNumbers(
  const Number* numbers, std::size_t count, const ValueMap& map, bool turned, std::string& bytes)
{
  const std::size_t begin = bytes.size();
  bytes.resize(begin + count * sizeof(Number));
  char* to = bytes.data() + begin;
  for (std::size_t n = 0; n < count; ++n, to += sizeof(Number))
  {
    const Number number =
      map.IsEmpty() ? numbers[n] : static_cast<Number>(map.Map(static_cast<double>(numbers[n])));
    std::memcpy(to, &number, sizeof number);
    if (turned)
    {
      std::reverse(to, to + sizeof number);
    }
  }
}
}
