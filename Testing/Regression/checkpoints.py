# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Searches that are killed at any moment go on from their checkpoint to the same end, bit by bit, on any number of ranks; and what a full
disk, a read-only folder and a file that is no checkpoint do.

    python3 checkpoints.py MPIEXEC PVBATCH FOLDER
"""
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import time

MPIEXEC, PVBATCH, FOLDER = sys.argv[1:4]
SEARCH = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'checkpoint_search.py')
SEARCHES = {
    'gradient': ({'MaximumIterations': 600}, 4),
    'population': ({'Method': 'Annealed Population', 'Population': 24, 'MatingPool': 4, 'MaximumGenerations': 40}, 3),
    'hybrid': ({'Method': 'Hybrid', 'HybridPopulation': 4, 'RefinementSteps': 20, 'MaximumGenerations': 25}, 3),
}
chance = random.Random(61301)


def require(good, what):
    if not good:
        sys.exit('FAILED: ' + what)


def start(settings, ranks=1):
    command = [PVBATCH, SEARCH, json.dumps(settings)]
    if ranks > 1:
        command = [MPIEXEC, '--oversubscribe', '-np', str(ranks)] + command
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, start_new_session=True)


def run(settings, ranks=1):
    """The output of a search, and the result in it or None."""
    output = start(settings, ranks).communicate(timeout=120)[0]
    return output, next((line for line in output.splitlines() if line.startswith('RESULT')), None)


def content(name):
    with open(name, 'rb') as file:
        return file.read()


def stamp(name):
    return os.stat(name).st_mtime_ns if os.path.exists(name) else None


def run_and_kill(settings, ranks):
    """Kills the search with all its ranks some time after it wrote a state; returns whether it was still at work."""
    name = settings['CheckpointFile']
    before = stamp(name)
    process = start(settings, ranks)
    while stamp(name) == before and process.poll() is None:
        time.sleep(0.002)
    time.sleep(chance.uniform(0.0, 0.15))
    alive = process.poll() is None
    if alive:
        os.killpg(process.pid, signal.SIGKILL)
    process.communicate()
    # The ranks are in process groups of their own
    subprocess.run(['pkill', '-KILL', '-f', name], check=False)
    return alive


def test_kills():
    killed = 0
    for label, (settings, kills) in SEARCHES.items():
        expected = run(settings)[1]
        require(expected, label + ' gives a result')
        name = os.path.join(FOLDER, label + '.state')
        writing = dict(settings, CheckpointFile=name, CheckpointInterval=0)
        for n in range(kills):
            killed += run_and_kill(writing, 1 + n % 2)
            shutil.copy(name, name + '.copy')
        require(run(writing, 1 + kills % 2)[1] == expected, label + ' ends as if it had never been killed')
        # The search goes on from the last killed state on the other number of ranks, and from its end
        writing['CheckpointFile'] = name + '.copy'
        require(run(writing, 2 - kills % 2)[1] == expected, label + ' ends the same on other ranks')
        require(run(writing)[1] == expected, label + ' from its end is the same')
        print(label, 'killed and resumed', flush=True)
    require(killed >= 8, f'searches are long enough to be killed 10 times, were {killed} times')


def test_cells():
    """Several cells have a file each."""
    settings = {'MaximumIterations': 60, 'NumberOfCells': 3}
    expected = run(settings)[1]
    name = os.path.join(FOLDER, 'cells.state')
    short = dict(settings, MaximumIterations=20, CheckpointFile=name)
    run(short, 2)
    require(sorted(os.listdir(FOLDER)).count('cells.state.3') == 1, 'cell 3 has a file of its own')
    os.remove(name + '.2')
    require(run(dict(settings, CheckpointFile=name))[1] == expected, 'three cells, two of which resume')


def run_until_stopped(settings, name, limit):
    """What a search says that is stopped by a TimeLimit, shorter on quicker machines; and its settings."""
    for attempt in range(10):
        limited = dict(settings, TimeLimit=limit / 2 ** attempt, CheckpointFile=f'{name}-{attempt}')
        result = run(limited, 2)[1]
        require(result is not None, name + ' gives a result')
        if result.count('Time limit') == settings.get('NumberOfCells', 1):  # none has come to its end
            return result, limited
    sys.exit(f'FAILED: {name} is never stopped')


def test_stopped():
    """A search that was stopped is shown as it was, bit by bit, by whoever runs it again, until it shall go on; then it ends as if never stopped."""
    # At once, before there is a state, and on the way
    for label, settings, limit in (('gradient', {'MaximumIterations': 300}, 1e-9), ('hybrid', SEARCHES['hybrid'][0], 0.6),
                                   ('cells', {'MaximumIterations': 300, 'NumberOfCells': 2}, 0.6)):
        expected = run(settings)[1]
        stopped, limited = run_until_stopped(settings, os.path.join(FOLDER, 'stopped-' + label), limit)
        for ranks in (1, 2):
            output, shown = run(limited, ranks)
            require(shown == stopped, f'{label} is shown as it was, on {ranks} ranks')
            require('ContinueAfterStops to 1' in output, f'{label} says how to go on, got {output[-300:]}')
        run(dict(limited, TimeLimit=1e-9, ContinueAfterStops=-1))  # a second stop, at once
        output, shown = run(dict(limited, ContinueAfterStops=1))
        require('ContinueAfterStops to 2' in output and shown, f'{label} counts its stops, got {output[-300:]}')
        require(run(dict(limited, TimeLimit=0, ContinueAfterStops=2))[1] == expected, f'{label} goes on to the same end')
        print(label, 'stopped, shown and carried on', flush=True)
    output = run({'TimeLimit': 1e-9})[0]
    require(output.count('searches anew when it is loaded') == 1, f'it is said once that a state file does not keep a cell, got {output[-300:]}')


def test_refused():
    """Files that are no checkpoint are refused with a reason and left as they are."""
    settings = {'MaximumIterations': 20}
    name = os.path.join(FOLDER, 'refused.state')
    run(dict(settings, CheckpointFile=name))
    good = content(name)
    flipped = bytearray(good)
    flipped[chance.randrange(len(good))] ^= 1 << chance.randrange(8)
    other = dict(settings, Seed=2)
    for what, data, wanted, ranks, reason in (
            ('flipped bit', bytes(flipped), settings, 2, 'CheckpointFile'), ('truncated', good[:len(good) // 2], settings, 1, 'truncated'),
            ('longer', good + b'x', settings, 1, 'CheckpointFile'), ('text', b'x,y,z\n1,2,3\n', settings, 2, 'no checkpoint'),
            ('empty', b'', settings, 1, 'empty'), ('seed', good, other, 2, 'seed'),
            ('method', good, SEARCHES['hybrid'][0], 1, 'method')):
        with open(name, 'wb') as file:
            file.write(data)
        output, result = run(dict(wanted, CheckpointFile=name), ranks)
        require(result is None, what + ' is refused')
        require('ERR' in output and reason in output, f'{what} is refused with a reason, got {output}')
        require(content(name) == data, what + ' is left as it is')
    output, result = run(dict(settings, CheckpointFile=os.path.join(FOLDER, 'nowhere', 'state')), 2)
    require(result is None and 'a folder that is there' in output, f'a name in no folder is refused before the search, got {output[-300:]}')
    print('refused what is no checkpoint', flush=True)


def test_neighbours():
    """Files beside the checkpoint that are not the search's own are left as they are, and what is no regular file hangs nothing."""
    settings = {'MaximumIterations': 20}
    expected = run(settings)[1]
    folder = os.path.join(FOLDER, 'neighbours')
    os.makedirs(folder)
    precious, linked, pipe = (os.path.join(folder, name) for name in ('notes.new', 'victim', 'pipe'))
    for name in (precious, linked):
        with open(name, 'wb') as file:
            file.write(b'precious')
    os.symlink(linked, os.path.join(folder, 'state.new'))
    os.mkfifo(pipe)
    os.mkfifo(pipe + '.new')
    for name in ('notes', 'state'):
        checkpoint = os.path.join(folder, name)
        require(run(dict(settings, CheckpointFile=checkpoint, CheckpointInterval=0))[1] == expected, f'a search with {name}')
        require(os.path.isfile(checkpoint), f'{name} is written')
    require(content(precious) == content(linked) == b'precious', 'files of others are left as they are')
    output, result = run(dict(settings, CheckpointFile=pipe))
    require(result is None and 'CheckpointFile requires' in output, 'a pipe is no checkpoint, got ' + output)
    for stop in (pipe, folder):
        require(run(dict(settings, StopFile=stop))[1] == expected, f'{stop} is no file that ends a search')
    print('left what is not its own', flush=True)


