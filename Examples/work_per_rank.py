# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""How the searches for a unit cell share their work out over 1 to 2048 ranks: counted by the program's rules, not timed.

    python3 work_per_rank.py --output work_per_rank
    xvfb-run -a -s "-screen 0 1400x1000x24 -noreset" pvbatch work_per_rank.py --output work_per_rank --pictures

The paper ran on 2048 processors. Efficiency is the whole work over the number of ranks times the largest share of a rank, all units of a
kind taken as equal. Not counted is what every rank does for itself (sorting the spheres, L-BFGS, choosing by rank) and the sums over all
ranks, of which Gradient takes two and two shares in each evaluation and Annealed Population one share in each generation.
"""
import argparse
import csv
import os
import sys
import traceback

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)

CHUNK = 8  # the number of centres, ChunkOfCentres in CellObjective.cxx
# What is counted, as columns of the table
ONE_CELL, CLASSES, CELLS, FIRST, CHILDREN = "GradientOneCell", "GradientPairClasses", "GradientCells", "PopulationFirst", "PopulationGeneration"


def parse_arguments():
    parser = argparse.ArgumentParser(prog="work_per_rank.py", description=__doc__.split("\n")[0],
                                     formatter_class=argparse.ArgumentDefaultsHelpFormatter)
    parser.add_argument("--particles", type=int, default=1082, help="spheres in the cell")
    parser.add_argument("--modes", type=int, default=9, help="number of modes")
    parser.add_argument("--cells", type=int, default=5, help="cells at a time")
    parser.add_argument("--population", type=int, default=512, help="individuals of Annealed Population")
    parser.add_argument("--mating-pool", type=int, default=16, help="children of a generation")
    parser.add_argument("--ranks", type=int, default=2048, help="most ranks")
    parser.add_argument("--output", default="work_per_rank_results", help="folder for the files")
    parser.add_argument("--pictures", action="store_true", help="draw them too, in pvbatch")
    parser.add_argument("--check", action="store_true", help="test the results")
    return parser.parse_args()


def deal(units, ranks):
    """Units of work dealt out one after another, as `for (n = rank; n < number; n += ranks)` takes them: the sums of all ranks."""
    shares = [0] * ranks
    for n, work in enumerate(units):
        shares[n % ranks] += work
    return shares


def chunks_of(spheres):
    """Centres in each chunk, of an evaluation of F2 and its gradient (CellObjective::Evaluate)."""
    return [min(CHUNK, spheres - first) for first in range(0, spheres, CHUNK)]


def share_cells(chunks, cells, ranks):
    """Cells in rounds (CellSearch.cxx): one on each rank as long as there are as many left as ranks, the rest in as many groups of ranks. All
    cells take as many evaluations, and ranks wait for each other at the end of a round."""
    result, left = [cells // ranks * sum(chunks)] * ranks, cells % ranks
    if left:
        members = [len(range(group, ranks, left)) for group in range(left)]
        shares = [share for number in members for share in deal(chunks, number)]
        result = [whole + share for whole, share in zip(result, shares)]
    return result


def efficiency(shares):
    return sum(shares) / (len(shares) * max(shares))


def study(args):
    """{column: list of numbers}, with a row for each number of ranks."""
    chunks, classes = chunks_of(args.particles), args.modes * (args.modes + 1) // 2
    shares = {ONE_CELL: lambda ranks: deal(chunks, ranks), CLASSES: lambda ranks: deal([1] * classes, ranks),
              CELLS: lambda ranks: share_cells(chunks, args.cells, ranks), FIRST: lambda ranks: deal([1] * args.population, ranks),
              CHILDREN: lambda ranks: deal([1] * args.mating_pool, ranks)}
    # Powers of two, and between them as many as there are cells times those
    powers = [2**i for i in range(24)]
    every = sorted({ranks for ranks in (*powers, *(args.cells * power for power in powers), args.ranks) if ranks <= args.ranks})
    table = {"Ranks": [float(ranks) for ranks in every]}
    for name, share in shares.items():
        table[name] = [efficiency(share(ranks)) for ranks in every]
        table[name + "LargestShare"] = [float(max(share(ranks))) for ranks in every]
    return table


def print_table(args, table):
    print(f"{'':>6}{'efficiency, and units of the largest share':>60}\n{'ranks':>6}{'one cell':>16}{'pair classes':>16}"
          f"{f'{args.cells} cells':>16}{f'first {args.population}':>16}{f'{args.mating_pool} children':>16}")
    shown = {2.0**i for i in range(24)} | {float(args.cells), float(args.ranks)}
    for i, ranks in enumerate(table["Ranks"]):
        if ranks in shown:
            print(f"{ranks:6.0f}" + "".join(f"{table[name][i]:9.3f}{table[name + 'LargestShare'][i]:7.0f}"
                                            for name in (ONE_CELL, CLASSES, CELLS, FIRST, CHILDREN)))
    print("units: centres, classes of pairs of modes, centres, individuals, children")


def check_all(args, table):
    """Compares with what is found by hand: where units are divided without rest the efficiency is 1, and beyond their number it is number / ranks."""
    at = {ranks: {name: values[i] for name, values in table.items()} for i, ranks in enumerate(table["Ranks"])}
    def require(condition, reason):
        if not condition:
            raise AssertionError(reason)
    last = at[float(args.ranks)]
    for name, units in ((FIRST, args.population), (CHILDREN, args.mating_pool), (CLASSES, args.modes * (args.modes + 1) // 2)):
        require(at[1.0][name] == 1.0 == at[float(args.cells)][CELLS] if name == FIRST else at[1.0][name] == 1.0, f"{name} on one rank")
        require(units > args.ranks or abs(last[name] - units / args.ranks) < 1e-12, f"{name} on {args.ranks} ranks: {last[name]}")
    require(abs(last[ONE_CELL] - args.particles / (CHUNK * args.ranks)) < 1e-12, f"one cell on {args.ranks} ranks: {last[ONE_CELL]}")
    require(all(0.0 < value <= 1.0 for name, values in table.items() if name != "Ranks" and not name.endswith("Share") for value in values),
            "an efficiency above 1")
    # 2 ranks: 68 of 136 chunks whose last has 2 centres; of 5 cells two each, and the last by both
    if (args.cells, args.particles) == (5, 1082):
        require(at[2.0][CELLS] == 5 * 1082 / (2 * (2 * 1082 + 544)) and at[2.0][ONE_CELL + "LargestShare"] == 544.0, f"two ranks: {at[2.0]}")


def write_table(args, table):
    os.makedirs(args.output, exist_ok=True)
    with open(os.path.join(args.output, "work_per_rank.csv"), "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(table)
        writer.writerows([f"{value:.9g}" for value in row] for row in zip(*table.values()))


def draw(args, table):
    from common import stop_on_error  # imported only here, as nothing else needs ParaView
    from statistics_pictures import Charts

    stop_on_error()
    charts, ranks = Charts(args.output), table["Ranks"]
    labels = [2.0**i for i in range(24) if 2.0**i <= args.ranks]
    view = charts.chart("ranks", "efficiency of shared work, counted", labels, [0.2 * i for i in range(6)])
    view.BottomAxisLogScale = 1
    view.LeftAxisRangeMaximum, view.BottomAxisRangeMaximum = 1.38, 1.2 * labels[-1]  # room for the legend and the last label
    chunks = len(chunks_of(args.particles))
    charts.plot(view, [(f"Gradient, {args.cells} cells in rounds", ranks, table[CELLS], "#0077bb", 1, 2, 4),
                       (f"Annealed Population, first {args.population}", ranks, table[FIRST], "#117733", 1, 2, 4),
                       (f"Gradient, one cell: {chunks} chunks of {CHUNK} centres", ranks, table[ONE_CELL], "#222222", 1, 2, 4),
                       (f"    its {args.modes * (args.modes + 1) // 2} classes of pairs of modes", ranks, table[CLASSES], "#777777", 2, 2, 4),
                       (f"Annealed Population, a generation of {args.mating_pool} children", ranks, table[CHILDREN], "#bb3344", 1, 2, 4)])
    charts.save(view, "work_per_rank.png")


def main():
    args = parse_arguments()
    table = study(args)
    print_table(args, table)
    write_table(args, table)
    print(f"\nfiles    {os.path.abspath(args.output)}")
    if args.pictures:
        draw(args, table)
    if args.check:
        check_all(args, table)
        print("check    passed")


if __name__ == "__main__":
    try:
        main()
    except Exception:
        sys.exit(traceback.format_exc())
