// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Images/RawImage.h"

#include "ruc/Base/ParseDouble.h"

#include <cmath>
#include <cstdint>
#include <iomanip>
#include <iterator>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace ruc
{
namespace
{
constexpr const char* Form = "values and others in their place, such as 0=1; 1-9=0";

bool ReadFinite(std::string_view text, double& number)
{
  return ParseDouble(text, number) && std::isfinite(number);
}

// Reads "3" or "1-9", both of which may have signs
bool ReadRange(std::string_view text, double& low, double& high)
{
  if (ReadFinite(text, low))
  {
    high = low;
    return true;
  }
  for (std::size_t dash = text.find('-', 1); dash != std::string_view::npos;
       dash = text.find('-', dash + 1))
  {
    if (ReadFinite(text.substr(0, dash), low) && ReadFinite(text.substr(dash + 1), high))
    {
      return low <= high;
    }
  }
  return false;
}

std::string WithoutBlanks(const std::string& text)
{
  std::string kept;
  std::copy_if(text.begin(), text.end(), std::back_inserter(kept),
    [](char c) { return c != ' ' && c != '\t'; });
  return kept;
}

// Numbers with all digits, whatever the locale
std::string Numbers(const char* between, const Vector3& v)
{
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream << std::setprecision(17) << v[0] << between << v[1] << between << v[2];
  return stream.str();
}

// The place of a number of 1, 2, 4 or 8 bytes in a list of their names
int SizeOf(const RawImage& image)
{
  return image.BytesOfNumber == 1 ? 0
    : image.BytesOfNumber == 2    ? 1
    : image.BytesOfNumber == 4    ? 2
                                  : 3;
}

std::string MetaType(const RawImage& image)
{
  if (!image.Integer)
  {
    return image.BytesOfNumber == 4 ? "MET_FLOAT" : "MET_DOUBLE";
  }
  const char* names[] = { "CHAR", "SHORT", "INT", "LONG_LONG" };
  return Text("MET_", image.Signed ? "" : "U", names[SizeOf(image)]);
}

std::string WriteMetaImage(const RawImage& image)
{
  const auto& n = image.Grid.Dimensions;
  return Text("ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = ",
    image.BigEndian ? "True" : "False",
    "\nCompressedData = False\nTransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = ",
    Numbers(" ", image.Grid.CentreOf(0, 0, 0)),
    "\nElementSpacing = ", Numbers(" ", image.Grid.Spacing), "\nDimSize = ", n[0], " ", n[1], " ",
    n[2], "\nElementType = ", MetaType(image),
    "\nElementDataFile = ", image.DataFile.empty() ? "LOCAL" : image.DataFile, "\n");
}

std::string VtkType(const RawImage& image)
{
  if (!image.Integer)
  {
    return image.BytesOfNumber == 4 ? "float" : "double";
  }
  const char* names[] = { "char", "short", "int", "long" };
  return Text(image.Signed ? "" : "unsigned_", names[SizeOf(image)]);
}

std::string WriteAmitexVtk(const RawImage& image)
{
  const auto& n = image.Grid.Dimensions;
  std::string name = image.Name.empty() ? "MaterialId" : image.Name;
  std::replace_if(
    name.begin(), name.end(), [](char c) { return c == ' ' || c == '\t' || c == '\n'; }, '_');
  // Dimensions are those of the corners, and the voxels are cells
  return Text("# vtk DataFile Version 4.5\n", name,
    "\nBINARY\nDATASET STRUCTURED_POINTS\nDIMENSIONS    ", std::int64_t(n[0]) + 1, "   ",
    std::int64_t(n[1]) + 1, "   ", std::int64_t(n[2]) + 1, "\nORIGIN    ",
    Numbers("   ", image.Grid.Lower), "\nSPACING    ", Numbers("   ", image.Grid.Spacing),
    "\nCELL_DATA   ", std::int64_t(n[0]) * n[1] * n[2], "\nSCALARS ", name, " ", VtkType(image),
    "\nLOOKUP_TABLE default\n");
}
}

ValueMap::ValueMap(const std::string& text)
{
  std::istringstream entries(WithoutBlanks(text));
  for (std::string entry; std::getline(entries, entry, ';');)
  {
    if (entry.empty())
    {
      continue;
    }
    const std::size_t sign = std::min(entry.find('='), entry.size());
    const std::string_view view = entry;
    Entry read{};
    Require(sign + 1 < entry.size() && ReadRange(view.substr(0, sign), read.Low, read.High) &&
        ReadFinite(view.substr(sign + 1), read.Value),
      "Values", Form, "'" + entry + "'");
    this->Entries.push_back(read);
  }
}

double ValueMap::Map(double value) const
{
  for (const Entry& entry : this->Entries)
  {
    if (value >= entry.Low && value <= entry.High)
    {
      return entry.Value;
    }
  }
  return value;
}

bool IsBigEndianHere()
{
  const std::uint16_t one = 1;
  std::uint8_t first = 0;
  std::memcpy(&first, &one, 1);
  return first == 0;
}

std::string WriteHeader(const RawImage& image)
{
  return image.Header == RawHeader::MetaImage ? WriteMetaImage(image)
    : image.Header == RawHeader::AmitexVtk    ? WriteAmitexVtk(image)
                                              : std::string();
}
}
