# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""The cases: for every proxy of the plugin, as child.py describes them, hostile values and data, one at a time and in pairs.

A case is {'proxy': name, 'inputs': {input: 'kind/name' of data.py}, 'set': {property: values}}; settings that are only small are part of it,
so that a case says all.
"""
import itertools
import math
import random

INTEGERS = [0, -1, 1, 2, 1000, 1000000, 2**31 - 1, -2**31]
HOSTILE = {
    'int': INTEGERS,
    'id': INTEGERS + [2**63 - 1, -2**63],
    'double': [math.nan, math.inf, -math.inf, 0.0, -1.0, 1e-5, 1e7, 1e300, -1e300, 1e-300, 5e-324],
    'text': ['', ' ', '; ;', ';', ',', '0 0', '-1 m', '1 2 3', '999 999', 'm m m; 999999999999 1 1', 'all', 'nan', '%s%n%d', '1e400', '@long',
             '@latin1', '@control', '1 1;' * 5000],
    'file': ['@folder', '@missing', '@missing/file', '@fifo', '@piped', '@planted', '@notes', '@link', '@loop', '@dangling', '@empty', '@huge',
             '@noise', '@victim', '/dev/full', '/dev/null', '/dev/zero', '@long'],
}
LENGTHS = [0, 1, 2, 9, 30, 5000]  # the lengths of lists

# These values keep a good case at milliseconds. A property that is not named here and is a larger whole number than 50 is set to 10.
SMALL = {'NumberOfLines': [200], 'NumberOfThrows': [200], 'MaximumIterations': [2], 'MaximumGenerations': [2], 'Population': [8], 'MatingPool': [4],
         'HybridPopulation': [8], 'HybridMatingPool': [4], 'RefinementSteps': [2], 'NumberOfParticles': [20], 'CheckpointInterval': [0.0],
         'Resolution': [4], 'SecondResolution': [0], 'SurfaceResolution': [8], 'NumberOfSpheres': [40]}


# Not attacked yet: of images of two voxels along an edge three ranks have some twice, and Method Bounds leaves the columns of the solver NaN
LATER = ['EffectiveProperties']
# What is not finite where it is known that it cannot be: the chords of a mode that no line met
KNOWN = {'ChordLengths': {'0:%s is not finite' % name for name in
                          ['MeanChordLength', *(column % mode for mode in range(1, 40) for column in ('p_%d', 'p_%d_error', 'L_%d', 'L_%d_error'))]}}

# The good input of a proxy, where it is not the good one of its kind
GOOD = {'ParticlesFromImage': {'Input': 'image/good particle'}}


def small(settings):
    """The settings of a good case of a proxy."""
    made = {}
    for name, setting in settings.items():
        if name in SMALL:
            made[name] = SMALL[name]
        elif setting['type'] == 'int' and not setting['choices'] and setting['default'] and setting['default'][0] > 50:
            made[name] = [10]
        elif name == 'FileName' and setting['file']:
            made[name] = ['@pack']
    return made


def make(description, name, values=None, inputs=None):
    proxy = description['proxies'][name]
    good = {key: found['kinds'][0] + '/good' for key, found in proxy['inputs'].items() if not found['optional']}
    good.update(GOOD.get(name, {}))
    return {'proxy': name, 'inputs': {**good, **(inputs or {})}, 'set': {**small(proxy['settings']), **(values or {})}}


def hostile(setting):
    """Every hostile value of a property: all its elements, then each alone, then lists that are too short and too long."""
    values = HOSTILE['text'] + HOSTILE['file'] if setting['file'] else HOSTILE[setting['type']]
    default = setting['default'] or [1 if setting['type'] != 'text' else '1']
    if setting['list']:
        return [[value] * length for length in LENGTHS for value in (default[0], values[0], values[3])] + [[v, v] for v in values]
    if len(default) == 1:
        return [[value] for value in values]
    return ([[value] * len(default) for value in values] +
            [[*default[:i], value, *default[i + 1:]] for i in range(len(default)) for value in values])


def choices(proxy):
    """{property: value} for every choice of every enumeration and switch, the default first."""
    return [{}] + [{name: [int(value)]} for name, setting in proxy['settings'].items() for value in setting['choices']]


def data_cases(description):
    """Every data set of every input with every choice."""
    for name, proxy in description['proxies'].items():
        for choice in choices(proxy):
            for key, found in proxy['inputs'].items():
                for kind in found['kinds']:
                    for data in description['data'][kind]:
                        yield make(description, name, choice, {key: data})


def property_cases(description):
    """Every hostile value of every property with every choice of the first enumeration, which is the method where there is one."""
    for name, proxy in description['proxies'].items():
        methods = next((s['choices'] for k, s in proxy['settings'].items() if k == 'Method'), None)
        for key, setting in proxy['settings'].items():
            for values, method in itertools.product(hostile(setting), methods or [None]):
                yield make(description, name, {**({} if method is None else {'Method': [int(method)]}), key: values})


def pair(description, chance):
    """Two or three hostile things at once."""
    name, proxy = chance.choice(list(description['proxies'].items()))
    values, inputs = dict(chance.choice(choices(proxy))), {}
    for key in chance.sample(sorted(proxy['settings']), min(2, len(proxy['settings']))):
        values[key] = chance.choice(hostile(proxy['settings'][key]))
    for key, found in proxy['inputs'].items():
        if chance.random() < (0.2 if found['optional'] else 0.3):
            inputs[key] = chance.choice(description['data'][chance.choice(found['kinds'])])
    return make(description, name, values, inputs)


def campaign(description, seed):
    """All cases in an order that is the seed's: first every data set and every property of every proxy, then the other single ones, and pairs
    for ever."""
    chance = random.Random(seed)
    single = list(data_cases(description)) + list(property_cases(description))
    chance.shuffle(single)
    seen, first, rest = set(), [], []
    for case in single:
        plain = small(description['proxies'][case['proxy']]['settings'])
        changed = [data for data in case['inputs'].values() if '/good' not in data]
        changed += [(case['proxy'], key) for key, values in case['set'].items() if values != plain.get(key)]
        new = [item for item in changed if item not in seen]
        seen.update(new)
        (first if new else rest).append(case)
    yield from first
    while True:
        for _ in range(3):
            if rest:
                yield rest.pop()
        yield pair(description, chance)


def good_cases(description):
    return [make(description, name) for name in description['proxies']]


def simpler(description, case):
    """The cases that have one hostile thing less."""
    plain = make(description, case['proxy'])
    for key in case['set']:
        if case['set'][key] != plain['set'].get(key):
            yield {**case, 'set': {**{k: v for k, v in case['set'].items() if k != key}, **({key: plain['set'][key]} if key in plain['set'] else {})}}
    for key, value in case['inputs'].items():
        if value != plain['inputs'].get(key):
            inputs = {k: v for k, v in case['inputs'].items() if k != key}
            yield {**case, 'inputs': {**inputs, **({key: plain['inputs'][key]} if key in plain['inputs'] else {})}}


def what(description, case):
    """In a few words, in what a case differs from a good one."""
    plain = make(description, case['proxy'])
    words = ['%s %s' % (key, value) for key, value in case['inputs'].items() if value != plain['inputs'].get(key)]
    for key, values in case['set'].items():
        if values != plain['set'].get(key):
            words.append('%s=%s' % (key, values[0] if len(values) == 1 else str(values[:3])[:-1] + ', … %d]' % len(values) if len(values) > 3 else values))
    return '; '.join(word if len(word) < 60 else word[:57] + '…' for word in words) or 'nothing'
