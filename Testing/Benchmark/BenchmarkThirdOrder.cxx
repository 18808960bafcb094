// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The third-order parameters of the example pack, of a random cell of 1082 of its spheres, and of a
 * million spheres, which are that cell a thousand times: what they are, and the seconds of the
 * processor on one core. Run it with OMP_NUM_THREADS=1; other work on the machine does not count.
 */
#include "ExamplePack.h"
#include "ruc/Base/Random.h"
#include "ruc/Packing/OverlapRemoval.h"
#include "ruc/Particles/PackShare.h"
#include "ruc/Statistics/ThirdOrder/ThirdOrderOfSpheres.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>

namespace
{
double ProcessorSeconds()
{
  timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return now.tv_sec + 1e-9 * now.tv_nsec;
}

void Print(const char* what, const ruc::SpherePack& pack, const ruc::Window& window,
  const ruc::ThirdOrderSettings& settings)
{
  const ruc::PackShare share = ruc::SharePack(pack, window);
  ruc::Communicator serial;
  const double begin = ProcessorSeconds();
  const ruc::ThirdOrderOfSpheres found = ruc::MeasureThirdOrder(share, settings, serial);
  const double seconds = ProcessorSeconds() - begin;
  std::printf("%-36s %8.3f s; %7lld centres, cut-off %.0f%s: zeta %.4f +- %.4f", what, seconds,
    static_cast<long long>(found.Centres), found.CutOff, found.Ewald ? ", Ewald" : "",
    found.Spheres.Zeta.Value, found.Spheres.Zeta.Error);
  if (settings.WithEta)
  {
    std::printf(", eta %.4f +- %.4f", found.Spheres.Eta.Value, found.Spheres.Eta.Error);
  }
  std::printf("\n");
}

// Without overlap in a periodic cube, with the example's fraction
ruc::SpherePack MakeCell(const ruc::SpherePack& pack, int spheres, double& edge)
{
  ruc::SpherePack cell;
  double volume = 0.0;
  for (int i = 0; i < spheres; ++i)
  {
    const std::size_t from = i * (pack.Size() / spheres);
    cell.Append(pack, from);
    volume += 4.0 / 3.0 * ruc::Pi * std::pow(pack.Radius[from], 3);
  }
  edge = std::cbrt(volume / 0.553);
  for (int i = 0; i < spheres; ++i)
  {
    const std::array<double, 3> u = ruc::UniformTriple(1, ruc::RandomStream::CellCentres, i);
    cell.X[i] = edge * u[0];
    cell.Y[i] = edge * u[1];
    cell.Z[i] = edge * u[2];
  }
  ruc::RemoveOverlap(cell,
    ruc::Window::MakeBox({ 0, 0, 0 }, { edge, edge, edge }, { true, true, true }), 1,
    [] { return true; });
  return cell;
}

ruc::SpherePack Tile(const ruc::SpherePack& cell, double edge, int tiles)
{
  ruc::SpherePack pack;
  for (int n = 0; n < tiles * tiles * tiles; ++n)
  {
    const std::size_t first = pack.Size();
    pack.Append(cell);
    for (std::size_t i = first; i < pack.Size(); ++i)
    {
      pack.X[i] += edge * (n % tiles);
      pack.Y[i] += edge * (n / tiles % tiles);
      pack.Z[i] += edge * (n / tiles / tiles);
    }
  }
  return pack;
}
}

int main()
{
  const ruc::SpherePack pack = ReadPack();
  ruc::ThirdOrderSettings zeta, both, modes, wide;
  zeta.WithEta = false;
  modes.ByMode = true;
  wide.CutOff = 200.0;
  Print("example pack, zeta", pack, Block, zeta);
  Print("  with eta", pack, Block, both);
  Print("  nine modes", pack, Block, modes);
  Print("  centres 200 inside", pack, Block, wide);
  double edge;
  const ruc::SpherePack cell = MakeCell(pack, 1082, edge);
  const ruc::Window box =
    ruc::Window::MakeBox({ 0, 0, 0 }, { edge, edge, edge }, { true, true, true });
  Print("random cell of 1082, zeta", cell, box, zeta);
  Print("  with eta", cell, box, both);
  Print("  nine modes", cell, box, modes);
  const double size = 10 * edge;
  const ruc::SpherePack million = Tile(cell, edge, 10);
  const ruc::Window window =
    ruc::Window::MakeBox({ 0, 0, 0 }, { size, size, size }, { false, false, false });
  Print("1 082 000 spheres, zeta", million, window, zeta);
  Print("  with eta", million, window, both);
  return 0;
}
