// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// two_point PACK.csv X Y Z: S_mm of a pack in a box of these edges that begins at the origin, at 20
// lags up to 200
#include <ruc/Formats/PackFormats.h>
#include <ruc/Statistics/PairSums/ExactPairSum.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>

int main(int argc, char* argv[])
{
  if (argc != 5)
  {
    std::puts("usage: two_point PACK.csv X Y Z");
    return EXIT_FAILURE;
  }
  std::ifstream file(argv[1]);
  const std::string text(std::istreambuf_iterator<char>(file), {});
  ruc::SpherePack pack = ruc::ReadPack(text).Pack;
  pack.Mode.assign(pack.Size(), 1);
  const ruc::Vector3 edges{ std::atof(argv[2]), std::atof(argv[3]), std::atof(argv[4]) };
  const ruc::Window window = ruc::Window::MakeBox({ 0, 0, 0 }, edges, { false, false, false });
  const ruc::TwoPointProbability probability = ruc::SumPairs(pack, window, { 10.0, 20 });
  for (int k = 0; k <= probability.Lags.Count; ++k)
  {
    std::printf("%g,%.15g\n", k * probability.Lags.Spacing, probability.S(1, 1)[k]);
  }
  return EXIT_SUCCESS;
}
