# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Images: a pack as voxels and what is made of them downstream; files of voxels that open again; and every kind of image that ParaView reads
as a mask. The numbers, and the bytes of files, are those of one rank.

    pvbatch images.py FOLDER EXPECTED     FOLDER for its files, which one rank makes for all; EXPECTED the file of the numbers
"""
import hashlib
import os
import struct
import sys

from paraview.simple import *
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkImageData

from harness import RANKS, columns, fetch, field, leaves, remember, run

HERE = os.path.dirname(os.path.abspath(__file__))
FOLDER = os.path.join(os.path.abspath(sys.argv[1]), 'images')
N = 11  # points along each axis of the mask, at 0, 1, ... 10


def make_pack(**window):
    reader = SpherePackReader(FileName=os.path.join(HERE, '../Gui/pack.csv'), BoxSize=[10, 10, 10], **window)
    return ParticleModes(Input=reader, NumberOfModes=2)


def path(name):
    return os.path.join(FOLDER, name)


def numbers(data, name):
    """The values of a cell array."""
    return [int(leaf.GetCellData().GetArray(name).GetTuple1(i)) for leaf in leaves(data) for i in range(leaf.GetNumberOfCells())]


def labels():
    """Voxels come in pieces of one image; filters and writers of ParaView see the whole at their first update."""
    pack = make_pack(BoxPeriodic=[1, 1, 1])
    pack.UpdatePipeline()
    image = LabelImage(Input=pack, VoxelSize=0.5, ParticleIds=1, VolumeFractions=1)
    image.UpdateVTKObjects()
    image.SMProxy.UpdatePropertyInformation()
    assert image.GetProperty('EstimatedTime').GetData() > 0.0 and image.GetProperty('EstimatedMemory').GetData() > 0.0
    assert image.GetDataInformation().GetNumberOfCells() == 0, 'it has not run'
    particles = Threshold(Input=image, Scalars=['CELLS', 'Phase'], LowerThreshold=1, UpperThreshold=2)
    particles.UpdatePipeline()
    info = image.GetDataInformation()
    assert info.GetExtent() == (0, 20, 0, 20, 0, 20) and info.GetNumberOfCells() == 8000, info.GetExtent()
    count = particles.GetDataInformation().GetNumberOfCells()
    sums = IntegrateVariables(Input=image)
    fraction = fetch(sums).GetCellData().GetArray('VolumeFraction').GetValue(0) / 1000.0
    exact = 1.0 - field(fetch(OnePointProbability(Input=pack)), 'VolumeFractions')[-1]
    assert abs(fraction - exact) < 1e-6 and abs(count / 8000 - exact) < 0.01, (fraction, count / 8000, exact)
    remember('voxels in particles', [count])
    SaveData(path('labels_%d.pvti' % RANKS), proxy=image, DataMode='Binary')
    again = OpenDataFile(path('labels_%d.pvti' % RANKS))
    again.UpdatePipeline()
    assert again.GetDataInformation().GetNumberOfCells() == 8000
    automatic = LabelImage(Input=pack)
    automatic.UpdateVTKObjects()
    automatic.SMProxy.UpdatePropertyInformation()
    said = automatic.GetProperty('AutomaticValues').GetData()
    size = field(fetch(automatic), 'VoxelSize')[0]
    assert said.startswith('Voxel Size %.6g, Dimensions ' % size), (said, size)


def files():
    """What is written opens again with the same numbers, and has the same bytes on any number of ranks."""
    image = LabelImage(Input=make_pack(BoxPeriodic=[1, 1, 1]), Dimensions=[13, 8, 5], ParticleIds=1)
    image.UpdatePipeline()
    for name, settings in (('a_%d.mha', {}), ('a_%d.raw', {'Values': '0=1; 1-2=0'}), ('b_%d.raw', {'ImageArray': 'ParticleId', 'ByteOrder': 'Big Endian'})):
        SaveData(path(name % RANKS), proxy=image, **settings)
        with open(path(name % RANKS), 'rb') as file:
            content = file.read()
        remember(name, [hashlib.sha256(content).hexdigest()])
    meta = OpenDataFile(path('a_%d.mha' % RANKS))
    meta.UpdatePipeline()
    info = meta.GetDataInformation()
    assert info.GetExtent() == (0, 12, 0, 7, 0, 4), info.GetExtent()
    # Each is the centre of its voxel
    assert all(abs(a - b) < 1e-9 for a, b in zip(info.GetBounds()[::2], (5 / 13, 5 / 8, 1))), info.GetBounds()
    servermanager.writers.RawImageWriter(Input=image, FileName=path('a_%d.vtk' % RANKS)).UpdatePipeline()
    legacy = OpenDataFile(path('a_%d.vtk' % RANKS))
    legacy.UpdatePipeline()
    assert legacy.GetDataInformation().GetNumberOfCells() == 13 * 8 * 5
    if RANKS == 1:
        expected = numbers(fetch(image), 'Phase')
        assert numbers(fetch(legacy), 'Phase') == expected
        with open(path('a_%d.raw' % RANKS), 'rb') as file:
            assert list(file.read()) == [1 if phase == 0 else 0 for phase in expected]


def tiff(page):
    """A page of bytes as a file without compression."""
    tags = [(256, 3, N), (257, 3, N), (258, 3, 8), (259, 3, 1), (262, 3, 1), (273, 4, 8), (277, 3, 1), (278, 3, N), (279, 4, len(page))]
    page += b'\0' * (len(page) % 2)
    directory = struct.pack('<H', len(tags)) + b''.join(struct.pack('<HHII', tag, kind, 1, value) for tag, kind, value in tags)
    return b'II*\0' + struct.pack('<I', 8 + len(page)) + page + directory + struct.pack('<I', 0)


def write_masks():
    """The same mask, a block of points with the label 7, as files of every kind."""
    inside = bytes(7 if 3 <= x < 9 and 2 <= y < 8 and 3 <= z < 8 else 0 for z in range(N) for y in range(N) for x in range(N))
    data, array = vtkImageData(), vtkUnsignedCharArray()
    data.SetDimensions(N, N, N)
    array.SetName('Mask')
    for value in inside:
        array.InsertNextValue(value)
    data.GetPointData().SetScalars(array)
    source = TrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    SaveData(path('mask.vti'), proxy=source, DataMode='Binary')
    SaveData(path('mask.pvti'), proxy=source, DataMode='Binary')
    SaveData(path('mask.xmf'), proxy=source)
    SaveData(path('pages.tiff'), proxy=source)
    servermanager.writers.RawImageWriter(Input=source, FileName=path('mask.mhd')).UpdatePipeline()
    servermanager.writers.RawImageWriter(Input=source, FileName=path('mask.mha')).UpdatePipeline()
    with open(path('mask.nrrd'), 'wb') as file:
        file.write(b'NRRD0004\ntype: uint8\ndimension: 3\nsizes: 11 11 11\nspacings: 1 1 1\nencoding: raw\n\n' + inside)
    for z in range(N):
        with open(path('slice_%02d.tif' % z), 'wb') as file:
            file.write(tiff(inside[N * N * z:N * N * (z + 1)]))


def masks():
    """Masks of every kind of file give the same numbers. ParaView 5.11 reads an NRRD packed by gzip wrongly on several ranks, and an XDMF whose
    name has no folder not at all; these are not tried."""
    if RANKS == 1:
        write_masks()
    pack = make_pack()
    readers = {name: OpenDataFile(path(name)) for name in ('mask.vti', 'mask.pvti', 'mask.xmf', 'pages.tiff', 'mask.mhd', 'mask.mha', 'mask.nrrd')}
    readers['stack of TIFF'] = TIFFSeriesReader(FileNames=[path('slice_%02d.tif' % z) for z in range(N)], ReadAsImageStack=1)
    readers['raw'] = ImageReader(FileNames=[path('mask.raw')], DataScalarType='unsigned char')
    if 'Dimensions' in readers['raw'].ListProperties():  # since ParaView 6.1
        readers['raw'].Dimensions = [N] * 3
    else:
        readers['raw'].DataExtent = [0, N - 1] * 3
    fractions = {}
    for name, reader in readers.items():
        table = OnePointProbability(Input=pack, Mask=reader, MaskLabel=7, Method='Chord Sampling', NumberOfLines=200, WindowMargin=0.5)
        fractions[name] = columns(table)['VolumeFraction']
        print('  %s by %s: %r' % (name, reader.SMProxy.GetXMLName(), fractions[name][-1]), flush=True)
        assert fractions[name] == fractions['mask.vti'], (name, fractions)
        Delete(table)
    remember('fractions in the mask', fractions['mask.vti'])


os.makedirs(FOLDER, exist_ok=True)
run((labels, files, masks), sys.argv[2])
