# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""A script whose input goes bad: no rank hangs, former results are gone, the cause is told in one line, and mended input works again."""
import os
import sys

from paraview import servermanager
from paraview.simple import *
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonCore import vtkOutputWindow

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
cell = UnitCellReconstruction(Input=modes, NumberOfParticles=42, NumberOfLags=20, MaximumIterations=5, ContactWeight=0, PoreWeight=0)
replicas = PeriodicReplicas(Input=cell)
chain = [reader, modes, probability, cell, replicas]


def update():
    replicas.UpdatePipeline()
    probability.UpdatePipeline()
    return [probability.GetDataInformation().GetNumberOfRows(), cell.GetDataInformation().GetNumberOfPoints(),
            replicas.GetDataInformation().GetNumberOfPoints()]


messages = []


@calldata_type(VTK_STRING)
def hear(window, event, text):
    messages.append(text)


def told():
    """What the filters, all of which work on this rank, too, have said since the last call."""
    heard = messages[:]
    messages.clear()
    assert not any('(0x' in text for text in heard), heard
    return heard


for event in ('ErrorEvent', 'WarningEvent'):
    vtkOutputWindow.GetInstance().AddObserver(event, hear)
expected = update()
assert all('no window is known' in text for text in told())
assert expected[0] == 21 and expected[1] == 42 and expected[2] > 42, expected
for name, text in bad.items():
    reader.FileName = write(name, text)
    assert update() == [0, 0, 0], (name, update())
    heard = told()
    assert len(heard) == 1 and 'Sphere Pack Reader: FileName' in heard[0], heard
    reader.FileName = good
    assert update() == expected, name
    told()
reader.FileName = os.path.join(folder, 'no such file.csv')
assert update() == [0, 0, 0]
reader.FileName = good
probability.NumberOfLags = 0
assert update()[0] == 0
probability.NumberOfLags = 20
assert update() == expected
# An image is asked for again by whatever looks at it
told()
image = ThreePointProbability(Input=modes, NumberOfThrows=0)
for port in range(4):
    servermanager.Fetch(OutputPort(image, port))
heard = [text for text in told() if 'no window' not in text]
assert len(heard) == 1 and 'Three-Point Probability: ' in heard[0], heard
# What ParaView has cut
box = dict(BoxSize=[5.0] * 3, BoxOrigin=[0.0] * 3)
part = Clip(Input=SpherePackReader(FileName=good, **box), ClipType='Plane')
part.ClipType.Origin = [2.2, 2.2, 2.2]
fractions = OnePointProbability(Input=ParticleModes(Input=part, Method='One Per Size'))
fractions.UpdatePipeline()
heard = told()
assert len(heard) == 2 and all("the centres fill only a volume of about" in text for text in heard), heard
# Two packs, a folder, a window in another unit
both = ParticleModes(Input=[reader, SpherePackReader(FileName=good)])
both.UpdatePipeline()
heard = told()
assert len(heard) == 1 and 'Particle Modes: Input takes one pack, got 2.' in heard[0], heard
assert both.GetDataInformation().GetNumberOfPoints() == 0
SpherePackReader(FileName=folder).UpdatePipeline()
heard = told()
assert len(heard) == 1 and 'a regular file is required, got a folder' in heard[0], heard
metres = SpherePackReader(FileName=good, Scale=1e-6, **box)
metres.UpdatePipeline()
heard = told()
assert len(heard) == 1 and 'a tenth or less of the box window 5 x 5 x 5' in heard[0], heard
metres.UpdatePropertyInformation()
assert '216 spheres of diameter 6e-07 to 6.8e-07' in metres.GetProperty('Summary').GetData()
print('errors.py: passed')
