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
lags = {'MaximumLag': 3, 'NumberOfLags': 20}
two = TwoPointProbability(Input=modes, Method='Chord Sampling', NumberOfLines=500, NumberOfThrows=50, **lags, **box)
directions = DirectionalProbability(Input=modes, Method='Chord Sampling', NumberOfLines=500, NumberOfDirections=3, **lags, **box)
chords = ChordLengths(Input=modes, NumberOfLines=500, **lags, **box)
radial = RadialDistribution(Input=modes, **lags, **box)
image_of_pairs = ProbabilityMap(Input=modes, MaximumLag=3, Resolution=3, **box)


def image(extent, function):
    return Calculator(Input=Wavelet(WholeExtent=extent), Function=function, ResultArrayName='Inside')


def update(source):
    """The number of rows of a table, or of points of the map."""
    source.UpdatePipeline()
    result = []
    for port in range(source.SMProxy.GetNumberOfOutputPorts()):
        info = source.GetDataInformation(port)
        result.append(info.GetNumberOfRows() if info.GetDataSetTypeAsString() == 'vtkTable' else info.GetNumberOfPoints())
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
assert update(two) == [21, 6, 21, 21], update(two)
assert update(directions) == [21, 63], update(directions)
assert update(chords) == [21] and update(radial) == [21], (update(chords), update(radial))

WINDOWS = ({'BoxSize': [9.0, 9.0, -1.0]}, {'BoxSize': [0.25] * 3}, {'CylinderRadius': 5.0}, {'CylinderRadius': 5.0, 'BoxSize': [0.0] * 3})
SAMPLES = ({'NumberOfLines': 0}, {'Seed': -1}, {'TargetError': -1.0}, {'WindowMargin': -0.5}, {'WindowMargin': 4.6})
LAGS = ({'NumberOfLags': 0}, {'MaximumLag': 9.5})
for source, properties in ((one, (*SAMPLES, {'Method': 'Template Sampling', 'NumberOfThrows': 0})),
                           (two, (*SAMPLES, *LAGS, {'Method': 'Template Sampling', 'NumberOfThrows': 0}, {'SaturationTolerance': 0.0})),
                           (directions, (*SAMPLES, *LAGS, {'NumberOfDirections': 1})),
                           (chords, (*SAMPLES, *LAGS)),
                           (radial, LAGS),
                           (image_of_pairs, ({'PhasePairs': '1 x'}, {'PhasePairs': '1 3'}, {'Resolution': 0}, {'Spacing': 9.5}))):
    for bad in (*WINDOWS, *properties):
        fails_and_mends(source, bad)

# Masks
two, directions, chords = (filter(Input=modes, NumberOfLines=500, MaximumLag=2, NumberOfLags=20, **box)
                           for filter in (TwoPointProbability, DirectionalProbability, ChordLengths))
two.Method = directions.Method = 'Chord Sampling'


def rows(source):
    source.UpdatePipeline()
    return source.GetDataInformation(0).GetNumberOfRows()


good, empty, beyond = image([0, 8, 0, 8, 0, 8], '1'), image([0, 8, 0, 8, 0, 8], '0'), image([20, 28, 0, 8, 0, 8], '1')
for source, expected in ((one, 3), (two, 21), (directions, 21), (chords, 21)):
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
two.Method = directions.Method = 'Exact Pair Sum'  # this method knows no masks
assert rows(two) == rows(directions) == 0
two.Method = 'Chord Sampling'
assert rows(two) == 21
print('sampling_errors.py: passed')
