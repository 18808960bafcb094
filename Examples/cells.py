# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reconstructs several independent unit cells of a sphere pack, as the paper did five, and compares them with the pack and the paper.

    mpirun -np 2 pvbatch cells.py --output cells

prints the paper's Table I for these cells beside the paper's own, the errors of volume fractions (equation 16) and the difference of
the mean S_rs (equation 17), and writes the cells, their tables and the mean S_rs with its standard deviation. No display is needed. With
--check it then tests its own results by independent means and ends with an error if one of them fails.
"""
import csv
import itertools
import math
import os
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from paraview.servermanager import Fetch
from paraview.simple import *
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

from common import (add_output, check_all, close, columns, fetch, field, make_parser, minimum_image, norm, pair, path_in, read_pack, require,
                    require_equal_data, run, sort_spheres, spheres, write_data, write_table, write_tables)

# Table I of Lee et al., Phys. Rev. E 80, 061301 (2009): F2 before (minimum, mean, maximum) and after, iterations, overlap in percent
PAPER = [(4.035, 7.253, 10.963, 0.520, 0.606, 0.839, 578, 0.000),
         (4.202, 7.600, 11.348, 0.581, 0.774, 1.163, 942, 0.001),
         (3.993, 7.537, 11.179, 0.590, 0.773, 1.253, 807, 0.002),
         (3.989, 7.335, 10.801, 0.587, 0.652, 0.793, 1452, 0.000),
         (4.075, 7.420, 11.128, 0.535, 0.574, 0.699, 1726, 0.000)]
PAPER_FRACTIONS, PAPER_DIFFERENCE = 0.8, 0.0387  # percent: equation 16 is below this in every mode; equation 17
TABLE_ONE = ("BeforeMinimum", "BeforeMean", "BeforeMaximum", "AfterMinimum", "AfterMean", "AfterMaximum", "Iterations", "OverlapPercent")


def parse_arguments():
    parser = make_parser("cells.py", __doc__)
    cell = parser.add_argument_group("cells")
    cell.add_argument("--cells", type=int, default=5, help="number of cells")
    cell.add_argument("--method", choices=["Gradient", "Annealed Population", "Hybrid"], default="Gradient", help="how they are found")
    cell.add_argument("--particles", type=int, default=1082, help="spheres in each cell")
    cell.add_argument("--maximum-lag", type=float, default=200.0, help="last lag r of S_rs(r)")
    cell.add_argument("--lags", type=int, default=277, help="number K of lags after 0")
    cell.add_argument("--iterations", type=int, default=1000, help="end a cell by Gradient after so many iterations")
    cell.add_argument("--population", type=int, default=512, help="individuals of Annealed Population")
    cell.add_argument("--mating-pool", type=int, default=16, help="individuals that a generation alters, of Annealed Population")
    cell.add_argument("--generations", type=int, default=10000, help="end a cell by the other methods after so many generations")
    cell.add_argument("--target", type=float, default=0.0, help="end a cell when its F2 is this small")
    cell.add_argument("--time-limit", type=float, default=0.0, help="end all after so many seconds; 0: no limit")
    cell.add_argument("--checkpoint", default="", help="file from which a search that was stopped goes on")
    cell.add_argument("--seed", type=int, default=1, help="seed of the first cell; the next has one more, …")
    add_output(parser, "cells_results")
    return parser.parse_args()


def leaves(data):
    """The data sets in a fetched multiblock, which of several ranks comes as a set for each rank."""
    if data is None or not data.IsA("vtkMultiBlockDataSet"):
        return [] if data is None else [data]
    return [leaf for n in range(data.GetNumberOfBlocks()) for leaf in leaves(data.GetBlock(n))]


class Job:
    """The pipeline, and the folder its results go to."""

    def __init__(self, args):
        self.args = args
        self.modes = sort_spheres(read_pack(args), args)
        # F2 alone counts in the paper
        self.search = UnitCellReconstruction(Input=self.modes, Method=args.method, NumberOfCells=args.cells, ContactWeight=0, PoreWeight=0,
                                             NumberOfParticles=args.particles, MaximumLag=args.maximum_lag, NumberOfLags=args.lags,
                                             MaximumIterations=args.iterations, Population=args.population,
                                             MatingPool=args.mating_pool, MaximumGenerations=args.generations,
                                             TargetObjective=args.target, TimeLimit=args.time_limit, Seed=args.seed,
                                             CheckpointFile=os.path.abspath(args.checkpoint) if args.checkpoint else "")
        # What is written: of each file the filter and its output
        self.tables = {"modes.csv": (self.modes, 1), "convergence.csv": (self.search, 1), "two_point.csv": (self.search, 2),
                       "table_of_cells.csv": (self.search, 4), "comparison.csv": (self.search, 5)}
        self.cells = []  # fetched

    def path(self, name):
        return path_in(self.args.output, name)

    def run(self):
        self.search.UpdatePipeline()
        self.cells = leaves(Fetch(self.search, idx=3))
        if not self.cells:
            raise RuntimeError("Unit Cell Reconstruction gave no cells.")

    def cell_file(self, cell):
        return f"cell_{field(cell, 'Cell'):.0f}.vtp"

    def two_point(self, cell):
        """S_rs of the cell in a file, summed over its pairs anew."""
        source = XMLPolyDataReader(FileName=[self.path(self.cell_file(cell))])
        return columns(fetch(TwoPointProbability(Input=source, MaximumLag=self.args.maximum_lag, NumberOfLags=self.args.lags)))


def phases_of(table):
    return list(dict.fromkeys(name.split("_")[1] for name in table if name.startswith("S_")))


def print_row(name, values, more=""):
    print(f"{name:8}" + "".join(f"{value:9.3f}" for value in values[:6]) + f"{values[6]:12.0f}{values[7]:9.3f} %{more}")


def improvement(rows):
    """How far F2 falls from the mean before to the mean after, in percent, mean over the runs."""
    return sum(100.0 * (1.0 - row[4] / row[1]) for row in rows) / len(rows)


def print_summary(job, seconds):
    table, comparison = columns(fetch(job.search, 4)), columns(fetch(job.search, 5))
    rows = [*zip(*(table[name] for name in TABLE_ONE))]
    print(f"\n{'':8}{'F2 before':>18}{'':9}{'F2 after':>18}\n{'Run':8}" + "".join(f"{name:>9}" for name in ("min", "mean", "max") * 2) +
          f"{'iterations':>12}{'overlap':>11}{'seed':>7}{'(17)':>10}   ended by")
    for i, row in enumerate(rows):
        print_row(f"Run {table['Cell'][i]:.0f}", row,
                  f"{table['Seed'][i]:7.0f}{table['DifferencePercent'][i]:8.3f} %   {table['EndedBy'][i]}")
    print(f"improved by {improvement(rows):.1f} % on average, {seconds:.1f} s for all")
    print("\nTable I of the paper (RECON3D on 2048 CPUs, populations of 512, of its own pack)")
    for i, row in enumerate(PAPER):
        print_row(f"Run {i + 1}", row)
    print(f"improved by {improvement(PAPER):.1f} % on average")
    if job.args.method == "Gradient":
        print("By Gradient a run is one cell: before is its random start freed from overlap, after the cell itself.")
    print(f"\n{'phase':>5} {'c pack':>10} {'c cells':>10} {'deviation':>10} {'(16)':>10}")
    for i, name in enumerate(comparison["Quantity"]):
        if name.startswith("c_"):
            deviation = comparison.get("StandardDeviation", [math.nan] * (i + 1))[i]
            percent = f"{comparison['Percent'][i]:8.4f} %" if name != "c_m" else ""
            print(f"{name[2:]:>5} {comparison['Pack'][i]:10.6f} {comparison['Cell'][i]:10.6f} {deviation:10.1e} {percent:>10}")
    modes = [percent for name, percent in zip(comparison["Quantity"], comparison["Percent"]) if name.startswith("c_") and name != "c_m"]
    print(f"equation 16, largest of all modes  {max(modes):.4f} %   (paper: below {PAPER_FRACTIONS} %)")
    percent = field(fetch(job.search, 5), "DifferencePercent")
    print(f"equation 17, mean of {len(job.cells)} cells       {percent:.4f} %   (paper: {PAPER_DIFFERENCE} %)")


def write_files(job):
    write_tables(job.args.output, job.tables)
    for cell in job.cells:
        write_data(vtkXMLPolyDataWriter(), cell, job.path(job.cell_file(cell)))
    # S_rs of every cell also goes to a file, for other uses
    for cell in job.cells:
        write_table(job.args.output, f"two_point_{job.cell_file(cell)[:-4]}.csv", job.two_point(cell))


def main():
    args = parse_arguments()
    os.makedirs(args.output, exist_ok=True)
    job = Job(args)
    print(f"{args.cells} cells of {args.particles} spheres by {args.method} …", flush=True)
    start = time.time()
    job.run()
    print_summary(job, time.time() - start)
    write_files(job)
    print(f"\nfiles    {job.path('')}")
    if args.check:
        check_all(CHECKS, job)


# ---- Checks: everything below is plain Python on the files ----


def read_table(path):
    """{name: list of numbers, or of texts}"""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    def convert(values):
        try:
            return [float(value) for value in values]
        except ValueError:
            return values
    return {name: convert([row[name] for row in rows]) for name in rows[0]}


def names_of(table):
    """Every ordered pair of phases as a name of a column, so that S_1_2 comes twice and S_1_1 once."""
    phases = phases_of(table)
    return [pair(phases, r, s) for r, s in itertools.product(phases, phases)]


def difference(pack, cell):
    """F2, and equation 17 in percent, of two tables with the same lags."""
    names = names_of(pack)
    f2 = math.fsum(norm([a - b for a, b in zip(pack[name], cell[name])]) for name in names)
    return f2, 200.0 * f2 / math.fsum(norm(pack[name]) + norm(cell[name]) for name in names)


def check_table(job):
    """the table has a row for each cell, in order, and the best cell's is its convergence"""
    table, convergence = read_table(job.path("table_of_cells.csv")), read_table(job.path("convergence.csv"))
    require(table["Cell"] == [i + 1.0 for i in range(len(job.cells))], f"cells {table['Cell']}")
    require(len(job.cells) == job.args.cells or job.args.time_limit > 0.0, f"{len(job.cells)} cells")
    for i, cell in enumerate(job.cells):
        low, mean, high, low2, mean2, high2, iterations, overlap = (table[name][i] for name in TABLE_ONE)
        require(low <= mean <= high and low2 <= mean2 <= high2, f"cell {i + 1}: not in order {low, mean, high, low2, mean2, high2}")
        require(table["Seed"][i] == job.args.seed + i == field(cell, "Seed"), f"cell {i + 1} has another seed")
        require(field(cell, "StartObjective") == mean, f"cell {i + 1}: StartObjective is not the mean before")
        for name, value in (("Objective", table["Objective"][i]), ("Iterations", iterations), ("OverlapPercent", overlap),
                            ("EndedBy", table["EndedBy"][i]), ("Cell", i + 1)):
            require(field(cell, name) == value, f"cell {i + 1}: {name} is {field(cell, name)}, in the table {value}")
        if job.args.method == "Gradient":
            require(low == high and low2 == high2 == table["Objective"][i], f"cell {i + 1} by Gradient is a population")
        require(table["Objective"][i] < mean, f"cell {i + 1} is no better than its start")
    best = min(range(len(job.cells)), key=lambda i: (table["OverlapPercent"][i] > 0.0, table["Objective"][i]))
    for name, column in (("Objective", "Objective"), ("OverlapPercent", "OverlapPercent"), ("Iterations", "Iteration")):
        require(convergence[column][-1] == table[name][best], f"the last {column} of the convergence is not {name} of cell {best + 1}")
    require(convergence["Iteration"] == [float(i) for i in range(len(convergence["Iteration"]))], "an iteration is missing")
    if job.args.method == "Gradient":
        require(convergence["Objective"][1] == table["BeforeMean"][best], "row 1 of the convergence is not the start freed from overlap")
    else:
        require(convergence["Objective"][0] <= table["BeforeMaximum"][best], "row 0 is not of the first population")
    require(field(fetch(job.search), "Cell") == best + 1, f"output 0 is not cell {best + 1}")


