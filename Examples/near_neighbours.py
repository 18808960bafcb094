# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""What cells keep of the pack besides S_rs: cells by F2 alone, with near neighbours and pores, and with the spectrum of zeta too.

    pvbatch near_neighbours.py --output near
    xvfb-run -a -s "-screen 0 1400x1000x24 -noreset" pvbatch near_neighbours.py --output near --pictures

Every descriptor of the pack has its standard error; a cell's difference is told in that unit, so that 1 is as near as another pack of the same
process would be. --check ends with an error unless near neighbours come nearer where they are fitted. Pictures are drawn on one rank, and
need a display.
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from paraview.simple import *

from common import add_output, fetch, field, make_parser, read_pack, require, run, sort_spheres, table_of, write_table

TABLE = "near_neighbours.csv"
GAPS = (0.005, 0.01, 0.02, 0.05, 0.1)
CELLS = {"F2": {"ContactWeight": 0, "PoreWeight": 0}, "Neighbours": {}, "Spectrum": {"SpectrumWeight": 1}}


def parse_arguments():
    parser = make_parser("near_neighbours.py", __doc__)
    cell = parser.add_argument_group("cells")
    cell.add_argument("--particles", type=int, default=1082, help="spheres in each cell")
    cell.add_argument("--iterations", type=int, default=1000, help="of F2; further terms take half as many more")
    cell.add_argument("--maximum-lag", type=float, default=200.0, help="last lag r of S_rs(r)")
    cell.add_argument("--lags", type=int, default=277, help="number K of lags after 0")
    cell.add_argument("--seed", type=int, default=1, help="seed of the cells")
    cell.add_argument("--cut-off", type=float, default=0.0, help="of zeta and eta; 0: four mean diameters")
    add_output(parser, "near_neighbours_results")
    parser.add_argument("--pictures", action="store_true", help="draw them too")
    return parser.parse_args()


def describe(pack, args):
    """{descriptor: (value, standard error)} of a pack or a cell."""
    neighbours = NeighbourStatistics(Input=pack, MaximumGap=0.1, NumberOfGaps=20)
    gaps, means = table_of(neighbours, 2), table_of(neighbours, 3)
    rows = [min(range(len(gaps["x"])), key=lambda k: abs(gaps["x"][k] - gap)) for gap in GAPS]
    found = {f"neighbours, gap < {100 * gap:g} %": (gaps["N"][k], gaps["N_error"][k]) for gap, k in zip(GAPS, rows)}
    for name, text in (("NearestGap", f"nearest gap ({args.unit})"), ("LocalFraction", "local fraction"), ("Q6", "Q6")):
        found[text] = (means[name][-1], means[name + "_error"][-1])
    voids = VoidDistances(Input=pack)
    pores = table_of(voids, 1)
    for name in ("mean distance", "critical radius x"):
        n = pores["Quantity"].index(name)
        found[f"pores, {name} ({args.unit})"] = (pores["Value"][n], pores["Error"][n])
    third = table_of(ThirdOrderParameters(Input=pack, CutOff=args.cut_off, Phases="Spheres"))
    for name in ("zeta", "eta"):
        found[name] = (third[name][0], third[name + "_error"][0])
    return found


def study(args):
    """{column: list}, with a row for each descriptor."""
    modes = sort_spheres(read_pack(args), args)
    described = {"Pack": describe(modes, args)}
    for name, weights in CELLS.items():
        cell = UnitCellReconstruction(Input=modes, NumberOfParticles=args.particles, MaximumLag=args.maximum_lag, NumberOfLags=args.lags,
                                      MaximumIterations=args.iterations, Seed=args.seed, **weights)
        described[name] = describe(cell, args)
        described[name]["F2"] = (field(fetch(cell), "Objective"), 0.0)
    described["Pack"] = {"F2": (0.0, 0.0), **described["Pack"]}
    table = {"Descriptor": list(described["Pack"])}
    for name, values in described.items():
        table[name] = [values[row][0] for row in table["Descriptor"]]
        if name == "Pack":
            table["Pack_error"] = [values[row][1] for row in table["Descriptor"]]
        else:
            table[name + "_Z"] = [(values[row][0] - pack) / error if error > 0.0 else 0.0 for row, pack, error in
                                  zip(table["Descriptor"], table["Pack"], table["Pack_error"])]
    return table


def print_table(table):
    print(f"{'':38s} {'pack':>9s} {'error':>8s}" + "".join(f" {name:>10s} {'Z':>7s}" for name in CELLS))
    for n, descriptor in enumerate(table["Descriptor"]):
        cells = "".join(f" {table[name][n]:10.4f} {table[name + '_Z'][n]:7.1f}" for name in CELLS)
        print(f"{descriptor:38s} {table['Pack'][n]:9.4f} {table['Pack_error'][n]:8.4f}{cells}")


def check_all(table):
    rows = {descriptor: n for n, descriptor in enumerate(table["Descriptor"])}
    require(all(0.0 < table[name][rows["F2"]] for name in CELLS), "a cell is its pack")
    for gap in GAPS[:3]:
        n = rows[f"neighbours, gap < {100 * gap:g} %"]
        require(abs(table["Neighbours_Z"][n]) < 0.5 * abs(table["F2_Z"][n]), f"gaps below {gap} are no nearer: {table['Neighbours_Z'][n]}")
    zeta = rows["zeta"]
    require(abs(table["Spectrum_Z"][zeta]) < max(3.0, abs(table["F2_Z"][zeta])), f"zeta is no nearer: {table['Spectrum_Z'][zeta]}")


def draw(args, table):
    from statistics_pictures import Charts  # imported only here, as nothing else draws

    charts = Charts(args.output)
    descriptors = table["Descriptor"][1:]
    places = list(range(len(descriptors), 0, -1))  # from above
    view = charts.chart("difference from the pack, in its standard errors", "", [0.01, 0.1, 1.0, 10.0, 100.0, 1000.0, 10000.0],
                        [0, *places[::-1], len(places) + 1])
    view.BottomAxisLogScale = 1
    view.LeftAxisLabels = [text for place, descriptor in zip(places, descriptors) for text in (repr(place), descriptor)]
    labels = {"F2": "F2 alone", "Neighbours": "and near neighbours, pores", "Spectrum": "and the spectrum of zeta"}
    styles = {"F2": ("#bb3344", 0, 1, 4), "Neighbours": ("#0077bb", 0, 1, 5), "Spectrum": ("#117733", 0, 1, 3)}
    charts.plot(view, [("2 standard errors", [2.0, 2.0], [0, len(places) + 1], "#777777", 2, 1, 0)] +
                [(labels[name], [max(abs(z), 0.011) for z in table[name + "_Z"][1:]], places, *styles[name]) for name in CELLS])
    charts.save(view, "near_neighbours.png")


def main():
    args = parse_arguments()
    args.output = os.path.abspath(args.output)
    table = study(args)
    print_table(table)
    write_table(args.output, TABLE, table)
    print(f"\nfiles    {args.output}")
    if args.pictures:
        draw(args, table)
    if args.check:
        check_all(table)
        print("check    passed")


if __name__ == "__main__":
    run(main)
