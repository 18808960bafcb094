// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

namespace ruc
{
/**
 * What random numbers are drawn for. Every purpose has a stream of its own, so that draws for
 * different purposes share no numbers. A purpose with several parts takes the streams from its own
 * upwards.
 */
enum class RandomStream : std::uint32_t
{
  CellCentres = 0,
  Velocity = 0x03e10c00u, // and the stream after it
  Exchange = 0x05a9e000u,
  MutationOperator = 0x09e7a700u,
  Shaking = 0x5ba4e000u, // + the attempt
  MatingPool = 0x5e1ec700u,
  LineDirection = 0x71000000u,
  LinePlace = 0x72000000u, // + the set of lines, below 2^24
  SamplePoint = 0x9017f500u,
  MeshOrder = 0xa3e50000u,
  MeshPoints = 0xa3e51000u,
  MeshImprovement = 0xa3e52000u,
  Deposition = 0xba111500u,
  SampleDirection = 0xd14ec700u
};

/**
 * Returns three numbers uniform in [0, 1) that depend on seed, stream, sample and part alone. They
 * are those of Philox4x32-10 of Random123, with the seed as key, and the same on every rank, thread
 * and machine.
 */
std::array<double, 3> UniformTriple(
  std::uint32_t seed, RandomStream stream, std::uint64_t sample, std::uint32_t part = 0);

/**
 * A sequence of random numbers uniform in [0, 1) that depend on (seed, stream, sequence) alone
 * (UniformTriple). It holds 3 x 2^24 of them.
 */
class RandomSequence
{
public:
  RandomSequence(std::uint32_t seed, RandomStream stream, std::uint64_t sequence);
  double Next();
  /** Returns a whole number uniform in 0…count - 1. */
  int NextIndex(int count);

private:
  std::uint32_t Seed;
  RandomStream Stream;
  std::uint64_t Sample;
  std::array<double, 3> Triple{};
  int Used = 3;
};
}
