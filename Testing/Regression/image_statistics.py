# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Image Statistics in a script: the statistics of the voxels of a cell against the exact ones of its spheres, beside them in Compare
Probabilities, and of a file of the image; the numbers of one rank are those of two.

    pvbatch image_statistics.py FOLDER NUMBERS.json
"""
import math
import os
import sys

from paraview.simple import *

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from harness import RANKS, columns, expect_error, fetch, field, remember, run

FOLDER, EXPECTED = sys.argv[1:3]
PACK = os.path.join(os.path.dirname(os.path.abspath(__file__)), '../../Examples/Data/bead_block.csv')
VOXELS, LAGS = 96, 24

reader = SpherePackReader(FileName=PACK, BoxSize=[1445.372, 1287.892, 789.106], LengthUnit='µm')
modes = ParticleModes(Input=reader, NumberOfModes=3)
cell = UnitCellReconstruction(Input=modes, NumberOfParticles=300, MaximumIterations=30, NumberOfLags=60)
edge = field(fetch(cell), 'BoxSize')[0]
voxel = edge / VOXELS
image = LabelImage(Input=cell, Dimensions=[VOXELS] * 3)
statistics = ImageStatistics(Input=image, ImagePairs='3 3; m m')
exact = TwoPointProbability(Input=cell, MaximumLag=LAGS * voxel, NumberOfLags=LAGS)


def numbers(rows):
    return [value for name, values in rows.items() if name not in ('Pair', 'Phase') for value in values if value == value]


def statistics_of_voxels():
    found, of_spheres = columns(statistics), columns(exact)
    data = fetch(statistics)
    assert abs(field(data, 'MaximumLag') / voxel - LAGS) < 1e-9
    assert field(data, 'BoxPeriodic') == [1, 1, 1], 'the boundary is that of the image'
    assert field(data, 'LengthUnit') == 'µm'
    assert list(found) == list(of_spheres)
    for name in list(found)[1:]:
        # 3.4e-4 is the error of the voxels, with 11 of them in a diameter
        rms = math.sqrt(sum((a - b) ** 2 for a, b in zip(found[name][1:], of_spheres[name][1:])) / LAGS)
        assert rms < 3 * 3.4e-4, (name, rms)
        assert abs(found[name][0] - of_spheres[name][0]) < 2e-3, name
    statistics.SMProxy.UpdatePropertyInformation()
    assert statistics.GetProperty('EstimatedTime')[0] > 0.0 and statistics.GetProperty('EstimatedMemory')[0] > 0.0
    for port in (0, 1, 2, 3, 5, 6):
        remember('output %d' % port, numbers(columns(statistics, port)))


def phases_and_chords():
    phases, chords = columns(statistics, 6), columns(statistics, 5)
    assert phases['Phase'] == ['1', '2', '3', 'm'] and phases['Label'] == [1, 2, 3, 0]
    spheres = fetch(cell).GetPointData().GetArray('Radius')
    surface = sum(4 * math.pi * spheres.GetValue(n) ** 2 for n in range(spheres.GetNumberOfTuples())) / edge ** 3
    # The truth lies between, but for the chance of this image
    assert 0.88 * surface < phases['SurfaceAtOneVoxel'][3] < 1.005 * surface
    assert 0.995 * surface < phases['SurfacePerVolume'][3] < 1.08 * surface
    for name, fraction in zip(phases['Phase'], phases['VolumeFraction']):
        assert abs(chords['L_' + name][0] - fraction) < 1e-12, name


def map_over_lags():
    statistics.UpdatePipeline()
    info = statistics.GetDataInformation(4)
    assert list(info.GetExtent()) == [-LAGS, LAGS] * 3, info.GetExtent()
    arrays = info.GetPointDataInformation()
    assert arrays.GetArrayInformation('S_3_3')
    largest = arrays.GetArrayInformation('S_m_m').GetComponentRange(0)[1]
    assert abs(largest - columns(statistics, 6)['VolumeFraction'][3]) < 1e-12


def beside_a_pack():
    rows = columns(CompareProbabilities(Input=exact, Cell=statistics))
    percent = dict(zip(rows['Quantity'], rows['Percent']))
    assert 0.0 < percent['all'] < 1.5, percent['all']
    remember('compared', rows['Percent'])


def files_and_masks():
    """The voxels of a file are points, and a mask that holds all of them changes nothing."""
    points = LabelImage(Input=cell, Dimensions=[VOXELS] * 3, ArrayOn='Points')
    points.UpdatePipeline()
    name = os.path.join(FOLDER, 'voxels_%d.pvti' % RANKS)
    SaveData(name, proxy=points, DataMode='Binary')
    read = XMLPartitionedImageDataReader(FileName=[name])
    window = columns(ImageStatistics(Input=points, Boundary='Window', ImagePairs=''))
    assert columns(ImageStatistics(Input=read, Boundary='Window', ImagePairs='')) == window
    remember('window', numbers(window))
    inside = Calculator(Input=image, AttributeType='Cell Data', ResultArrayName='Inside', Function='1')
    masked = ImageStatistics(Input=image, Mask=inside, MaskArray='Inside', Boundary='Window', ImagePairs='')
    assert columns(masked) == window
    some = ImageStatistics(Input=image, Mask=image, MaskArray='Phase', MaskLabel=3)
    assert columns(some)['S_3_3'][0] == 1.0, 'nothing but mode 3 is inside'


def refusals():
    ids = LabelImage(Input=cell, Dimensions=[40] * 3, Phases=0, ParticleIds=1)
    expect_error(ImageStatistics(Input=ids, PhaseArray='ParticleId'), ['at most 64 labels; ParticleId has'])
    expect_error(ImageStatistics(Input=image, MaximumLag=edge), ['MaximumLag requires', 'half the shortest edge'])
    expect_error(ImageStatistics(Input=image, MemoryLimit=20), ['MemoryLimit requires at least', 'got 20'])


if __name__ == '__main__':
    run((statistics_of_voxels, phases_and_chords, map_over_lags, beside_a_pack, files_and_masks, refusals), EXPECTED)
