# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures of the statistics of a pack from the files that pack_statistics.py has left.

    xvfb-run -a -s "-screen 0 1400x1000x24 -noreset" pvbatch statistics_pictures.py --input results --output Pictures

It runs on one rank. The figures of the paper that they correspond to are 6(a), 6(b) and 7(b).
"""
import argparse
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)

from paraview.servermanager import Fetch
from paraview.simple import *

from common import run
from pictures import BLACK, Pictures, read_table, ticks

COLOURS = ["#222222", "#bb3344", "#0077bb", "#ee7733", "#117733", "#aa4499"]


class Charts(Pictures):
    """Line charts of any curves."""

    def __init__(self, output):
        self.output = os.path.abspath(output)
        os.makedirs(self.output, exist_ok=True)

    def chart(self, x_title, y_title, x_labels, y_labels, logarithmic=False):
        view = super().chart(x_title, y_title, x_labels, y_labels)
        view.BottomAxisLogScale = view.LeftAxisLogScale = int(logarithmic)
        return view

    def plot(self, view, series):
        """series: (label, x, y, colour, line style, thickness, marker), each with x of its own."""
        for label, x, y, *style in series:
            self.curves(view, x, {label: (y, *style)})

    def band(self, view, label, x, values, errors, colour, pale):
        """A line, and a standard error above and below it thin lines, which are one curve with a gap."""
        edges = [value + error for value, error in zip(values, errors)] + [math.nan] + [value - error for value, error in zip(values, errors)]
        self.plot(view, [(f"{label} ± standard error", x + [math.nan] + x, edges, pale, 1, 2, 0), (label, x, values, colour, 1, 2, 0)])


class StatisticsPictures(Charts):
    def __init__(self, args):
        super().__init__(args.output)
        self.input = os.path.abspath(args.input)
        self.map = XMLImageDataReader(FileName=[self.file("map.vti")])
        self.image = Fetch(self.map)
        self.unit = self.image.GetFieldData().GetAbstractArray("LengthUnit").GetValue(0)
        one = read_table(self.file("one_point.csv"))
        self.c = dict(zip(one["Phase"], map(float, one["SphereVolumes"])))
        # The modes of largest volume, by number
        modes = sorted((phase for phase in self.c if phase != "m"), key=self.c.get)[-2:]
        self.large = sorted(modes, key=int)

    def numbers(self, name):
        return {column: [float(value) for value in values] for column, values in read_table(self.file(name)).items()}

    def pairs(self):
        """The pairs of the matrix and of the modes of largest volume."""
        a, b = self.large[0], self.large[-1]
        return list(dict.fromkeys([("m", "m"), (b, "m"), (b, b), (a, b)]))

    # ---- S_rs(x), Fig. 6(a) ----

    def draw_map(self, name, file):
        """The core of S_rs(x): a ball of lag vectors x with an eighth cut out."""
        view = self.scene()
        _, r, s = name.split("_")
        reach = 0.5 * self.image.GetBounds()[1]
        # Finer than the lag vectors, which the surface would show as steps
        fine = ResampleToImage(Input=self.map, UseInputBounds=0, SamplingBounds=[-1.02 * reach, 1.02 * reach] * 3,
                               SamplingDimensions=[121] * 3)
        # The function is negative inside; the eighth towards the eye is open
        solid = Calculator(Input=fine, ResultArrayName="Solid",
                           Function=f"max(mag(coords) - {reach}, min(min(coordsX, -coordsY), coordsZ))")
        ball = Contour(Input=solid, ContourBy=["POINTS", "Solid"], Isosurfaces=[0.0], ComputeScalars=0, ComputeNormals=0)
        display = Show(ball, view, "GeometryRepresentation")
        display.Representation = "Surface"
        ColorBy(display, ("POINTS", name))
        low, high = self.image.GetPointData().GetArray(name).GetRange()
        limit = self.c[r] * self.c[s]
        top = min(high, limit + 2.0 * (limit - low))  # higher values are near the centre only
        table = GetColorTransferFunction(name)
        table.ApplyPreset("Cividis", True)
        table.RescaleTransferFunction(low, top)
        table.NumberOfTableValues = 128
        display.SetScalarBarVisibility(view, True)
        bar = GetScalarBar(table, view)
        bar.Title, bar.ComponentTitle = f"S_{r}{s}(x)", ""
        bar.WindowLocation, bar.Position, bar.ScalarBarLength = "Any Location", [0.84, 0.24], 0.5
        bar.TitleColor = bar.LabelColor = BLACK
        bar.TitleFontSize, bar.LabelFontSize = 24, 20
        bar.HorizontalTitle, bar.ScalarBarThickness, bar.DrawTickMarks, bar.AddRangeLabels = 1, 26, 1, 0
        step = ticks(top - low)[1]
        digits = max(0, -math.floor(math.log10(step) + 1e-9))
        bar.UseCustomLabels, bar.CustomLabels = 1, [step * k for k in range(math.ceil(low / step), math.floor(top / step) + 1)]
        bar.AutomaticLabelFormat, bar.LabelFormat = 0, f"%.{digits}f"
        display.Ambient, display.Diffuse, display.Specular = 0.8, 0.25, 0.0
        self.axes(display, reach)
        peak = f"; {high:.{digits + 1}f} at x = 0" if top < high else ""
        self.title(view, f"S_{r}{s}(x), core of the map; far away {limit:.{digits + 1}f}{peak}")
        view.CameraFocalPoint, view.CameraViewUp, view.CameraViewAngle = [0.14 * reach, 0.1 * reach, 0.04 * reach], [0, 0, 1], 20
        view.CameraPosition = [10.8 * reach * q for q in (0.5, -0.72, 0.48)]
        self.save(view, file)

    def axes(self, display, reach):
        grid = display.DataAxesGrid
        grid.GridAxesVisibility = 1
        for axis in "XYZ":
            setattr(grid, axis + "Title", f"{axis.lower()} ({self.unit})")
            for what, size in (("Title", 24), ("Label", 20)):
                setattr(grid, f"{axis}{what}Color", BLACK)
                setattr(grid, f"{axis}{what}FontSize", size)
            setattr(grid, axis + "AxisUseCustomLabels", 1)
            setattr(grid, axis + "AxisLabels", [-0.5 * reach, 0.0, 0.5 * reach])
        grid.GridColor = [0.4, 0.4, 0.4]

    # ---- curves ----

    def draw_isotropy(self):
        sigma, two = self.numbers("isotropy.csv"), self.numbers("two_point_exact.csv")
        series, largest = [], 0.0
        for (r, s), colour in zip(self.pairs(), COLOURS):
            limit = self.c[r] * self.c[s]
            name = f"S_{r}_{s}"
            percent = [100.0 * b / max(a, limit) for a, b in zip(two[name], sigma["sigma_" + name])]
            largest = max(largest, max(percent))
            series.append((f"S_{r}{s}", two["r"], percent, colour, 1, 2, 0))
        view = self.chart(f"r ({self.unit})", "sigma_S(r) in % of S_rs(r), or of its limit if larger", ticks(two["r"][-1]), ticks(largest))
        self.plot(view, series)
        self.save(view, "isotropy.png")

    def draw_gradients(self):
        table = self.numbers("gradients.csv")
        names = [f"S_{r}_{s}" for r, s in self.pairs()]
        scale = 1000.0
        low, high = (scale * choose(choose(table[name]) for name in names) for choose in (min, max))
        step = ticks(max(high - low, 1e-9))[1]
        labels = [step * k for k in range(math.floor(low / step), math.ceil(high / step) + 1)]
        view = self.chart(f"r ({self.unit})", f"1000 dS_rs/dr (1/{self.unit})", ticks(table["r"][-1]), labels)
        self.plot(view, [(f"S_{r}{s}", table["r"], [scale * value for value in table[name]], colour, 1, 2, 0)
                         for (r, s), name, colour in zip(self.pairs(), names, COLOURS)])
        self.save(view, "gradients.png")

    def draw_chords(self):
        table = self.numbers("chord_lengths.csv")
        phases = self.large + ["m"]
        labels = [10.0**e for e in range(-5, 1)]
        last = next((r for k, r in enumerate(table["r"]) if k and all(table["L_" + phase][k] <= 1e-5 for phase in phases)), table["r"][-1])
        view = self.chart(f"r ({self.unit})", "probability", ticks(last), labels)
        view.LeftAxisLogScale = 1
        two = self.numbers("two_point_chords.csv")
        series = []
        for phase, colour in zip(phases, COLOURS[1:]):
            path = [value if value > 1e-6 else math.nan for value in table["L_" + phase]]
            where = "the matrix m" if phase == "m" else f"mode {phase}"
            series += [(f"L_{phase}: all of a segment in {where}", table["r"], path, colour, 1, 3, 0),
                       (f"S_{phase}{phase}: both ends in {where}", two["r"], two[f"S_{phase}_{phase}"], colour, 2, 1, 0)]
        self.plot(view, series)
        self.save(view, "lineal_path.png")

    def draw_errors(self):
        """S_mm by all methods, near its limit, where errors show."""
        tables = {label: self.numbers(f"two_point_{label}.csv") for label in ("exact", "chords", "template")}
        x, name, limit = tables["exact"]["r"], "S_m_m", self.c["m"]**2
        low = 0.9 * min(tables["exact"][name])
        step = ticks(0.35 * limit)[1]
        labels = [step * k for k in range(math.floor(low / step), math.ceil(1.25 * limit / step) + 1)]
        view = self.chart(f"r ({self.unit})", "S_mm(r)", ticks(x[-1]), [round(label, 9) for label in labels])
        for label, colour, pale in (("template", COLOURS[1], "#e6b3ba"), ("chords", COLOURS[2], "#99d0f5")):
            self.band(view, label, x, tables[label][name], tables[label][name + "_error"], colour, pale)
        self.plot(view, [("exact, of the whole window", x, tables["exact"][name], COLOURS[0], 1, 2, 0)])
        self.save(view, "two_point_errors.png")


def main():
    parser = argparse.ArgumentParser(prog="pvbatch statistics_pictures.py", description=__doc__.split("\n")[0],
                                     formatter_class=argparse.ArgumentDefaultsHelpFormatter)
    parser.add_argument("--input", default="statistics_results", help="folder of the files")
    parser.add_argument("--output", default="Pictures", help="folder for the pictures")
    pictures = StatisticsPictures(parser.parse_args())
    for i in range(pictures.image.GetPointData().GetNumberOfArrays()):
        name = pictures.image.GetPointData().GetArrayName(i)
        pictures.draw_map(name, f"map_{name[2:]}.png")
    pictures.draw_isotropy()
    pictures.draw_gradients()
    pictures.draw_chords()
    pictures.draw_errors()


if __name__ == "__main__":
    run(main)