def mount(folder, options):
    return subprocess.run(['mount', '-t', 'tmpfs', '-o', options, 'tmpfs', folder], capture_output=True).returncode == 0


def test_disk():
    """A disk that is full, and then read-only: the search goes on, the last good state remains."""
    settings = SEARCHES['population'][0]
    expected = run(settings)[1]
    disk = os.path.join(FOLDER, 'disk')
    os.makedirs(disk, exist_ok=True)
    # There is room for one state, but not for two
    if not mount(disk, 'size=420k'):
        print('no tmpfs can be mounted here: not tested with a full disk')
        return
    try:
        name = os.path.join(disk, 'state')
        output, result = run(dict(settings, CheckpointFile=name, CheckpointInterval=0))
        require('No space left' in output and 'last good one remains' in output, 'a full disk is told, got ' + output[-2000:])
        require(result == expected, 'a full disk does not stop the search')
        require(os.listdir(disk) == ['state'], f'only the last good state remains, got {os.listdir(disk)}')
        kept = os.path.join(FOLDER, 'kept.state')
        shutil.copy(name, kept)
        require(run(dict(settings, CheckpointFile=kept))[1] == expected, 'the state before the disk was full is good')
        require(subprocess.run(['mount', '-o', 'remount,ro', disk]).returncode == 0, 'the disk can be made read-only')
        output, result = run(dict(settings, CheckpointFile=name, CheckpointInterval=0))
        require('Read-only' in output and result == expected, 'a read-only disk is told and does not stop the search')
        print('full and read-only disk', flush=True)
    finally:
        subprocess.run(['umount', disk])


shutil.rmtree(FOLDER, ignore_errors=True)
os.makedirs(FOLDER)
# A mount of its own, that ends with this process
if '--own-mounts' not in sys.argv:
    inside = [sys.executable, os.path.abspath(__file__)] + sys.argv[1:4] + ['--own-mounts']
    for unshare in (['unshare', '-m'], ['unshare', '-rm']):
        if subprocess.run(unshare + ['true'], capture_output=True).returncode == 0:
            sys.exit(subprocess.run(unshare + inside).returncode)
test_kills()
test_cells()
test_stopped()
test_refused()
test_neighbours()
test_disk()
