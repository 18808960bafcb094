# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Times the main job on the example pack as a user runs it; started by Testing/Benchmark/run. Prints one line for each figure."""
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


def sampling_job(pack, **settings):
    probability = TwoPointProbability(Input=pack, MaximumLag=200, **settings)
    begin = time.perf_counter()
    probability.UpdatePipeline()
    taken = time.perf_counter() - begin
    return taken, field(servermanager.Fetch(probability, idx=0), 'TotalError')


seconds = [sampling_job(modes, Method='Chord Sampling', TargetError=0.06, Seed=seed)[0] for seed in (1, 2, 3)]
report('chords of the block to a standard error of 0.06: median of 3, s', '%.2f' % statistics.median(seconds))
periodic = UnitCellReconstruction(Input=modes, NumberOfParticles=8000, MaximumIterations=0, NumberOfLags=20)
periodic.UpdatePipeline()
chords = sampling_job(periodic, Method='Chord Sampling', NumberOfLines=50000)
template = sampling_job(periodic, Method='Template Sampling', NumberOfThrows=2000)
report('periodic pack of 8000, 50 000 lines', '%.2f s  error %.4f' % chords)
report('the same by 2000 throws of the template', '%.2f s  error %.4f' % template)
report('chords cheaper at equal error by a factor of', '%.0f' % (template[0] * template[1] ** 2 / (chords[0] * chords[1] ** 2)))
for what, filter in (('S_rs along 32 directions', DirectionalProbability), ('radial distribution functions', RadialDistribution),
                     ('map of S_mm(x), 41^3', ProbabilityMap), ('chord lengths of 20 000 lines', ChordLengths)):
    probability = filter(Input=modes, MaximumLag=200)
    begin = time.perf_counter()
    probability.UpdatePipeline()
    report(what, '%.2f s' % (time.perf_counter() - begin))


def three_point_job(**settings):
    probability = ThreePointProbability(Input=modes, Phases='3 5 5; 7 7 5; m m m', MaximumLag=200, **settings)
    before = megabytes()
    begin = time.perf_counter()
    probability.UpdatePipeline()
    return '%.2f s  %.0f MB more' % (time.perf_counter() - begin, megabytes() - before)


report('S_rsq of three triples, 5000 throws', three_point_job(NumberOfThrows=5000))
report('the same, 50 000 throws', three_point_job())
report('the same with standard errors', three_point_job(StandardErrors=1))


def cell_job(**settings):
    cell = UnitCellReconstruction(Input=modes, NumberOfParticles=1082, MaximumLag=200, **settings)
    begin = time.perf_counter()
    cell.UpdatePipeline()
    taken = time.perf_counter() - begin
    data = servermanager.Fetch(cell)
    return ('%.2f s  F2 %.4f  overlap %g %%  %d iterations' % (taken, field(data, 'Objective'),
            field(data, 'OverlapPercent'), field(data, 'Iterations'))), taken


ALONE = {'ContactWeight': 0, 'PoreWeight': 0}
for target, terms, name in ((0.10, ALONE, 'by F2 alone'), (0.05, ALONE, 'by F2 alone'), (0.05, {}, 'with near neighbours and pores')):
    runs = [cell_job(TargetObjective=target, Seed=seed, **terms) for seed in (1, 2, 3)]
    for seed, (text, taken) in enumerate(runs, 1):
        report('cell of 1082 to F2 <= %.2f %s, seed %d' % (target, name, seed), text)
    report('cell of 1082 to F2 <= %.2f %s, median' % (target, name), '%.2f s' % statistics.median(t for _, t in runs))
report('one generation of 512, evaluated exactly', '%.1f s' % cell_job(Method='Annealed Population', MaximumGenerations=0)[1])

begin = time.perf_counter()
five = UnitCellReconstruction(Input=modes, NumberOfParticles=1082, MaximumLag=200, NumberOfCells=5, **ALONE)
five.UpdatePipeline()
taken = time.perf_counter() - begin
comparison, table = servermanager.Fetch(five, idx=5), servermanager.Fetch(five, idx=4)
percent = {comparison.GetValue(row, 0).ToString(): comparison.GetValueByName(row, 'Percent').ToDouble() for row in range(comparison.GetNumberOfRows())}
f2 = [table.GetValueByName(row, 'Objective').ToDouble() for row in range(table.GetNumberOfRows())]
report('five cells of at most 1000 iterations', '%.1f s  F2 %.4f to %.4f' % (taken, min(f2), max(f2)))
report('their (16), largest of the modes, and (17) of their mean, %', '%.4f  %.4f' % (
    max(value for name, value in percent.items() if name.startswith('c_') and name != 'c_m'), percent['all']))


def estimate_job(what, filter, **settings):
    """EstimatedTime divided by the time that the run then took, and EstimatedMemory."""
    source = filter(Input=modes, MaximumLag=200, **settings)
    source.UpdateVTKObjects()
    source.SMProxy.UpdatePropertyInformation()
    seconds, memory = [source.GetProperty(name).GetData() for name in ('EstimatedTime', 'EstimatedMemory')]
    begin = time.perf_counter()
    source.UpdatePipeline()
    taken = time.perf_counter() - begin
    report('estimated over measured, ' + what, '%.2f  (%.2f s, %.0f MB)' % (seconds / taken, seconds, memory))


for method in ('Exact Pair Sum', 'Chord Sampling', 'Template Sampling'):
    estimate_job(method, TwoPointProbability, Method=method)
estimate_job('32 directions', DirectionalProbability)
estimate_job('map 21^3', ProbabilityMap, Resolution=10)
estimate_job('fans', ThreePointProbability)
estimate_job('Gradient, 200 iterations', UnitCellReconstruction, NumberOfParticles=1082, MaximumIterations=200)
estimate_job('Annealed Population, 20 generations', UnitCellReconstruction, NumberOfParticles=1082, Method='Annealed Population', MaximumGenerations=20)
estimate_job('Hybrid, 5 generations', UnitCellReconstruction, NumberOfParticles=1082, Method='Hybrid', MaximumGenerations=5)
if least:
    for iterations in (2000, 10000):
        report('cell of 1082, %d iterations at most' % iterations, cell_job(MaximumIterations=iterations)[0])
    for seed in (6, 7, 8, 9, 10):
        for method in ('Gradient', 'Hybrid'):
            report('%s, seed %d, 30 s' % (method, seed), cell_job(Method=method, Seed=seed, TimeLimit=30, MaximumIterations=100000)[0])
    for seed in (1, 2):
        population = UnitCellReconstruction(Input=modes, NumberOfParticles=1082, MaximumLag=200, Method='Annealed Population', Seed=seed, TimeLimit=180)
        population.UpdatePipeline()
        row = servermanager.Fetch(population, idx=4)
        numbers = [row.GetValueByName(0, name).ToDouble() for name in (
            'BeforeMinimum', 'BeforeMean', 'BeforeMaximum', 'AfterMinimum', 'AfterMean', 'AfterMaximum', 'Iterations')]
        report('Annealed Population, seed %d, 180 s' % seed, 'F2 %.3f %.3f %.3f -> %.3f %.3f %.3f in %d generations' % tuple(numbers))
report('peak memory over ParaView, MB', '%.0f' % (megabytes() - at_start))
