# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Files of other programs as a user opens them: by their name alone, one frame after the other, a file a step, and with what the panel offers."""
import gzip
import os
import shutil
import sys

from paraview.simple import *
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from harness import RANKS, expect_error, fetch, field, run

folder = os.path.join(sys.argv[1], 'formats_%d' % RANKS)
data = os.path.join(sys.argv[2], 'formats', 'same_pack')
shutil.rmtree(folder, ignore_errors=True)
os.makedirs(folder)


def frame(step, x):
    """Three spheres, the first of them at x."""
    return ('ITEM: TIMESTEP\n%d\nITEM: NUMBER OF ATOMS\n3\nITEM: BOX BOUNDS pp pp pp\n0 10\n0 10\n0 10\nITEM: ATOMS id type x y z radius\n'
            '2 1 5 5 5 0.5\n1 2 %r 2 3 0.25\n3 1 8 8 8 0.5\n' % (step, x))


def write(name, text):
    path = os.path.join(folder, name)
    with (gzip.open if name.endswith('.gz') else open)(path, 'wt') as file:
        file.write(text)
    return path


def expect_first(reader, steps):
    """The centre x of the first sphere at each time, as a filter behind the reader gets it."""
    modes = ParticleModes(Input=reader, Method='One Per Size')
    for time, x in steps:
        modes.UpdatePipeline(time)
        assert modes.GetDataInformation().GetNumberOfPoints() == 3, time
        assert servermanager.Fetch(modes).GetPoint(0)[0] == x, time
    Delete(modes)


def test_frames():
    for name in ('frames.dump', 'frames.dump.gz'):
        reader = SpherePackReader(FileName=write(name, frame(0, 1.0) + frame(100, 1.5) + frame(200, 2.0)))
        assert list(reader.TimestepValues) == [0, 100, 200]
        expect_first(reader, ((0, 1.0), (100, 1.5), (200, 2.0), (150, 1.5), (0, 1.0)))
        Delete(reader)


def test_series():
    names = [write(name, frame(step, x)) for name, step, x in (('dump.0', 0, 1.0), ('dump.500', 500, 1.5), ('dump.1000.gz', 1000, 2.0))]
    reader = OpenDataFile(names)
    assert list(reader.TimestepValues) == [0, 500, 1000]
    expect_first(reader, ((0, 1.0), (500, 1.5), (1000, 2.0), (500, 1.5), (0, 1.0)))
    Delete(reader)
    # Tables tell no times: they are numbered
    names = [write('table.%d.csv' % n, 'x,y,z,r\n%r,2,3,0.5\n5,5,5,0.5\n8,8,8,0.5\n' % (1.0 + n)) for n in range(3)]
    reader = SpherePackReader(FileName=names, BoxSize=[10, 10, 10])
    assert list(reader.TimestepValues) == [0, 1, 2]
    expect_first(reader, ((2, 3.0), (1, 2.0)))
    Delete(reader)


def test_opened_by_name():
    for name in sorted(os.listdir(data)) if RANKS == 1 else ():
        if name.endswith(('.nfo', '.vtk', '.vtp')):
            continue
        path = os.path.join(data, name)
        reader = SpherePackReader(FileName=path) if name.endswith(('.csv', '.txt', '.dat', '.xyz')) else OpenDataFile(path)
        if name in ('lammps_atom_no_radius.dump', 'no_header_id_first.txt', 'positions_only.csv'):
            continue
        assert reader.SMProxy.GetXMLName() == 'SpherePackReader', (name, reader)
        pack = fetch(reader)
        assert pack.GetNumberOfPoints() == 500, (name, pack.GetNumberOfPoints())
        Delete(reader)


def test_formats_of_the_panel():
    reader = SpherePackReader(FileName=os.path.join(data, 'truth.csv'))
    formats = reader.GetProperty('Format').GetDomain('formats')
    names = [formats.GetString(n) for n in range(formats.GetNumberOfStrings())]
    reader.Format = 'none of them'
    expect_error(reader, ['Format requires %s; got' % ', '.join(names)])
    reader.Format = 'table'
    assert fetch(reader).GetNumberOfPoints() == 500


def test_refusal_of_one_frame():
    whole = frame(0, 1.0) + frame(100, 1.5)
    reader = SpherePackReader(FileName=write('cut.dump', whole[:-20]))
    expect_first(reader, ((0, 1.0),))
    assert field(fetch(reader), 'TimeValue') == 0
    assert list(reader.TimestepValues) == [0, 100]
    window, former = vtkStringOutputWindow(), vtkOutputWindow.GetInstance()
    vtkOutputWindow.SetInstance(window)
    reader.UpdatePipeline(100)
    vtkOutputWindow.SetInstance(former)
    assert 'Frame 2: ' in window.GetOutput() and reader.GetDataInformation().GetNumberOfPoints() == 0, window.GetOutput()


def test_state_moved_with_its_file():
    here, there = os.path.join(folder, 'here'), os.path.join(folder, 'there')
    os.makedirs(here)
    reader = SpherePackReader(FileName=write('here/pack.csv', 'x,y,z,radius\n1,1,1,0.5\n3,3,3,0.5\n'), BoxSize=[4, 4, 4], BoxPeriodic=[1, 1, 1])
    RenameSource('functions', TwoPointProbability(Input=ParticleModes(Input=reader, Method='One Per Size'), NumberOfLags=5))
    SaveState(os.path.join(here, 'state.pvsm'))
    os.rename(here, there)
    ResetSession()
    LoadState(os.path.join(there, 'state.pvsm'), data_directory=there)
    assert fetch(FindSource('functions')).GetNumberOfRows() == 6


run([test_frames, test_series, test_opened_by_name, test_formats_of_the_panel, test_refusal_of_one_frame] + [test_state_moved_with_its_file] * (RANKS == 1))
