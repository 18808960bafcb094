# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""A search ended from outside leaves a valid cell: within seconds, marked as stopped, free of overlap.

    pvbatch TestEnding.py pack.csv "Stop file" file|"Time limit" seconds
"""
import os
import subprocess
import sys
import time

from paraview.servermanager import Fetch
from paraview.simple import *

pack, ending, value = sys.argv[1:]
PARTICLES, DELAY, PATIENCE = 1082, 3.0, 5.0
modes = ParticleModes(Input=SpherePackReader(FileName=pack))
modes.UpdatePipeline()


def seconds_of(cell):
    start = time.monotonic()
    cell.UpdatePipeline()
    return time.monotonic() - start


# Where others take the cores, three seconds may end in the first iteration, whose cell is the start
some = seconds_of(UnitCellReconstruction(Input=modes, NumberOfParticles=PARTICLES, MaximumIterations=10))
cell = UnitCellReconstruction(Input=modes, NumberOfParticles=PARTICLES, MaximumIterations=1000000)
if ending == "Stop file":
    if os.path.exists(value):
        os.remove(value)
    cell.StopFile = value
    expected = max(DELAY, 2.0 * some)
    subprocess.Popen(["sh", "-c", f'sleep {expected} && touch "$0"', value])
else:
    expected = cell.TimeLimit = max(float(value), 2.0 * some)
seconds = seconds_of(cell)
print(f"10 iterations took {some:.1f} s, the search ended after {seconds:.1f} of {expected:.1f} s")
assert expected <= seconds < expected + max(PATIENCE, some), seconds

data = Fetch(cell)
fields = data.GetFieldData()
number = lambda name: fields.GetArray(name).GetValue(0)
assert fields.GetAbstractArray("EndedBy").GetValue(0) == ending, fields.GetAbstractArray("EndedBy").GetValue(0)
assert number("Stopped") == 1
assert 0 < number("Iterations") < cell.MaximumIterations
assert 0.0 < number("Objective") < number("StartObjective")
assert number("OverlapPercent") == 0.0

# Overlap once more, by its definition: no two centres are closer than the sum of the radii, images included
assert data.GetNumberOfPoints() == PARTICLES
box = [fields.GetArray("BoxSize").GetValue(axis) for axis in range(3)]
edge = box[0]
spheres = sorted((data.GetPoint(i), data.GetPointData().GetArray("Radius").GetValue(i)) for i in range(PARTICLES))
largest = max(radius for _, radius in spheres)
assert box == [edge] * 3 and edge > 4.0 * largest  # so only the nearest image has to be looked at
for i, (p, radius) in enumerate(spheres):
    for q, other in spheres[:i]:
        d = [abs(a - b) for a, b in zip(p, q)]
        d = [min(a, edge - a) for a in d]
        gap = sum(a * a for a in d) - (radius + other) ** 2
        assert gap >= -1e-12 * edge ** 2, (p, q)
