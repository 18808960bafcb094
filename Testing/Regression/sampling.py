# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Sampled statistics against exact ones, theory and each other: periodic packs, overlapping spheres, cylinders, masks, stretched packs.

    pvbatch sampling.py FOLDER DATA     FOLDER for its files; DATA/settled_cylinder.csv and ../../Examples/Data/bead_block.csv are read
"""
import itertools
import math
import os
import random
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from paraview.simple import *

from harness import RANKS, columns, fetch, field, run

FOLDER, DATA = sys.argv[1], sys.argv[2]
BEADS = os.path.join(DATA, '..', '..', 'Examples', 'Data', 'bead_block.csv')
BEADS_BOX = [1445.372, 1287.892, 789.106]
CHORDS, TEMPLATE = 'Chord Sampling', 'Template Sampling'


def pairs_of(table):
    return [name for name in table if name.startswith('S_') and not name.endswith('_error')]


def norm(values):
    """The norm over the lags after 0."""
    return math.sqrt(sum(value * value for value in values[1:]))


def spread(values):
    mean = sum(values) / len(values)
    return math.sqrt(sum((value - mean)**2 for value in values) / (len(values) - 1))


def periodic_cell(particles):
    """Random spheres in a periodic cube without overlap: there the pair sum is exact. The modes have equal volumes, so that none is rare."""
    beads = ParticleModes(Input=SpherePackReader(FileName=BEADS, LengthUnit='µm', BoxSize=BEADS_BOX), Method='Equal Volume',
                          NumberOfModes=3)
    cell = UnitCellReconstruction(Input=beads, NumberOfParticles=particles, MaximumIterations=0, MaximumLag=150)
    assert field(fetch(cell), 'OverlapPercent') == 0.0
    return cell


def periodic_packs():
    """Chords and template against the exact sum, in units of their standard errors."""
    cell = periodic_cell(600)
    lags = {'MaximumLag': 150, 'NumberOfLags': 100}
    exact = columns(TwoPointProbability(Input=cell, **lags))
    volumes = columns(OnePointProbability(Input=cell))['VolumeFraction']
    seeds = range(1, 11)
    for method, samples in ((CHORDS, {'NumberOfLines': 3000}), (TEMPLATE, {'NumberOfThrows': 300})):
        units, ones = [], []
        for seed in seeds:
            sampled = columns(TwoPointProbability(Input=cell, Method=method, Seed=seed, **lags, **samples))
            for name in pairs_of(exact):
                # This looks at lags from the fifth on: next to contact so few points of different phases are met that the law is that of counts
                for a, b, error in list(zip(exact[name], sampled[name], sampled[name + '_error']))[5:]:
                    units.append((b - a) / error)
            one = columns(OnePointProbability(Input=cell, Method=method, Seed=seed, **samples))
            assert abs(sum(one['VolumeFraction']) - 1.0) < 1e-12
            ones += [(b - a) / error for a, b, error in zip(volumes, one['VolumeFraction'], one['VolumeFraction_error'])]
        two, five = (sum(abs(u) > bound for u in units) / len(units) for bound in (2.0, 5.0))
        square, one_square = (math.sqrt(sum(u * u for u in group) / len(group)) for group in (units, ones))
        print('  %s: root mean square %.2f standard errors, one-point %.2f, beyond 2 %.3f, beyond 5 %.5f, largest %.1f' %
              (method, square, one_square, two, five, max(map(abs, units))))
        # The normal law has 0.0455 beyond 2. Lags and pairs go together, so that a seed gives some 5 independent numbers: their mean square
        # scatters by sqrt(2 / 50) = 0.2 about 1, and the share by sqrt(0.0455 / 50) = 0.03; the limit is 3 of each. Beyond 5 the law has 6e-7,
        # so none; a thousandth is for errors from few batches
        assert 0.6 < square**2 < 1.6 and two < 0.0455 + 3.0 * 0.03 and five <= 0.001, (method, square, two, five)
        # 4 phases, of which 3 are independent
        assert 0.4 < one_square**2 < 1.8 and max(map(abs, ones)) < 5.0, (method, one_square, ones)


def overlapping_spheres():
    """Spheres at random: S_mm by chords against (1 - V_union(r) / V)^N."""
    edge, fraction, number = 12.0, 0.3, 24
    volume = edge**3
    spheres = round(-math.log(1.0 - fraction) * volume / (4.0 / 3.0 * math.pi))
    curves, shares = [], []
    for seed in range(number):
        draw = random.Random(seed)
        path = os.path.join(FOLDER, 'overlapping_%d_%d.csv' % (RANKS, seed))
        with open(path, 'w') as file:
            file.write('x,y,z,radius\n')
            file.writelines('%.15g,%.15g,%.15g,1\n' % tuple(edge * draw.random() for _ in range(3)) for _ in range(spheres))
        pack = ParticleModes(Input=SpherePackReader(FileName=path, BoxSize=[edge] * 3, BoxPeriodic=[1, 1, 1]), NumberOfModes=1)
        two = columns(TwoPointProbability(Input=pack, Method=CHORDS, MaximumLag=4, NumberOfLags=20, NumberOfLines=4000, Seed=seed))
        one = columns(OnePointProbability(Input=pack, Method=CHORDS, NumberOfLines=4000, Seed=seed))
        curves.append(two['S_m_m'])
        shares.append(one['VolumeFraction'][1])

    # N independent centres miss a volume U with probability (1 - U / V)^N, exactly; exp(-rho U) for large N. The error is that of the
    # mean over realisations, which holds both their own scatter and that of the lines; 4 standard errors of 23 degrees of freedom are
    # passed by 0.06 % of single numbers, and the 21 lags go together
    worst = 0.0
    for k, r in enumerate(two['r']):
        lens = math.pi * (2.0 - r)**2 * (r * r + 4.0 * r) / (12.0 * r) if 0.0 < r < 2.0 else 4.0 / 3.0 * math.pi * (r == 0.0)
        expected = (1.0 - (8.0 / 3.0 * math.pi - lens) / volume)**spheres
        values = [curve[k] for curve in curves]
        worst = max(worst, abs(sum(values) / number - expected) / (spread(values) / math.sqrt(number)))
    print('  largest difference %.1f standard errors, S_mm(0) %.4f' % (worst, sum(c[0] for c in curves) / number))
    assert worst < 4.0, worst
    expected = (1.0 - 4.0 / 3.0 * math.pi / volume)**spheres
    assert abs(sum(shares) / number - expected) < 4.0 * spread(shares) / math.sqrt(number), (shares, expected)


def cylinders():
    """An inner cylinder of a settled pack against its inscribed block, by both methods, and a tilted one."""
    modes = ParticleModes(Input=SpherePackReader(FileName=os.path.join(DATA, 'settled_cylinder.csv'), LengthUnit='µm'), NumberOfModes=3)
    radius, low, height = 800.0, 100.0, 700.0
    half = radius / math.sqrt(2.0)
    lags = {'MaximumLag': 200, 'NumberOfLags': 50, 'CropToWindow': 1, 'NumberOfLines': 20000}
    cylinder = {'CylinderBase': [0, 0, low], 'CylinderRadius': radius, 'CylinderHeight': height}
    block = {'BoxOrigin': [-half, -half, low], 'BoxSize': [2.0 * half, 2.0 * half, height]}
    octants = [columns(TwoPointProbability(Input=modes, BoxOrigin=[-half + i * half, -half + j * half, low + k * height / 2.0],
                                           BoxSize=[half, half, height / 2.0], **lags))
               for i, j, k in itertools.product((0, 1), repeat=3)]
    # By how much two parts of the pack with the volume of an octant differ
    part = {name: [spread([table[name][k] for table in octants]) for k in range(51)] for name in pairs_of(octants[0])}
    octant_volume = half * half * height / 2.0

    exact = columns(TwoPointProbability(Input=modes, **lags, **block))
    tilted = {'CylinderBase': [-177, 0, 250], 'CylinderAxis': [1, 0, 1], 'CylinderRadius': 250, 'CylinderHeight': 500}
    for label, method, window in (('block, chords', CHORDS, block), ('cylinder, exact', 'Exact Pair Sum', cylinder),
                                  ('cylinder, chords', CHORDS, cylinder), ('tilted cylinder, chords', CHORDS, tilted)):
        source = TwoPointProbability(Input=modes, Method=method, **lags, **window)
        table, data = columns(source), fetch(source)
        if method == CHORDS:
            # What is left of the cylinder without its margin, the largest radius
            volume, margin = field(data, 'SampledVolume'), field(data, 'WindowMargin')
            assert margin == 28.0, margin
            if 'CylinderRadius' in window:
                expected = math.pi * (window['CylinderRadius'] - margin)**2 * (window['CylinderHeight'] - 2.0 * margin)
                assert abs(volume / expected - 1.0) < 1e-12, (volume, expected)
        else:
            volume = math.pi * radius**2 * height
        # Parts of a pack scatter as 1 / sqrt(their volume), as they are larger than the lag at which S_rs saturates. The block is one part
        # of 8 octants, the other window another of its own volume; that they share spheres makes them differ less. The norm over the
        # lags, which go together, is like a single number with 7 degrees of freedom: 5 standard errors
        scale = math.sqrt(octant_volume / volume + 1.0 / 8.0)
        worst = 0.0
        for name in pairs_of(exact):
            error = table[name + '_error'] if name + '_error' in table else [0.0] * 51
            bound = norm([math.hypot(scale * a, b) for a, b in zip(part[name], error)])
            worst = max(worst, norm([a - b for a, b in zip(exact[name], table[name])]) / bound)
        print('  %s: largest difference from the block %.2f standard errors' % (label, worst))
        assert worst < 5.0, (label, worst)


def masks():
    """A mask equal to a box is that box; so is a label of a label image."""
    step = 20.0  # the edge of the voxels in µm, which is the unit here
    beads = SpherePackReader(FileName=BEADS, Scale=1.0 / step, LengthUnit='20 µm')
    modes = ParticleModes(Input=beads, NumberOfModes=3)
    lags = {'MaximumLag': 9, 'NumberOfLags': 30, 'NumberOfLines': 3000, 'WindowMargin': 2}
    filters = ((TwoPointProbability, {'Method': CHORDS}), (ChordLengths, {}))
    # Voxels around the points 2…69 and so on; the margin of two voxels exceeds the largest radius, 1.32: spheres beyond the box that the
    # box run does not see cannot reach in
    extent = [2, 69, 2, 61, 2, 36]
    box = {'BoxOrigin': [extent[2 * q] - 0.5 for q in range(3)], 'BoxSize': [extent[2 * q + 1] - extent[2 * q] + 1.0 for q in range(3)]}
    plain = Calculator(Input=Wavelet(WholeExtent=extent), Function='1', ResultArrayName='Inside')
    inside = ' & '.join('(coords%s > %g) & (coords%s < %g)' % (axis, extent[2 * q] - 0.5, axis, extent[2 * q + 1] + 0.5)
                        for q, axis in enumerate('XYZ'))
    labels = Calculator(Input=Wavelet(WholeExtent=[0, 72, 0, 64, 0, 39]), Function='if (%s, 3, 7)' % inside, ResultArrayName='Label')
    expected = [filter(Input=modes, CropToWindow=1, **box, **lags, **settings) for filter, settings in filters]
    for label, mask in (('mask', {'Mask': plain, 'MaskArray': 'Inside'}),
                        ('label', {'Mask': labels, 'MaskArray': 'Label', 'MaskLabel': 3})):
        sources = [filter(Input=modes, **lags, **settings, **mask) for filter, settings in filters]
        worst = 0.0
        for n, port in ((0, 0), (0, 1), (0, 2), (0, 3), (1, 0)):
            one, other = columns(expected[n], port), columns(sources[n], port)
            assert list(one) == list(other) and field(fetch(sources[n], port), 'Mask') == 1.0
            for name, values in one.items():
                if name == 'Pair':
                    continue
                for a, b in zip(values, other[name]):
                    worst = max(worst, 0.0 if math.isnan(a) and math.isnan(b) else abs(a - b))
        print('  %s: largest difference from the box %.1e' % (label, worst))
        assert worst < 1e-9, (label, worst)  # the rounding of the positions along lines
        for field_name in ('SampledVolume', 'TotalError'):
            for a, b in ([field(fetch(two), field_name) for two in pair] for pair in zip(expected, sources)):
                assert abs(a / b - 1.0) < 1e-9, (field_name, a, b)
        for method in (CHORDS, TEMPLATE):
            samples = {'Method': method, 'NumberOfLines': 3000, 'WindowMargin': 2}
            one = columns(OnePointProbability(Input=modes, CropToWindow=1, **box, **samples))
            other = columns(OnePointProbability(Input=modes, **samples, **mask))
            assert all(abs(a - b) < 1e-9 for a, b in zip(one['VolumeFraction'], other['VolumeFraction'])), (label, method, one, other)


def stretched_packs():
    """Centres stretched along z show in the isotropy deviation; those of the pack itself are within noise."""
    cell = fetch(periodic_cell(600))
    radius, box = cell.GetPointData().GetArray('Radius'), field(cell, 'BoxSize')
    lags = {'MaximumLag': 100, 'NumberOfLags': 40, 'NumberOfDirections': 24}
    sigma = {}
    for stretch in (1.0, 1.25):
        path = os.path.join(FOLDER, 'stretched_%d_%g.csv' % (RANKS, stretch))
        with open(path, 'w') as file:
            file.write('x,y,z,radius\n')
            for i in range(cell.GetNumberOfPoints()):
                x, y, z = cell.GetPoint(i)
                file.write('%.17g,%.17g,%.17g,%.17g\n' % (x, y, z * stretch, radius.GetValue(i)))
        pack = ParticleModes(Input=SpherePackReader(FileName=path, LengthUnit='µm', BoxSize=[box[0], box[1], box[2] * stretch],
                                                    BoxPeriodic=[1, 1, 1]), Method='One Per Size')
        exact = columns(DirectionalProbability(Input=pack, **lags))
        chords = columns(DirectionalProbability(Input=pack, Method=CHORDS, NumberOfLines=500, **lags))
        sigma[stretch] = {name: norm(values) for name, values in exact.items() if name.startswith('sigma_')}
        for name in sigma[stretch]:
            measured, noise = norm(chords[name]), norm(chords[name + '_noise'])
            # Independent directions: the variance by chords is the exact one and that of the noise. An estimate from 24 directions scatters
            # by sqrt(2 / 23) = 0.3, and less as the lags are several independent numbers; the limit is 3 times 0.15 of a standard deviation
            ratio = measured / math.hypot(sigma[stretch][name], noise)
            print('  stretch %g %s: exact %.5f, chords %.5f, noise %.5f, ratio %.2f' % (stretch, name, sigma[stretch][name], measured, noise, ratio))
            assert abs(ratio - 1.0) < 0.45, (stretch, name, ratio)
    # This looks at all phases that fill the cell well; the pack itself deviates by its finite size only
    assert sigma[1.25]['sigma_S_m_m'] > 1.5 * sigma[1.0]['sigma_S_m_m'], sigma


def stopped_early():
    """Sampling that is stopped keeps what it has: fewer samples than asked for, and values within their errors."""
    pack = periodic_cell(300)
    exact = columns(TwoPointProbability(Input=pack, MaximumLag=100, NumberOfLags=20))
    most = 10**7
    runs = {'chords': TwoPointProbability(Input=pack, MaximumLag=100, NumberOfLags=20, Method=CHORDS, NumberOfLines=most),
            'template': TwoPointProbability(Input=pack, MaximumLag=100, NumberOfLags=20, Method='Template Sampling', NumberOfThrows=most),
            'fans': ThreePointProbability(Input=pack, MaximumLag=100, NumberOfLags=20, Phases='m m m', NumberOfThrows=most)}
    for name, source in runs.items():
        filter = source.GetClientSideObject()
        begun = []

        def stop(*_):
            begun.append(time.time())
            if begun[-1] - begun[0] > 0.5:
                filter.SetAbortExecute(1)

        filter.AddObserver('ProgressEvent', stop)
        port = 1 if name == 'fans' else 0
        table = columns(source, port)
        data = fetch(source, port)
        samples = field(data, 'NumberOfLines' if name == 'chords' else 'NumberOfThrows')
        assert field(data, 'Stopped') == 1 and 100 < samples < most, (name, samples)
        if name == 'fans':
            continue
        for k, value in enumerate(table['S_m_m']):
            error = table['S_m_m_error'][k]
            assert 0 < error < 0.05 and abs(value - exact['S_m_m'][k]) < 5 * error, (name, k, value, exact['S_m_m'][k], error)


if __name__ == '__main__':
    run((periodic_packs, overlapping_spheres, cylinders, masks, stretched_packs, stopped_early))
