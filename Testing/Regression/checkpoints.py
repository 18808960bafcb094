# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Searches and packs that are killed at any moment go on from their checkpoint to the same end, bit by bit, on any number of ranks; and what a full
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
    'neighbours': ({'MaximumIterations': 80, 'ContactWeight': 1, 'PoreWeight': 1}, 2),
    'population': ({'Method': 'Annealed Population', 'Population': 24, 'MatingPool': 4, 'MaximumGenerations': 40}, 3),
    'hybrid': ({'Method': 'Hybrid', 'HybridPopulation': 4, 'RefinementSteps': 20, 'MaximumGenerations': 25}, 3),
}
RESULTS, MESSAGES = (os.path.join(FOLDER, name) for name in ('results.json', 'messages.txt'))
chance = random.Random(61301)


def require(good, what):
    if not good:
        sys.exit('FAILED: ' + what)


def start(searches, ranks=1):
    command = [PVBATCH, SEARCH, json.dumps(searches), RESULTS, MESSAGES]
    if ranks > 1:
        command = [MPIEXEC, '--oversubscribe', '-np', str(ranks)] + command
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, start_new_session=True)


def run(*searches, ranks=1):
    """For each of the searches, which one process does one after the other: what it said, and its result or None."""
    open(MESSAGES, 'w').close()  # so that no earlier run is taken for one that does not even begin
    output = start(searches, ranks).communicate(timeout=300)[0]
    with open(MESSAGES) as file:
        outputs = file.read().split('END\n')
    require(len(outputs) > len(searches), f'all searches come to an end, got {output[-2000:]}{outputs[-1][-2000:]}')
    with open(RESULTS) as file:
        return list(zip(outputs, json.load(file)))


def results(*searches, ranks=1):
    return [result for _, result in run(*searches, ranks=ranks)]


def difference(got, expected, output):
    """Where two results differ first, or what was said where there is none."""
    if not got:
        return 'got no result but ' + output[-500:]
    places = [n for n, (a, b) in enumerate(zip(got.split(), expected.split())) if a != b]
    return f'{len(got.split())} of {len(expected.split())} words, at {places[:5]} of which {len(places)} differ, got ' + ' '.join(
        got.split()[n] for n in places[:5])


def content(name):
    with open(name, 'rb') as file:
        return file.read()


def stamp(name):
    return os.stat(name).st_mtime_ns if os.path.exists(name) else None


def run_and_kill(settings, ranks):
    """Kills the search with all its ranks some time after it wrote a state; returns whether it was still at work."""
    name = settings['CheckpointFile']
    before = stamp(name)
    process = start([settings], ranks)
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
    expected = dict(zip(SEARCHES, results(*(settings for settings, _ in SEARCHES.values()))))
    later = {1: [], 2: []}  # what is still to be run on that many ranks
    for label, (settings, kills) in SEARCHES.items():
        require(expected[label], label + ' gives a result')
        name = os.path.join(FOLDER, label + '.state')
        writing = dict(settings, CheckpointFile=name, CheckpointInterval=0)
        for n in range(kills):
            killed += run_and_kill(writing, 1 + n % 2)
            shutil.copy(name, name + '.copy')
        later[1 + kills % 2].append((label + ' ends as if it had never been killed', label, writing))
        # From the last killed state on the other number of ranks
        later[2 - kills % 2].append((label + ' ends the same on other ranks', label, dict(writing, CheckpointFile=name + '.copy')))
        later[1].append((label + ' from its end is the same', label, writing))
    for ranks in (2, 1):
        for (what, label, _), result in zip(later[ranks], results(*(settings for _, _, settings in later[ranks]), ranks=ranks)):
            require(result == expected[label], what)
    require(killed >= 8, f'searches are long enough to be killed 10 times, were {killed} times')
    print('killed and resumed', flush=True)


