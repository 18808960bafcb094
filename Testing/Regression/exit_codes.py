# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Every example ends at the first error with an exit code that is not 0, and so does a script that begins with the lines of the README.

    python3 exit_codes.py MPIEXEC PVBATCH FOLDER
"""
import os
import re
import shutil
import subprocess
import sys

MPIEXEC, PVBATCH, FOLDER = sys.argv[1:4]
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
ERROR = re.compile(r'ERR\|.*')


def run(script, *arguments, ranks=1):
    """Exit code, output and errors of a script in a folder of its own."""
    shutil.rmtree(FOLDER, ignore_errors=True)
    os.makedirs(FOLDER)
    with open(os.path.join(FOLDER, 'bad.csv'), 'w', encoding='utf-8') as file:
        file.write('x,y,z,radius\n1,2,oops,0.3\n')
    command = [MPIEXEC, '--oversubscribe', '-np', str(ranks), PVBATCH, script, *arguments]
    # Errors by themselves: mpiexec puts what a script prints into the middle of their lines
    done = subprocess.run(command, cwd=FOLDER, capture_output=True, text=True, timeout=100, check=False)
    return done.returncode, done.stdout + done.stderr, ERROR.findall(done.stderr)


def require_end(what, code, output, errors):
    """The script ended at the first error, which is the reader's; ParaView has printed it, and nothing came of it."""
    assert code != 0, (what, code, output)
    assert len(errors) == 1 and 'Sphere Pack Reader' in errors[0] and 'oops' in errors[0], (what, errors, output)
    files = [name for _, _, names in os.walk(FOLDER) for name in names]
    assert files == ['bad.csv'], (what, files)
    print(what, flush=True)


def examples(option):
    """The examples that have an option."""
    for name in sorted(os.listdir(os.path.join(ROOT, 'Examples'))):
        path = os.path.join(ROOT, 'Examples', name)
        if name.endswith('.py') and name != 'common.py':
            with open(path, encoding='utf-8') as file:
                if option in file.read():
                    yield path


def readme():
    """The ten lines of the README after the lines that stop, on a pack with an error."""
    with open(os.path.join(ROOT, 'README.md'), encoding='utf-8') as file:
        blocks = re.findall(r'```python\n(.*?)```', file.read(), re.DOTALL)
    stop, = (block for block in blocks if 'ErrorEvent' in block)
    return stop + blocks[0].replace('Examples/Data/bead_block.csv', 'bad.csv')


found = [*examples('make_parser('), *examples('= parse_arguments(\n')]
assert len(found) >= 5, found
for path in found:
    require_end(path, *run(path, '--input', 'bad.csv', '--output', 'results'))
require_end(found[-1] + ' on 2 ranks', *run(found[-1], '--input', 'bad.csv', '--output', 'results', ranks=2))
script = FOLDER + '.py'
with open(script, 'w', encoding='utf-8') as file:
    file.write(readme())
for ranks in (1, 2):
    require_end('README on %d ranks' % ranks, *run(script, ranks=ranks))
print('exit_codes.py: passed')
