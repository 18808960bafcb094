# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Times how a large pack turns; started by Testing/Benchmark/run. Prints one line."""
import os
import statistics
import time

from paraview import servermanager
from paraview.simple import *

ranks = servermanager.ActiveConnection.GetNumberOfDataPartitions()
pack_file = os.path.join(os.path.dirname(os.path.abspath(__file__)), '../Gui/pack.csv')
reader = SpherePackReader(FileName=pack_file, BoxSize=[10, 10, 10], BoxPeriodic=[1, 1, 1])
tiles = PeriodicReplicas(Input=ParticleModes(Input=reader, Method='One Per Size'), Method='Tiling', Tiles=[12, 10, 7])
view = CreateView('RenderView', ViewSize=[800, 800])
Show(tiles, view)
ResetCamera(view)
Render(view)
seconds = []
for frame in range(21):
    view.GetActiveCamera().Azimuth(7)
    begin = time.perf_counter()
    Render(view)
    seconds.append(time.perf_counter() - begin)
spheres = tiles.GetDataInformation().GetNumberOfPoints()
print('%-64s ranks %d  %.2f' % ('a frame of %d spheres, 800 x 800: median of 21, s' % spheres, ranks, statistics.median(seconds)))
Delete(view)
del view
