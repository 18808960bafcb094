# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Run by the window as it starts: records what is done in it, as Tools > Start Trace does, in trace.py of the folder HOME."""
import os

from paraview import servermanager, smtrace

smtrace.start_trace()


def write(*_):
    with open(os.path.join(os.environ["HOME"], "trace.py"), "w") as file:
        file.write(smtrace.get_current_trace_output())


# Before the window closes the trace is gone; the last proxy is registered when the last view has been filled
servermanager.vtkSMProxyManager.GetProxyManager().AddObserver("RegisterEvent", write)
