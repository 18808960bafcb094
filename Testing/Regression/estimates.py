# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""EstimatedTime and EstimatedMemory: known before a run and without one, 0 where there is nothing to go by. The tests do not look at how long a run
takes; Testing/Benchmark/run prints it."""
import os
import re

from paraview.simple import *

from harness import RANKS, fetch, run

here = os.path.dirname(os.path.abspath(__file__))


def estimate(source):
    """Asks for seconds and megabytes as a panel does."""
    source.UpdateVTKObjects()
    source.SMProxy.UpdatePropertyInformation()
    return [source.GetProperty(name).GetData() for name in ('EstimatedTime', 'EstimatedMemory')]


def has_run(source):
    info = source.GetDataInformation()
    return info.GetNumberOfRows() > 0 or info.GetNumberOfPoints() > 0


def make_pack():
    reader = SpherePackReader(FileName=os.path.join(here, '../Gui/pack.csv'))
    modes = ParticleModes(Input=reader, NumberOfModes=2)
    modes.UpdatePipeline()
    return modes


def filters():
    return TwoPointProbability, ThreePointProbability, UnitCellReconstruction, *of_one_lag()


def of_one_lag():
    return DirectionalProbability, ProbabilityMap, ChordLengths, RadialDistribution


def without_a_run():
    """The estimates are there before the first run, grow with the work, and running is left to the user."""
    pack = make_pack()
    more = {TwoPointProbability: {'NumberOfLags': 10000}, ThreePointProbability: {'NumberOfThrows': 1000000},
            UnitCellReconstruction: {'NumberOfCells': 4}, DirectionalProbability: {'NumberOfDirections': 1000},
            ProbabilityMap: {'Resolution': 60}, ChordLengths: {'NumberOfLines': 1000000}, RadialDistribution: {'MaximumLag': 15}}
    for filter in filters():
        source = filter(Input=pack)
        seconds, megabytes = estimate(source)
        assert seconds > 0.0 and megabytes > 0.0, (filter, seconds, megabytes)
        longer = filter(Input=pack, **more[filter])
        assert estimate(longer)[0] > seconds, (filter, seconds)
        assert not has_run(source) and not has_run(longer), filter
    for method in ('Chord Sampling', 'Template Sampling'):
        assert min(estimate(TwoPointProbability(Input=pack, Method=method))) > 0.0, method
    for method in ('Annealed Population', 'Hybrid'):
        assert min(estimate(UnitCellReconstruction(Input=pack, Method=method))) > 0.0, method
    # The search takes at most the time limit; the work on the pack comes on top
    endless = UnitCellReconstruction(Input=pack, MaximumIterations=1000000000)
    unlimited = estimate(endless)[0]
    endless.TimeLimit = 5
    assert 5.0 <= estimate(endless)[0] < 10.0 < unlimited, (estimate(endless), unlimited)


def automatic_values():
    """What 0 stands for is said before the run, and is what the field data say after it."""
    pack = make_pack()
    for filter in (TwoPointProbability, ThreePointProbability):
        source = filter(Input=pack)
        estimate(source)
        said = source.GetProperty('AutomaticValues').GetData()
        taken = fetch(source, 1).GetFieldData().GetArray('MaximumLag').GetValue(0)
        assert said == 'Maximum Lag %.6g' % taken, (filter, said, taken)
        source.MaximumLag = 1.0
        estimate(source)
        assert not source.GetProperty('AutomaticValues').GetData()
    cell = UnitCellReconstruction(Input=pack, NumberOfParticles=100, MaximumIterations=1, NumberOfLags=20)
    estimate(cell)
    said = cell.GetProperty('AutomaticValues').GetData()
    taken = fetch(cell).GetFieldData().GetArray('BoxSize').GetValue(0) / 2
    number = float(said.split()[-1])
    # The final edge differs a little, so that the fractions fit best; two digits are said
    assert said.startswith('Maximum Lag ') and abs(number / taken - 1) < 0.15, (said, taken)
    cell.NumberOfParticles = 0
    estimate(cell)
    assert re.fullmatch(r'Number Of Particles \S+, Cell Size \S+, Maximum Lag \S+', cell.GetProperty('AutomaticValues').GetData())


def of_third_order():
    """More around every centre takes longer, and the automatic cut-off is said."""
    pack = make_pack()
    box = {'BoxSize': [10, 10, 10], 'BoxPeriodic': [1, 1, 1]}
    source = ThirdOrderParameters(Input=pack, **box)
    seconds, megabytes = estimate(source)
    assert seconds > 0.0 and megabytes > 0.0, (seconds, megabytes)
    said = source.GetProperty('AutomaticValues').GetData()
    cut_off = float(said.split()[-1])
    assert said.startswith('Cut Off ') and cut_off > 0.0, said
    longer = ThirdOrderParameters(Input=pack, CutOff=3 * cut_off, **box)
    assert estimate(longer)[0] > seconds and not longer.GetProperty('AutomaticValues').GetData()
    for bad in ({'MaximumDegree': 3}, {'CutOff': -1.0}, {'CutOff': float('nan')}, {'Blocks': 0}, {'Slabs': -1}):
        assert estimate(ThirdOrderParameters(Input=pack, **box, **bad))[0] == 0.0, bad
    taken = fetch(source).GetFieldData().GetArray('CutOff').GetValue(0)
    assert '%.6g' % taken == '%.6g' % cut_off, (taken, cut_off)


def of_properties():
    """Twice the voxels along an edge take eight times as long and as much memory, and stiffness more than conductivity."""
    pack = make_pack()
    box = {'BoxSize': [10, 10, 10], 'BoxPeriodic': [1, 1, 1], 'Method': 'Solver', 'SecondResolution': 0}
    seconds, megabytes = estimate(EffectiveProperties(Input=pack, Resolution=64, **box))
    twice = estimate(EffectiveProperties(Input=pack, Resolution=128, **box))
    assert 6 < twice[0] / seconds < 9 and 5 < twice[1] / megabytes < 9, (seconds, megabytes, twice)
    stiff = estimate(EffectiveProperties(Input=pack, Resolution=64, Property='Elasticity', **box))
    assert stiff[0] > 3 * seconds and stiff[1] > 2 * megabytes, (seconds, megabytes, stiff)
    for bad in ({'Resolution': 1}, {'Tolerance': 0.0}, {'Fields': 4}, {'MatrixConductivity': 0.0}, {'WindowSize': [20, 1, 1]}):
        assert estimate(EffectiveProperties(Input=pack, **{**box, **bad}))[0] == 0.0, bad


def of_neighbours():
    """More gaps by pair of modes take more memory, more points more time, and the automatic distance is said."""
    pack = make_pack()
    box = {'BoxSize': [10, 10, 10], 'BoxPeriodic': [1, 1, 1]}
    neighbours, voids = NeighbourStatistics(Input=pack, **box), VoidDistances(Input=pack, Spacing=0.2, **box)
    assert min(estimate(neighbours) + estimate(voids)) > 0.0
    assert estimate(NeighbourStatistics(Input=pack, NumberOfGaps=10000, **box))[1] > 2 * estimate(neighbours)[1]
    assert estimate(VoidDistances(Input=pack, Spacing=0.1, **box))[0] > 4 * estimate(voids)[0]
    said = voids.GetProperty('AutomaticValues').GetData()
    assert said.startswith('Maximum Distance '), said
    taken = fetch(voids).GetFieldData().GetArray('MaximumDistance').GetValue(0)
    assert '%.6g' % taken == '%.6g' % float(said.split()[-1]), (taken, said)
    for bad in ({'ContactTolerance': 0.3}, {'MaximumGap': 0.0}, {'NumberOfGaps': 0}, {'Blocks': 1}):
        assert estimate(NeighbourStatistics(Input=pack, **box, **bad))[0] == 0.0, bad
    for bad in ({'Spacing': -1.0}, {'MaximumDistance': -1.0}, {'NumberOfDistances': 0}, {'Blocks': 1}):
        assert estimate(VoidDistances(Input=pack, **box, **bad))[0] == 0.0, bad


def spheres_told():
    """SpheresInInput is what a spread pack has in all; it asks for no run, neither of this filter nor of those behind it."""
    pack = make_pack()
    source = TwoPointProbability(Input=pack)
    own = estimate(source)[0]
    number = pack.GetDataInformation().GetNumberOfPoints()
    source.SpheresInInput = number
    assert estimate(source)[0] == own, 'the field data say the same'
    source.UpdatePipeline()
    behind = source.SMProxy.GetClientSideObject()
    before = behind.GetMTime()
    source.SpheresInInput = 100 * number
    assert estimate(source)[0] > 10 * own
    assert behind.GetMTime() == before


def from_a_table():
    """The target is a table, with its own lags and given diameters."""
    table = TwoPointProbability(Input=make_pack(), NumberOfLags=30)
    table.UpdatePipeline()
    cell = UnitCellReconstruction(Input=table, NumberOfParticles=50)
    assert estimate(cell) == [0.0, 0.0], 'without diameters'
    cell.ModeDiameters = [1.0, 1.0]
    few = estimate(cell)
    cell.NumberOfParticles = 500
    assert 0.0 < few[0] < estimate(cell)[0] and few[1] > 0.0, (few, estimate(cell))


def nothing_to_go_by():
    """The estimates are 0, without an error, for a pack that was not updated, that has no modes, and for properties out of range."""
    reader = SpherePackReader(FileName=os.path.join(here, '../Gui/pack.csv'))
    for source in (reader, ParticleModes(Input=reader)):
        for filter in filters():
            assert estimate(filter(Input=source))[0] == 0.0, (filter, source)
    reader.UpdatePipeline()
    pack = make_pack()
    for filter in filters():
        assert estimate(filter(Input=reader))[0] == 0.0, 'no modes'
        lags = () if filter is ProbabilityMap else ({'NumberOfLags': 0}, {'NumberOfLags': -5})
        for bad in ({'MaximumLag': -1.0}, {'MaximumLag': float('nan')}, *lags):
            assert estimate(filter(Input=pack, **bad))[0] == 0.0, (filter, bad)
    for bad in ({'Method': 'Chord Sampling', 'TargetError': 0.1}, {'Method': 'Chord Sampling', 'NumberOfLines': -3}):
        for filter in (TwoPointProbability, DirectionalProbability):
            assert estimate(filter(Input=pack, **bad))[0] == 0.0, (filter, bad)
    assert estimate(DirectionalProbability(Input=pack, NumberOfDirections=1))[0] == 0.0
    for bad in ({'TargetError': 0.1}, {'NumberOfLines': -3}):
        assert estimate(ChordLengths(Input=pack, **bad))[0] == 0.0, bad
    for bad in ({'PhasePairs': 'x'}, {'PhasePairs': '1 7'}, {'PhasePairs': ''}, {'Resolution': 0}, {'Spacing': -1.0}):
        assert estimate(ProbabilityMap(Input=pack, **bad))[0] == 0.0, bad
    for bad in ({'Phases': '1 2'}, {'Phases': '1 2 9'}, {'NumberOfThrows': -1}, {'NumberOfDirections': -20}, {'NumberOfDirections': 100000}):
        assert estimate(ThreePointProbability(Input=pack, **bad))[0] == 0.0, bad
    for bad in ({'NumberOfParticles': -1}, {'NumberOfCells': 0}, {'CellSize': -2.0}, {'Method': 'Hybrid', 'HybridPopulation': 1}):
        assert estimate(UnitCellReconstruction(Input=pack, **bad)) == [0.0, 0.0], bad


def shared_by_ranks():
    """The pack of two sources lies on rank 0 or on both; field data or SpheresInInput tell how many there are."""
    pack = make_pack()
    spread = DistributePoints(Input=pack) if RANKS > 1 else pack
    spread.UpdatePipeline()
    whole, parts = [estimate(TwoPointProbability(Input=source, MaximumLag=1.0)) for source in (pack, spread)]
    # Sizes are taken from the spheres of one rank
    assert abs(parts[0] - whole[0]) < 0.5 * whole[0] and abs(parts[1] - whole[1]) < 0.5 * whole[1], (whole, parts)
    assert fetch(TwoPointProbability(Input=spread, MaximumLag=1.0)).GetNumberOfRows() == 278


run((without_a_run, automatic_values, of_third_order, of_properties, of_neighbours, spheres_told, from_a_table, nothing_to_go_by, shared_by_ranks))
