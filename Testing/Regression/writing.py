# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Save Data offers the formats of other programs, and what it writes opens again with the same bits; frames and cells go round, too.

    pvbatch writing.py FOLDER     FOLDER for its files
"""
import math
import os
import sys

from paraview.simple import *

from harness import RANKS, fetch, field, leaves, run

FOLDER = os.path.join(sys.argv[1], 'writing_%d' % RANKS)
BOX = [9.0, 9.0, 9.0]
SPHERES = [(1.5 * i + 0.1 * math.sqrt(j), 1.5 * j + math.pi / 9, 1.5 * k + 0.1 / (i + 1), 0.4 + 0.1 * math.sin(i + j + k))
           for i in range(6) for j in range(6) for k in range(6)]


def spheres(data):
    radius = data.GetPointData().GetArray('Radius')
    return sorted((*data.GetPoint(i), radius.GetValue(i)) for i in range(data.GetNumberOfPoints()))


def open_pack():
    with open('pack.csv', 'w') as file:
        file.write('x,y,z,radius\n' + ''.join('%r,%r,%r,%r\n' % sphere for sphere in SPHERES))
    return ParticleModes(Input=SpherePackReader(FileName=['pack.csv'], BoxSize=BOX, BoxPeriodic=[1, 1, 1], LengthUnit='mm'), NumberOfModes=3)


def every_extension():
    pack = open_pack()
    expected = spheres(fetch(pack))
    assert expected == sorted(SPHERES)
    for extension in ('dump', 'lammpstrj', 'data', 'extxyz', 'xyzd', 'yade', 'spheres'):
        name = 'saved.' + extension
        SaveData(name, proxy=pack)
        again = fetch(OpenDataFile(name))
        assert spheres(again) == expected, extension
        if extension in ('dump', 'lammpstrj', 'extxyz', 'xyzd'):
            assert field(again, 'BoxSize') == BOX and field(again, 'BoxPeriodic') == [1, 1, 1], extension
    assert not any('.new-' in name for name in os.listdir()), os.listdir()


def cells_and_time_steps():
    pack = open_pack()
    cells = UnitCellReconstruction(Input=pack, NumberOfParticles=30, NumberOfLags=20, MaximumIterations=2, NumberOfCells=3)
    SaveData('cells.dump', proxy=OutputPort(cells, 3))
    frames = OpenDataFile('cells.dump')
    assert list(frames.TimestepValues) == [0, 1, 2], frames.TimestepValues
    expected = [spheres(cell) for cell in leaves(fetch(cells, 3)) if cell.GetNumberOfPoints() > 0]
    assert [len(cell) for cell in expected] == [30, 30, 30]
    for time, cell in zip(frames.TimestepValues, expected):
        frames.UpdatePipeline(time)
        assert spheres(servermanager.Fetch(frames)) == cell, time
    SaveData('again.dump', proxy=frames, WriteTimeSteps=1)
    with open('cells.dump') as first, open('again.dump') as second:
        assert first.read() == second.read()
    frames.UpdatePipeline(1)
    for name in ('now.dump', 'now.extxyz'):
        SaveData(name, proxy=frames)
        assert list(OpenDataFile(name).TimestepValues) == [1], name


os.makedirs(FOLDER, exist_ok=True)
os.chdir(FOLDER)
for file in os.listdir():
    os.remove(file)
run((every_extension, cells_and_time_steps))
