# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the window of stop-button runs: a search for many minutes that has to end by the click on a button, with what it found so far.

The button, the pack, the port of a server, if any, and the file that is to appear when the search has something to keep come in RUC_BUTTON, RUC_PACK,
RUC_PORT and RUC_BETTER, since paraview --script takes no arguments.
"""
import os
import re
import traceback

from paraview.simple import *

LIMIT = 60  # in seconds; without the button the search ends by this
FAR = 0.1   # F2 is below only where a search has been at work for a while
ENDED_BY = {"Stop": "Stop button", "Abort": "Abort"}[os.environ["RUC_BUTTON"]]


def tell_when_better():
    """Makes the file once the F2 that the search tells has fallen to half of what it told first, or far, where the first was told late."""
    handler = servermanager.ActiveConnection.Session.GetProgressHandler()
    told = []

    def on_progress(*_):
        value = re.search(r"^Unit Cell Reconstruction: .*\[F2 = ([^,]+),", handler.GetLastProgressText() or "")
        if value:
            told.append(float(value[1]))
            if told[-1] < max(told[0] / 2, FAR):
                open(os.environ["RUC_BETTER"], "w").close()

    return handler, handler.AddObserver("ProgressEvent", on_progress)


def run():
    if os.environ.get("RUC_PORT"):
        Connect("127.0.0.1", int(os.environ["RUC_PORT"]))
    # With this box nothing is warned of, by a window that may lie over the button
    pack = SpherePackReader(FileName=os.environ["RUC_PACK"], BoxSize=[1445.372, 1287.892, 789.106])
    modes = ParticleModes(Input=pack, NumberOfModes=9)
    cells = UnitCellReconstruction(Input=modes, NumberOfParticles=1000, MaximumLag=200, Method="Hybrid", NumberOfCells=2,
                                   TimeLimit=LIMIT)
    handler, observer = tell_when_better()
    cells.UpdatePipeline()
    handler.RemoveObserver(observer)
    table = servermanager.Fetch(cells, 0, idx=4)
    assert table.GetNumberOfRows() >= 1
    for row in range(table.GetNumberOfRows()):
        ended = table.GetColumnByName("EndedBy").GetValue(row)
        assert ended == ENDED_BY, f"cell {row + 1} ended by {ended}"
    cell = servermanager.Fetch(cells)
    assert cell.GetNumberOfPoints() == 1000
    fields = cell.GetFieldData()
    assert fields.GetArray("Stopped").GetValue(0) == 1
    objectives = [fields.GetArray(name).GetValue(0) for name in ("Objective", "StartObjective")]
    assert 0 < objectives[0] < objectives[1] and fields.GetArray("OverlapPercent").GetValue(0) == 0, objectives
    # Many filters of VTK ask whether one upstream was aborted, and would show nothing
    lifted = Elevation(Input=cells)
    lifted.UpdatePipeline()
    assert servermanager.Fetch(lifted).GetNumberOfPoints() == 1000
    # The wish ends one run alone: the next one goes to its own end
    again = UnitCellReconstruction(Input=modes, NumberOfParticles=300, MaximumLag=200, MaximumIterations=3)
    again.UpdatePipeline()
    assert servermanager.Fetch(again).GetFieldData().GetAbstractArray("EndedBy").GetValue(0) == "Maximum iterations"


try:
    run()
except BaseException:
    os.write(2, traceback.format_exc().encode())  # this does not go through the window, which ends here
    os._exit(1)
print("stopped as wished", flush=True)
os._exit(0)  # otherwise a script does not end ParaView's window
