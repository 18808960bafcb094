# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""A pack in blocks, however many and on whatever ranks, gives the numbers of the pack in one piece; ghosts are no spheres."""
import math
import os
import sys

from paraview import servermanager
from paraview.simple import *
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLMultiBlockDataWriter, vtkXMLPolyDataWriter

ranks = servermanager.ActiveConnection.GetNumberOfDataPartitions()
folder = os.path.join(sys.argv[1], 'composite_%d' % ranks)
os.makedirs(folder, exist_ok=True)
box = 9.0
spheres = [(1.5 * i + 0.1 * (j % 2), 1.5 * j, 1.5 * k + 0.05 * i, 0.4 + 0.1 * ((i + j + k) % 3))
           for i in range(6) for j in range(6) for k in range(6)]


def piece(spheres, edge=box, ghosts=None, name='Radius'):
    points, radius, data = vtkPoints(), vtkDoubleArray(), vtkPolyData()
    points.SetDataTypeToDouble()
    radius.SetName(name)
    for sphere in spheres:
        points.InsertNextPoint(sphere[:3])
        radius.InsertNextValue(sphere[3])
    data.SetPoints(points)
    data.GetPointData().AddArray(radius)
    if ghosts:
        types = vtkUnsignedCharArray()
        types.SetName('vtkGhostType')
        for ghost in ghosts:
            types.InsertNextValue(ghost)
        data.GetPointData().AddArray(types)
    for name, values in (('BoxSize', [edge] * 3), ('BoxPeriodic', [1, 1, 1])):
        array = vtkDoubleArray()
        array.SetName(name)
        for value in values:
            array.InsertNextValue(value)
        data.GetFieldData().AddArray(array)
    return data


def write(writer, name, data):
    writer.SetDataModeToBinary()  # ParaView 5.11 does not read appended data with newer expat libraries
    writer.SetInputData(data)
    writer.SetFileName(os.path.join(folder, name))
    assert writer.Write()
    return writer.GetFileName()


def blocks(number):
    return [piece(spheres[n::number]) for n in range(number)]


def multiblock(number):
    """The blocks in a tree of two levels, beside an empty block and one that is not there."""
    whole, inner = vtkMultiBlockDataSet(), vtkMultiBlockDataSet()
    for n, block in enumerate(blocks(number)):
        inner.SetBlock(n, block)
    whole.SetBlock(0, vtkPolyData())
    whole.SetBlock(2, inner)
    return XMLMultiBlockDataReader(FileName=[write(vtkXMLMultiBlockDataWriter(), 'blocks_%d.vtm' % number, whole)])


