# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Convergence study: error against number of lines, throws and lags, as the paper chose its 500 000 throws.

    pvbatch convergence.py --output results
    xvfb-run -a -s "-screen 0 1400x1000x24 -noreset" pvbatch convergence.py --output results --pictures

A periodic pack with the sizes of the bead block is sampled by ever more lines and throws. The exact pair sum of such a pack has no error at
all, so that the true error is known beside the standard error that the filter states. --check ends with an error where errors do not fall as
they should. Pictures are drawn on one rank, and need a display.
"""
import argparse
import csv
import itertools
import math
import os
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from paraview.simple import *

from common import HERE, columns, fetch, field, norm, pair, require, run

CHORDS, TEMPLATE = "Chord Sampling", "Template Sampling"
SAMPLES = {CHORDS: ("NumberOfLines", [100, 300, 1000, 3000, 10000, 30000, 100000]),
           TEMPLATE: ("NumberOfThrows", [10, 30, 100, 300, 1000, 3000])}
LAGS, FINE_LAGS = [25, 50, 100, 200, 400, 800], 1600
PAPER_THROWS = 500000


def parse_arguments():
    parser = argparse.ArgumentParser(prog="pvbatch convergence.py", description=__doc__.split("\n")[0],
                                     formatter_class=argparse.ArgumentDefaultsHelpFormatter)
    parser.add_argument("--particles", type=int, default=1082, help="spheres in the periodic pack")
    parser.add_argument("--maximum-lag", type=float, default=200.0, help="last lag r of S_rs(r)")
    parser.add_argument("--lags", type=int, default=277, help="number K of lags after 0")
    parser.add_argument("--seed", type=int, default=1, help="seed of lines and throws")
    parser.add_argument("--output", default="convergence_results", help="folder for the files")
    parser.add_argument("--pictures", action="store_true", help="draw them too")
    parser.add_argument("--check", action="store_true", help="test the results")
    return parser.parse_args()


def periodic_pack(args):
    """Random spheres without overlap in a periodic cube, in 9 modes."""
    beads = SpherePackReader(FileName=os.path.join(HERE, "Data", "bead_block.csv"), LengthUnit="µm",
                             BoxSize=[1445.372, 1287.892, 789.106])
    modes = ParticleModes(Input=beads, NumberOfModes=9)
    cell = UnitCellReconstruction(Input=modes, NumberOfParticles=args.particles, MaximumIterations=0)
    require(field(fetch(cell), "OverlapPercent") == 0.0, "spheres overlap: the pair sum is not exact")
    return cell


def names_of(table):
    """Every ordered pair of phases as a name of a column, so that S_1_2 comes twice and S_1_1 once."""
    phases = list(dict.fromkeys(name.split("_")[1] for name in table if name.startswith("S_")))
    return [pair(phases, r, s) for r, s in itertools.product(phases, phases)]


def error_against(exact, table):
    """The sum of the norm over all ordered pairs, as F2 has it."""
    return sum(norm([a - b for a, b in zip(exact[name], table[name])]) for name in names_of(exact))


def study_samples(args, cell):
    """{method: table of samples, errors and seconds}; MatrixError is the standard error of S_mm alone."""
    lags = {"MaximumLag": args.maximum_lag, "NumberOfLags": args.lags}
    exact, tables = columns(fetch(TwoPointProbability(Input=cell, **lags))), {}
    for method, (name, numbers) in SAMPLES.items():
        tables[method] = {"Samples": [], "StandardError": [], "TrueError": [], "MatrixError": [], "Seconds": []}
        for number in numbers:
            source = TwoPointProbability(Input=cell, Method=method, Seed=args.seed, **lags, **{name: number})
            start = time.perf_counter()
            source.UpdatePipeline()
            seconds = time.perf_counter() - start
            table = columns(fetch(source))
            taken = field(fetch(source), name)  # lines come in grids: about as many as asked for
            row = [taken, field(fetch(source), "TotalError"), error_against(exact, table), norm(table["S_m_m_error"]), seconds]
            for column, value in zip(tables[method].values(), row):
                column.append(float(value))
    return tables


def study_lags(args, cell):
    """Numbers of lags, the largest error of linear interpolation between them, and that of the specific surface from the slope at 0."""
    fine = columns(fetch(TwoPointProbability(Input=cell, MaximumLag=args.maximum_lag, NumberOfLags=FINE_LAGS)))
    table = {"Lags": [], "InterpolationError": [], "SurfaceError": []}
    for number in LAGS:
        source = TwoPointProbability(Input=cell, MaximumLag=args.maximum_lag, NumberOfLags=number)
        coarse, steps, worst = columns(fetch(source)), FINE_LAGS // number, 0.0
        for name in set(names_of(fine)):
            for i, value in enumerate(fine[name][:-1]):
                k, t = i // steps, i % steps / steps
                worst = max(worst, abs((1.0 - t) * coarse[name][k] + t * coarse[name][k + 1] - value))
        checks = fetch(source, 1)
        surface = field(checks, "SpecificSurface")
        table["Lags"].append(float(number))
        table["InterpolationError"].append(worst)
        table["SurfaceError"].append(abs(field(checks, "SpecificSurfaceFromSlope") / surface - 1.0))
    return table


def fit(x, y):
    """(slope, its standard error) of log y over log x by least squares."""
    x, y, n = [math.log(value) for value in x], [math.log(value) for value in y], len(x)
    mx, my = sum(x) / n, sum(y) / n
    sxx = sum((a - mx)**2 for a in x)
    slope = sum((a - mx) * (b - my) for a, b in zip(x, y)) / sxx
    rest = sum((b - my - slope * (a - mx))**2 for a, b in zip(x, y))
    return slope, math.sqrt(rest / (n - 2) / sxx)


def root_law(table):
    """The standard error times the root of the number of samples, in the (geometric) mean over the numbers."""
    products = [math.log(error * math.sqrt(number)) for number, error in zip(table["Samples"], table["StandardError"])]
    return math.exp(sum(products) / len(products))


def study_target(args, cell, samples):
    """The error of the paper's throws and their seconds, extrapolated; lines and seconds in which chords reach it, measured."""
    template = samples[TEMPLATE]
    target = template["StandardError"][-1] * math.sqrt(template["Samples"][-1] / PAPER_THROWS)
    source = TwoPointProbability(Input=cell, Method=CHORDS, Seed=args.seed, MaximumLag=args.maximum_lag, NumberOfLags=args.lags,
                                 TargetError=target)
    start = time.perf_counter()
    source.UpdatePipeline()
    seconds = time.perf_counter() - start
    data = fetch(source)
    return {"Target": target, "ThrowSeconds": PAPER_THROWS * seconds_a_sample(template), "Lines": field(data, "NumberOfLines"),
            "Reached": field(data, "TotalError"), "LineSeconds": seconds}


