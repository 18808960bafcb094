# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Every table of every filter in every view that offers itself for it.

    pvpython TestTables.py pack.csv port ranks      by a server, which must live to the end
"""
import sys

import paraview.simple as pv
from paraview import servermanager
from paraview.servermanager import Fetch, OutputPort

pack, port, ranks = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
pv.Connect("127.0.0.1", port)
assert servermanager.ActiveConnection.GetNumberOfDataPartitions() == ranks
manager = servermanager.ProxyManager()


def names_of(group):
    """The kinds of proxies in a group."""
    definitions = manager.GetProxyDefinitionManager().NewSingleGroupIterator(group)
    names = []
    definitions.InitTraversal()
    while not definitions.IsDoneWithTraversal():
        names.append(definitions.GetProxyName())
        definitions.GoToNextItem()
    return names


def is_ours(name):
    """Whether a filter is one of the plugin's, by its place in the menu."""
    hints = manager.GetPrototypeProxy("filters", name).GetHints()
    menu = hints.FindNestedElementByName("ShowInMenu") if hints else None
    return menu and menu.GetAttribute("category") == "Representative Unit Cell"


reader = pv.SpherePackReader(FileName=pack, BoxSize=[10, 10, 10], BoxPeriodic=[1, 1, 1])
modes = pv.ParticleModes(Input=reader, NumberOfModes=1)  # so a matrix of plots has few columns
two_point = pv.TwoPointProbability(Input=modes, NumberOfLags=8)
cell = pv.UnitCellReconstruction(Input=modes, NumberOfParticles=30, NumberOfLags=8, MaximumIterations=5)
of_cell = pv.TwoPointProbability(Input=cell, MaximumLag=5, NumberOfLags=8)
# 16 voxels along each axis, of a label for each half
labels = pv.Calculator(Input=pv.Wavelet(WholeExtent=[0, 15, 0, 15, 0, 15]), ResultArrayName="Label", Function="if(coordsX > 7, 1, 0)")
sources = [modes, two_point, cell,
           pv.SpherePackSource(NumberOfSpheres=50, Fraction=0.61),
           pv.PointsToSpherePack(Input=reader),
           pv.OnePointProbability(Input=modes),
           pv.DirectionalProbability(Input=modes, NumberOfLags=8, NumberOfDirections=2),
           pv.ProbabilityMap(Input=modes, Resolution=3),
           pv.LabelImage(Input=modes, Dimensions=[5, 5, 5]),
           pv.ParticlesFromImage(Input=pv.LabelImage(Input=modes, Dimensions=[40, 40, 40])),
           pv.ChordLengths(Input=modes, NumberOfLags=8, NumberOfLines=50),
           pv.RadialDistribution(Input=modes, NumberOfLags=8),
           pv.NeighbourStatistics(Input=modes),
           pv.VoidDistances(Input=modes, NumberOfDistances=8, Spacing=0.5),
           pv.ImageStatistics(Input=labels, PhaseArray="Label"),
           pv.ThirdOrderParameters(Input=modes),
           pv.EffectiveProperties(Input=modes, Resolution=12, SecondResolution=0),
           pv.ThreePointProbability(Input=modes, Phases="m m m", MaximumLag=5, NumberOfLags=4, NumberOfThrows=100),
           pv.CompareProbabilities(Input=two_point, Cell=of_cell),
           pv.CompareWithPack(Input=modes, Cell=cell),
           pv.CellSizeStudy(Input=modes, Sizes=[20, 30], NumberOfCells=2, NumberOfLags=8, MaximumIterations=5),
           pv.PeriodicMesh(Input=cell),
           pv.PeriodicReplicas(Input=cell)]
missing = {name for name in names_of("filters") if is_ours(name)} - {source.SMProxy.GetXMLName() for source in sources}
assert not missing, f"filters that are not tried: {missing}"
tables = []
for source in sources:
    source.UpdatePipeline()
    tables += [(source, n) for n in range(source.SMProxy.GetNumberOfOutputPorts())
               if source.GetDataInformation(n).GetDataSetTypeAsString() == "vtkTable"]

# Comparative views are grids of the others, and a Python view shows what its script says
views = [name for name in names_of("views") if not name.startswith(("Comparative", "Python")) and
         manager.GetPrototypeProxy("views", name).IsA("vtkSMViewProxy")]
shown = {}
for name in views:
    print("view", name, flush=True)
    view = pv.CreateView(name, ViewSize=[200, 150])
    for source, n in tables:
        # ParaView cannot draw a line of one row
        if view.SMProxy.CanDisplayData(source.SMProxy, n) and source.GetDataInformation(n).GetNumberOfRows() != 1:
            print(name, source.SMProxy.GetXMLName(), n, flush=True)
            display = pv.Show(OutputPort(source, n), view)
            pv.Render(view)
            pv.Hide(OutputPort(source, n), view)
            shown[name] = shown.get(name, 0) + 1
    pv.Delete(view)
for name in ("XYHistogramChartView", "XYBarChartView", "BoxChartView", "SpreadSheetView", "ParallelCoordinatesChartView", "PlotMatrixView",
             "QuartileChartView", "XYChartView", "XYPointChartView"):
    assert shown.get(name, 0) > 10, f"{name} showed {shown.get(name, 0)} tables"
assert two_point.GetDataInformation(0).GetNumberOfRows() == 9  # the server still lives
