# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reconstructs a small periodic cell with the statistics of a sphere pack, and writes both as files.

    mpirun -np 2 pvbatch unit_cell.py --output results

reads the pack and the box its centres were observed in, sorts the spheres into modes, computes the one- and two-point probabilities,
reconstructs the unit cell and makes its periodic copies. No display is needed. With --check it then tests its own
results by independent means (check_unit_cell.py) and ends with an error where one of them fails.
"""
import os
import sys
import time
from types import SimpleNamespace

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from paraview.simple import *

from check_unit_cell import CHECKS
from common import check_all, fetch, field, parse_arguments, run, sort_spheres, table_of, write_points, write_tables

ARGUMENTS = parse_arguments(
    "unit_cell.py", __doc__, "unit_cell_results",
    particles=(1082, "spheres in the cell"),
    maximum_lag=(200.0, "last lag r of S_rs(r)"),
    lags=(277, "number K of lags after 0"),
    target=(0.06, "end when F2 is this small; 0: never, for the best cell"),
    iterations=(1000, "end after so many iterations"),
    time_limit=(0.0, "end after so many seconds; 0: no limit"),
    seed=(1, "seed of the random start"))


def main(args):
    print(f"reading  {args.input}")
    pack = SpherePackReader(FileName=os.path.abspath(args.input), LengthUnit=args.unit, BoxOrigin=args.origin, BoxSize=args.box)
    modes = sort_spheres(pack, args)  # by default ParticleModes(Input=pack, NumberOfModes=9)

    lags = {"MaximumLag": args.maximum_lag, "NumberOfLags": args.lags}
    one_point = OnePointProbability(Input=modes)
    two_point = TwoPointProbability(Input=modes, **lags)
    print(f"         {fetch(modes).GetNumberOfPoints()} spheres, overlap {field(fetch(two_point), 'OverlapPercent'):.4f} %")

    print(f"cell     {args.particles} spheres, until F2 <= {args.target:g} or {args.iterations} iterations …", flush=True)
    cell = UnitCellReconstruction(Input=modes, NumberOfParticles=args.particles, TargetObjective=args.target,
                                  MaximumIterations=args.iterations, TimeLimit=args.time_limit, Seed=args.seed, **lags)
    replicas = PeriodicReplicas(Input=cell, ClipToBox=1)
    start = time.time()
    fetch(cell)
    print_summary(args, modes, one_point, cell)
    print(f"time     {time.time() - start:.1f} s for the cell")

    # For each file the filter and its output
    points = {"pack.vtp": (modes, 0), "cell.vtp": (cell, 0), "replicas.vtp": (replicas, 0), "outline.vtp": (replicas, 1),
              "surfaces.vtp": (replicas, 2)}
    tables = {"modes.csv": (modes, 1), "one_point.csv": (one_point, 0), "two_point_pack.csv": (two_point, 0),
              "two_point_checks.csv": (two_point, 1), "convergence.csv": (cell, 1), "two_point.csv": (cell, 2)}
    write_points(args.output, points)
    write_tables(args.output, tables)
    print(f"files    {os.path.abspath(args.output)}")
    if args.check:
        check_all(CHECKS, SimpleNamespace(args=args, modes=modes, one_point=one_point, two_point=two_point, cell=cell, replicas=replicas,
                                          points=points, tables=tables))


def print_summary(args, modes, one_point, cell):
    in_pack, in_cell = table_of(modes, 1), fetch(cell).GetPointData().GetArray("Mode")
    counts = [sum(in_cell.GetValue(i) == mode for i in range(in_cell.GetNumberOfValues())) for mode in in_pack["Mode"]]
    fractions = list(zip(table_of(one_point)["VolumeFraction"], field(fetch(cell), "VolumeFractions")))
    print(f"\n{'mode':>4} {f'diameter ({args.unit})':>18} {'in pack':>9} {'in cell':>9} {'c pack':>9} {'c cell':>9}")
    for i, mode in enumerate(in_pack["Mode"]):
        diameters = f"{in_pack['MinimumDiameter'][i]:.2f} to {in_pack['MaximumDiameter'][i]:.2f}"
        print(f"{mode:4.0f} {diameters:>18} {in_pack['Count'][i]:9.0f} {counts[i]:9d} {fractions[i][0]:9.5f} {fractions[i][1]:9.5f}")
    print(f"{'m':>4} {'':18} {sum(in_pack['Count']):9.0f} {sum(counts):9d} {fractions[-1][0]:9.5f} {fractions[-1][1]:9.5f}")
    value = lambda name: field(fetch(cell), name)
    print(f"\ncell     {' x '.join(f'{edge:.3f}' for edge in value('BoxSize'))} {args.unit}, overlap {value('OverlapPercent'):.4f} %")
    print(f"F2       {value('StartObjective'):.4f} -> {value('Objective'):.4f} in {value('Iterations'):.0f} iterations, "
          f"ended by: {value('EndedBy')}")


if __name__ == "__main__":
    run(main, ARGUMENTS)
