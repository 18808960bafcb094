# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the filters from file to replicas and writes every number of their outputs, bit by bit, and a picture.

    pvpython RunChain.py pack.csv numbers.txt picture.png [port ranks]      with a port: by a server
"""
import sys

import paraview.simple as pv
from paraview import servermanager
from paraview.servermanager import Fetch

pack, numbers, picture = sys.argv[1:4]
if len(sys.argv) > 4:
    pv.Connect("127.0.0.1", int(sys.argv[4]))  # a bare system may not know the name localhost
    assert servermanager.ActiveConnection.GetNumberOfDataPartitions() == int(sys.argv[5])
    pv.GetSettingsProxy("RenderViewSettings").RemoteRenderThreshold = 0.0

reader = pv.SpherePackReader(FileName=pack, BoxSize=[10, 10, 10], BoxPeriodic=[1, 1, 1])
modes = pv.ParticleModes(Input=reader, Method="One Per Size")
one_point = pv.OnePointProbability(Input=modes)
two_point = pv.TwoPointProbability(Input=modes, NumberOfLags=40)
chords = pv.TwoPointProbability(Input=modes, NumberOfLags=40, Method="Chord Sampling", NumberOfLines=500)
cell = pv.UnitCellReconstruction(Input=modes, NumberOfParticles=30, NumberOfLags=40, MaximumIterations=10)
cells = pv.UnitCellReconstruction(Input=two_point, ModeDiameters=[1.2, 1.7, 2.3], ModeCounts=[16, 10, 4], Method="Hybrid", HybridPopulation=2,
                                  MaximumGenerations=1, RefinementSteps=2, NumberOfCells=2)
of_cell = pv.TwoPointProbability(Input=cell, MaximumLag=5, NumberOfLags=40)
three_point = pv.ThreePointProbability(Input=modes, Phases="1 2 m; m m m", MaximumLag=5, NumberOfLags=20, NumberOfThrows=200, StandardErrors=1)
of_cell_three = pv.ThreePointProbability(Input=cell, Phases="m m m; 1 2 m", MaximumLag=5, NumberOfLags=20, NumberOfThrows=200)
comparison = pv.CompareProbabilities(Input=two_point, Cell=[of_cell, two_point])
images = pv.CompareProbabilities(Input=three_point, Cell=of_cell_three)
replicas = pv.PeriodicReplicas(Input=cell)

# The images of three-point probabilities lie in slabs over the ranks; what they hold is in the other outputs, too.
OUTPUTS = {"modes": (modes, (0, 1)), "one point": (one_point, (0,)), "two point": (two_point, (0, 1, 2)), "chords": (chords, (0, 1, 2)),
           "cell": (cell, (0, 1, 2, 4, 5)), "cells": (cells, (0, 1, 2, 4, 5)), "three point": (three_point, (1, 2, 3)),
           "comparison": (comparison, (0, 1)), "images": (images, (0,)), "replicas": (replicas, (0,))}
lines = []
for name, (source, ports) in OUTPUTS.items():
    source.UpdatePipeline()
    for port in ports:
        info = source.GetDataInformation(port)
        if info.GetDataSetTypeAsString() == "vtkTable":
            data = Fetch(source, 0, idx=port)  # the part of rank 0, which must be the whole
            assert info.GetNumberOfRows() == data.GetNumberOfRows() > 0, (name, port)
            arrays = [data.GetColumn(i) for i in range(data.GetNumberOfColumns())]
            count = data.GetNumberOfRows()
        else:
            data = Fetch(source, idx=port)
            attributes = data.GetPointData()
            arrays = [attributes.GetArray(i) for i in range(attributes.GetNumberOfArrays())]
            arrays = [data.GetPoints().GetData()] + sorted(arrays, key=lambda a: a.GetName())  # they are gathered in any order
            count = data.GetNumberOfPoints()
        rows = [" ".join(a.GetValue(i) if a.IsA("vtkStringArray") else " ".join(map(float.hex, map(float, a.GetTuple(i)))) for a in arrays)
                for i in range(count)]
        if name == "replicas":
            rows.sort()  # they are spread over the ranks, so their order differs
        lines += [f"{name} {port}: " + " ".join(a.GetName() for a in arrays)] + rows
with open(numbers, "w") as file:
    file.write("\n".join(lines) + "\n")

view = pv.CreateView("RenderView", ViewSize=[400, 300], OrientationAxesVisibility=0)
display = pv.Show(replicas, view)
assert display.Representation == "Spheres"
pv.Show(servermanager.OutputPort(replicas, 1), view)
view.ResetCamera()
pv.SaveScreenshot(picture, view, ImageResolution=view.ViewSize)
print("remote rendering:", view.GetClientSideObject().GetUseDistributedRenderingForRender())
pv.Delete(view)  # otherwise the window would outlive its GL context and end with GLXBadContext
del view, display
