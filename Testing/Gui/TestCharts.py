# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""How tables and images open: columns, axes, titles with unit, limits, and what a user chose stays.

    pvpython TestCharts.py pack.csv folder [port ranks]      with a port: by a server
"""
import sys

import paraview.simple as pv
from paraview import servermanager
from paraview.servermanager import Fetch, OutputPort

pack, folder = sys.argv[1:3]
if len(sys.argv) > 3:
    pv.Connect("127.0.0.1", int(sys.argv[3]))
    assert servermanager.ActiveConnection.GetNumberOfDataPartitions() == int(sys.argv[4])

reader = pv.SpherePackReader(FileName=pack, BoxSize=[10, 10, 10], BoxPeriodic=[1, 1, 1], LengthUnit="µm")
modes = pv.ParticleModes(Input=reader, Method="One Per Size")
two_point = pv.TwoPointProbability(Input=modes, NumberOfLags=40)
sampled = pv.TwoPointProbability(Input=modes, NumberOfLags=40, Method="Chord Sampling", NumberOfLines=100)
directions = pv.DirectionalProbability(Input=modes, NumberOfLags=40, NumberOfDirections=2)
sampled_directions = pv.DirectionalProbability(Input=modes, NumberOfLags=40, NumberOfDirections=2, Method="Chord Sampling", NumberOfLines=100)
of_pairs = pv.ProbabilityMap(Input=modes, Resolution=3)
chords = pv.ChordLengths(Input=modes, NumberOfLags=40)
radial = pv.RadialDistribution(Input=modes, NumberOfLags=40)
cell = pv.UnitCellReconstruction(Input=modes, NumberOfParticles=30, NumberOfLags=40, MaximumIterations=5)
three_point = pv.ThreePointProbability(Input=modes, Phases="m m m", MaximumLag=5, NumberOfLags=8, NumberOfThrows=200, StandardErrors=1)
of_cell = pv.TwoPointProbability(Input=cell, MaximumLag=5, NumberOfLags=40)
comparison = pv.CompareProbabilities(Input=two_point, Cell=of_cell)

BOTTOM, LEFT = 1, 0  # vtkAxis
LAG = "Lag r (µm)"
BOTH = ["S_m_m_cell", "S_m_m_pack"]
# For each output the column at the bottom, what is drawn, and the titles at the bottom, on the left and on the right
CHARTS = {
    (modes, 1): ("Mode", ["VolumeFraction"], "Mode", "Volume fraction", ""),
    (two_point, 0): ("r", ["S_m_m"], LAG, "Probability S_rs", ""),
    (two_point, 2): ("r", ["S_m_m"], LAG, "Gradient dS_rs/dr (1/µm)", ""),
    (directions, 0): ("r", ["sigma_S_m_m"], LAG, "Deviation of S_rs over directions", ""),
    (directions, 1): ("r", ["S_m_m"], LAG, "Probability S_rs along directions", ""),
    (chords, 0): ("r", ["L_m", "p_m"], "Length (µm)", "Chord-length density p (1/µm)", "Lineal path L"),
    (radial, 0): ("r", ["g"], "Distance r (µm)", "Radial distribution g", ""),
    (two_point, 3): ("r", ["chi_m_m"], LAG, "Autocovariance S_rs - c_r c_s", ""),
    (sampled, 0): ("r", ["S_m_m"], LAG, "Probability S_rs", ""),
    (sampled_directions, 0): ("r", ["sigma_S_m_m", "sigma_S_m_m_noise"], LAG, "Deviation of S_rs over directions", ""),
    (cell, 1): ("Iteration", ["Objective"], "Iteration", "Objective F2", "Overlap (%)"),
    (cell, 2): ("r", BOTH, LAG, "Probability S_rs", ""),
    (three_point, 1): ("r", ["S_m_m_m_r1_axis", "S_m_m_m_r1_axis_limit"], LAG, "Probability S_rsq", ""),
    (comparison, 1): ("r", BOTH, LAG, "Probability S_rs", ""),
}
failures = []


def check(what, found, expected):
    if found != expected:
        failures.append(f"{what}: {found!r}, where {expected!r} is due")


def pairs(values, size=2):
    return {values[n]: tuple(values[n + 1:n + size]) for n in range(0, len(values), size)}


def shown(display):
    return sorted(name for name, (flag,) in pairs(display.SeriesVisibility).items() if flag == "1")


for (source, port), (x, series, bottom, left, right) in CHARTS.items():
    what = f"{source.SMProxy.GetXMLName()} {port}"
    view = pv.CreateView("XYChartView", ViewSize=[400, 300])
    display = pv.Show(OutputPort(source, port), view)
    pv.Render(view)
    check(what + " x", (display.UseIndexForXAxis, display.XArrayName), (0, x))
    check(what + " drawn", shown(display), series)
    check(what + " titles", (view.BottomAxisTitle, view.LeftAxisTitle, view.RightAxisTitle), (bottom, left, right))
    colors = pairs(display.SeriesColor, 4)
    check(what + " colours", len({colors[name] for name in series}), len(series))
    chart = view.GetClientSideObject().GetContextItem()
    plots = [chart.GetPlot(n) for n in range(chart.GetNumberOfPlots())]
    check(what + " curves", sorted(plot.GetLabel() for plot in plots if plot.GetVisible() and plot.GetLabel()), series)
    # No empty margin: the axis at the bottom is as long as the column, to the next round number
    column = Fetch(source, 0, idx=port).GetColumnByName(x)
    values = [column.GetTuple1(i) for i in range(column.GetNumberOfTuples())]
    low, high = chart.GetAxis(BOTTOM).GetUnscaledMinimum(), chart.GetAxis(BOTTOM).GetUnscaledMaximum()
    check(what + " limits", (low == min(values), max(values) <= high <= min(values) + 1.2 * (max(values) - min(values))), (True, True))
    if (source, port) == (cell, 1):
        check("convergence by powers of ten", (view.LeftAxisLogScale, chart.GetAxis(LEFT).GetLogScaleActive()), (1, True))
        check("overlap by the axis on the right", pairs(display.SeriesPlotCorner)["OverlapPercent"], ("1",))
    else:
        check(what + " scale", view.LeftAxisLogScale, 0)
    if series == BOTH:
        styles = pairs(display.SeriesLineStyle)
        check(what + " lines", (styles["S_m_m_cell"], styles["S_m_m_pack"]), (("1",), ("2",)))
    pv.SaveScreenshot(f"{folder}/chart_{source.SMProxy.GetXMLName()}_{port}.png", view, ImageResolution=view.ViewSize)
    pv.Delete(view)

# Without a unit there are no brackets
plain = pv.SpherePackReader(FileName=pack, BoxSize=[10, 10, 10], BoxPeriodic=[1, 1, 1])
plain_modes = pv.ParticleModes(Input=plain, Method="Equal Width", NumberOfModes=2)
plain_probabilities = pv.TwoPointProbability(Input=plain_modes, NumberOfLags=40)
view = pv.CreateView("XYChartView", ViewSize=[400, 300])
display = pv.Show(plain_probabilities, view)
check("title without unit", view.BottomAxisTitle, "Lag r")

# What a user writes and ticks stays when the filter runs again and when another table comes into the view
view.LeftAxisTitle, view.BottomAxisTitle = "Mine", ""
display.SeriesVisibility = ["S_1_1", "1", "S_m_m", "0"]
plain_modes.NumberOfModes = 3
pv.Render(view)
check("the title of a user", (view.LeftAxisTitle, view.BottomAxisTitle), ("Mine", ""))
check("the series of a user", shown(display), ["S_1_1"])
check("the new series are there", "S_3_3" in pairs(display.SeriesColor, 4), True)
pv.Show(OutputPort(cell, 1), view)
pv.Render(view)
check("the titles with a second table", (view.LeftAxisTitle, view.BottomAxisTitle, view.LeftAxisLogScale), ("Mine", "", 0))
pv.Delete(view)

# Images over lags show their middle slice, seen from above, with titled axes
for source, port, titles, slice_number in ((three_point, 0, ["r1 (µm)", "r2 (µm)", "theta (degrees)"], 10),
                                           (of_pairs, 0, ["x (µm)", "y (µm)", "z (µm)"], 3)):
    view = pv.CreateView("RenderView", ViewSize=[400, 300])
    pv.Show(modes, view)
    pv.Render(view)
    view.CameraPosition = [40, 30, 20]
    display = pv.Show(OutputPort(source, port), view)
    grid = display.DataAxesGrid
    check("image titles", (grid.GridAxesVisibility, [grid.XTitle, grid.YTitle, grid.ZTitle]), (1, titles))
    check("image slice", (display.Representation, display.Slice), ("Slice", slice_number))
    check("image colours", display.ColorArrayName[1], "S_m_m" if source is of_pairs else "S_m_m_m")
    bounds = source.GetDataInformation(port).GetBounds()
    center = [0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3])]
    sight = [a - b for a, b in zip(view.CameraPosition, view.CameraFocalPoint)]
    check("camera", (sight[:2], sight[2] > 0.0, list(view.CameraFocalPoint[:2])), ([0.0, 0.0], True, center))
    edge = bounds[3] - bounds[2]
    check("in sight", edge < 2.0 * view.CameraParallelScale < 2.0 * edge, True)
    pv.Hide(modes, view)
    pv.Render(view)
    view.ResetCamera()
    check("in sight after a reset", edge < 2.0 * view.CameraParallelScale < 2.0 * edge, True)
    pv.Delete(view)

# After a chart, a filter whose result lies in space finds the 3D view
render = pv.CreateView("RenderView")
pv.Show(modes, render)
chart = pv.CreateView("XYChartView")
pv.SetActiveView(chart)
pv.CompareProbabilities(Input=two_point, Cell=of_cell)
check("a table leaves the chart active", pv.GetActiveView() == chart, True)
pv.PeriodicReplicas(Input=cell)
check("the 3D view is active", pv.GetActiveView() == render, True)
pv.Delete(chart)
pv.Delete(render)

print("\n".join(failures) or "all as it should be")
sys.exit(1 if failures else 0)
