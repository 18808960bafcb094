# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""The checks of unit_cell.py: plain Python on the fetched results, by independent means. `job` has the filters, files and options of its main."""
import csv
import itertools
import math
import random

from paraview.simple import *

from common import close, fetch, field, minimum_image, pair, path_in, require, require_equal_data, require_equal_tables, spheres, table_of


def check_modes(job):
    """the pack is the file's, and the modes divide its spheres by size"""
    with open(job.args.input) as file:
        rows = sorted(tuple(float(row[c]) for c in ("x", "y", "z", "radius")) for row in csv.DictReader(file))
    pack = spheres(fetch(job.modes))
    require(sorted(sphere[:4] for sphere in pack) == rows, "the pack's spheres are not those of the file")
    modes, volume = table_of(job.modes, 1), math.prod(job.args.box)
    fractions = table_of(job.one_point)["VolumeFraction"]
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
    return [str(i + 1) for i in range(len(table_of(job.modes, 1)["Mode"]))] + ["m"]


def check_sum_rules(job, table, suffix, fractions, overlap_percent):
    phases = phases_of(job)
    at_zero = 1e-12 + 2.0 * overlap_percent / 100.0  # an overlap counts in both orders of its two spheres
    for r, c_r in zip(phases, fractions):
        own = [table[pair(phases, r, s) + suffix] for s in phases]
        for k, values in enumerate(zip(*own)):
            require(close(sum(values), c_r, 1e-12), f"sum over s of S_{r}_s{suffix} is not c_{r} at lag {k}")
        for s, values in zip(phases, own):
            require(close(values[0], c_r if r == s else 0.0, at_zero), f"S_{r}_{s}{suffix}(0) is wrong")


def check_pack_probabilities(job):
    """S_rs of the pack: lags, values at 0, sums over s, and the same columns beside the cell's"""
    table, fractions = table_of(job.two_point), table_of(job.one_point)["VolumeFraction"]
    lags = [job.args.maximum_lag * k / job.args.lags for k in range(job.args.lags + 1)]
    require(all(close(a, b, 1e-9) for a, b in zip(table["r"], lags)) and len(table["r"]) == len(lags), "the lags are wrong")
    check_sum_rules(job, table, "", fractions, field(fetch(job.two_point), "OverlapPercent"))
    beside = table_of(job.cell, 2)
    for name, values in table.items():
        require(values == beside[name if name == "r" else name + "_pack"], f"output 2 of the cell has another {name} of the pack")


def check_cell(job):
    """the cell: number of spheres, shares of the modes, volume fractions, no overlap of any pair"""
    cell, modes = fetch(job.cell), table_of(job.modes, 1)
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


def check_objective(job):
    """F2 from the columns of pack and cell, and the end of the table of convergence"""
    cell, table, phases = fetch(job.cell), table_of(job.cell, 2), phases_of(job)
    check_sum_rules(job, table, "_cell", field(cell, "VolumeFractions"), field(cell, "OverlapPercent"))
    f2 = 0.0
    for r, s in itertools.product(phases, phases):
        name = pair(phases, r, s)
        differences = [a - b for a, b in zip(table[name + "_pack"][1:], table[name + "_cell"][1:])]
        f2 += math.sqrt(sum(d * d for d in differences))
    require(close(f2, field(cell, "Objective"), 1e-9), f"Objective is {field(cell, 'Objective')}, but F2 of the columns {f2}")
    require(f2 < field(cell, "StartObjective"), "F2 has not become smaller")
    convergence = table_of(job.cell, 1)
    require(close(convergence["Objective"][-1], f2, 1e-9), "the last row of the convergence is not the cell")
    require(convergence["OverlapPercent"][-1] == field(cell, "OverlapPercent"), "the last row's overlap is not the cell's")
    if field(cell, "EndedBy") == "Target objective":
        require(f2 <= job.args.target, "the target is not reached")


def check_cell_by_throws(job):
    """S_rs of the cell against points thrown at random, within 5 standard errors"""
    cell, table, phases = fetch(job.cell), table_of(job.cell, 2), phases_of(job)
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
    for name, (source, port) in job.points.items():
        require_equal_data(fetch(source, port), fetch(XMLPolyDataReader(FileName=[path_in(job.args.output, name)])), name)
    require_equal_tables(job.args.output, job.tables)
    again = table_of(TwoPointProbability(Input=XMLPolyDataReader(FileName=[path_in(job.args.output, "cell.vtp")]),
                                         MaximumLag=job.args.maximum_lag, NumberOfLags=job.args.lags))
    table = table_of(job.cell, 2)
    for name, values in again.items():
        if name != "r":
            require(all(close(a, b, 1e-9) for a, b in zip(values, table[name + "_cell"])), f"cell.vtp gives another {name}")


CHECKS = (check_modes, check_pack_probabilities, check_cell, check_objective, check_cell_by_throws, check_replicas, check_files)
