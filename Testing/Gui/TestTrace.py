# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""The trace of the window makes, in another process, what its state file holds: the same numbers, bit by bit, and charts.

    pvpython TestTrace.py folder       with trace.py of RecordTrace.py and gui.pvsm of menu.xml
"""
import sys

import paraview.simple as pv

from ImageDifference import image_difference
from Outputs import numbers_of

folder = sys.argv[1]
NAMES = ("pack.csv", "ParticleModes1", "UnitCellReconstruction1", "PeriodicReplicas1", "OnePointProbability1", "TwoPointProbability1",
         "ThreePointProbability1")


def describe(kind):
    """Numbers, pictures of the charts, and what views there are. The trace places no camera before it is stopped."""
    pictures = []
    for view in sorted(pv.GetViews("XYChartView"), key=lambda view: view.LeftAxisTitle):
        view.ViewSize = [400, 300]
        pictures.append(f"{folder}/{kind}_{len(pictures)}.png")
        pv.SaveScreenshot(pictures[-1], view, ImageResolution=view.ViewSize)
    views = sorted(view.SMProxy.GetXMLName() for view in pv.GetViews())
    return numbers_of(NAMES), views, pictures


with open(f"{folder}/trace.py") as file:
    exec(file.read(), {"__name__": "__main__"})
traced = describe("traced")
pv.ResetSession()
pv.LoadState(f"{folder}/gui.pvsm")
saved = describe("saved")
assert traced[0] == saved[0], "the numbers differ"
assert traced[1] == saved[1], (traced[1], saved[1])
assert len(traced[2]) == len(saved[2]) == 2
for first, second in zip(traced[2], saved[2]):
    error = image_difference(first, second)
    assert error == 0.0, (first, second, error)
print(f"{len(traced[0])} lines and {len(traced[2])} charts are the same")
for view in pv.GetViews():
    pv.Delete(view)
