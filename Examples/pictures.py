# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures of a unit cell from the files that unit_cell.py has left.

    xvfb-run -a -s "-screen 0 1400x1000x24 -noreset" pvbatch pictures.py --input results --output Pictures

It runs on one rank, as the charts are of tables that this process alone has.
"""
import argparse
import csv
import math
import os
import struct
import sys
import zlib

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from paraview.servermanager import Fetch
from paraview.simple import *
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkTable
from vtkmodules.vtkImagingColor import vtkImageQuantizeRGBToIndex
from vtkmodules.vtkIOImage import vtkPNGReader

from common import run

SIZE = [1200, 900]
BLACK, WHITE, GREY = [0.0, 0.0, 0.0], [1.0, 1.0, 1.0], [0.35, 0.35, 0.35]
# Colours of the modes from small to large, and of the curves; distinct for colour-blind readers too
MODE_COLOURS = ["#332288", "#0077bb", "#33bbee", "#44aa99", "#117733", "#999933", "#ddaa33", "#ee7733", "#bb3344"]
CURVE_COLOURS = ["#222222", "#bb3344", "#0077bb", "#ee7733"]
MARKER_STEP = 6


def rgb(colour):
    return [int(colour[i:i + 2], 16) / 255.0 for i in (1, 3, 5)]


def read_table(path):
    """{column: list of texts}"""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    return {name: [row[name] for row in rows] for name in rows[0]}


def ticks(last):
    """Round numbers from 0 to the last value or beyond, up to ten steps."""
    step = next(m * 10.0**e for e in range(-6, 9) for m in (1, 2, 5) if m * 10.0**e * 10 >= last)
    return [step * i for i in range(math.ceil(last / step - 1e-9) + 1)]


def to_palette(path):
    """Rewrites a PNG with at most 256 colours: a third of the size."""
    reader, quantize = vtkPNGReader(), vtkImageQuantizeRGBToIndex()
    reader.SetFileName(path)
    quantize.SetInputConnection(reader.GetOutputPort())
    quantize.SetNumberOfColors(256)
    quantize.Update()
    image, table = quantize.GetOutput(), quantize.GetLookupTable()
    width, height, _ = image.GetDimensions()
    index = image.GetPointData().GetScalars()
    pixels = bytes(int(index.GetValue(i)) for i in range(width * height))
    rows = b"".join(b"\0" + pixels[width * y:width * (y + 1)] for y in reversed(range(height)))
    palette = bytes(round(255.0 * table.GetTableValue(i)[q]) for i in range(table.GetNumberOfTableValues()) for q in range(3))
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n")
        for kind, data in ((b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 3, 0, 0, 0)), (b"PLTE", palette),
                           (b"IDAT", zlib.compress(rows, 9)), (b"IEND", b"")):
            file.write(struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data)))


class Pictures:
    def __init__(self, args):
        self.input, self.output = os.path.abspath(args.input), os.path.abspath(args.output)
        os.makedirs(self.output, exist_ok=True)
        self.modes = read_table(self.file("modes.csv"))
        self.unit = self.field("cell.vtp", "LengthUnit")

    def file(self, name):
        return os.path.join(self.input, name)

    def field(self, name, array):
        return Fetch(XMLPolyDataReader(FileName=[self.file(name)])).GetFieldData().GetAbstractArray(array).GetValue(0)

    def number_of_spheres(self, name):
        return Fetch(XMLPolyDataReader(FileName=[self.file(name)])).GetNumberOfPoints()

    def save(self, view, name):
        path = os.path.join(self.output, name)
        SaveScreenshot(path, view, ImageResolution=SIZE, FontScaling="Do not scale fonts")
        to_palette(path)
        print(f"picture  {path}", flush=True)
        Delete(view)

    # ---- spheres ----

    def scene(self):
        view = CreateView("RenderView", ViewSize=SIZE, UseColorPaletteForBackground=0, Background=WHITE, OrientationAxesVisibility=0)
        return view

    def colour_by_mode(self, display, view):
        """Shows each mode in its colour, with a legend of the diameters."""
        ColorBy(display, ("POINTS", "Mode"))
        table = GetColorTransferFunction("Mode")
        table.InterpretValuesAsCategories = 1
        table.AnnotationsInitialized = 1
        names, colours = [], []
        for i, mode in enumerate(self.modes["Mode"]):
            low, high = float(self.modes["MinimumDiameter"][i]), float(self.modes["MaximumDiameter"][i])
            size = f"{low:.1f}" if f"{low:.1f}" == f"{high:.1f}" else f"{low:.1f} – {high:.1f}"
            names += [mode, f"  mode {mode}: {size}"]
            colours += rgb(MODE_COLOURS[i % len(MODE_COLOURS)])
        table.Annotations, table.IndexedColors = names, colours
        table.IndexedOpacities = [1.0] * len(self.modes["Mode"])
        display.SetScalarBarVisibility(view, True)
        bar = GetScalarBar(table, view)
        bar.Title, bar.ComponentTitle = f"Diameter ({self.unit})", ""
        bar.WindowLocation, bar.Position, bar.ScalarBarLength = "Any Location", [0.79, 0.24], 0.52
        bar.TitleColor = bar.LabelColor = BLACK
        bar.TitleFontSize, bar.LabelFontSize = 20, 19
        bar.HorizontalTitle, bar.TitleJustification = 1, "Left"
        bar.TextPosition = "Ticks left/bottom, annotations right/top"
        bar.ScalarBarThickness, bar.DrawTickMarks, bar.DrawTickLabels = 26, 0, 0

    def look(self, view, data):
        """Places the camera so that it sees the whole data from above a corner, left of the legend."""
        x0, x1, y0, y1, z0, z1 = data.GetDataInformation().GetBounds()
        radius = math.dist((x0, y0, z0), (x1, y1, z1)) / 2
        focus = [(x0 + x1) / 2 + 0.20 * radius, (y0 + y1) / 2 - 0.11 * radius, (z0 + z1) / 2 - 0.02 * radius]
        view.CameraFocalPoint, view.CameraViewUp, view.CameraViewAngle = focus, [0, 0, 1], 20
        view.CameraPosition = [focus[q] + 5.9 * radius * (-0.44, -0.79, 0.42)[q] for q in range(3)]
        view.CenterOfRotation = focus

    def outline(self, view, source):
        display = Show(source, view, "GeometryRepresentation")
        display.Representation = "Surface"
        display.ColorArrayName = ["POINTS", ""]
        display.AmbientColor = display.DiffuseColor = BLACK
        display.LineWidth = 3.0
        display.Ambient, display.Diffuse = 1.0, 0.0

    def title(self, view, text):
        display = Show(Text(Text=text), view, "TextSourceRepresentation")
        display.Color, display.FontSize, display.WindowLocation = BLACK, 22, "Upper Left Corner"

    def draw_spheres(self, name, file, representation, title, with_outline):
        view = self.scene()
        source = XMLPolyDataReader(FileName=[self.file(file)])
        display = Show(source, view, "GeometryRepresentation")
        display.Representation = representation
        self.colour_by_mode(display, view)
        display.Ambient, display.Diffuse = 0.3, 0.8
        if with_outline:
            self.outline(view, XMLPolyDataReader(FileName=[self.file("outline.vtp")]))
        self.title(view, title)
        self.look(view, source)
        self.save(view, name)

    # ---- curves ----

    def table(self, columns):
        """A source of a table from {name: list of numbers}."""
        table = vtkTable()
        for name, values in columns.items():
            column = vtkDoubleArray()
            column.SetName(name)
            for value in values:
                column.InsertNextValue(value)
            table.AddColumn(column)
        source = TrivialProducer()
        source.GetClientSideObject().SetOutput(table)
        return source

    def chart(self, x_title, y_title, x_labels, y_labels):
        view = CreateView("XYChartView", ViewSize=SIZE)
        view.BottomAxisTitle, view.LeftAxisTitle = x_title, y_title
        for axis in ("Bottom", "Left"):
            setattr(view, axis + "AxisTitleFontSize", 24)
            setattr(view, axis + "AxisLabelFontSize", 20)
            setattr(view, axis + "AxisTitleBold", 0)
            setattr(view, axis + "AxisLabelFontFamily", "Times")  # Arial numbers are drawn with stray dashes by Mesa's llvmpipe
            setattr(view, axis + "AxisUseCustomLabels", 1)
            setattr(view, axis + "AxisUseCustomRange", 1)
        # Pairs of value and label
        view.BottomAxisLabels = [text for x in x_labels for text in (repr(x), f"{x:g}")]
        view.LeftAxisLabels = [text for y in y_labels for text in (repr(y), f"{y:g}")]
        view.BottomAxisRangeMinimum, view.BottomAxisRangeMaximum = x_labels[0], x_labels[-1]
        view.LeftAxisRangeMinimum, view.LeftAxisRangeMaximum = y_labels[0], y_labels[-1]
        view.LegendFontSize = 20
        return view

    def curves(self, view, x, series):
        """series: {label: (values, colour, line style, thickness, marker)}; styles: 0 none, 1 solid, 2 dashed, 3 dotted, 4 dash-dot."""
        source = self.table({"r": x, **{label: values for label, (values, *_) in series.items()}})
        display = Show(source, view, "XYChartRepresentation")
        display.UseIndexForXAxis, display.XArrayName = 0, "r"
        display.SeriesVisibility = list(series)
        text = lambda i: [item for label, entry in series.items() for item in (label, str(entry[i]))]
        display.SeriesLabel = [item for label in series for item in (label, label)]
        display.SeriesColor = [item for label, entry in series.items() for item in (label, *map(str, rgb(entry[1])))]
        display.SeriesLineStyle, display.SeriesLineThickness, display.SeriesMarkerStyle = text(2), text(3), text(4)
        display.SeriesMarkerSize = [item for label in series for item in (label, "9")]

    def draw_two_point(self):
        data = {name: [float(v) for v in values] for name, values in read_table(self.file("two_point.csv")).items()}
        fractions = read_table(self.file("one_point.csv"))
        c = dict(zip(fractions["Phase"], map(float, fractions["VolumeFraction"])))
        # The matrix and the modes of the largest volume; for one mode there is no fourth pair
        a, b = (sorted((mode for mode in c if mode != "m"), key=c.get) * 2)[-2:]
        pairs = [pair for pair in ("m_m", f"{b}_m", f"{b}_{b}", "_".join(sorted((a, b), key=int))) if f"S_{pair}_pack" in data]
        pairs = list(dict.fromkeys(pairs))
        view = self.chart(f"r ({self.unit})", "S_rs(r)", ticks(data["r"][-1]), [0.0, 0.1, 0.2, 0.3, 0.4, 0.5])
        x, y = [], []  # all limits as one curve with gaps
        for r, s in (pair.split("_") for pair in pairs):
            x, y = x + [0.0, data["r"][-1], math.nan], y + [c[r] * c[s]] * 2 + [math.nan]
        self.curves(view, data["r"][::MARKER_STEP], {f"S_{p} pack": (data[f"S_{p}_pack"][::MARKER_STEP], colour, 0, 1, 4)
                                                     for p, colour in zip(pairs, CURVE_COLOURS)})
        self.curves(view, data["r"], {f"S_{p} cell": (data[f"S_{p}_cell"], colour, 1, 2, 0) for p, colour in zip(pairs, CURVE_COLOURS)})
        self.curves(view, x, {"limits c_r c_s of the pack": (y, "#777777", 2, 1, 0)})
        self.save(view, "two_point.png")

    def draw_convergence(self):
        data = {name: [float(v) for v in values] for name, values in read_table(self.file("convergence.csv")).items()}
        view = self.chart("Iteration", "F2", ticks(data["Iteration"][-1]), [0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0])
        view.LeftAxisLogScale = 1
        view.ShowLegend = 0
        self.curves(view, data["Iteration"], {"F2": (data["Objective"], CURVE_COLOURS[2], 1, 3, 0)})
        self.save(view, "convergence.png")


def main():
    parser = argparse.ArgumentParser(prog="pvbatch pictures.py", description=__doc__.split("\n")[0],
                                     formatter_class=argparse.ArgumentDefaultsHelpFormatter)
    parser.add_argument("--input", default="unit_cell_results", help="folder of the files")
    parser.add_argument("--output", default="Pictures", help="folder for the pictures")
    pictures = Pictures(parser.parse_args())
    pack, cell = (pictures.number_of_spheres(name) for name in ("pack.vtp", "cell.vtp"))
    pictures.draw_spheres("pack.png", "pack.vtp", "Spheres", f"Pack of {pack} spheres", False)
    pictures.draw_spheres("cell.png", "replicas.vtp", "Spheres", f"Cell of {cell} spheres with periodic copies",
                          True)
    pictures.draw_spheres("cell_cut.png", "surfaces.vtp", "Surface", "The cell, cut at its box", True)
    pictures.draw_two_point()
    pictures.draw_convergence()


if __name__ == "__main__":
    run(main)
