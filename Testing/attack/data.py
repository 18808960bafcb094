# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""The hostile data sets, by kind of input: PACKS, IMAGES, TABLES, each {name: function(rank, ranks) -> data object}. 'good' is not hostile.

Every rank runs this inside a Programmable Source, so nothing here may import ParaView's client.
"""
import math

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import VTK_DOUBLE, VTK_FLOAT, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import (vtkImageData, vtkMultiBlockDataSet, vtkPolyData, vtkRectilinearGrid, vtkStructuredGrid, vtkTable,
                                           vtkUnstructuredGrid)
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline

EDGE = 10.0
BOX = {'BoxOrigin': [0.0, 0.0, 0.0], 'BoxSize': [EDGE] * 3, 'BoxPeriodic': [1, 1, 1]}
CYLINDER = {'CylinderBase': [5.0, 5.0, 0.0], 'CylinderAxis': [0.0, 0.0, 1.0], 'CylinderRadius': [8.0], 'CylinderHeight': [EDGE]}


def array(name, values):
    """A VTK array, of text where the values are text."""
    if isinstance(values, list) and values and isinstance(values[0], str):
        made = vtkStringArray()
        for value in values:
            made.InsertNextValue(value)
    else:
        made = numpy_to_vtk(numpy.ascontiguousarray(values), deep=1)
    made.SetName(name)
    return made


def lattice():
    """64 spheres of two modes, not quite on a lattice, which do not overlap."""
    n = numpy.arange(64)
    place = numpy.stack([n % 4, n // 4 % 4, n // 16], axis=1)
    shift = 0.2 * numpy.sin(numpy.stack([3.0 * n, 5.0 * n, 7.0 * n], axis=1))
    return {'points': (place + 0.5) * EDGE / 4 + shift, 'Radius': numpy.where(n % 3 == 0, 1.0, 0.8), 'Mode': numpy.where(n % 3 == 0, 2, 1),
            'Id': n, 'field': BOX}


def build(pack, rank, ranks, point_set=vtkPolyData, precision=VTK_DOUBLE):
    """The share of a pack that a rank gets. Too short an array is given whole, so that it is too short on every rank; what a longer one has
    beyond the points stands behind every share."""
    count = len(pack['points'])
    share = slice(rank * count // ranks, (rank + 1) * count // ranks)
    data, points = point_set(), vtkPoints()
    points.SetDataType(precision)
    for point in pack['points'][share]:
        points.InsertNextPoint(*point)
    data.SetPoints(points)
    if point_set is vtkStructuredGrid:
        data.SetDimensions(points.GetNumberOfPoints(), 1, 1)
    for name, values in pack.items():
        if name not in ('points', 'field'):
            if len(values) == count:
                values = values[share]
            elif len(values) > count:
                values = numpy.concatenate([values[share], values[count:]])
            data.GetPointData().AddArray(array(name, values))
    for name, values in pack['field'].items():
        data.GetFieldData().AddArray(array(name, values))
    return data


def pack(**changes):
    """A data set that differs from the good one by these arrays, or functions of the good one's; None leaves an array out."""
    def make(rank, ranks):
        made = lattice()
        for name, change in changes.items():
            made[name] = change(made[name]) if callable(change) else change
        return build({name: values for name, values in made.items() if values is not None}, rank, ranks)
    return make


def cut(count):
    """Keeps only the first spheres."""
    def make(rank, ranks):
        return build({name: values if name == 'field' else values[:count] for name, values in lattice().items()}, rank, ranks)
    return make


def first(value, axis=None):
    """Sets the first entry, along one axis for points."""
    def change(values):
        changed = numpy.array(values, dtype=float)
        changed[0 if axis is None else (0, axis)] = value
        return changed
    return change


def window(**changes):
    return pack(field={**BOX, **changes})


def blocks(*makes):
    def make(rank, ranks):
        data = vtkMultiBlockDataSet()
        for i, block in enumerate(makes):
            data.SetBlock(i, block and block(rank, ranks))
        return data
    return make


def flat(values):
    return values * [1.0, 1.0, 0.0]


def rectilinear(rank, ranks):
    data = vtkRectilinearGrid()
    data.SetDimensions(2, 2, 2)
    for set_coordinates in (data.SetXCoordinates, data.SetYCoordinates, data.SetZCoordinates):
        set_coordinates(array('c', [0.0, 1.0]))
    data.GetPointData().AddArray(array('Radius', [0.1] * 8))
    return data


