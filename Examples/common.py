# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the examples share, and nothing that a reader has to copy: options, outputs as Python values, files, and the tools of their checks."""
import argparse
import csv
import math
import os
import sys
import traceback

from paraview.servermanager import Fetch
from paraview.simple import *
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkOutputWindow
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter, vtkXMLPolyDataWriter

HERE = os.path.dirname(os.path.abspath(__file__))
FETCHED = {}  # the outputs on this rank, by filter and port
TABLES = {}  # the same as Python values


def stop_on_error():
    """From here on an error of a reader, a filter or a writer, once ParaView has printed it, ends all ranks with exit code 1. Without
    this the script goes on with empty outputs. The exit is at once: what else a rank does at its end may wait for the others."""
    vtkOutputWindow.GetInstance().AddObserver("ErrorEvent", lambda *_: os._exit(1))


def run(main, *arguments):
    """A job whose errors end all ranks. Under mpirun an exception that leaves the script would keep the other ranks waiting for ever."""
    stop_on_error()
    try:
        main(*arguments)
    except Exception:
        sys.exit(traceback.format_exc())


# ---- Options ----


def make_parser(program, documentation, division="Equal Width"):
    """A parser with the options of the pack and its modes; `division` is what the modes have in common by default."""
    parser = argparse.ArgumentParser(prog="pvbatch " + program, description=documentation.split("\n")[0],
                                     formatter_class=argparse.ArgumentDefaultsHelpFormatter)
    pack = parser.add_argument_group("pack")
    pack.add_argument("--input", default=os.path.join(HERE, "Data", "bead_block.csv"), help="text table with columns x, y, z, radius")
    pack.add_argument("--origin", type=float, nargs=3, default=[0, 0, 0], help="lower corner of the box of the centres")
    pack.add_argument("--box", type=float, nargs=3, default=[1445.372, 1287.892, 789.106], help="edges of the box of the centres")
    pack.add_argument("--unit", default="µm", help="unit of length")
    modes = parser.add_argument_group("modes")
    modes.add_argument("--modes", type=int, default=9, help="number of modes")
    modes.add_argument("--division", choices=["Equal Width", "Equal Volume"], default=division, help="what the modes have in common")
    modes.add_argument("--edges", type=float, nargs="+", default=[], help="or the diameters between the modes, ascending")
    return parser


def parse_arguments(program, documentation, output, **options):
    """Reads the options of make_parser, options given as name=(default, help), --output with its default and --check."""
    parser = make_parser(program, documentation)
    for name, (default, text) in options.items():
        parser.add_argument("--" + name.replace("_", "-"), type=type(default), default=default, help=text)
    add_output(parser, output)
    return parser.parse_args()


def add_output(parser, output):
    parser.add_argument("--output", default=output, help="folder for the files")
    parser.add_argument("--check", action="store_true", help="test the results")


def read_pack(args):
    """Reads the pack of these options, with the box in which its centres were observed."""
    return SpherePackReader(FileName=os.path.abspath(args.input), LengthUnit=args.unit, BoxOrigin=args.origin, BoxSize=args.box)


def sort_spheres(pack, args):
    """Sorts the pack's spheres into the modes of these options."""
    if args.edges:
        return ParticleModes(Input=pack, Method="Explicit Edges", Edges=args.edges)
    return ParticleModes(Input=pack, Method=args.division, NumberOfModes=args.modes)


# ---- Outputs as Python values ----


def fetch(source, port=0):
    """The whole output on this rank."""
    key = (source.GetGlobalIDAsString(), port)
    if key in FETCHED:
        return FETCHED[key]
    source.UpdatePipeline()
    data = Fetch(source, idx=port)
    if data is None or data.GetNumberOfElements(data.POINT) + data.GetNumberOfElements(data.ROW) == 0:
        raise RuntimeError(f"{source.GetXMLLabel()} gave no result (output {port}).")
    FETCHED[key] = data
    return data


def columns(table):
    """A fetched table as {name: list of values}."""
    result = {}
    for j in range(table.GetNumberOfColumns()):
        column = table.GetColumn(j)
        texts = (column.GetValue(i) for i in range(column.GetNumberOfValues()))
        result[column.GetName()] = list(map(float, memoryview(column)) if column.IsNumeric() else texts)
    return result


def table_of(source, port=0):
    """The same of an output, converted once."""
    key = (source.GetGlobalIDAsString(), port)
    if key not in TABLES:
        TABLES[key] = columns(fetch(source, port))
    return TABLES[key]


def field(data, name):
    """A field data array as a number, a text or a list of numbers."""
    array = data.GetFieldData().GetAbstractArray(name)
    values = [array.GetVariantValue(i) for i in range(array.GetNumberOfValues())]
    values = [v.ToDouble() if v.IsNumeric() else v.ToString() for v in values]
    return values[0] if len(values) == 1 else values


def spheres(pack):
    """A fetched pack as a list of (x, y, z, radius, mode)."""
    radius, mode = pack.GetPointData().GetArray("Radius"), pack.GetPointData().GetArray("Mode")
    return [(*pack.GetPoint(i), radius.GetValue(i), int(mode.GetValue(i))) for i in range(pack.GetNumberOfPoints())]


