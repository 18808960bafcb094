// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Images/Fit/DistanceMap.h"

#include "GreyScenes.h"

namespace
{
std::vector<std::int32_t> BruteForce(
  const std::vector<float>& values, const std::array<int, 3>& n, float threshold)
{
  std::vector<std::array<int, 3>> matrix;
  const auto placeOf = [&](std::size_t k) {
    return std::array<int, 3>{ int(k % n[0]), int(k / n[0] % n[1]), int(k / n[0] / n[1]) };
  };
  for (std::size_t k = 0; k < values.size(); ++k)
  {
    if (!(values[k] > threshold))
    {
      matrix.push_back(placeOf(k));
    }
  }
  std::vector<std::int32_t> squares(values.size(), ruc::NoMatrix);
  for (std::size_t k = 0; k < values.size(); ++k)
  {
    const auto here = placeOf(k);
    for (const auto& other : matrix)
    {
      std::int32_t square = 0;
      for (int q = 0; q < 3; ++q)
      {
        square += (here[q] - other[q]) * (here[q] - other[q]);
      }
      squares[k] = std::min(squares[k], square);
    }
  }
  return squares;
}
}

TEST(DistanceMap, IsExact)
{
  // Odd, prime and one-voxel edges, rows longer than what is done at once, few voxels of matrix and
  // many
  const std::array<int, 3> shapes[] = { { 9, 11, 13 }, { 150, 5, 4 }, { 1, 17, 19 }, { 16, 1, 1 },
    { 3, 70, 6 } };
  for (const auto& n : shapes)
  {
    for (double share : { 0.002, 0.05, 0.7 })
    {
      oracle::Uniform random(3);
      std::vector<float> values(std::size_t(n[0]) * n[1] * n[2]);
      for (float& value : values)
      {
        value = random() < share ? 1.0f : 2.0f;
      }
      values[values.size() / 3] = 1.0f; // of matrix, as is what equals the threshold
      const std::vector<std::int32_t> expected = BruteForce(values, n, 1.0f);
      for (int size : { 1, 2, 3, 4 })
      {
        EXPECT_EQ(oracle::Together<std::int32_t>(size,
                    [&](ruc::Communicator& ranks)
                    {
                      return ruc::SquaredDistances(
                        ruc::FindAbove(oracle::SlabOf(values, n, ranks), 1.0f), ranks)
                        .Values;
                    }),
          expected)
          << n[0] << " " << n[1] << " " << n[2] << " " << share << " on " << size;
      }
    }
  }
}

TEST(DistanceMap, TellsWhereThereIsNoMatrix)
{
  ruc::Communicator one;
  const std::vector<float> values(6 * 5 * 4, 2.0f);
  const auto map =
    ruc::SquaredDistances(ruc::FindAbove(oracle::SlabOf(values, { 6, 5, 4 }, one), 1.0f), one);
  EXPECT_EQ(map.Values, std::vector<std::int32_t>(values.size(), ruc::NoMatrix));
}
