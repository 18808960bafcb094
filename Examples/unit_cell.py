# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reconstructs a small periodic cell with the statistics of a sphere pack, and writes both as files.

    mpirun -np 2 pvbatch unit_cell.py --output results

reads the pack and the box its centres were observed in, sorts the spheres into modes, computes the one- and two-point probabilities,
reconstructs the unit cell and makes its periodic copies. No display is needed. With --check it then tests its own
results by independent means and ends with an error where one of them fails.
"""
import argparse
import csv
import itertools
import math
import os
import random
import sys
import time
import traceback

from paraview.servermanager import Fetch
from paraview.simple import *
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

FETCHED = {}  # outputs on this rank, by filter and port
HERE = os.path.dirname(os.path.abspath(__file__))


def make_parser(program, documentation, division="Equal Width"):
    """With the options of the pack and its modes, which the examples share; what the modes have in common by default."""
    parser = argparse.ArgumentParser(prog="pvbatch " + program, description=documentation.split("\n")[0],
                                     formatter_class=argparse.ArgumentDefaultsHelpFormatter)
    pack = parser.add_argument_group("pack")
    pack.add_argument("--input", default=os.path.join(HERE, "Data", "bead_block.csv"), help="text table with columns x, y, z, radius")
    pack.add_argument("--origin", type=float, nargs=3, default=[0, 0, 0], help="lower corner of the box of the centres")
    pack.add_argument("--box", type=float, nargs=3, default=[1445.372, 1287.892, 789.106], help="edges of the box of the centres")
    pack.add_argument("--unit", default="µm", help="unit of length")
    modes = parser.add_argument_group("modes")
    modes.add_argument("--modes", type=int, default=9, help="number of modes")
    modes.add_argument("--division", choices=["Equal Width", "Equal Volume"], default=division, help="what the modes have in common")
    modes.add_argument("--edges", type=float, nargs="+", default=[], help="or the diameters between the modes, ascending")
    return parser


def sort_spheres(pack, args):
    """The pack's spheres in the modes of these options."""
    if args.edges:
        return ParticleModes(Input=pack, Method="Explicit Edges", Edges=args.edges)
    return ParticleModes(Input=pack, Method=args.division, NumberOfModes=args.modes)


def parse_arguments():
    parser = make_parser("unit_cell.py", __doc__)
    cell = parser.add_argument_group("cell")
    cell.add_argument("--particles", type=int, default=1082, help="spheres in the cell")
    cell.add_argument("--maximum-lag", type=float, default=200.0, help="last lag r of S_rs(r)")
    cell.add_argument("--lags", type=int, default=277, help="number K of lags after 0")
    cell.add_argument("--target", type=float, default=0.06, help="end when F2 is this small; 0: never, for the best cell")
    cell.add_argument("--iterations", type=int, default=1000, help="end after so many iterations")
    cell.add_argument("--time-limit", type=float, default=0.0, help="end after so many seconds; 0: no limit")
    cell.add_argument("--seed", type=int, default=1, help="seed of the random start")
    parser.add_argument("--output", default="unit_cell_results", help="folder for the files")
    parser.add_argument("--check", action="store_true", help="test the results")
    return parser.parse_args()


class Job:
    """The pipeline, and the folder its results go to."""

    def __init__(self, args):
        self.args = args
        self.pack = SpherePackReader(FileName=os.path.abspath(args.input), LengthUnit=args.unit, BoxOrigin=args.origin,
                                     BoxSize=args.box)
        self.modes = sort_spheres(self.pack, args)
        self.one_point = OnePointProbability(Input=self.modes)
        self.two_point = TwoPointProbability(Input=self.modes, MaximumLag=args.maximum_lag, NumberOfLags=args.lags)
        self.cell = UnitCellReconstruction(Input=self.modes, NumberOfParticles=args.particles, MaximumLag=args.maximum_lag,
                                           NumberOfLags=args.lags, TargetObjective=args.target,
                                           MaximumIterations=args.iterations, TimeLimit=args.time_limit, Seed=args.seed)
        self.replicas = PeriodicReplicas(Input=self.cell, ClipToBox=1)
        # What is written: file, filter, output port
        self.point_files = [("pack.vtp", self.modes, 0), ("cell.vtp", self.cell, 0), ("replicas.vtp", self.replicas, 0),
                            ("outline.vtp", self.replicas, 1), ("surfaces.vtp", self.replicas, 2)]
        self.table_files = [("modes.csv", self.modes, 1), ("one_point.csv", self.one_point, 0),
                            ("two_point_pack.csv", self.two_point, 0), ("two_point_checks.csv", self.two_point, 1),
                            ("convergence.csv", self.cell, 1), ("two_point.csv", self.cell, 2)]

    def path(self, name):
        return os.path.join(os.path.abspath(self.args.output), name)


