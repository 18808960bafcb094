# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Unit cells as a user asks for them: several, by all methods, from tables in files, with counts and diameters given; and what is refused.

    pvbatch cells.py FOLDER EXPECTED     FOLDER for its files; EXPECTED, a file of numbers: the first run writes it, on one rank, and others
                                         must have the same, compared with ==
"""
import itertools
import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from paraview.simple import *
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet

from harness import NUMBERS, RANKS, columns, expect_error, fetch, field, leaves, remember, run

FOLDER, EXPECTED = sys.argv[1], sys.argv[2]
EDGE, SPHERES = 9.0, 60
GRID = {'MaximumLag': 2.0, 'NumberOfLags': 20}
SMALL = {**GRID, 'NumberOfParticles': SPHERES, 'MaximumIterations': 30}
METHODS = {'Gradient': {}, 'Annealed Population': {'Population': 12, 'MatingPool': 4, 'MaximumGenerations': 6},
           'Hybrid': {'HybridPopulation': 4, 'HybridMatingPool': 2, 'RefinementSteps': 5, 'MaximumGenerations': 4}}
TABLE_ONE = ['Cell', 'Seed', 'BeforeMinimum', 'BeforeMean', 'BeforeMaximum', 'AfterMinimum', 'AfterMean', 'AfterMaximum', 'Iterations',
             'OverlapPercent', 'Objective', 'DifferencePercent', 'EndedBy']


def spheres(data):
    """[(x, y, z, radius, mode)]"""
    radius, mode = data.GetPointData().GetArray('Radius'), data.GetPointData().GetArray('Mode')
    return [(*data.GetPoint(i), radius.GetValue(i), mode.GetValue(i)) for i in range(data.GetNumberOfPoints())]


def counts(data):
    modes = [s[4] for s in spheres(data)]
    return [modes.count(mode) for mode in sorted(set(modes))]


def remember_all(name, source):
    """Every output of a reconstruction."""
    for data in [fetch(source)] + leaves(fetch(source, 3)):
        remember('%s, cell %g%s' % (name, field(data, 'Cell'), ', best' if name + ', best' not in NUMBERS else ''),
                 itertools.chain(*spheres(data)))
    for port in (1, 2, 4, 5):
        remember('%s, output %d' % (name, port), itertools.chain(*columns(source, port).values()))


def overlaps(data):
    """Whether two spheres, or images of them, overlap."""
    edge = field(data, 'BoxSize')[0]
    for a, b in itertools.combinations(spheres(data), 2):
        steps = [a[q] - b[q] - edge * round((a[q] - b[q]) / edge) for q in range(3)]
        if math.hypot(*steps) < a[3] + b[3] - 1e-9:
            return True
    return False


def objective(target, table, end=''):
    """F2 (13), and the percentage of (17)."""
    norm = lambda values: math.sqrt(sum(value * value for value in values[1:]))
    f2 = sums = 0.0
    for name in (name for name in target if name.startswith('S_')):
        weight = 1 if name.split('_')[1] == name.split('_')[2] else 2
        f2 += weight * norm([a - b for a, b in zip(target[name], table[name + end])])
        sums += weight * (norm(target[name]) + norm(table[name + end]))
    return f2, 200.0 * f2 / sums


def make_pack():
    """A jittered periodic lattice of spheres of two sizes."""
    path = os.path.join(FOLDER, 'cells_%d_pack.csv' % RANKS)
    with open(path, 'w') as file:
        file.write('x,y,z,radius\n')
        for n, (x, y, z) in enumerate(itertools.product(range(9), repeat=3)):
            jitter = [0.11 * math.sin(12.9898 * n + 78.233 * q) for q in range(3)]
            file.write('%.17g,%.17g,%.17g,%.17g\n' % (x + jitter[0], y + jitter[1], z + jitter[2], 0.41 if n % 3 else 0.36))
    box = {'BoxOrigin': [-0.5] * 3, 'BoxSize': [EDGE] * 3, 'BoxPeriodic': [1] * 3}
    return ParticleModes(Input=SpherePackReader(FileName=path, LengthUnit='mm', **box), Method='One Per Size')


PACK = make_pack()
TARGET = TwoPointProbability(Input=PACK, **GRID)


def several_cells():
    """Outputs 2 to 5 of three cells by each method, and that cell n is the only cell with seed n."""
    target = columns(TARGET)
    for method, settings in METHODS.items():
        search = UnitCellReconstruction(Input=PACK, Method=method, NumberOfCells=3, Seed=5, **SMALL, **settings)
        cells, table, two = leaves(fetch(search, 3)), columns(search, 4), columns(search, 2)
        assert len(cells) == 3 and [field(cell, 'Cell') for cell in cells] == [1, 2, 3], method
        assert list(table) == TABLE_ONE and table['Cell'] == [1, 2, 3] and table['Seed'] == [5, 6, 7], table
        for n, cell in enumerate(cells):
            assert field(cell, 'Method') == method and field(cell, 'Seed') == 5 + n and field(cell, 'LengthUnit') == 'mm'
            assert len(spheres(cell)) == SPHERES and not overlaps(cell) and field(cell, 'OverlapPercent') == 0.0, method
            assert field(cell, 'Objective') == table['Objective'][n] and field(cell, 'EndedBy') == table['EndedBy'][n]
            alone = UnitCellReconstruction(Input=PACK, Method=method, Seed=5 + n, **SMALL, **settings)
            assert spheres(fetch(alone)) == spheres(cell), (method, n)
            row, own = columns(alone, 4), columns(alone, 2)
            assert [row[name][0] for name in TABLE_ONE[2:]] == [table[name][n] for name in TABLE_ONE[2:]], (method, n)
            f2, percent = objective(target, own, '_cell')
            assert abs(f2 - table['Objective'][n]) < 1e-9 and abs(percent - table['DifferencePercent'][n]) < 1e-9, (method, n, f2)
            before, after = [[table[time + part][n] for part in ('Minimum', 'Mean', 'Maximum')] for time in ('Before', 'After')]
            assert before == sorted(before) and after == sorted(after), (before, after)
            assert (before[0] == before[2]) == (method == 'Gradient') and after[0] < before[1], (method, before, after)
            assert not any(name.endswith(('_mean', '_deviation')) for name in own) and 'StandardDeviation' not in columns(alone, 5)
            if n == 0:
                parts = {name: [] for name in own if name.endswith('_cell')}
            for name in parts:
                parts[name].append(own[name])
        for name, values in parts.items():
            for k, of_cells in enumerate(zip(*values)):
                mean = sum(of_cells) / 3
                deviation = math.sqrt(sum((value - mean)**2 for value in of_cells) / 2)
                assert abs(two[name[:-5] + '_mean'][k] - mean) < 1e-14, (name, k)
                assert abs(two[name[:-5] + '_deviation'][k] - deviation) < 1e-12, (name, k)
        best = min(range(3), key=lambda n: table['Objective'][n])
        assert field(fetch(search), 'Cell') == best + 1 and spheres(fetch(search)) == spheres(cells[best])
        convergence = columns(search, 1)
        misfits = ['GapMisfit', 'NearestMisfit', 'PoreMisfit'] if method == 'Gradient' else []
        assert list(convergence) == ['Iteration', 'Objective', 'OverlapPercent'] + misfits, list(convergence)
        assert convergence['Objective'][-1] == table['Objective'][best]
        rows = columns(search, 5)
        assert list(rows) == ['Quantity', 'Pack', 'Cell', 'Difference', 'LargestDifference', 'Percent', 'StandardDeviation'], list(rows)
        assert rows['Quantity'] == ['c_1', 'c_2', 'c_m', 'S_1_1', 'S_1_2', 'S_1_m', 'S_2_2', 'S_2_m', 'S_m_m', 'all'], rows['Quantity']
        f2, percent = objective(target, two, '_mean')
        assert abs(rows['Percent'][-1] - percent) < 1e-9 and abs(rows['Difference'][-1] - f2) < 1e-9
        assert rows['Percent'][-1] == field(fetch(search, 5), 'DifferencePercent')
        c = [sum(4 / 3 * math.pi * s[3]**3 for s in spheres(cells[0]) if s[4] == mode) / field(cells[0], 'BoxSize')[0]**3 for mode in (1, 2)]
        for i in range(2):
            assert abs(rows['Cell'][i] - c[i]) < 1e-12, rows
            assert abs(rows['Percent'][i] - 100.0 * abs(rows['Pack'][i] - c[i]) / sum(rows['Pack'][:2])) < 1e-9, rows
        remember_all(method, search)
    if RANKS == 1:  # on several ranks the cells come in a set for each rank
        blocks = search.GetClientSideObject().GetOutputDataObject(3)  # Fetch of ParaView 6.1 gives them longer names
        assert [blocks.GetMetaData(n).Get(vtkCompositeDataSet.NAME()) for n in range(3)] == ['Cell 1', 'Cell 2', 'Cell 3']
    try:
        search.Method = 'Simplex'
        raise AssertionError('a method that is none')
    except ValueError:
        pass


def gaps_and_sizes():
    """Surfaces keep the least gap from each other, and a mode of two sizes keeps them."""
    one = ParticleModes(Input=PACK, NumberOfModes=1)
    settings = {**SMALL, 'MinimumGap': 0.02, 'MinimumGapShare': 0.01, 'DiametersPerMode': 2}
    data = fetch(UnitCellReconstruction(Input=one, **settings))
    edge = field(data, 'BoxSize')[0]
    for a, b in itertools.combinations(spheres(data), 2):
        steps = [a[q] - b[q] - edge * round((a[q] - b[q]) / edge) for q in range(3)]
        assert math.hypot(*steps) > 1.01 * (a[3] + b[3]) + 0.02 - 1e-9, (a, b)
    # A third of the pack's spheres are of 0.36, so that the lower half of a cell's is two thirds of them and one of 0.41
    small, large = sorted(set(s[3] for s in spheres(data)))
    means = [((2 * 0.36**3 + 0.41**3) / 3)**(1 / 3), 0.41]
    assert abs(small - means[0]) < 1e-9 and abs(large - means[1]) < 1e-9, (small, large, means)
    remember('gaps and sizes', itertools.chain(*spheres(data)))
    search = UnitCellReconstruction(Input=one, Method='Annealed Population', **{**SMALL, 'MinimumGap': 0.02})
    expect_error(search, ['MinimumGap', 'Method is not Gradient', '0.02'])


def write_table(name, table):
    path = os.path.join(FOLDER, 'cells_%d_%s.csv' % (RANKS, name))
    with open(path, 'w') as file:
        file.write(','.join(table) + '\n')
        file.writelines(','.join('%.17g' % value for value in row) + '\n' for row in zip(*table.values()))
    return CSVReader(FileName=[path])


def targets_from_files():
    """S_rs written by ParaView and read again gives the cell of the table itself, and that of the pack but for rounding of its edge."""
    diameters = columns(PACK, 1)['VolumeMeanDiameter']
    few = {'NumberOfParticles': SPHERES, 'MaximumIterations': 10, 'NumberOfCells': 2}
    of_pack = UnitCellReconstruction(Input=PACK, ContactWeight=0, PoreWeight=0, **GRID, **few)  # a table tells no neighbours
    of_table = UnitCellReconstruction(Input=TARGET, ModeDiameters=diameters, **few)
    path = os.path.join(FOLDER, 'cells_%d_saved.csv' % RANKS)
    SaveData(path, proxy=TARGET, Precision=17, UseScientificNotation=1)
    of_file = UnitCellReconstruction(Input=CSVReader(FileName=[path]), ModeDiameters=diameters, **few)
    # With 17 digits every bit of all outputs is the same. The lags of a file are its own, whatever MaximumLag and NumberOfLags are
    assert spheres(fetch(of_file)) == spheres(fetch(of_table))
    for port in (1, 2, 4, 5):
        assert columns(of_file, port) == columns(of_table, port), port
    assert columns(of_file, 2)['r'] == columns(TARGET)['r'] and field(fetch(of_file), 'NumberOfLags') == 20
    remember_all('file', of_file)
    # The fractions of a table are S_rr(0), sums over pairs, and those of a pack are volumes of spheres: the edge is rounded differently
    pack, table = fetch(of_pack), fetch(of_table)
    edges = [field(data, 'BoxSize')[0] for data in (pack, table)]
    assert counts(pack) == counts(table) and abs(edges[0] / edges[1] - 1.0) < 1e-9, edges
    for a, b in zip(spheres(pack), spheres(table)):
        # Ten iterations let the rounding grow
        assert abs(a[3] - b[3]) < 1e-12 and a[4] == b[4] and math.dist(a[:3], b[:3]) < 1e-4, (a, b)
    f2 = [columns(search, 4)['Objective'] for search in (of_pack, of_table)]
    assert max(abs(a / b - 1.0) for a, b in zip(*f2)) < 1e-4, f2
    # With five digits, as ParaView writes them, and with six, F2 is known to the root of the lags times the digits. These round the lags too
    uneven = TwoPointProbability(Input=PACK, MaximumLag=2.0, NumberOfLags=23)
    of_uneven = UnitCellReconstruction(Input=uneven, ModeDiameters=diameters, **few)
    for name, source, exact, digits in (('five', uneven, of_uneven, {}), ('six', uneven, of_uneven, {'Precision': 6}),
                                        ('even', TARGET, of_table, {'Precision': 6})):
        path = os.path.join(FOLDER, 'cells_%d_%s.csv' % (RANKS, name))
        SaveData(path, proxy=source, **digits)
        reader = CSVReader(FileName=[path])
        rounded = UnitCellReconstruction(Input=reader, ModeDiameters=diameters, **few)
        found, expected = columns(rounded, 4)['Objective'], columns(exact, 4)['Objective']
        assert max(abs(a - b) for a, b in zip(found, expected)) < 0.1 * expected[0], (name, found, expected)
        # The norm of a difference is at most the root of the lags times half a unit of the last digit
        difference = columns(CompareProbabilities(Input=reader, Cell=source))['Difference']
        assert 0.0 < max(difference) < 1e-3, (name, difference)
    # Columns may come in any order, and with S_2_1 for S_1_2
    other = {name: values for name, values in reversed(columns(TARGET).items()) if name != 'S_1_2'}
    other['S_2_1'] = columns(TARGET)['S_1_2']
    swapped = UnitCellReconstruction(Input=write_table('swapped', other), ModeDiameters=diameters, **few)
    assert spheres(fetch(swapped)) == spheres(fetch(of_table))


def contents():
    """Counts and diameters of the modes as given, from a pack and from a table."""
    diameters = columns(PACK, 1)['VolumeMeanDiameter']
    fractions = [columns(TARGET)['S_%s_%s' % (mode, mode)][0] for mode in '12']
    for settings in ({'Input': PACK, **GRID}, {'Input': TARGET, 'ModeDiameters': diameters},
                     {'Input': PACK, 'ModeDiameters': [0.7, 0.9], **GRID}):
        search = UnitCellReconstruction(ModeCounts=[17, 40], MaximumIterations=0, **settings)
        assert counts(fetch(search)) == [17, 40], counts(fetch(search))
        radii = [0.5 * d for d in settings.get('ModeDiameters', diameters)]
        assert all(abs(s[3] - radii[s[4] - 1]) < 1e-12 for s in spheres(fetch(search)))
        # Equation (12)
        volumes = [n * r**3 for n, r in zip((17, 40), radii)]
        edge = (4 / 3 * math.pi * sum(v * v for v in volumes) / sum(c * v for c, v in zip(fractions, volumes)))**(1 / 3)
        assert abs(field(fetch(search), 'BoxSize')[0] / edge - 1.0) < 1e-7, (field(fetch(search), 'BoxSize'), edge)
    # The edge gives the nearest whole numbers
    search = UnitCellReconstruction(Input=TARGET, ModeDiameters=diameters, CellSize=4.0, MaximumIterations=0)
    expected = [round(64.0 * c / (math.pi / 6 * d**3)) for c, d in zip(fractions, diameters)]
    assert counts(fetch(search)) == expected, (counts(fetch(search)), expected)


def refused_settings():
    """What cannot be is refused with its reason; mended, the filter gives its former result."""
    population = METHODS['Annealed Population']
    search = UnitCellReconstruction(Input=PACK, Method='Annealed Population', **SMALL, **population)
    expected = spheres(fetch(search))
    for bad, parts in (({'Population': 0}, ['Population requires Population >= 2, got 0']),
                       ({'Population': 1}, ['Population requires Population >= 2, got 1']),
                       ({'MatingPool': 13}, ['MatingPool requires 1 <= MatingPool <= Population (12), got 13']),
                       ({'MatingPool': 0}, ['MatingPool requires', 'got 0']),
                       ({'NumberOfCells': 0}, ['NumberOfCells requires 1 <= NumberOfCells <= 10000, got 0']),
                       ({'NumberOfCells': -3}, ['NumberOfCells requires', 'got -3']),
                       ({'NumberOfCells': 10001}, ['NumberOfCells requires', 'got 10001']),
                       ({'CheckpointInterval': -1.0}, ['CheckpointInterval requires CheckpointInterval >= 0, got -1']),
                       ({'MaximumGenerations': -1}, ['MaximumGenerations requires', 'got -1']),
                       ({'RandomShare': 1.5}, ['RandomShare requires', 'got 1.5']),
                       ({'DepositionDegree': -0.1}, ['DepositionDegree requires', 'got -0.1']),
                       ({'InitialTemperature': 0.0}, ['InitialTemperature requires', 'got 0']),
                       ({'SelectionPressure': 2.5}, ['SelectionPressure requires', 'got 2.5']),
                       ({'OperatorWeights': [0.0] * 8}, ['OperatorWeights requires a sum > 0']),
                       ({'OperatorWeights': [1.0] * 7}, ['OperatorWeights requires 8 numbers, got 7']),
                       ({'OperatorWeights': [1.0] * 30}, ['OperatorWeights requires 8 numbers, got 30']),
                       ({'OperatorWeights': [-1.0] + [1.0] * 7}, ['OperatorWeights requires', 'got -1']),
                       ({'ModeCounts': [20, 40]}, ['NumberOfParticles requires 0 when ModeCounts are set, got 60']),
                       ({'NumberOfParticles': 0, 'ModeCounts': [20, 40], 'CellSize': 4.0}, ['CellSize requires 0 when ModeCounts are set']),
                       ({'NumberOfParticles': 0, 'ModeCounts': [20, 0]}, ['ModeCounts requires numbers >= 1, got 0 for mode 2']),
                       ({'NumberOfParticles': 0, 'ModeCounts': [20]}, ['ModeCounts requires a number for each of the 2 modes, got 1']),
                       ({'ModeDiameters': [0.7]}, ['ModeDiameters requires a diameter for each of the 2 modes, got 1'])):
        former = {name: list(value) if hasattr(value := search.GetPropertyValue(name), '__len__') else value for name in bad}
        for name, value in bad.items():
            setattr(search, name, value)
        expect_error(search, parts)
        for name, value in former.items():
            setattr(search, name, value)
        assert spheres(fetch(search)) == expected, bad
    hybrid = UnitCellReconstruction(Input=PACK, Method='Hybrid', **SMALL, **METHODS['Hybrid'])
    expected = spheres(fetch(hybrid))
    for bad, former, parts in (({'HybridPopulation': 1}, {'HybridPopulation': 4}, ['HybridPopulation requires HybridPopulation >= 2, got 1']),
                               ({'HybridMatingPool': 5}, {'HybridMatingPool': 2}, ['HybridMatingPool requires', 'HybridPopulation (4), got 5']),
                               ({'HybridMatingPool': 0}, {'HybridMatingPool': 2}, ['HybridMatingPool requires', 'got 0']),
                               ({'HybridMutationReach': 1.5}, {'HybridMutationReach': 0.1}, ['HybridMutationReach requires', 'got 1.5']),
                               ({'RefinementSteps': 0}, {'RefinementSteps': 5}, ['RefinementSteps requires RefinementSteps >= 1, got 0']),
                               ({'Population': 1}, {'Population': 512}, None)):  # not a setting of Hybrid
        for name, value in bad.items():
            setattr(hybrid, name, value)
        if parts:
            expect_error(hybrid, parts)
        for name, value in (former if parts else {}).items():
            setattr(hybrid, name, value)
        assert spheres(fetch(hybrid)) == expected, bad


def refused_targets():
    """Tables that are no S_rs, and diameters that do not go with them."""
    diameters, table = columns(PACK, 1)['VolumeMeanDiameter'], columns(TARGET)

    def changed(name, **values):
        """A file with one value changed in some columns, given by its row and what it becomes."""
        other = {column: list(numbers) for column, numbers in table.items()}
        for column, (row, value) in values.items():
            other[column][row] = value(other[column][row])
        return write_table(name, other)

    for name, source, parts in (
            ('missing', write_table('missing', {c: v for c, v in table.items() if c != 'S_1_m'}), ["got none 'S_1_m'"]),
            ('no lags', write_table('no_lags', {c: v for c, v in table.items() if c != 'r'}), ["got none 'r'"]),
            ('no pairs', write_table('no_pairs', {'r': table['r']}), ['Input requires the columns S_1_1']),
            ('nan', changed('nan', S_2_2=(4, lambda x: math.nan)), ['finite numbers', 'S_2_2, row 4']),
            ('infinite', changed('infinite', S_2_2=(4, lambda x: math.inf)), ['S_2_2']),
            ('lags', changed('lags', r=(7, lambda x: 1.1 * x)), ['requires lags 0, dr, 2 dr', 'in row 7']),
            ('first lag', changed('first_lag', r=(0, lambda x: 0.05)), ['requires lags 0, dr, 2 dr', 'in row 0']),
            ('above 1', changed('above', S_1_2=(4, lambda x: 1.2)), ['requires probabilities from 0 to 1, got 1.2 for S_1_2 at r = 0.4']),
            ('below 0', changed('below', S_1_2=(4, lambda x: -0.3)), ['requires probabilities from 0 to 1, got -0.3 for S_1_2 at r = 0.4']),
            ('sums', changed('sums', S_1_2=(4, lambda x: x + 0.02)), ['add up to the fraction of phase 1', 'at r = 0.4']),
            ('fraction', changed('fraction', S_1_1=(0, lambda x: 1.5 * x)), ['add up to the fraction of phase 1']),
            ('one row', write_table('one_row', {c: v[:1] for c, v in table.items()}), ['Input requires at least two rows'])):
        expect_error(UnitCellReconstruction(Input=source, ModeDiameters=diameters, NumberOfParticles=SPHERES), parts)
    for bad, parts in (({}, ['ModeDiameters requires a diameter for each of the 2 modes, got 0']),
                       ({'ModeDiameters': diameters[:1]}, ['ModeDiameters requires a diameter for each of the 2 modes, got 1']),
                       ({'ModeDiameters': diameters + [1.0]}, ['ModeDiameters requires a diameter for each of the 2 modes, got 3']),
                       ({'ModeDiameters': [0.7, 0.0]}, ['ModeDiameters requires finite numbers > 0, got 0 for mode 2']),
                       ({'ModeDiameters': [-0.7, 0.8]}, ['ModeDiameters requires finite numbers > 0, got -0.7 for mode 1']),
                       ({'ModeDiameters': [math.nan, 0.8]}, ['ModeDiameters requires finite numbers > 0, got nan for mode 1'])):
        expect_error(UnitCellReconstruction(Input=TARGET, NumberOfParticles=SPHERES, **bad), parts)


if __name__ == '__main__':
    run((several_cells, gaps_and_sizes, targets_from_files, contents, refused_settings, refused_targets), EXPECTED)
