# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""One search, for checkpoints.py, which kills it and starts it again. Prints all of its result as text, every bit of it."""
import json
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from paraview.simple import *

from harness import fetch, leaves

settings = json.loads(sys.argv[1])
pack_file = os.path.join(os.path.dirname(os.path.abspath(__file__)), '../../Examples/Data/bead_block.csv')
reader = SpherePackReader(FileName=pack_file, BoxSize=[1445.372, 1287.892, 789.106])
modes = ParticleModes(Input=reader, NumberOfModes=4)
search = UnitCellReconstruction(Input=modes, MaximumLag=100, NumberOfLags=40, NumberOfParticles=400, **settings)
cells = leaves(fetch(search, 3))
if cells:
    result = []
    for cell in cells:
        result += [x.hex() for i in range(cell.GetNumberOfPoints()) for x in cell.GetPoint(i)]
    for port in (1, 2, 4):
        table = fetch(search, port)
        result += [table.GetValue(i, j).ToString() for j in range(table.GetNumberOfColumns()) for i in range(table.GetNumberOfRows())]
        result += [table.GetColumn(j).GetValue(i).hex() for j in range(table.GetNumberOfColumns()) for i in range(table.GetNumberOfRows())
                   if isinstance(table.GetColumn(j).GetValue(i), float)]
    print('RESULT', ' '.join(result), flush=True)
