# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Sampling that is asked for what cannot be: no rank hangs, outputs are empty, and mended properties work again."""
import os
import sys

from paraview import servermanager
from paraview.simple import *

folder = sys.argv[1]
ranks = servermanager.ActiveConnection.GetNumberOfDataPartitions()
path = os.path.join(folder, 'sampling_errors_%d.csv' % ranks)
with open(path, 'w') as file:
    file.write('x,y,z,radius\n')
    file.writelines('%d,%d,%d,%g\n' % (x, y, z, 0.3 + 0.02 * ((x + y + z) % 3)) for x in range(9) for y in range(9) for z in range(9))

modes = ParticleModes(Input=SpherePackReader(FileName=path), NumberOfModes=2)
box = {'BoxOrigin': [-0.5] * 3, 'BoxSize': [9.0] * 3}
one = OnePointProbability(Input=modes, Method='Chord Sampling', NumberOfLines=500, NumberOfThrows=50, **box)
two = TwoPointProbability(Input=modes, Method='Chord Sampling', NumberOfLines=500, NumberOfThrows=50, MaximumLag=3, NumberOfLags=20,
                          NumberOfDirections=3, ChordLengths=1, Autocovariance=1, RadialDistribution=1, ImagePairs='m m',
                          ImageResolution=3, **box)


def image(extent, function):
    return Calculator(Input=Wavelet(WholeExtent=extent), Function=function, ResultArrayName='Inside')


def update(source):
    """Rows of the tables, points of the map."""
    source.UpdatePipeline()
    result = []
    for port in range(source.SMProxy.GetNumberOfOutputPorts()):
        info = source.GetDataInformation(port)
        result.append(info.GetNumberOfPoints() if port == 3 else info.GetNumberOfRows())
    return result


def fails_and_mends(source, bad):
    """Sets the bad properties, and then their former values again."""
    expected = update(source)
    assert all(expected), expected
    former = {name: list(value) if hasattr(value := source.GetPropertyValue(name), '__len__') and not isinstance(value, str) else value
              for name in bad}
    for name, value in bad.items():
        setattr(source, name, value)
    got = update(source)
    assert not any(got), (bad, got)
    for name, value in former.items():
        setattr(source, name, value)
    got = update(source)
    assert got == expected, (bad, got, expected)


assert update(one) == [3], update(one)
expected = update(two)
assert expected[0] == 21 and expected[4] == 21 and expected[5] == 63 and expected[6:] == [21, 21, 21], expected

for source in (one, two):
    for bad in ({'NumberOfLines': 0}, {'Method': 'Template Sampling', 'NumberOfThrows': 0}, {'Seed': -1}, {'TargetError': -1.0},
                {'WindowMargin': -0.5}, {'WindowMargin': 4.6}, {'BoxSize': [9.0, 9.0, -1.0]}, {'BoxSize': [0.25] * 3},
                {'CylinderRadius': 5.0}, {'CylinderRadius': 5.0, 'BoxSize': [0.0] * 3}):
        fails_and_mends(source, bad)
for bad in ({'NumberOfDirections': 1}, {'Method': 'Template Sampling'}, {'NumberOfLags': 0}, {'MaximumLag': 9.5},
            {'ImagePairs': '1 x'}, {'ImagePairs': '1 3'}, {'SaturationTolerance': 0.0}):
    fails_and_mends(two, bad)

# Masks: none of map and radial distribution with these
two = TwoPointProbability(Input=modes, Method='Chord Sampling', NumberOfLines=500, MaximumLag=2, NumberOfLags=20, **box)


def rows(source):
    source.UpdatePipeline()
    return source.GetDataInformation(0).GetNumberOfRows()


good, empty, beyond = image([0, 8, 0, 8, 0, 8], '1'), image([0, 8, 0, 8, 0, 8], '0'), image([20, 28, 0, 8, 0, 8], '1')
for source, expected in ((one, 3), (two, 21)):
    for name, bad in (('empty', {'Mask': empty}), ('beyond', {'Mask': beyond}), ('label', {'Mask': good, 'MaskLabel': 2}),
                      ('array', {'Mask': good, 'MaskArray': 'No such array'}), ('margin', {'Mask': good, 'WindowMargin': 4.6})):
        source.Mask = good
        source.MaskArray = 'Inside'
        assert rows(source) == expected, (name, rows(source))
        for key, value in bad.items():
            setattr(source, key, value)
        assert rows(source) == 0, (name, rows(source))
        source.Mask, source.MaskArray, source.MaskLabel, source.WindowMargin = good, 'Inside', 0, -1.0
        assert rows(source) == expected, (name, rows(source))
two.Method = 'Exact Pair Sum'  # which knows no masks
assert rows(two) == 0
two.Method = 'Chord Sampling'
assert rows(two) == 21
print('sampling_errors.py: passed')
