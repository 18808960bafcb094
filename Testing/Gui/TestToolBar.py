# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Opens the state that toolbar.xml has saved: one click behind a file has made modes, S_rs, a cell, its copies, and the comparison, each
behind the right one.

    pvpython TestToolBar.py state.pvsm
"""
import sys

from paraview.simple import *

LoadState(sys.argv[1])
pack, modes, probabilities, cell, copies, report = (FindSource(name) for name in (
    "bead_block.csv", "ParticleModes1", "TwoPointProbability1", "UnitCellReconstruction1", "PeriodicReplicas1", "CompareWithPack1"))
inputs = {modes: pack, probabilities: modes, cell: modes, copies: cell}
for behind, before in inputs.items():
    assert behind.Input.SMProxy is before.SMProxy and behind.Input.Port == 0, behind
assert [port.SMProxy for port in report.Input] == [modes.SMProxy] and [port.SMProxy for port in report.Cell] == [cell.SMProxy]
assert cell.NumberOfParticles == 500 and copies.ClipToBox == 1
assert len(GetSources()) == 6, GetSources()
# What is seen: the cut cell in place of the pack, and three charts
views = {name: len(GetViews(name)) for name in ("RenderView", "XYChartView")}
assert views == {"RenderView": 1, "XYChartView": 3}, views
view = GetViews("RenderView")[0]
assert GetRepresentation(OutputPort(copies, 2), view).Visibility == 1
Delete(view)  # otherwise the window would outlive its GL context and end with GLXBadContext
del view
