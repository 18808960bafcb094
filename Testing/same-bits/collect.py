# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Collects every bit that the filters give, of pipelines like those of the examples and with every option, for `run` beside this file.

    mpirun -np 3 pvbatch --symmetric collect.py FOLDER [GROUP ...]

Every rank runs this script and writes FOLDER/rank<N>.pickle with its own piece of every output, as {(output, part): (kind, bytes or
texts)}. Outputs have names of what they are, not of the filter and its port, so that versions of the plugin in which other filters give
them can be compared: up to commit 8d5a1f8 Two-Point Probability gave what five filters give now.
"""
import itertools
import math
import os
import pickle
import sys
import time
import traceback

from paraview import simple
from paraview.simple import *
from vtkmodules.vtkIOGeometry import vtkSTLWriter
from vtkmodules.vtkParallelCore import vtkMultiProcessController

HERE = os.path.dirname(os.path.abspath(__file__))
BEADS = os.path.join(HERE, '../../Examples/Data/bead_block.csv')
BEADS_BOX = [1445.372, 1287.892, 789.106]
SETTLED = os.path.join(HERE, '../Data/settled_cylinder.csv')
RANK = vtkMultiProcessController.GetGlobalController().GetLocalProcessId()
CHORDS, TEMPLATE = {'Method': 'Chord Sampling'}, {'Method': 'Template Sampling'}
SPLIT = hasattr(simple, 'DirectionalProbability')  # Two-Point Probability is five filters
LAGS = {'MaximumLag': 200, 'NumberOfLags': 277}
FEW_LAGS = {'MaximumLag': 2.0, 'NumberOfLags': 20}  # for the lattice, whose edge is 9
ENTRIES = {}


# ---- What is written down ----


def add(output, part, kind, content):
    assert (output, part) not in ENTRIES, (output, part)
    ENTRIES[output, part] = kind, content


def add_array(output, part, array):
    """Numbers as bytes, with their type and components."""
    if array.IsNumeric():
        size = array.GetNumberOfValues()
        add(output, part, f'{array.GetDataTypeAsString()} x {array.GetNumberOfComponents()}', bytes(memoryview(array)) if size else b'')
    else:
        add(output, part, array.GetClassName(), [array.GetValue(i) for i in range(array.GetNumberOfValues())])


def add_arrays(output, kind, arrays):
    for i in range(arrays.GetNumberOfArrays()):
        array = arrays.GetAbstractArray(i)
        add_array(output, f'{kind} {array.GetName()}', array)


def add_data(output, data):
    """Everything that a data object holds; the order of columns counts, that of field data does not."""
    add(output, 'class', 'text', [data.GetClassName()])
    add_arrays(output, 'field', data.GetFieldData())
    if data.IsA('vtkMultiBlockDataSet'):
        for n in range(data.GetNumberOfBlocks()):
            block = data.GetBlock(n)
            name = data.GetMetaData(n).Get(data.NAME()) if data.HasMetaData(n) else ''
            add(f'{output} / block {n}', 'name', 'text', [str(name), 'empty' if block is None else 'filled'])
            if block is not None:
                add_data(f'{output} / block {n}', block)
        return
    kinds = {'row': data.GetRowData()} if data.IsA('vtkTable') else {'point': data.GetPointData(), 'cell': data.GetCellData()}
    for kind, arrays in kinds.items():
        add(output, f'order of {kind} arrays', 'text', [arrays.GetArrayName(i) for i in range(arrays.GetNumberOfArrays())])
        active = arrays.GetScalars()
        add(output, f'active {kind} scalars', 'text', [active.GetName() if active else ''])
        add_arrays(output, kind, arrays)
    if data.IsA('vtkImageData'):
        add(output, 'extent', 'text', [str(data.GetExtent())])
        add(output, 'grid', 'text', [x.hex() for x in (*data.GetSpacing(), *data.GetOrigin())])
    elif data.IsA('vtkPolyData'):
        if data.GetPoints():
            add_array(output, 'points', data.GetPoints().GetData())
        for kind in ('Verts', 'Lines', 'Polys', 'Strips'):
            cells = getattr(data, 'Get' + kind)()
            add_array(output, kind + ' connectivity', cells.GetConnectivityArray())
            add_array(output, kind + ' offsets', cells.GetOffsetsArray())


def collect(name, source, outputs):
    """Updates a filter and writes its outputs down: {port: name of the output}."""
    source.UpdatePipeline()
    local = source.GetClientSideObject()
    for port, output in outputs.items():
        add_data(f'{name}: {output}', local.GetOutputDataObject(port))
    return source


# ---- The filters, whatever version they are of ----


def read_pack(name, **settings):
    return collect(name, SpherePackReader(**settings), {0: 'spheres'})


def sort_modes(name, pack, **settings):
    return collect(name, ParticleModes(Input=pack, **settings), {0: 'pack', 1: 'modes'})


def one_point(name, pack, **settings):
    return collect(name, OnePointProbability(Input=pack, **settings), {0: 'one-point'})


def two_point(name, pack, **settings):
    source = TwoPointProbability(Input=pack, **settings, **({} if SPLIT else {'Autocovariance': 1}))
    return collect(name, source, {0: 'two-point', 1: 'two-point checks', 2: 'gradients', 3 if SPLIT else 8: 'autocovariance'})


def directions(name, pack, **settings):
    source = DirectionalProbability(Input=pack, **settings) if SPLIT else TwoPointProbability(Input=pack, **settings)
    return collect(name, source, {0: 'isotropy', 1: 'directions'} if SPLIT else {4: 'isotropy', 5: 'directions'})


def phase_map(name, pack, pairs, resolution, maximum_lag, spacing=0.0):
    settings = {'Input': pack, 'MaximumLag': maximum_lag}
    source = (ProbabilityMap(PhasePairs=pairs, Resolution=resolution, Spacing=spacing, **settings) if SPLIT else
              TwoPointProbability(ImagePairs=pairs, ImageResolution=resolution, ImageSpacing=spacing, **settings))
    return collect(name, source, {0 if SPLIT else 3: 'map'})


def chord_lengths(name, pack, **settings):
    source = (simple.ChordLengths(Input=pack, **settings) if SPLIT else
              TwoPointProbability(Input=pack, ChordLengths=1, **CHORDS, **settings))
    return collect(name, source, {0 if SPLIT else 6: 'chord lengths'})


def radial_distribution(name, pack, **settings):
    source = (simple.RadialDistribution(Input=pack, **settings) if SPLIT else
              TwoPointProbability(Input=pack, RadialDistribution=1, **settings))
    return collect(name, source, {0 if SPLIT else 7: 'radial distribution'})


def three_point(name, pack, **settings):
    outputs = {0: 'three-point', 1: 'three-point limits', 2: 'three-point checks'}
    triples = settings['Phases'].split(';')
    if settings['Phases'] == 'all' or any(len(set(triple.split())) == 1 for triple in triples):
        outputs[3] = 'third-order parameters'
    return collect(name, ThreePointProbability(Input=pack, **settings), outputs)


def compare(name, pack, cells, images=False):
    outputs = {0: 'comparison', **({2: 'differences'} if images else {1: 'curves'})}
    return collect(name, CompareProbabilities(Input=pack, Cell=cells), outputs)


def reconstruct(name, pack, **settings):
    outputs = {0: 'cell', 1: 'convergence', 2: 'two-point of pack and cell', 3: 'all cells', 4: 'table of cells', 5: 'comparison of cells'}
    return collect(name, UnitCellReconstruction(Input=pack, **settings), outputs)


def replicate(name, pack, clip=False, **settings):
    outputs = {0: 'copies', 1: 'outline', **({2: 'surfaces'} if clip else {})}
    return collect(name, PeriodicReplicas(Input=pack, ClipToBox=int(clip), **settings), outputs)


# ---- Packs ----


def beads(method='Equal Width', modes=9):
    reader = SpherePackReader(FileName=BEADS, LengthUnit='µm', BoxSize=BEADS_BOX)
    return ParticleModes(Input=reader, Method=method, NumberOfModes=modes)


def file_of_rank(name):
    return os.path.join(FOLDER, name)


def write_spheres(name, rows, header='x,y,z,radius', separator=','):
    with open(file_of_rank(name), 'w') as file:
        file.write(header + '\n' if header else '')
        file.writelines(separator.join(f'{x:.17g}' for x in row) + '\n' for row in rows)
    return file_of_rank(name)


def lattice(sizes=2, radius=0.41, jitter=0.11):
    """A jittered lattice of 729 spheres, which have two sizes or each its own."""
    for n, (x, y, z) in enumerate(itertools.product(range(9), repeat=3)):
        moved = [jitter * math.sin(12.9898 * n + 78.233 * q) for q in range(3)]
        size = (radius if n % 3 else radius - 0.05) if sizes == 2 else radius - 0.15 * (n * 0.618034 % 1.0)
        yield x + moved[0], y + moved[1], z + moved[2], size


def lattice_pack(name, periodic=True, windowed=True, modes=None, **options):
    window = {'BoxOrigin': [-0.5] * 3, 'BoxSize': [9.0] * 3, 'BoxPeriodic': [int(periodic)] * 3} if windowed else {}
    reader = SpherePackReader(FileName=write_spheres(name + '.csv', lattice(**options)), LengthUnit='mm', **window)
    return ParticleModes(Input=reader, **(modes or {'Method': 'One Per Size'}))


def spread(name, **options):
    """A pack that is shared out over the ranks, while one that is read lies on the first."""
    return DistributePoints(Input=lattice_pack(name, **options))


MANY = {'sizes': 729, 'modes': {'Method': 'Equal Volume', 'NumberOfModes': 3}}


def table_file(name, source):
    """Writes a table of this rank to a file; the other ranks, which have no rows, write one that no one reads."""
    data = source.GetClientSideObject().GetOutputDataObject(0)
    columns = [data.GetColumn(i) for i in range(data.GetNumberOfColumns())]
    return write_spheres(name, zip(*(map(float, memoryview(c)) for c in columns)) if data.GetNumberOfRows() else [],
                         ','.join(c.GetName() for c in columns))


def mask(extent, function, name='Inside'):
    return Calculator(Input=Wavelet(WholeExtent=extent), Function=function, ResultArrayName=name)


# ---- Groups ----


def packs():
    """Sphere Pack Reader and Particle Modes"""
    whole = read_pack('beads', FileName=BEADS, LengthUnit='µm', BoxSize=BEADS_BOX)
    read_pack('settled', FileName=SETTLED, LengthUnit='µm')
    rows = list(lattice())
    read_pack('no header', FileName=write_spheres('plain.txt', rows, '', ' '), Scale=2.5)
    read_pack('diameters', FileName=write_spheres('diameters.csv', rows, 'x;y;z;diameter', ';'))
    read_pack('named column', FileName=write_spheres('named.csv', rows, 'x,y,z,size'), RadiusColumn='size', RadiusIsDiameter=1)
    with_ids = [(*row, n % 2 + 1, 7 * n) for n, row in enumerate(rows)]
    numbered = read_pack('modes and ids', FileName=write_spheres('numbered.csv', with_ids, '# a line\nx,y,z,r,mode,id'), SkipLines=1)
    images = rows + [(x + 9.0, y, z, r) for x, y, z, r in rows if x < 0.5]
    read_pack('ghosts', FileName=write_spheres('ghosts.csv', images), BoxOrigin=[-0.5] * 3, BoxSize=[9.0] * 3, BoxPeriodic=[1, 1, 0])
    for method, settings in (('Equal Width', {}), ('Equal Volume', {'NumberOfModes': 5}), ('Equal Width', {'NumberOfModes': 40}),
                             ('Explicit Edges', {'Edges': [5.0, 20.0, 30.0, 60.0]}), ('One Per Size', {}),
                             ('Equal Volume', {'MinimumDiameter': 25.0})):
        name = ' '.join([method, *(f'{key} {value}' for key, value in settings.items())])
        sort_modes(f'beads by {name}', whole if method != 'One Per Size' else numbered, Method=method, **settings)
    sort_modes('spread lattice', DistributePoints(Input=numbered), NumberOfModes=2)


def statistics():
    """The bead pack as pack_statistics.py and unit_cell.py take it"""
    pack = beads()
    samples = {'NumberOfLines': 8000, 'NumberOfThrows': 300, 'Seed': 1}
    for method in ('Sphere Volumes', 'Chord Sampling', 'Template Sampling'):
        one_point(f'beads, {method}', pack, Method=method, **samples)
    two_point('beads, exact', pack, **LAGS)
    two_point('beads, chords', pack, **CHORDS, **LAGS, **samples)
    two_point('beads, template', pack, **TEMPLATE, **LAGS, **samples)
    radial_distribution('beads', pack, **LAGS)
    chord_lengths('beads', pack, NumberOfLines=8000, Seed=1, **LAGS)
    phase_map('beads', pack, 'm m; 5 5', 6, 200)
    octant = {'BoxSize': [edge / 2 for edge in BEADS_BOX], 'CropToWindow': 1}
    plain = ParticleModes(Input=SpherePackReader(FileName=BEADS, LengthUnit='µm'), NumberOfModes=9)
    two_point('octant of the beads', plain, MaximumLag=150, NumberOfLags=200, **octant)
    directions('octant of the beads, exact', plain, NumberOfDirections=32, MaximumLag=150, NumberOfLags=60, **octant)
    directions('octant of the beads, chords', plain, NumberOfDirections=12, NumberOfLines=4000, MaximumLag=150, NumberOfLags=60, **octant, **CHORDS)


def sampling():
    """One- and two-point probabilities of small packs: windows, masks, overlaps, automatic lags, every option"""
    packs = {'periodic': lattice_pack('periodic'), 'block': lattice_pack('block', periodic=False),
             'many radii': lattice_pack('many', **MANY), 'many radii, block': lattice_pack('many_block', periodic=False, **MANY),
             'overlapping': lattice_pack('overlapping', radius=0.55), 'spread over the ranks': spread('spread')}
    few = {'NumberOfLines': 1500, 'NumberOfThrows': 100, 'Seed': 3}
    for name, pack in packs.items():
        for method in ('Exact Pair Sum', 'Chord Sampling', 'Template Sampling'):
            two_point(f'{name}, {method}', pack, Method=method, **FEW_LAGS, **few)
        for method in ('Sphere Volumes', 'Chord Sampling', 'Template Sampling'):
            one_point(f'{name}, {method}', pack, Method=method, **few)
        two_point(f'{name}, automatic lags', pack, NumberOfLags=40, SaturationTolerance=0.002)
        directions(f'{name}, exact', pack, NumberOfDirections=9, **FEW_LAGS)
        directions(f'{name}, chords', pack, NumberOfDirections=9, NumberOfLines=600, Seed=2, **CHORDS, **FEW_LAGS)
        chord_lengths(name, pack, NumberOfLines=1500, Seed=3, **FEW_LAGS)
        radial_distribution(name, pack, **FEW_LAGS)
        phase_map(name, pack, 'm m; 1 2', 4, 2.0)
    phase_map('a spacing', packs['periodic'], '1 1; 1 2; 2 m', 3, 2.0, 0.25)
    for method in (CHORDS, TEMPLATE):
        two_point(f'target error, {method["Method"]}', packs['block'], TargetError=0.3, WindowMargin=0.6, Seed=4, **method, **FEW_LAGS)
        two_point(f'automatic lags, {method["Method"]}', packs['block'], NumberOfLags=20, **few, **method)
    plain = lattice_pack('plain', windowed=False, radius=0.36)
    windows = {'box': {'BoxOrigin': [0.5] * 3, 'BoxSize': [7.0] * 3, 'CropToWindow': 1},
               'cylinder': {'CylinderBase': [4, 4, 0.5], 'CylinderRadius': 4, 'CylinderHeight': 7, 'CropToWindow': 1},
               'tilted cylinder': {'CylinderBase': [2, 4, 2], 'CylinderAxis': [1, 0, 1], 'CylinderRadius': 2.6, 'CylinderHeight': 5,
                                   'CropToWindow': 1},
               'box, periodic': {'BoxOrigin': [-0.5] * 3, 'BoxSize': [9.0] * 3, 'BoxPeriodic': [1] * 3},
               'box, periodic along x and y': {'BoxOrigin': [-0.5] * 3, 'BoxSize': [9.0] * 3, 'BoxPeriodic': [1, 1, 0]},
               'bounding box': {}}
    for name, window in windows.items():
        for method in ({}, CHORDS, TEMPLATE):
            two_point(f'{name}, {method.get("Method", "exact")}', plain, MaximumLag=1.5, NumberOfLags=15, **few, **window, **method)
        radial_distribution(name, plain, MaximumLag=1.5, NumberOfLags=15, **window)
        one_point(name, plain, **window)
    inside = ' & '.join(f'(coords{axis} > 0.5) & (coords{axis} < 7.5)' for axis in 'XYZ')
    for name, source, label in (('mask', mask([1, 7] * 3, '1'), {}),
                                ('label', mask([-12, 15] * 3, f'if ({inside}, 3, 7)', 'Label'), {'MaskArray': 'Label', 'MaskLabel': 3})):
        masked = {'Mask': source, 'MaskArray': 'Inside', **label}
        for method in (CHORDS, TEMPLATE):
            one_point(f'{name}, {method["Method"]}', plain, WindowMargin=1, **few, **masked, **method)
            two_point(f'{name}, {method["Method"]}', plain, WindowMargin=1, MaximumLag=1.5, NumberOfLags=15, **few, **masked, **method)
        chord_lengths(name, plain, WindowMargin=1, MaximumLag=1.5, NumberOfLags=15, NumberOfLines=1500, Seed=3, **masked)


def settled():
    """A cylinder of the settled pack, and what convergence.py takes"""
    modes = ParticleModes(Input=SpherePackReader(FileName=SETTLED, LengthUnit='µm'), NumberOfModes=3)
    window = {'CylinderBase': [0, 0, 100], 'CylinderRadius': 800, 'CylinderHeight': 700, 'CropToWindow': 1}
    for method in ({}, CHORDS):
        two_point(f'settled cylinder, {method.get("Method", "exact")}', modes, MaximumLag=200, NumberOfLags=50, NumberOfLines=3000, **window, **method)
    cell = UnitCellReconstruction(Input=beads(), NumberOfParticles=1082, MaximumIterations=0)
    for number in (25, 400):
        two_point(f'convergence, {number} lags', cell, MaximumLag=200, NumberOfLags=number)
    for samples in ({'NumberOfLines': 100, **CHORDS}, {'NumberOfLines': 3000, **CHORDS}, {'NumberOfThrows': 300, **TEMPLATE}):
        two_point('convergence, ' + ', '.join(map(str, samples.values())), cell, Seed=1, **LAGS, **samples)
    chord_lengths('convergence', cell, NumberOfLines=3000, Seed=1, **LAGS)


def triples():
    """Three-Point Probability and Compare Probabilities"""
    few = {'NumberOfThrows': 400, 'NumberOfDirections': 8, 'NumberOfLags': 10, 'MaximumLag': 2.0, 'StandardErrors': 1, 'Seed': 2}
    packs = {'periodic': lattice_pack('three'), 'block': lattice_pack('three_block', periodic=False),
             'overlapping': lattice_pack('three_overlapping', radius=0.55), 'spread over the ranks': spread('three_spread')}
    three = {name: three_point(name, pack, Phases='1 2 m; m m m; 2 2 2', **few) for name, pack in packs.items()}
    three_point('all', packs['periodic'], Phases='all', **{**few, 'StandardErrors': 0, 'NumberOfDirections': 7})
    three_point('automatic lags', packs['block'], Phases='1 1 m', NumberOfThrows=200, NumberOfLags=12)
    plain = lattice_pack('three_plain', windowed=False, radius=0.36)
    three_point('cylinder', plain, Phases='1 2 m; m m m', CylinderBase=[4, 4, 0.5], CylinderRadius=4, CylinderHeight=7, CropToWindow=1, **few)
    three_point('mask', plain, Phases='1 2 m; m m m', Mask=mask([1, 7] * 3, '1'), MaskArray='Inside', WindowMargin=1, **few)
    three_point('beads', beads('Equal Volume'), Phases='3 5 5; 7 7 5; m m m', MaximumLag=200, NumberOfLags=60, NumberOfThrows=1500,
                StandardErrors=1)
    compare('images', three['periodic'], [three['overlapping']], images=True)
    two = [TwoPointProbability(Input=lattice_pack(f'compared{n}', radius=0.36 + 0.02 * n), **FEW_LAGS) for n in range(3)]
    compare('a table', two[0], two[1:2])
    compare('tables', two[0], two[1:])
    two[1].UpdatePipeline()
    compare('a file', two[0], [CSVReader(FileName=[table_file('compared.csv', two[1])])])
    maps = [phase_map(f'compared {n}', packs[name], 'm m; 1 2', 4, 2.0) for n, name in enumerate(('periodic', 'overlapping'))]
    port = 0 if SPLIT else 3
    compare('maps', OutputPort(maps[0], port), [OutputPort(maps[1], port)], images=True)


SMALL = {'NumberOfParticles': 60, 'MaximumIterations': 30, **FEW_LAGS}
SEARCHES = {'Gradient': {}, 'Annealed Population': {'Population': 12, 'MatingPool': 4, 'MaximumGenerations': 6},
            'Hybrid': {'HybridPopulation': 4, 'HybridMatingPool': 2, 'RefinementSteps': 5, 'MaximumGenerations': 4}}


def cells():
    """Unit Cell Reconstruction and Periodic Replicas"""
    pack = lattice_pack('cells')
    for method, settings in SEARCHES.items():
        reconstruct(method, pack, Method=method, Seed=5, **SMALL, **settings)
        reconstruct(f'{method}, 4 cells', pack, Method=method, NumberOfCells=4, Seed=5, **SMALL, **settings)
    population = {**SMALL, 'Method': 'Annealed Population', 'Population': 16, 'MatingPool': 6, 'MaximumGenerations': 12}
    reconstruct('every setting of a population', pack, RandomShare=0.3, DepositionDegree=0.5, SelectionPressure=1.8, HalfOverlap=0.5,
                OperatorWeights=[1, 2, 0.5, 1, 3, 1, 0, 1], MutatedShare=0.05, MutationShape=3, MutationReach=0.5, MutationGenerations=50,
                MassSpringProbability=0.5, InitialTemperature=0.01, CoolingFactor=0.9, ReheatingGenerations=4, **population)
    reconstruct('patience', pack, PatienceGenerations=2, **population)
    reconstruct('hybrid reach', pack, Method='Hybrid', HybridMutationReach=0.3, **SMALL, **SEARCHES['Hybrid'])
    reconstruct('target objective', pack, **{**SMALL, 'MaximumIterations': 200, 'TargetObjective': 0.5})
    reconstruct('cell size', pack, CellSize=4.2, MaximumIterations=3, **FEW_LAGS)
    reconstruct('automatic size and lags', pack, NumberOfLags=30, MaximumIterations=3, SaturationTolerance=0.01)
    reconstruct('mode counts', pack, ModeCounts=[17, 40], MaximumIterations=3, **FEW_LAGS)
    reconstruct('spread over the ranks', spread('cells_spread'), **SMALL)
    reconstruct('block', lattice_pack('cells_block', periodic=False), **SMALL)
    reconstruct('many radii', lattice_pack('cells_many', **MANY), **SMALL)
    target = two_point('target', pack, **FEW_LAGS)
    diameters = {'ModeDiameters': [0.72, 0.82]}
    reconstruct('from a table', target, **SMALL, **diameters)
    reconstruct('from a file', CSVReader(FileName=[table_file('target.csv', target)]), **SMALL, **diameters)
    reconstruct('mode counts, from a table', target, ModeCounts=[17, 40], MaximumIterations=3, **diameters)
    for name, settings in (('boundary copies', {}), ('tiling', {'Method': 'Tiling', 'Tiles': [2, 1, 3]})):
        replicate(name, reconstruct(name, pack, **{**SMALL, 'Seed': 9}), **settings)
    spheres = UnitCellReconstruction(Input=pack, **SMALL)
    replicate('spread over the ranks', spread('copies_spread'), clip=True)
    for name, settings in (('clipped', {}), ('coarse', {'SurfaceResolution': 8}), ('clipped tiling', {'Method': 'Tiling', 'Tiles': [1, 2, 1]})):
        surfaces = replicate(name, spheres, clip=True, **settings)
    write_stl('surfaces.stl', surfaces)


def write_stl(name, source):
    """The surfaces as the README has them written."""
    writer = vtkSTLWriter()
    writer.SetFileTypeToBinary()
    writer.SetFileName(file_of_rank(name))
    writer.SetInputData(source.GetClientSideObject().GetOutputDataObject(2))
    if source.GetClientSideObject().GetOutputDataObject(2).GetNumberOfPoints():
        assert writer.Write()
        add_file('clipped tiling: STL file', name)


def add_file(output, name):
    if os.path.exists(file_of_rank(name)):
        with open(file_of_rank(name), 'rb') as file:
            add(output, 'bytes', 'file', file.read())


def bead_cells():
    """Cells of the bead pack as the examples take them"""
    pack = beads()
    cell = reconstruct('unit_cell.py', pack, NumberOfParticles=1082, TargetObjective=0.06, MaximumIterations=60, **LAGS)
    replicate('unit_cell.py', cell, clip=True)
    two_point('unit_cell.py, cell', cell, **LAGS)
    three_point('unit_cell.py, cell', cell, Phases='m m m', MaximumLag=200, NumberOfLags=40, NumberOfThrows=1000, StandardErrors=1)
    reconstruct('cells.py', pack, NumberOfCells=3, NumberOfParticles=400, MaximumIterations=40, MaximumLag=200, NumberOfLags=100)
    reconstruct('cells.py, population', pack, NumberOfCells=2, NumberOfParticles=400, MaximumLag=200, NumberOfLags=60,
                Method='Annealed Population', Population=24, MatingPool=4, MaximumGenerations=10)
    for size in (50, 200):
        reconstruct(f'smallest_cell.py, {size} spheres', pack, NumberOfCells=3, NumberOfParticles=size, MaximumIterations=20, MaximumLag=200,
                    NumberOfLags=100)


def checkpoints():
    """Searches that end, and go on from their checkpoint"""
    pack = lattice_pack('checkpoints')
    for method, settings in SEARCHES.items():
        settings = {**SMALL, **settings, 'Method': method, 'Seed': 2, 'NumberOfCells': 2 if method == 'Gradient' else 1}
        limit = 'MaximumIterations' if method == 'Gradient' else 'MaximumGenerations'
        file = f'{method}.state'
        for name, most in (('begun', settings[limit] // 2), ('gone on', settings[limit])):
            reconstruct(f'{method}, {name}', pack, CheckpointFile=file_of_rank(file), **{**settings, limit: most})
            for ending in ('', '.1', '.2'):
                add_file(f'{method}, {name}: checkpoint{ending}', file + ending)
        reconstruct(f'{method}, uninterrupted', pack, **settings)


GROUPS = (packs, statistics, sampling, settled, triples, cells, bead_cells, checkpoints)


def main():
    for group in GROUPS:
        if not sys.argv[2:] or group.__name__ in sys.argv[2:]:
            start = time.time()
            group()
            if RANK == 0:
                print(f'{group.__doc__}: {time.time() - start:.1f} s', flush=True)
    with open(os.path.join(sys.argv[1], f'rank{RANK}.pickle'), 'wb') as file:
        pickle.dump(ENTRIES, file)


try:
    FOLDER = os.path.join(os.path.abspath(sys.argv[1]), f'rank{RANK}')
    os.makedirs(FOLDER, exist_ok=True)
    main()
except Exception:
    # An exception that leaves one rank's script would keep the others waiting for ever
    print(traceback.format_exc(), flush=True)
    os.abort()
