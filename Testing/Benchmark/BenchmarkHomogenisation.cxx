// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the conductivity and the stiffness of a random cell of 1082 beads of the example pack take
 * on 128 voxels along each edge, the bounds, and how far cubic arrays on 64 voxels are from their
 * exact values. Seconds are of the processor on one core: run it with OMP_NUM_THREADS=1; other work
 * on the machine hardly counts.
 */
#include "ExamplePack.h"
#include "ruc/Base/Random.h"
#include "ruc/Homogenisation/EffectiveResult.h"
#include "ruc/Packing/OverlapRemoval.h"
#include "ruc/Particles/PackShare.h"

#include <sys/resource.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <vector>

namespace
{
double ProcessorSeconds()
{
  timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double Peak()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

// Without overlap in a periodic cube, with the example's fraction and one mode
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
  cell.Mode.assign(spheres, 1);
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

void Solve(const char* what, const ruc::SpherePack& pack, const ruc::Window& box,
  const ruc::CellMaterials& materials, int voxels)
{
  ruc::Communicator serial;
  const ruc::CellGrid grid = ruc::MakeCellGrid(box, voxels, false);
  const ruc::InterfaceRule rule = materials.AutomaticRule();
  const double before = Peak(), begin = ProcessorSeconds();
  const ruc::SolvedCell cell = ruc::SolveCell(pack, box, grid, materials, rule, {}, serial);
  const double seconds = ProcessorSeconds() - begin, count = grid.Source.Voxels();
  const double steps = static_cast<double>(cell.Tensor.Steps.size());
  const ruc::Estimate estimate = ruc::EstimateCell(grid, materials, rule, false);
  std::printf(
    "%-34s %6.2f s (estimated %.2f), %3.0f steps of all cases, %5.1f ns a voxel and step; "
    "%.0f bytes a voxel more than before (estimated %.0f): first entry %.4f\n",
    what, seconds, estimate.Seconds, steps, 1e9 * seconds / steps / count,
    (Peak() - before) / count, 1e6 * estimate.MegabytesOfAll / count, cell.Tensor.Value[0][0]);
}

void Bounds(const ruc::SpherePack& pack, const ruc::Window& box)
{
  ruc::Communicator serial;
  const ruc::PackShare share = ruc::SharePack(pack, box);
  const ruc::ThirdOrderOfSpheres third = ruc::MeasureThirdOrder(share, {}, serial);
  const ruc::CellMaterials materials = ruc::MakeElastic(3.0, 0.38, { 70.0 }, { 0.2 }, 1);
  constexpr int times = 1000;
  const double begin = ProcessorSeconds();
  double sum = 0.0;
  for (int n = 0; n < times; ++n)
  {
    sum += ruc::BoundPack(materials, { 0.55, 0.45 }, &third)[1].Estimate;
  }
  std::printf("bounds after zeta and eta: %.4f ms, G about %.3f\n",
    1e3 * (ProcessorSeconds() - begin) / times, sum / times);
}

// Against Rayleigh's method
void Array(const char* what, double k, ruc::InterfaceRule rule, double exact)
{
  ruc::SpherePack pack;
  pack.X = pack.Y = pack.Z = { 0.5 };
  pack.Radius = { std::cbrt(3.0 * 0.4 / (4.0 * ruc::Pi)) };
  pack.Mode = { 1 };
  const ruc::Window cube = ruc::Window::MakeBox({ 0, 0, 0 }, { 1, 1, 1 }, { true, true, true });
  ruc::Communicator serial;
  const double found = ruc::SolveCell(pack, cube, ruc::MakeCellGrid(cube, 64, false),
    ruc::MakeConductors(1.0, { k }, 1), rule, { 1e-5, 500 }, serial)
                         .Tensor.Value[0][0];
  std::printf("simple cubic array, c = 0.4, 64 voxels, %s: %.5f, %+.3f %%\n", what, found,
    100.0 * (found / exact - 1.0));
}
}

int main()
{
  double edge = 0.0;
  const ruc::SpherePack cell = MakeCell(ReadPack(), 1082, edge);
  const ruc::Window box =
    ruc::Window::MakeBox({ 0, 0, 0 }, { edge, edge, edge }, { true, true, true });
  // From small to large, as the peak of memory never falls
  Solve("conductivity, contrast 10", cell, box, ruc::MakeConductors(1.0, { 10.0 }, 1), 128);
  Solve("conductivity, contrast 100", cell, box, ruc::MakeConductors(1.0, { 100.0 }, 1), 128);
  Solve(
    "glass in epoxy, stiffness", cell, box, ruc::MakeElastic(3.0, 0.38, { 70.0 }, { 0.2 }, 1), 128);
  Bounds(cell, box);
  Array("does not conduct", 0.0, ruc::InterfaceRule::Arithmetic, 0.49011);
  Array("10", 10.0, ruc::InterfaceRule::Laminate, 2.36443);
  Array("100", 100.0, ruc::InterfaceRule::Harmonic, 3.13336);
  Array("10000, to that without resistance", 1e4, ruc::InterfaceRule::Harmonic, 3.26257);
  return 0;
}
