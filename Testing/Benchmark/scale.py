# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Time and memory of the exact sum against the number of spheres; started by Testing/Benchmark/run --scale.

The pack is a periodic cell of 10 000 spheres of five sizes at a fraction of 0.55, tiled; the lags go to five mean diameters in K = 200 steps.
"""
import math
import os
import sys
import time

from paraview import servermanager
from paraview.simple import *

ranks = servermanager.ActiveConnection.GetNumberOfDataPartitions()
here = os.path.dirname(os.path.abspath(__file__))


def peak_megabytes():
    """The largest memory of each rank so far, ParaView included."""
    peaks = []
    for process in filter(str.isdigit, os.listdir('/proc')):
        try:
            with open('/proc/%s/cmdline' % process) as file:
                ours = file.read().split('\0')[0].endswith('pvbatch') and os.getpgid(int(process)) != os.getpgid(1)
            with open('/proc/%s/status' % process) as file:
                peaks += [int(line.split()[1]) // 1024 for line in file if ours and line.startswith('VmHWM')]
        except OSError:
            pass  # the rank has ended
    return peaks


def report(what, value):
    print('%-64s ranks %d  %s' % (what, ranks, value), flush=True)


reader = SpherePackReader(FileName=os.path.join(here, '../../Examples/Data/bead_block.csv'), BoxSize=[1445.372, 1287.892, 789.106])
modes = ParticleModes(Input=reader, NumberOfModes=5)
modes.UpdatePipeline()
block = servermanager.Fetch(modes)
radii = block.GetPointData().GetArray('Radius')
diameter = 2 * (sum(radii.GetValue(i) ** 3 for i in range(radii.GetNumberOfTuples())) / radii.GetNumberOfTuples()) ** (1 / 3)
cell = UnitCellReconstruction(Input=modes, NumberOfParticles=10000, NumberOfLags=20, MaximumIterations=0)
cell.UpdatePipeline()

timed = []
for tiles in ((1, 1, 1), (2, 5, 1), (5, 5, 4), (10, 10, 10))[0 if ranks == 1 else 3:]:
    pack = PeriodicReplicas(Input=cell, Method='Tiling', Tiles=tiles)
    pack.UpdatePipeline()
    spheres = pack.GetDataInformation().GetNumberOfPoints()
    probability = TwoPointProbability(Input=pack, MaximumLag=5 * diameter, NumberOfLags=200)
    probability.UpdateVTKObjects()
    probability.SMProxy.UpdatePropertyInformation()
    estimate = probability.GetProperty('EstimatedTime').GetData()
    begin = time.perf_counter()
    probability.UpdatePipeline()
    timed.append((spheres, time.perf_counter() - begin))
    report('exact sum of %d spheres, lags to five mean diameters' % spheres,
           '%.2f s, estimated %.2f s, peak memory of each rank %s MB' % (timed[-1][1], estimate, peak_megabytes()))
    Delete(probability)
    Delete(pack)
if len(timed) > 1:
    # least squares of log time on log number
    x, y = [[math.log(pair[i]) for pair in timed] for i in (0, 1)]
    mx, my = sum(x) / len(x), sum(y) / len(y)
    exponent = sum((a - mx) * (b - my) for a, b in zip(x, y)) / sum((a - mx) ** 2 for a in x)
    report('exponent of time against number', '%.3f' % exponent)
