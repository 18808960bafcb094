# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the scripts of this folder share: outputs as Python values, errors that are expected, numbers that must not depend on the ranks."""
import json
import os
import sys
import time
import traceback

from paraview import servermanager
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow

RANKS = servermanager.ActiveConnection.GetNumberOfDataPartitions()
NUMBERS = {}  # numbers that must not depend on the ranks


def fetch(source, port=0):
    source.UpdatePipeline()
    return servermanager.Fetch(source, idx=port)


def columns(source, port=0):
    """{name: list of values} of a table, which must not be empty."""
    table = fetch(source, port)
    assert table.GetClassName() == 'vtkTable' and table.GetNumberOfRows() > 0, (source, port)
    return {table.GetColumn(j).GetName(): [table.GetColumn(j).GetValue(i) for i in range(table.GetNumberOfRows())]
            for j in range(table.GetNumberOfColumns())}


def field(data, name):
    """A field data array as a number, a text or a list of them."""
    array = data.GetFieldData().GetAbstractArray(name)
    assert array is not None, name
    values = [array.GetVariantValue(i) for i in range(array.GetNumberOfValues())]
    values = [value.ToDouble() if value.IsNumeric() else value.ToString() for value in values]
    return values[0] if len(values) == 1 else values


def leaves(data):
    """The data sets in a fetched multiblock, which of several ranks comes as a set for each rank."""
    if data is None or not data.IsA('vtkMultiBlockDataSet'):
        return [data] if data is not None else []
    return [leaf for n in range(data.GetNumberOfBlocks()) for leaf in leaves(data.GetBlock(n))]


def expect_error(source, parts):
    """An update fails with a text of the filter's that has these parts, and leaves every output empty."""
    window, former = vtkStringOutputWindow(), vtkOutputWindow.GetInstance()
    vtkOutputWindow.SetInstance(window)
    try:
        source.UpdatePipeline()
    finally:
        vtkOutputWindow.SetInstance(former)
    text = window.GetOutput()
    assert 'ERROR' in text.upper(), ('no error', parts, text)
    for part in (source.SMProxy.GetXMLLabel() + ': ', *parts):
        assert part in text, (part, text)
    for port in range(source.SMProxy.GetNumberOfOutputPorts()):
        info = source.GetDataInformation(port)
        assert info.GetNumberOfPoints() == 0 and info.GetNumberOfRows() == 0, (parts, port)


def remember(name, values):
    """Keeps every bit of these numbers and texts for run."""
    NUMBERS[name] = [value if isinstance(value, str) else repr(value) for value in values]


def compare_with_one_rank(path):
    """A run on one rank writes what was remembered to this file; others must have the same, compared with ==."""
    if RANKS == 1:
        with open(path, 'w') as file:
            json.dump(NUMBERS, file)
        return
    with open(path) as file:
        expected = json.load(file)
    assert expected.keys() == NUMBERS.keys()
    for name, values in NUMBERS.items():
        assert values == expected[name], name + ' differs from that of one rank'
    print('  %d numbers are those of one rank' % sum(map(len, NUMBERS.values())))


def run(parts, expected=None):
    """Runs the functions of a script in turn; `expected` is the file of compare_with_one_rank."""
    try:
        for part in parts:
            start = time.time()
            print(part.__name__, flush=True)
            part()
            print('  %.1f s' % (time.time() - start), flush=True)
        if expected:
            compare_with_one_rank(expected)
        print('%s: passed' % os.path.basename(sys.argv[0]))
    except Exception:
        # Under mpirun an exception that leaves the script would keep the other ranks waiting for ever
        sys.exit(traceback.format_exc())