def fetch(source, port=0):
    """The whole output on this rank. A filter that failed has printed why, and its output is empty."""
    key = (source.GetGlobalIDAsString(), port)
    if key in FETCHED:
        return FETCHED[key]
    source.UpdatePipeline()
    data = Fetch(source, idx=port)
    if data is None or data.GetNumberOfElements(data.POINT) + data.GetNumberOfElements(data.ROW) == 0:
        raise RuntimeError(f"{source.GetXMLLabel()} gave no result (output {port}).")
    FETCHED[key] = data
    return data


def columns(table):
    """A fetched table as {name: list of values}."""
    result = {}
    for j in range(table.GetNumberOfColumns()):
        values = [table.GetValue(i, j) for i in range(table.GetNumberOfRows())]
        result[table.GetColumnName(j)] = [v.ToDouble() if v.IsNumeric() else v.ToString() for v in values]
    return result


def field(data, name):
    """A field data array as a number, a text or a list of numbers."""
    array = data.GetFieldData().GetAbstractArray(name)
    values = [array.GetVariantValue(i) for i in range(array.GetNumberOfValues())]
    values = [v.ToDouble() if v.IsNumeric() else v.ToString() for v in values]
    return values[0] if len(values) == 1 else values


def spheres(pack):
    """A fetched pack as a list of (x, y, z, radius, mode)."""
    radius, mode = pack.GetPointData().GetArray("Radius"), pack.GetPointData().GetArray("Mode")
    return [(*pack.GetPoint(i), radius.GetValue(i), int(mode.GetValue(i))) for i in range(pack.GetNumberOfPoints())]


def print_summary(job, seconds):
    unit = job.args.unit
    modes, cell = columns(fetch(job.modes, 1)), fetch(job.cell)
    pack_fractions, cell_fractions = columns(fetch(job.one_point))["VolumeFraction"], field(cell, "VolumeFractions")
    in_cell = [sphere[4] for sphere in spheres(cell)]
    print(f"\n{'mode':>4} {f'diameter ({unit})':>18} {'in pack':>9} {'in cell':>9} {'c pack':>9} {'c cell':>9}")
    for i, mode in enumerate(modes["Mode"]):
        diameters = f"{modes['MinimumDiameter'][i]:.2f} to {modes['MaximumDiameter'][i]:.2f}"
        print(f"{mode:4.0f} {diameters:>18} {modes['Count'][i]:9.0f} {in_cell.count(mode):9d} {pack_fractions[i]:9.5f} "
              f"{cell_fractions[i]:9.5f}")
    print(f"{'m':>4} {'':18} {sum(modes['Count']):9.0f} {len(in_cell):9d} {pack_fractions[-1]:9.5f} {cell_fractions[-1]:9.5f}")
    edges = " x ".join(f"{edge:.3f}" for edge in field(cell, "BoxSize"))
    print(f"\ncell     {edges} {unit}, overlap {field(cell, 'OverlapPercent'):.4f} %")
    print(f"F2       {field(cell, 'StartObjective'):.4f} -> {field(cell, 'Objective'):.4f} in {field(cell, 'Iterations'):.0f} "
          f"iterations, ended by: {field(cell, 'EndedBy')}")
    print(f"time     {seconds:.1f} s for the cell")


