# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures of the three-point probabilities of pack and cell from the files that three_point.py has left.

    xvfb-run -a -s "-screen 0 1400x1000x24 -noreset" pvbatch three_point_pictures.py --input results --output Pictures

It runs on one rank. The figures of the paper that they correspond to are 9, 10 and 14 to 17.
"""
import argparse
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)

from paraview.servermanager import Fetch
from paraview.simple import *

from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from common import run
from pictures import BLACK, SIZE, read_table, ticks, to_palette
from statistics_pictures import COLOURS, Charts

SIZE[:] = [1400, 560]
ANGLES = [0.0, 72.0, 180.0]  # the angles theta of the maps, in degrees
LEFT, BOTTOM, EDGE, PITCH = 80, 85, 345, 1.215  # the maps' place and edge in pixels, and the way from one to the next in edges
PALE = "#e6b3ba"


def numbers(path):
    """{column: list of numbers}"""
    return {column: [float(value) for value in values] for column, values in read_table(path).items()}


class ThreePointPictures(Charts):
    def __init__(self, args):
        super().__init__(args.output)
        self.input = os.path.abspath(args.input)
        self.images = {name: XMLImageDataReader(FileName=[self.file(f"three_point_{name}.vti")]) for name in ("pack", "cell", "difference")}
        pack = Fetch(self.images["pack"])
        self.unit = pack.GetFieldData().GetAbstractArray("LengthUnit").GetValue(0)
        self.extent, self.spacing = pack.GetExtent(), pack.GetSpacing()
        self.limits = {name: numbers(self.file(f"limits_{name}.csv")) for name in ("pack", "cell")}
        names = (pack.GetPointData().GetArrayName(i) for i in range(pack.GetPointData().GetNumberOfArrays()))
        self.triples = [name for name in names if not name.endswith("_error")]

    # ---- maps, Figs. 9, 10, 14, 15 ----

    def draw_maps(self, medium, triple, title, file, preset, logarithmic):
        """S_rsq over r1 and r2 at three angles side by side, on one scale."""
        view, reach = self.scene(), self.extent[1] * self.spacing[0]
        colours = GetColorTransferFunction(triple)
        colours.UseLogScale = 0
        slices = sorted({min(round(angle / self.spacing[2]), self.extent[5]) for angle in ANGLES})
        flats = [ExtractSubset(Input=self.images[medium], VOI=[*self.extent[:4], t, t]) for t in slices]
        displays = []
        for n, (flat, t) in enumerate(zip(flats, slices)):
            displays.append(Show(flat, view, "UniformGridRepresentation"))
            displays[-1].Representation = "Slice"
            place = "Translation" if "Translation" in displays[-1].ListProperties() else "Position"  # its name before ParaView 5.13
            displays[-1].GetProperty(place).SetData([n * PITCH * reach, 0.0, -t * self.spacing[2]])
            ColorBy(displays[-1], ("POINTS", triple))
        ranges = [flat.PointData[triple].GetRange() for flat in flats]
        low, high = min(r[0] for r in ranges), max(r[1] for r in ranges)
        low = max(low, high / 100.0) if logarithmic else 0.0
        colours.ApplyPreset(preset, True)
        colours.RescaleTransferFunction(low, high)
        if logarithmic:
            colours.MapControlPointsToLogSpace()
            colours.UseLogScale = 1
        colours.NumberOfTableValues = 128 if logarithmic else 32
        displays[0].SetScalarBarVisibility(view, True)
        self.bar(GetScalarBar(colours, view), low, high, logarithmic)
        self.look_down(view, reach)
        self.axes(view, reach, [t * self.spacing[2] for t in slices])
        self.text(view, title, LEFT - 60, SIZE[1] - 48, 24)
        self.save(view, file)

    def typical_error(self, medium, triple):
        """The root mean square over r1, r2 and theta."""
        image = Fetch(self.images[medium])
        errors = memoryview(image.GetPointData().GetArray(triple + "_error"))
        return math.sqrt(sum(error * error for error in errors) / len(errors))

    def look_down(self, view, reach):
        """Places the camera so that the first map has its corner at the pixels (LEFT, BOTTOM)."""
        pixel = reach / EDGE
        focus = [(0.5 * SIZE[0] - LEFT) * pixel, (0.5 * SIZE[1] - BOTTOM) * pixel, 0.0]
        view.CameraParallelProjection, view.CameraParallelScale = 1, 0.5 * SIZE[1] * pixel
        view.CameraViewUp, view.CameraFocalPoint, view.CameraPosition = [0, 1, 0], focus, [*focus[:2], 10.0 * reach]

    def axes(self, view, reach, angles):
        """Draws frames with ticks, numbers and titles."""
        labels = ticks(reach)
        labels = [label for label in (labels[::2] if len(labels) > 6 else labels) if label <= reach * (1.0 + 1e-9)]
        points, lines = vtkPoints(), vtkCellArray()

        def line(*ends):
            lines.InsertNextCell(len(ends))
            for x, y in ends:
                lines.InsertCellPoint(points.InsertNextPoint(x, y, 0.01 * reach))

        for n, angle in enumerate(angles):
            x0, left, tick = n * PITCH * reach, LEFT + n * PITCH * EDGE, 0.02 * reach
            line((x0, 0.0), (x0 + reach, 0.0), (x0 + reach, reach), (x0, reach), (x0, 0.0))
            for label in labels:
                line((x0 + label, 0.0), (x0 + label, -tick))
                line((x0, label), (x0 - tick, label))
                at, text = label / reach * EDGE, f"{label:g}"
                self.text(view, text, left + at - 0.5 * width(text, 20), BOTTOM - 30, 20)
                self.text(view, text, left - 12 - width(text, 20), BOTTOM + at - 11, 20)
            for text, x, y in ((f"r1 ({self.unit})", 0.5 * EDGE, -62), (f"theta = {angle:g}°", 0.5 * EDGE, EDGE + 16)):
                self.text(view, text, left + x - 0.5 * width(text, 22), BOTTOM + y, 22)
            self.text(view, f"r2 ({self.unit})", left - 60, BOTTOM + EDGE + 16, 22)
        frame, source = vtkPolyData(), TrivialProducer()
        frame.SetPoints(points)
        frame.SetLines(lines)
        source.GetClientSideObject().SetOutput(frame)
        display = Show(source, view, "GeometryRepresentation")
        display.ColorArrayName, display.LineWidth = ["POINTS", ""], 2.0
        display.AmbientColor = display.DiffuseColor = BLACK
        display.Ambient, display.Diffuse = 1.0, 0.0

    def text(self, view, text, x, y, size):
        """Places a text with its lower left corner at a pixel."""
        display = Show(Text(Text=text), view, "TextSourceRepresentation")
        display.Color, display.FontSize, display.WindowLocation = BLACK, size, "Any Location"
        display.Position = [x / SIZE[0], y / SIZE[1]]

    def bar(self, bar, low, high, logarithmic):
        bar.Title = bar.ComponentTitle = ""
        bar.WindowLocation, bar.Position, bar.ScalarBarLength = "Any Location", [1275 / SIZE[0], BOTTOM / SIZE[1]], EDGE / SIZE[1]
        bar.TitleColor = bar.LabelColor = BLACK
        bar.LabelFontSize, bar.ScalarBarThickness, bar.DrawTickMarks, bar.AddRangeLabels = 20, 26, 1, 0
        bar.UseCustomLabels = 1
        if logarithmic:
            steps = (1, 2, 5) if high > 20.0 * low else (1, 1.5, 2, 3, 4, 6)
            labels = [m * 10.0**e for e in range(-9, 1) for m in steps if low <= m * 10.0**e <= high]
            bar.AutomaticLabelFormat, bar.LabelFormat = 0, "%.2g"
        else:
            step = ticks(high)[1] * (2 if high / ticks(high)[1] > 6 else 1)
            labels = [step * k for k in range(math.floor(high / step) + 1)]
            bar.AutomaticLabelFormat, bar.LabelFormat = 0, f"%.{max(0, -math.floor(math.log10(step) + 1e-9))}f"
        bar.CustomLabels = labels

    # ---- limits, Figs. 16, 17 ----

    def draw_limit(self, triple, file):
        """Where S_rsq becomes S_rs, against the exact one; pack and cell side by side."""
        _, r, s, q = triple.split("_")
        if s == q:
            place, both, where = "diagonal", (r, s), "r1 = r2 = r, theta = 0"
        elif r == s:
            place, both, where = "r2_axis", (r, q), "r2 = r, r1 = 0"
        elif r == q:
            place, both, where = "r1_axis", (r, s), "r1 = r, r2 = 0"
        else:
            return  # 0 everywhere
        column = f"{triple}_{place}"
        curves = {name: [table[column + end] for end in ("", "_error", "_limit")] for name, table in self.limits.items()}
        x = self.limits["pack"]["r"]
        highest = max(max(map(sum, zip(values, errors))) for values, errors, _ in curves.values())
        layout = CreateLayout(triple)
        layout.SplitHorizontal(0, 0.5)
        views = []
        for n, (name, (values, errors, limit)) in enumerate(curves.items()):
            view = self.chart(f"r ({self.unit})", "probability", ticks(x[-1]), ticks(1.02 * highest))
            view.ChartTitle, view.ChartTitleFontSize = f"{name}: {where}", 22
            view.LegendLocation, view.LegendFontFamily = "BottomRight", "Times"  # in Arial with stray dashes, see chart
            edges = [a + b for a, b in zip(values, errors)] + [math.nan] + [a - b for a, b in zip(values, errors)]
            flat = "S_" + triple[2:].replace("_", "")
            self.plot(view, [(f"{flat} ± standard error", x + [math.nan] + x, edges, PALE, 1, 2, 0),
                             (f"S_{''.join(both)}, exact", x, limit, COLOURS[0], 1, 3, 0),
                             (flat, x, values, COLOURS[1], 2, 3, 0)])
            AssignViewToLayout(view, layout, n + 1)
            views.append(view)
        path = os.path.join(self.output, file)
        layout.SetSize(*SIZE)
        SaveScreenshot(path, layout, SaveAllViews=1, ImageResolution=SIZE, FontScaling="Do not scale fonts")
        to_palette(path)
        print(f"picture  {path}", flush=True)
        for view in views:
            Delete(view)


def width(text, size):
    """About the width of a text in pixels."""
    return 0.52 * size * len(text)


def main():
    parser = argparse.ArgumentParser(prog="pvbatch three_point_pictures.py", description=__doc__.split("\n")[0],
                                     formatter_class=argparse.ArgumentDefaultsHelpFormatter)
    parser.add_argument("--input", default="three_point_results", help="folder of the files")
    parser.add_argument("--output", default="Pictures", help="folder for the pictures")
    drawn = ThreePointPictures(parser.parse_args())
    for triple in drawn.triples:
        phases = triple[2:]
        name = f"S_{phases.replace('_', '')}"
        drawn.draw_maps("pack", triple, f"{name}(r1, r2, theta) of the pack; standard error about {drawn.typical_error('pack', triple):.1g}",
                        f"three_point_{phases}.png", "Cividis", True)
        drawn.draw_maps("difference", triple, f"Difference of {name} between pack and cell, its magnitude; standard error about "
                        f"{drawn.typical_error('difference', triple):.1g}", f"three_point_difference_{phases}.png", "Black-Body Radiation", False)
        drawn.draw_limit(triple, f"degenerate_{phases}.png")


if __name__ == "__main__":
    run(main)
