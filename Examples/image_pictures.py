# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures of the way from an image to a cell from the files that from_image.py has left.

    xvfb-run -a -s "-screen 0 1400x1000x24 -noreset" pvbatch image_pictures.py --input results --output Pictures

It runs on one rank. The last two correspond to figures 12(a) and 12(b) of the paper.
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
from pictures import read_table, rgb, ticks
from statistics_pictures import Charts

STEPS = 60  # of an outline
COLOURS = {"voxels": "#222222", "pack": "#bb3344", "cell": "#0077bb"}
NAMES = {"voxels": "voxel pack", "pack": "pack", "cell": "cell"}


class ImagePictures(Charts):
    def __init__(self, args):
        super().__init__(args.output)
        self.input = os.path.abspath(args.input)
        self.particles = Fetch(XMLPolyDataReader(FileName=[self.file("particles.vtp")]))
        self.unit = self.particles.GetFieldData().GetAbstractArray("LengthUnit").GetValue(0)

    def plane(self, name):
        return XMLImageDataReader(FileName=[self.file(name)])

    def outlines(self, image):
        """The circles in which a plane cuts the spheres, above it by a hundredth of a voxel."""
        z, above = image.GetBounds()[4], 0.01 * image.GetSpacing()[0]
        points, lines, data = vtkPoints(), vtkCellArray(), vtkPolyData()
        radius = self.particles.GetPointData().GetArray("Radius")
        for n in range(self.particles.GetNumberOfPoints()):
            centre = self.particles.GetPoint(n)
            square = radius.GetValue(n)**2 - (centre[2] - z)**2
            if square > 0:
                lines.InsertNextCell(STEPS + 1)
                first = points.GetNumberOfPoints()
                for k in range(STEPS):
                    angle = 2 * math.pi * k / STEPS
                    points.InsertNextPoint(centre[0] + math.sqrt(square) * math.cos(angle), centre[1] + math.sqrt(square) * math.sin(angle), z + above)
                for k in range(STEPS + 1):
                    lines.InsertCellPoint(first + k % STEPS)
        data.SetPoints(points)
        data.SetLines(lines)
        source = TrivialProducer()
        source.GetClientSideObject().SetOutput(data)
        return source

    def draw_plane(self, name, file, scale):
        """A part of the middle plane in grey, with the outlines of the spheres."""
        source = self.plane(file)
        image = Fetch(source)
        array = image.GetPointData().GetArrayName(0)
        low, high = scale(image.GetPointData().GetArray(0).GetRange())
        view = self.scene()
        display = Show(source, view, "UniformGridRepresentation")
        display.Representation = "Slice"
        ColorBy(display, ("POINTS", array))
        colours = GetColorTransferFunction(array)
        colours.ColorSpace, colours.RGBPoints = "RGB", [low, 0.0, 0.0, 0.0, high, 1.0, 1.0, 1.0]
        display.SetScalarBarVisibility(view, False)
        lines = Show(self.outlines(image), view, "GeometryRepresentation")
        lines.ColorArrayName = ["POINTS", ""]
        lines.AmbientColor = lines.DiffuseColor = rgb("#ee7733")
        lines.LineWidth, lines.Ambient, lines.Diffuse = 2.5, 1.0, 0.0
        x0, x1, y0, y1, z, _ = image.GetBounds()
        half = min(0.5 * (y1 - y0), 0.375 * (x1 - x0))
        view.CameraParallelProjection, view.CameraParallelScale = 1, 0.8 * half
        view.CameraFocalPoint, view.CameraViewUp = [(x0 + x1) / 2, (y0 + y1) / 2, z], [0, 1, 0]
        view.CameraPosition = [(x0 + x1) / 2, (y0 + y1) / 2, z + 10 * half]
        self.save(view, name)

    def numbers(self, name):
        return {column: [float(value) for value in values] for column, values in read_table(self.file(name)).items()}

    def draw_fractions(self):
        table = self.numbers("fractions.csv")
        top = ticks(max(max(table[name]) for name in NAMES))
        view = self.chart("Mode i", "Volume fraction c_i", [0.0] + table["Mode"] + [table["Mode"][-1] + 1.0], top)
        # Beside each other, as the paper has them
        for n, name in enumerate(NAMES):
            x, y = [], []
            for mode, value in zip(table["Mode"], table[name]):
                at = mode + 0.22 * (n - 1)
                x, y = x + [at, at, math.nan], y + [0.0, value, math.nan]
            self.plot(view, [(NAMES[name], x, y, COLOURS[name], 1, 26, 0)])
        self.save(view, "from_image_fractions.png")

    def draw_errors(self):
        table = self.numbers("fractions.csv")
        top = ticks(1.25 * max(table["error_pack"] + table["error_cell"]))  # and room for the legend
        view = self.chart("Mode i", "Error of c_i, equation 16 (%)", [0.0] + table["Mode"] + [table["Mode"][-1] + 1.0], top)
        self.plot(view, [(f"{NAMES[name]} against voxel pack", table["Mode"], table["error_" + name], COLOURS[name], 1, 3, 4) for name in ("pack", "cell")])
        self.save(view, "from_image_errors.png")

    def draw_two_point(self):
        table = self.numbers("two_point.csv")
        view = self.chart(f"r ({self.unit})", "S_mm(r)", ticks(table["r"][-1]), [0.0, 0.1, 0.2, 0.3, 0.4, 0.5])
        self.plot(view, [("S_mm of the voxels", table["r"][::2], table["voxels"][::2], COLOURS["voxels"], 0, 1, 4),
                         ("of the pack", table["r"], table["pack"], COLOURS["pack"], 1, 2, 0),
                         ("of the cell", table["r"], table["cell"], COLOURS["cell"], 1, 2, 0)])
        self.save(view, "from_image_two_point.png")


def main(args):
    pictures = ImagePictures(args)
    contrast = pictures.particles.GetFieldData()
    contrast = contrast.GetArray("ParticleValue").GetValue(0) - contrast.GetArray("MatrixValue").GetValue(0)
    pictures.draw_plane("from_image_slice.png", "slice.vti", lambda r: r)
    pictures.draw_plane("from_image_residual.png", "residual.vti", lambda r: (-0.5 * abs(contrast), 0.5 * abs(contrast)))
    pictures.draw_fractions()
    pictures.draw_errors()
    pictures.draw_two_point()


if __name__ == "__main__":
    parser = argparse.ArgumentParser(prog="pvbatch image_pictures.py", description=__doc__.split("\n")[0])
    parser.add_argument("--input", default="from_image_results", help="folder with the files of from_image.py")
    parser.add_argument("--output", default="from_image_results", help="folder for the pictures")
    run(main, parser.parse_args())