def read_cell(job, cell):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(job.path(job.cell_file(cell)))
    reader.Update()
    return reader.GetOutput()


def check_cells(job):
    """cells: spheres of each mode, box, volume fractions, no overlap of any pair and its images"""
    modes, contents = read_table(job.path("modes.csv")), set()
    comparison = read_table(job.path("comparison.csv"))
    for cell in job.cells:
        data = read_cell(job, cell)
        pack, box = spheres(data), field(data, "BoxSize")
        require(len(pack) == job.args.particles and box[0] == box[1] == box[2], "wrong number of spheres, or no cube")
        require(field(data, "BoxPeriodic") == [1, 1, 1] and all(0.0 <= x <= box[0] for s in pack for x in s[:3]), "outside the box")
        for i, mode in enumerate(modes["Mode"]):
            radii = [s[3] for s in pack if s[4] == mode]
            require(all(close(2.0 * r, modes["VolumeMeanDiameter"][i], 1e-9) for r in radii), f"mode {mode}: wrong diameter")
            fraction = math.fsum(4.0 / 3.0 * math.pi * r**3 for r in radii) / math.prod(box)
            require(close(fraction, comparison["Cell"][i], 1e-12), f"mode {mode}: c_r of the cells is not {fraction}")
        contents.add((box[0], *sorted(s[3:] for s in pack)))
        overlap = field(data, "OverlapPercent")
        deepest = max(a[3] + b[3] - math.hypot(*minimum_image(a, b, box)) for a, b in itertools.combinations(pack, 2))
        require(deepest <= 1e-9 or overlap > 0.0, f"cell {field(data, 'Cell'):.0f}: spheres overlap by {deepest}")
        require(overlap == 0.0 or job.args.time_limit > 0.0, f"cell {field(data, 'Cell'):.0f} has an overlap of {overlap} %")
    require(len(contents) == 1, "cells differ in their edges or spheres")
    places = {tuple(cell.GetPoint(0)) for cell in job.cells}
    require(len(places) == len(job.cells), "two cells are the same")