def write_files(job):
    """Packs as XML with inline binary, which ParaView 5.11 reads everywhere (its default, appended data, fails with newer
    expat libraries); tables as CSV with all digits, in the order of their columns, which ParaView's own writer sorts."""
    os.makedirs(job.args.output, exist_ok=True)
    for name, source, port in job.point_files:
        writer = vtkXMLPolyDataWriter()
        writer.SetDataModeToBinary()
        writer.SetInputData(fetch(source, port))
        writer.SetFileName(job.path(name))
        if not writer.Write():
            raise RuntimeError(f"Cannot write {job.path(name)}.")
    for name, source, port in job.table_files:
        table = columns(fetch(source, port))
        with open(job.path(name), "w", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(table)
            for row in zip(*table.values()):
                writer.writerow(value if isinstance(value, str) else f"{value:.17g}" for value in row)


def main():
    args = parse_arguments()
    job = Job(args)
    print(f"reading  {args.input}")
    print(f"         {fetch(job.modes).GetNumberOfPoints()} spheres, overlap {field(fetch(job.two_point), 'OverlapPercent'):.4f} %")
    print(f"cell     {args.particles} spheres, until F2 <= {args.target:g} or {args.iterations} iterations …", flush=True)
    start = time.time()
    fetch(job.cell)
    print_summary(job, time.time() - start)
    write_files(job)
    print(f"files    {job.path('')}")
    if args.check:
        check_all(job)
        print("check    passed")


# ---- Checks: everything below is plain Python on the fetched results ----


def require(condition, reason):
    if not condition:
        raise AssertionError(reason)


def close(a, b, tolerance):
    return abs(a - b) <= tolerance


def check_all(job):
    for check in (check_modes, check_pack_probabilities, check_cell, check_objective, check_cell_by_throws, check_replicas, check_files):
        check(job)
        print(f"check    {check.__doc__.splitlines()[0]}", flush=True)


def check_modes(job):
    """the pack is the file's, and the modes divide its spheres by size"""
    with open(job.args.input) as file:
        rows = sorted(tuple(float(row[c]) for c in ("x", "y", "z", "radius")) for row in csv.DictReader(file))
    pack = spheres(fetch(job.modes))
    require(sorted(sphere[:4] for sphere in pack) == rows, "the pack's spheres are not those of the file")
    modes, volume = columns(fetch(job.modes, 1)), math.prod(job.args.box)
    fractions = columns(fetch(job.one_point))["VolumeFraction"]
    largest = 0.0
    for i, mode in enumerate(modes["Mode"]):
        radii = [sphere[3] for sphere in pack if sphere[4] == mode]
        require(len(radii) == modes["Count"][i], f"mode {mode}: Count is not the number of its spheres")
        require(largest < min(radii), f"mode {mode} overlaps the one below")
        largest = max(radii)
        fraction = sum(4.0 / 3.0 * math.pi * radius**3 for radius in radii) / volume
        require(close(fraction, modes["VolumeFraction"][i], 1e-12), f"mode {mode}: VolumeFraction is not {fraction}")
        require(close(fraction, fractions[i], 1e-12), f"mode {mode}: c_r is not {fraction}")
    require(close(sum(fractions), 1.0, 1e-12), "the c_r do not add to 1")


def phases_of(job):
    return [str(i + 1) for i in range(len(columns(fetch(job.modes, 1))["Mode"]))] + ["m"]


def pair(phases, r, s):
    r, s = sorted((r, s), key=phases.index)
    return f"S_{r}_{s}"


def check_sum_rules(job, table, suffix, fractions, overlap_percent):
    phases = phases_of(job)
    at_zero = 1e-12 + 2.0 * overlap_percent / 100.0  # an overlap counts for both orders of its two spheres
    for r, c_r in zip(phases, fractions):
        own = [table[pair(phases, r, s) + suffix] for s in phases]
        for k, values in enumerate(zip(*own)):
            require(close(sum(values), c_r, 1e-12), f"sum over s of S_{r}_s{suffix} is not c_{r} at lag {k}")
        for s, values in zip(phases, own):
            require(close(values[0], c_r if r == s else 0.0, at_zero), f"S_{r}_{s}{suffix}(0) is wrong")


def check_pack_probabilities(job):
    """S_rs of the pack: lags, values at 0, sums over s, and the same columns beside the cell's"""
    table, fractions = columns(fetch(job.two_point)), columns(fetch(job.one_point))["VolumeFraction"]
    lags = [job.args.maximum_lag * k / job.args.lags for k in range(job.args.lags + 1)]
    require(all(close(a, b, 1e-9) for a, b in zip(table["r"], lags)) and len(table["r"]) == len(lags), "the lags are wrong")
    check_sum_rules(job, table, "", fractions, field(fetch(job.two_point), "OverlapPercent"))
    beside = columns(fetch(job.cell, 2))
    for name, values in table.items():
        require(values == beside[name if name == "r" else name + "_pack"], f"output 2 of the cell has another {name} of the pack")


def check_cell(job):
    """the cell: number of spheres, shares of the modes, volume fractions, no overlap of any pair"""
    cell, modes = fetch(job.cell), columns(fetch(job.modes, 1))
    box, pack = field(cell, "BoxSize"), spheres(fetch(job.cell))
    require(len(pack) == job.args.particles == field(cell, "NumberOfSpheres"), "the cell has not the number of spheres asked for")
    require(field(cell, "BoxPeriodic") == [1, 1, 1] and box[0] == box[1] == box[2], "the cell is no periodic cube")
    fractions = field(cell, "VolumeFractions")
    for i, mode in enumerate(modes["Mode"]):
        radii = [sphere[3] for sphere in pack if sphere[4] == mode]
        share = len(pack) * modes["Count"][i] / sum(modes["Count"])
        require(abs(len(radii) - share) < 1.0 or len(radii) == 1, f"mode {mode}: {len(radii)} spheres for a share of {share}")
        require(all(close(2.0 * radius, modes["VolumeMeanDiameter"][i], 1e-9) for radius in radii), f"mode {mode}: wrong diameter")
        fraction = sum(4.0 / 3.0 * math.pi * radius**3 for radius in radii) / math.prod(box)
        require(close(fraction, fractions[i], 1e-12), f"mode {mode}: c_r of the cell is not {fraction}")
    for a, b in itertools.combinations(pack, 2):
        distance = math.dist(minimum_image(a, b, box), (0.0, 0.0, 0.0))
        require(distance >= a[3] + b[3] - 1e-9, f"spheres at {a[:3]} and {b[:3]} overlap by {a[3] + b[3] - distance}")


def minimum_image(a, b, box):
    return [a[q] - b[q] - box[q] * round((a[q] - b[q]) / box[q]) for q in range(3)]


def check_objective(job):
    """F2 from the columns of pack and cell, and the end of the table of convergence"""
    cell, table, phases = fetch(job.cell), columns(fetch(job.cell, 2)), phases_of(job)
    check_sum_rules(job, table, "_cell", field(cell, "VolumeFractions"), field(cell, "OverlapPercent"))
    f2 = 0.0
    for r, s in itertools.product(phases, phases):
        name = pair(phases, r, s)
        differences = [a - b for a, b in zip(table[name + "_pack"][1:], table[name + "_cell"][1:])]
        f2 += math.sqrt(sum(d * d for d in differences))
    require(close(f2, field(cell, "Objective"), 1e-9), f"Objective is {field(cell, 'Objective')}, but F2 of the columns {f2}")
    require(f2 < field(cell, "StartObjective"), "F2 has not become smaller")
    convergence = columns(fetch(job.cell, 1))
    require(close(convergence["Objective"][-1], f2, 1e-9), "the last row of the convergence is not the cell")
    require(convergence["OverlapPercent"][-1] == field(cell, "OverlapPercent"), "the last row's overlap is not the cell's")
    if field(cell, "EndedBy") == "Target objective":
        require(f2 <= job.args.target, "the target is not reached")


def check_cell_by_throws(job):
    """S_rs of the cell against points thrown at random, within 5 standard errors"""
    cell, table, phases = fetch(job.cell), columns(fetch(job.cell, 2)), phases_of(job)
    box, pack = field(cell, "BoxSize"), spheres(cell)
    bins = max(1, int(box[0] / max(sphere[3] for sphere in pack)))
    grid = {}
    for sphere in pack:
        home = [int(sphere[q] / box[q] * bins) for q in range(3)]
        for shift in itertools.product((-1, 0, 1), repeat=3):
            grid.setdefault(tuple((home[q] + shift[q]) % bins for q in range(3)), set()).add(sphere)

    def phase(point):
        for sphere in grid.get(tuple(int(point[q] / box[q] % 1.0 * bins) % bins for q in range(3)), ()):
            if math.dist(minimum_image(point, sphere, box), (0.0, 0.0, 0.0)) < sphere[3]:
                return str(sphere[4])
        return "m"

    throws, rows, draw = 20000, [job.args.lags * i // 10 for i in (1, 2, 3, 5, 10)], random.Random(1)
    counts = {}
    for _ in range(throws):
        start = [box[q] * draw.random() for q in range(3)]
        direction = [draw.gauss(0.0, 1.0) for q in range(3)]
        norm = math.hypot(*direction)
        first = phase(start)
        for k in rows:
            name = pair(phases, first, phase([start[q] + table["r"][k] * direction[q] / norm for q in range(3)]))
            counts[k, name] = counts.get((k, name), 0) + 1
    for k, (i, r) in itertools.product(rows, enumerate(phases)):
        for s in phases[i:]:
            name = pair(phases, r, s)
            both = 1.0 if r == s else 2.0  # throws from r to s and from s to r
            probability = both * table[name + "_cell"][k]
            error = math.sqrt(max(probability, 1.0 / throws) / throws)
            thrown = counts.get((k, name), 0) / throws
            require(close(thrown, probability, 5.0 * error), f"{name} at lag {k}: {probability / both}, thrown {thrown / both}")


def check_replicas(job):
    """the copies are the images that reach into the box; the surfaces fill the box and end at it"""
    cell = fetch(job.cell)
    box, expected = field(cell, "BoxSize"), 0
    for sphere in spheres(cell):
        for image in itertools.product((-1, 0, 1), repeat=3):
            centre = [sphere[q] + image[q] * box[q] for q in range(3)]
            outside = [max(-centre[q], centre[q] - box[q], 0.0) for q in range(3)]
            expected += image == (0, 0, 0) or math.hypot(*outside) < sphere[3]
    replicas = fetch(job.replicas)
    require(replicas.GetNumberOfPoints() == expected, f"{replicas.GetNumberOfPoints()} spheres with copies, expected {expected}")
    originals, ids = {}, cell.GetPointData().GetArray("Id")
    for i in range(cell.GetNumberOfPoints()):
        originals[ids.GetValue(i)] = cell.GetPoint(i)
    arrays = replicas.GetPointData()
    for i in range(expected):
        original, image = originals[arrays.GetArray("Id").GetValue(i)], arrays.GetArray("Image").GetTuple3(i)
        moved = [original[q] + image[q] * box[q] for q in range(3)]
        require(math.dist(moved, replicas.GetPoint(i)) < 1e-9, f"copy {i} is not its original moved by the box")
    bounds = fetch(job.replicas, 2).GetBounds()
    require(all(close(bounds[2 * q], 0.0, 1e-3) and close(bounds[2 * q + 1], box[q], 1e-3) for q in range(3)),
            f"the surfaces end at {bounds}, not at the box")


def check_files(job):
    """the files, read again, hold what was written, and give the same S_rs of the cell"""
    for name, source, port in job.point_files:
        require_equal_data(fetch(source, port), fetch(XMLPolyDataReader(FileName=[job.path(name)])), name)
    for name, source, port in job.table_files:
        # As text, since nan (no saturation up to the last lag) does not equal itself
        written, read = columns(fetch(source, port)), columns(fetch(CSVReader(FileName=[job.path(name)])))
        require([*map(str, written.items())] == [*map(str, read.items())], f"{name} reads differently")
    again = columns(fetch(TwoPointProbability(Input=XMLPolyDataReader(FileName=[job.path("cell.vtp")]),
                                              MaximumLag=job.args.maximum_lag, NumberOfLags=job.args.lags)))
    table = columns(fetch(job.cell, 2))
    for name, values in again.items():
        if name != "r":
            require(all(close(a, b, 1e-9) for a, b in zip(values, table[name + "_cell"])), f"cell.vtp gives another {name}")


def require_equal_data(written, read, name):
    points = written.GetNumberOfPoints()
    require(read.GetNumberOfPoints() == points and read.GetNumberOfCells() == written.GetNumberOfCells(), f"{name}: wrong size")
    require(values_of(read.GetPoints().GetData()) == values_of(written.GetPoints().GetData()), f"{name}: other points")
    for kind in ("GetPointData", "GetCellData", "GetFieldData"):
        ours, theirs = getattr(written, kind)(), getattr(read, kind)()
        for i in range(ours.GetNumberOfArrays()):
            array = ours.GetAbstractArray(i)
            again = theirs.GetAbstractArray(array.GetName())
            require(again is not None and values_of(again) == values_of(array), f"{name}: {array.GetName()} reads differently")


def values_of(array):
    if array.IsNumeric():
        return array.GetNumberOfComponents(), bytes(memoryview(array))
    return [array.GetVariantValue(i).ToString() for i in range(array.GetNumberOfValues())]


if __name__ == "__main__":
    try:
        main()
    except Exception:
        # Under mpirun an exception that leaves the script would keep the other ranks waiting for ever
        sys.exit(traceback.format_exc())
