// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Packing/DensePackCheckpoint.h"

#include "ruc/Base/Bytes.h"
#include "ruc/Base/SealedBytes.h"

#include <cmath>
#include <stdexcept>

namespace ruc
{
namespace
{
constexpr std::string_view Format = "RUCDENSE";
constexpr std::uint32_t Version = 2;

std::uint64_t KeyOf(const DensePackSettings& settings)
{
  return FingerprintOfBytes(ToBytes(settings));
}
}

std::string WriteCheckpoint(const DensePackState& state, const DensePackSettings& settings)
{
  return SealBytes(Format, Version, ToBytes(KeyOf(settings)) + ToBytes(state));
}

DensePackState ReadDensePackCheckpoint(std::string_view bytes, const DensePackSettings& settings)
{
  ByteReader reader(UnsealBytes(bytes, Format, Version, "a pack"), "checkpoint");
  if (reader.Get<std::uint64_t>() != KeyOf(settings))
  {
    throw std::invalid_argument("The checkpoint is of a pack with other settings. To begin anew, "
                                "remove the file or name another one.");
  }
  DensePackState state;
  reader.Get(state);
  reader.Finish();
  const bool grows = state.At == DensePackState::Stage::Growing;
  const bool pushes = state.At == DensePackState::Stage::Pushing;
  if (pushes)
  {
    state.Removal.Check(settings.Radii.size());
  }
  else
  {
    state.Spheres.Check(settings.Radii.size());
  }
  const bool fits = (grows ? state.Rate > 0.0 && state.Rate <= 1.0 : state.Rate == 0.0) &&
    state.Fraction > 0.0 && state.Fraction <= settings.Fraction * (1.0 + 1e-8) &&
    state.Collisions >= 0.0 && std::isfinite(state.Collisions);
  if (!fits)
  {
    throw std::invalid_argument("The checkpoint is damaged: it holds a value that cannot be.");
  }
  return state;
}
}
