# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Times dumps through the Sphere Pack Reader, in seconds of the processor; started by Testing/Benchmark/run. Prints one line for each figure. What a
pass of the file takes by itself stands beside it."""
import gzip
import os
import random
import resource
import statistics
import subprocess
import tempfile
import time

from paraview import servermanager
from paraview.simple import *

ranks = servermanager.ActiveConnection.GetNumberOfDataPartitions()


def seconds(work):
    def used():
        children = resource.getrusage(resource.RUSAGE_CHILDREN)
        return time.process_time() + children.ru_utime + children.ru_stime
    begin = used()
    work()
    return used() - begin


def tell(what, figure):
    print('%-64s ranks %d  %.2f' % (what, ranks, figure))


def rows(count):
    edge = count ** (1 / 3)
    place = random.Random(7).uniform
    return ''.join('%d %d %.6f %.6f %.6f 0.4\n' % (n + 1, n % 3 + 1, place(0, edge), place(0, edge), place(0, edge)) for n in range(count))


def header(step, count):
    edge = count ** (1 / 3)
    return 'ITEM: TIMESTEP\n%d\nITEM: NUMBER OF ATOMS\n%d\nITEM: BOX BOUNDS pp pp pp\n%sITEM: ATOMS id type x y z radius\n' % (
        step, count, ('0 %r\n' % edge) * 3)


def times_of_reading(name):
    readers = []
    opened = seconds(lambda: readers.append(SpherePackReader(FileName=name)))
    return opened, seconds(readers[0].UpdatePipeline), readers[0]


with tempfile.TemporaryDirectory() as folder:
    name = os.path.join(folder, 'frames.dump')
    body = rows(100000)
    with open(name, 'w') as file:
        for step in range(200):
            file.write(header(step, 100000) + body)
    size = os.path.getsize(name) / 1e9
    tell('cat of 200 frames of 1e5 rows, %.1f GB, s' % size, seconds(lambda: subprocess.run(['cat', name], stdout=subprocess.DEVNULL)))
    opened, first, reader = times_of_reading(name)
    tell('opening it, s', opened)
    steps = [seconds(lambda: reader.UpdatePipeline(step)) for step in range(1, 40)]
    tell('one step to the next: median of 39, s', statistics.median(steps))
    os.remove(name)

    body = header(0, 1000000) + rows(1000000)
    with open(name, 'w') as file:
        file.write(body)
    packed = name + '.gz'
    with gzip.open(packed, 'wt', compresslevel=6) as file:
        file.write(body)
    tell('zcat of 1e6 rows of a dump, s', seconds(lambda: subprocess.run(['zcat', packed], stdout=subprocess.DEVNULL)))
    for what, dump in (('a dump', name), ('a packed dump', packed)):
        opened, first, reader = times_of_reading(dump)
        tell('1e6 rows of %s: opening, s' % what, opened)
        tell('1e6 rows of %s: the pack, s' % what, first)