def image(size=8, values=None, origin=(0.0, 0.0, 0.0), spacing=None, direction=None, on_cells=False, name='mask'):
    """Points of an image over the box with values of 1; the same on every rank, of which the pipeline takes pieces."""
    size = (size,) * 3 if isinstance(size, int) else size

    def make(rank, ranks):
        data = vtkImageData()
        data.SetDimensions(size)
        data.SetOrigin(origin)
        data.SetSpacing(spacing or [EDGE / max(1, n) for n in size])
        if direction:
            data.SetDirectionMatrix(direction)
        attributes, count = ((data.GetCellData(), data.GetNumberOfCells()) if on_cells else (data.GetPointData(), data.GetNumberOfPoints()))
        if name:
            attributes.AddArray(array(name, numpy.ones(count) if values is None else values(count) if callable(values) else values))
        return data
    return make


def table(rows=11, **changes):
    """S_rs of one mode and the matrix on equal lags."""
    def make(rank, ranks):
        r = numpy.arange(rows) * 0.5
        decay = 0.21 * numpy.exp(-r)
        columns = {'r': r, 'S_1_1': 0.09 + decay, 'S_1_m': 0.21 - decay, 'S_m_1': 0.21 - decay, 'S_m_m': 0.49 + decay}
        data = vtkTable()
        for name, values in {**columns, **changes}.items():
            if values is not None and rank == 0:
                data.GetRowData().AddArray(array(name, values(columns[name]) if callable(values) else values))
        return data
    return make


