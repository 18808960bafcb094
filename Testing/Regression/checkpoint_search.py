# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Searches, and packs of Sphere Pack Source, one after the other, for checkpoints.py, which kills them and starts them again.

    pvbatch checkpoint_search.py SEARCHES RESULTS MESSAGES

MESSAGES gets what is said, with a line END after each search; at last RESULTS gets all of their results as text, every bit of them, or null
where there is none."""
import json
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from paraview.simple import *

from harness import fetch, leaves

# Not through mpiexec, which mixes what the ranks say and was seen to lose some of it
messages = os.open(sys.argv[3], os.O_WRONLY | os.O_CREAT | os.O_TRUNC | os.O_APPEND)
for stream in (1, 2):
    os.dup2(messages, stream)
pack_file = os.path.join(os.path.dirname(os.path.abspath(__file__)), '../../Examples/Data/bead_block.csv')
reader = SpherePackReader(FileName=pack_file, BoxSize=[1445.372, 1287.892, 789.106])
modes = ParticleModes(Input=reader, NumberOfModes=4)
results = []


def make_pack(settings):
    """The places of a pack, and its table of growth."""
    source = SpherePackSource(**settings)
    pack, growth = fetch(source), fetch(source, 1)
    values = [x for i in range(pack.GetNumberOfPoints()) for x in pack.GetPoint(i)]
    values += [growth.GetColumn(j).GetValue(i) for j in range(growth.GetNumberOfColumns()) for i in range(growth.GetNumberOfRows())]
    Delete(source)
    return [x.hex() for x in values]


def search_cells(settings):
    """The places of the cells that a search found, and its tables."""
    # Of F2 alone, unless they say otherwise
    settings = {'ContactWeight': 0, 'PoreWeight': 0, **settings}
    search = UnitCellReconstruction(Input=modes, MaximumLag=100, NumberOfLags=40, NumberOfParticles=400, **settings)
    cells = leaves(fetch(search, 3))
    result = []
    if cells:
        for cell in cells:
            result += [x.hex() for i in range(cell.GetNumberOfPoints()) for x in cell.GetPoint(i)]
        for port in (1, 2, 4):
            table = fetch(search, port)
            result += [table.GetValue(i, j).ToString() for j in range(table.GetNumberOfColumns()) for i in range(table.GetNumberOfRows())]
            result += [table.GetColumn(j).GetValue(i).hex() for j in range(table.GetNumberOfColumns())
                       for i in range(table.GetNumberOfRows()) if isinstance(table.GetColumn(j).GetValue(i), float)]
    Delete(search)
    return result


for settings in json.loads(sys.argv[1]):
    result = make_pack(settings) if 'NumberOfSpheres' in settings else search_cells(settings)
    results.append(' '.join(result) or None)
    os.write(messages, b'END\n')  # ParaView 5.13 keeps what is printed until its end
with open(sys.argv[2], 'w') as file:
    json.dump(results, file)
