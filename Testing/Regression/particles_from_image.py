# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Particles From Image in a script: the spheres of a pack from the image of its volume fractions with noise, from its phases and from its
ids, and by watershed, the image that they leave behind, and what the pack that was found is good for; the numbers of one rank are those of two.

    pvbatch particles_from_image.py FOLDER NUMBERS.json
"""
import math
import os
import sys

from paraview.simple import *

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from harness import expect_error, fetch, field, remember, run

FOLDER, EXPECTED = sys.argv[1:3]
PACK = os.path.join(os.path.dirname(os.path.abspath(__file__)), '../../Examples/Data/bead_block.csv')
VOXEL = 3.0
NOISE = 0.05
SIZE = [240, 210, 180]

modes = ParticleModes(Input=SpherePackReader(FileName=PACK, LengthUnit='µm'), NumberOfModes=1, BoxOrigin=[400, 400, 200], BoxSize=SIZE, CropToWindow=1)
image = LabelImage(Input=modes, VoxelSize=VOXEL, VolumeFractions=1, ParticleIds=1)
# Even noise that depends on the place alone
place = '(12.9898 * coordsX + 78.233 * coordsY + 37.719 * coordsZ)'
chance = '(43758.5453 * sin(%s) - floor(43758.5453 * sin(%s)) - 0.5)' % (place, place)
centres = LabelImage(Input=modes, VoxelSize=VOXEL, VolumeFractions=1, ArrayOn='Points')
grey = Calculator(Input=centres, ResultArrayName='Grey', Function='1000 + 500 * VolumeFraction + %.12g * %s' % (500 * NOISE * math.sqrt(12), chance))
particles = ParticlesFromImage(Input=grey, ImageArray='Grey', Residual=1)


def spheres(source, port=0):
    """x, y, z, radius of each point."""
    data = fetch(source, port)
    radius = data.GetPointData().GetArray('Radius')
    return [(*data.GetPoint(n), radius.GetValue(n)) for n in range(data.GetNumberOfPoints())]


def compare(found, centre, radius, least):
    """All spheres of the pack with centres two voxels and more inside are found, and hardly more. Those that reach over the border lack
    what the image, which has only spheres with centres inside, does not show: they count as found alone."""
    missing, errors = 0, []
    for x, y, z, r in spheres(modes):
        inside = min(min(q - low, low + size - q) for q, low, size in zip((x, y, z), (400, 400, 200), SIZE))
        if inside < 2 * VOXEL or 2 * r < least:
            continue
        nearest = min(found, key=lambda other: math.dist(other[:3], (x, y, z)))
        away = math.dist(nearest[:3], (x, y, z))
        missing += away > 0.5 * r
        if inside > 25 and away <= 0.5 * r:
            errors.append((away, abs(nearest[3] - r)))
    assert missing == 0, missing
    assert len(errors) > 20, len(errors)
    for n, limit in enumerate((centre, radius)):
        rms = math.sqrt(sum(error[n] ** 2 for error in errors) / len(errors))
        assert rms < limit * VOXEL, (n, rms)


def grey_values():
    found = spheres(particles)
    compare(found, 0.06, 0.03, 5 * VOXEL)
    data = fetch(particles)
    assert abs(field(data, 'MatrixValue') - 1000) < 5 and abs(field(data, 'ParticleValue') - 1500) < 5
    assert 0.9 * NOISE < field(data, 'Noise') < 1.6 * NOISE, field(data, 'Noise')  # edges without blur count
    assert field(data, 'LengthUnit') == 'µm' and field(data, 'Stopped') == 0
    assert [round(edge / VOXEL) for edge in field(data, 'BoxSize')] == [round(size / VOXEL) for size in SIZE]
    remember('spheres', [value for sphere in found for value in sphere])
    for name in ('EqualVolumeRadius', 'Sphericity', 'Contrast', 'FitResidual', 'CenterError', 'RadiusError', 'OverlapDepth', 'BorderFaces'):
        array = data.GetPointData().GetArray(name)
        remember(name, [array.GetValue(n) for n in range(array.GetNumberOfTuples())])
    remember('dropped', [value for sphere in spheres(particles, 2) for value in sphere])
    particles.SMProxy.UpdatePropertyInformation()
    assert particles.GetProperty('EstimatedTime')[0] > 0.0 and particles.GetProperty('EstimatedMemory')[0] > 0.0
    assert particles.GetProperty('AutomaticValues')[0].startswith('Minimum Diameter 9')


def images():
    whole = grey.GetDataInformation().GetExtent()
    for port, name in ((1, 'ParticleId'), (3, 'Residual')):
        info = particles.GetDataInformation(port)
        assert list(info.GetExtent()) == list(whole), (port, info.GetExtent())
        values = info.GetPointDataInformation().GetArrayInformation(name).GetComponentRange(0)
        if port == 1:
            assert -1.0 <= values[0] <= 0.0 and values[1] == len(spheres(particles)), values
        else:
            assert -250 < values[0] < 0 < values[1] < 500, values


def binary_and_labels():
    binary = spheres(ParticlesFromImage(Input=image, ImageArray='Phase'))
    compare(binary, 0.25, 0.15, 7 * VOXEL)
    remember('binary', [value for sphere in binary for value in sphere])
    labels = ParticlesFromImage(Input=image, ImageArray='ParticleId')
    compare(spheres(labels), 0.25, 0.15, 7 * VOXEL)
    ids = fetch(labels).GetPointData().GetArray('Id')
    of_pack = fetch(modes).GetPointData().GetArray('Id')
    raised = field(fetch(image), 'ParticleIdsRaised')
    known = {of_pack.GetValue(n) + raised for n in range(of_pack.GetNumberOfTuples())}
    assert all(ids.GetValue(n) in known for n in range(ids.GetNumberOfTuples())), 'ids are the labels'


def watershed():
    """Particles without a fit: nearly all spheres, whose volume is that of their voxels."""
    cut = ParticlesFromImage(Input=grey, ImageArray='Grey', Method='Watershed')
    found, fitted = spheres(cut), spheres(particles)
    assert abs(len(found) - len(fitted)) < 0.1 * len(fitted), (len(found), len(fitted))
    whole = ParticlesFromImage(Input=grey, ImageArray='Grey', Method='Watershed', BorderParticles='Whole Only')
    inner = spheres(whole)
    for x, y, z, r in inner:
        near = min(fitted, key=lambda other: math.dist(other[:3], (x, y, z)))
        assert math.dist(near[:3], (x, y, z)) < 2 * VOXEL and abs(near[3] - r) < 0.15 * r, (x, y, z, r, near)
    assert len(inner) > 20, len(inner)
    data = fetch(cut)
    volume = sum(4 / 3 * math.pi * r ** 3 for _, _, _, r in found) / math.prod(field(data, 'BoxSize'))
    # The image has what the border cuts off
    sums = IntegrateVariables(Input=image)
    expected = fetch(sums).GetCellData().GetArray('VolumeFraction').GetValue(0) / math.prod(SIZE)
    assert abs(volume - expected) < 0.02, (volume, expected)
    for name in ('EqualVolumeRadius', 'Sphericity', 'BorderFaces'):
        array = data.GetPointData().GetArray(name)
        remember('watershed ' + name, [array.GetValue(n) for n in range(array.GetNumberOfTuples())])
    remember('watershed', [value for sphere in found for value in sphere])
    # Of labels the volumes are those of their voxels, cut at the border
    labels = spheres(ParticlesFromImage(Input=image, ImageArray='ParticleId', Method='Watershed', MinimumDiameter=0.1))
    volume = sum(4 / 3 * math.pi * r ** 3 for _, _, _, r in labels)
    voxels = IntegrateVariables(Input=Threshold(Input=image, Scalars=['CELLS', 'ParticleId'], LowerThreshold=1, UpperThreshold=1e9))
    assert abs(volume / fetch(voxels).GetCellData().GetArray('Volume').GetValue(0) - 1) < 1e-6


def as_a_pack():
    """What was found is a pack for all that comes after it."""
    whole = ParticlesFromImage(Input=grey, ImageArray='Grey', BorderParticles='Whole Only')
    edge = field(fetch(whole), 'BoxSize')
    assert all(a < size for a, size in zip(edge, SIZE))
    again = ParticleModes(Input=particles, NumberOfModes=2)
    one = OnePointProbability(Input=again)
    one.UpdatePipeline()
    fraction = 1.0 - field(fetch(one), 'VolumeFractions')[-1]
    before = OnePointProbability(Input=modes)
    before.UpdatePipeline()
    expected = 1.0 - field(fetch(before), 'VolumeFractions')[-1]
    assert abs(fraction - expected) < 0.03, (fraction, expected)


def refusals():
    expect_error(ParticlesFromImage(Input=grey, ImageArray='None'), ["an array 'None'"])
    expect_error(ParticlesFromImage(Input=grey, ImageArray='Grey', ImageKind='Binary'), ['A binary image requires two values'])
    expect_error(ParticlesFromImage(Input=grey, ImageArray='Grey', MemoryLimit=1), ['MemoryLimit requires at least', 'got 1'])
    expect_error(ParticlesFromImage(Input=grey, ImageArray='Grey', Threshold=9999), ['Threshold requires a value between'])
    constant = Calculator(Input=centres, ResultArrayName='Grey', Function='7')
    expect_error(ParticlesFromImage(Input=constant, ImageArray='Grey'), ['one grey only, 7'])


if __name__ == '__main__':
    run((grey_values, images, binary_and_labels, watershed, as_a_pack, refusals), EXPECTED)
