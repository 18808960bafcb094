# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the state files to start from in the window: the filters on the bead pack, with their views side by side.

    xvfb-run -a -s "-screen 0 1400x1000x24 -noreset" pvpython states.py --output States
"""
import argparse
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from paraview.simple import *

from common import run

HERE = os.path.dirname(os.path.abspath(__file__))
DATA = os.path.join("Data", "bead_block.csv")  # the states name the file so, below the folder of this script


def read_pack():
    pack = SpherePackReader(registrationName="bead_block.csv", FileName=os.path.join(HERE, DATA), LengthUnit="µm",
                            BoxSize=[1445.372, 1287.892, 789.106])
    return ParticleModes(registrationName="Modes", Input=pack, NumberOfModes=9)


def show_colors(display, array, title):
    """Puts the colour bar below the picture."""
    view, colors = GetActiveView(), GetColorTransferFunction(array)
    display.SetScalarBarVisibility(view, True)
    bar = GetScalarBar(colors, view)
    bar.Title, bar.ComponentTitle, bar.Orientation, bar.WindowLocation, bar.ScalarBarLength = title, "", "Horizontal", "Lower Center", 0.5


def show_in_space(output, *others):
    """Shows spheres coloured by mode, seen at an angle."""
    view = CreateView("RenderView", OrientationAxesVisibility=0)
    display = Show(output, view)
    show_colors(display, "Mode", "Mode")
    for other in others:
        Show(other, view)
    ResetCamera(view)
    center, radius = list(view.CameraFocalPoint), view.CameraParallelScale
    view.CameraPosition = [a + 5.6 * radius * b for a, b in zip(center, (-0.44, -0.79, 0.42))]
    view.CameraFocalPoint, view.CameraViewUp = [*center[:2], center[2] - 0.2 * radius], [0.0, 0.0, 1.0]
    return view


def show_chart(output, series=()):
    """A chart as it opens, or with these columns."""
    view = CreateView("XYChartView")
    display = Show(output, view)
    if series:
        names = display.SeriesVisibility[::2]
        display.SeriesVisibility = [text for name in names for text in (name, "1" if name in series else "0")]
    return view


def show_side_by_side(name, left, *right):
    """One view on the left, the others below each other on the right."""
    layout = CreateLayout(name)
    cell = layout.SplitHorizontal(0, 0.5)
    layout.AssignView(cell, left)
    cell += 1
    for n, view in enumerate(right, 1):
        if n < len(right):
            cell = layout.SplitVertical(cell, 1.0 / (len(right) - n + 1))
        layout.AssignView(cell, view)
        cell += 1
    layout.SetSize(1400, 800)


def statistics():
    modes = read_pack()
    probabilities = TwoPointProbability(registrationName="Two-point", Input=modes, MaximumLag=200)
    distances = RadialDistribution(registrationName="Distances", Input=modes, MaximumLag=200)
    show_side_by_side("Statistics", show_in_space(modes), show_chart(probabilities, ("S_7_7", "S_8_8", "S_8_m", "S_m_m")),
                      show_chart(distances))


def reconstruction():
    cell = UnitCellReconstruction(registrationName="Cell", Input=read_pack(), NumberOfParticles=400, MaximumLag=150, MaximumIterations=150)
    replicas = PeriodicReplicas(registrationName="Replicas", Input=cell)
    show_side_by_side("Reconstruction", show_in_space(replicas, OutputPort(replicas, 1)), show_chart(OutputPort(cell, 2)),
                      show_chart(OutputPort(cell, 1)))


def three_point():
    probabilities = ThreePointProbability(registrationName="Three-point", Input=read_pack(), Phases="m m m", MaximumLag=100, NumberOfLags=100,
                                          NumberOfThrows=10000)
    view = CreateView("RenderView", OrientationAxesVisibility=0)
    display = Show(probabilities, view)
    show_colors(display, "S_m_m_m", "S_mmm at a right angle")
    view.CameraParallelScale = 100.0
    view.CameraFocalPoint = [50.0, 40.0, view.CameraFocalPoint[2]]
    view.CameraPosition = [50.0, 40.0, view.CameraPosition[2]]
    show_side_by_side("Three points", view, show_chart(OutputPort(probabilities, 1)))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--output", default=os.path.join(HERE, "States"), help="folder for the states")
    folder = parser.parse_args().output
    os.makedirs(folder, exist_ok=True)
    for make in (statistics, reconstruction, three_point):
        make()
        RenderAllViews()
        path = os.path.join(folder, make.__name__ + ".pvsm")
        SaveState(path)
        with open(path, encoding="utf-8") as file:
            text = file.read().replace(os.path.join(HERE, DATA), DATA)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        ResetSession()


run(main)
