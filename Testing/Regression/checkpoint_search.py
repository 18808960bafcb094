# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Searches one after the other, for checkpoints.py, which kills them and starts them again. After each a line END; at last a file with all of
their results as text, every bit of them, or null where there is none."""
import json
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from paraview.simple import *

from harness import fetch, leaves

# Messages stand between the results as they were printed, which two pipes would not keep
os.dup2(1, 2)
pack_file = os.path.join(os.path.dirname(os.path.abspath(__file__)), '../../Examples/Data/bead_block.csv')
reader = SpherePackReader(FileName=pack_file, BoxSize=[1445.372, 1287.892, 789.106])
modes = ParticleModes(Input=reader, NumberOfModes=4)
results = []
for settings in json.loads(sys.argv[1]):
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
    results.append(' '.join(result) or None)
    print('END', flush=True)
# Not to the output, in which mpiexec mixes what the ranks say
with open(sys.argv[2], 'w') as file:
    json.dump(results, file)
