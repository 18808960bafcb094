# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Opens the state that cut.xml has saved: ticking Clip To Box shows the cut surfaces, by mode, and no whole spheres over them.

    pvpython TestCut.py state.pvsm folder
"""
import os
import operator
import sys

from paraview.simple import *
from vtkmodules.vtkIOImage import vtkPNGReader

state, folder = sys.argv[1:]
LoadState(state)
replicas = FindSource("PeriodicReplicas1")
view = FindViewOrCreate("RenderView1", "RenderView")
view.ViewSize = [400, 300]
spheres, surfaces = (GetRepresentation(OutputPort(replicas, port), view) for port in (0, 2))
assert replicas.ClipToBox == 1 and spheres.Visibility == surfaces.Visibility == 1
assert spheres.Representation == "Spheres" and surfaces.Representation == "Surface"
assert list(surfaces.ColorArrayName) == ["POINTS", "Mode"], surfaces.ColorArrayName
table = GetColorTransferFunction("Mode")
assert table.InterpretValuesAsCategories == 1 and list(table.Annotations) == ["1", "1", "2", "2", "3", "3"]


def picture(what):
    path = os.path.join(folder, f"cut_{what}.png")
    SaveScreenshot(path, view, ImageResolution=view.ViewSize)
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    return bytes(memoryview(reader.GetOutput().GetPointData().GetScalars()))


opened = picture("opened")
spheres.ShowCutSpheres = 1
whole = picture("whole")
spheres.ShowCutSpheres = 0
spheres.Visibility = 0
cut = picture("cut")
surfaces.Visibility = 0
outline = picture("outline")
spheres.Visibility = 1
without = picture("without")
# The box is drawn twice, by the outline too, and differs in some pixels; a sphere has hundreds
assert sum(map(operator.ne, opened, cut)) < 0.01 * sum(map(operator.ne, whole, cut))
spheres.ShowCutSpheres = 1
assert picture("alone") == without
# The facets of the surfaces have the volume of the spheres, and look out of them here and there
assert sum(map(operator.ne, whole, without)) < 0.5 * sum(map(operator.ne, cut, without))
assert len({cut, whole, outline}) == 3
Delete(view)  # otherwise the window would outlive its GL context and end with GLXBadContext
del view, spheres, surfaces
