# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""What a plugin without MPI is asked on several ranks, which it refuses.

    pvbatch TestTwoRanks.py pack.csv
"""
import sys

from paraview.simple import *

pack = SpherePackReader(FileName=sys.argv[1], BoxSize=[10, 10, 10], BoxPeriodic=[1, 1, 1])
ParticleModes(Input=pack, NumberOfModes=2).UpdatePipeline()
