# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Loads a state file of the examples as a user does, and looks at what is in it.

    pvpython TestStates.py folder name Examples/Data
"""
import csv
import os
import sys

import paraview.simple as pv
from paraview.servermanager import Fetch

folder, name, data = sys.argv[1:4]
path = os.path.join(folder, name + ".pvsm")
with open(path, encoding="utf-8") as file:
    text = file.read()
assert 'value="Data/bead_block.csv"' in text and f'value="{os.path.dirname(data)}' not in text, "a path of the machine that made it"
pv.LoadState(path, data_directory=data)
pv.RenderAllViews()

with open(os.path.join(data, "bead_block.csv")) as file:
    beads = sum(1 for _ in csv.reader(file)) - 1
modes = pv.FindSource("Modes")
assert modes.GetDataInformation(0).GetNumberOfPoints() == beads


def column(table, label):
    array = table.GetColumnByName(label)
    return [array.GetTuple1(n) for n in range(array.GetNumberOfTuples())]


views = pv.GetViews()
charts = [view for view in views if view.SMProxy.GetXMLName() == "XYChartView"]
titles = sorted((view.BottomAxisTitle, view.LeftAxisTitle) for view in charts)
if name == "statistics":
    table = Fetch(pv.FindSource("Two-point"), 0)
    # Every point is in one phase, but for the overlap above which the filter warns
    assert abs(sum(column(table, f"S_{phase}_{phase}")[0] for phase in [*range(1, 10), "m"]) - 1.0) < 1e-4
    assert titles == [("Distance r (µm)", "Radial distribution g"), ("Lag r (µm)", "Probability S_rs")], titles
elif name == "reconstruction":
    cell, convergence = Fetch(pv.FindSource("Cell")), Fetch(pv.FindSource("Cell"), 0, idx=1)
    assert cell.GetNumberOfPoints() == 400
    assert cell.GetFieldData().GetArray("OverlapPercent").GetValue(0) == 0.0
    objective = column(convergence, "Objective")
    assert objective[-1] < 0.1 * objective[0]
    assert titles == [("Iteration", "Objective F2"), ("Lag r (µm)", "Probability S_rs")], titles
    assert sorted(view.LeftAxisLogScale for view in charts) == [0, 1]
else:
    image = Fetch(pv.FindSource("Three-point"))
    # Where all three points are in one place, it is the fraction of the matrix, to five standard errors of 10 000 throws
    fraction = 1.0 - sum(column(Fetch(modes, 0, idx=1), "VolumeFraction"))
    assert abs(image.GetPointData().GetArray("S_m_m_m").GetValue(0) - fraction) < 5.0 * (0.25 / 10000) ** 0.5
    assert titles == [("Lag r (µm)", "Probability S_rsq")], titles
assert len(views) == len(charts) + 1
for view in views:
    shown = [display for display in view.Representations if getattr(display, "Visibility", 0) and hasattr(display, "Input")]
    assert shown, "an empty view"
    pv.Delete(view)
print(f"{name}: {len(views)} views")