def seconds_a_sample(table):
    """From the two largest numbers, so that what a filter takes without any sample drops out."""
    return (table["Seconds"][-1] - table["Seconds"][-2]) / (table["Samples"][-1] - table["Samples"][-2])


def print_tables(args, samples, target, lags):
    for method, table in samples.items():
        print(f"\n{method + ', ' + SAMPLES[method][0][8:].lower():>26} {'standard error':>15} {'true error':>11} {'of S_mm':>9} {'seconds':>9}")
        for number, standard, true, matrix, seconds in zip(*table.values()):
            print(f"{number:26.0f} {standard:15.4f} {true:11.4f} {matrix:9.5f} {seconds:9.3f}")
        powers = {name: fit(table["Samples"], table[name]) for name in ("StandardError", "TrueError", "MatrixError")}
        print("   powers of the number: " + ", ".join(f"{name} {slope:.3f} ± {error:.3f}" for name, (slope, error) in powers.items()))
    print(f"\nerror of the paper's {PAPER_THROWS} throws: {target['Target']:.4f}, in {target['ThrowSeconds']:.0f} s (both extrapolated)")
    print(f"chords reach {target['Reached']:.4f} with {target['Lines']:.0f} lines in {target['LineSeconds']:.1f} s: "
          f"{target['ThrowSeconds'] / target['LineSeconds']:.0f} times cheaper")
    print(f"\n{'lags K':>8} {'step':>8} {'interpolation':>14} {'specific surface':>17}")
    for number, interpolation, surface in zip(*lags.values()):
        print(f"{number:8.0f} {args.maximum_lag / number:8.3f} {interpolation:14.2e} {100.0 * surface:15.3f} %")


