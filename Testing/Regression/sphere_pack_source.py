# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Sphere Pack Source in a script: its pack feeds filters and writers, it tells its estimate before a run, and its numbers are those of one rank."""
import os
import sys

from paraview.simple import *

from harness import RANKS, columns, expect_error, fetch, field, remember, run

FOLDER = os.path.abspath(sys.argv[1])


def pack():
    source = SpherePackSource(NumberOfSpheres=400, Fraction=0.64, LengthUnit='mm', MeanDiameter=2)
    source.UpdateVTKObjects()
    source.SMProxy.UpdatePropertyInformation()
    assert source.GetProperty('EstimatedTime').GetData() > 0.0 and source.GetProperty('EstimatedMemory').GetData() > 0.0
    assert source.GetProperty('AutomaticValues').GetData() == 'Rate 0.01', source.GetProperty('AutomaticValues').GetData()
    data = fetch(source)
    assert data.GetNumberOfPoints() == 400 and field(data, 'LengthUnit') == 'mm' and field(data, 'Protocol') == 'Events'
    assert abs(field(data, 'MaximumFraction') - 0.6435) < 0.002 and field(data, 'Q6') < 0.2
    growth = columns(source, 1)
    assert growth['Fraction'] == sorted(growth['Fraction']) and abs(growth['Fraction'][-1] - 0.64) < 1e-6
    assert growth['ReducedPressure'][-1] > 50.0
    one = fetch(OnePointProbability(Input=ParticleModes(Input=source, NumberOfModes=1)))
    fraction = field(one, 'VolumeFractions')[0]
    assert abs(fraction - 0.64) < 1e-12, fraction
    remember('pack', [x for i in range(400) for x in data.GetPoint(i)])
    remember('growth', [x for name in sorted(growth) for x in growth[name]])


def written():
    """What is written and read again still has no overlap and fills the same fraction: the cell of a jammed pack is not moved by a digit."""
    source = SpherePackSource(NumberOfSpheres=300, Fraction=0.64, Seed=3)
    name = os.path.join(FOLDER, 'source_%d.extxyz' % RANKS)
    SaveData(name, proxy=source)
    data, again = fetch(source), fetch(SpherePackReader(FileName=name))
    assert [data.GetPoint(i) for i in range(300)] == [again.GetPoint(i) for i in range(300)]
    assert list(field(data, 'BoxSize')) == list(field(again, 'BoxSize'))


def two_sizes():
    source = SpherePackSource(NumberOfSpheres=300, Fraction=0.6, Sizes='Classes', Diameters=[1, 3], Shares=[30, 70], Walls=[0, 0, 1])
    data = fetch(source)
    radius, mode = (data.GetPointData().GetArray(name) for name in ('Radius', 'Mode'))
    assert all(radius.GetValue(i) == (1.5 if mode.GetValue(i) == 2 else 0.5) for i in range(300))
    edge = field(data, 'BoxSize')[2]
    assert all(radius.GetValue(i) <= data.GetPoint(i)[2] <= edge - radius.GetValue(i) for i in range(300))
    assert [int(x) for x in field(data, 'BoxPeriodic')] == [1, 1, 0]


def equilibrated():
    """The pressure of a fluid is that of Carnahan and Starling, to three standard errors."""
    data = fetch(SpherePackSource(NumberOfSpheres=300, Fraction=0.4, EquilibrationTime=2000))
    pressure, error = field(data, 'ReducedPressure'), field(data, 'ReducedPressureError')
    assert 0 < error < 0.1 and abs(pressure - 6.926) < 3 * error, (pressure, error)


def dense_cell():
    """A cell of a dense pack has no overlap, its convergence tells the sum of the multipliers, and only Gradient finds it."""
    modes = ParticleModes(Input=SpherePackSource(NumberOfSpheres=400, Fraction=0.635), NumberOfModes=1)
    search = UnitCellReconstruction(Input=modes, NumberOfParticles=60, MaximumLag=2, NumberOfLags=20, MaximumIterations=400)
    convergence = columns(search, 1)
    assert list(convergence)[:4] == ['Iteration', 'Objective', 'OverlapPercent', 'SumOfMultipliers'], list(convergence)
    assert convergence['SumOfMultipliers'][0] == 0 < convergence['SumOfMultipliers'][-1] and field(fetch(search), 'OverlapPercent') == 0
    remember('dense cell', convergence['Objective'])
    search.Method = 'Annealed Population'
    expect_error(search, ['Method requires Gradient'])


def sizes_of_a_file():
    """A sieve curve in a file: the volume that passes the sieve in the middle is that of the curve, to the volume of a sphere."""
    name = os.path.join(FOLDER, 'sieves_%d.csv' % RANKS)
    with open(name, 'w') as sieves:
        sieves.write('sieve [mm], passing [%]\n0.5, 0\n1.0, 35\n1.4, 80\n2.0, 100\n')
    data = fetch(SpherePackSource(NumberOfSpheres=500, Fraction=0.5, Sizes='File', FileName=name))
    radius = data.GetPointData().GetArray('Radius')
    volumes = sorted((radius.GetValue(i), radius.GetValue(i)**3) for i in range(500))
    passed = sum(volume for r, volume in volumes if 2 * r < 1.4) / sum(volume for r, volume in volumes)
    assert abs(passed - 0.80) < 0.01, passed


run((pack, written, two_sizes, equilibrated, dense_cell, sizes_of_a_file), sys.argv[2])
