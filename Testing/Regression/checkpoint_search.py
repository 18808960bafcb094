# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Searches one after the other, for checkpoints.py, which kills them and starts them again. After each, all of its result as text, every bit
of it, and the line END."""
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
for settings in json.loads(sys.argv[1]):
    search = UnitCellReconstruction(Input=modes, MaximumLag=100, NumberOfLags=40, NumberOfParticles=400, **settings)
    cells = leaves(fetch(search, 3))
    if cells:
        result = []
        for cell in cells:
            result += [x.hex() for i in range(cell.GetNumberOfPoints()) for x in cell.GetPoint(i)]
        for port in (1, 2, 4):
            table = fetch(search, port)
            result += [table.GetValue(i, j).ToString() for j in range(table.GetNumberOfColumns()) for i in range(table.GetNumberOfRows())]
            result += [table.GetColumn(j).GetValue(i).hex() for j in range(table.GetNumberOfColumns())
                       for i in range(table.GetNumberOfRows()) if isinstance(table.GetColumn(j).GetValue(i), float)]
        print('RESULT', ' '.join(result), flush=True)
    Delete(search)
    print('END', flush=True)