def write_tables(args, samples, lags):
    os.makedirs(args.output, exist_ok=True)
    files = {"convergence_chords.csv": samples[CHORDS], "convergence_template.csv": samples[TEMPLATE], "convergence_lags.csv": lags}
    for name, table in files.items():
        with open(os.path.join(args.output, name), "w", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(table)
            writer.writerows([f"{value:.9g}" for value in row] for row in zip(*table.values()))


def check_all(samples, target, lags):
    for method, table in samples.items():
        # This looks at S_mm, whose phase every line and throw meets. The sum over all pairs does not fall so fast at first: phases so rare that
        # few throws meet them have small errors then, both standard and true, and come in with the number of throws. The limit is 4 standard
        # errors of the fit, of 4 or 5 degrees of freedom, and a hundredth: 10 throws are 10 batches, whose error is biased by some percent. The
        # lines of chords come in 64 grids, which cover the pack the more evenly the denser they are: their error falls at least so fast.
        for name in ("MatrixError",) if method == TEMPLATE else ("MatrixError", "StandardError", "TrueError"):
            slope, error = fit(table["Samples"], table[name])
            slack = 4.0 * error + 0.01
            require(slope <= -0.5 + slack and (slope >= -0.5 - slack or method == CHORDS),
                    f"{method}: {name} falls with the power of {slope} ± {error}")
        for number, standard, true, *_ in zip(*table.values()):
            # The true error is one draw, but of the sum of a hundred norms, which go together only in part
            require(0.5 < true / standard < 2.0, f"{method}, {number}: standard error {standard}, true error {true}")
    require(target["Reached"] <= target["Target"], f"the error aimed at is not reached: {target}")  # TargetError promises this
    # An error of linear interpolation falls with the square of the step: a factor of 4. The slope at 0, by differences of second order,
    # would too, were it not for spheres just not in contact: gaps of all sizes down to 0 make S_mm behave as r^2 log r, and the error
    # fall with the step itself: a factor of 2, once the steps are finer than most gaps
    for name, least in (("InterpolationError", 3.0), ("SurfaceError", 1.5)):
        for i in range(3, len(LAGS)):
            ratio = lags[name][i - 1] / lags[name][i]
            require(ratio > least, f"{name} falls by {ratio} only from {LAGS[i - 1]} to {LAGS[i]} lags")


# ---- Pictures ----


def powers(values):
    """Powers of ten that enclose the values."""
    low, high = math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)))
    return [10.0**e for e in range(low, high + 1)]


def draw(args, samples, lags):
    from statistics_pictures import Charts  # imported only here, as nothing else draws

    charts = Charts(args.output)
    series, all_seconds, all_errors = [], [], []
    for method, colour in ((TEMPLATE, "#bb3344"), (CHORDS, "#0077bb")):
        table, label = samples[method], f"{method.split()[0].lower()}"
        # The time without what a filter takes before its first sample
        seconds = [number * seconds_a_sample(table) for number in table["Samples"]]
        line = [root_law(table) / math.sqrt(number) for number in table["Samples"]]
        series += [(f"{label}: standard error", seconds, table["StandardError"], colour, 0, 1, 4),
                   (f"{label}: true error", seconds, table["TrueError"], colour, 0, 1, 1),
                   (f"{label}: slope -1/2", seconds, line, colour, 1, 2, 0)]
        all_seconds, all_errors = all_seconds + seconds, all_errors + table["StandardError"] + table["TrueError"] + line
    view = charts.chart("seconds of sampling, one core", "error of S_rs(r), summed over all pairs r s", powers(all_seconds),
                        powers(all_errors), logarithmic=True)
    charts.plot(view, series)
    charts.save(view, "convergence_samples.png")
    steps = [args.maximum_lag / number for number in lags["Lags"]]
    view = charts.chart("number of lags K up to 200 µm".replace("200", f"{args.maximum_lag:g}"), "error", [10.0, 100.0, 1000.0],
                        powers(lags["InterpolationError"] + lags["SurfaceError"]), logarithmic=True)
    second = [lags["InterpolationError"][-1] * (step / steps[-1])**2 for step in steps]
    first = [lags["SurfaceError"][-1] * step / steps[-1] for step in steps]
    view.BottomAxisRangeMaximum = 1200.0  # room for the last label
    charts.plot(view, [("largest error of S_rs interpolated", lags["Lags"], lags["InterpolationError"], "#0077bb", 0, 2, 4),
                       ("relative error of the specific surface", lags["Lags"], lags["SurfaceError"], "#bb3344", 0, 2, 4),
                       ("slope -1", lags["Lags"], first, "#777777", 3, 2, 0),
                       ("slope -2", lags["Lags"], second, "#777777", 2, 2, 0)])
    charts.save(view, "convergence_lags.png")


def main():
    args = parse_arguments()
    args.output = os.path.abspath(args.output)
    cell = periodic_pack(args)
    samples, lags = study_samples(args, cell), study_lags(args, cell)
    target = study_target(args, cell, samples)
    print_tables(args, samples, target, lags)
    write_tables(args, samples, lags)
    print(f"\nfiles    {args.output}")
    if args.pictures:
        draw(args, samples, lags)
    if args.check:
        check_all(samples, target, lags)
        print("check    passed")


if __name__ == "__main__":
    run(main)
