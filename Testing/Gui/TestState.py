# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Opens the state that menu.xml has saved: properties as set in the panel, spheres drawn as such, the picture.

    pvpython TestState.py state.pvsm baseline.png picture.png

Where the search is meant to find another cell, look at the new picture and copy it over the baseline.
"""
import sys

from paraview.servermanager import Fetch
from paraview.simple import *

from ImageDifference import image_difference

state, baseline, picture = sys.argv[1:]
LoadState(state)
reader, modes, cell, replicas, one_point, two_point, three_point = (FindSource(name) for name in (
    "pack.csv", "ParticleModes1", "UnitCellReconstruction1", "PeriodicReplicas1", "OnePointProbability1", "TwoPointProbability1",
    "ThreePointProbability1"))
view = FindViewOrCreate("RenderView1", "RenderView")

assert list(reader.BoxSize) == [10.0, 10.0, 10.0] and list(reader.BoxPeriodic) == [1, 1, 1]
assert modes.Method == "One Per Size"
assert (cell.NumberOfParticles, cell.NumberOfLags, cell.MaximumIterations) == (30, 40, 5)
assert (replicas.Method, list(replicas.Tiles)) == ("Tiling", [2, 1, 1])
for source in reader, modes, cell, replicas:
    display = GetRepresentation(source, view)
    assert display.Representation == "Spheres", (source, display.Representation)
    assert Fetch(source).GetPointData().GetArray("Radius")
assert Fetch(replicas).GetNumberOfPoints() == 2 * Fetch(cell).GetNumberOfPoints() == 60
assert Fetch(one_point).GetNumberOfRows() == 4
assert Fetch(two_point).GetNumberOfRows() == two_point.NumberOfLags + 1 == 41
assert Fetch(three_point).GetDimensions() == (21, 21, 21)
assert Fetch(three_point).GetPointData().GetScalars().GetName() == "S_m_m_m"

# What Apply has opened: each chart in a view of its own, and the map apart from the pack
charts = GetViews("XYChartView")
assert sorted(chart.LeftAxisTitle for chart in charts) == ["Objective F2", "Probability S_rs"]
for chart, source, port in zip(sorted(charts, key=lambda chart: chart.LeftAxisTitle), (cell, two_point), (1, 0)):
    assert GetRepresentation(OutputPort(source, port), chart).Visibility
assert three_point not in [display.Input for display in view.Representations if hasattr(display, "Input")]
assert len(GetViews("RenderView")) == 2

view.ViewSize = [400, 300]
view.OrientationAxesVisibility = 0
view.ResetActiveCameraToNegativeZ()
view.ResetCamera()
SaveScreenshot(picture, view, ImageResolution=view.ViewSize)
error = image_difference(picture, baseline)
print(f"difference of the pictures: {error}")
# Otherwise the window would outlive its GL context and end with GLXBadContext
Delete(view)
del view, display
sys.exit(0 if error < 20.0 else 1)