PACKS = {
    'good': pack(),
    'nothing at all': lambda rank, ranks: vtkPolyData(),
    'no points': cut(0),
    'one point': cut(1),
    'two points': cut(2),
    'without window': pack(field={}),
    'coincident points': pack(points=lambda p: 0.0 * p + 5.0),
    'coincident points, without window': pack(points=lambda p: 0.0 * p + 5.0, field={}),
    'NaN coordinate': pack(points=first(math.nan, 0)),
    'infinite coordinate': pack(points=first(math.inf, 1)),
    'NaN coordinate, without window': pack(points=first(math.nan, 0), field={}),
    'infinite coordinate, without window': pack(points=first(-math.inf, 2), field={}),
    'outlier at 1e7': pack(points=first(1e7, 0), field={}),
    'outlier at 1e300': pack(points=first(1e300, 2), field={}),
    'outlier of a box': pack(points=first(1e7, 0)),
    'scale 1e150': pack(points=lambda p: 1e150 * p, Radius=lambda r: 1e150 * r, field={}),
    'scale 1e-150': pack(points=lambda p: 1e-150 * p, Radius=lambda r: 1e-150 * r, field={}),
    'box of 1e8 along x': window(BoxSize=[1e8, EDGE, EDGE]),
    'offset 1e9': pack(points=lambda p: p + 1e9, field={**BOX, 'BoxOrigin': [1e9] * 3}),
    'monolayer': pack(points=lambda p: p * [1.0, 1.0, 1e-3], field={}),
    'plane': pack(points=flat, field={}),
    'line': pack(points=lambda p: p * [1.0, 0.0, 0.0], field={}),
    'short Radius': pack(Radius=lambda a: a[:1]),
    'short Mode': pack(Mode=lambda a: a[:1]),
    'short Id': pack(Id=lambda a: a[:1]),
    'long Radius': pack(Radius=lambda a: numpy.concatenate([a, a])),
    'empty Radius': pack(Radius=lambda a: a[:0]),
    'no Radius': pack(Radius=None),
    'no Mode': pack(Mode=None),
    'Radius of text': pack(Radius=['wide'] * 64),
    'Mode of text': pack(Mode=['one'] * 64),
    'Id of text': pack(Id=['a'] * 64),
    'Radius of 3 components': pack(Radius=lambda a: numpy.stack([a, a, a], axis=1)),
    'Mode of 300 components': pack(Mode=lambda a: numpy.repeat(a[:, None], 300, axis=1)),
    'Radius of huge integers': pack(Radius=lambda a: numpy.full(64, 2**62)),
    'Radius 0': pack(Radius=first(0.0)),
    'Radius negative': pack(Radius=first(-1.0)),
    'Radius NaN': pack(Radius=first(math.nan)),
    'Radius infinite': pack(Radius=first(math.inf)),
    'Radius 1e300': pack(Radius=first(1e300)),
    'Radius 1e-300': pack(Radius=first(1e-300)),
    'Radius ratio 1e6': pack(Radius=lambda a: numpy.where(numpy.arange(64) == 0, 1.0, 1e-6)),
    'Radius of float': pack(Radius=lambda a: a.astype(numpy.float32)),
    'one large sphere': pack(Radius=first(4.0)),
    'heavy overlap': pack(Radius=lambda a: 4.0 * a),
    'Mode with gaps': pack(Mode=lambda a: numpy.where(a == 1, 1, 1000000)),
    'Mode 2^31-1': pack(Mode=lambda a: numpy.where(a == 1, 1, 2**31 - 1)),
    'Mode 2^62': pack(Mode=lambda a: numpy.where(a == 1, 1, 2**62)),
    'Mode negative': pack(Mode=lambda a: -a),
    'Mode 0': pack(Mode=lambda a: a - 1),
    'Mode 1.5': pack(Mode=lambda a: a + 0.5),
    'Mode NaN': pack(Mode=first(math.nan)),
    'a mode a sphere': pack(Mode=lambda a: 1 + numpy.arange(64)),
    '216 modes': pack(points=lambda p: numpy.array([(x + 0.5, y + 0.5, z + 0.5) for x in range(6) for y in range(6) for z in range(6)]),
                      Radius=0.3 + 1e-4 * numpy.arange(216), Mode=1 + numpy.arange(216), Id=numpy.arange(216),
                      field={**BOX, 'BoxSize': [6.0] * 3}),
    'equal Ids': pack(Id=lambda a: 0 * a),
    'Id 2^62': pack(Id=lambda a: a + 2**62),
    'ghost points': pack(vtkGhostType=(numpy.arange(64) % 2).astype(numpy.uint8)),
    'hidden points': pack(vtkGhostType=(numpy.arange(64) % 2 * 2).astype(numpy.uint8)),
    'only ghosts': pack(vtkGhostType=numpy.ones(64, dtype=numpy.uint8)),
    'box of 0': window(BoxSize=[0.0, EDGE, EDGE]),
    'box negative': window(BoxSize=[-EDGE, EDGE, EDGE]),
    'box NaN': window(BoxSize=[math.nan, EDGE, EDGE]),
    'box 1e300': window(BoxSize=[1e300] * 3),
    'box 1e-300': window(BoxSize=[1e-300] * 3),
    'box of 2 numbers': window(BoxSize=[EDGE, EDGE]),
    'box of text': window(BoxSize=['wide', 'deep', 'high']),
    'box without origin': pack(field={'BoxSize': [EDGE] * 3}),
    'box origin NaN': window(BoxOrigin=[math.nan] * 3),
    'box periodic 7': window(BoxPeriodic=[7, -1, 2**31 - 1]),
    'box in part periodic': window(BoxPeriodic=[1, 0, 0]),
    'box and cylinder': window(**CYLINDER),
    'cylinder': pack(field=CYLINDER),
    'cylinder without height': pack(field={'CylinderRadius': [8.0]}),
    'cylinder axis 0': pack(field={**CYLINDER, 'CylinderAxis': [0.0, 0.0, 0.0]}),
    'cylinder axis 1e-300': pack(field={**CYLINDER, 'CylinderAxis': [0.0, 0.0, 1e-300]}),
    'cylinder 1e300': pack(field={**CYLINDER, 'CylinderRadius': [1e300], 'CylinderHeight': [1e300]}),
    'float points': lambda rank, ranks: build(lattice(), rank, ranks, precision=VTK_FLOAT),
    'unstructured grid': lambda rank, ranks: build(lattice(), rank, ranks, vtkUnstructuredGrid),
    'structured grid': lambda rank, ranks: build(lattice(), rank, ranks, vtkStructuredGrid),
    'rectilinear grid': rectilinear,
    'blocks': blocks(pack(), pack()),
    'blocks of which one is null': blocks(None, pack(), None),
    'blocks, all null': blocks(None, None),
    'blocks of two kinds': blocks(pack(), table()),
}
IMAGES = {
    'good': image(values=lambda n: (numpy.arange(n) < n - 1).astype(float)),  # a mask with a voxel outside; two labels
    'good particle': image(size=13, values=lambda n: (((numpy.indices((13, 13, 13)) - 6) ** 2).sum(axis=0).ravel() < 20).astype(float)),
    'values on cells': image(on_cells=True),
    'dimensions 0': image(size=0),
    'one voxel': image(size=1),
    'one slice': image(size=(8, 8, 1)),
    'one row': image(size=(8, 1, 1)),
    'nothing inside': image(values=lambda n: numpy.zeros(n)),
    'NaN values': image(values=lambda n: numpy.full(n, math.nan)),
    'infinite values': image(values=lambda n: numpy.full(n, math.inf)),
    'values 2^62': image(values=lambda n: numpy.full(n, 2**62)),
    'values of text': image(values=lambda n: ['in'] * n),
    'values of 3 components': image(values=lambda n: numpy.ones((n, 3))),
    'short array': image(values=lambda n: numpy.ones(1)),
    'empty array': image(values=lambda n: numpy.ones(0)),
    'no array': image(name=None),
    'array named S_1_1': image(name='S_1_1'),
    'spacing 0': image(spacing=(0.0, 1.0, 1.0)),
    'spacing negative': image(spacing=(-1.25, 1.25, 1.25)),
    'spacing NaN': image(spacing=(math.nan, 1.0, 1.0)),
    'spacing 1e-300': image(spacing=(1e-300,) * 3),
    'spacing 1e300': image(spacing=(1e300,) * 3),
    'origin NaN': image(origin=(math.nan, 0.0, 0.0)),
    'far away': image(origin=(1e9, 0.0, 0.0)),
    'axes turned': image(direction=(0, 1, 0, -1, 0, 0, 0, 0, 1)),
    'axes mirrored': image(direction=(-1, 0, 0, 0, 1, 0, 0, 0, 1)),
    'axes of 0': image(direction=(0, 0, 0, 0, 0, 0, 0, 0, 0)),
    'checkerboard': image(values=lambda n: numpy.arange(n) % 2),
}
TABLES = {
    'good': table(),
    'nothing at all': lambda rank, ranks: vtkTable(),
    'no rows': table(rows=0),
    'one row': table(rows=1),
    'lags only': table(S_1_1=None, S_1_m=None, S_m_1=None, S_m_m=None),
    'no lags': table(r=None),
    'a function missing': table(S_1_m=None),
    'NaN value': table(S_1_1=first(math.nan)),
    'infinite value': table(S_m_m=first(math.inf)),
    'values 1e300': table(S_1_1=lambda s: s + 1e300),
    'fraction above 1': table(S_1_1=lambda s: s + 3.0),
    'NaN lag': table(r=first(math.nan)),
    'lags descending': table(r=lambda r: r[::-1].copy()),
    'lags of 0': table(r=lambda r: 0.0 * r),
    'lags of text': table(r=['near'] * 11),
    'values of text': table(S_1_1=['rare'] * 11),
    'short column': table(S_m_m=lambda s: s[:1]),
    'column of 3 components': table(S_1_1=lambda s: numpy.stack([s, s, s], axis=1)),
    'mode 2^31-1': table(S_2147483647_2147483647=numpy.zeros(11)),
    'strange name': table(**{'S__': numpy.zeros(11), 'S_1': numpy.zeros(11), 'S_1_1_1': numpy.zeros(11)}),
}
KINDS = {'pack': PACKS, 'image': IMAGES, 'table': TABLES}
for kind, sets in KINDS.items():  # what is good as one kind has the wrong type as another
    for other, others in list(KINDS.items()):
        if other != kind:
            sets['a good ' + other] = others['good']


