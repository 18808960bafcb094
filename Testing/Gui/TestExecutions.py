# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Each filter runs once, whatever of it is shown afterwards and however.

    mpiexec -n ranks pvbatch TestExecutions.py pack.csv
"""
import sys

import paraview.simple as pv
from paraview.servermanager import OutputPort

reader = pv.SpherePackReader(FileName=sys.argv[1], BoxSize=[10, 10, 10], BoxPeriodic=[1, 1, 1], LengthUnit="µm")
modes = pv.ParticleModes(Input=reader, Method="One Per Size")
one_point = pv.OnePointProbability(Input=modes)
two_point = pv.TwoPointProbability(Input=modes, NumberOfLags=20)
directions = pv.DirectionalProbability(Input=modes, NumberOfLags=20, NumberOfDirections=2)
of_pairs = pv.ProbabilityMap(Input=modes, Resolution=3)
chords = pv.ChordLengths(Input=modes, NumberOfLags=20, NumberOfLines=50)
radial = pv.RadialDistribution(Input=modes, NumberOfLags=20)
neighbours = pv.NeighbourStatistics(Input=modes)
voids = pv.VoidDistances(Input=modes, Spacing=0.5)
third_order = pv.ThirdOrderParameters(Input=modes)
cell = pv.UnitCellReconstruction(Input=modes, NumberOfParticles=30, NumberOfLags=20, MaximumIterations=5)
three_point = pv.ThreePointProbability(Input=modes, Phases="m m m", MaximumLag=5, NumberOfLags=8, NumberOfThrows=100)
of_cell = pv.TwoPointProbability(Input=cell, MaximumLag=5, NumberOfLags=20)
comparison = pv.CompareProbabilities(Input=two_point, Cell=of_cell)
report = pv.CompareWithPack(Input=modes, Cell=cell)
study = pv.CellSizeStudy(Input=modes, Sizes=[20, 30], NumberOfCells=1, NumberOfLags=20, MaximumIterations=5)
replicas = pv.PeriodicReplicas(Input=cell)
mesh = pv.PeriodicMesh(Input=cell)
particles = pv.ParticlesFromImage(Input=pv.LabelImage(Input=modes, Dimensions=[40, 40, 40], VolumeFractions=1), ImageArray="VolumeFraction",
                                  Residual=1)
filters = [reader, modes, one_point, two_point, directions, of_pairs, chords, radial, neighbours, voids, third_order, cell, three_point, of_cell, comparison, report, study, replicas, mesh, particles]

runs = {}


def observe(source):
    runs[source] = 0

    def count(*_):
        runs[source] += 1

    source.GetClientSideObject().AddObserver("StartEvent", count)  # the filter of rank 0 suffices, as an execution is collective


for source in filters:
    observe(source)
# These two ask the pack for the extent of their images
labels = pv.LabelImage(Input=modes)
effective = pv.EffectiveProperties(Input=modes, Resolution=12, SecondResolution=0)
filters.append(effective)
observe(labels)
observe(effective)

failures = []


def check(after):
    for source, number in runs.items():
        if number != 1:
            failures.append(f"{source.SMProxy.GetXMLName()} ran {number} times after {after}")
            runs[source] = 1


render = pv.CreateView("RenderView", ViewSize=[300, 200])
displays = [pv.Show(source, render) for source in (reader, modes, cell, replicas)]
pv.Show(labels, render)
pv.Render(render)
for source in (one_point, two_point, directions, of_pairs, chords, radial, neighbours, voids, third_order, effective, three_point, of_cell, comparison, report, study, mesh, particles):
    source.UpdatePipeline()
check("the first outputs")

chart = pv.CreateView("XYChartView", ViewSize=[300, 200])
for source in filters:
    for port in range(source.SMProxy.GetNumberOfOutputPorts()):
        data = source.GetDataInformation(port)
        if data.GetDataSetTypeAsString() == "vtkTable":
            if data.GetNumberOfRows() == 1:
                continue  # of which ParaView cannot draw a line
            table = pv.Show(OutputPort(source, port), chart)
            pv.Render(chart)
            table.Visibility = 0
        elif data.GetNumberOfPoints() > 0:
            pv.Show(OutputPort(source, port), render)
            pv.Render(render)
        check(f"output {port} of {source.SMProxy.GetXMLName()}")

display = pv.Show(two_point, chart)
display.SeriesVisibility = ["S_1_1", "1", "S_m_m", "1"]
display.SeriesColor = ["S_1_1", "1", "0", "0"]
chart.BottomAxisTitle, chart.LeftAxisLogScale = "Lag", 1
pv.Render(chart)
check("properties of a chart")

for display in displays:
    pv.ColorBy(display, ("POINTS", "Radius"))
    display.RescaleTransferFunctionToDataRange(True, False)
    display.SphereScale = 0.5
pv.Render(render)
displays[-1].Representation = "3D Glyphs"
pv.Hide(cell, render)
render.CameraPosition = [30, 20, 10]
pv.Render(render)
check("colours, another representation and camera")
pv.Delete(chart)
pv.Delete(render)

print("\n".join(failures) or "each ran once")
if failures:
    sys.exit(1)  # an exit code of 0 would take this rank away from the others
