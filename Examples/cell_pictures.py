# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures of several cells from the files that cells.py has left.

    xvfb-run -a -s "-screen 0 1400x1000x24 -noreset" pvbatch cell_pictures.py --input cells --output Pictures

It runs on one rank. The figures of the paper that they correspond to are 12(a), 12(b) and 13.
"""
import argparse
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)

from paraview.simple import *

from common import run
from pictures import SIZE, rgb, ticks
from statistics_pictures import COLOURS, Charts
from cells import read_table

BARS, DOTS = 14, 46  # along a curve


class CellPictures(Charts):
    def __init__(self, args):
        super().__init__(args.output)
        self.input = os.path.abspath(args.input)
        self.two = read_table(self.file("two_point.csv"))
        if "S_m_m_mean" not in self.two:
            raise RuntimeError("Pictures of several cells want two or more: --cells 2 of cells.py, or more.")
        rows = read_table(self.file("comparison.csv"))
        self.fractions = {name[2:]: values for name, *values in zip(rows["Quantity"], rows["Pack"], rows["Cell"], rows["StandardDeviation"],
                                                                    rows["Percent"]) if name.startswith("c_")}
        self.cells = len(read_table(self.file("table_of_cells.csv"))["Cell"])
        self.unit = self.field("cell_1.vtp", "LengthUnit")
        # The modes of largest volume, by number
        modes = sorted((phase for phase in self.fractions if phase != "m"), key=lambda phase: self.fractions[phase][0])[-2:]
        a, b = (sorted(modes, key=int) * 2)[-2:]
        pairs = ["m_m", f"{b}_m", f"{b}_{b}", f"{a}_{b}"]
        self.pairs = [pair for pair in dict.fromkeys(pairs) if f"S_{pair}_pack" in self.two]

    # ---- volume fractions, Fig. 12 ----

    def bars(self, name, y_title, y_labels, series):
        """A group of bars for each mode. series: {label: (values, colour)}"""
        modes = [phase for phase in self.fractions if phase != "m"]
        view = CreateView("XYBarChartView", ViewSize=SIZE)
        view.BottomAxisTitle, view.LeftAxisTitle, view.LegendFontSize = "mode", y_title, 20
        view.ShowLegend = int(len(series) > 1)
        for axis in ("Bottom", "Left"):
            setattr(view, axis + "AxisTitleFontSize", 24)
            setattr(view, axis + "AxisLabelFontSize", 20)
            setattr(view, axis + "AxisTitleBold", 0)
            setattr(view, axis + "AxisLabelFontFamily", "Times")  # Arial numbers are drawn with stray dashes by Mesa's llvmpipe
            setattr(view, axis + "AxisUseCustomLabels", 1)
            setattr(view, axis + "AxisUseCustomRange", 1)
        view.BottomAxisLabels = [text for i, mode in enumerate(modes) for text in (repr(i + 1.0), mode)]
        view.LeftAxisLabels = [text for y in y_labels for text in (repr(y), f"{y:g}")]
        view.BottomAxisRangeMinimum, view.BottomAxisRangeMaximum = 0.4, len(modes) + 0.6
        view.LeftAxisRangeMinimum, view.LeftAxisRangeMaximum = y_labels[0], y_labels[-1]
        source = self.table({"mode": [i + 1.0 for i in range(len(modes))], **{label: values for label, (values, _) in series.items()}})
        display = Show(source, view, "XYBarChartRepresentation")
        display.UseIndexForXAxis, display.XArrayName = 0, "mode"
        display.SeriesVisibility = list(series)
        display.SeriesLabel = [item for label in series for item in (label, label)]
        display.SeriesColor = [item for label, (_, colour) in series.items() for item in (label, *map(str, rgb(colour)))]
        self.save(view, name)

    def draw_fractions(self):
        values = [values for phase, values in self.fractions.items() if phase != "m"]
        pack, cell, _, percent = zip(*values)
        self.bars("cell_fractions.png", "volume fraction", ticks(max(pack + cell)),
                  {"pack": (pack, "#bb3344"), f"cells (all {self.cells} alike)": (cell, "#0077bb")})
        self.bars("cell_fraction_errors.png", "error of the volume fraction, equation 16 (%)", ticks(max(percent)),
                  {"(16)": (percent, "#0077bb")})

    # ---- S_rs, Fig. 13 ----

    def error_bars(self, centres, deviations, place):
        """Vertical lines with crossbars as one curve with gaps: x and y. `place` from 0 to 1 keeps those of several curves apart."""
        x, y, lags = [], [], len(centres) - 1
        half = 0.006 * self.two["r"][-1]
        for k in (round((n + place) * lags / BARS) for n in range(BARS)):
            r, low, high = self.two["r"][k], centres[k] - deviations[k], centres[k] + deviations[k]
            x += [r - half, r + half, math.nan, r, r, math.nan, r - half, r + half, math.nan]
            y += [low, low, math.nan, low, high, math.nan, high, high, math.nan]
        return x, y

    def draw_two_point(self):
        columns = [self.two[f"S_{pair}_{end}"] for pair in self.pairs for end in ("pack", "mean")]
        view = self.chart(f"r ({self.unit})", "S_rs(r)", ticks(self.two["r"][-1]), ticks(max(map(max, columns))))
        step, x, y = max(1, len(self.two["r"]) // DOTS), [], []
        for n, (pair, colour) in enumerate(zip(self.pairs, COLOURS)):
            mean = self.two[f"S_{pair}_mean"]
            self.plot(view, [(f"S_{pair} pack", self.two["r"][::step], self.two[f"S_{pair}_pack"][::step], colour, 0, 1, 4),
                             (f"S_{pair} mean of {self.cells} cells", self.two["r"], mean, colour, 1, 2, 0)])
            bars = self.error_bars(mean, self.two[f"S_{pair}_deviation"], (n + 0.5) / len(self.pairs))
            x, y = x + bars[0], y + bars[1]
        self.plot(view, [("± standard deviation of the cells", x, y, "#777777", 1, 1, 0)])
        self.save(view, "cell_two_point.png")

    def draw_differences(self):
        """The mean minus the pack, where the standard deviation shows."""
        scale, series, values, pairs = 1e4, [], [0.0], [self.pairs[0], self.pairs[min(2, len(self.pairs) - 1)]]
        for n, (pair, colour) in enumerate(zip(dict.fromkeys(pairs), COLOURS)):
            difference = [scale * (a - b) for a, b in zip(self.two[f"S_{pair}_mean"], self.two[f"S_{pair}_pack"])]
            x, y = self.error_bars(difference, [scale * value for value in self.two[f"S_{pair}_deviation"]], 0.5 * n + 0.25)
            series += [(f"S_{pair}", self.two["r"], difference, colour, 1, 2, 0),
                       (f"S_{pair} ± standard deviation of the cells", x, y, colour, 1, 1, 0)]
            values += difference + [value for value in y if not math.isnan(value)]
        step = ticks(max(values) - min(values))[1]
        labels = [round(step * k, 9) for k in range(math.floor(min(values) / step), math.ceil(max(values) / step) + 1)]
        view = self.chart(f"r ({self.unit})", f"{scale:g} (mean of {self.cells} cells - pack)", ticks(self.two["r"][-1]), labels)
        view.LeftAxisRangeMaximum = labels[-1] + 0.25 * (labels[-1] - labels[0])  # room for the legend
        self.plot(view, series)
        self.save(view, "cell_two_point_difference.png")


def main():
    parser = argparse.ArgumentParser(prog="pvbatch cell_pictures.py", description=__doc__.split("\n")[0],
                                     formatter_class=argparse.ArgumentDefaultsHelpFormatter)
    parser.add_argument("--input", default="cells_results", help="folder of the files")
    parser.add_argument("--output", default="Pictures", help="folder for the pictures")
    pictures = CellPictures(parser.parse_args())
    pictures.draw_fractions()
    pictures.draw_two_point()
    pictures.draw_differences()


if __name__ == "__main__":
    run(main)