def fill(algorithm, kind, name, rank, ranks):
    """Gives the data in the script of a Programmable Source. Of an image a rank gives the piece that it is asked for, if VTK itself can cut it."""
    made = KINDS[kind][name](rank, ranks)
    asked = algorithm.GetOutputInformation(0).Get(vtkStreamingDemandDrivenPipeline.UPDATE_EXTENT())
    if ranks > 1 and made.IsA('vtkImageData') and made.GetNumberOfCells() > 0 and all(
            attributes.GetAbstractArray(i).GetNumberOfTuples() == count
            for attributes, count in ((made.GetPointData(), made.GetNumberOfPoints()), (made.GetCellData(), made.GetNumberOfCells()))
            for i in range(attributes.GetNumberOfArrays())):
        made.Crop(asked)
    algorithm.GetOutputDataObject(0).ShallowCopy(made)


def inform(algorithm, kind, name):
    """Gives the extent in its script of information."""
    made = KINDS[kind][name](0, 1)
    if made.IsA('vtkImageData') or made.IsA('vtkRectilinearGrid') or made.IsA('vtkStructuredGrid'):
        algorithm.GetOutputInformation(0).Set(vtkStreamingDemandDrivenPipeline.WHOLE_EXTENT(), made.GetExtent(), 6)