def test_packs():
    """A pack that is killed, while its spheres grow or while they are pushed apart, goes on to the same pack, and refuses the state of another."""
    for label, settings in (('growing', {'NumberOfSpheres': 1500, 'Fraction': 0.64}),
                            ('pushed', {'NumberOfSpheres': 30000, 'Fraction': 0.6, 'Protocol': 'Soft'})):
        name = os.path.join(FOLDER, label + '.state')
        writing = dict(settings, CheckpointFile=name, CheckpointInterval=0)
        killed = sum(run_and_kill(writing, 1 + n % 2) for n in range(3))
        require(killed >= 2, f'{label} packs take long enough to be killed 3 times, were {killed} times')
        (_, expected), (_, resumed), (output, other) = run(settings, writing, dict(writing, Seed=2))
        require(expected and resumed == expected, f'a {label} pack ends as if it had never been killed')
        require(other is None and 'other settings' in output, f'another pack is refused, got {output[-300:]}')
    print('packs killed and resumed', flush=True)


def test_cells():
    """Several cells have a file each."""
    settings = {'MaximumIterations': 60, 'NumberOfCells': 3}
    name = os.path.join(FOLDER, 'cells.state')
    run(dict(settings, MaximumIterations=20, CheckpointFile=name), ranks=2)
    require(sorted(os.listdir(FOLDER)).count('cells.state.3') == 1, 'cell 3 has a file of its own')
    os.remove(name + '.2')
    expected, resumed = results(settings, dict(settings, CheckpointFile=name))
    require(expected and resumed == expected, 'three cells, two of which resume')


def run_until_stopped(settings, name, limit):
    """What a search says that is stopped by a TimeLimit, shorter on quicker machines; and its settings."""
    for attempt in range(10):
        limited = dict(settings, TimeLimit=limit / 2 ** attempt, CheckpointFile=f'{name}-{attempt}')
        result, = results(limited, ranks=2)
        require(result is not None, name + ' gives a result')
        if result.count('Time limit') == settings.get('NumberOfCells', 1):  # none has come to its end
            return result, limited
    sys.exit(f'FAILED: {name} is never stopped')


