# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Images made by others, in MATLAB files: 64 equal spheres that touch, of which the volume is known, by a fit and by watershed; and an image of 1607
labels, some of which are in pieces, whose particles have the volumes and centres of their labels.

    pvbatch third_party_images.py FOLDER     FOLDER for the images, as ParaView reads no such files
"""
import math
import os
import struct
import sys
import zlib

from paraview import servermanager
from paraview.simple import *

folder = os.environ.get('RUC_THIRD_PARTY_DATA', '')
if not folder:
    print('RUC_THIRD_PARTY_DATA is not set')
    sys.exit(0)


def elements(data):
    """The types and contents of the elements of a MATLAB 5 file, unpacked (MAT-File Format, The MathWorks)."""
    found, at = [], 0
    while at < len(data):
        kind, size = struct.unpack_from('<II', data, at)
        if kind >> 16:  # a small one
            found.append((kind & 0xffff, data[at + 4:at + 4 + (kind >> 16)]))
            at += 8
        elif kind == 15:  # packed
            found += elements(zlib.decompress(data[at + 8:at + 8 + size]))
            at += 8 + size
        else:
            found.append((kind, data[at + 8:at + 8 + size]))
            at += 8 + size + -size % 8
    return found


def read_image(name):
    """Returns the first array of a file as ParaView reads it, and its bytes, x running fastest. Voxels are cubes of edge 1."""
    with open(os.path.join(folder, 'voxels', name), 'rb') as file:
        matrix = elements(file.read()[128:])[0][1]
    _, (_, edges), _, (kind, values) = elements(matrix)
    path = os.path.join(sys.argv[1], os.path.splitext(name)[0])
    with open(path + '.raw', 'wb') as file:
        file.write(values)
    with open(path + '.mhd', 'w') as file:
        file.write('NDims = 3\nDimSize = %d %d %d\nElementType = %s\nElementByteOrderMSB = False\nElementDataFile = %s\n' %
                   (*struct.unpack('<3i', edges), {2: 'MET_UCHAR', 4: 'MET_USHORT'}[kind], os.path.basename(path) + '.raw'))
    return OpenDataFile(path + '.mhd'), values, struct.unpack('<3i', edges)


def numbers(pack, name):
    array = pack.GetPointData().GetArray(name)
    return [array.GetTuple1(n) for n in range(array.GetNumberOfTuples())]


def spheres_that_touch():
    image, values, _ = read_image('Loose_packing.mat')
    by_volume = (3 * values.count(1) / 64 / (4 * math.pi)) ** (1 / 3)
    for method, tolerance in (('Sphere Fit', 5e-4), ('Watershed', 2e-3)):
        particles = ParticlesFromImage(Input=image, Method=method)
        pack = servermanager.Fetch(particles)
        radii = numbers(pack, 'Radius')
        print(method, len(radii), 'spheres, radii', min(radii), 'to', max(radii), ', by volume', by_volume)
        assert len(radii) == 64
        assert all(abs(radius / by_volume - 1) < tolerance for radius in radii)
        for n in range(64):
            # The centres lie on a lattice of 100 voxels
            assert all(abs((q - 49.5) % 100 - (100 if (q - 49.5) % 100 > 50 else 0)) < 1.0 for q in pack.GetPoint(n)), pack.GetPoint(n)
        Delete(particles)


def labels_of_others():
    image, values, edges = read_image('lm_simstep0.mat')
    sums = {}
    for place, label in enumerate(struct.unpack('<%dH' % (len(values) // 2), values)):
        of = sums.setdefault(label, [0, 0, 0, 0])
        of[0] += 1
        of[1] += place % edges[0]
        of[2] += place // edges[0] % edges[1]
        of[3] += place // (edges[0] * edges[1])
    sums.pop(0, None)
    assert len(sums) == 1607, len(sums)
    # There is no matrix, so that no sphere can be fitted
    particles = ParticlesFromImage(Input=image, ImageKind='Labels', Method='Watershed', MinimumDiameter=0.1)
    pack = servermanager.Fetch(particles)
    ids, radii, sphericities = [numbers(pack, name) for name in ('Id', 'EqualVolumeRadius', 'Sphericity')]
    print('labels:', len(ids), 'of which', sum(value < 0.5 for value in sphericities), 'have a sphericity below 0.5')
    assert ids == sorted(sums)
    for n, (label, radius) in enumerate(zip(ids, radii)):
        voxels = sums[int(label)][0]
        assert abs(4 / 3 * math.pi * radius ** 3 / voxels - 1) < 1e-6, label
        assert all(abs(q - sum_q / voxels) < 1e-6 for q, sum_q in zip(pack.GetPoint(n), sums[int(label)][1:])), label


spheres_that_touch()
labels_of_others()
