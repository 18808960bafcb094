# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Times the main job on the example pack as a user runs it; started by Testing/Benchmark/run. Prints one line a figure."""
import os
import resource
import statistics
import sys
import time

from paraview import servermanager
from paraview.simple import *

ranks = servermanager.ActiveConnection.GetNumberOfDataPartitions()
least = '--least' in sys.argv
pack_file = os.path.join(os.path.dirname(os.path.abspath(__file__)), '../../Examples/Data/bead_block.csv')


def megabytes():
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def report(what, value):
    print('%-64s ranks %d  %s' % (what, ranks, value), flush=True)


def field(data, name):
    return data.GetFieldData().GetArray(name).GetComponent(0, 0)


at_start = megabytes()


def statistics_job():
    reader = SpherePackReader(FileName=pack_file, BoxSize=[1445.372, 1287.892, 789.106])
    modes = ParticleModes(Input=reader)
    probability = TwoPointProbability(Input=modes, MaximumLag=200)
    begin = time.perf_counter()
    probability.UpdatePipeline()
    return modes, time.perf_counter() - begin


seconds = []
for run in range(7):
    modes, taken = statistics_job()
    seconds.append(taken)
report('read, modes, all S_rs (K = 277 to 200 um): median of 7, s', '%.3f' % statistics.median(seconds))
report('peak memory over ParaView, MB', '%.0f' % (megabytes() - at_start))


def cell_job(**settings):
    cell = UnitCellReconstruction(Input=modes, NumberOfParticles=1082, MaximumLag=200, **settings)
    begin = time.perf_counter()
    cell.UpdatePipeline()
    taken = time.perf_counter() - begin
    data = servermanager.Fetch(cell)
    return ('%.2f s  F2 %.4f  overlap %g %%  %d iterations' % (taken, field(data, 'Objective'),
            field(data, 'OverlapPercent'), field(data, 'Iterations'))), taken


for target in (0.10, 0.06):
    runs = [cell_job(TargetObjective=target, Seed=seed) for seed in (1, 2, 3)]
    for seed, (text, taken) in enumerate(runs, 1):
        report('cell of 1082 to F2 <= %.2f, seed %d' % (target, seed), text)
    report('cell of 1082 to F2 <= %.2f, median' % target, '%.2f s' % statistics.median(t for _, t in runs))
if least:
    for iterations in (2000, 10000):
        report('cell of 1082, %d iterations at most' % iterations, cell_job(MaximumIterations=iterations)[0])
report('peak memory over ParaView, MB', '%.0f' % (megabytes() - at_start))
