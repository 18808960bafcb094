// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Formats/WrittenPack.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <iomanip>
#include <locale>
#include <sstream>

namespace ruc
{
namespace
{
constexpr int Digits = 17; // tell a double from all others
}

void AppendNumber(std::string& text, double value)
{
#ifdef __cpp_lib_to_chars
  std::array<char, 32> digits;
  const auto [end, error] =
    std::to_chars(digits.begin(), digits.end(), value, std::chars_format::general, Digits);
  text.append(digits.data(), static_cast<std::size_t>(end - digits.data()));
#else
  AppendNumberByStream(text, value);
#endif
}

void AppendNumberByStream(std::string& text, double value)
{
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream << std::setprecision(Digits) << value;
  text += stream.str();
}

void AppendNumbers(std::string& text, std::initializer_list<double> values)
{
  bool first = true;
  for (double value : values)
  {
    text += first ? "" : " ";
    AppendNumber(text, value);
    first = false;
  }
}

int TypeOf(const FramePack& pack, std::size_t i)
{
  return pack.Type.empty() ? 1 : pack.Type[i];
}

LammpsNumbers::LammpsNumbers(const FramePack& pack)
{
  const auto missing = [](const auto& values)
  {
    const auto least = std::min_element(values.begin(), values.end());
    return least == values.end() ? 0 : std::max<std::int64_t>(1 - std::int64_t(*least), 0);
  };
  this->AddedToId = missing(pack.Pack.Id);
  this->AddedToType = missing(pack.Type);
}

std::string LammpsNumbers::Of(const FramePack& pack, std::size_t i) const
{
  return std::to_string(pack.Pack.Id[i] + this->AddedToId) + " " +
    std::to_string(TypeOf(pack, i) + this->AddedToType) + " ";
}

Window BoxOrBounds(const FramePack& pack)
{
  if (pack.Box)
  {
    return pack.Box->GetBounds();
  }
  const std::vector<double>* const axes[3] = { &pack.Pack.X, &pack.Pack.Y, &pack.Pack.Z };
  Vector3 low{}, size{};
  for (int q = 0; q < 3; ++q)
  {
    low[q] = axes[q]->at(0);
    double high = low[q];
    for (std::size_t i = 0; i < pack.Pack.Size(); ++i)
    {
      low[q] = std::min(low[q], (*axes[q])[i] - pack.Pack.Radius[i]);
      high = std::max(high, (*axes[q])[i] + pack.Pack.Radius[i]);
    }
    size[q] = high - low[q];
  }
  return Window::MakeBox(low, size, { false, false, false });
}
}
