# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Three-point probabilities and comparisons as a user asks for them: properties, outputs, windows and masks, all triples, errors.

    pvbatch three_point.py FOLDER EXPECTED     FOLDER for its files; with EXPECTED, a file of numbers, they must be the same: the first run
                                               writes it, on one rank, and others compare with ==
"""
import itertools
import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from paraview.simple import *

from harness import RANKS, columns, expect_error, fetch, field, remember, run

FOLDER, EXPECTED = sys.argv[1], sys.argv[2]
EDGE, LAG, LAGS, RAYS, THROWS = 9.0, 2.0, 10, 8, 2000
GRID = {'MaximumLag': LAG, 'NumberOfLags': LAGS}
FEW = {**GRID, 'NumberOfDirections': RAYS, 'NumberOfThrows': THROWS}


def points(source, port=0):
    """{(i, j, k): {array: value}} of an image, whole on any number of ranks."""
    source.UpdatePipeline()
    info, result = source.GetDataInformation(port), {}
    spacing = [(info.GetBounds()[2 * q + 1] - info.GetBounds()[2 * q]) / info.GetExtent()[2 * q + 1] for q in range(3)]
    cloud = fetch(ConvertToPointCloud(Input=OutputPort(source, port)))
    arrays = [cloud.GetPointData().GetArray(i) for i in range(cloud.GetPointData().GetNumberOfArrays())]
    for n in range(cloud.GetNumberOfPoints()):
        place = tuple(round(x / step) for x, step in zip(cloud.GetPoint(n), spacing))
        values = {array.GetName(): array.GetValue(n) for array in arrays}
        assert result.setdefault(place, values) == values, place  # points on the border of two slabs
    return result


def write_pack(name, radius, count=9, shift=0.0):
    """A jittered lattice of spheres, centres in [-0.5, 8.5]."""
    path = os.path.join(FOLDER, 'three_point_%d_%s.csv' % (RANKS, name))
    with open(path, 'w') as file:
        file.write('x,y,z,radius\n')
        for n, (x, y, z) in enumerate(itertools.product(range(count), repeat=3)):
            jitter = [0.11 * math.sin(12.9898 * n + 78.233 * q + shift) for q in range(3)]
            file.write('%.17g,%.17g,%.17g,%.17g\n' % (x + jitter[0], y + jitter[1], z + jitter[2], radius + 0.05 * (n % 2)))
    return path


def make_pack(name, radius=0.36, periodic=0, shift=0.0):
    box = {'BoxOrigin': [-0.5] * 3, 'BoxSize': [EDGE] * 3, 'BoxPeriodic': [periodic] * 3}
    return ParticleModes(Input=SpherePackReader(FileName=write_pack(name, radius, shift=shift), LengthUnit='mm', **box),
                         Method='One Per Size')


def properties_and_outputs():
    """Names, types, field data and spacing, and the outputs with and without standard errors."""
    pack = make_pack('periodic', periodic=1)
    source = ThreePointProbability(Input=pack)
    defaults = {'Phases': 'm m m', 'MaximumLag': 0.0, 'NumberOfLags': 277, 'NumberOfDirections': 40, 'NumberOfThrows': 50000,
                'StandardErrors': 0, 'MemoryLimit': 4000.0, 'Seed': 1, 'WindowMargin': -1.0}
    assert {name: getattr(source, name) for name in defaults} == defaults
    for name, value in {**FEW, 'Phases': '1 2 2; m 1 2; m m m', 'StandardErrors': 1, 'Seed': 7}.items():
        setattr(source, name, value)
    image, info = fetch(source), source.GetDataInformation(0)
    assert image.GetClassName() == 'vtkImageData' and info.GetExtent() == (0, LAGS, 0, LAGS, 0, RAYS // 2), info.GetExtent()
    assert max(abs(a - b) for a, b in zip(info.GetBounds(), (0, LAG, 0, LAG, 0, 180))) < 1e-12, info.GetBounds()
    arrays = [image.GetPointData().GetArrayName(i) for i in range(image.GetPointData().GetNumberOfArrays())]
    assert arrays == ['S_1_2_2', 'S_1_2_2_error', 'S_m_1_2', 'S_m_1_2_error', 'S_m_m_m', 'S_m_m_m_error'], arrays
    for port in range(5):
        data = fetch(source, port)
        expected = {'Method': 'Fan Sampling', 'LimitMethod': 'Exact Pair Sum', 'Phases': '1 2 2; m 1 2; m m m', 'NumberOfLags': LAGS,
                    'MaximumLag': LAG, 'NumberOfDirections': RAYS, 'NumberOfThrows': THROWS, 'Seed': 7, 'LengthUnit': 'mm', 'Mask': 0,
                    'NumberOfSpheres': 729, 'WindowMargin': 0.0, 'SampledVolume': EDGE**3}
        for name, value in expected.items():
            assert field(data, name) == value, (port, name, field(data, name))
    limits, checks, third = (columns(source, port) for port in (1, 2, 3))
    places = ('r1_axis', 'r2_axis', 'diagonal')
    assert list(limits) == ['r'] + ['%s_%s%s' % (triple, place, end) for triple in ('S_1_2_2', 'S_m_1_2', 'S_m_m_m') for place in places
                                    for end in ('', '_limit', '_error')], list(limits)
    assert [abs(r - LAG * k / LAGS) < 1e-12 for k, r in enumerate(limits['r'])] == [True] * (LAGS + 1)
    assert list(checks) == ['Triple', 'Place', 'Limit', 'Difference', 'StandardError'] and len(checks['Triple']) == 12
    assert checks['Limit'][:4] == ['0', '0', 'S_1_2', 'c_1 c_2 c_2'], checks['Limit']
    assert list(third) == ['Phase', 'VolumeFraction', 'zeta', 'eta', 'zeta_error', 'eta_error'] and third['Phase'] == ['m', 'all but m']
    assert 0.0 < third['zeta_error'][0] < 10.0 and abs(sum(third['zeta']) - 1.0) < 1e-12, third

    # The limits are those of the exact pair sum, within 5 standard errors of the norm over lags that go together
    two = columns(TwoPointProbability(Input=pack, **GRID))
    assert limits['S_1_2_2_diagonal_limit'] == two['S_1_2'] and limits['S_m_m_m_r1_axis_limit'] == two['S_m_m']
    for name, place, difference, error in zip(*(checks[column] for column in ('Triple', 'Place', 'Difference', 'StandardError'))):
        assert difference <= 5.0 * error + 1e-15, (name, place, difference, error)
    values = points(source)
    assert len(values) == (LAGS + 1)**2 * (RAYS // 2 + 1)
    assert all(values[i, j, t]['S_1_2_2'] == values[j, i, t]['S_1_2_2'] for i, j, t in values)
    assert [values[k, k, 0]['S_1_2_2'] for k in range(LAGS + 1)] == limits['S_1_2_2_diagonal']
    for port, table in ((1, limits), (2, checks), (3, third)):
        remember('periodic %d' % port, itertools.chain(*table.values()))
    remember('periodic image', (x for place in sorted(values) for x in values[place].values()))

    # Without errors the values are the same, there are no errors, and memory is half; another seed gives other values
    with_errors = field(fetch(source), 'EstimatedMemory')
    source.StandardErrors = 0
    without, memory = points(source), field(fetch(source), 'EstimatedMemory')
    assert list(without[0, 0, 0]) == ['S_1_2_2', 'S_m_1_2', 'S_m_m_m'] and 0.0 < memory < 0.5 * with_errors < 1.0
    assert all(without[place][name] == values[place][name] for place in values for name in without[place])
    source.Seed = 8
    assert points(source) != without
    # S_rqs is S_rsq with r1 and r2 swapped
    source.Seed, source.Phases = 7, 'm 2 1'
    swapped = points(source)
    assert all(swapped[j, i, t]['S_m_2_1'] == values[i, j, t]['S_m_1_2'] for i, j, t in values)
    assert fetch(source, 3).GetNumberOfRows() == 0  # there is no triple of one phase
    # Two classes, of the modes of the smaller and of the larger spheres
    assert columns(source, 4) == {'Note': ['Multipoles is off']}
    source.Multipoles, source.MultipoleClasses, source.MultipoleDegree, source.MultipoleDistances = 1, 2, 1, [0.3, 0.6, 0.9]
    multipoles = columns(source, 4)
    assert list(multipoles) == ['r', 's', 'q', 'l', 'Distance1', 'Distance2', 'T', 'T_error'], list(multipoles)
    assert len(multipoles['T']) == 2 * 3 * 2 * 9 and list(zip(*(multipoles[c] for c in 'rsql')))[17::18] == [
        (r, s, q, 1) for r in (1, 2) for s, q in ((1, 1), (1, 2), (2, 2))]
    assert sorted(field(fetch(source, 4), 'ClassOfMode')) == [1, 2] and all(error > 0.0 for error in multipoles['T_error'])
    remember('multipoles', multipoles['T'] + multipoles['T_error'])
    source.SMProxy.UpdatePropertyInformation()
    estimate = source.GetProperty('EstimatedMemory').GetData()
    assert abs(estimate - field(fetch(source), 'EstimatedMemory')) <= 0.5 * estimate, estimate


def all_triples():
    """Every triple, with few lags: their number is right, they add up to S_rs, and they are refused where they take too much."""
    pack = make_pack('all', periodic=1)
    source = ThreePointProbability(Input=pack, Phases='all', **FEW)
    values, phases = points(source), ['1', '2', 'm']
    number = len(phases)
    assert len(values[0, 0, 0]) == number**2 * (number + 1) // 2 == 18, len(values[0, 0, 0])

    def at(place, r, s, q):
        i, j, t = place
        return values[place]['S_%s_%s_%s' % (r, s, q)] if phases.index(s) <= phases.index(q) else values[j, i, t]['S_%s_%s_%s' % (r, q, s)]

    for r, s in itertools.product(phases, phases):
        # The sum over q does not know r2 and theta: by the same throws for all, but other rays; S_rs(r1) on the r2 axis (0 lags) is one
        for i in range(LAGS + 1):
            sums = {t: [sum(at((i, j, t), r, s, q) for q in phases) for j in range(LAGS + 1)] for t in range(RAYS // 2 + 1)}
            for t, row in sums.items():
                assert max(row) - min(row) < 1e-12, (r, s, i, t, row)
            assert max(abs(row[0] - sums[0][0]) for row in sums.values()) < 1e-12, (r, s, i)
    # And it is S_rs: there are no chords of the same throws, so the limit is 5 standard errors of the exact sum
    two, errors = columns(TwoPointProbability(Input=pack, **GRID)), columns(ThreePointProbability(Input=pack, Phases='1 1 1; m m m',
                                                                                                 StandardErrors=1, **FEW), 1)
    for r in ('1', 'm'):
        own = [sum(at((k, 0, 0), r, r, q) for q in phases) for k in range(LAGS + 1)]
        scatter = math.sqrt(sum(e * e for e in errors['S_%s_%s_%s_diagonal_error' % (r, r, r)][1:]))
        difference = math.sqrt(sum((a - b)**2 for a, b in zip(own[1:], two['S_%s_%s' % (r, r)][1:])))
        assert difference <= 5.0 * scatter, (r, difference, scatter)
    assert abs(sum(at((3, 5, 2), r, s, q) for r, s, q in itertools.product(phases, repeat=3)) - 1.0) < 1e-12
    # 278 x 278 x 11 numbers of 12 bytes and the image of 8, for 18 triples
    source.NumberOfLags, source.NumberOfDirections, source.MemoryLimit = 277, 20, 200.0
    need = 278**2 * 11 * 18 * (12 + 8 / RANKS) / 1e6
    expect_error(source, ['MemoryLimit requires at least %d MB on every rank for 18 triples' % math.ceil(need), '277 lags and 11 angles',
                          'got 200'])
    source.NumberOfLags, source.NumberOfDirections = LAGS, RAYS
    assert points(source) == values


def windows():
    """A box and a cylinder window, a mask that is a box, and overlapping spheres."""
    beads = make_pack('block')
    settings = {**FEW, 'Phases': '1 2 m; m m m', 'StandardErrors': 1}
    block = ThreePointProbability(Input=beads, **settings)
    assert abs(field(fetch(block, 1), 'SampledVolume') - (EDGE - 0.82)**3) < 1e-9 and field(fetch(block, 1), 'WindowMargin') == 0.41
    plain = ParticleModes(Input=SpherePackReader(FileName=write_pack('plain', 0.36)), Method='One Per Size')
    cylinder = ThreePointProbability(Input=plain, CylinderBase=[4, 4, 0.5], CylinderRadius=4, CylinderHeight=7, CropToWindow=1, **settings)
    data = fetch(cylinder, 1)
    assert abs(field(data, 'SampledVolume') / (math.pi * 3.59**2 * 6.18) - 1.0) < 1e-12, field(data, 'SampledVolume')
    for name, source in (('block', block), ('cylinder', cylinder)):
        remember(name, itertools.chain(*columns(source, 1).values()))
        values = points(source)
        assert all(0.0 <= value <= 1.0 for at in values.values() for value in at.values()), name
    # Both hold the same lattice: matrix fractions and parameters agree within 5 standard errors
    a, b = (points(source)[0, 0, 0] for source in (block, cylinder))
    assert abs(a['S_m_m_m'] - b['S_m_m_m']) <= 5.0 * math.hypot(a['S_m_m_m_error'], b['S_m_m_m_error']), (a, b)

    # The cells of images 1…7 hold 6 x 6 x 6; the points of a mask are centres of voxels, so these are boxes from 0.5 to 7.5. The image is
    # larger than the lags are many, and begins elsewhere
    box = {'BoxOrigin': [0.5] * 3, 'BoxSize': [7.0] * 3, 'CropToWindow': 1}
    inside = ' & '.join('(coords%s > 0.5) & (coords%s < 7.5)' % (axis, axis) for axis in 'XYZ')
    expected = ThreePointProbability(Input=plain, WindowMargin=1, **box, **settings)
    reference = points(expected)
    for extent, function in (([1, 7] * 3, '1'), ([-12, 15] * 3, 'if (%s, 1, 0)' % inside)):
        mask = Calculator(Input=Wavelet(WholeExtent=extent), Function=function, ResultArrayName='Inside')
        # Centres outside the mask are known too; the box run crops them. A margin of 1 keeps them out
        source = ThreePointProbability(Input=plain, Mask=mask, MaskArray='Inside', WindowMargin=1, **settings)
        assert field(fetch(source, 1), 'Mask') == 1 and field(fetch(source, 1), 'LimitMethod') == 'Chord Sampling'
        assert field(fetch(source, 1), 'SampledVolume') == 125.0, field(fetch(source, 1), 'SampledVolume')
        masked = points(source)
        worst = max(abs(masked[place][name] - reference[place][name]) for place in reference for name in reference[place])
        assert len(masked) == len(reference) and worst < 0.02, worst
        remember('mask %d' % extent[0], itertools.chain(*columns(source, 1).values()))

    # Overlapping spheres count once: the phases of every point add up to 1, and the limits are those by chords
    overlapping = make_pack('overlapping', radius=0.55, periodic=1)
    source = ThreePointProbability(Input=overlapping, Phases='m m m; 1 1 1; 2 2 2', StandardErrors=1, **FEW)
    assert field(fetch(source), 'LimitMethod') == 'Chord Sampling' and field(fetch(source), 'OverlapPercent') > 1.0
    at = points(source)[0, 0, 0]
    assert abs(sum(at['S_%s_%s_%s' % (p, p, p)] for p in '12m') - 1.0) < 1e-12, at
    checks = columns(source, 2)
    for name, place, difference, error in zip(*(checks[column] for column in ('Triple', 'Place', 'Difference', 'StandardError'))):
        assert difference <= 6.0 * error + 1e-15, (name, place, difference, error)  # chords have an error of their own
    remember('overlapping', itertools.chain(*columns(source, 1).values()))


def errors_of_three_point():
    """What cannot be is refused with its reason; mended, the filter gives its former result."""
    pack = make_pack('refused')
    source = ThreePointProbability(Input=pack, **FEW)
    expected = columns(source, 1)
    window = {'MaximumLag': 4.2}  # of 8.18 without margins, for two opposite rays
    for bad, parts in (({'Phases': '1 2 3'}, ['Phases requires triples of phases, 1 to 2 or m', "got '1 2 3'"]),
                       ({'Phases': '1 x m'}, ['Phases requires', "got '1 x m'"]),
                       ({'Phases': 'm m'}, ['Phases requires', "got 'm m'"]),
                       ({'Phases': 'm m m m'}, ['Phases requires', "got 'm m m m'"]),
                       ({'Phases': ''}, ['Phases requires at least one triple', 'got none']),
                       ({'Phases': 'm m m; all'}, ['Phases requires', "got ' all'"]),
                       (window, ['MaximumLag requires 0 < MaximumLag <= 4.0', 'got 4.2']),
                       ({'NumberOfDirections': 1}, ['NumberOfDirections requires a number from 2 to 512', 'got 1']),
                       ({'NumberOfDirections': -4}, ['NumberOfDirections requires a number from 2 to 512', 'got -4']),
                       ({'NumberOfThrows': 0}, ['NumberOfThrows requires', 'got 0']),
                       ({'NumberOfLags': 0}, ['NumberOfLags requires', 'got 0']),
                       ({'Seed': -2}, ['Seed requires a number >= 0, got -2']),
                       ({'WindowMargin': 5.0}, ['margin of 5']),
                       ({'MemoryLimit': 0.001}, ['MemoryLimit requires at least 1 MB', 'got 0.001'])):
        former = {name: source.GetPropertyValue(name) for name in bad}
        for name, value in bad.items():
            setattr(source, name, value)
        expect_error(source, ['Three-Point Probability: '] + parts)
        for name, value in former.items():
            setattr(source, name, value)
        assert columns(source, 1) == expected, bad
    mask = Calculator(Input=Wavelet(WholeExtent=[0, 8] * 3), Function='1', ResultArrayName='Inside')
    expect_error(ThreePointProbability(Input=make_pack('masked', periodic=1), Mask=mask, **FEW),
                 ['Mask requires a pack that is not periodic'])


def comparisons():
    """Tables of one and of several cells, images, and what does not go together."""
    packs = [make_pack('compared_%d' % n, periodic=1, radius=0.3 + 0.01 * n, shift=0.5 * n) for n in range(4)]
    two = [TwoPointProbability(Input=pack, **GRID) for pack in packs]
    tables = [columns(source) for source in two]
    names = [name for name in tables[0] if name != 'r']
    norm = lambda values: math.sqrt(sum(value * value for value in values[1:]))
    for cells in (two[1:2], two[1:]):
        source = CompareProbabilities(Input=two[0], Cell=cells)
        rows, curves, several = columns(source), columns(source, 1), len(cells) > 1
        assert list(rows) == ['Quantity', 'Pack', 'Cell', 'Difference', 'LargestDifference', 'Percent'] + several * ['StandardDeviation']
        assert rows['Quantity'] == ['c_1', 'c_2', 'c_m'] + names + ['all'], rows['Quantity']
        assert field(fetch(source), 'NumberOfCells') == len(cells)
        assert field(fetch(source), 'DifferencePercent') == rows['Percent'][-1]
        sums = [0.0] * 3
        for name in names:
            of_cells = [columns(cell)[name] for cell in cells]
            mean = [sum(values) / len(cells) for values in zip(*of_cells)]
            difference = [a - b for a, b in zip(tables[0][name], mean)]
            for end, values in (('_pack', tables[0][name]), ('_cell', mean), ('_difference', difference)):
                assert max(abs(a - b) for a, b in zip(curves[name + end], values)) < 1e-15, (name, end)
            i, norms = rows['Quantity'].index(name), [norm(values) for values in (tables[0][name], mean, difference)]
            for column, value in zip(('Pack', 'Cell', 'Difference'), norms):
                assert abs(rows[column][i] - value) < 1e-12, (name, column)
            assert abs(rows['LargestDifference'][i] - max(map(abs, difference))) < 1e-15, name
            assert abs(rows['Percent'][i] - 200.0 * norms[2] / (norms[0] + norms[1])) < 1e-9, name
            weight = 1 if name in ('S_1_1', 'S_2_2', 'S_m_m') else 2
            sums = [a + weight * b for a, b in zip(sums, norms)]
            if several:
                deviation = [math.sqrt(sum((a - m)**2 for a in values) / (len(cells) - 1)) for values, m in zip(zip(*of_cells), mean)]
                assert max(abs(a - b) for a, b in zip(curves[name + '_deviation'], deviation)) < 1e-12, name
                assert abs(rows['StandardDeviation'][i] - norm(deviation)) < 1e-12, name
        assert abs(rows['Percent'][-1] - 200.0 * sums[2] / (sums[0] + sums[1])) < 1e-9, rows
        c = [[table['S_%s_%s' % (p, p)][0] for p in '12'] for table in (tables[0], {n: [sum(v) / len(cells) for v in zip(
            *(columns(cell)[n] for cell in cells))] for n in names})]
        for i in range(2):
            assert abs(rows['Percent'][i] - 100.0 * abs(c[0][i] - c[1][i]) / sum(c[0])) < 1e-9, rows
        assert fetch(source, 2).GetNumberOfPoints() == 0
        remember('compared tables %d' % len(cells), itertools.chain(*rows.values(), *curves.values()))

    # The table comes from a file, and from one without some columns
    path = os.path.join(FOLDER, 'three_point_%d_table.csv' % RANKS)
    def write(leave_out):
        with open(path, 'w') as file:
            kept = [name for name in tables[1] if name not in leave_out]
            file.write(','.join(kept) + '\n')
            file.writelines(','.join('%.17g' % value for value in row) + '\n' for row in zip(*(tables[1][name] for name in kept)))
        return CSVReader(FileName=[path])
    expected = columns(CompareProbabilities(Input=two[0], Cell=[two[1]]))
    assert columns(CompareProbabilities(Input=two[0], Cell=[write([])])) == expected
    expect_error(CompareProbabilities(Input=two[0], Cell=[write(['S_1_m'])]), ['Cell requires the columns r, S_1_1', "got none 'S_1_m'"])
    expect_error(CompareProbabilities(Input=write(['r']), Cell=[two[0]]), ['Input requires the columns r', "got none 'r'"])
    other = TwoPointProbability(Input=packs[1], MaximumLag=LAG, NumberOfLags=LAGS + 2)
    expect_error(CompareProbabilities(Input=two[0], Cell=[other]), ['Cell requires the lags of the input, 10 steps to 2, got 12 to 2'])

    # Images
    three = [ThreePointProbability(Input=pack, Phases='1 2 2; m m m', StandardErrors=1, **FEW) for pack in packs[:2]]
    source = CompareProbabilities(Input=three[0], Cell=[three[1]])
    pack, cell, difference = points(three[0]), points(three[1]), points(source, 2)
    assert set(pack) == set(difference) and list(difference[0, 0, 0]) == list(pack[0, 0, 0])
    rows = columns(source)
    assert rows['Quantity'] == ['S_1_2_2', 'S_m_m_m', 'all'], rows['Quantity']
    for place, name in itertools.product(pack, ('S_1_2_2', 'S_m_m_m')):
        assert difference[place][name] == abs(pack[place][name] - cell[place][name]), (place, name)
        both = math.hypot(pack[place][name + '_error'], cell[place][name + '_error'])
        assert abs(difference[place][name + '_error'] - both) < 1e-15, (place, name)
    for i, name in enumerate(rows['Quantity'][:2]):
        norms = [math.sqrt(sum(at[name]**2 for at in image.values())) for image in (pack, cell, difference)]
        for column, value in zip(('Pack', 'Cell', 'Difference'), norms):
            assert abs(rows[column][i] / value - 1.0) < 1e-6, (name, column)
        assert rows['LargestDifference'][i] == max(at[name] for at in difference.values()) > 0.0
        assert abs(rows['Percent'][i] / (200.0 * norms[2] / (norms[0] + norms[1])) - 1.0) < 1e-6, name
    assert fetch(source, 1).GetNumberOfRows() == 0
    remember('compared images', itertools.chain(*rows.values(), (x for place in sorted(difference) for x in difference[place].values())))
    expect_error(CompareProbabilities(Input=three[0], Cell=three), ['Cell requires one image, got 2'])
    expect_error(CompareProbabilities(Input=two[0], Cell=[three[0]]), ['Cell requires the kind of data of the input, a table, got an image'])
    expect_error(CompareProbabilities(Input=three[0], Cell=[two[0]]), ['Cell requires the kind of data of the input, an image, got a table'])
    three[1].MaximumLag = 1.5
    expect_error(source, ['Cell requires an image with the spacing of the input, 0.2, got 0.15', 'MaximumLag'])
    three[1].MaximumLag, three[1].NumberOfLags = LAG, LAGS + 1
    expect_error(source, ["Cell requires an image of the input's size", 'NumberOfLags'])
    three[1].NumberOfLags, three[1].Phases = LAGS, '1 1 1'
    expect_error(source, ["Cell requires an array of the input's names, got none"])
    three[1].Phases = '1 2 2; m m m'
    assert points(source, 2) == difference
    # Two ranks cannot share an image of one voxel: the rank without points has no arrays
    small = {'NumberOfLags': 1, 'MaximumLag': 1, 'NumberOfDirections': 2, 'NumberOfThrows': 50}
    tiny = [Calculator(Input=ThreePointProbability(Input=pack, **small), ResultArrayName='More', Function='300*S_m_m_m')
            for pack in packs[:2]]
    rows = columns(CompareProbabilities(Input=tiny[0], Cell=[tiny[1]]))
    assert rows['Quantity'] == ['S_m_m_m', 'More', 'all'] and abs(rows['Pack'][1] / rows['Pack'][0] - 300.0) < 1e-9, rows
    remember('tiny images', itertools.chain(*rows.values()))


if __name__ == '__main__':
    run((properties_and_outputs, all_triples, windows, errors_of_three_point, comparisons), EXPECTED)
