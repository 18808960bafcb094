# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""pvbatch child.py FOLDER: tells what there is to attack, then runs the cases that come on stdin, a line of JSON each.

For `run`, which watches from outside. On one rank every case has a process of its own.
"""
import json
import os
import sys
import tempfile
import traceback

import numpy
from paraview import servermanager
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet

HERE = os.path.dirname(os.path.abspath(sys.argv[0]))
if HERE not in sys.path:
    sys.path.insert(0, HERE)
import data  # noqa: E402

if not servermanager.ActiveConnection:  # as in pvpython
    servermanager.Connect()
RANKS = servermanager.ActiveConnection.GetNumberOfDataPartitions()
MANAGER = servermanager.ProxyManager()
TYPES = {'vtkSMIntVectorProperty': 'int', 'vtkSMIdTypeVectorProperty': 'id', 'vtkSMDoubleVectorProperty': 'double',
         'vtkSMStringVectorProperty': 'text', 'vtkSMInputProperty': 'input'}
MEGABYTE = 1e6


def say(word, value):
    os.write(1, ('@%s %s\n' % (word, json.dumps(value))).encode())


# What there is

def walk(iterator, go_first, go_next, at_end):
    go_first()
    while not at_end():
        yield iterator
        go_next()


def proxies():
    """(group, name) of the plugin's sources and filters: those of its classes."""
    definitions = servermanager.ActiveConnection.Session.GetProxyDefinitionManager()
    iterator = definitions.NewIterator()
    for it in walk(iterator, iterator.InitTraversal, iterator.GoToNextItem, iterator.IsDoneWithTraversal):
        group, name = it.GetGroupName(), it.GetProxyName()
        if group in ('sources', 'filters') and (it.GetProxyDefinition().GetAttribute('class') or '').startswith('vtkRUC'):
            yield group, name


def properties(proxy):
    """(name, property, domains) of what a user can set."""
    iterator = proxy.NewPropertyIterator()
    for it in walk(iterator, iterator.Begin, iterator.Next, iterator.IsAtEnd):
        found = it.GetProperty()
        if found.GetClassName() in TYPES and not found.GetInformationOnly():
            domains = found.NewDomainIterator()
            yield it.GetKey(), found, [d.GetDomain() for d in walk(domains, domains.Begin, domains.Next, domains.IsAtEnd)]


def elements(element, name):
    """The elements of this name, at any depth, in the XML of a proxy."""
    for i in range(element.GetNumberOfNestedElements()):
        nested = element.GetNestedElement(i)
        if nested.GetName() == name:
            yield nested
        yield from elements(nested, name)


def kinds_of(group, name, key):
    """What an input takes, as data.KINDS calls it."""
    definition = servermanager.ActiveConnection.Session.GetProxyDefinitionManager().GetProxyDefinition(group, name)
    types = [kind.GetAttribute('value') for found in elements(definition, 'InputProperty') if found.GetAttribute('name') == key
             for kind in elements(found, 'DataType')]
    kinds = [kind for kind, name in (('table', 'vtkTable'), ('image', 'vtkImageData')) if name in types]
    return ['pack'] + kinds if 'vtkPointSet' in types or not kinds else kinds


def describe():
    described = {}
    for group, name in sorted(proxies()):
        proxy = MANAGER.NewProxy(group, name)
        inputs, settings = {}, {}
        for key, found, domains in properties(proxy):
            if found.IsA('vtkSMInputProperty'):
                hints = found.GetHints()
                inputs[key] = {'kinds': kinds_of(group, name, key), 'optional': bool(hints and hints.FindNestedElementByName('Optional'))}
                continue
            choices = [d.GetEntryValue(i) for d in domains if d.IsA('vtkSMEnumerationDomain') for i in range(d.GetNumberOfEntries())]
            choices += [0, 1] if any(d.IsA('vtkSMBooleanDomain') for d in domains) else []
            settings[key] = {'type': TYPES[found.GetClassName()], 'list': bool(found.GetRepeatCommand()), 'choices': choices,
                             'file': any(d.IsA('vtkSMFileListDomain') for d in domains),
                             'default': [found.GetElement(i) for i in range(found.GetNumberOfElements())]}
        described[name] = {'group': group, 'inputs': inputs, 'settings': settings}
    return described


