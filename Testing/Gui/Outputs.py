# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Every number of the outputs of filters, as lines of text that are equal only where the numbers are, bit by bit."""
import paraview.simple as pv
from paraview.servermanager import Fetch


def rows_of(data):
    """A table or a point set, with a line for each row."""
    if data.IsA("vtkMultiBlockDataSet"):
        blocks = [data.GetBlock(n) for n in range(data.GetNumberOfBlocks())]  # it is empty if another rank has the cell
        return [row for block in blocks if block for row in rows_of(block)]
    attributes = data.GetRowData() if data.IsA("vtkTable") else data.GetPointData()
    arrays = sorted((attributes.GetAbstractArray(n) for n in range(attributes.GetNumberOfArrays())), key=lambda array: array.GetName())
    if data.IsA("vtkPointSet") and data.GetPoints():
        arrays.append(data.GetPoints().GetData())
    count = arrays[0].GetNumberOfTuples() if arrays else 0
    rows = [" ".join(array.GetValue(n) if array.IsA("vtkStringArray") else " ".join(map(float.hex, map(float, array.GetTuple(n))))
                     for array in arrays) for n in range(count)]
    return sorted(rows)  # points spread over ranks come in another order


def numbers_of(names):
    """All outputs of the sources with these names."""
    lines = []
    for name in names:
        source = pv.FindSource(name)
        source.UpdatePipeline()
        for port in range(source.SMProxy.GetNumberOfOutputPorts()):
            data = source.GetDataInformation(port)
            kind = data.GetDataSetTypeAsString()
            lines.append(f"{name} {port} {kind}")
            if kind == "vtkImageData":  # in slabs on the ranks, which share points
                lines += [f"{data.GetExtent()} {array.GetName()} {array.GetRange()}" for array in source[port].PointData]
            else:
                lines += rows_of(Fetch(source, idx=port))
    return lines
