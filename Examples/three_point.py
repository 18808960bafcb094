# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Computes three-point probabilities of a sphere pack and of its unit cell, compares them, and writes both as files.

    mpirun -np 2 pvbatch three_point.py --output results

sorts the spheres of the pack into modes, reconstructs the unit cell, and computes S_rsq(r1, r2, theta) of both for some triples of
phases, with standard errors, their limits, their differences and the third-order parameters. The modes are of equal volume: with
modes of equal width modes 3 and 5 of the bead pack hold 0.2 % and 0.7 % of it, and their S_355 of some 1e-5 would be lost in the
noise. No display is needed. With --check it then tests its own results and ends with an error where one of them fails.
"""
import itertools
import math
import os
import random
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from paraview.simple import *
from vtkmodules.vtkIOXML import vtkXMLImageDataReader

from check_pack_statistics import blocks
from common import (add_output, check_all, close, fetch, field, make_parser, minimum_image, norm, pair, path_in, read_pack, require,
                    require_equal_images, require_equal_tables, run, sort_spheres, spheres, standard_error, table_of, whole_image, write_image,
                    write_tables)

MEDIA = ("pack", "cell")
PLACES = {"r1 axis": (1, 0), "r2 axis": (0, 1), "diagonal": (1, 1)}  # the steps of r1 and r2 in the limits


def parse_arguments():
    parser = make_parser("three_point.py", __doc__, "Equal Volume")
    cell = parser.add_argument_group("cell")
    cell.add_argument("--particles", type=int, default=1082, help="spheres in the cell")
    cell.add_argument("--target", type=float, default=0.08, help="end when F2 is this small; 0: never, for the best cell")
    cell.add_argument("--iterations", type=int, default=1000, help="end after so many iterations")
    three = parser.add_argument_group("three-point probabilities")
    three.add_argument("--phases", default="3 5 5; 7 7 5; m m m", help="triples of phases r s q")
    three.add_argument("--maximum-lag", type=float, default=200.0, help="last lag of r1, r2 and of S_rs(r)")
    three.add_argument("--lags", type=int, default=277, help="number K of lags after 0")
    three.add_argument("--directions", type=int, default=20, help="rays of a throw; theta goes in steps of 360 degrees / this")
    three.add_argument("--throws", type=int, default=50000, help="random points and planes, of pack and cell each")
    parser.add_argument("--seed", type=int, default=1, help="seed of the cell and of the throws")
    add_output(parser, "three_point_results")
    return parser.parse_args()


class Job:
    """The filters, and the folder their results go to."""

    def __init__(self, args):
        self.args = args
        self.modes = sort_spheres(read_pack(args), args)
        lags = {"MaximumLag": args.maximum_lag, "NumberOfLags": args.lags}
        # By F2 alone, so that no more than S_rs tells the cell of the pack
        self.cell = UnitCellReconstruction(Input=self.modes, NumberOfParticles=args.particles, TargetObjective=args.target,
                                           MaximumIterations=args.iterations, Seed=args.seed, ContactWeight=0, PoreWeight=0, **lags)
        self.medium = {"pack": self.modes, "cell": self.cell}
        self.two = {name: TwoPointProbability(Input=medium, **lags) for name, medium in self.medium.items()}
        self.three = {name: ThreePointProbability(Input=medium, Phases=args.phases, NumberOfDirections=args.directions,
                                                  NumberOfThrows=args.throws, StandardErrors=1, Seed=args.seed, **lags)
                      for name, medium in self.medium.items()}
        self.compare_two = CompareProbabilities(Input=self.two["pack"], Cell=[self.two["cell"]])
        self.compare_three = CompareProbabilities(Input=self.three["pack"], Cell=[self.three["cell"]])
        self.images = {}

    def tables(self):
        """What is written: of each file the filter and its output."""
        files = {"modes.csv": (self.modes, 1), "comparison_two_point.csv": (self.compare_two, 0),
                 "comparison_three_point.csv": (self.compare_three, 0)}
        for name in MEDIA:
            files[f"two_point_{name}.csv"] = self.two[name], 0
            files[f"limits_{name}.csv"] = self.three[name], 1
            files[f"checks_{name}.csv"] = self.three[name], 2
            if self.parameters():
                files[f"third_order_{name}.csv"] = self.three[name], 3
        return files

    def image(self, name):
        """S_rsq of pack or cell, or their difference."""
        if name not in self.images:
            self.images[name] = whole_image(self.compare_three, 2) if name == "difference" else whole_image(self.three[name], 0)
        return self.images[name]

    def values(self, name, array):
        return list(memoryview(self.image(name).GetPointData().GetArray(array)))

    def place(self, k1, k2, t):
        """The place of a point in the values of an image."""
        return k1 + (self.args.lags + 1) * (k2 + (self.args.lags + 1) * t)

    def triples(self):
        """Names of the arrays, S_3_5_5 and so on."""
        return list(dict.fromkeys(table_of(self.three["pack"], 2)["Triple"]))

    def parameters(self):
        """The triples of one phase, which have third-order parameters."""
        return [triple for triple in self.triples() if len(set(triple.split("_")[1:])) == 1]


def print_summary(job, seconds):
    args, checks = job.args, {name: table_of(job.three[name], 2) for name in MEDIA}
    print(f"\n{'limits of':>10} {'':9} {'':>12} {'pack':>21} {'cell':>21}   norm of the difference over {args.lags} lags ± standard error")
    for i, triple in enumerate(checks["pack"]["Triple"]):
        both = [f"{checks[name]['Difference'][i]:.6f} ± {checks[name]['StandardError'][i]:.6f}" for name in MEDIA]
        print(f"{triple:>10} {checks['pack']['Place'][i]:9} {checks['pack']['Limit'][i]:>12} {both[0]:>21} {both[1]:>21}")
    three, two = table_of(job.compare_three), table_of(job.compare_two)
    print(f"\n{'difference':>10} {'|pack|':>10} {'|cell|':>10} {'|pack - cell|':>14} {'largest':>10} {'%':>8}")
    for table, rows in ((three, range(len(three["Quantity"]))), (two, [len(two["Quantity"]) - 1])):
        for i in rows:
            name = "all S_rs" if table is two else "all S_rsq" if table["Quantity"][i] == "all" else table["Quantity"][i]
            print(f"{name:>10} {table['Pack'][i]:10.5f} {table['Cell'][i]:10.5f} {table['Difference'][i]:14.5f} "
                  f"{table['LargestDifference'][i]:10.6f} {table['Percent'][i]:8.3f}")
    if job.parameters():
        print(f"\n{'phase':>10} {'':>5} {'c':>8} {'zeta':>19} {'eta':>19}")
        tables = {name: table_of(job.three[name], 3) for name in MEDIA}
        for i, name in itertools.product(range(len(tables["pack"]["Phase"])), MEDIA):
            table = tables[name]
            both = [f"{table[what][i]:.5f} ± {table[what + '_error'][i]:.5f}" for what in ("zeta", "eta")]
            print(f"{table['Phase'][i]:>10} {name:>5} {table['VolumeFraction'][i]:8.5f} {both[0]:>19} {both[1]:>19}")
    print(f"\nmemory   {field(fetch(job.three['pack']), 'EstimatedMemory'):.0f} MB on every rank for the three-point probabilities")
    print("time     " + ", ".join(f"{name} {value:.1f} s" for name, value in seconds.items()))


def main():
    args = parse_arguments()
    job = Job(args)
    print(f"reading  {args.input}")
    print(f"         {fetch(job.modes).GetNumberOfPoints()} spheres", flush=True)
    seconds = {}
    for name, source in (("cell", job.cell), ("S_rsq of the pack", job.three["pack"]), ("S_rsq of the cell", job.three["cell"])):
        start = time.time()
        fetch(source)
        seconds[name] = time.time() - start
    print(f"cell     {fetch(job.cell).GetNumberOfPoints()} spheres, F2 {field(fetch(job.cell), 'Objective'):.4f}")
    print_summary(job, seconds)
    start = time.time()
    write_tables(args.output, job.tables())
    for name in (*MEDIA, "difference"):
        write_image(args.output, f"three_point_{name}.vti", job.image(name))
    print(f"files    {os.path.abspath(args.output)} in {time.time() - start:.1f} s", flush=True)
    if args.check:
        check_all(CHECKS, job)


# ---- Checks: everything below is plain Python on the fetched results ----


def phases_of(job):
    return [str(i + 1) for i in range(len(table_of(job.modes, 1)["Mode"]))] + ["m"]


def fractions(job, name):
    """c_r of pack or cell from the volumes of the spheres, by phase."""
    phases, pack = phases_of(job), spheres(fetch(job.medium[name]))
    volume = math.prod(job.args.box if name == "pack" else field(fetch(job.cell), "BoxSize"))
    c = {r: math.fsum(4.0 / 3.0 * math.pi * sphere[3]**3 for sphere in pack if str(sphere[4]) == r) / volume for r in phases[:-1]}
    return {**c, "m": 1.0 - sum(c.values())}


def check_images(job):
    """images: size, spacing, arrays, probabilities from 0 to 1 with finite errors, and r1 and r2 swapped where s is q"""
    args, points = job.args, job.args.lags + 1
    for name in MEDIA:
        image = job.image(name)
        require(image.GetDimensions() == (points, points, args.directions // 2 + 1), f"{name}: {image.GetDimensions()} points")
        spacing = (args.maximum_lag / args.lags, args.maximum_lag / args.lags, 360.0 / args.directions)
        require(all(close(a, b, 1e-9) for a, b in zip(image.GetSpacing(), spacing)), f"{name}: spacing {image.GetSpacing()}")
        require(all(close(x, 0.0, 1e-9) for x in image.GetOrigin()), f"{name}: origin {image.GetOrigin()}")
        arrays = [image.GetPointData().GetArrayName(i) for i in range(image.GetPointData().GetNumberOfArrays())]
        require(arrays == [array for triple in job.triples() for array in (triple, triple + "_error")], f"{name}: arrays {arrays}")
        for triple in job.triples():
            values, errors = job.values(name, triple), job.values(name, triple + "_error")
            require(0.0 <= min(values) and max(values) <= 1.0, f"{triple} of the {name} is no probability")
            require(all(0.0 <= error < 1.0 for error in errors), f"{triple} of the {name} has bad errors")
            _, r, s, q = triple.split("_")
            if s == q:
                for t in range(args.directions // 2 + 1):
                    rows = [values[job.place(0, k, t):job.place(points, k, t)] for k in range(points)]
                    require(rows == [*map(list, zip(*rows))], f"{triple} of the {name} changes with r1 and r2 swapped")


def check_coincident_points(job):
    """points that coincide: S_rsq is 0 unless their phases do, and S_rrr(0, 0) is c_r at every angle"""
    args, phases = job.args, phases_of(job)
    octants = [field(checks, "SphereVolumeFractions") for checks, _ in blocks(job)]
    lags, angles = range(args.lags + 1), range(args.directions // 2 + 1)
    for name, triple in itertools.product(MEDIA, job.triples()):
        values, errors = job.values(name, triple), job.values(name, triple + "_error")
        _, r, s, q = triple.split("_")
        what = f"{triple} of the {name}"
        # These are counts, so exactly 0
        require(q == r or all(values[job.place(k, 0, t)] == 0.0 for k in lags for t in angles), f"{what} is not 0 where r2 = 0")
        require(s == r or all(values[job.place(0, k, t)] == 0.0 for k in lags for t in angles), f"{what} is not 0 where r1 = 0")
        require(s == q or all(values[job.place(k, k, 0)] == 0.0 for k in lags), f"{what} is not 0 where r1 = r2 and theta = 0")
        if r == s == q:
            at_zero = [values[job.place(0, 0, t)] for t in angles]
            require(all(close(value, at_zero[0], 1e-12) for value in at_zero), f"{what} changes with the angle where r1 = r2 = 0")
            # The spheres are counted in the whole window, the throws lie within a margin of it: 8 octants tell how much parts of the pack
            # differ (see pack_statistics.py); the limit is 5 standard errors
            i = phases.index(r)
            part = standard_error([octant[i] for octant in octants]) if name == "pack" else 0.0
            c = fractions(job, name)[r]
            bound = 5.0 * math.hypot(part, errors[0])
            require(close(at_zero[0], c, bound), f"{what} is {at_zero[0]} where r1 = r2 = 0, c_{r} {c}, bound {bound}")


def check_limits(job):
    """limits (10): the columns are those of the image and of S_rs, and they agree within 5 standard errors"""
    phases, lags = phases_of(job), range(job.args.lags + 1)
    octants = [two for _, two in blocks(job)]
    for name, triple in itertools.product(MEDIA, job.triples()):
        limits, checks = table_of(job.three[name], 1), table_of(job.three[name], 2)
        values, errors = job.values(name, triple), job.values(name, triple + "_error")
        _, r, s, q = triple.split("_")
        expected = {"r1 axis": (r, s) if q == r else None, "r2 axis": (r, q) if s == r else None, "diagonal": (r, s) if s == q else None}
        for place, (one, two) in PLACES.items():
            column = f"{triple}_{place.replace(' ', '_')}"
            along = [job.place(one * k, two * k, 0) for k in lags]
            require(limits[column] == [values[i] for i in along], f"{column} of the {name} is not that of the image")
            require(limits[column + "_error"] == [errors[i] for i in along], f"{column}_error of the {name} is not that of the image")
            both = expected[place] and pair(phases, *expected[place])
            limit = table_of(job.two[name])[both] if both else [0.0] * len(lags)
            if field(fetch(job.three[name]), "LimitMethod") == "Exact Pair Sum":
                require(limits[column + "_limit"] == limit, f"{column}_limit of the {name} is not {both}")
            row = [*zip(checks["Triple"], checks["Place"])].index((triple, place))
            difference = norm([a - b for a, b in zip(limits[column], limit)])
            require(close(checks["Difference"][row], difference, 1e-12), f"{column} of the {name}: difference is not {difference}")
            require(close(checks["StandardError"][row], norm(limits[column + "_error"]), 1e-12), f"{column}: wrong standard error")
            # The norm of the standard errors is that of a difference, root mean square; lags go together, so that the norm scatters as a single
            # number does; the limit is 5 of them. For parts of the pack see check_coincident_points
            end = len(lags)
            scatter = [0.0] * end
            if name == "pack" and both:
                end = job.block_lags + 1
                scatter = [standard_error([table[both][k] if both in table else 0.0 for table in octants]) for k in range(end)]
            bound = 5.0 * norm([math.hypot(a, b) for a, b in zip(scatter, limits[column + "_error"])])
            difference = norm([a - b for a, b in zip(limits[column][:end], limit)])
            require(difference <= bound, f"{column} of the {name} differs by {difference}, bound {bound}")
        # The points are far apart, in opposite directions
        c = fractions(job, name)
        row = [*zip(checks["Triple"], checks["Place"])].index((triple, "far apart"))
        last = job.place(lags[-1], lags[-1], job.args.directions // 2)
        if field(fetch(job.three[name]), "LimitMethod") == "Exact Pair Sum":
            require(close(checks["Difference"][row], abs(values[last] - c[r] * c[s] * c[q]), 1e-12), f"{triple}: wrong far apart")


def check_comparison(job):
    """comparison: |pack - cell| of the images point by point, norms and percentages, equations 16 and 17"""
    three, two, phases = table_of(job.compare_three), table_of(job.compare_two), phases_of(job)
    sums = [0.0] * 3
    require(three["Quantity"] == job.triples() + ["all"], f"rows {three['Quantity']}")
    for i, triple in enumerate(job.triples()):
        pack, cell, difference = (job.values(name, triple) for name in (*MEDIA, "difference"))
        require(difference == [abs(a - b) for a, b in zip(pack, cell)], f"{triple} is not |pack - cell|")
        errors = [job.values(name, triple + "_error") for name in (*MEDIA, "difference")]
        require(all(close(math.hypot(a, b), c, 1e-15) for a, b, c in zip(*errors)), f"{triple}_error is not that of a difference")
        norms = [math.sqrt(math.fsum(value * value for value in values)) for values in (pack, cell, difference)]
        for column, value in zip(("Pack", "Cell", "Difference"), norms):
            require(close(three[column][i], value, 1e-6 * value), f"{triple}: {column} is not {value}")
        require(three["LargestDifference"][i] == max(difference), f"{triple}: another largest difference")
        require(close(three["Percent"][i], 200.0 * norms[2] / (norms[0] + norms[1]), 1e-4), f"{triple}: another percentage")
        sums = [a + b for a, b in zip(sums, norms)]
    require(close(three["Percent"][-1], 200.0 * sums[2] / (sums[0] + sums[1]), 1e-4), "another percentage of all triples")
    pack, cell, sums = table_of(job.two["pack"]), table_of(job.two["cell"]), [0.0] * 3
    for r, s in itertools.product(phases, phases):
        name = pair(phases, r, s)
        sums = [a + norm(b) for a, b in zip(sums, (pack[name], cell[name], [x - y for x, y in zip(pack[name], cell[name])]))]
    require(close(two["Percent"][-1], 200.0 * sums[2] / (sums[0] + sums[1]), 1e-9), "S_rs: not the percentage of equation 17")
    c = {name: [table_of(job.two[name])[pair(phases, r, r)][0] for r in phases] for name in MEDIA}
    for i, r in enumerate(phases[:-1]):
        percent = 100.0 * abs(c["pack"][i] - c["cell"][i]) / sum(c["pack"][:-1])
        require(close(two["Percent"][two["Quantity"].index("c_" + r)], percent, 1e-9), f"c_{r}: not the percentage of equation 16")


class Lookup:
    """The phase at a point of a fetched pack, found by bins as large as the largest sphere."""

    def __init__(self, pack, origin, box, periodic):
        self.origin, self.box, self.periodic, self.bins = origin, box, periodic, {}
        all_spheres = spheres(pack)
        self.margin = 0.0 if periodic else max(sphere[3] for sphere in all_spheres)
        self.count = [max(1, int(edge / max(sphere[3] for sphere in all_spheres))) for edge in box]
        for sphere in all_spheres:
            home = self.bin_of(sphere)
            for shift in itertools.product((-1, 0, 1), repeat=3):
                self.bins.setdefault(self.wrap([a + b for a, b in zip(home, shift)]), set()).add(sphere)

    def wrap(self, place):
        return tuple(i % n for i, n in zip(place, self.count)) if self.periodic else tuple(place)

    def bin_of(self, point):
        return [math.floor((point[q] - self.origin[q]) / self.box[q] * self.count[q]) for q in range(3)]

    def is_inside(self, point):
        return self.periodic or all(self.margin <= point[q] - self.origin[q] <= self.box[q] - self.margin for q in range(3))

    def random_point(self, draw):
        return [self.origin[q] + self.margin + (self.box[q] - 2.0 * self.margin) * draw.random() for q in range(3)]

    def phase(self, point):
        modes = [sphere[4] for sphere in self.bins.get(self.wrap(self.bin_of(point)), ())
                 if math.dist(minimum_image(point, sphere, self.box) if self.periodic else point,
                              (0.0, 0.0, 0.0) if self.periodic else sphere[:3]) < sphere[3]]
        return str(min(modes)) if modes else "m"


def random_frame(draw):
    """A random direction and another at a right angle to it."""
    first, second = ([draw.gauss(0.0, 1.0) for _ in range(3)] for _ in range(2))
    length = math.hypot(*first)
    first = [a / length for a in first]
    along = sum(a * b for a, b in zip(first, second))
    second = [b - along * a for a, b in zip(first, second)]
    length = math.hypot(*second)
    return first, [b / length for b in second]


def check_throws(job):
    """S_rsq against points thrown at random, within 5 standard errors"""
    args, number = job.args, 20000
    last, step, angle = args.lags, args.maximum_lag / args.lags, 2.0 * math.pi / args.directions
    places = [(last // 10, last // 10, 0), (last // 4, last // 8, args.directions // 5), (last // 10, last // 3, args.directions // 2),
              (last // 2, last // 2, args.directions // 20), (last, last // 2, args.directions // 4)]
    for name in MEDIA:
        lookup = Lookup(fetch(job.medium[name]), *((args.origin, args.box, False) if name == "pack" else
                                                   ([0.0] * 3, field(fetch(job.cell), "BoxSize"), True)))
        draw, counts, inside = random.Random(2), {}, [0] * len(places)
        for _ in range(number):
            start, (u, w) = lookup.random_point(draw), random_frame(draw)
            first = lookup.phase(start)
            for n, (k1, k2, t) in enumerate(places):
                a, b = step * k2 * math.cos(angle * t), step * k2 * math.sin(angle * t)
                one = [x + step * k1 * p for x, p in zip(start, u)]
                two = [x + a * p + b * o for x, p, o in zip(start, u, w)]
                if lookup.is_inside(one) and lookup.is_inside(two):
                    inside[n] += 1
                    key = n, f"S_{first}_{lookup.phase(one)}_{lookup.phase(two)}"
                    counts[key] = counts.get(key, 0) + 1
        for (n, place), triple in itertools.product(enumerate(places), job.triples()):
            i = job.place(*place)
            probability, own_error = job.values(name, triple)[i], job.values(name, triple + "_error")[i]
            error = math.hypot(own_error, math.sqrt(max(probability, 1.0 / inside[n]) / inside[n]))
            thrown = counts.get((n, triple), 0) / inside[n]
            require(close(thrown, probability, 5.0 * error),
                    f"{triple} of the {name} at {place} is {probability}, thrown {thrown}, standard error {error}")


def hat_integrals(lags, step):
    """Weights of the lags in the integral of f(r) / r dr, f linear between every step-th lag and 0 at r = 0."""
    nodes = [*range(0, lags, step), lags]
    weights = [0.0] * (lags + 1)
    weights[nodes[1]] = 1.0
    for a, b in zip(nodes[1:], nodes[2:]):
        weights[a] += b / (b - a) * math.log(b / a) - 1.0
        weights[b] += 1.0 - a / (b - a) * math.log(b / a)
    return weights


def check_parameters(job):
    """third-order parameters against a quadrature of the image of our own, and from 0 to 1"""
    args, half = job.args, job.args.directions // 2
    if args.directions % 2 or half < 4:
        return
    rules = [(2.0, hat_integrals(args.lags, 1)), (-1.0, hat_integrals(args.lags, 2))]
    # The rule of Clenshaw and Curtis for cos theta
    angular = []
    for t in range(half + 1):
        series = sum((1.0 if 2 * j == half else 2.0) / (4 * j * j - 1) * math.cos(2.0 * j * t * math.pi / half)
                     for j in range(1, half // 2 + 1))
        angular.append((1.0 if t in (0, half) else 2.0) / half * (1.0 - series))
    for name, triple in itertools.product(MEDIA, job.parameters()):
        values, table, integrals = job.values(name, triple), table_of(job.three[name], 3), {2: 0.0, 4: 0.0}
        for t in range(half + 1):
            x = math.cos(math.pi * t / half)
            rows = [values[job.place(0, k, t):job.place(args.lags + 1, k, t)] for k in range(args.lags + 1)]
            total = math.fsum(factor * outer * sum(a * b for a, b in zip(radial, row))
                              for factor, radial in rules for outer, row in zip(radial, rows) if outer)
            integrals[2] += angular[t] * (3.0 * x * x - 1.0) / 2.0 * total
            integrals[4] += angular[t] * (35.0 * x**4 - 30.0 * x * x + 3.0) / 8.0 * total
        phase, c = triple.split("_")[1], values[0]
        zeta = 9.0 / (2.0 * c * (1.0 - c)) * integrals[2]
        eta = 5.0 / 21.0 * zeta + 150.0 / (7.0 * c * (1.0 - c)) * integrals[4]
        own, rest = table["Phase"].index(phase), table["Phase"].index("all but " + phase)
        for what, value in (("VolumeFraction", c), ("zeta", zeta), ("eta", eta)):
            got = table[what]
            require(close(got[own], value, 1e-9), f"{what} of {phase} in the {name} is {got[own]}, by quadrature {value}")
            require(close(got[rest], 1.0 - value, 1e-9), f"{what} of all but {phase} in the {name} is not 1 - {value}")
            error = table[what + "_error"][own] if what != "VolumeFraction" else 0.0
            require(-5.0 * error <= value <= 1.0 + 5.0 * error, f"{what} of {phase} in the {name} is out of range")


def check_files(job):
    """the files, read again, hold what was written"""
    require_equal_tables(job.args.output, job.tables())
    for name in (*MEDIA, "difference"):
        reader = vtkXMLImageDataReader()  # not on several ranks, of which Fetch would bring one slab
        reader.SetFileName(path_in(job.args.output, f"three_point_{name}.vti"))
        reader.Update()
        require_equal_images(job.image(name), reader.GetOutput(), name)


CHECKS = (check_images, check_coincident_points, check_limits, check_comparison, check_throws, check_parameters, check_files)


if __name__ == "__main__":
    run(main)
