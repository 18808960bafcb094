# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""A script whose input goes bad: no rank hangs, former results are gone, and mended input works again."""
import os
import sys

from paraview import servermanager
from paraview.simple import *

folder = sys.argv[1]
ranks = servermanager.ActiveConnection.GetNumberOfDataPartitions()


def write(name, text):
    path = os.path.join(folder, 'errors_%d_%s' % (ranks, name))
    with open(path, 'wb') as file:
        file.write(text)
    return path


rows = ['%d,%d,%d,%g' % (x, y, z, 0.3 + 0.02 * ((x + y + z) % 3)) for x in range(6) for y in range(6) for z in range(6)]
good = write('good.csv', ('x,y,z,radius\n' + '\n'.join(rows) + '\n').encode())
bad = {
    'text.csv': b'x,y,z,radius\n1,2,3,0.3\n1,2,oops,0.3\n',
    'short.csv': b'x,y,z,radius\n1,2,3\n',
    'empty.csv': b'',
    'latin1.csv': b'x,y,z,radius\n1,2,3,0.3 \xb5m\n',
    'long.csv': b'x,y,z,radius\n' + b'1' * (10 << 20) + b'\n',
    'negative.csv': b'x,y,z,radius\n1,2,3,-1\n',
}

reader = SpherePackReader(FileName=good)
modes = ParticleModes(Input=reader, Method='One Per Size')
probability = TwoPointProbability(Input=modes, NumberOfLags=20)
cell = UnitCellReconstruction(Input=modes, NumberOfParticles=42, NumberOfLags=20, MaximumIterations=5)
replicas = PeriodicReplicas(Input=cell)
chain = [reader, modes, probability, cell, replicas]


def update():
    replicas.UpdatePipeline()
    probability.UpdatePipeline()
    return [probability.GetDataInformation().GetNumberOfRows(), cell.GetDataInformation().GetNumberOfPoints(),
            replicas.GetDataInformation().GetNumberOfPoints()]


expected = update()
assert expected[0] == 21 and expected[1] == 42 and expected[2] > 42, expected
for name, text in bad.items():
    reader.FileName = write(name, text)
    assert update() == [0, 0, 0], (name, update())
    reader.FileName = good
    assert update() == expected, name
reader.FileName = os.path.join(folder, 'no such file.csv')
assert update() == [0, 0, 0]
reader.FileName = good
probability.NumberOfLags = 0
assert update()[0] == 0
probability.NumberOfLags = 20
assert update() == expected
print('errors.py: passed')
