# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""The Python of the READMEs and of Plugin/Documentation runs as it is printed, and what it saves is what was computed, with every digit and the box of the cell.

    pvbatch readme.py FOLDER     FOLDER for its files
"""
import csv
import gzip
import os
import re
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from paraview.simple import *

from harness import RANKS, columns, fetch, run

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
DOCUMENTATION = os.path.join(ROOT, 'Plugin', 'Documentation')
FOLDER = os.path.join(sys.argv[1], 'readme_%d' % RANKS)
ARRAYS = ('Radius', 'Mode', 'Id')


def link(name, *target):
    if not os.path.lexists(name):
        os.symlink(os.path.join(ROOT, 'Examples', *target), name)


def blocks(*path):
    with open(os.path.join(ROOT, *path), encoding='utf-8') as file:
        return re.findall(r'```python\n(.*?)```', file.read(), re.DOTALL)


def spheres(data):
    arrays = [data.GetPointData().GetArray(name) for name in ARRAYS]
    return sorted((*data.GetPoint(i), *(array.GetValue(i) for array in arrays)) for i in range(data.GetNumberOfPoints()))


def box(data):
    return [[data.GetFieldData().GetArray(name).GetValue(i) for i in range(3)] for name in ('BoxOrigin', 'BoxSize', 'BoxPeriodic')]


def number(text):
    try:
        return float(text)
    except ValueError:
        return text


def numbers(name):
    """{column: list of numbers, and of texts}"""
    with open(name, newline='', encoding='utf-8') as file:
        header, *rows = csv.reader(file)
    return {column: list(map(number, values)) for column, values in zip(header, zip(*rows))}


def require_cell_file(cell):
    again = fetch(OpenDataFile('cell.pvtp'))
    assert spheres(again) == spheres(cell) and box(again) == box(cell) and len(spheres(cell)) == 1082
    # It is a pack with its window again
    modes = ParticleModes(Input=OpenDataFile('cell.pvtp'), Method='One Per Size')
    assert box(fetch(modes)) == box(cell)


def require_files(names):
    cell = fetch(names['cell'])
    require_cell_file(cell)
    table = numbers('cell.csv')
    assert sorted(zip(*(table[name] for name in ('Points:0', 'Points:1', 'Points:2', *ARRAYS)))) == spheres(cell)
    fields = numbers('cell_box.csv')
    assert [fields[name][:3] for name in ('BoxOrigin', 'BoxSize', 'BoxPeriodic')] == box(cell), fields
    assert numbers('probabilities.csv') == columns(names['probabilities'])


def write_particles(name):
    """As LIGGGHTS writes them: floats, in an array with a small letter."""
    numbers = range(1000)
    points = ' '.join('%d %d %d' % (2 * (n % 10), 2 * (n // 10 % 10), 2 * (n // 100)) for n in numbers)
    arrays = {'id': ('Int32', [n + 1 for n in numbers]), 'type': ('Int32', [1 + n % 2 for n in numbers]),
              'radius': ('Float32', [0.5 + 0.25 * (n % 2) for n in numbers])}
    with open(name, 'w') as file:
        file.write('<VTKFile type="PolyData" version="0.1"><PolyData><Piece NumberOfPoints="%d"><Points>'
                   '<DataArray type="Float32" NumberOfComponents="3" format="ascii">%s</DataArray></Points><PointData>' % (len(numbers), points))
        for array, (kind, values) in arrays.items():
            file.write('<DataArray type="%s" Name="%s" format="ascii">%s</DataArray>' % (kind, array, ' '.join(map(str, values))))
        file.write('</PointData></Piece></PolyData></VTKFile>')


def write_formats():
    with open(os.path.join(ROOT, 'Testing', 'Data', 'formats', 'same_pack', 'lammps_frames.dump'), 'rb') as dump:
        with gzip.open('settling.dump.gz', 'wb') as packed:
            packed.write(dump.read())
    with open('beads.txt', 'w') as file:
        file.writelines('%d %d %d %d\n' % (n + 1, 2 * (n % 3), 2 * (n // 3 % 3), 2 * (n // 9)) for n in range(27))


def require_formats(names):
    assert list(names['settling'].TimestepValues) == [0, 0.001, 0.002]
    assert fetch(names['settling']).GetNumberOfPoints() == 500
    coordinates = fetch(names['coordinates'])
    assert coordinates.GetPointData().GetArray('Radius').GetRange() == (0.5, 0.5) and coordinates.GetPoint(26) == (4, 4, 4)


def require_particles(pack):
    data = fetch(pack)
    radius, kind, number = (data.GetPointData().GetArray(name) for name in ('Radius', 'Type', 'Id'))
    assert sorted((number.GetValue(i), kind.GetValue(i), radius.GetValue(i)) for i in range(data.GetNumberOfPoints())) == [
        (n + 1, 1 + n % 2, 0.5 + 0.25 * (n % 2)) for n in range(1000)]
    assert box(data) == [[0, 0, 0], [20, 20, 20], [1, 1, 1]]


def require_saved(cell):
    """What other programs get is the cell, and opens again."""
    def places(data):
        return sorted((*data.GetPoint(i), data.GetPointData().GetArray('Radius').GetValue(i)) for i in range(data.GetNumberOfPoints()))
    expected = places(fetch(cell))
    assert len(expected) == 1082
    for file in ('cell.dump', 'cell.data', 'cell_for_tables.csv'):
        assert places(fetch(SpherePackReader(FileName=[file]))) == expected, file


def require_arrays(names, cell):
    assert names['s']['S_m_m'].tolist() == columns(names['probabilities'])['S_m_m']
    centres, = names['cells_as_arrays']
    expected = sorted(sphere[:5] for sphere in spheres(fetch(cell)))
    assert sorted((*centre, radius, mode) for centre, radius, mode in zip(centres.tolist(), names['radii'].tolist(), names['modes_of_cell'].tolist())) == expected
    assert names['phase'].max() == max(sphere[4] for sphere in expected)
    mine = fetch(names['mine'])
    assert sorted((*mine.GetPoint(i), mine.GetPointData().GetArray('Radius').GetValue(i)) for i in range(mine.GetNumberOfPoints())) == [
        sphere[:4] for sphere in expected]
    assert box(mine) == box(fetch(cell))


def go_on(names, *path):
    """Runs the blocks of a page, each of which goes on where the one before ended."""
    names = dict(names)
    for n, block in enumerate(blocks(*path)):
        exec(compile(block, '%s, block %d' % (path[-1], n + 1), 'exec'), names)
    return names


def readme():
    """Every page goes on where the README ended."""
    names = go_on({}, 'README.md')
    require_files(names)
    pages = {name: go_on(names, 'Plugin', 'Documentation', name) for name in sorted(os.listdir(DOCUMENTATION))}
    require_saved(names['cell'])
    require_formats(pages['Files.md'])
    require_particles(pages['Files.md']['settled'])
    assert len(columns(pages['Cells.md']['cells'], 4)['Seed']) == 5
    require_arrays(pages['Python.md'], names['cell'])


def shortest_script():
    ResetSession()
    os.remove('cell.pvtp')
    names = {}
    for block in blocks('Examples', 'README.md'):
        exec(compile(block, 'Examples/README.md', 'exec'), names)
    require_cell_file(fetch(names['cell']))
    assert numbers('two_point.csv') == columns(names['cell'], 2)


os.makedirs(FOLDER, exist_ok=True)
os.chdir(FOLDER)
for file in os.listdir():
    if os.path.isfile(file):
        os.remove(file)
link('Examples')
link('Data', 'Data')
write_particles('particles.vtp')
write_formats()
run((readme, shortest_script))
