# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Packs made by others: periodic packs with ghost copies, whose packing fraction their makers state."""
import os
import sys

from paraview import servermanager
from paraview.simple import *

folder = os.environ.get('RUC_THIRD_PARTY_DATA', '')
if not folder:
    print('RUC_THIRD_PARTY_DATA is not set')
    sys.exit(0)


def field(data, name):
    return data.GetFieldData().GetArray(name).GetComponent(0, 0)


# the name, the rows, the ghosts, and the packing fraction to the digits of the file's porosity
for name, rows, ghosts, fraction, digits in (('Sph1896_pack.out', 1896, 396, 1 - 0.36, 6), ('Sph125_pack.out', 125, 0, 1 - 0.369, 3)):
    reader = SpherePackReader(FileName=os.path.join(folder, 'lbpm', name), SkipLines=5, BoxSize=[1, 1, 1], BoxPeriodic=[1, 1, 1])
    modes = ParticleModes(Input=reader, NumberOfModes=3)
    one = OnePointProbability(Input=modes)
    one.UpdatePipeline()
    table = servermanager.Fetch(one)
    last = table.GetNumberOfRows() - 1
    particles = 1 - table.GetValueByName(last, 'VolumeFraction').ToDouble()
    pack = servermanager.Fetch(reader)
    print(name, pack.GetNumberOfPoints(), 'spheres,', field(pack, 'NumberOfGhosts'), 'ghosts, fraction', particles)
    assert pack.GetNumberOfPoints() == rows - ghosts
    assert field(pack, 'NumberOfGhosts') == ghosts
    assert round(particles, digits) == round(fraction, digits), particles

    # A pack at a fraction of 0.64 is a target like any other; its cell, as dense, comes out without overlap or says so
    cell = UnitCellReconstruction(Input=modes, NumberOfParticles=pack.GetNumberOfPoints(), NumberOfLags=60, MaximumIterations=30)
    cell.UpdatePipeline()
    data = servermanager.Fetch(cell)
    assert data.GetNumberOfPoints() == pack.GetNumberOfPoints()
    # The search prefers a cell without overlap, even to a better one with, and near jamming the start may have been left with some
    start = servermanager.Fetch(cell, idx=1).GetValueByName(1, 'OverlapPercent').ToDouble()
    assert start > 0 or field(data, 'Objective') <= field(data, 'StartObjective')
    print('  cell: F2', field(data, 'Objective'), 'overlap', field(data, 'OverlapPercent'), '%')
