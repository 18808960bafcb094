# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""A session with all filters and their views, saved and loaded again in another process: the same numbers, bit by bit, and pictures.

    pvpython TestSession.py make pack.csv folder [port ranks]       writes state.pvsm, state.py, numbers and pictures
    pvpython TestSession.py load state folder [port ranks]          loads one of them and compares
"""
import glob
import os
import sys

import paraview.simple as pv
from paraview import servermanager
from paraview.servermanager import OutputPort
from paraview.smstate import get_state

from ImageDifference import image_difference
from Outputs import numbers_of

what, path, folder = sys.argv[1:4]
if len(sys.argv) > 4:
    pv.Connect("127.0.0.1", int(sys.argv[4]))
    assert servermanager.ActiveConnection.GetNumberOfDataPartitions() == int(sys.argv[5])


def make():
    reader = pv.SpherePackReader(registrationName="reader", FileName=path, BoxSize=[10, 10, 10], BoxPeriodic=[1, 1, 1], LengthUnit="µm")
    modes = pv.ParticleModes(registrationName="modes", Input=reader, Method="One Per Size")
    two_point = pv.TwoPointProbability(registrationName="two_point", Input=modes, NumberOfLags=40)
    radial = pv.RadialDistribution(registrationName="radial", Input=modes, NumberOfLags=40)
    cell = pv.UnitCellReconstruction(registrationName="cell", Input=modes, NumberOfParticles=30, NumberOfLags=40, MaximumIterations=10)
    of_cell = pv.TwoPointProbability(registrationName="of_cell", Input=cell, MaximumLag=5, NumberOfLags=40)
    three_point = pv.ThreePointProbability(registrationName="three_point", Input=modes, Phases="1 2 m; m m m", MaximumLag=5, NumberOfLags=20,
                                           NumberOfThrows=200, StandardErrors=1)
    comparison = pv.CompareProbabilities(registrationName="comparison", Input=two_point, Cell=[of_cell, two_point])
    replicas = pv.PeriodicReplicas(registrationName="replicas", Input=cell)

    # The size of a view tells which it is
    def view(kind, width, *outputs):
        new = pv.CreateView(kind, ViewSize=[width, 300])
        displays = [pv.Show(output, new) for output in outputs]
        if kind == "RenderView":
            new.OrientationAxesVisibility = 0
            new.ResetCamera()
        return new, displays

    view("RenderView", 401, modes)
    glyphs, displays = view("RenderView", 402, replicas, OutputPort(replicas, 1))
    for name, value in {"Representation": "3D Glyphs", "GlyphType": "Sphere", "Scaling": 1, "ScaleMode": "Magnitude",
                        "SelectScaleArray": "Radius", "ScaleFactor": 2.0}.items():
        setattr(displays[0], name, value)
    pv.ColorBy(displays[0], ("POINTS", "Mode"))
    map_view, displays = view("RenderView", 403, three_point)
    displays[0].Slice = 2
    chart, displays = view("XYChartView", 404, two_point)
    chart.LeftAxisTitle, chart.BottomAxisTitle = "Mine", ""
    displays[0].SeriesVisibility = ["S_1_1", "1", "S_m_m", "0"]
    view("XYChartView", 405, OutputPort(cell, 1))
    view("XYChartView", 406, OutputPort(comparison, 1))
    view("XYChartView", 407, radial)
    write(folder)
    pv.SaveState(f"{folder}/state.pvsm")
    with open(f"{folder}/state.py", "w") as file:
        file.write(get_state())


def write(target):
    lines = numbers_of(("reader", "modes", "two_point", "radial", "cell", "of_cell", "three_point", "comparison", "replicas"))
    with open(f"{target}/numbers.txt", "w") as file:
        file.write("\n".join(lines) + "\n")
    for view in pv.GetViews():
        pv.SaveScreenshot(f"{target}/view_{view.ViewSize[0]}.png", view, ImageResolution=view.ViewSize)


def load():
    loaded = f"{folder}/loaded"
    os.makedirs(loaded, exist_ok=True)
    for old in glob.glob(f"{loaded}/*"):
        os.remove(old)
    if path.endswith(".pvsm"):
        pv.LoadState(path)
    else:
        with open(path) as file:
            exec(file.read(), {"__name__": "__main__"})
    write(loaded)
    with open(f"{folder}/numbers.txt") as first, open(f"{loaded}/numbers.txt") as second:
        assert first.read() == second.read(), "the numbers differ"
    pictures = sorted(os.path.basename(name) for name in glob.glob(f"{folder}/view_*.png"))
    assert pictures == sorted(os.path.basename(name) for name in glob.glob(f"{loaded}/view_*.png")), "not the same views"
    assert len(pictures) == 7
    for name in pictures:
        error = image_difference(f"{folder}/{name}", f"{loaded}/{name}")
        print(name, error)
        assert error == 0.0, name


make() if what == "make" else load()
for view in pv.GetViews():
    pv.Delete(view)
