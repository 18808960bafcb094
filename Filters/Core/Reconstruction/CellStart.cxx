// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/CellStart.h"

#include "ruc/Base/Random.h"

namespace ruc
{
std::vector<double> RandomCentres(
  const CellContents& contents, std::uint32_t seed, std::uint32_t number)
{
  std::vector<double> centres;
  for (int i = 0; i < contents.NumberOfSpheres(); ++i)
  {
    for (double u : UniformTriple(
           seed, RandomStream::CellCentres, std::uint64_t(number) << 32 | std::uint32_t(i)))
    {
      centres.push_back(contents.Edge * u);
    }
  }
  return centres;
}
}
