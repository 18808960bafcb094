# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""How much two pictures differ; paraview.smtesting looks for its baselines elsewhere."""
import sys

from vtkmodules.vtkImagingCore import vtkImageDifference
from vtkmodules.vtkIOImage import vtkPNGReader


def image_difference(first, second):
    difference = vtkImageDifference()
    readers = [vtkPNGReader() for _ in range(2)]
    for reader, path in zip(readers, (first, second)):
        reader.SetFileName(path)
        reader.Update()
    assert readers[0].GetOutput().GetDimensions() == readers[1].GetOutput().GetDimensions()
    difference.SetInputConnection(readers[0].GetOutputPort())
    difference.SetImageConnection(readers[1].GetOutputPort())
    difference.Update()
    return difference.GetThresholdedError()


if __name__ == "__main__":
    error = image_difference(*sys.argv[1:3])
    print(f"difference of the pictures: {error}")
    sys.exit(0 if error < 20.0 else 1)