def collection(number):
    """The blocks as the pieces, two each, of a collection."""
    text = '<VTKFile type="vtkPartitionedDataSetCollection" version="1.0"><vtkPartitionedDataSetCollection>'
    for n, block in enumerate(blocks(number)):
        file = os.path.basename(write(vtkXMLPolyDataWriter(), 'part_%d_%d.vtp' % (number, n), block))
        text += ('<Partitions index="%d">' % (n // 2) if n % 2 == 0 else '') + '<DataSet index="%d" file="%s"/>' % (n % 2, file)
        text += '</Partitions>' if n % 2 == 1 or n == number - 1 else ''
    path = os.path.join(folder, 'parts_%d.vtpc' % number)
    with open(path, 'w') as out:
        out.write(text + '</vtkPartitionedDataSetCollection></VTKFile>')
    return XMLPartitionedDatasetCollectionReader(FileName=[path])


def single(name, data):
    return XMLPolyDataReader(FileName=[write(vtkXMLPolyDataWriter(), name, data)])


def grouped(number):
    return GroupDatasets(Input=[single('group_%d_%d.vtp' % (number, n), block) for n, block in enumerate(blocks(number))])


def columns(source, port=0):
    table = servermanager.Fetch(source, idx=port)
    assert table.GetClassName() == 'vtkTable', table.GetClassName()
    return {table.GetColumnName(c): [table.GetColumn(c).GetValue(row) for row in range(table.GetNumberOfRows())]
            for c in range(table.GetNumberOfColumns())}


def centres(source):
    data = servermanager.Fetch(source)
    assert data.GetClassName() == 'vtkPolyData', data.GetClassName()
    return sorted(data.GetPoint(i) for i in range(data.GetNumberOfPoints()))


def measure(source):
    modes = ParticleModes(Input=source, NumberOfModes=2)
    cell = UnitCellReconstruction(Input=modes, NumberOfParticles=42, NumberOfLags=20, MaximumIterations=3)
    numbers = [centres(modes), columns(modes, 1), columns(OnePointProbability(Input=modes)),
               columns(TwoPointProbability(Input=modes, MaximumLag=3, NumberOfLags=12)),
               centres(PeriodicReplicas(Input=source)), centres(cell)]
    assert len(numbers[0]) == len(spheres) and len(numbers[5]) == 42
    return numbers


expected = measure(single('whole.vtp', piece(spheres)))
fraction = sum(4 / 3 * math.pi * sphere[3] ** 3 for sphere in spheres) / box ** 3
assert abs(sum(expected[1]['VolumeFraction']) - fraction) < 1e-12
for make, numbers in ((multiblock, (1, 5)), (collection, (3,)), (grouped, (2,))):
    for number in numbers:
        assert measure(make(number)) == expected, (make.__name__, number)
    print(make.__name__, 'passed', flush=True)

# The filters that the modes do not stand before, and the estimate, which knows the pack from its blocks
modes = [ParticleModes(Input=single('mode_%d.vtp' % n, block), NumberOfModes=1) for n, block in enumerate(blocks(3))]
group = GroupDatasets(Input=modes)
whole = ParticleModes(Input=single('whole.vtp', piece(spheres)), NumberOfModes=1)
tables = [columns(TwoPointProbability(Input=source, MaximumLag=3, NumberOfLags=12)) for source in (group, whole)]
assert tables[0] == tables[1] and len(tables[0]['r']) == 13
if ranks == 1:
    times = []
    for source in (group, whole):
        probability = TwoPointProbability(Input=source, MaximumLag=3, NumberOfLags=12)
        source.UpdatePipeline()
        probability.UpdateVTKObjects()
        probability.SMProxy.UpdatePropertyInformation()
        times.append(probability.GetProperty('EstimatedTime')[0])
    assert times[0] > 0 and abs(times[0] / times[1] - 1) < 1e-9, times

# Duplicate points (1) and hidden ones (2) are no spheres; other marks (8) say nothing of them
twice = piece(spheres + spheres[:9] + [(4.0, 4.0, 4.0, 99.0)], ghosts=[8] * len(spheres) + [1] * 9 + [2])
assert measure(single('ghosts.vtp', twice)) == expected
halves = vtkMultiBlockDataSet()
halves.SetBlock(0, piece(spheres[:100] + spheres[100:120], ghosts=[0] * 100 + [1] * 20))
halves.SetBlock(1, piece(spheres[100:] + spheres[:7], ghosts=[0] * (len(spheres) - 100) + [1] * 7))
assert measure(XMLMultiBlockDataReader(
    FileName=[write(vtkXMLMultiBlockDataWriter(), 'halves.vtm', halves)])) == expected
assert not servermanager.Fetch(ParticleModes(Input=single('ghosts.vtp', twice))).GetPointData().HasArray('vtkGhostType')
print('ghosts passed', flush=True)

# The same with an array of another name
assert measure(PointsToSpherePack(Input=single('others.vtp', piece(
    spheres + spheres[:9] + [(4.0, 4.0, 4.0, 99.0)], ghosts=[8] * len(spheres) + [1] * 9 + [2], name='radii')))) == expected
for n, part in enumerate((spheres[:100], spheres[100:])):
    halves.SetBlock(n, piece([(x, y, z, 2 * r) for x, y, z, r in part], name='Diameter'))
assert measure(PointsToSpherePack(Input=XMLMultiBlockDataReader(
    FileName=[write(vtkXMLMultiBlockDataWriter(), 'diameters.vtm', halves)]))) == expected
print('names passed', flush=True)

# Two packs are not one: all filters refuse blocks with different windows
other = GroupDatasets(Input=[single('pack_%d.vtp' % edge, piece(spheres, edge)) for edge in (9, 10)])
refused = ParticleModes(Input=other, NumberOfModes=1)
refused.UpdatePipeline()
assert refused.GetDataInformation().GetNumberOfPoints() == 0
print('windows passed', flush=True)