def target_of(table):
    return {name[:-5] if name.endswith("_pack") else name: values for name, values in table.items() if name == "r" or name.endswith("_pack")}


def check_objective(job):
    """F2 and equation 17 of each cell from the columns of S_rs, summed over its pairs anew"""
    target, table = target_of(read_table(job.path("two_point.csv"))), read_table(job.path("table_of_cells.csv"))
    for i, cell in enumerate(job.cells):
        f2, percent = difference(target, read_table(job.path(f"two_point_cell_{i + 1}.csv")))
        # F2 sums 100 norms of 277 lags; those of the search interpolate the pair sums between knots
        require(close(f2, table["Objective"][i], 1e-6), f"F2 of cell {i + 1} is {table['Objective'][i]}, from its columns {f2}")
        require(close(percent, table["DifferencePercent"][i], 1e-5), f"(17) of cell {i + 1} is not {percent}")


def check_mean(job):
    """mean and standard deviation of S_rs over the cells"""
    table, cells = read_table(job.path("two_point.csv")), [read_table(job.path(f"two_point_cell_{i + 1}.csv")) for i in range(len(job.cells))]
    if len(cells) < 2:
        require(not any(name.endswith("_mean") for name in table), "a mean of one cell")
        return
    for name in set(names_of(cells[0])):
        for k, values in enumerate(zip(*(cell[name] for cell in cells))):
            mean = math.fsum(values) / len(values)
            deviation = math.sqrt(math.fsum((value - mean)**2 for value in values) / (len(values) - 1))
            require(close(table[name + "_mean"][k], mean, 1e-9), f"{name} at lag {k}: mean is not {mean}")
            require(close(table[name + "_deviation"][k], deviation, 1e-8), f"{name} at lag {k}: deviation is not {deviation}")


