# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""How small the cell may be: sweeps its size, and writes how far its statistics are from the pack's, and the time it takes.

    pvbatch smallest_cell.py --output smallest_cell
    xvfb-run -a -s "-screen 0 1400x1000x24 -noreset" pvbatch smallest_cell.py --output smallest_cell --pictures

For every size some cells with different seeds are reconstructed by Gradient with the same number of iterations, over the same lags.
Sizes at which a mode would have no sphere are left out. Time is processor time of the first rank. --check ends with an error if the figures
do not fall as they should, or files read differently. Pictures are drawn on one rank, and need a display.
"""
import csv
import math
import os
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from paraview.simple import *

from common import add_output, close, columns, fetch, field, make_parser, path_in, read_pack, require, run, sort_spheres, write_table

TABLE = "smallest_cell.csv"


def parse_arguments():
    parser = make_parser("smallest_cell.py", __doc__)
    sweep = parser.add_argument_group("sweep")
    sweep.add_argument("--sizes", type=int, nargs="+", default=[50, 100, 200, 400, 800, 1600], help="spheres in the cell, ascending")
    sweep.add_argument("--cells", type=int, default=3, help="cells of each size, with different seeds")
    sweep.add_argument("--iterations", type=int, default=300, help="of Gradient for each cell")
    sweep.add_argument("--maximum-lag", type=float, default=200.0, help="last lag r of S_rs(r)")
    sweep.add_argument("--lags", type=int, default=277, help="number K of lags after 0")
    sweep.add_argument("--seed", type=int, default=1, help="seed of the first cell of each size")
    add_output(parser, "smallest_cell_results")
    parser.add_argument("--pictures", action="store_true", help="draw them too")
    return parser.parse_args()


def missing_modes(numbers, size):
    """The modes without a sphere in a cell of this size: the volume is the least whose rounded numbers add up to it, as the filter has it."""
    low, high = 0.0, 2.0 * (size + len(numbers)) / sum(numbers)
    rounded = lambda volume: [math.floor(number * volume + 0.5) for number in numbers]
    for _ in range(100):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if sum(rounded(middle)) < size else (low, middle)
    return [mode + 1 for mode, count in enumerate(rounded(high)) if count < 1]


def study(args):
    """{column: list of numbers}, with a row for each size."""
    modes = sort_spheres(read_pack(args), args)
    numbers = columns(fetch(modes, 1))["Count"]
    table = {name: [] for name in ("Spheres", "Edge", "ObjectiveMinimum", "ObjectiveMean", "ObjectiveMaximum", "LargestFractionPercent",
                                   "CellDifferencePercent", "MeanDifferencePercent", "OverlapPercent", "SecondsPerCell")}
    print(f"{'spheres':>8} {f'edge ({args.unit})':>10} {'F2 min':>8} {'mean':>8} {'max':>8} {'(16) %':>8} {'(17) %, a cell':>15} "
          f"{'mean of cells':>14} {'s a cell':>9}")
    for size in args.sizes:
        missing = missing_modes(numbers, size)
        if missing:
            print(f"{size:8d} skipped: no sphere of mode {', '.join(map(str, missing))}", flush=True)
            continue
        # By F2 alone, as in the paper
        search = UnitCellReconstruction(Input=modes, NumberOfCells=args.cells, NumberOfParticles=size, MaximumLag=args.maximum_lag,
                                        NumberOfLags=args.lags, MaximumIterations=args.iterations, Seed=args.seed, ContactWeight=0,
                                        PoreWeight=0)
        start = time.process_time()
        search.UpdatePipeline()
        seconds = time.process_time() - start
        cells, comparison = columns(fetch(search, 4)), columns(fetch(search, 5))
        fractions = [percent for name, percent in zip(comparison["Quantity"], comparison["Percent"])
                     if name.startswith("c_") and name != "c_m"]
        row = [size, field(fetch(search), "BoxSize")[0], min(cells["Objective"]), sum(cells["Objective"]) / args.cells,
               max(cells["Objective"]), max(fractions), sum(cells["DifferencePercent"]) / args.cells, comparison["Percent"][-1],
               max(cells["OverlapPercent"]), seconds / args.cells]
        for column, value in zip(table.values(), row):
            column.append(float(value))
        print(f"{row[0]:8d} {row[1]:10.2f} {row[2]:8.4f} {row[3]:8.4f} {row[4]:8.4f} {row[5]:8.3f} {row[6]:15.3f} {row[7]:14.3f} {row[9]:9.1f}",
              flush=True)
    return table


def read_table(args):
    with open(path_in(args.output, TABLE), newline="") as file:
        rows = list(csv.DictReader(file))
    return {name: [float(row[name]) for row in rows] for name in rows[0]}


def check_all(args, table):
    require(read_table(args) == table, f"{TABLE} reads differently")
    require(len(table["Spheres"]) >= 2, "fewer than two sizes have a sphere of every mode")
    for name in ("ObjectiveMean", "LargestFractionPercent", "CellDifferencePercent", "MeanDifferencePercent"):
        require(table[name][-1] < 0.8 * table[name][0], f"{name} of the largest cell is {table[name][-1]}, of the smallest {table[name][0]}")
    volumes = [edge**3 / size for edge, size in zip(table["Edge"], table["Spheres"])]
    for i, size in enumerate(table["Spheres"]):
        low, mean, high = (table["Objective" + name][i] for name in ("Minimum", "Mean", "Maximum"))
        require(0.0 < low <= mean <= high and (args.cells == 1 or low < high), f"{size} spheres: F2 of {low}, {mean}, {high}")
        require(table["OverlapPercent"][i] == 0.0, f"{size} spheres overlap")
        # The norm of a mean is no more than the mean of the norms; (17) divides by nearly the same
        require(table["MeanDifferencePercent"][i] <= 1.01 * table["CellDifferencePercent"][i], f"{size} spheres: the mean is worse")
        require(close(volumes[i], volumes[-1], 0.1 * volumes[-1]), f"{size} spheres: an edge of {table['Edge'][i]}")


# ---- Pictures ----


def draw(args, table):
    from statistics_pictures import Charts  # imported only here, as nothing else draws

    charts, sizes = Charts(args.output), table["Spheres"]

    def draw_one(name, title, series):
        values = [value for _, column, *_ in series for value in table[column] if value > 0.0]
        decades = [digit * 10.0**e for e in range(-9, 10) for digit in (1, 2, 5)]
        low, high = max(v for v in decades if v <= min(values)), min(v for v in decades if v >= max(values))
        ends = [min(sizes) / 1.25, *sizes, max(sizes) * 1.25]
        view = charts.chart(f"spheres in the cell (edge in {args.unit})", title, ends, [v for v in decades if low <= v <= high], logarithmic=True)
        view.BottomAxisLabels = [text for size, edge in zip(sizes, table["Edge"]) for text in (repr(size), f"{size:.0f} ({edge:.0f})")]
        view.ShowLegend = int(len(series) > 1)
        charts.plot(view, [(label, sizes, table[column], *style) for label, column, *style in series])
        charts.save(view, name)

    draw_one("smallest_cell.png", "F2, and differences in %",
             [("S_rs, eq. 17, each cell, %", "CellDifferencePercent", "#0077bb", 1, 2, 4),
              (f"S_rs, eq. 17, mean of {args.cells} cells, %", "MeanDifferencePercent", "#33bbee", 2, 2, 1),
              ("volume fractions, eq. 16, worst mode, %", "LargestFractionPercent", "#bb3344", 1, 2, 4),
              (f"F2, mean of {args.cells} cells", "ObjectiveMean", "#222222", 1, 2, 4)])
    draw_one("smallest_cell_time.png", f"processor seconds for {args.iterations} iterations, one cell",
             [("seconds", "SecondsPerCell", "#0077bb", 1, 2, 4)])


def main():
    args = parse_arguments()
    args.output = os.path.abspath(args.output)
    table = study(args)
    write_table(args.output, TABLE, table)
    print(f"\nfiles    {args.output}")
    if args.pictures:
        draw(args, table)
    if args.check:
        check_all(args, table)
        print("check    passed")


if __name__ == "__main__":
    run(main)
