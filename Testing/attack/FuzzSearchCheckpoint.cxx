// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
//
// libFuzzer target: any bytes are read as the state of a search, or refused with
// std::invalid_argument. The first byte says which search, and whether the others stand for
// themselves or are forged into a true state: they are added to its bytes, bit by bit, and the
// checksum at the end, FNV-1a-64, is made to fit again, which a fuzzer would never find.
#include "ruc/Reconstruction/SearchCheckpoint.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>

namespace
{
volatile bool Converged = false;

ruc::DescentState SomeDescent()
{
  ruc::DescentState descent;
  descent.Place = descent.Gradient = { 1.0, 2.0, 3.0 };
  descent.Steps = descent.GradientChanges = { { 1.0, 2.0, 3.0 }, { 4.0, 5.0, 6.0 } };
  return descent;
}

std::string SomeCheckpoint(bool population, const ruc::SearchKey& key)
{
  if (population)
  {
    ruc::PopulationState state;
    state.Centres = { { 1.0, 2.0, 3.0 }, { 4.0, 5.0, 6.0 } };
    state.Objective = state.OverlapPercent = { 1.0, 2.0 };
    state.Convergence.resize(2);
    state.Descent = SomeDescent();
    return ruc::WriteCheckpoint(state, key);
  }
  ruc::GradientState state;
  state.Descent = SomeDescent();
  state.Best = state.Descent.Place;
  state.Convergence.resize(2);
  return ruc::WriteCheckpoint(state, key);
}

void Forge(std::string& checkpoint, const std::uint8_t* bytes, std::size_t size)
{
  const std::size_t body = checkpoint.size() - sizeof(std::uint64_t);
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (std::size_t i = 0; i < body; ++i)
  {
    checkpoint[i] = static_cast<char>(checkpoint[i] ^ (i < size ? bytes[i] : 0));
    hash = (hash ^ static_cast<unsigned char>(checkpoint[i])) * 0x100000001b3u;
  }
  std::memcpy(&checkpoint[body], &hash, sizeof hash);
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  if (size < 1)
  {
    return 0;
  }
  const bool population = bytes[0] & 1;
  ruc::SearchKey key;
  key.Method = population ? 2 : 1;
  std::string checkpoint;
  if (bytes[0] & 2)
  {
    checkpoint.assign(reinterpret_cast<const char*>(bytes) + 1, size - 1);
  }
  else
  {
    checkpoint = SomeCheckpoint(population, key);
    Forge(checkpoint, bytes + 1, size - 1);
  }
  try
  {
    // The state is written again, so that every value is looked at; a truth value is only looked at
    // where it is asked for
    if (population)
    {
      ruc::WriteCheckpoint(ruc::ReadPopulationCheckpoint(checkpoint, key), key);
    }
    else
    {
      const ruc::GradientState state = ruc::ReadGradientCheckpoint(checkpoint, key);
      Converged = state.Converged;
      ruc::WriteCheckpoint(state, key);
    }
  }
  catch (const std::invalid_argument&)
  {
  }
  return 0;
}