def check_comparison(job):
    """equations 16 and 17 of the mean of the cells, from the columns"""
    table, rows = read_table(job.path("two_point.csv")), read_table(job.path("comparison.csv"))
    target, end = target_of(table), "_mean" if len(job.cells) > 1 else "_cell"
    mean = {name[:-5]: values for name, values in table.items() if name.endswith(end)}
    percent = difference(target, mean)[1]
    require(close(rows["Percent"][-1], percent, 1e-9) and rows["Quantity"][-1] == "all", f"(17) is {rows['Percent'][-1]}, not {percent}")
    require(field(fetch(job.search, 5), "DifferencePercent") == rows["Percent"][-1], "DifferencePercent is not the last row")
    # All cells hold the same spheres
    pack, cell = read_table(job.path("modes.csv"))["VolumeFraction"], read_cell(job, job.cells[0])
    for i, c in enumerate(pack):
        of_cells = math.fsum(4.0 / 3.0 * math.pi * s[3]**3 for s in spheres(cell) if s[4] == i + 1) / math.prod(field(cell, "BoxSize"))
        percent = 100.0 * abs(c - of_cells) / math.fsum(pack)
        require(rows["Quantity"][i] == f"c_{i + 1}", f"row {i} is {rows['Quantity'][i]}")
        require(close(rows["Percent"][i], percent, 1e-9), f"(16) of mode {i + 1} is {rows['Percent'][i]}, not {percent}")
    for name in names_of(target):
        i = rows["Quantity"].index(name)
        require(close(rows["Difference"][i], norm([a - b for a, b in zip(target[name], mean[name])]), 1e-12), f"{name}: other difference")


def check_files(job):
    """the files, read again, hold what was written"""
    for cell in job.cells:
        require_equal_data(cell, read_cell(job, cell), job.cell_file(cell))
    for name, (source, port) in job.tables.items():
        written, read = columns(fetch(source, port)), read_table(job.path(name))
        require([*map(str, written.items())] == [*map(str, read.items())], f"{name} reads differently")


CHECKS = (check_table, check_cells, check_objective, check_mean, check_comparison, check_files)


if __name__ == "__main__":
    run(main)
