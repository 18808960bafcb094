# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""The mistakes of Plugin/Documentation/Questions.md have the messages that stand there; those with (Python) are ParaView's own, and differ between its versions.

    pvbatch questions.py FOLDER     FOLDER for its files
"""
import os
import re
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from paraview.simple import *
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonCore import vtkOutputWindow

from harness import run

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
BEADS = os.path.join(ROOT, 'Examples', 'Data', 'bead_block.csv')
messages = []


@calldata_type(VTK_STRING)
def hear(window, event, text):
    messages.append(text)


def beads(**properties):
    return SpherePackReader(FileName=BEADS, BoxSize=[1445.372, 1287.892, 789.106], LengthUnit='µm', **properties)


def file(name, header, row):
    path = os.path.join(sys.argv[1], 'questions_' + name)
    with open(path, 'w') as table:
        table.write(header + '\n' + ''.join(row % (n % 10, n // 10 % 10, n // 100) + '\n' for n in range(1000)))
    return path


def modes(**properties):
    return ParticleModes(Input=beads(), **properties)


MISTAKES = {
    'no radii': lambda: SpherePackReader(FileName=file('bare.csv', 'x,y,z', '%d,%d,%d')),
    'two units': lambda: SpherePackReader(FileName=file('units.csv', 'x [mm],y [mm],z [mm],radius [um]', '%d,%d,%d,500')),
    'diameters for radii': lambda: TwoPointProbability(Input=ParticleModes(Input=Calculator(Input=beads(), ResultArrayName='Radius', Function='2*Radius'))),
    'no modes': lambda: TwoPointProbability(Input=beads()),
    '0 modes': lambda: modes(NumberOfModes=0),
    '50 modes': lambda: modes(NumberOfModes=50),
    'no window': lambda: ParticleModes(Input=SpherePackReader(FileName=BEADS, FindWindow=0)),
    'a lag beyond the window': lambda: TwoPointProbability(Input=modes(), MaximumLag=5000),
    'a negative lag': lambda: TwoPointProbability(Input=modes(), MaximumLag=-5),
    'an image': lambda: TwoPointProbability(Input=Wavelet()),
    'a table': lambda: TwoPointProbability(Input=CSVReader(FileName=[BEADS])),
    'a mesh': lambda: ParticleModes(Input=Sphere()),
    'too large': lambda: ThreePointProbability(Input=modes(), Phases='all', MaximumLag=200),
}


def questions():
    window = vtkOutputWindow.GetInstance()
    for event in ('ErrorEvent', 'WarningEvent'):
        window.AddObserver(event, hear)
    heard = {}
    for name, mistake in MISTAKES.items():
        del messages[:]
        mistake().UpdatePipeline()
        assert len(messages) >= 1, name
        heard[name] = ' '.join(messages)
    with open(os.path.join(ROOT, 'Plugin', 'Documentation', 'Questions.md'), encoding='utf-8') as page:
        told = re.findall(r'^\| \*([^|]*)\* \|', page.read(), re.MULTILINE)
    assert len(told) >= len(MISTAKES) - 1, told
    for text in told:
        parts = [part.strip() for part in text.split('…') if part.strip()]
        where = [name for name, message in heard.items() if all(part in message for part in parts)]
        assert where, ('nobody says', text, heard)


run((questions,))
