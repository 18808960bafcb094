# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Whether ParaView finds the filters by itself, in any of its programs; for a file of a server also what one computes there.

    pvpython TestInstalled.py [PORT PACK]
"""
import os
import sys

import paraview.simple as simple


def say(text):
    os.write(1, (text + '\n').encode())  # the window has a console of its own for print


PORT, PACK = sys.argv[1:3] if len(sys.argv) > 2 else (None, None)
if PORT:
    simple.Connect('127.0.0.1', int(PORT))  # a bare system may not know the name localhost
names = {'SpherePackReader': 'sources', 'ParticleModes': 'filters', 'TwoPointProbability': 'filters', 'UnitCellReconstruction': 'filters'}
# ParaView 6.1 leaves the functions of the client where the server cannot make what they promise
proxies = simple.servermanager.ProxyManager()
found = [name for name, group in names.items() if hasattr(simple, name) and proxies.HasDefinition(group, name)]
say('found %d of %d' % (len(found), len(names)))
if PORT and found:
    pack = simple.SpherePackReader(FileName=PACK, BoxSize=[10.0, 10.0, 10.0])
    probability = simple.TwoPointProbability(Input=simple.ParticleModes(Input=pack, NumberOfModes=2), NumberOfLags=10)
    probability.UpdatePipeline()
    say('rows %d' % simple.servermanager.Fetch(probability, idx=0).GetNumberOfRows())
if not PORT:
    os._exit(0)  # otherwise the window would stay