# Files, by the names that cases have for them

LONG = {'@long': b'x' * 1000000, '@latin1': b'\xb5m \xff\xfe', '@control': b'a\x01\x1b[2J\r\n\tb'}


class Files:
    """A folder with things that are no ordinary file, and some that belong to another, which no run may change."""

    def __init__(self, parent):
        self.Folder = tempfile.mkdtemp(dir=parent)
        p = self.path
        self.Kept = ['victim', 'notes.new', 'notes.tmp']
        for name in self.Kept:
            with open(p(name), 'w') as file:
                file.write('precious')
        with open(p('pack'), 'w') as file:
            good = data.lattice()
            file.write('x,y,z,radius,mode,id\n')
            for point, radius, mode, i in zip(good['points'], good['Radius'], good['Mode'], good['Id']):
                file.write('%r,%r,%r,%r,%d,%d\n' % (*map(float, point), float(radius), mode, i))
        open(p('empty'), 'w').close()
        with open(p('huge'), 'w') as file:
            file.truncate(1 << 42)  # the file consists of holes
        with open(p('noise'), 'wb') as file:
            file.write(bytes(i * i % 251 for i in range(5000)))
        os.mkdir(p('folder'))
        for name in ('fifo', 'piped.new', 'piped.tmp'):
            os.mkfifo(p(name))
        for name, target in (('link', 'victim'), ('planted.new', 'victim'), ('planted.tmp', 'victim'), ('loop', 'loop'), ('dangling', 'nowhere')):
            os.symlink(p(target), p(name))

    def path(self, name):
        return os.path.join(self.Folder, name)

    def text(self, value):
        """A text of a case as bytes; @ and a name is a file here, or a long text."""
        if value in LONG:
            return LONG[value]
        return (self.path(value[1:]) if value.startswith('@') else value).encode()

    def changed(self):
        """The files of others that are not as they were."""
        wrong = []
        for name in self.Kept:
            try:
                with open(self.path(name)) as file:
                    wrong += [] if file.read() == 'precious' else [name]
            except OSError:
                wrong.append(name)
        return wrong


# One case

SCRIPT = '''
import sys
sys.path.insert(0, %r)
import data
from vtkmodules.vtkParallelCore import vtkMultiProcessController
controller = vtkMultiProcessController.GetGlobalController()
rank, ranks = (controller.GetLocalProcessId(), controller.GetNumberOfProcesses()) if controller else (0, 1)
data.%s
'''


def source(kind, name):
    proxy = MANAGER.NewProxy('sources', 'ProgrammableSource')
    proxy.GetProperty('OutputDataSetType').SetElement(0, data.KINDS[kind][name](0, 1).GetDataObjectType())
    proxy.GetProperty('Script').SetElement(0, SCRIPT % (HERE, 'fill(self, %r, %r, rank, ranks)' % (kind, name)))
    proxy.GetProperty('InformationScript').SetElement(0, SCRIPT % (HERE, 'inform(self, %r, %r)' % (kind, name)))
    proxy.UpdateVTKObjects()
    proxy.UpdatePipeline()
    return proxy


def apply(proxy, settings, files):
    """Sets a property past its domains, as a script can."""
    for name, values in settings.items():
        found = proxy.GetProperty(name)
        if found.GetNumberOfElements() != len(values):
            found.SetNumberOfElements(len(values))
        for i, value in enumerate(values):
            found.SetElement(i, files.text(value) if isinstance(value, str) else value)


def memory(name):
    with open('/proc/self/status') as file:
        return next(float(line.split()[1]) * 1024 / MEGABYTE for line in file if line.startswith(name))


def leaves(found):
    if isinstance(found, vtkCompositeDataSet):
        iterator = found.NewIterator()
        return [it.GetCurrentDataObject() for it in walk(iterator, iterator.InitTraversal, iterator.GoToNextItem, iterator.IsDoneWithTraversal)]
    return [found] if found else []