def test_stopped():
    """A search that was stopped is shown as it was, bit by bit, by whoever runs it again, until it shall go on; then it ends as if never stopped."""
    # At once, before there is a state, and on the way
    for label, settings, limit in (('gradient', {'MaximumIterations': 300}, 1e-9), ('hybrid', SEARCHES['hybrid'][0], 0.6),
                                   ('cells', {'MaximumIterations': 300, 'NumberOfCells': 2}, 0.6)):
        stopped, limited = run_until_stopped(settings, os.path.join(FOLDER, 'stopped-' + label), limit)
        again = run(limited, ranks=2)
        expected, *further = run(settings, limited,
                                 dict(limited, TimeLimit=1e-9, ContinueAfterStops=-1),  # a second stop, at once
                                 dict(limited, ContinueAfterStops=1), dict(limited, TimeLimit=0, ContinueAfterStops=2))
        for output, shown in (again[0], further[0]):
            require(shown == stopped, f'{label} is shown as it was: {difference(shown, stopped, output)}')
            require('ContinueAfterStops to 1' in output, f'{label} says how to go on, got {output[-300:]}')
        output, shown = further[2]
        require('ContinueAfterStops to 2' in output and shown, f'{label} counts its stops, got {output[-300:]}')
        require(expected[1] and further[3][1] == expected[1], f'{label} goes on to the same end')
        print(label, 'stopped, shown and carried on', flush=True)
    (output, _), = run({'TimeLimit': 1e-9})
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
    cases = {1: (('truncated', good[:len(good) // 2], settings, 'truncated'), ('longer', good + b'x', settings, 'CheckpointFile'),
                 ('empty', b'', settings, 'empty'), ('method', good, SEARCHES['hybrid'][0], 'method')),
             2: (('flipped bit', bytes(flipped), settings, 'CheckpointFile'), ('text', b'x,y,z\n1,2,3\n', settings, 'no checkpoint'),
                 ('seed', good, other, 'seed'))}
    for ranks, of_ranks in cases.items():
        searches = []
        for what, data, wanted, _ in of_ranks:
            with open(f'{name} {what}', 'wb') as file:
                file.write(data)
            searches.append(dict(wanted, CheckpointFile=file.name))
        searches.append(dict(settings, CheckpointFile=os.path.join(FOLDER, 'nowhere', 'state')))
        *refused, nowhere = run(*searches, ranks=ranks)
        for (what, data, _, reason), (output, result) in zip(of_ranks, refused):
            require(result is None, what + ' is refused')
            require('ERR' in output and reason in output, f'{what} is refused with a reason, got {output}')
            require(content(f'{name} {what}') == data, what + ' is left as it is')
        output, result = nowhere
        require(result is None and 'a folder that is there' in output, f'a name in no folder is refused before the search, got {output[-300:]}')
    print('refused what is no checkpoint', flush=True)


def test_neighbours():
    """Files beside the checkpoint that are not the search's own are left as they are, and what is no regular file hangs nothing."""
    settings = {'MaximumIterations': 20}
    folder = os.path.join(FOLDER, 'neighbours')
    os.makedirs(folder)
    precious, linked, pipe = (os.path.join(folder, name) for name in ('notes.new', 'victim', 'pipe'))
    for name in (precious, linked):
        with open(name, 'wb') as file:
            file.write(b'precious')
    os.symlink(linked, os.path.join(folder, 'state.new'))
    os.mkfifo(pipe)
    os.mkfifo(pipe + '.new')
    checkpoints = [os.path.join(folder, name) for name in ('notes', 'state')]
    expected, *written, refused, no_pipe, no_folder = run(
        settings, *(dict(settings, CheckpointFile=name, CheckpointInterval=0) for name in checkpoints), dict(settings, CheckpointFile=pipe),
        dict(settings, StopFile=pipe), dict(settings, StopFile=folder))
    for name, (_, result) in zip(checkpoints, written):
        require(expected[1] and result == expected[1], f'a search with {name}')
        require(os.path.isfile(name), f'{name} is written')
    require(content(precious) == content(linked) == b'precious', 'files of others are left as they are')
    require(refused[1] is None and 'CheckpointFile requires' in refused[0], f'a pipe is no checkpoint, got {refused[0]}')
    require(no_pipe[1] == no_folder[1] == expected[1], 'a pipe and a folder are no files that end a search')
    print('left what is not its own', flush=True)


def mount(folder, options):
    return subprocess.run(['mount', '-t', 'tmpfs', '-o', options, 'tmpfs', folder], capture_output=True).returncode == 0


def test_disk():
    """A disk that is full, and then read-only: the search goes on, the last good state remains."""
    settings = SEARCHES['population'][0]
    disk = os.path.join(FOLDER, 'disk')
    os.makedirs(disk, exist_ok=True)
    # There is room for one state, but not for two
    if not mount(disk, 'size=420k'):
        print('no tmpfs can be mounted here: not tested with a full disk')
        return
    try:
        name = os.path.join(disk, 'state')
        (_, expected), (output, result) = run(settings, dict(settings, CheckpointFile=name, CheckpointInterval=0))
        require('No space left' in output and 'last good one remains' in output, 'a full disk is told, got ' + output[-2000:])
        require(expected and result == expected, 'a full disk does not stop the search')
        require(os.listdir(disk) == ['state'], f'only the last good state remains, got {os.listdir(disk)}')
        kept = os.path.join(FOLDER, 'kept.state')
        shutil.copy(name, kept)
        require(subprocess.run(['mount', '-o', 'remount,ro', disk]).returncode == 0, 'the disk can be made read-only')
        (_, resumed), (output, result) = run(dict(settings, CheckpointFile=kept), dict(settings, CheckpointFile=name, CheckpointInterval=0))
        require(resumed == expected, 'the state before the disk was full is good')
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
test_packs()
test_cells()
test_stopped()
test_refused()
test_neighbours()
test_disk()