def whole_image(source, port):
    """An image output of any number of ranks. Fetch brings one rank's slab of an image, with 6 digits of its spacing, but all of a point
    cloud."""
    slab, info = fetch(source, port), source.GetDataInformation(port)
    extent, bounds = info.GetExtent(), info.GetBounds()
    if tuple(slab.GetExtent()) == tuple(extent):
        return slab
    image, cloud = vtkImageData(), fetch(ConvertToPointCloud(Input=OutputPort(source, port)))
    spacing = [(bounds[2 * q + 1] - bounds[2 * q]) / max(extent[2 * q + 1] - extent[2 * q], 1) for q in range(3)]
    image.SetExtent(extent)
    image.SetSpacing(spacing)
    image.SetOrigin([bounds[2 * q] - spacing[q] * extent[2 * q] for q in range(3)])
    image.SetFieldData(slab.GetFieldData())
    arrays = []
    for i in range(slab.GetPointData().GetNumberOfArrays()):
        array = vtkDoubleArray()
        array.SetName(slab.GetPointData().GetArrayName(i))
        array.SetNumberOfValues(image.GetNumberOfPoints())
        array.Fill(math.nan)
        image.GetPointData().AddArray(array)
        arrays.append((array, cloud.GetPointData().GetArray(array.GetName())))
    # Row by row, along which x grows and y and z stay; most rows are as long as the one before
    total, begin, length = cloud.GetNumberOfPoints(), 0, 1
    while begin < total:
        first = cloud.GetPoint(begin)
        in_row = lambda i: (i < total and cloud.GetPoint(i)[1:] == first[1:] and
                            round((cloud.GetPoint(i)[0] - first[0]) / spacing[0]) == i - begin)
        length = length if in_row(begin + length - 1) else 1
        while in_row(begin + length):
            length += 1
        index = [round((x - low) / step) for x, low, step in zip(first, image.GetOrigin(), spacing)]
        for array, values in arrays:
            array.InsertTuples(image.ComputePointId(index), length, begin, values)
        begin += length
    return image


# ---- Files ----


def path_in(folder, name):
    return os.path.join(os.path.abspath(folder), name)


def write_points(folder, files):
    """Writes the packs of {file: (filter, output)}."""
    for name, (source, port) in files.items():
        write_data(vtkXMLPolyDataWriter(), fetch(source, port), path_in(folder, name))


def write_image(folder, name, image):
    writer = vtkXMLImageDataWriter()
    writer.SetCompressionLevel(1)  # probabilities hardly get smaller
    write_data(writer, image, path_in(folder, name))


def write_data(writer, data, path):
    """Writes XML with inline binary data, which ParaView 5.11 reads everywhere; its default, appended data, fails with newer expat libraries."""
    os.makedirs(os.path.dirname(path), exist_ok=True)
    writer.SetDataModeToBinary()
    writer.SetInputData(data)
    writer.SetFileName(path)
    if not writer.Write():
        raise RuntimeError(f"Cannot write {path}.")


def write_tables(folder, files):
    """Writes the tables of {file: (filter, output)} as CSV with all digits, in the order of their columns, which ParaView's own writer sorts."""
    for name, (source, port) in files.items():
        write_table(folder, name, columns(fetch(source, port)))


def write_table(folder, name, table):
    """{name: list of values}"""
    os.makedirs(folder, exist_ok=True)
    with open(path_in(folder, name), "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(table)
        for row in zip(*table.values()):
            writer.writerow(value if isinstance(value, str) else f"{value:.17g}" for value in row)


# ---- Checks ----


def check_all(checks, job):
    """Runs the checks, each of which raises an AssertionError where it fails, and tells what they have found."""
    for check in checks:
        check(job)
        print(f"check    {check.__doc__.splitlines()[0]}", flush=True)
    print("check    passed")


def require(condition, reason):
    if not condition:
        raise AssertionError(reason)


def close(a, b, tolerance):
    return abs(a - b) <= tolerance


def norm(values):
    """The discrete norm, over k = 1…K."""
    return math.sqrt(math.fsum(value * value for value in values[1:]))


def standard_error(values):
    mean = sum(values) / len(values)
    return math.sqrt(sum((value - mean)**2 for value in values) / (len(values) - 1) / len(values))


def pair(phases, r, s):
    r, s = sorted((r, s), key=phases.index)
    return f"S_{r}_{s}"


def minimum_image(a, b, box):
    return [a[q] - b[q] - box[q] * round((a[q] - b[q]) / box[q]) for q in range(3)]


def require_equal_data(written, read, name):
    points = written.GetNumberOfPoints()
    require(read.GetNumberOfPoints() == points and read.GetNumberOfCells() == written.GetNumberOfCells(), f"{name}: wrong size")
    require(values_of(read.GetPoints().GetData()) == values_of(written.GetPoints().GetData()), f"{name}: other points")
    for kind in ("GetPointData", "GetCellData", "GetFieldData"):
        ours, theirs = getattr(written, kind)(), getattr(read, kind)()
        for i in range(ours.GetNumberOfArrays()):
            array = ours.GetAbstractArray(i)
            again = theirs.GetAbstractArray(array.GetName())
            require(again is not None and values_of(again) == values_of(array), f"{name}: {array.GetName()} reads differently")


def values_of(array):
    if array.IsNumeric():
        return array.GetNumberOfComponents(), bytes(memoryview(array))
    return [array.GetVariantValue(i).ToString() for i in range(array.GetNumberOfValues())]


def require_equal_tables(folder, files):
    """The tables in the files of write_tables are those of the filters."""
    for name, (source, port) in files.items():
        # As text, since nan (no saturation up to the last lag) does not equal itself
        written, read = columns(fetch(source, port)), columns(fetch(CSVReader(FileName=[path_in(folder, name)])))
        require([*map(str, written.items())] == [*map(str, read.items())], f"{name} reads differently")


def require_equal_images(written, read, name):
    require(written.GetDimensions() == read.GetDimensions() and written.GetSpacing() == read.GetSpacing(), f"{name}: other points")
    for i in range(written.GetPointData().GetNumberOfArrays()):
        array = written.GetPointData().GetArray(i)
        require(values_of(array) == values_of(read.GetPointData().GetArray(array.GetName())), f"{name}: other {array.GetName()}")