def suspicious(proxy):
    """Arrays of rank 0's outputs with numbers that cannot be: not finite, fractions and probabilities beyond 0 to 1."""
    names = set()
    for port in range(proxy.GetNumberOfOutputPorts()):
        for leaf in leaves(proxy.GetClientSideObject().GetOutputDataObject(port)):
            for kind in range(7):
                attributes = leaf.GetAttributesAsFieldData(kind)
                for i in range(attributes.GetNumberOfArrays() if attributes else 0):
                    found = attributes.GetArray(i)
                    if not found or not found.GetNumberOfValues():
                        continue
                    values, name = vtk_to_numpy(found), '%d:%s' % (port, found.GetName())
                    if not numpy.isfinite(values).all():
                        names.add(name + ' is not finite')
                    elif port == 0 and (found.GetName() or '').startswith(('S_', 'VolumeFraction')) and (
                            values.min() < -0.01 or values.max() > 1.01):
                        names.add(name + ' is beyond 0 to 1')
    return sorted(names)


def outcome(proxy):
    """Sizes and ranges of all outputs over all ranks, which must not depend on the ranks."""
    found = {}
    for port in range(proxy.GetNumberOfOutputPorts()):
        information = proxy.GetDataInformation(port)
        arrays = {}
        for kind in range(7):
            attributes = information.GetAttributeInformation(kind)
            for i in range(attributes.GetNumberOfArrays() if attributes else 0):
                array = attributes.GetArrayInformation(i)
                if array.GetName() != 'EstimatedMemory':  # which is that of one rank
                    arrays[array.GetName()] = [array.GetComponentRange(c) for c in range(min(9, array.GetNumberOfComponents()))]
        # Points where the pieces of an image meet count twice
        size = information.GetNumberOfCells() if information.GetDataSetTypeAsString() == 'vtkImageData' else information.GetNumberOfPoints()
        found[port] = [size + information.GetNumberOfRows(), arrays]
    return found


def attack(case, description, parent):
    files, described = Files(parent), description[case['proxy']]
    proxy = MANAGER.NewProxy(described['group'], case['proxy'])
    inputs = [(name, source(*value.split('/', 1))) for name, value in case['inputs'].items()]
    for name, made in inputs:
        proxy.GetProperty(name).AddInputConnection(made, 0)
    say('BEGIN', None)  # the words before are ParaView's, about the data
    with open('/proc/self/clear_refs', 'w') as file:
        file.write('5')
    before = memory('VmRSS')
    apply(proxy, case['set'], files)
    proxy.UpdateVTKObjects()
    proxy.UpdatePipelineInformation()
    proxy.UpdatePropertyInformation()
    estimates = [proxy.GetProperty(name) for name in ('EstimatedTime', 'EstimatedMemory')]
    say('ESTIMATE', [found.GetElement(0) if found else None for found in estimates])
    proxy.UpdatePipeline()
    most = memory('VmHWM')
    say('UPDATED', None)  # what comes now is the attack's own work, and ParaView's look at the ranges of a thousand million voxels
    if most - before > 500:
        say('HUNG', 'long')  # too large to be looked at
        return
    for port in range(proxy.GetNumberOfOutputPorts()):
        proxy.GetDataInformation(port)
    found = outcome(proxy)
    given = {name for _, made in inputs for name in suspicious(made)}  # and passed through
    say('RESULT', {'sizes': [size for size, _ in found.values()], 'digest': repr(found), 'suspicious': [name for name in suspicious(proxy) if name not in given],
                   'memory': most - before, 'changed': files.changed()})


def main():
    description = describe()
    say('DESCRIPTION', {'proxies': description, 'data': {kind: [kind + '/' + name for name in sets] for kind, sets in data.KINDS.items()}})
    for line in open(0):  # sys.stdin is ParaView's own
        case = json.loads(line)
        child = os.fork() if RANKS == 1 else 0
        if child == 0:
            try:
                attack(case, description, sys.argv[1])
            except Exception:
                say('EXCEPTION', traceback.format_exc(limit=-2))
            if RANKS == 1:
                os._exit(0)
        else:
            status = os.waitpid(child, 0)[1]
            if os.WIFSIGNALED(status):
                say('DIED', os.WTERMSIG(status))
            elif status:
                say('DIED', 'exit code %d' % os.WEXITSTATUS(status))
        say('END', None)


if __name__ == '__main__':
    import child  # a Programmable Source puts names of its own among those of __main__
    child.main()
