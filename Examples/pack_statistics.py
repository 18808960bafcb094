# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Computes the statistics of a sphere pack by all methods, with their errors, and writes them as files.

    mpirun -np 2 pvbatch pack_statistics.py --output results

is the paper's program STAT3D for a pack of your own: one- and two-point probabilities exactly, by chords and by the paper's template,
their checks, gradients, isotropy, chord lengths, radial distribution functions, autocovariances, and S_rs(x) as an image. No display
is needed. With --check it then tests its own results and ends with an error where one of them fails.
"""
import os
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from paraview.simple import *

from check_pack_statistics import CHECKS, isotropy_in_percent, largest_pairs, one_point
from common import (check_all, fetch, field, parse_arguments, read_pack, run, sort_spheres, table_of, whole_image, write_image, write_table,
                    write_tables)

ARGUMENTS = parse_arguments(
    "pack_statistics.py", __doc__, "statistics_results",
    maximum_lag=(200.0, "last lag r of S_rs(r)"),
    lags=(277, "number K of lags after 0"),
    lines=(100000, "lines of the chord sampling"),
    throws=(2000, "throws of the paper's template"),
    directions=(32, "directions of the test of isotropy"),
    phase_pairs=("m m; 5 5", "pairs of phases of the map S_rs(x)"),
    resolution=(20, "steps from the centre of the map to its faces"),
    seed=(1, "seed of lines and throws"))
CHORDS, TEMPLATE = "Chord Sampling", "Template Sampling"


class Job:
    """The filters, and the folder their results go to."""

    def __init__(self, args):
        self.args = args
        self.modes = sort_spheres(read_pack(args), args)
        samples = {"NumberOfLines": args.lines, "NumberOfThrows": args.throws, "Seed": args.seed}
        self.one = {method: OnePointProbability(Input=self.modes, Method=method, **samples)
                    for method in ("Sphere Volumes", CHORDS, TEMPLATE)}
        lags = {"MaximumLag": args.maximum_lag, "NumberOfLags": args.lags}
        self.exact = TwoPointProbability(Input=self.modes, **lags)
        self.chords = TwoPointProbability(Input=self.modes, Method=CHORDS, **lags, **samples)
        self.template = TwoPointProbability(Input=self.modes, Method=TEMPLATE, **lags, **samples)
        self.directions = DirectionalProbability(Input=self.modes, NumberOfDirections=args.directions, **lags)
        self.chord_lengths = ChordLengths(Input=self.modes, NumberOfLines=args.lines, Seed=args.seed, **lags)
        self.distances = RadialDistribution(Input=self.modes, **lags)
        self.map = ProbabilityMap(Input=self.modes, PhasePairs=args.phase_pairs, Resolution=args.resolution, MaximumLag=args.maximum_lag)
        self.image = None
        # What is written: of each file the filter and its output
        self.tables = {
            "modes.csv": (self.modes, 1),
            "two_point_exact.csv": (self.exact, 0), "two_point_chords.csv": (self.chords, 0), "two_point_template.csv": (self.template, 0),
            "checks_exact.csv": (self.exact, 1), "checks_chords.csv": (self.chords, 1), "checks_template.csv": (self.template, 1),
            "gradients.csv": (self.exact, 2), "autocovariance.csv": (self.exact, 3), "isotropy.csv": (self.directions, 0),
            "chord_lengths.csv": (self.chord_lengths, 0), "radial_distribution.csv": (self.distances, 0)}

    def phases(self):
        return table_of(self.one["Sphere Volumes"])["Phase"]

    def fetch_map(self):
        if self.image is None:
            self.image = whole_image(self.map, 0)
        return self.image


def print_summary(job, seconds):
    unit, one = job.args.unit, one_point(job)
    print(f"\n{'phase':>5} {'sphere volumes':>15} {'chords':>20} {'template':>20} {'mean chord':>11}")
    mean_chords = field(fetch(job.chord_lengths), "MeanChordLength")
    for i, phase in enumerate(one["Phase"]):
        sampled = [f"{one[name][i]:.5f} ± {one[name + '_error'][i]:.5f}" for name in ("ChordSampling", "TemplateSampling")]
        print(f"{phase:>5} {one['SphereVolumes'][i]:15.5f} {sampled[0]:>20} {sampled[1]:>20} {mean_chords[i]:11.3f}")
    checks = fetch(job.exact, 1)
    print(f"\nsaturation length      {field(fetch(job.exact), 'SaturationLength'):.1f} {unit}, first guess of a cell twice that")
    print(f"error of the chords    {field(fetch(job.chords), 'TotalError'):.4f} (sum over all ordered pairs of the norm over "
          f"{job.args.lags} lags; {job.args.lines} lines)")
    print(f"error of the template  {field(fetch(job.template), 'TotalError'):.4f} ({job.args.throws} throws)")
    print(f"isotropy               largest sigma_S in percent of S: "
          + ", ".join(f"{name} {isotropy_in_percent(job, name):.2f}" for name in largest_pairs(job)))
    print(f"specific surface       {field(checks, 'SpecificSurface'):.6f} 1/{unit} of the spheres, "
          f"{field(checks, 'SpecificSurfaceFromSlope'):.6f} from the slope of S_mm")
    print("time                   " + ", ".join(f"{name} {value:.1f} s" for name, value in seconds.items()))


def main(args):
    job = Job(args)
    print(f"reading  {args.input}")
    print(f"         {fetch(job.modes).GetNumberOfPoints()} spheres", flush=True)
    seconds = {}
    for name, source in (("exact", job.exact), ("chords", job.chords), ("template", job.template), ("directions", job.directions),
                         ("chord lengths", job.chord_lengths), ("distances", job.distances), ("map", job.map)):
        start = time.time()
        fetch(source)
        seconds[name] = time.time() - start
    print_summary(job, seconds)
    write_table(args.output, "one_point.csv", one_point(job))
    write_tables(args.output, job.tables)
    write_image(args.output, "map.vti", job.fetch_map())
    print(f"files    {os.path.abspath(args.output)}")
    if args.check:
        check_all(CHECKS, job)


if __name__ == "__main__":
    run(main, ARGUMENTS)
