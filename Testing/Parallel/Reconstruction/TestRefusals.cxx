// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Packs and settings of which no cell is made
#include "Refusals.h"

#include "vtkRUCUnitCellReconstruction.h"

using Cell = vtkRUCUnitCellReconstruction;

namespace
{
const std::string Name = "Unit Cell Reconstruction";

// Keeps the search short: whether a good pack is taken does not depend on a good cell
void Briefly(Cell* filter)
{
  filter->SetMaximumIterations(2);
}

void RefusesCell(const std::vector<std::string>& parts, const std::function<void(Cell*)>& spoil,
  bool periodic = true)
{
  RefusesSettings<Cell>(parts, spoil, periodic, Briefly);
}
}

TEST(CellRefusals, NoSphereOfAModeInTheCell)
{
  Refuses<Cell>({ Name, "at least one sphere of every mode", "mode 1", "CellSize" },
    { [](ruc::SpherePack& p)
      {
        for (std::size_t i = 1; i < p.Size(); ++i)
        {
          p.Mode[i] = 2 + i % 2;
        }
        p.Mode[0] = 1;
      },
      {}, [](Cell* f) { f->SetNumberOfParticles(20); } },
    true, Briefly);
}

TEST(CellRefusals, NoLags)
{
  RefusesCell({ Name, "NumberOfLags requires", "got 0" }, [](Cell* f) { f->SetNumberOfLags(0); });
}

TEST(CellRefusals, NegativeCell)
{
  RefusesCell({ Name, "CellSize requires", "got -2" }, [](Cell* f) { f->SetCellSize(-2.0); });
}

TEST(CellRefusals, LagBeyondThePack)
{
  RefusesCell(
    { Name, "MaximumLag requires", "got 11.9" }, [](Cell* f) { f->SetMaximumLag(11.9); }, false);
}

// Twenty of 600 spheres in a cube of edge 12
TEST(CellRefusals, LagBeyondTheCell)
{
  RefusesCell(
    { Name, "MaximumLag requires 0 < MaximumLag <= 7.85", "for a cell of edge 3.92", "got 10.5" },
    [](Cell* f)
    {
      f->SetNumberOfParticles(20);
      f->SetMaximumLag(10.5);
    });
}

TEST(CellRefusals, TooLittleMemory)
{
  RefusesCell({ Name, "MemoryLimit requires at least", "MB on every rank", "got 0.001" },
    [](Cell* f) { f->SetMemoryLimit(0.001); });
}

// The tables of the objective grow with the ratio of the radii
TEST(CellRefusals, SpheresFarSmallerThanTheOthers)
{
  Refuses<Cell>({ Name, "MemoryLimit requires at least", "MB on every rank", "got 4000" },
    { [](ruc::SpherePack& p)
      {
        for (std::size_t i = 0; i < p.Size(); ++i)
        {
          p.Radius[i] *= p.Mode[i] == 1 ? 1e-7 : 1.0;
        }
      },
      {}, [](Cell* f) { f->SetNumberOfParticles(20); } },
    true, Briefly);
}

TEST(CellRefusals, NegativeIterations)
{
  RefusesCell(
    { Name, "MaximumIterations requires", "got -1" }, [](Cell* f) { f->SetMaximumIterations(-1); });
}

// A cube of 3.5 has no room for eight blocks of two mean diameters, 1.05 each
TEST(CellRefusals, NoRoomForThePackError)
{
  Refuses<Cell>({ Name, "StopAtPackError requires a window with room for 8 blocks" },
    { [](ruc::SpherePack& pack)
      {
        ruc::SpherePack few;
        for (std::size_t i = 0; i < pack.Size(); ++i)
        {
          if (std::max({ pack.X[i], pack.Y[i], pack.Z[i] }) < 3.5)
          {
            few.Append(pack, i);
          }
        }
        pack = few;
        pack.Mode.assign(pack.Size(), 1);
      },
      {}, {}, 3.5 },
    false,
    [](Cell* f)
    {
      Briefly(f);
      f->SetStopAtPackError(true);
      f->SetMaximumLag(1.0);
    });
}
