# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Is the cell a stand-in for its pack? The conductivity of cells, from random ones to the nearest in F2, and that of the pack.

    pvbatch is_it_representative.py --output representative
    xvfb-run -a -s "-screen 0 1400x1000x24 -noreset" pvbatch is_it_representative.py --output representative --pictures

The pack is cut into cubes as large as the cell, which are solved with their mirror images. Their conductivity at the fraction of the cell
is on the line through all of them, with its standard error; what cutting and mirroring do by themselves is told by the same cut of a cell, and
taken off. Everything is solved with voxels of one size and by one rule, as only then numbers compare. --check ends with an error unless the
cell that is nearest in F2 comes nearer than the random one. Pictures need a display.
"""
import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from paraview.simple import *

from common import add_output, fetch, field, make_parser, read_pack, require, run, sort_spheres, table_of, write_table

TABLE = "is_it_representative.csv"
F2_ALONE = {"ContactWeight": 0, "PoreWeight": 0}


def parse_arguments():
    parser = make_parser("is_it_representative.py", __doc__)
    cell = parser.add_argument_group("cells")
    cell.add_argument("--particles", type=int, default=1082, help="spheres in each cell")
    cell.add_argument("--iterations", type=int, default=1000, help="of F2; near neighbours take half as many more")
    cell.add_argument("--targets", type=float, nargs="*", default=[0.2, 0.1, 0.05], help="F2 at which searches end early")
    cell.add_argument("--maximum-lag", type=float, default=200.0, help="last lag r of S_rs(r)")
    cell.add_argument("--lags", type=int, default=277, help="number K of lags after 0")
    cell.add_argument("--seed", type=int, default=1, help="seed of the cells")
    solver = parser.add_argument_group("solver")
    solver.add_argument("--contrasts", type=float, nargs="+", default=[10.0, 100.0], help="conductivity of the spheres over that of the matrix")
    solver.add_argument("--resolution", type=int, default=96, help="voxels along the edge of the cell")
    solver.add_argument("--rule", default="Harmonic", choices=["Laminate", "Harmonic", "Arithmetic"], help="what a voxel is that a surface cuts")
    solver.add_argument("--windows", type=int, default=0, help="cubes of the pack, at least 3; 0: as many as fit")
    add_output(parser, "is_it_representative_results")
    parser.add_argument("--pictures", action="store_true", help="draw them too")
    return parser.parse_args()


def make_cells(modes, args):
    """{name: cell}, from the farthest to the nearest."""
    common = {"Input": modes, "NumberOfParticles": args.particles, "MaximumLag": args.maximum_lag, "NumberOfLags": args.lags, "Seed": args.seed}
    cells = {"random": UnitCellReconstruction(MaximumIterations=0, **common, **F2_ALONE)}
    for target in args.targets:
        cells[f"to F2 {target:g}"] = UnitCellReconstruction(MaximumIterations=args.iterations, TargetObjective=target, **common, **F2_ALONE)
    cells["F2 alone"] = UnitCellReconstruction(MaximumIterations=args.iterations, **common, **F2_ALONE)
    cells["near neighbours"] = UnitCellReconstruction(MaximumIterations=args.iterations, **common)
    return cells


def solve(pack, contrast, args, **window):
    """(mean conductivity over that of the matrix, fraction of spheres)"""
    properties = EffectiveProperties(Input=pack, Method="Solver", ModeConductivities=[contrast], Resolution=args.resolution, SecondResolution=0,
                                     InterfaceRule=args.rule, **window)
    table = table_of(properties)
    return table["Solver"][table["Quantity"].index("k")], field(fetch(properties), "SolvedFraction")


def cubes(args, edge, largest):
    """Lower corners of cubes of the pack, away from its faces, where spheres are lacking."""
    room = [size - 2.0 * largest for size in args.box]
    counts = [int(length // edge) for length in room]
    require(min(counts) > 0, f"the pack has no room for a cube of edge {edge:g}")
    first = [args.origin[q] + largest + 0.5 * (room[q] - counts[q] * edge) for q in range(3)]
    corners = [[first[0] + i * edge, first[1] + j * edge, first[2] + k * edge] for i in range(counts[0]) for j in range(counts[1])
               for k in range(counts[2])]
    return corners[:args.windows] if args.windows else corners


def line_at(points, place):
    """The straight line through (fraction, conductivity) at a fraction, with its standard error."""
    n, mean = len(points), sum(c for c, _ in points) / len(points)
    square = math.fsum((c - mean)**2 for c, _ in points)
    height = sum(k for _, k in points) / n
    slope = math.fsum((c - mean) * (k - height) for c, k in points) / square
    rest = math.fsum((k - height - slope * (c - mean))**2 for c, k in points)
    return height + slope * (place - mean), math.sqrt(rest / max(n - 2, 1) * (1.0 / n + (place - mean)**2 / square))


def study(args):
    """{column: list}, with a row for the pack and for each cell."""
    modes = sort_spheres(read_pack(args), args)
    cells = make_cells(modes, args)
    best = cells["F2 alone"]
    edge, fraction = field(fetch(best), "BoxSize")[0], 0.0
    largest = fetch(modes).GetPointData().GetArray("Radius").GetRange()[1]
    corners = cubes(args, edge, largest)
    require(len(corners) >= 3, f"a line takes at least 3 cubes, got {len(corners)}")
    table = {"Name": ["pack", *cells], "F2": [0.0, *(field(fetch(cell), "Objective") for cell in cells.values())]}
    for contrast in args.contrasts:
        found = {name: solve(cell, contrast, args) for name, cell in cells.items()}
        fraction = found["F2 alone"][1]
        mirrored = solve(best, contrast, args, Boundary="Mirrored")[0]
        bias = mirrored / found["F2 alone"][0]
        windows = [solve(modes, contrast, args, WindowOrigin=corner, WindowSize=[edge] * 3)[::-1] for corner in corners]
        pack, error = (value / bias for value in line_at(windows, fraction))
        print(f"contrast {contrast:g}: cutting and mirroring a cell changes its conductivity by {100.0 * (bias - 1.0):+.2f} %, which is taken off")
        table[f"k_{contrast:g}"] = [pack, *(k for k, _ in found.values())]
        table[f"k_{contrast:g}_error"] = [error] + [0.0] * len(cells)
        table[f"Percent_{contrast:g}"] = [0.0, *(100.0 * (k / pack - 1.0) for k, _ in found.values())]
    return table


def print_table(table, args):
    print(f"{'':18s} {'F2':>7s}" + "".join(f" {'k, contrast ' + format(c, 'g'):>16s} {'error':>7s} {'to pack':>9s}" for c in args.contrasts))
    for n, name in enumerate(table["Name"]):
        print(f"{name:18s} {table['F2'][n]:7.4f}" + "".join(
            f" {table[f'k_{c:g}'][n]:16.4f} {table[f'k_{c:g}_error'][n]:7.4f} {table[f'Percent_{c:g}'][n]:+7.2f} %" for c in args.contrasts))
    for contrast in args.contrasts:
        error = 100.0 * table[f"k_{contrast:g}_error"][0] / table[f"k_{contrast:g}"][0]
        print(f"\nA cell of {args.particles} spheres has the conductivity of the pack at a contrast of {contrast:g} but for "
              f"{table[f'Percent_{contrast:g}'][-1]:+.2f} %, with a standard error of {error:.2f} % of the pack's; "
              f"a random cell differs by {table[f'Percent_{contrast:g}'][1]:+.1f} %.")


def check_all(table, args):
    for contrast in args.contrasts:
        percent = table[f"Percent_{contrast:g}"]
        require(abs(percent[-1]) < abs(percent[1]), f"contrast {contrast:g}: near neighbours differ by {percent[-1]} %, random by {percent[1]} %")


def draw(args, table):
    from statistics_pictures import Charts  # imported only here, as nothing else draws

    charts = Charts(args.output)
    f2 = table["F2"][1:]
    most = max(max(table[f"Percent_{c:g}"][1:]) for c in args.contrasts)
    top = 5.0 * math.ceil(most / 5.0)
    view = charts.chart("F2 of the cell", "conductivity above that of the pack (%)", [0.0, 0.1, 0.2, 0.3, 0.4],
                        [5.0 * n for n in range(-1, int(top / 5.0) + 1)])
    colours = ["#0077bb", "#bb3344", "#117733", "#777777"]
    series = [("the pack", [0.0, 0.4], [0.0, 0.0], "#777777", 2, 1, 0)]
    for n, contrast in enumerate(args.contrasts):
        percent = table[f"Percent_{contrast:g}"][1:]
        series.append((f"contrast {contrast:g}, by F2", f2[:-1], percent[:-1], colours[n % 4], 2, 1, 4))
        series.append((f"contrast {contrast:g}, near neighbours", [f2[-1]] * 2, [percent[-1]] * 2, colours[n % 4], 0, 1, 5))
    charts.plot(view, series)
    charts.save(view, "is_it_representative.png")


def main():
    args = parse_arguments()
    args.output = os.path.abspath(args.output)
    table = study(args)
    print_table(table, args)
    write_table(args.output, TABLE, table)
    print(f"\nfiles    {args.output}")
    if args.pictures:
        draw(args, table)
    if args.check:
        check_all(table, args)
        print("check    passed")


if __name__ == "__main__":
    run(main)
