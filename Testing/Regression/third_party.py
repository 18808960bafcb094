# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Packs made by others: periodic packs with ghost copies, whose packing fraction their makers state, and a histogram of contacts."""
import collections
import math
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


# A pack of LIGGGHTS with the histogram of its contacts by its maker, who counts j as a contact of i where d < 1.005 r_i + r_j and leaves
# out the last bin, a bead with 18. All these pairs have gaps up to 0.005.
reader = SpherePackReader(FileName=os.path.join(folder, 'azamat', 'test.particles'), BoxOrigin=[-0.05] * 3, BoxSize=[0.6, 0.6, 2])
neighbours = NeighbourStatistics(Input=ParticleModes(Input=reader, NumberOfModes=1), ContactTolerance=0.005, WindowMargin=0)
neighbours.UpdatePipeline()
pack, contacts = (servermanager.Fetch(neighbours, idx=port) for port in (0, 1))
radii = pack.GetPointData().GetArray('Radius')
centres = [pack.GetPoint(i) for i in range(pack.GetNumberOfPoints())]
WIDTH = 1e-4  # less than half a bead, so that a place has one bead or none
places = {tuple(int(x // WIDTH) for x in centre): i for i, centre in enumerate(centres)}


def bead_at(point):
    place = [int(x // WIDTH) for x in point]
    near = (places.get((place[0] + i, place[1] + j, place[2] + k)) for i in (-1, 0, 1) for j in (-1, 0, 1) for k in (-1, 0, 1))
    return next(i for i in near if i is not None and math.dist(centres[i], point) < 1e-8)


counts = [0] * len(centres)
for line in range(contacts.GetNumberOfCells()):
    ids = contacts.GetCell(line).GetPointIds()
    i, j = (bead_at(contacts.GetPoint(ids.GetId(end))) for end in (0, 1))
    distance, a, b = math.dist(centres[i], centres[j]), radii.GetValue(i), radii.GetValue(j)
    counts[i] += distance < 1.005 * a + b
    counts[j] += distance < 1.005 * b + a
with open(os.path.join(folder, 'azamat', 'test_CN.csv'), encoding='utf-8') as file:
    expected = {int(row.split()[-2]): int(row.split()[-1]) for row in list(file)[1:] if row.strip()}
assert collections.Counter(counts) == {**expected, 18: 1}, collections.Counter(counts)
print('azamat:', sum(counts), 'contacts as its maker counts them')
